"""Strikes and chances in words."""

from __future__ import annotations

import math
from collections.abc import Sequence

from carom._core import TIP

# A cue that is raised by more than this is mentioned, rad: 10°. Strokes over the rail have less.
RAISED = math.radians(10.0)


def tip_offset(side: float, height: float) -> str:
    """A tip offset to half a tip, such as ``½ tip of left, 2 tips of draw``.

    Args:
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
    """
    parts = (_tips(side, "right", "left"), _tips(height, "follow", "draw"))
    return ", ".join(filter(None, parts)) or "centre"


def _tips(offset: float, plus: str, minus: str) -> str:
    """An offset in one direction, such as ``1½ tips of right``; empty below a quarter of a tip."""
    whole, half = divmod(round(2 * abs(offset) / TIP), 2)
    if not whole and not half:
        return ""
    number = f"{whole or ''}{'½' * half}"
    return f"{number} tip{'s' * (whole + half > 1)} of {plus if offset > 0 else minus}"


def strike(speed: float, side: float, height: float, elevation: float) -> str:
    """Speed, tip offset and a raised cue, such as ``2.1 m/s, ½ tip of left``.

    Args:
        speed: The cue's speed, m/s.
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
        elevation: Butt raised above horizontal, rad.
    """
    raised = f", cue raised {math.degrees(elevation):.0f}°" if elevation > RAISED else ""
    return f"{speed:.1f} m/s, {tip_offset(side, height)}{raised}"


def percent(share: float | None) -> str:
    """A probability in whole per cent; ``–`` for None."""
    return "–" if share is None else f"{100 * share:.0f} %"


def place(point: tuple[float, float]) -> str:
    """A point on the table in m, to the centimetre."""
    return f"({point[0]:.2f}, {point[1]:.2f})"


def pot(kind: str, ball: str, pocket: str, legs: Sequence[tuple[str, int]]) -> str:
    """A pot, such as ``bank: 3 off 1 cushion into top-left``.

    Args:
        kind: Its kind, as ``Recommendation.kind``.
        ball: The ball that falls.
        pocket: The pocket.
        legs: The balls on the way, the cue ball first, each with its number of cushions.
    """
    aim = f"{ball} into {pocket}"
    match kind:
        case "bank":
            return f"bank: {ball} off {_cushions(legs[-1][1])} into {pocket}"
        case "kick":
            return f"kick: off {_cushions(legs[0][1])}, {aim}"
        case "combination":
            return f"combination: {legs[1][0]}, {aim}"
        case "indirect":
            return f"indirect: {aim}"
        case _:
            return aim


def _cushions(count: int) -> str:
    return f"{count} cushion{'s' * (count != 1)}"
