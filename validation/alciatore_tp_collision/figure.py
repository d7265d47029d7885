"""Throw against cut, and the 30° rule."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_collision.rows import (
    bb7,
    cut_of_fraction,
    deflection,
    impact,
    stun_throw,
)
from carom.validation.lab import TP_SPEEDS

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    cuts = np.linspace(1.0, 80.0, 60)
    printed = np.array(list(bb7.reference.values())).reshape(4, 3)
    for k, (label, speed) in enumerate(TP_SPEEDS.items()):
        plot.ours(left, cuts, [stun_throw(c, speed) for c in cuts], f"{label}, {speed} m/s", k)
        plot.published(left, (10, 30, 45, 60), printed[:, k], color=k)
    plot.name(left, "cut angle, °", "throw of a stun shot, °", "Rings: TP A.14")

    cuts = np.radians(np.linspace(2.0, 85.0, 60))
    for k, (e, mu) in enumerate(((1.0, 0.0), (0.94, 0.06))):
        angles = [deflection(impact(c, roll=1.0, restitution=e, friction=mu)) for c in cuts]
        plot.ours(right, np.degrees(cuts), angles, f"e = {e:g}, μ = {mu:g}", k)
    at = [math.degrees(cut_of_fraction(f)) for f in (0.25, 0.5, 0.75)]
    plot.published(right, at, [27.267, 33.670, 27.626], "TP 3.3", 0)
    plot.published(right, [30.0], [34.026], "TP A.6", 1)
    plot.name(right, "cut angle, °", "final deflection of the cue ball, °", "Rolling cue ball")
    return fig
