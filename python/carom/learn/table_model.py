"""A table with numbers that are learned: which they are, and the shots that follow from them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Self

from carom import _core
from carom.cloth import STANDARD_GRAVITY, rolling_bands
from carom.errors import InputError
from carom.lazy import np
from carom.learn.header import TracksHeader
from carom.learn.observation import Observation
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number that can be learned from tracks.

    Attributes:
        name: Its key: that of a shot file in ``physics``, that in ``table``, or ``rolling.a``,
            ``rolling.b``, ``frame.x``, ``frame.y`` and ``frame.rotation``.
        step: A useful step, and the scale of its weak prior, in the parameter's unit.
        low: Least value.
        high: Largest value.
        unit: Its unit.
        about: What it is.
    """

    name: str
    step: float
    low: float
    high: float
    unit: str
    about: str


_ROWS = (
    ("cloth.sliding_friction", 0.01, 0.05, 0.4, "", "friction of a ball that slides on the cloth"),
    ("rolling.a", 0.002, 0.005, 0.3, "m/s²", "deceleration of a ball that rolls slowly"),
    ("rolling.b", 0.002, 0.0, 0.1, "1/s", "growth of that deceleration with the speed"),
    (
        "cloth.spin_deceleration",
        0.4,
        0.5,
        30.0,
        "rad/s²",
        "loss of spin about the vertical",
    ),
    ("ball_ball.restitution", 0.01, 0.7, 1.0, "", "restitution of two balls"),
    (
        "ball_ball.friction.b",
        0.02,
        0.0,
        0.6,
        "",
        "friction of two balls that falls with the slip",
    ),
    ("ball_ball.friction.c", 0.1, 0.0, 4.0, "s/m", "how fast that part falls"),
    ("cushion.restitution.a", 0.01, 0.3, 1.0, "", "restitution of a rail at low speed"),
    ("cushion.restitution.b", 0.01, -0.3, 0.1, "per m/s", "its change with the speed"),
    ("cushion.restitution.c", 0.003, -0.05, 0.05, "per (m/s)²", "the same, second power"),
    ("cushion.friction.a", 0.02, 0.0, 0.8, "", "friction of a rail, ball straight into it"),
    ("cushion.friction.b", 0.02, -0.4, 0.6, "per rad", "its change with the angle of incidence"),
    (
        "cushion.frequency_ratio",
        0.05,
        1.0,
        2.0,
        "",
        "tangential over normal frequency of a rail",
    ),
    ("table.cushion_height", 0.0005, 0.025, 0.06, "m", "height of the nose"),
    ("table.length", 0.0005, 0.5, 4.0, "m", "distance of the short rails' nose lines"),
    ("table.width", 0.0005, 0.3, 3.0, "m", "distance of the long rails' nose lines"),
    ("frame.x", 0.0005, -0.2, 0.2, "m", "offset of the tracks, along the table's width"),
    ("frame.y", 0.0005, -0.2, 0.2, "m", "offset of the tracks, along the table's length"),
    ("frame.rotation", 0.0005, -0.1, 0.1, "rad", "rotation of the tracks about the table's centre"),
)
#: Every number that can be learned, by name.
PARAMETERS: Mapping[str, Parameter] = MappingProxyType({row[0]: Parameter(*row) for row in _ROWS})
#: The cushion models that have each parameter of theirs.
_ONLY = MappingProxyType({"cushion.frequency_ratio": ("stronge",)})
#: A ball that touched a nose is placed so far from it, m.
TOUCHING = 1e-6
#: A strike that a real player could not make is one of the search's, not an error.
POLICIES = MappingProxyType({"miscue": "report", "obstruction": "report"})


def _bands(a: float, b: float) -> list[tuple[dict[str, float], float]]:
    """Speed bands, and the speed at which the law a + b·v has the resistance of each, m/s.

    The ends of the bands stay while a and b are learned: a path that changes its bands would have
    no derivative by them.
    """
    bands = rolling_bands(a, b)
    assert not isinstance(bands, float)  # one band would be enough for a law without growth
    return [
        (
            {key: value for key, value in band.items() if key == "up_to"},
            (band["friction"] * STANDARD_GRAVITY - a) / b,
        )
        for band in bands
    ]


#: The bands of the preset ``carom``; ``docs/realism.md`` has the measurement.
_BANDS = _bands(0.0410, 0.0142)


