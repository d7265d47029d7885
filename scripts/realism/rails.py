"""What rails return: perpendicular hits against speed, and fast banks."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import INCH, MPH, ball, crossing, simulate

from realism.item import MEASURED, Choice, Item, Physics, Point, lines, rings

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure

#: Tables: width and length of the playing area, m, and the radius of the preset's balls, m.
SIZES = {
    "wpa-9ft": (1.27, 2.54, 0.028575),
    "showood-7ft": (0.9906, 1.9812, 0.028575),
    "snooker-12ft": (1.778, 3.569, 0.02625),
    "carom-10ft": (1.42, 2.84, 0.03075),
}
#: Distance of the sights behind the nose line (WPA), m.
SIGHT = 3.6875 * INCH


def share(table: str, speed: float, physics: Physics, *, rolls: bool = False) -> float:
    """Share of the speed that the top rail returns to a rolling ball, at right angles.

    `speed` is that at the rail, m/s. The share is that just after the rail, or that when the ball
    `rolls` again: it leaves the rail with spin against its motion and loses speed while it slides.
    """
    width, length, radius = SIZES[table]
    # Between a side pocket and a corner, if there are any; near the rail, so that it hardly slows.
    start = (0.4 * width, length - 0.1)
    run = simulate(
        ball("cue", start, (0.0, speed, 0.0), (-speed / radius, 0.0, 0.0), radius=radius),
        physics=physics,
        table=table,
    )
    event = run.first("rail-collision")
    after = event.after["cue"]
    before = event.before["cue"].speed
    if rolls:
        # The slip u = v_y + Rω_x takes 2/7 of itself from the speed until it has ended, however
        # far away that is (Leckie & Greenspan 2005).
        along, spin = float(after.velocity[1]), float(after.spin[0])
        return abs(along - 2.0 / 7.0 * (along + radius * spin)) / before
    return after.speed / before


def return_points(choice: Choice) -> list[Point]:
    """The filmed returns of a snooker table."""
    physics = choice.physics("snooker")
    data = MEASURED["rail_snooker"]
    return [
        Point(f"{v} m/s", float(np.polyval(data["polynomial"], v)), data["tolerance"],
              v * share("snooker-12ft", v, physics))
        for v in data["speed_m_s"]
    ]  # fmt: skip


def carom_points(choice: Choice) -> list[Point]:
    """Han's fit, and the band of the tracked match, for carom tables."""
    physics = choice.physics("carom")
    han, tracked = MEASURED["rail_carom_han"], MEASURED["rail_carom_tracked"]
    found = [
        Point(f"Han 2005, {v} m/s", float(np.polyval(han["polynomial"], v)), han["tolerance"],
              share("carom-10ft", v, physics))
        for v in han["speed_m_s"]
    ]  # fmt: skip
    low, high = tracked["range"]
    return found + [
        Point(f"tracked match, {v} m/s", (low + high) / 2, (high - low) / 2,
              share("carom-10ft", v, physics, rolls=True))
        for v in tracked["speed_m_s"]
    ]  # fmt: skip


def return_figure(before: Choice | None, after: Choice) -> Figure:
    """Shares that the rails of snooker, pool and carom tables return."""
    fig, (left, right) = plot.panels(2)
    speeds = np.linspace(0.3, 8.0, 45)

    def curve(table: str) -> Callable[[Physics], list[float]]:
        return lambda physics: [share(table, float(v), physics) for v in speeds]

    lines(left, speeds, curve("snooker-12ft"), "snooker", (before, after), "snooker")
    lines(left, speeds, curve("wpa-9ft"), "pool", (before, after), "pool", 2)
    data = MEASURED["rail_snooker"]
    filmed = np.array(data["speed_m_s"])
    rings(
        left, filmed, np.polyval(data["polynomial"], filmed) / filmed, data["tolerance"] / filmed,
        "snooker, filmed",
    )  # fmt: skip
    plot.name(left, "speed at the rail, m/s", "share returned", "Rolling, at right angles")

    lines(right, speeds, curve("carom-10ft"), "carom", (before, after), "after the rail")
    lines(
        right, speeds,
        lambda p: [share("carom-10ft", float(v), p, rolls=True) for v in speeds], "carom",
        (before, after), "when it rolls", 4,
    )  # fmt: skip
    data = MEASURED["rail_carom_han"]
    fitted = np.linspace(0.5, 3.0, 30)
    right.plot(fitted, np.polyval(data["polynomial"], fitted), ":", color="0.35", label="Han 2005")
    data = MEASURED["rail_carom_tracked"]
    right.fill_between(
        data["speed_m_s"], *data["range"], color=plot.COLORS[4], alpha=0.35, linewidth=0,
        label="tracked match",
    )  # fmt: skip
    plot.name(right, "speed at the rail, m/s", "share returned", "Carom, rolling")
    for ax in (left, right):
        # Room for the legend above the curves.
        ax.set_ylim(0.3, 1.3)
    return fig


