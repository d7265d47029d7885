"""The cue ball's final speed against restitution."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_collision.rows import impact

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    e = np.linspace(0.6, 1.0, 20)
    after = [impact(0.0, roll=1.0, restitution=k).rolling("cue").after["cue"].speed for k in e]
    plot.ours(ax, e, after)
    plot.published(ax, (1.0, 0.95, 0.94, 0.89), (0.2857, 0.3036, 0.3071, 0.3250), "Kim 2024")
    plot.name(ax, "restitution", "cue ball once it rolls again, v", "Full hit, rolling")
    return fig