@dataclass(frozen=True, slots=True)
class Frame:
    """Where the tracks lie on the table.

    A place p of the tracks is at centre + R(rotation)·(p − centre) + offset, where the centre is
    that of the playing area.

    Attributes:
        offset: m.
        rotation: rad.
    """

    offset: tuple[float, float] = (0.0, 0.0)
    rotation: float = 0.0

    def to_table(self, places: ArrayLike, size: Sequence[float]) -> Floats:
        """Places of the tracks, (..., 2), on a table of this size (width and length, m)."""
        centre = np.array(size[:2]) / 2.0
        cos, sin = np.cos(self.rotation), np.sin(self.rotation)
        turn = np.array(((cos, -sin), (sin, cos)))
        moved: Floats = (np.asarray(places) - centre) @ turn.T + centre + np.array(self.offset)
        return moved


class TableModel:
    """A table whose free numbers are a vector.

    Args:
        table: The table, as a shot file has it.
        physics: The physics, as a shot file has it: the models, and the numbers that are not free.
        free: Names of the numbers that are learned.
        radius: Radius of the balls, m; None is that of the physics.
    """

    def __init__(
        self,
        table: str | Mapping[str, Any],
        physics: str | Mapping[str, Any] | None = None,
        free: Iterable[str] | None = None,
        radius: float | None = None,
    ) -> None:
        self.table = dict(table) if isinstance(table, Mapping) else {"base": table}
        base = physics if physics is not None else _own_physics(self.table)
        self.physics = dict(base) if isinstance(base, Mapping) else {"base": base}
        self.radius = radius
        values = _values(self.table, self.physics)
        self.cushion_model = str(values["cushion.model"])
        self.ball_model = str(values["ball_ball.model"])
        self._law = {"a": values["rolling.a"], "b": values["rolling.b"]}
        self._size = (values["table.width"], values["table.length"])
        self._height = values.get("table.cushion_height")
        self._has_pockets = values["pockets"]
        self._ball_radius = float(radius if radius is not None else values["ball.radius"])
        names = list(free) if free is not None else self._usual(values)
        for name in names:
            if name not in PARAMETERS:
                raise InputError(
                    "unknown-name",
                    "free",
                    f"{name!r} cannot be learned",
                    f"choose from {', '.join(PARAMETERS)}",
                )
        self.free = tuple(PARAMETERS[name] for name in names)
        self.start = np.array([self._first(p, values) for p in self.free])
        self.steps = np.array([p.step for p in self.free])

    @classmethod
    def of(
        cls,
        header: TracksHeader,
        table: str | Mapping[str, Any] | None,
        physics: str | Mapping[str, Any] | None,
        free: Iterable[str] | None,
    ) -> Self:
        """The table of some tracks; None for ``table`` is the one that their header names.

        Raises:
            InputError: Neither names a table, or a name of ``free`` is unknown.
        """
        chosen = table if table is not None else header.table
        if chosen is None:
            raise InputError(
                "missing",
                "table",
                "the tracks do not say on which table they were filmed",
                'give it, such as "carom-10ft"',
            )
        return cls(chosen, physics, free, header.radius)

    def _usual(self, values: Mapping[str, Any]) -> list[str]:
        names = []
        for name in PARAMETERS:
            if name in _ONLY and self.cushion_model not in _ONLY[name]:
                continue
            if name in ("table.length", "table.width") and values["pockets"]:
                continue
            if name == "frame.rotation":
                continue
            names.append(name)
        return names

    def _first(self, parameter: Parameter, values: Mapping[str, Any]) -> float:
        value = values.get(parameter.name, 0.0)
        return float(np.clip(value, parameter.low, parameter.high))

    @property
    def names(self) -> list[str]:
        """Names of the free numbers, in the order of the vector."""
        return [parameter.name for parameter in self.free]

    @property
    def identity(self) -> tuple[Any, ...]:
        """What distinguishes the model from another one, as values of JSON."""
        return self.table, self.physics, self.names, self.radius

    def clip(self, vector: Floats) -> Floats:
        """The vector with each number inside its bounds."""
        low = np.array([p.low for p in self.free])
        high = np.array([p.high for p in self.free])
        clipped: Floats = np.clip(vector, low, high)
        return clipped

    def parts(self, vector: Floats) -> tuple[dict[str, Any], dict[str, Any], Frame]:
        """The table, the physics and the frame with the numbers of a vector."""
        table, physics = deepcopy(self.table), deepcopy(self.physics)
        rolling, frame = {}, {"x": 0.0, "y": 0.0, "rotation": 0.0}
        for parameter, value in zip(self.free, vector.tolist(), strict=True):
            first, _, rest = parameter.name.partition(".")
            if first == "rolling":
                rolling[rest] = value
            elif first == "frame":
                frame[rest] = value
            elif first == "table":
                table[rest] = value
            else:
                _put(physics, parameter.name.split("."), value)
        if rolling:
            law = {**self._law, **rolling}
            bands = [
                {**band, "friction": (law["a"] + law["b"] * speed) / STANDARD_GRAVITY}
                for band, speed in _BANDS
            ]
            _put(physics, ["cloth", "rolling_friction"], bands)
        return table, physics, Frame((frame["x"], frame["y"]), frame["rotation"])

    def size(self, vector: Floats) -> tuple[float, float]:
        """Width and length of the playing area, m."""
        width, length = self._size
        return (
            self._value("table.width", vector, width),
            self._value("table.length", vector, length),
        )

    def _value(self, name: str, vector: Floats, held: float) -> float:
        """A number of a vector; ``held`` if it is not free."""
        return float(vector[self.names.index(name)]) if name in self.names else held

    def inside(self, place: Floats, vector: Floats) -> Floats:
        """Places, (..., 2), with the ball outside the noses: one that is seen in a nose touched it.

        A pocketless table only: in a pocket's mouth a ball may lie behind the line of the noses.
        """
        if self._has_pockets or self._height is None:
            return place
        height = self._value("table.cushion_height", vector, self._height)
        above = height - self._ball_radius
        touching = np.sqrt(max(self._ball_radius**2 - above**2, 0.0)) + TOUCHING
        moved: Floats = np.clip(place, touching, np.array(self.size(vector)) - touching)
        return moved

    def shot(self, observed: Observation, vector: Floats) -> tuple[Shot, Frame]:
        """A shot of the balls as they lay, and the frame of the tracks.

        Its strike is only there to say which ball is struck.
        """
        table, physics, frame = self.parts(vector)
        size = self.size(vector)
        balls: list[dict[str, Any]] = []
        for name, place in observed.rest.items():
            lay = self.inside(frame.to_table(place, size), vector)
            ball: dict[str, Any] = {"id": name, "position": lay.tolist()}
            if self.radius is not None:
                ball["radius"] = self.radius
            balls.append(ball)
        strike = {"ball": observed.struck, "speed": 1.0, "azimuth": 0.0, **POLICIES}
        return Shot(table, balls, strike, physics=physics), frame