def arrival(start: float, aim: float, table: str, physics: Physics) -> float:
    """Where a fast stun bank arrives, in diamonds along the rail that it started from (TP B.28).

    The ball moves at 12 mph from the sight `start` on the left rail towards the sight `aim` on the
    right rail, both counted from the corner, and meets the rail sliding. The result is the point
    at which its line after the rail crosses the left line of sights.
    """
    width, length, _ = SIZES[table]
    diamond, speed = length / 8, 12 * MPH
    direction = math.atan2((aim - start) * diamond, width + 2 * SIGHT)
    x = width - 0.05
    y = start * diamond + (x + SIGHT) * math.tan(direction)
    run = simulate(
        ball("cue", (x, y), (speed * math.cos(direction), speed * math.sin(direction), 0.0)),
        physics=physics,
        table=table,
    )
    after = run.first("rail-collision").after["cue"]
    slope = float(after.velocity[1] / -after.velocity[0])
    return (float(after.position[1]) + slope * (float(after.position[0]) + SIGHT)) / diamond


def bank(aim: float, table: str, physics: Physics) -> float:
    """The sight from which a bank towards the sight `aim` arrives at the corner."""
    return crossing(lambda start: arrival(start, aim, table, physics), aim, 9.5, width=1e-6)


#: The tables of TP B.28: ours of that size, and the preset with their rails.
BANKED = {
    "Olhausen 9 ft": ("wpa-9ft", "pool"),
    "Gold Crown 9 ft": ("wpa-9ft", "pool-gold-crown"),
    "Valley 7 ft": ("showood-7ft", "pool-valley"),
}


def bank_points(choice: Choice) -> list[Point]:
    """The banks of three tables."""
    data = MEASURED["banks"]
    return [
        Point(f"{name}, aim {aim:g}", start, data["tolerance"],
              bank(aim, table, choice.physics(preset)))
        for name, (table, preset) in BANKED.items()
        for aim, start in zip(data["aim"], data["start"][name], strict=True)
    ]  # fmt: skip


def bank_figure(before: Choice | None, after: Choice) -> Figure:
    """Start against aim for banks into the corner."""
    fig, panels = plot.panels(3)
    data = MEASURED["banks"]
    aims = np.linspace(0.4, 3.0, 14)
    for ax, (name, (table, preset)) in zip(panels, BANKED.items(), strict=True):

        def curve(physics: Physics, table: str = table) -> list[float]:
            return [bank(float(aim), table, physics) for aim in aims]

        lines(ax, aims, curve, preset, (before, after))
        rings(ax, data["aim"], data["start"][name], data["tolerance"], "measured (TP B.28)")
        plot.name(ax, "aim, diamonds", "start, diamonds", f"{name}: {preset}")
    return fig


RETURNS = Item(
    "returns", "Perpendicular returns, snooker", "m/s", ("rail_snooker",), "snooker",
    return_points, return_figure,
)  # fmt: skip
CAROM_RETURNS = Item(
    "carom-returns", "Perpendicular returns, carom", "–",
    ("rail_carom_han", "rail_carom_tracked"), "carom", carom_points, return_figure,
)  # fmt: skip
BANKS = Item(
    "banks", "Fast banks", "diamonds", ("banks",), "pool, pool-gold-crown, pool-valley",
    bank_points, bank_figure,
)  # fmt: skip
