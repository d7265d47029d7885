"""The two cues' jumps, and launch angle against the elevation of the cue."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import INCH
from carom.validation.unf_jump_machine.rows import LAUNCHES, launch_angle, launched

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    for k, (name, launch) in enumerate(LAUNCHES.items()):
        run = launched(*launch)
        path = np.array([run.trace.at(t).position[0] for t in np.linspace(0.0, 0.7, 400)])
        plot.ours(left, path[:, 1] / INCH, (path[:, 2] - path[0, 2]) / INCH, name, k)
    plot.published(left, [38.80 / 2, 38.80], [4.56, 0.0], "range (measured), apex", 0)
    plot.published(left, [64.28 / 2, 64.28], [8.39, 0.0], "", 1)
    plot.name(left, "distance, in", "height above the cloth, in")

    elevations = np.linspace(5.0, 60.0, 50)
    plot.ours(right, elevations, [launch_angle(e) for e in elevations], "`pool`, centre ball")
    for k, (angle, _) in enumerate(LAUNCHES.values()):
        right.axhline(angle, color=plot.COLORS[k], linewidth=0.8, linestyle="--")
    plot.name(right, "elevation of the cue, °", "launch angle of the ball, °")
    return fig
