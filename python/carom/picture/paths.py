"""The path of every ball as curves that a vector picture draws exactly.

Between two of its events a ball moves on a parabola, p(t) = p₀ + v₀t + ½at². A parabola is a
quadratic Bézier curve from p₀ to p₁ = p(T) whose control point, p₀ + ½v₀T, is where the tangents
at its ends meet. This holds for all three coordinates, so no path is sampled.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom.flights import Heights, highest

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.trace import Trace

# A flight that rises less than this, m, is drawn as if the ball stayed on the cloth.
SEEN = 1e-3

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Leg:
    """One ball's path from one of its events to the next; points in m, times in s."""

    start_time: float
    end_time: float
    start: Point
    control: Point
    end: Point
    heights: Heights = (0.0, 0.0, 0.0)

    @property
    def flies(self) -> bool:
        """Whether the ball is in the air: its height changes only there."""
        return len(set(self.heights)) > 1

    @property
    def top(self) -> float:
        """Largest height of the centre, m."""
        return highest(self.heights)

    def at(self, time: float) -> tuple[float, float, float]:
        """Position of the centre at a time (s) within this leg, m."""
        share = (time - self.start_time) / (self.end_time - self.start_time)
        x, y, z = (
            (1 - share) ** 2 * a + 2 * share * (1 - share) * b + share**2 * c
            for a, b, c in (
                *zip(self.start, self.control, self.end, strict=True),
                self.heights,
            )
        )
        return (x, y, z)

    @property
    def length(self) -> float:
        """Length of the curve, m (closed form of the quadratic Bézier's arc length)."""
        ax = self.start[0] - 2 * self.control[0] + self.end[0]
        ay = self.start[1] - 2 * self.control[1] + self.end[1]
        bx = 2 * (self.control[0] - self.start[0])
        by = 2 * (self.control[1] - self.start[1])
        # |B′(s)|² = as² + bs + c for s in [0, 1].
        a, b, c = 4 * (ax * ax + ay * ay), 4 * (ax * bx + ay * by), bx * bx + by * by
        # For a nearly straight curve the closed form below loses its digits to cancellation, but
        # the chord is exact to rounding.
        if a <= 1e-12 * (c + a):
            return math.dist(self.start, self.end)
        root_a, root_c, root_end = math.sqrt(a), math.sqrt(c), math.sqrt(max(0.0, a + b + c))
        bend = 4 * a * c - b * b
        ends = 2 * root_a * root_end + 2 * a + b
        begin = 2 * root_a * root_c + b
        turning = 0.0
        if bend > 1e-14 * a * a and ends > 0 and begin > 0:
            turning = bend / (8 * a * root_a) * math.log(ends / begin)
        return ((2 * a + b) * root_end - b * root_c) / (4 * a) + turning


@dataclass(frozen=True, slots=True)
class Route:
    """The whole path of one ball: its legs in order, its start and its end."""

    id: str
    radius: float
    start: Point
    end: Point
    legs: tuple[Leg, ...]
    fate: str
    """Its final motion: ``stationary``, ``pocketed``, ..."""
    rest_heights: tuple[float, float]
    """Heights of its centre at the start and at the end, m."""

    @property
    def length(self) -> float:
        """Length of the whole path, seen from above, m."""
        return sum(leg.length for leg in self.legs)

    def split(self) -> tuple[list[Leg], list[Leg]]:
        """Its legs on the ground, and its visible flights."""
        ground: list[Leg] = []
        aloft: list[Leg] = []
        for leg in self.legs:
            (aloft if self.rise(leg) >= SEEN else ground).append(leg)
        return ground, aloft

    def rise(self, leg: Leg) -> float:
        """Largest height of the ball above the slate on a leg in the air, m; 0 on other legs."""
        return max(0.0, leg.top - self.radius) if leg.flies else 0.0

    def at(self, time: float) -> tuple[float, float, float]:
        """Position of the centre at a time (s), m."""
        before = (*self.start, self.rest_heights[0])
        for leg in self.legs:
            if time < leg.start_time:
                return before
            if time <= leg.end_time:
                return leg.at(time)
            before = (*leg.end, leg.heights[2])
        return before


def starts(trace: Trace) -> list[dict[str, Any]]:
    """The balls at time 0, in the form that ``routes`` needs."""
    shot, start = trace.shot, trace.at(0.0)
    return [
        {"id": name, "radius": radius, "position": place, "velocity": velocity}
        for name, radius, place, velocity in zip(
            shot.ids,
            shot.radius.tolist(),
            start.position.tolist(),
            start.velocity.tolist(),
            strict=True,
        )
    ]


def routes(trace: dict[str, Any], balls: Sequence[dict[str, Any]]) -> list[Route]:
    """Compute each ball's path from a trace.

    Args:
        trace: A ``carom-trace/1``.
        balls: The shot's balls at time 0, each with ``id``, ``position`` (m), ``velocity``
            (m/s) and ``radius`` (m), in the order of the shot.

    Returns:
        One route per ball, in the same order.
    """
    legs: dict[str, list[Leg]] = {ball["id"]: [] for ball in balls}
    last = {ball["id"]: (0.0, ball["position"], ball["velocity"]) for ball in balls}
    for event in trace["events"]:
        for before, after in zip(event["before"], event["after"], strict=True):
            _extend(legs[after["id"]], last[after["id"]], event["time"], before["position"])
            last[after["id"]] = (event["time"], after["position"], after["velocity"])
    final = {state["id"]: state for state in trace["final"]}
    for ball in balls:
        end = final[ball["id"]]
        _extend(legs[ball["id"]], last[ball["id"]], trace["duration"], end["position"])
    return [
        Route(
            id=ball["id"],
            radius=ball["radius"],
            start=_flat(ball["position"]),
            end=_flat(final[ball["id"]]["position"]),
            legs=tuple(legs[ball["id"]]),
            fate=final[ball["id"]]["motion"],
            rest_heights=(ball["position"][2], final[ball["id"]]["position"][2]),
        )
        for ball in balls
    ]


def _extend(
    legs: list[Leg],
    last: tuple[float, Sequence[float], Sequence[float]],
    time: float,
    position: Sequence[float],
) -> None:
    since, start, velocity = last
    half = 0.5 * (time - since)
    # The ball did not move, unless it flew straight up and fell back to the same place.
    if tuple(start) == tuple(position) and (half == 0.0 or velocity[2] == 0.0):
        return
    x, y, z = (p + v * half for p, v in zip(start, velocity, strict=True))
    heights = (float(start[2]), z, float(position[2]))
    legs.append(Leg(since, time, _flat(start), (x, y), _flat(position), heights))


def _flat(position: Sequence[float]) -> Point:
    return (float(position[0]), float(position[1]))
