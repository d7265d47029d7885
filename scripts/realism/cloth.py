"""Rolling: the deceleration against the speed, and the turn of a ball with sidespin."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import FOOT, MPH, ball, crossing, degrees_between, simulate

from realism.item import MEASURED, Choice, Item, Physics, Point, lines, rings

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Radii of the presets' balls, m.
RADII = {"pool": 0.028575, "snooker": 0.02625, "carom": 0.03075}
#: Time over which a deceleration is taken, s.
MOMENT = 0.01
#: Spin of the turning ball, Rω_z/v: a tip offset of half a radius. The source gives no number.
SPIN_RATE = 1.25


def deceleration(preset: str, speed: float, physics: Physics) -> float:
    """Deceleration of a ball that rolls at `speed` m/s, m/s²."""
    radius = RADII[preset]
    run = simulate(
        ball("cue", (0.0, 0.0), (0.0, speed, 0.0), (-speed / radius, 0.0, 0.0), radius=radius),
        physics=physics,
    )
    first, last = (float(run.trace.at(t).velocity[0][1]) for t in (0.0, MOMENT))
    return (first - last) / MOMENT


def carom_points(choice: Choice) -> list[Point]:
    """The deceleration on a heated carom table at three speeds."""
    physics = choice.physics("carom")
    data = MEASURED["rolling_carom"]
    return [
        Point(f"{v} m/s", a, data["tolerance"], deceleration("carom", v, physics))
        for v, a in zip(data["speed_m_s"], data["deceleration_m_s2"], strict=True)
    ]


def snooker_points(choice: Choice) -> list[Point]:
    """The deceleration on a snooker table."""
    low, high = MEASURED["rolling_snooker"]["range"]
    ours = deceleration("snooker", 1.0, choice.physics("snooker"))
    return [Point("snooker", (low + high) / 2, (high - low) / 2, ours)]


def rolling_figure(before: Choice | None, after: Choice) -> Figure:
    """Deceleration against speed on the three kinds of tables."""
    fig, (left, right) = plot.panels(2)
    speeds = np.linspace(0.05, 3.0, 120)
    data = MEASURED["rolling_carom"]
    lines(
        left, speeds, lambda p: [deceleration("carom", float(v), p) for v in speeds], "carom",
        (before, after),
    )  # fmt: skip
    base, slope = data["line"]
    left.plot(speeds, base + slope * speeds, ":", color="0.35", label="tracked match, line")
    rings(left, data["speed_m_s"], data["deceleration_m_s2"], data["tolerance"], "tracked match")
    left.set_ylim(0.0, 0.12)
    plot.name(left, "speed, m/s", "deceleration, m/s²", "Heated carom")

    for k, preset in enumerate(("pool", "snooker")):

        def curve(physics: Physics, preset: str = preset) -> list[float]:
            return [deceleration(preset, float(v), physics) for v in speeds]

        lines(right, speeds, curve, preset, (before, after), preset, k)
    low, high = MEASURED["rolling_snooker"]["range"]
    right.axhspan(low, high, color=plot.COLORS[4], alpha=0.5, label="snooker, filmed")
    right.set_ylim(0.0, 0.2)
    plot.name(right, "speed, m/s", "deceleration, m/s²", "Pool and snooker")
    return fig


def turn(physics: Physics, rate: float = SPIN_RATE) -> float:
    """Turn of a rolling ball's path over 8 ft at 2 mph, ° towards the side of its spin.

    `rate` is Rω_z/v at the start.
    """
    data, radius = MEASURED["ball_turn"], RADII["pool"]
    speed, distance = data["speed_mph"] * MPH, data["distance_ft"] * FOOT
    run = simulate(
        ball("cue", (0.0, 0.0), (0.0, speed, 0.0), (-speed / radius, 0.0, rate * speed / radius),
             radius=radius),
        physics=physics,
    )  # fmt: skip

    def beyond(t: float) -> float:
        return float(run.trace.at(t).position[0][1]) - distance

    end = run.record["duration"]
    if beyond(end) < 0.0:
        return math.nan  # It stops before.
    velocity = run.trace.at(crossing(beyond, 0.0, end, width=1e-9)).velocity[0]
    return degrees_between(math.atan2(velocity[1], velocity[0]), math.pi / 2)


def turn_points(choice: Choice) -> list[Point]:
    """The turn of TP B.2."""
    data = MEASURED["ball_turn"]
    return [Point("8 ft at 2 mph", data["turn_deg"], data["tolerance"],
                  turn(choice.physics("pool")))]  # fmt: skip


def turn_figure(before: Choice | None, after: Choice) -> Figure:
    """Turn against the spin."""
    fig, (ax,) = plot.panels(1)
    rates = np.linspace(0.0, 2.0, 21)
    lines(ax, rates, lambda p: [turn(p, float(r)) for r in rates], "pool", (before, after))
    data = MEASURED["ball_turn"]
    ax.axhline(data["turn_deg"], color=plot.COLORS[6], linestyle=":", label="TP B.2 (spin unknown)")
    plot.name(ax, "Rω_z / v at the start", "turn, °", "Rolling ball, 8 ft at 2 mph")
    return fig


CAROM_ROLLING = Item(
    "carom-rolling", "Rolling deceleration, carom", "m/s²", ("rolling_carom",), "carom",
    carom_points, rolling_figure,
)  # fmt: skip
SNOOKER_ROLLING = Item(
    "snooker-rolling", "Rolling deceleration, snooker", "m/s²", ("rolling_snooker",), "snooker",
    snooker_points, rolling_figure,
)  # fmt: skip
TURN = Item("ball-turn", "Ball turn", "°", ("ball_turn",), "pool", turn_points, turn_figure)
