"""Throw: measured, and with the default parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_throw_tests.rows import (
    CUTS,
    OBJECT_SPEEDS,
    bb23,
    bb25,
    throw,
    throw_at_object_speed,
)
from carom.validation.lab import FOOT, TP_SPEEDS

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (left, right) = plot.panels(2)
    speeds = np.linspace(2.0, 11.5, 25)
    plot.ours(left, speeds, [throw_at_object_speed(30.0, v * FOOT) for v in speeds], "pool")
    dirty = [throw_at_object_speed(30.0, v * FOOT, "pool-dirty-balls") for v in speeds]
    plot.ours(left, speeds, dirty, "pool-dirty-balls", 1)
    plot.published(left, OBJECT_SPEEDS, list(bb23.reference.values()), "measured")
    left.set_ylim(0.0, 7.0)
    plot.name(left, "object ball's speed, ft/s", "throw at 30°, °", "2014 test")

    cuts = np.linspace(2.0, 75.0, 50)
    printed = np.array(list(bb25.reference.values())).reshape(len(CUTS), 3)
    for k, (label, speed) in enumerate(TP_SPEEDS.items()):
        plot.ours(right, cuts, [throw(c, speed) for c in cuts], label, k)
        plot.published(right, CUTS, printed[:, k], color=k)
    plot.name(right, "cut angle, °", "throw of a stun shot, °", "2006 test")
    return fig
