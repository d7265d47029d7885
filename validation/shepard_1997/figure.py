"""Speed of the rolling ball against tip height."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.shepard_1997.rows import rolled_speed

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    heights = np.linspace(-0.2, 0.55, 60)
    plot.ours(ax, heights, [rolled_speed(h) for h in heights])
    ax.axvline(0.235, color=plot.COLORS[1], linestyle=":", label="problem 3.11: x = 0.235")
    plot.name(ax, "tip height, R", "speed when it rolls / cue speed", "Elastic tip")
    return fig
