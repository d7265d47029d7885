"""Speeds and angles of shots 2–4: carom's and the paper's."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.mathavan_2014.rows import PHYSICS, SHOTS, bb22, rolled_out

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, axes = plot.panels(2)
    cuts = np.linspace(2.0, 75.0, 40)
    speed = SHOTS[1][0]
    values = np.array([rolled_out(PHYSICS, speed, c) for c in cuts])
    printed = np.array(list(bb22.reference.values())).reshape(3, 4)
    at = [cut for _, cut in SHOTS]
    scale = [speed / v for v, _ in SHOTS]
    for k, ball in enumerate(("cue ball", "object ball")):
        plot.ours(axes[0], cuts, values[:, k], ball, k)
        plot.published(axes[0], at, printed[:, k] * scale, color=k)
        plot.ours(axes[1], cuts, values[:, 2 + k], ball, k)
        plot.published(axes[1], at, printed[:, 2 + k], color=k)
    title = f"Rolling at {speed} m/s; rings scaled to it"
    plot.name(axes[0], "cut angle, °", "speed when both roll, m/s", title)
    plot.name(axes[1], "cut angle, °", "direction from the initial one, °")
    return fig
