"""Diamond systems: the third rail of the corner five, and the arrival of the plus system."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.diamond_systems.rows import (
    ONE_TIP,
    RUNNING,
    corner_five_line,
    heading,
    played,
    plus_line,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    firsts = np.linspace(0.9, 4.1, 17)
    for k, preset in enumerate(("carom", "pool")):
        third = [
            heading(played(preset, corner_five_line(preset, 5.0, float(f)), RUNNING), preset)
            for f in firsts
        ]
        plot.ours(left, firsts, third, preset, k)
    plot.published(left, [1, 2, 3, 4], [4, 3, 2, 1], "5 − first", 6)
    plot.name(left, "first rail", "third rail", "Corner five, from 5")

    shorts = np.linspace(2.8, 5.2, 13)
    for k, start in enumerate((2.0, 3.0)):
        arrival = [
            heading(played("pool", plus_line("pool", start, float(n)), -ONE_TIP), "pool")
            for n in shorts
        ]
        plot.ours(right, shorts, arrival, f"pool, from {start:g}", k)
        plot.published(right, [3, 4, 5], [start + n for n in (3, 4, 5)], "", k)
    plot.name(right, "number on the short rail", "arrival, diamonds", "Plus system")
    return fig
