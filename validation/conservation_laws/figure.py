"""Errors of momentum and angular momentum."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.conservation_laws.rows import (
    angular_momentum_error,
    collisions,
    momentum_error,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    events = collisions()
    bins = np.logspace(-18, -11, 43)
    for k, (label, error) in enumerate(
        (("momentum", momentum_error), ("angular momentum", angular_momentum_error))
    ):
        values = np.maximum([error(e) for e in events], bins[0])
        ax.hist(
            values, bins.tolist(), histtype="step", color=plot.COLORS[k], linewidth=1.6, label=label
        )
    ax.axvline(1e-12, color="0.4", linestyle=":", label="bound")
    ax.set_xscale("log")
    plot.name(ax, "relative error of one collision", "collisions", f"{len(events)} collisions")
    return fig
