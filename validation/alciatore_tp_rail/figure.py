"""Starts of banks, and the distance of a lag."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_rail.rows import AIMS, TABLES, bank, cu_16, lag_distance
from carom.validation.lab import FOOT, MPH

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    aims = np.linspace(0.5, 3.0, 26)
    measured = np.array(list(cu_16.reference.values())).reshape(3, -1)
    for k, (label, values) in enumerate(zip(TABLES, measured, strict=True)):
        size, preset = TABLES[label]
        plot.ours(left, aims, [bank(a, *size, preset) for a in aims], preset, k + 1)
        plot.published(left, AIMS, values, label, k + 1)
    left.plot(AIMS, [2 * a for a in AIMS], ":", color="0.5", label="mirror")
    plot.name(left, "aim, diamonds", "start, diamonds", "Fast sliding bank into the corner")

    speeds = np.linspace(0.5, 8.0, 100)
    plot.ours(right, speeds, [lag_distance(v * MPH) / FOOT for v in speeds], "formula of TP B.6")
    plot.published(right, (1.5, 3.0, 7.0, 3.465), (7.522, 14.033, 25.041, 200 / 12), "TP B.6")
    plot.name(right, "speed, mph", "distance, ft", "Lag, stun after each rail (formula only)")
    return fig
