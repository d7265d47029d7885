"""Draws the figures of docs/contact.md into docs/images.

    python scripts/contact_figures.py

Rings are numbers of a source, solid lines the preset `pool`, dashed lines the same preset with the
sequential strike. docs/contact.md explains each figure.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
from carom.validation import plot
from carom.validation.alciatore_tp_collision.rows import FROZEN_ANGLES, FROZEN_CUTS, frozen
from carom.validation.alciatore_tp_flight.rows import coriolis, preset_masse, rise, turn
from carom.validation.alciatore_tp_strike.rows import (
    PRESET_MASS_RATIO,
    ball_speed,
    net_deviation,
    on_a_table,
)
from carom.validation.lab import JSON, Run, ball, degrees_between, simulate
from matplotlib.axes import Axes
from matplotlib.figure import Figure

IMAGES = Path(__file__).resolve().parents[1] / "docs" / "images"
RADIUS = 0.028575
#: The preset with the law before: tip alone, then slate and balls; no loss off the centre.
BEFORE: JSON = {"base": "pool", "cue": {"model": "sequential", "tip_off_centre_loss": 0.0}}


def main() -> int:
    """Draws all figures."""
    figures = {
        "frozen": frozen_cue_ball,
        "masse": masse,
        "off_centre": off_centre,
        "swerve": swerve,
        "networks": networks,
        "times": contact_times,
    }
    for name, draw in figures.items():
        path = IMAGES / f"contact_{name}.png"
        draw().savefig(path, dpi=plot.DPI, metadata={"Software": None})
        print(path, file=sys.stderr)
    return 0


def before(ax: Axes, x: Any, y: Any, label: str = "sequential (before)", color: int = 1) -> None:
    """Draws numbers of the sequential law as a dashed line."""
    ax.plot(x, y, "--", color=plot.COLORS[color], linewidth=1.6, label=label)


def formula(ax: Axes, x: Any, y: Any, label: str) -> None:
    """Draws a formula as a thin dotted line."""
    ax.plot(x, y, ":", color="0.35", linewidth=1.4, label=label)


def frozen_cue_ball() -> Figure:
    """Direction of a frozen cue ball, and of one with a gap."""
    fig, (left, right) = plot.panels(2)
    cuts = np.linspace(2.0, 85.0, 50)
    plot.ours(left, cuts, [frozen(c) for c in cuts], "network")
    before(left, cuts, [frozen(c, model="sequential") for c in cuts])
    theory = np.degrees(np.arctan(2.0 * np.tan(np.radians(cuts))))
    formula(left, cuts, theory, "tan θ = 2 tan φ (TP A.15)")
    plot.published(left, FROZEN_CUTS, FROZEN_ANGLES, "measured (TP A.15)", 6)
    plot.name(left, "aim φ, ° off the line of centres", "cue ball leaves at θ, °", "Frozen")

    gaps = np.linspace(0.0, 3.0, 121)
    for k, speed in enumerate((1.0, 3.0)):
        angles = [with_gap(1e-3 * gap, speed) for gap in gaps]
        plot.ours(right, gaps, angles, f"network, {speed:g} m/s", (0, 2)[k])
    before(right, gaps, [with_gap(1e-3 * gap, 1.0, BEFORE) for gap in gaps])
    plot.published(right, [0.0], [50.0], "measured, frozen", 6)
    right.set_ylim(40.0, 95.0)
    plot.name(right, "gap between the balls, mm", "cue ball leaves at θ, °", "φ = 34°, with a gap")
    return fig


def with_gap(gap: float, speed: float, physics: JSON | str = "pool") -> float:
    """Direction of the cue ball after it has met a ball `gap` m away, ° off the line of centres.

    The aim is 34° off the line of centres at the contact.
    """
    cut = math.radians(34.0)
    across, along = 2.0 * RADIUS * math.sin(cut), 2.0 * RADIUS * math.cos(cut)
    # `gap` is measured along the line of centres at the start.
    ahead = math.sqrt((2.0 * RADIUS + gap) ** 2 - across**2)
    assert ahead >= along
    run = simulate(
        ball(),
        ball("object", (-across, ahead)),
        physics=physics,
        strike={"ball": "cue", "speed": speed, "azimuth_deg": 90.0, "elevation_deg": 0.0},
    )
    impacts = [event for event in run.events if "object" in event.after and "cue" in event.after]
    return degrees_between(math.pi / 2 + cut, impacts[0].after["cue"].heading)


def masse() -> Figure:
    """Height and direction of massés."""
    fig, (left, right) = plot.panels(2)
    elevations = np.linspace(40.0, 84.0, 60)
    plot.ours(left, elevations, [rise(preset_masse(e, 3.0)) for e in elevations], "network")
    before(left, elevations, [rise(preset_masse(e, 3.0, BEFORE)) for e in elevations])
    left.plot([72.0, 78.0], [15.0, 15.0], color=plot.COLORS[6], linewidth=3, label="our bar")
    plot.name(left, "elevation of the cue, °", "height of the hop, mm", "Cue at 3 m/s, tip ¼R, ¼R")

    formula(
        right,
        elevations,
        [coriolis(e, 0.25, -0.25) for e in elevations],
        "without squirt (TP A.19)",
    )
    plot.ours(right, elevations, [turn(preset_masse(e, 3.0)) for e in elevations], "network")
    plot.published(right, [75.0], [87.908], "TP A.19 at 75°", 6)
    plot.name(right, "elevation of the cue, °", "final direction from the aim, °", "Direction")
    return fig


def off_centre() -> Figure:
    """Speed and spin of the ball against the offset of the tip."""
    fig, (left, right) = plot.panels(2)
    offsets = np.linspace(0.0, 0.5, 41)
    after = [struck_off_centre(x, "pool") for x in offsets]
    earlier = [struck_off_centre(x, BEFORE) for x in offsets]
    plot.ours(left, offsets, [v for v, _ in after], "with the loss")
    before(left, offsets, [v for v, _ in earlier], "constant restitution (before)")
    formula(
        left, offsets, [ball_speed(x, 0.87, PRESET_MASS_RATIO) for x in offsets],
        "efficiency 0.87 (TP A.30)",
    )  # fmt: skip
    plot.published(left, [0.5], [0.74628], "TP B.10", 6)
    plot.name(left, "tip offset, R", "ball speed per cue speed", "Speed")

    plot.ours(right, offsets, [w for _, w in after], "with the loss")
    before(right, offsets, [w for _, w in earlier], "constant restitution (before)")
    plot.published(right, [0.5], [2.5 * 0.5 * 0.74628], "TP B.10", 6)
    plot.name(right, "tip offset, R", "Rω per cue speed", "Spin")
    return fig


def struck_off_centre(offset: float, physics: JSON | str) -> tuple[float, float]:
    """Speed and surface speed Rω of a ball per cue speed, cue at 15 mph."""
    speed = 6.7056
    strike = {"ball": "cue", "speed": speed, "azimuth_deg": 90.0, "elevation_deg": 0.0}
    run = simulate(ball(), strike={**strike, "height": -offset}, physics=physics)
    cue = run.first("cue-strike").after["cue"]
    return cue.speed / speed, RADIUS * math.hypot(*cue.spin) / speed


def swerve() -> Figure:
    """Path of a ball with side, and net deviation against the offset."""
    fig, (left, right) = plot.panels(2)
    for label, more, color in (("default, 3°", {}, 0), ("level (before)", LEVEL, 1)):
        run = on_a_table(0.5, side=0.4, **more)
        path = np.array([run.trace.at(t).position[0] for t in np.linspace(0.0, 0.9, 300)])
        style = "-" if not more else "--"
        left.plot(
            path[:, 1] - 0.5, 1000 * (0.635 - path[:, 0]), style, color=plot.COLORS[color],
            linewidth=1.6, label=label,
        )  # fmt: skip
    plot.name(left, "along the aim, m", "left of the aim, mm", "Right English 0.4R, cue at 2 m/s")

    sides = np.linspace(0.0, 0.5, 21)
    runs = [on_a_table(0.9, side=float(s)) for s in sides]
    plot.ours(right, sides, [leftward(run, "cue-strike") for run in runs], "starts")
    plot.ours(right, sides, [leftward(run, "rolling") for run in runs], "rolls, default", 2)
    level = [leftward(on_a_table(0.9, side=float(s), **LEVEL), "rolling") for s in sides]
    before(right, sides, level, "rolls, level (before)")
    few = (0.1, 0.2, 0.3, 0.4, 0.5)
    formulas = np.array([net_deviation(s) for s in few])
    plot.published(right, few, formulas[:, 0], "TP A.31", 0)
    plot.published(right, few, formulas[:, 1], "TP A.31 and A.19", 2)
    plot.name(right, "right English, R", "left of the aim, °", "Direction")
    return fig


LEVEL: dict[str, float] = {"elevation_deg": 0.0}


def leftward(run: Run, when: str) -> float:
    """Direction to the left of the aim, °: at the start, or when the ball rolls."""
    event = run.rolling("cue") if when == "rolling" else run.first(when)
    return degrees_between(event.after["cue"].heading, math.pi / 2)


def networks() -> Figure:
    """Three balls in a row, and a cue ball frozen to a row."""
    fig, (left, right) = plot.panels(2)
    places = np.arange(3)
    left.bar(places - 0.18, row_of_three(), 0.36, color=plot.COLORS[0], label="network")
    left.bar(places + 0.18, [0.0, 0.0, 1.0], 0.36, color=plot.COLORS[1], label="pair by pair")
    plot.published(left, places - 0.18, [-0.071, 0.076, 0.995], "TP B.29", 6)
    left.axhline(0.0, color="0.4", linewidth=0.8)
    left.set_xticks(places, ("first", "second", "third"))
    plot.name(left, "ball of the row", "speed after, m/s", "One ball hits two, 1 m/s, no losses")

    counts = np.arange(0, 5)
    together = [struck_into_row(int(n), "pool") for n in counts]
    earlier = [struck_into_row(int(n), BEFORE) for n in counts]
    right.plot(counts, together, "o-", color=plot.COLORS[0], label="network")
    right.plot(counts, earlier, "o--", color=plot.COLORS[1], label="sequential (before)")
    right.axhline(0.0, color="0.4", linewidth=0.8)
    right.set_xticks(counts)
    plot.name(
        right, "balls in a row that touch the cue ball", "cue ball after the blow, m/s",
        "Struck into a frozen row, cue at 1 m/s",
    )  # fmt: skip
    return fig


def row_of_three() -> list[float]:
    """Speeds of three balls in a row after the first has hit the others at 1 m/s."""
    balls = [
        ball(str(k), (0.0, 2 * RADIUS * k), (0.0, 1.0 if k == 0 else 0.0, 0.0)) for k in range(3)
    ]
    physics = {"base": "ideal", "ball": {"radius": RADIUS}}
    event = simulate(*balls, physics=physics).first("ball-collision")
    return [float(event.after[str(k)].velocity[1]) for k in range(3)]


def struck_into_row(count: int, physics: JSON | str) -> float:
    """Speed of a cue ball after it was struck straight into a row that it touches, m/s."""
    row = [ball(str(k), (0.0, 2 * RADIUS * k)) for k in range(1, count + 1)]
    strike = {"ball": "cue", "speed": 1.0, "azimuth_deg": 90.0, "elevation_deg": 0.0}
    run = simulate(ball(), *row, physics=physics, strike=strike)
    now = [event.after["cue"] for event in run.events if event.time == 0.0 and "cue" in event.after]
    return float(now[-1].velocity[1])


def contact_times() -> Figure:
    """How long contacts last."""
    fig, (ax,) = plot.panels(1)
    fig.set_size_inches(7.0, 2.6)
    spans = {
        "ball and ball": (0.25, 0.30),
        "ball and slate (fit)": (0.48, 0.52),
        "tip, phenolic to leather": (0.8, 1.2),
        "ball and cushion (estimate)": (2.5, 3.0),
    }
    for place, (low, high) in enumerate(spans.values()):
        ax.barh(place, high - low, left=low, height=0.5, color=plot.COLORS[place])
    ax.set_yticks(range(len(spans)), list(spans))
    ax.invert_yaxis()
    ax.set_xlim(0.0, 3.2)
    plot.name(ax, "duration of a contact at 1 m/s, ms", "")
    return fig


if __name__ == "__main__":
    sys.exit(main())