def _own_physics(table: Mapping[str, Any]) -> str:
    """The physics of the preset that the table is, or is made from."""
    base = table.get("base")
    rows = {row["name"]: row for row in _core.tables()}
    return str(rows[base]["physics"]) if base in rows else "pool"


def _values(table: Mapping[str, Any], physics: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers and models of a table and its physics, by the names of parameters."""
    values: dict[str, Any] = {}
    base = physics.get("base", _own_physics(table))
    for row in next(row for row in _core.physics() if row["name"] == base)["parameters"]:
        values[row["key"]] = row["value"]
    values |= _flat({key: value for key, value in physics.items() if key != "base"})
    for name in ("cushion.restitution", "cushion.friction", "ball_ball.friction"):
        if isinstance(values.get(name), int | float):
            part = "b" if name == "ball_ball.friction" else "a"
            values[f"{name}.{part}"] = values.pop(name)
    law = _rolling_law(values.get("cloth.rolling_friction", 0.01))
    values["rolling.a"], values["rolling.b"] = law
    preset = next((row for row in _core.tables() if row["name"] == table.get("base")), None)
    if preset is not None:
        values |= {f"table.{row['key']}": row["value"] for row in preset["dimensions"]}
        values["pockets"] = bool(preset["pockets"])
    values |= {f"table.{key}": value for key, value in table.items() if key != "base"}
    values["pockets"] = bool(values.get("pockets") or values.get("table.pockets"))
    return values


def _rolling_law(friction: Any) -> tuple[float, float]:
    """The line a + b·v (m/s², 1/s) through a rolling resistance, given as in a shot file."""
    if isinstance(friction, int | float):
        return float(friction) * STANDARD_GRAVITY, 0.0
    ends = [0.0, *(band["up_to"] for band in friction if "up_to" in band)]
    middles = [(low + high) / 2.0 for low, high in pairwise(ends)]
    values = [band["friction"] * STANDARD_GRAVITY for band in friction][: len(middles)]
    if len(middles) < 2:
        return values[0], 0.0
    slope, first = np.polyfit(middles, values, 1)
    return float(first), float(slope)


def _flat(tree: Mapping[str, Any], before: str = "") -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for key, value in tree.items():
        if isinstance(value, Mapping):
            flat |= _flat(value, f"{before}{key}.")
        else:
            flat[f"{before}{key}"] = value
    return flat


def _put(tree: dict[str, Any], path: Sequence[str], value: Any) -> None:
    """Puts a value into a tree of dicts; a number on the way becomes a dict."""
    *way, last = path
    for key in way:
        if not isinstance(tree.get(key), dict):
            tree[key] = {}
        tree = tree[key]
    tree[last] = value
