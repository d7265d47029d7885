"""Ball speed against tip offset, and squirt."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_strike.rows import BALL_MASS, squirt, struck

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    x = np.linspace(0.0, 0.55, 45)
    for k, (label, cue) in enumerate(
        (
            ("η = 0.87", {"tip_efficiency": 0.87}),
            ("e = 0.73 (leather)", {"tip_restitution": 0.73}),
            ("e = 0.87 (phenolic)", {"tip_restitution": 0.87}),
        )
    ):
        plot.ours(left, x, [struck(height=-h, **cue).speed for h in x], label, k)
    plot.published(left, [0.0, 0.5], [1.2745, 0.74628], "TP A.30, B.10", 0)
    plot.published(left, [0.0], [1.3148], color=1)
    plot.published(left, [0.0], [1.4212], color=2)
    plot.name(left, "tip offset, R", "ball speed / cue speed")

    ratios = np.linspace(10, 60, 40)
    plot.ours(right, ratios, [squirt(1.0, 0.5, BALL_MASS / r) for r in ratios])
    plot.published(right, [15, 20, 40, 53.3], [3.466, 2.709, 1.446, 1.103], "TP A.31")
    plot.name(right, "ball mass / shaft-end mass", "squirt at ½R, °")
    return fig
