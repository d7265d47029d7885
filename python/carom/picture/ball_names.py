"""The names that diagrams write beside balls, and free places for them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from carom.picture.paths import Leg, Point, Route

# Distance of the points of a path that numbers keep clear of, m: less than half a number's height.
SPACING = 0.02
# Directions in which a free place for a number is searched.
DIRECTIONS = 24


def points_on(leg: Leg) -> list[Point]:
    """Points on a leg of a path, about a ball's radius apart."""
    count = max(1, math.ceil(leg.length / SPACING))
    span = leg.end_time - leg.start_time
    return [leg.at(leg.start_time + span * k / count)[:2] for k in range(count + 1)]


def ball_names(balls: Sequence[str]) -> dict[str, str]:
    """What is written beside each ball: its number, or the first letters of its colour.

    The cue ball has no name, and neither have several balls of one colour.
    """
    stems = {ball: ball.rstrip("0123456789").rstrip("-_ ") for ball in balls}
    names = {}
    for ball, stem in stems.items():
        others = [other for one, other in stems.items() if one != ball]
        if not stem:
            names[ball] = ball
        elif ball == "cue" or stem in others:
            names[ball] = ""
        else:
            lengths = range(1, len(stem) + 1)
            own = (n for n in lengths if not any(o.startswith(stem[:n]) for o in others))
            names[ball] = stem[: next(own, len(stem))].capitalize()
    return names


def free_place(
    ball: Route, half: float, taken: Sequence[tuple[Point, float]], geometry: dict[str, Any]
) -> Point:
    """The place beside a ball with the most space around it; the nearest of those with enough."""

    def space(at: Point) -> float:
        others = min(math.dist(at, middle) - radius for middle, radius in taken)
        if geometry["size"] is None:
            return others
        width, length = map(float, geometry["size"])
        return min(others, at[0], width - at[0], at[1], length - at[1])

    places = [
        (
            ball.start[0] + away * math.cos(math.tau * k / DIRECTIONS),
            ball.start[1] + away * math.sin(math.tau * k / DIRECTIONS),
        )
        for away in (ball.radius + half * step for step in (1.6, 2.1, 2.8))
        for k in range(DIRECTIONS)
    ]
    return next((at for at in places if space(at) >= 1.4 * half), max(places, key=space))
