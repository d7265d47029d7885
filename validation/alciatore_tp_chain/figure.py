"""Speeds along a row of touching balls."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_chain.rows import chain, hertz

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    for k, n in enumerate((3, 4, 6)):
        numbers = np.arange(1, n + 1)
        plot.ours(left, numbers, chain(n), f"{n} balls", k)
        plot.published(left, numbers, hertz(n), "", k)
    plot.published(left, [1, 2, 3], [-0.071, 0.076, 0.995], "TP B.29", 6)
    plot.name(left, "ball", "speed after, m/s", "Frozen in a line (rings: Hertz)")

    restitutions = np.linspace(0.5, 1.0, 21)
    speeds = np.array([chain(3, e) for e in restitutions])
    for k, name in enumerate(("first", "second", "third")):
        plot.ours(right, restitutions, speeds[:, k], name, k)
    plot.name(right, "restitution", "speed after, m/s", "Three balls")
    return fig
