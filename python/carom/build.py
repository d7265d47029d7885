"""The parts that a shot is built from: table, physics, layout, strike.

Each stands for a part of the shot file, with Python's names. Keys and numbers are checked where
they are written; whether the parts fit together is checked when the shot is built.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from carom import _core
from carom.arguments import angle, core, number, numbers, text, warn_of_degrees, whole
from carom.errors import InputError

if TYPE_CHECKING:
    import carom

JSON = dict[str, Any]


@dataclass(frozen=True)
class Table:
    """A table: a preset, possibly with changed keys, a plain rectangle, or unbounded cloth.

    Args:
        description: The shot file's ``table``: a preset's name (`carom tables` lists them) or
            an object.

    Raises:
        InputError: There is no such preset, a key is unknown, or a value is invalid.
    """

    description: str | Mapping[str, Any] = "wpa-9ft"

    def __post_init__(self) -> None:
        _core.check_part("table", self.description)

    @classmethod
    def preset(cls, name: str, **changes: Any) -> Self:
        """A preset with some keys of its description changed (lengths in m)."""
        return cls({"base": name, **changes} if changes else name)

    @classmethod
    def rectangle(cls, *, length: float, width: float, **more: Any) -> Self:
        """Four rails without pockets.

        Args:
            length: Nose to nose along y, m.
            width: Nose to nose along x, m.
            more: Further keys, such as ``cushion_height`` (m).
        """
        return cls({"length": length, "width": width, "pockets": "none", **more})

    @classmethod
    def unbounded(cls) -> Self:
        """Unbounded cloth without rails."""
        return cls({"cloth": "unbounded"})


@dataclass(frozen=True)
class Physics:
    """Every parameter of every model: a preset's name, or an object merged over its ``base``.

    Args:
        description: The shot file's ``physics``; None is the preset that belongs to the table.

    Raises:
        InputError: There is no such preset, a key is unknown, or a value is invalid.
    """

    description: str | Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        if self.description is not None:
            _core.check_part("physics", self.description)

    @classmethod
    def preset(cls, name: str, **changes: Any) -> Self:
        """A preset with some parameters changed.

        Args:
            name: One of those that ``carom physics`` lists, such as ``pool``.
            changes: Sections to merge over it, e.g. ``cloth={"sliding_friction": 0.25}``.
        """
        return cls({"base": name, **changes} if changes else name)


@dataclass(frozen=True)
class Layout:
    """The balls and where they are.

    Args:
        balls: The shot file's ``balls``: each with ``id``, ``position`` (2 or 3 numbers, m) and
            optionally ``velocity`` (m/s), ``angular_velocity`` (rad/s), ``mass`` (kg) and
            ``radius`` (m). ``"rolling": True`` in place of ``angular_velocity`` gives a ball the
            spin with which it rolls at its velocity.

    Raises:
        InputError: A key is unknown, or a value is missing or invalid. Whether the balls have room
            on a table is checked when a shot is built.
    """

    balls: Sequence[Mapping[str, Any]] = field(default_factory=tuple)

    def __post_init__(self) -> None:
        if isinstance(self.balls, Mapping):
            raise InputError(
                "wrong-type",
                "balls",
                "found positions by id",
                "write carom.Layout.at({...}), or a list of balls",
            )
        _core.check_part("balls", self.balls)

    @classmethod
    def at(cls, positions: Mapping[str, Sequence[float]]) -> Self:
        """Balls at rest, by id: ``Layout.at({"cue": (0.6, 0.6), "1": (0.6, 1.9)})``, in m."""
        if not isinstance(positions, Mapping):
            _core.wrong_type(positions, "positions", 'places by id, such as {"cue": (0.6, 0.6)}')
        return cls(tuple({"id": i, "position": p} for i, p in positions.items()))

    def repaired(
        self,
        tolerance: float = 0.001,
        *,
        table: Table | str | Mapping[str, Any] = "wpa-9ft",
        physics: Physics | str | Mapping[str, Any] | None = None,
    ) -> Repaired:
        """This layout with overlapping balls apart, such as one that a camera measured.

        Balls that overlap each other or a cushion by at most the tolerance are moved to the nearest
        places without overlaps: the sum of the squared displacements is least. Balls in the air
        stay. A layout without overlaps is not changed.

        Args:
            tolerance: Largest overlap that is repaired, m; at most 0.03.
            table: The table of the layout.
            physics: Its physics, which has the balls' radius; None is that of the table.

        Returns:
            The layout, and the balls that moved.

        Raises:
            InputError: Two balls, or a ball and a cushion, overlap by more than the tolerance, or
                have no room to move apart. The message names them.
        """
        file: JSON = {
            "table": table.description if isinstance(table, Table) else table,
            "balls": [dict(ball) for ball in self.balls],
        }
        given = physics.description if isinstance(physics, Physics) else physics
        if given is not None:
            file["physics"] = given
        found, moved = _core.repaired(file, number("tolerance", tolerance))
        return Repaired(
            Layout(tuple(found["balls"])), [MovedBall(ball, (x, y)) for ball, (x, y) in moved]
        )

    @classmethod
    def rack(
        cls, game: str, *, table: str | None = None, seed: int = 0, gap: float | None = None
    ) -> Self:
        """The balls before the break, the cue ball first.

        Args:
            game: One of ``carom.rule_sets()``, such as ``nine-ball``.
            table: A preset's name; the game's own table if None.
            seed: Seed of the rack; the same seed gives the same rack on every platform.
            gap: Mean gap between the balls, m; 0 is frozen, None is the usual 0.1 mm.

        Raises:
            InputError: There is no such game or table.
        """
        rack = opening(game, table=table, speed=None, seed=seed, gap=gap)
        return cls(tuple(rack.to_object()["balls"]))


class MovedBall(NamedTuple):
    """A ball that ``Layout.repaired`` has moved.

    Attributes:
        ball: Its id.
        by: Where it is now minus where it was, x and y, m.
    """

    ball: str
    by: tuple[float, float]


class Repaired(NamedTuple):
    """A layout whose overlaps were removed.

    Attributes:
        layout: The layout.
        moved: The balls that moved; empty if nothing overlapped.
    """

    layout: Layout
    moved: list[MovedBall]


class CuePose(NamedTuple):
    """The cue at the moment when its tip touches the ball, in the file's frame.

    The tip is at C + R(side·r + height·u − √(1 − side² − height²)·d) for a ball with the centre C
    and the radius R: d is the direction, r the horizontal direction to its right, and u = r × d.

    Attributes:
        tip: Where the tip touches the ball, on the cue's axis, x, y, z, m.
        direction: Direction in which the cue moves, a unit vector.
        butt: The end of a cue of 1.47 m, m.
        clearance: How much the cue may move across its axis, in its vertical plane, until it
            touches a ball or a rail behind the struck ball, m; negative if it passes through, None
            if nothing is there.
        nearest: The ball or the rail of the clearance.
    """

    tip: tuple[float, float, float]
    direction: tuple[float, float, float]
    butt: tuple[float, float, float]
    clearance: float | None
    nearest: str | None


@dataclass(frozen=True, init=False)
class Strike:
    """A strike of the cue.

    Args:
        speed: The cue's speed at contact, m/s, in (0, 50].
        azimuth: Direction in which the cue moves, counter-clockwise from +x, rad.
        elevation: Butt raised above horizontal, rad, in [0, π/2). None is the default elevation:
            the least angle of a real stroke at which the cue clears the rails and the other balls
            (docs/formats.md).
        side: Contact point right of the cue's line through the ball's centre, in ball radii.
        height: Contact point above that line, in ball radii. Both are measured across the cue's
            axis at every elevation, as the shooter sees the ball: at a raised cue a height of 0 is
            above the ball's equator (docs/cue-pose.md).
        ball: Id of the struck ball.
        obstruction: ``"report"`` or ``"refuse"`` a cue that would pass through a ball or rail.
        miscue: ``"refuse"`` a miscue, or ``"report"`` it and play as if the tip had not slipped.
        azimuth_deg: The azimuth in degrees, in place of ``azimuth``.
        elevation_deg: The elevation in degrees, in place of ``elevation``.

    An azimuth of more than a full turn (2π) warns (``carom.AngleWarning``), because it was probably
    meant in degrees. The other numbers are checked when a shot is built.

    Raises:
        InputError: There is no azimuth, or an angle is given twice or not a number.
    """

    speed: float
    azimuth: float
    elevation: float | None = None
    side: float = 0.0
    height: float = 0.0
    ball: str = "cue"
    obstruction: str = "report"
    miscue: str = "refuse"

    def __init__(
        self,
        speed: float,
        azimuth: float | None = None,
        elevation: float | None = None,
        side: float = 0.0,
        height: float = 0.0,
        ball: str = "cue",
        obstruction: str = "report",
        miscue: str = "refuse",
        *,
        azimuth_deg: float | None = None,
        elevation_deg: float | None = None,
    ) -> None:
        direction = angle("strike.azimuth", azimuth, azimuth_deg)
        if direction is None:
            raise InputError(
                "missing",
                "strike.azimuth",
                "is missing",
                "give azimuth (rad) or azimuth_deg (degrees)",
            )
        if azimuth_deg is None:
            warn_of_degrees("strike.azimuth", direction)
        raised = angle("strike.elevation", elevation, elevation_deg)
        if raised is not None and not 0.0 <= raised < math.pi / 2:
            raise InputError(
                "out-of-range",
                "strike.elevation",
                f"{raised:g} rad is out of range",
                "write elevation_deg from 0 up to 90 (degrees), or elevation in radians",
            )
        self._set(speed, direction, raised, side, height, ball, obstruction, miscue)

    def _set(self, *values: Any) -> None:
        for name, value in zip(self.__dataclass_fields__, values, strict=True):
            object.__setattr__(self, name, value)

    @classmethod
    def _of(cls, *values: Any) -> Self:
        """A strike with these fields, as it was recorded or computed, without any check."""
        strike = cls.__new__(cls)
        strike._set(*values)
        return strike

    @classmethod
    def from_dict(cls, strike: Mapping[str, Any]) -> Self:
        """Read a strike in the form of a shot file, with angles in radians or in degrees.

        Raises:
            InputError: A key is unknown, the speed or the azimuth is missing, or as for ``Strike``.
        """
        if not isinstance(strike, Mapping):
            _core.wrong_type(strike, "strike", '{"speed": 2.0, "azimuth_deg": 90}')
        _core.check_keys(strike, "strike", _KEYS)
        if "speed" not in strike:
            raise InputError(
                "missing", "strike.speed", "is missing", "write the cue's speed in m/s"
            )
        return cls(**strike)

    @classmethod
    def _recorded(cls, strike: Mapping[str, Any]) -> Self:
        """The strike of a record, in radians. Its angles were checked when it was played."""
        fields = cls.__dataclass_fields__
        _core.check_keys(strike, "play.strike", list(fields))
        for name in ("speed", "azimuth"):
            if name not in strike:
                raise InputError(
                    "missing", f"play.strike.{name}", "is missing", "give the value of Frame.record"
                )
        return cls._of(*(strike.get(name, getattr(cls, name, None)) for name in fields))

    @property
    def azimuth_deg(self) -> float:
        """The azimuth in degrees."""
        return math.degrees(self.azimuth)

    @property
    def elevation_deg(self) -> float | None:
        """The elevation in degrees; None for the default one."""
        return None if self.elevation is None else math.degrees(self.elevation)

    @classmethod
    def from_pose(
        cls,
        shot: carom.Shot,
        tip: Sequence[float],
        direction: Sequence[float],
        speed: float,
        *,
        ball: str = "cue",
    ) -> Self:
        """The strike of a cue that is at a place in space, such as a robot's.

        Args:
            shot: The shot with the ball; its own strike is not used.
            tip: A point on the cue's axis, x, y, z, m: the tip, also before it touches the ball.
            direction: Direction in which the cue moves, of any length.
            speed: The cue's speed, m/s.
            ball: Id of the struck ball.

        Raises:
            InputError: The axis misses the ball, the direction points up or straight down, or there
                is no such ball.
        """
        inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
        x, y, z = numbers("tip", tip, 3)
        along, across, rise = numbers("direction", direction, 3)
        exact, wanted = (
            number("speed", speed),
            text("ball", ball, 'the id of a ball, such as "cue"'),
        )
        return cls(
            *inner.strike_of_pose((x, y, z), (along, across, rise), exact, wanted), ball=wanted
        )

    def to_dict(self) -> JSON:
        """The shot file's ``strike``, with angles in radians, so that they keep their bits."""
        return {
            "ball": self.ball,
            "speed": self.speed,
            "azimuth": self.azimuth,
            **({} if self.elevation is None else {"elevation": self.elevation}),
            "side": self.side,
            "height": self.height,
            "obstruction": self.obstruction,
            **({} if self.miscue == Strike.miscue else {"miscue": self.miscue}),
        }


