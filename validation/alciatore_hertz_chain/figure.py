"""Speeds after the impact of a row of balls."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.validation import plot
from carom.validation.alciatore_hertz_chain.rows import bb19, chain

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (three, six) = plot.panels(2)
    plot.ours(three, [1, 2, 3], chain(3))
    plot.published(three, [1, 2, 3], list(bb19.reference.values()), "TP B.29")
    plot.name(three, "ball", "speed after, m/s", "Three balls, one moves")
    for moving in (1, 2):
        plot.ours(six, [1, 2, 3, 4, 5, 6], chain(6, moving), f"{moving} of six", color=moving - 1)
    plot.name(six, "ball", "speed after, m/s", "Six balls, one and two move")
    for ax in (three, six):
        ax.axhline(0.0, color="0.6", linewidth=0.8)
    return fig
