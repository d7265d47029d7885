"""Throw: the object ball's direction off the line of centres."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import FOOT, Ball, ball, crossing, degrees_between, simulate, touching

from realism.item import MEASURED, Choice, Item, Physics, Point, lines, rings

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RADIUS = 0.028575
PRESET, DIRTY = "pool", "pool-dirty-balls"
#: The presets of the surfaces. No preset has balls cleaned with alcohol, and a chalked contact is a
#: cling.
SURFACES = {"used": PRESET, "ball cleaner": "pool-clean-balls"}


def hit(cut_deg: float, speed: float, physics: Physics) -> Ball:
    """The object ball after a stun shot at `speed` m/s."""
    run = simulate(
        ball(velocity=(0.0, speed, 0.0), radius=RADIUS),
        ball("object", touching(math.radians(cut_deg), RADIUS), radius=RADIUS),
        physics=physics,
    )
    return run.first("ball-collision").after["object"]


def throw(cut_deg: float, speed: float, physics: Physics) -> float:
    """Degrees between the object ball's direction and the line of centres."""
    after = hit(cut_deg, speed, physics)
    return degrees_between(math.pi / 2 + math.radians(cut_deg), after.heading)


def throw_at(cut_deg: float, object_speed: float, physics: Physics) -> float:
    """The throw at the cue ball's speed that gives the object ball `object_speed`, m/s."""
    speed = crossing(
        lambda v: hit(cut_deg, v, physics).speed - object_speed,
        object_speed, 3 * object_speed, width=1e-6,
    )  # fmt: skip
    return throw(cut_deg, speed, physics)


def points(choice: Choice) -> list[Point]:
    """The readings of 2014 and 2006, and the slow throw at 45° by surface."""
    late, early, surface = (MEASURED[f"throw_{k}"] for k in ("2014", "2006", "surface"))
    dirty, used = choice.physics(DIRTY), choice.physics(PRESET)
    found = [
        Point(f"2014, 30°, {v} ft/s", angle, late["tolerance"],
              throw_at(late["cut_deg"], v * FOOT, dirty))
        for v, angle in zip(late["object_speed_ft_s"], late["throw_deg"], strict=True)
    ]  # fmt: skip
    found += [
        Point(f"2006, {cut}°, {name}", angle, early["tolerance"], throw(cut, speed, used))
        for name, speed in early["speed_m_s"].items()
        for cut, angle in zip(early["cut_deg"], early["throw_deg"][name], strict=True)
    ]
    found += [
        Point(f"45°, slow, {name}", surface["throw_deg"][name], surface["tolerance"],
              throw(surface["cut_deg"], surface["speed_m_s"], choice.physics(preset)))
        for name, preset in SURFACES.items()
    ]  # fmt: skip
    return found


def figure(before: Choice | None, after: Choice) -> Figure:
    """Throw against speed at 30°, and against the cut at three speeds."""
    fig, (left, right) = plot.panels(2)
    data = MEASURED["throw_2014"]
    speeds = np.linspace(2.0, 11.5, 40)

    def slowing(physics: Physics) -> list[float]:
        return [throw_at(30.0, v * FOOT, physics) for v in speeds]

    lines(left, speeds, slowing, DIRTY, (None, after), "dirty balls")
    lines(left, speeds, slowing, PRESET, (before, after), "used balls", 2)
    rings(left, data["object_speed_ft_s"], data["throw_deg"], data["tolerance"], "test of 2014")
    plot.name(left, "object ball, ft/s", "throw, °", "Cut 30°, stun")

    data = MEASURED["throw_2006"]
    cuts = np.linspace(2.0, 75.0, 40)
    for k, (name, speed) in enumerate(data["speed_m_s"].items()):

        def curve(physics: Physics, speed: float = speed) -> list[float]:
            return [throw(c, speed, physics) for c in cuts]

        lines(right, cuts, curve, PRESET, (before, after), name, k)
        rings(right, data["cut_deg"], data["throw_deg"][name], data["tolerance"],
              f"{name}, test of 2006", k)  # fmt: skip
    data = MEASURED["throw_surface"]
    for name, angle in data["throw_deg"].items():
        right.plot([data["cut_deg"]], [angle], "x", color="0.3", markersize=5)
        right.annotate(name, (data["cut_deg"] + 1.5, angle), fontsize=6, va="center")
    # Room for the legend above the curves.
    right.set_ylim(0.0, 15.0)
    plot.name(right, "cut, °", "throw, °", "Stun; crosses: slow, by surface")
    return fig


ITEM = Item(
    "throw", "Throw", "°", ("throw_2014", "throw_2006", "throw_surface"),
    "pool, pool-dirty-balls, pool-clean-balls", points, figure,
)  # fmt: skip
