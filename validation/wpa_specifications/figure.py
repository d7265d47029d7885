"""Table lengths against cue speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import MPH
from carom.validation.wpa_specifications.rows import lengths_travelled

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    speeds = np.linspace(1.0, 16.0, 46)
    plot.ours(ax, speeds, [lengths_travelled(v * MPH) for v in speeds], "carom, wpa-9ft")
    ax.axhspan(4.0, 4.5, color=plot.COLORS[1], alpha=0.25, label="WPA: at least 4 to 4½, firm")
    plot.name(ax, "cue speed, mph", "table lengths")
    return fig
