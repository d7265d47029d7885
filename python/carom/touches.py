"""Touches that are one to the eye: a ball tips over an edge in many hops that nobody sees."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

# Hops over an edge follow each other within this, s: the engine brings a ball that presses on
# the edge with all its weight back after 8 ms at most. On the open slate a hop takes half as long
# as the one before, and the least that is not left out takes 6 ms: no run of them comes about.
HOP_TIME = 9e-3
# The last hops, where little of the weight is left, may last longer: this times the one before.
GROWTH = 2.0
# From so many on hops are a run.
LEAST_RUN = 3


def runs(events: Sequence[dict[str, Any]]) -> list[list[int]]:
    """Indices of the events, in order; those of a run of hops of one ball over one edge together.

    Args:
        events: As a ``carom-trace/1`` has them.

    Returns:
        Lists by their first index: one index each, or at least ``LEAST_RUN``.
    """
    found: list[list[int]] = []
    open_runs: dict[str, list[int]] = {}
    for index, event in enumerate(events):
        if event["type"] in {"slate-collision", "rail-collision"}:
            ball = event["balls"][0]
            run = open_runs.get(ball)
            if run is not None and _goes_on([events[i] for i in run[-2:]], event):
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


def _goes_on(last: Sequence[dict[str, Any]], event: dict[str, Any]) -> bool:
    same = all(last[-1].get(key) == event.get(key) for key in ("type", "rail", "part"))
    longest = max(HOP_TIME, GROWTH * (last[-1]["time"] - last[0]["time"]))
    return same and event["time"] - last[-1]["time"] < longest
