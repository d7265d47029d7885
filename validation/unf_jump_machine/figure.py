"""The two cues' jumps, and launch angle against the elevation of the cue."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import INCH, JSON
from carom.validation.unf_jump_machine.rows import JUMP_CUE, LAUNCHES, launch, launched

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: The cues of the right panel.
CUES: dict[str, JSON | str] = {
    "jump cue": JUMP_CUE,
    "playing cue (`pool`)": "pool",
    "the same, sequential": {"base": "pool", "cue": {"model": "sequential"}},
}


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    for k, (name, start) in enumerate(LAUNCHES.items()):
        run = launched(*start)
        path = np.array([run.trace.at(t).position[0] for t in np.linspace(0.0, 0.7, 400)])
        plot.ours(left, path[:, 1] / INCH, (path[:, 2] - path[0, 2]) / INCH, name, k)
    plot.published(left, [38.80 / 2, 38.80], [4.56, 0.0], "range (measured), apex", 0)
    plot.published(left, [64.28 / 2, 64.28], [8.39, 0.0], "", 1)
    plot.name(left, "distance, in", "height above the cloth, in")

    elevations = np.linspace(5.0, 65.0, 50)
    for k, (label, physics) in enumerate(CUES.items()):
        angles = [launch(e, physics)[0] for e in elevations]
        plot.ours(right, elevations, angles, label, k + 2)
    for k, (angle, _) in enumerate(LAUNCHES.values()):
        right.axhline(angle, color=plot.COLORS[k], linewidth=0.8, linestyle="--")
    plot.name(right, "elevation of the cue, °", "launch angle of the ball, °")
    return fig
