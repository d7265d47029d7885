"""A shot: everything that is fixed before it starts, and the questions about it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Self

from carom import _core, arguments, notebook, page, plan
from carom._core import Shot as CoreShot
from carom.batch import VARIABLES, batch, own_strike
from carom.build import CuePose, Layout, Physics, Strike, Table, like
from carom.errors import EventCapError
from carom.files import read_text, shown, write_whole
from carom.lazy import np
from carom.method import method
from carom.noise import vary
from carom.record import Record
from carom.trace import Trace

if TYPE_CHECKING:
    import os

    from numpy.typing import NDArray


class BallEntry(Record):
    """A ball as a shot file has it; keys that have their usual value are missing.

    Attributes:
        id: The ball's id.
        position: Centre, m, two or three numbers.
        velocity: m/s.
        angular_velocity: rad/s.
        mass: kg.
        radius: m.
    """

    __slots__ = ()

    id: str
    position: Sequence[float]
    velocity: Sequence[float]
    angular_velocity: Sequence[float]
    mass: float
    radius: float


class Shot:
    """A validated, immutable shot (``carom-shot/1``).

    Build one from its parts, or read one with ``load``, ``from_dict`` or ``from_json``.

    Every question about a shot is a method: ``simulate``, ``batch``, ``vary``, ``evaluate``,
    ``solve``, ``pot_map``, ``position_map``, ``acceptance``, ``kick_table``, ``bank_table``. The
    functions of the same names in ``carom.plan`` take the shot as their first argument.

    Args:
        table: The table, or the shot file's ``table`` (a preset's name, an object).
        layout: The balls, or the shot file's ``balls``, or positions (m) by id.
        strike: The strike, or the shot file's ``strike``, without ``ball`` that of the ball
            ``cue``; None if the balls have velocities of their own.
        physics: The parameters; None is the preset that belongs to the table.
        max_events: Largest number of events; more are an error. None is the engine's default.
        until: End time, s since the strike, > 0: the trace and every result are those of this
            instant, also if balls still move. None for an end at rest.
        cling: The contacts that cling, as the shot file has them; None for none.

    Raises:
        InputError: A value is invalid; the message names the place.
    """

    __slots__ = ("_core",)
    _core: CoreShot

    def __init__(
        self,
        table: Table | str | Mapping[str, Any],
        layout: Layout | Mapping[str, Any] | list[Any],
        strike: Strike | Mapping[str, Any] | None = None,
        *,
        physics: Physics | str | Mapping[str, Any] | None = None,
        max_events: int | None = None,
        until: float | None = None,
        cling: Mapping[str, Any] | None = None,
    ) -> None:
        file: dict[str, Any] = {
            "format": "carom-shot/1",
            "table": table.description if isinstance(table, Table) else table,
            "balls": _balls(layout),
        }
        if isinstance(physics, Physics):
            physics = physics.description
        optional = {
            "physics": physics,
            "strike": _strike(strike),
            "cling": cling,
            "until": until,
            "max_events": max_events,
        }
        file |= {key: value for key, value in optional.items() if value is not None}
        self._core = _core.Shot.from_object(file)
        if not isinstance(strike, Strike):
            self._warn_of_degrees()

    def _warn_of_degrees(self) -> None:
        """Warn of an azimuth in radians that was probably meant in degrees."""
        strike = self._core.strike
        if strike is not None and abs(strike[1]) > 1.0:
            # Of the two keys the one that was written.
            arguments.warn_of_degrees("strike.azimuth", self._source()["strike"].get("azimuth"))

    @classmethod
    def _wrap(cls, core: CoreShot) -> Self:
        shot = cls.__new__(cls)
        shot._core = core
        return shot

    def _source(self) -> dict[str, Any]:
        """The shot file, without an elevation that is the default."""
        return self._core.to_object(elevation=False)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a shot file.

        Raises:
            OSError: The file cannot be read.
            InputError: It is not a valid shot.
        """
        return cls._read(read_text(path), shown(path))

    @classmethod
    def from_json(cls, text: str) -> Self:
        """Read a shot from JSON text.

        Raises:
            InputError: It is not a valid shot.
        """
        return cls._read(arguments.text("text", text), None)

    @classmethod
    def _read(cls, text: str, file: str | None) -> Self:
        """Read a shot from JSON text; the error of a syntax fault names the file of the text."""
        shot = cls._wrap(_core.Shot.from_json(text, file))
        shot._warn_of_degrees()
        return shot

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """Read a shot from a dict in the form of the shot file.

        Raises:
            InputError: It is not a valid shot.
        """
        shot = cls._wrap(_core.Shot.from_object(file))
        shot._warn_of_degrees()
        return shot

    @classmethod
    def _copied(cls, file: Mapping[str, Any]) -> Self:
        """The shot of a pickle, which warned of its angles when it was made."""
        return cls._wrap(_core.Shot.from_object(file))

    def to_dict(self) -> dict[str, Any]:
        """The shot file; ``from_dict`` of it gives this shot again, to the bit.

        It always has the elevation that is used, also where it was omitted.
        """
        return self._core.to_object()

    def to_json(self) -> str:
        """The shot file as text; ``from_json`` of it gives this shot again, to the bit.

        It always has the elevation that is used, also where it was omitted.
        """
        return self._core.to_json()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the shot file."""
        write_whole(path, self.to_json() + "\n")

    @property
    def ids(self) -> list[str]:
        """The balls' ids; arrays of results have the balls in this order."""
        return self._core.ids

    @property
    def radius(self) -> NDArray[np.float64]:
        """The balls' radii, m, shape (n_balls,)."""
        return np.array(self._core.radius)

    @property
    def mass(self) -> NDArray[np.float64]:
        """The balls' masses, kg, shape (n_balls,)."""
        return np.array(self._core.mass)

    @property
    def table(self) -> Table:
        """The table, as it was given."""
        return Table(self._source()["table"])

    @property
    def physics(self) -> Physics:
        """The physics, as it was given; if it was not, the preset that belongs to the table."""
        return Physics(self._source().get("physics", self._core.physics_of_table))

    @property
    def balls(self) -> list[BallEntry]:
        """The balls as the shot file has them, in the order of ``ids``.

        ``Shot(shot.table, shot.balls, shot.strike, physics=shot.physics)`` is this shot again, if
        it has no end time, no cling and the usual largest number of events.
        """
        return [BallEntry(ball) for ball in self._source()["balls"]]

    @property
    def strike(self) -> Strike | None:
        """The strike; None without one. Its elevation is None if it was omitted."""
        numbers = self._core.strike
        if numbers is None:
            return None
        speed, azimuth, elevation, side, height = numbers
        raised = None if self.has_default_elevation else elevation
        return like((speed, azimuth, raised, side, height), self._source()["strike"])

    @property
    def speed(self) -> float | None:
        """The cue's speed, m/s; None without a strike."""
        return self._number(0)

    @property
    def azimuth(self) -> float | None:
        """Direction in which the cue moves, rad; None without a strike."""
        return self._number(1)

    @property
    def elevation(self) -> float | None:
        """Butt of the cue raised above horizontal, rad; None without a strike."""
        return self._number(2)

    @property
    def side(self) -> float | None:
        """Contact point right of centre, ball radii; None without a strike."""
        return self._number(3)

    @property
    def height(self) -> float | None:
        """Contact point above centre, ball radii; None without a strike."""
        return self._number(4)

    def _number(self, index: int) -> float | None:
        strike = self._core.strike
        return None if strike is None else strike[index]

    @property
    def has_default_elevation(self) -> bool:
        """Whether the elevation was omitted, so that it is the default (docs/formats.md)."""
        return self._core.has_default_elevation

    def with_strike(
        self,
        *,
        speed: float | None = None,
        azimuth: float | None = None,
        side: float | None = None,
        height: float | None = None,
        elevation: float | None = None,
        azimuth_deg: float | None = None,
        elevation_deg: float | None = None,
    ) -> Self:
        """The same shot with another strike. Arguments that are None keep the value of this shot.

        Args:
            speed: The cue's speed, m/s.
            azimuth: The cue's direction, counter-clockwise from +x, rad.
            side: Contact point right of centre, ball radii.
            height: Contact point above centre, ball radii.
            elevation: Butt raised above horizontal, rad. If it was omitted in this shot, None is
                the default elevation of the new strike.
            azimuth_deg: The azimuth in degrees, in place of ``azimuth``.
            elevation_deg: The elevation in degrees, in place of ``elevation``.

        Raises:
            InputError: The shot has no strike, or this one cannot be played: a number is out of
                range, the tip would slip off, or the cue would pass through something and the shot
                has ``"obstruction": "refuse"``.
        """
        azimuth = arguments.angle("azimuth", azimuth, azimuth_deg)
        if azimuth_deg is None:
            arguments.warn_of_degrees("azimuth", azimuth)
        elevation = arguments.angle("elevation", elevation, elevation_deg)
        given = (speed, azimuth, elevation, side, height)
        own = own_strike(self._core)
        new_speed, new_azimuth, new_elevation, new_side, new_height = (
            default if value is None else arguments.number(name, value)
            for name, value, default in zip(VARIABLES, given, own, strict=True)
        )
        omitted = elevation is None and self.has_default_elevation
        raised = None if omitted else new_elevation
        strike = (new_speed, new_azimuth, raised, new_side, new_height)
        return self._wrap(self._core.with_strike(strike))

    @property
    def until(self) -> float | None:
        """End time, s since the strike; None if the shot ends when all balls are at rest."""
        return self._core.until

    def with_until(self, until: float | None) -> Self:
        """The same shot with another end time, s since the strike; None for an end at rest.

        Raises:
            InputError: The time is not above 0, or not finite.
        """
        time = None if until is None else arguments.number("until", until)
        return self._wrap(self._core.with_until(time))

    @property
    def track(self) -> dict[str, NDArray[np.float64]]:
        """Where a camera saw the balls, by id; empty if the shot file has no ``track``.

        Each array has the shape (n, 3): time since the strike, s, and x and y of the centre, m.
        """
        entries = self._source().get("track", ())
        return {entry["ball"]: np.array(entry["samples"], float) for entry in entries}

    @property
    def marks(self) -> list[dict[str, Any]]:
        """What is drawn on the table, as the key ``marks`` of the shot file; empty without it."""
        return [dict(mark) for mark in self._source().get("marks", ())]

    def geometry(self) -> dict[str, Any]:
        """The table's dimensions, cushions and pockets, m, origin at the bottom left corner."""
        return self._core.geometry()

    def cue_pose(self) -> CuePose:
        """The pose of the cue for the strike: tip, direction, butt, and its clearance.

        ``Strike.from_pose`` is the way back.

        Raises:
            InputError: The shot has no strike.
        """
        own_strike(self._core)
        pose = self._core.cue_pose()
        assert pose is not None
        tip, direction, butt, found = pose
        clearance, nearest = (None, None) if found is None else found
        points = (_point(tip), _point(direction), _point(butt))
        return CuePose(*points, clearance, nearest)

    def simulate(self) -> Trace:
        """Simulate the shot to its end: until all balls rest, or to its end time ``until``.

        Raises:
            EventCapError: It reached its largest number of events; the error has the shot and
                the trace so far. If no friction stops a ball between the rails, the error is also
                an ``InputError``, whose remedy is an end time.
        """
        return Trace._wrap(_core.simulate(self._core))

    # Questions: functions whose first argument is the shot.
    batch = method(batch)
    vary = method(vary)
    evaluate = method(plan.evaluate)
    solve = method(plan.solve)
    pot_map = method(plan.pot_map)
    position_map = method(plan.position_map)
    acceptance = method(plan.acceptance)
    kick_table = method(plan.kick_table)
    bank_table = method(plan.bank_table)

    def show(self, *, height: int | None = None) -> None:
        """Aim and play the shot in the notebook, or else in the browser until Ctrl-C.

        Args:
            height: Height of the viewer in the notebook, CSS pixels; None is the usual one.

        Raises:
            PageError: The page is not built into this installation.
        """
        notebook.show(self, height=height or page.HEIGHT)

    def _repr_html_(self) -> str:
        """The viewer, for notebooks; a picture if the page is not built."""
        return notebook.cell(self) if page.is_built() else notebook.image(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shot) and self._core.equals(other._core)

    def __hash__(self) -> int:
        # Not the text, which may differ for equal shots.
        return hash((tuple(self.ids), self._core.strike))

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        # The copy of a shot with a default elevation has it too, and not the same angle.
        return (Shot._copied, (self._source(),))

    def __repr__(self) -> str:
        count = len(self.ids)
        name = self.geometry()["name"] or "table"
        return f"<carom.Shot: {count} ball{'s' * (count != 1)} on {name}>"


def _trace_to_cap(file: dict[str, Any]) -> Trace:
    """The trace of a shot that reaches its cap of events."""
    return Trace._wrap(_core.simulate_to_cap(_core.Shot.from_object(file)))


# A trace has its shot, and the error of the event cap its trace.
Trace._shot_of = Shot._wrap
EventCapError._trace_of = _trace_to_cap


def _strike(strike: Strike | Mapping[str, Any] | None) -> Any:
    if isinstance(strike, Strike):
        return strike.to_dict()
    if isinstance(strike, Mapping):
        return {"ball": Strike.ball, **strike}
    return strike


def _balls(layout: Any) -> Any:
    if isinstance(layout, Layout):
        return layout.balls
    if isinstance(layout, Mapping):
        return Layout.at(layout).balls
    return layout


def _point(coordinates: list[float]) -> tuple[float, float, float]:
    x, y, z = coordinates
    return x, y, z