# The keys of a strike in a file.
_KEYS = (*Strike.__dataclass_fields__, "azimuth_deg", "elevation_deg")

# The keys of a shot file's ``strike`` that are not numbers.
_WORDS = ("ball", "obstruction", "miscue")


def like(numbers: Sequence[float | None], strike: Mapping[str, Any]) -> Strike:
    """A strike with these numbers, on the ball and under the policies of another one.

    Args:
        numbers: Speed (m/s), azimuth, elevation (rad, or None), side, height (ball radii).
        strike: The shot file's ``strike`` with the ball, ``obstruction`` and ``miscue``.
    """
    speed, azimuth, elevation, side, height = numbers
    ball, obstruction, miscue = (strike.get(key, getattr(Strike, key)) for key in _WORDS)
    return Strike._of(speed, azimuth, elevation, side, height, ball, obstruction, miscue)


def opening(
    game: str,
    *,
    table: str | None,
    speed: float | None,
    seed: int,
    gap: float | None,
    preset: str | None = None,
) -> _core.Shot:
    """The opening shot of a game; see ``carom.break_shot`` for the arguments.

    Raises:
        InputError: There is no such game or table, or a value is out of range.
    """
    return _core.break_shot(
        text("game", game, '"nine-ball"'),
        None if preset is None else text("preset", preset, "a break preset's name"),
        None if table is None else text("table", table, "a preset's name"),
        None if speed is None else number("speed", speed),
        whole("seed", seed),
        None if gap is None else number("gap", gap),
    )
