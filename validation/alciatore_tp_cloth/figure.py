"""Distances to natural roll, and the massé of CL12."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_cloth.rows import distance_to_roll, steep_masse
from carom.validation.lab import FOOT, MPH

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Tip height as the spin it gives, in units of natural roll, with the printed distances (ft).
TIPS = (
    ("¼R below", -0.625, (1.073, 5.840, 17.162)),
    ("centre (stun)", 0.0, (0.737, 4.012, 11.789)),
    ("½R above", 1.25, (0.2226, 1.2118, 3.5612)),
    ("¼R above", 0.625, (0.305, 1.661, 4.881)),
)


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    speeds = np.linspace(0.5, 13.0, 40)
    for k, (label, roll, printed) in enumerate(TIPS):
        plot.ours(left, speeds, [distance_to_roll(v * MPH, roll) / FOOT for v in speeds], label, k)
        plot.published(left, (3, 7, 12), printed, color=k)
    plot.name(left, "speed, mph", "distance to natural roll, ft", "Rings: TP 4.1, A.18, CL6")

    run = steep_masse()
    times = np.linspace(0.0, 1.2 * run.rolling("cue").time, 200)
    path = np.array([run.trace.at(t).position[0] for t in times])
    plot.ours(right, path[:, 0], path[:, 1])
    plot.published(right, [0.2177], [0.3346], "end of sliding, closed form")
    right.set_aspect("equal")
    plot.name(right, "to the right of the aim, m", "along the aim, m", "Massé at 75°, 9 mph")
    return fig
