"""Strikes and chances in words."""

from __future__ import annotations

import math

# Width of a cue's tip in ball radii: 13 mm on a pool ball of 57.15 mm. Players count tip offsets in
# such widths.
TIP = 0.45
# A cue that is raised by more than this is mentioned, rad: 10°. Strokes over the rail have less.
RAISED = math.radians(10.0)

_QUARTERS = ("", "¼", "½", "¾")
# The eight directions of an offset, from the right counter-clockwise.
_DIRECTIONS = (
    "right",
    "high right",
    "high",
    "high left",
    "left",
    "low left",
    "low",
    "low right",
)


def tip_offset(side: float, height: float) -> str:
    """A tip offset to a quarter of a tip's width, such as ``½ tip low left``.

    Args:
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
    """
    quarters = round(4 * math.hypot(side, height) / TIP)
    if not quarters:
        return "centre"
    whole, rest = divmod(quarters, 4)
    number = f"{whole or ''}{_QUARTERS[rest]}"
    octant = round(math.atan2(height, side) / (math.pi / 4)) % 8
    return f"{number} tip{'s' * (quarters > 4)} {_DIRECTIONS[octant]}"


def strike(speed: float, side: float, height: float, elevation: float) -> str:
    """Speed, tip offset and a raised cue, such as ``2.1 m/s, ½ tip low left``.

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
