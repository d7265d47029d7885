"""Rebound speed and angle against incidence, as the paper's Figs. 9 and 10."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.mathavan_2010.rows import ANGLES, angle, cu_3_angle, cu_3_speed, rebound

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    incidences = np.linspace(5.0, 90.0, 35)
    for k, roll in enumerate((1.0, 0.0, -1.0)):
        after = [rebound(np.radians(a), roll) for a in incidences]
        plot.ours(left, incidences, [b.speed for b in after], f"k_T = {roll:g}", k)
    plot.published(left, ANGLES, list(cu_3_speed.reference.values()), color=0)
    plot.published(left, [90], [0.911], color=0)
    plot.published(left, [90], [0.837], color=1)
    plot.published(left, [90], [0.866], color=2)
    plot.name(left, "incidence from the rail, °", "rebound speed, V₀")

    for k, side in enumerate((0.0, -1.0, 1.0)):
        after = [rebound(np.radians(a), 1.0, side) for a in incidences]
        plot.ours(right, incidences, [angle(b) for b in after], f"k_S = {side:g}", k)
    plot.published(right, ANGLES, list(cu_3_angle.reference.values()), color=0)
    plot.published(right, (30, 60, 90), (34.5, 73.4, 103.85), color=1)
    plot.published(right, (30, 60, 90), (30.5, 54.6, 76.0), color=2)
    plot.name(right, "incidence from the rail, °", "rebound angle, °", "Rolling, with sidespin")
    return fig
