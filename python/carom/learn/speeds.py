"""Speeds between the samples of tracks."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn.tracks import TrackedShot

if TYPE_CHECKING:
    from numpy.typing import NDArray

# A step of at least this length, m, is one of a moving ball, and not the error of a camera.
_MOVES = 0.01


def speeds_of(shots: Iterable[TrackedShot]) -> tuple[float, NDArray[np.float64]]:
    """The median time between samples of moving balls, s, and the speeds between them, m/s."""
    steps, speeds = [np.empty(0)], [np.empty(0)]
    for shot in shots:
        for ball in shot.balls.values():
            seen = ball.seen
            if len(seen) < 2:
                continue
            step = np.diff(seen.time)
            way = np.hypot(*np.diff(seen.position, axis=0).T)
            moves = way >= _MOVES
            steps.append(step[moves])
            speeds.append(way[moves] / step[moves])
    all_steps = np.concatenate(steps)
    return float(np.median(all_steps)) if all_steps.size else 0.0, np.concatenate(speeds)
