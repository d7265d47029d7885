"""A dropped ball's height, and the angle at which a ball leaves a lip."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.textbook_mechanics.rows import (
    BOUNCES,
    DROP,
    FLIES,
    RADIUS,
    RETURNED,
    dropped,
    lift_off,
    rolls_to,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    run = dropped()
    times = np.linspace(0.0, run.record["duration"], 800)
    heights = [run.trace.at(t).position[0][2] - RADIUS for t in times]
    plot.ours(left, times, heights)
    fall = np.sqrt(2 * DROP / 9.81)
    k = np.arange(1, BOUNCES + 1)
    # Time of the k-th apex: the fall, k − 1 hops and half of the k-th.
    when = fall * (1 + 2 * RETURNED * (1 - RETURNED ** (k - 1)) / (1 - RETURNED) + RETURNED**k)
    plot.published(left, when, DROP * RETURNED ** (2 * k), "e²ᵏh")
    plot.name(left, "time, s", "height above the cloth, m", "Dropped from 0.3 m, e = 0.5")

    shares = np.linspace(0.03, 1.1, 60)
    plot.ours(right, shares, [lift_off(s * FLIES) for s in shares])
    marks = np.linspace(0.05, 1.1, 15)
    plot.published(right, marks, [rolls_to(s * FLIES) for s in marks], "rolling about the edge")
    plot.name(
        right, "speed at the lip, √(gR)", "last touch, ° from the vertical", "Rolling over a lip"
    )
    return fig
