"""The measured decelerations, the law, its speed bands, and the error of the rolls in them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.three_cushion_tracks.rows import (
    MEASURED,
    banded,
    deceleration,
    distance,
    law,
    rolled,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    v = np.linspace(0.02, 3.0, 299)
    plot.ours(left, v, [deceleration(x, banded()) for x in v], "carom, speed bands")
    plot.ours(left, v, [deceleration(x, "carom") for x in v], "carom, preset", 1)
    left.plot(v, [law(x) for x in v], "--", color=plot.COLORS[6], linewidth=1, label="law")
    plot.published(left, list(MEASURED), list(MEASURED.values()), "tracks", 6)
    plot.name(left, "speed, m/s", "deceleration, m/s²", "Rolling on heated cloth")

    for k, (share, least) in enumerate(((0.002, 0.01), (0.005, 0.005), (0.01, 0.01))):
        physics = banded(share, least)
        error = [1000 * (rolled(x, physics)[0] - distance(x)) / distance(x) for x in v[20:]]
        count = len(physics["cloth"]["rolling_friction"])
        plot.ours(right, v[20:], error, f"{count} bands", k)
    plot.name(right, "speed at the start, m/s", "error of the roll, ‰", "Place of rest")
    return fig
