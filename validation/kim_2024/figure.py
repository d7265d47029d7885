"""The cue ball's final speed against restitution, and its hop against its speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_collision.rows import impact
from carom.validation.kim_2024.rows import hop
from carom.validation.lab import TP_GRAVITY

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    e = np.linspace(0.6, 1.0, 20)
    after = [impact(0.0, roll=1.0, restitution=k).rolling("cue").after["cue"].speed for k in e]
    plot.ours(left, e, after)
    plot.published(left, (1.0, 0.95, 0.94, 0.89), (0.2857, 0.3036, 0.3071, 0.3250), "Kim 2024")
    plot.name(left, "restitution", "cue ball when it rolls again, v", "Full hit, rolling")

    speeds = np.linspace(1.5, 6.0, 30)
    marks = np.linspace(2.0, 6.0, 6)
    for k, mu in enumerate((0.06, 0.03)):
        fast = speeds if mu == 0.06 else speeds[speeds > 2.0]
        plot.ours(right, fast, [1000 * hop(v, mu) for v in fast], f"carom, μ = {mu:g}", k)
        plot.published(right, marks, 1000 * (mu * marks) ** 2 / (2 * TP_GRAVITY), "", k)
    plot.name(right, "speed, m/s", "height of the hop, mm", "Rings: μ²U²/2g")
    return fig
