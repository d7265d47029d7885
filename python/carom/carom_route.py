"""Routes of caroms, and readings of diamond systems."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, Self

from carom.record import Record

# Names of hits by how much of the ball is covered, each from this share on.
_HITS = (
    (0.97, "full"),
    (0.875, "nearly full"),
    (0.625, "three-quarter ball"),
    (0.375, "half ball"),
    (0.175, "quarter ball"),
    (0.06, "thin"),
    (0.0, "very thin"),
)
_PATTERNS = {
    "direct": "direct",
    "one-cushion": "one cushion",
    "two-cushions": "two cushions",
    "around-the-table": "around the table",
    "double-the-rail": "double the rail",
    "across-the-table": "opposite rails",
    "across-then-corner": "opposite rails, then the corner",
    "corner-then-across": "the corner, then opposite rails",
    "ticky": "ticky",
    "cushion-first": "one cushion first",
    "umbrella": "umbrella",
    "cushions-first": "three cushions first",
    "same-rail": "the same rail in a row",
}
_SIDES = {"none": "no side", "running": "running side", "reverse": "reverse side"}


class DiamondReading(Record):
    """What a diamond system says of the way of a ball. Numbers are diamonds of the system.

    Attributes:
        system: ``corner-five``, ``plus`` or ``two-to-one``; docs/realism.md has their sources.
        from_: The number from which the ball comes, to a tenth; the key is ``from``.
        over: The number over which it goes, to a tenth.
        predicted: Where it arrives by the system.
        actual: Where it arrives by the engine; None if it falls, stops or meets a ball before.
        numbers: The diamonds: each with ``at`` (x, y in m), ``number`` and ``scale``, which is
            ``line``, or ``target`` for the numbers of the arrival.
        places: The places of these numbers on the lines of sights, x and y in m.
    """

    __slots__ = ()

    system: Literal["corner-five", "plus", "two-to-one"]
    from_: float
    over: float
    predicted: float
    actual: float | None
    numbers: list[dict[str, Any]]
    places: dict[str, list[float] | None]

    def __str__(self) -> str:
        a, b, c = (f"{x:.1f}" for x in (self.from_, self.over, self.predicted))
        match self.system:
            case "corner-five":
                said = f"corner five: {a} − {b} = {c}"
            case "plus":
                said = f"plus system: {a} + {b} = {c}"
            case _:
                said = f"two to one: 2 × {b} − {a} = {c}"
        return said if self.actual is None else f"{said}, arrives at {self.actual:.1f}"


class CaromRoute(Record):
    """The route of a cue ball to its second object ball.

    Attributes:
        pattern: The order of the rails: ``direct``, ``one-cushion``, ``two-cushions``,
            ``around-the-table``, ``double-the-rail``, ``across-the-table``,
            ``across-then-corner``, ``corner-then-across``, ``same-rail``; with cushions before the
            first ball ``ticky`` (the same rail behind it), ``cushion-first`` (one), ``umbrella``
            (two), ``cushions-first`` (three and more).
        first: Id of the first object ball.
        second: Id of the second one.
        cushions: The cushions up to the second ball in order, each ``long`` or ``short``, as a
            referee counts them.
        rails: The rails of these cushions.
        cushions_first: Number of those before the first ball.
        fullness: How much of the first and of the second ball the cue ball covers, 1 (full) to 0;
            None in a contact of several balls.
        side: How the sidespin acts at the first cushion: ``running``, ``reverse``, or ``none``
            below half a tip.
        system: The system with which a player would reckon the way; None if none fits.
    """

    __slots__ = ()

    pattern: str
    first: str
    second: str
    cushions: list[Literal["long", "short"]]
    rails: list[str]
    cushions_first: int
    fullness: list[float | None]
    side: Literal["none", "running", "reverse"]
    system: DiamondReading | None

    @classmethod
    def _read(cls, node: Mapping[str, Any] | None) -> Self | None:
        """The route from its values in Rust."""
        if node is None:
            return None
        system = node["system"]
        return cls({**node, "system": None if system is None else DiamondReading(system)})

    @property
    def name(self) -> str:
        """The pattern in words with the first ball, such as ``around the table off red``."""
        return f"{_PATTERNS[self.pattern]} off {self.first}"

    def __str__(self) -> str:
        """Such as ``half ball off red, long, short, long, thin on yellow, running side``."""
        before = self.cushions_first
        one, other = map(_hit, self.fullness)
        parts = [
            *self.cushions[:before],
            f"{one}off {self.first}",
            *self.cushions[before:],
            f"{other}on {self.second}",
            _SIDES[self.side],
        ]
        return ", ".join(parts)


def _hit(fullness: float | None) -> str:
    """The players' name of a hit, with a space behind it; empty for None."""
    if fullness is None:
        return ""
    return next(f"{name} " for least, name in _HITS if fullness >= least)
