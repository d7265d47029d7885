"""Target widths against angle and speed, and acceptance of a corner pocket."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_pockets.rows import (
    CORNER,
    OFFSETS,
    SIDE,
    made,
    width,
)
from carom.validation.lab import MPH, TP_SPEEDS

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, middle, right) = plot.panels(3)
    for ax, pocket, end, name in ((left, SIDE, 75, "Side pocket"), (middle, CORNER, 45, "Corner")):
        angles = np.linspace(-end, end, 2 * end + 1)
        for k, (speed, v) in enumerate(TP_SPEEDS.items()):
            widths = [1000 * width(pocket, math.radians(a), v) for a in angles]
            plot.ours(ax, angles, widths, f"{speed}, {v / MPH:.0f} mph", k)
        plot.name(ax, "approach, ° from the pocket's axis", "target width, mm", name)
    for sign in (-1, 1):
        left.axvline(sign * 68.292, color="0.3", linewidth=0.9, linestyle="--")
    left.text(68.292, left.get_ylim()[1], "TP 3.5, slow ", ha="right", va="top", rotation=90)

    # Along the rail: white where the ball is not pocketed.
    speeds = np.linspace(0.3, 4.0, 75)
    goes_in = np.array([made(CORNER, math.radians(-40.0), v) for v in speeds])
    edges = (OFFSETS[0] * 1000, OFFSETS[-1] * 1000, speeds[0], speeds[-1])
    right.imshow(
        np.where(goes_in, 1.0, np.nan), origin="lower", extent=edges, aspect="auto",
        cmap="Blues", vmin=0.0, vmax=1.6, interpolation="nearest",
    )  # fmt: skip
    right.grid(visible=False)
    plot.name(right, "offset, mm", "speed, m/s", "Corner, 40° from its axis: acceptance")
    return fig
