"""Flights of balls: how high they rise, and hops that are too small to see.

A ball that tips over an edge makes many hops within some milliseconds. Tables of events and
pictures show such a run as one event.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

Heights = tuple[float, float, float]
"""The heights of a parabola's start, Bézier control point and end, m."""

# Longest time between two hops of one run, s. A ball that presses on an edge with its full weight
# returns to it after at most 8 ms. On the open slate each hop takes half as long as the one before
# and the shortest recorded one takes 6 ms, so that bounces there never form a run.
HOP_TIME = 9e-3
# The last hops of a run, where the edge carries little of the weight, take longer: at most this
# many times as long as the one before.
GROWTH = 2.0
# Least number of hops in a run.
LEAST_RUN = 3


def highest(heights: Heights) -> float:
    """The highest point of a parabola from its Bézier ordinates, m."""
    start, control, end = heights
    if control <= max(start, end):
        return max(start, end)
    return start + (control - start) ** 2 / (2 * control - start - end)


def runs(events: Sequence[dict[str, Any]]) -> list[list[int]]:
    """Group the indices of events: a run of hops of one ball over one edge is one group.

    Args:
        events: The events of a ``carom-trace/1``.

    Returns:
        Groups of indices, sorted by their first one. A group has one index or at least
        ``LEAST_RUN``.
    """
    found: list[list[int]] = []
    open_runs: dict[str, list[int]] = {}
    for index, event in enumerate(events):
        if event["type"] in {"slate-collision", "rail-collision"}:
            ball = event["balls"][0]
            run = open_runs.get(ball)
            if run is not None and _continues([events[i] for i in run[-2:]], event):
                run.append(index)
                continue
            open_runs[ball] = [index]
            found.append(open_runs[ball])
            continue
        for ball in event["balls"]:
            open_runs.pop(ball, None)
        found.append([index])
    return sorted(
        part
        for run in found
        for part in ([run] if len(run) >= LEAST_RUN else [[index] for index in run])
    )


def _continues(last: Sequence[dict[str, Any]], event: dict[str, Any]) -> bool:
    same = all(last[-1].get(key) == event.get(key) for key in ("type", "rail", "part"))
    longest = max(HOP_TIME, GROWTH * (last[-1]["time"] - last[0]["time"]))
    return same and event["time"] - last[-1]["time"] < longest
