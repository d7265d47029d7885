"""The parts that a shot is built from: table, physics, layout, strike.

Each stands for a part of the shot file, with Python's names and with angles in radians. The engine
checks the values when the shot is built.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self

from carom import _core
from carom.arguments import number, text, whole

JSON = dict[str, Any]


@dataclass(frozen=True)
class Table:
    """A table: a preset, possibly with changed keys, a plain rectangle, or unbounded cloth.

    Args:
        description: The shot file's ``table``: a preset's name (`carom tables` lists them) or
            an object.
    """

    description: str | Mapping[str, Any] = "wpa-9ft"

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
    """

    description: str | Mapping[str, Any] | None = None

    @classmethod
    def preset(cls, name: str, **changes: Any) -> Self:
        """A preset with some parameters changed.

        Args:
            name: ``pool``, ``snooker``, ``english``, ``carom``, ``poolfiz`` or ``ideal``.
            changes: Sections to merge over it, e.g. ``cloth={"sliding_friction": 0.25}``.
        """
        return cls({"base": name, **changes} if changes else name)


@dataclass(frozen=True)
class Layout:
    """The balls and where they are.

    Args:
        balls: The shot file's ``balls``: each with ``id``, ``position`` (2 or 3 numbers, m) and
            optionally ``velocity`` (m/s), ``angular_velocity`` (rad/s), ``mass`` (kg) and
            ``radius`` (m).
    """

    balls: Sequence[Mapping[str, Any]] = field(default_factory=tuple)

    @classmethod
    def at(cls, positions: Mapping[str, Sequence[float]]) -> Self:
        """Balls at rest, by id: ``Layout.at({"cue": (0.6, 0.6), "1": (0.6, 1.9)})``, in m."""
        # The engine rejects invalid positions and names their place in the file.
        return cls(tuple({"id": i, "position": p} for i, p in positions.items()))

    @classmethod
    def rack(
        cls, game: str, *, table: str | None = None, seed: int = 0, gap: float | None = None
    ) -> Self:
        """The balls before the break, the cue ball first.

        Args:
            game: ``eight-ball``, ``nine-ball``, ``ten-ball``, ``straight-pool``, ``snooker`` or
                ``three-cushion``.
            table: A preset's name; the game's own table if None.
            seed: Seed of the rack; the same seed gives the same rack on every platform.
            gap: Mean gap between the balls, m; 0 is frozen, None is the usual 0.1 mm.

        Raises:
            InputError: There is no such game or table.
        """
        rack = opening(game, table=table, speed=None, seed=seed, gap=gap)
        return cls(tuple(rack.to_object()["balls"]))


@dataclass(frozen=True)
class Strike:
    """A strike of the cue.

    Args:
        ball: Id of the struck ball.
        speed: The cue's speed at contact, m/s, in (0, 50].
        azimuth: Direction in which the cue moves, counter-clockwise from +x, rad.
        elevation: Butt raised above horizontal, rad, in [0, π/2). None is the default elevation:
            the least angle of a real stroke at which the cue clears the rails and the other balls
            (docs/formats.md).
        side: Contact point right of the centre, in ball radii.
        height: Contact point above the centre, in ball radii.
        obstruction: ``"report"`` or ``"refuse"`` a cue that would pass through a ball or rail.
        miscue: ``"refuse"`` a miscue, or ``"report"`` it and play as if the tip had not slipped.
    """

    speed: float
    azimuth: float
    elevation: float | None = None
    side: float = 0.0
    height: float = 0.0
    ball: str = "cue"
    obstruction: str = "report"
    miscue: str = "refuse"

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


# The keys of a shot file's ``strike`` that are not numbers.
_WORDS = ("ball", "obstruction", "miscue")


def like(numbers: Sequence[float], strike: Mapping[str, Any]) -> Strike:
    """A strike with these numbers, on the ball and under the policies of another one.

    Args:
        numbers: Speed (m/s), azimuth, elevation (rad), side, height (ball radii).
        strike: The shot file's ``strike`` with the ball, ``obstruction`` and ``miscue``.
    """
    speed, azimuth, elevation, side, height = numbers
    words = {key: strike[key] for key in _WORDS if key in strike}
    return Strike(speed, azimuth, elevation, side, height, **words)


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
