"""The paper's fits, and the engine's impacts with them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.han_2005.rows import INCIDENCES, SPEEDS, han_e, han_mu, rebound

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def tangential_share(degrees: float) -> float:
    """Tangential over normal impulse."""
    g = math.radians(degrees)
    after = rebound(1.0, g)
    return float((math.sin(g) - after.velocity[0]) / (math.cos(g) - after.velocity[1]))


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    v = np.linspace(0.1, 4.0, 40)
    plot.ours(left, v, [-float(rebound(s, 0.0).velocity[1]) / s for s in v])
    plot.published(left, SPEEDS, list(han_e.reference.values()), "e = 0.39 + 0.257V − 0.044V²")
    plot.name(left, "normal speed, m/s", "restitution")

    g = np.linspace(2.0, 85.0, 60)
    plot.ours(right, g, [tangential_share(a) for a in g], "carom: stick, then slip")
    plot.published(right, INCIDENCES, list(han_mu.reference.values()), "μ = 0.471 − 0.241γ")
    plot.name(right, "incidence from the normal, °", "tangential / normal impulse")
    return fig
