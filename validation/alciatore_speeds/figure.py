"""The cue ball's rebound from a rack against its speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_speeds.rows import FASTEST, LOSSLESS, head_on
from carom.validation.lab import JSON, MPH

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    speeds = np.linspace(10.0, FASTEST, 13)
    frictional: JSON = {"model": "frictional", "restitution": 0.95, "friction": 0.05}
    for k, (label, law) in enumerate(
        (("e = 1, no friction (SY2)", LOSSLESS), ("e = 0.95, μ = 0.05", frictional))
    ):
        plot.ours(ax, speeds, [head_on(v * MPH, law)[0] / MPH for v in speeds], label, k)
    ax.plot(speeds, speeds / 5, ":", color="0.4", label="v/5 (TP B.20)")
    ax.axvspan(22, 26, color=plot.COLORS[5], alpha=0.2, label="breaks, men")
    plot.name(ax, "cue ball, mph", "rebound off the rack, mph", "Head-on, 15 balls 0.1 mm apart")
    return fig
