"""Rebound speeds of the film and of the snooker preset."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.mathavan_2009.rows import bb20, film, rebound_speed

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    x = np.linspace(0.3, 3.5, 30)
    plot.ours(left, x, [rebound_speed(v) for v in x], "carom, snooker")
    plot.published(left, x[::2], [film(v) for v in x[::2]], "fit to 31 filmed shots")
    plot.name(left, "speed before, m/s", "speed after, m/s", "Perpendicular, rolling")

    comparisons = bb20.compare()
    for k, (label, start) in enumerate((("cue ball", 0), ("object ball", 1))):
        chosen = comparisons[start::3]
        x3 = np.arange(3) + 0.1 * k
        plot.published(right, x3, [float(str(c.reference)) for c in chosen], f"{label}, filmed", k)
        right.plot(x3, [c.ours for c in chosen], "_", color=plot.COLORS[k], markersize=16,
                   markeredgewidth=2, label=f"{label}, carom")  # fmt: skip
    right.set_xticks(range(3), ["26.4°", "40.5°", "46.5°"])
    plot.name(right, "cut angle", "speed when both roll, m/s", "Ball on ball")
    return fig
