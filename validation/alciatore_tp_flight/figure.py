"""Hops of a draw shot, seen from the side, and massés from above."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_flight.rows import MASSES, draw, raised
from carom.validation.lab import FOOT

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    for k, elevation in enumerate((5.0, 15.0)):
        path = np.array(
            [draw(elevation).trace.at(t).position[0] for t in np.linspace(0.0, 0.5, 600)]
        )
        height = 1000 * (path[:, 2] - path[0, 2])
        plot.ours(left, path[:, 1] / FOOT, height, f"elevation {elevation:g}°", k)
    landings = np.cumsum((0.848, 0.500, 0.297, 0.177, 0.106))
    plot.published(left, landings, np.zeros(5), "TP B.10", 0)
    plot.published(left, [2.298], [0.0], color=1)
    left.set_xlim(0.0, 5.0)
    plot.name(left, "distance, ft", "height above the cloth, mm", "Draw shot, cue 15 mph")

    for k, (name, (phi, speed, side, height)) in enumerate(MASSES.items()):
        run = raised(phi, speed, side, height)
        path = np.array([run.trace.at(t).position[0] for t in np.linspace(0.0, 2.5, 800)])
        plot.ours(right, path[:, 0], path[:, 1], f"elevation {name}", k)
    right.set_xlim(-0.6, 0.6)
    right.set_ylim(-0.1, 1.5)
    plot.name(right, "across, m", "along the cue, m", "Massés")
    return fig
