"""Draws the figure of docs/cue-pose.md into docs/images.

    python scripts/cue_pose_figure.py

The ball and the cue are drawn to scale, seen from the side and along the cue's axis, at the pose
that ``Shot.cue_pose`` gives.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import carom
import numpy as np
from carom.validation import plot
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle, Polygon
from numpy.typing import NDArray

PATH = Path(__file__).resolve().parents[1] / "docs" / "images" / "cue_pose.png"
RADIUS = 0.028575
ELEVATION = math.radians(30.0)
SIDE, HEIGHT = 0.35, 0.3
Point = NDArray[np.float64]
# Radius of the tip and of the shaft, m, and the length of the cue that is shown.
TIP, SHAFT, SHOWN = 0.0065, 0.0075, 0.075


def main() -> int:
    """Draws the figure."""
    figure = Figure(figsize=(9.6, 4.4), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1.45, 1))
    from_the_side(left)
    along_the_cue(right)
    figure.savefig(PATH, dpi=plot.DPI, metadata={"Software": None})
    print(PATH, file=sys.stderr)
    return 0


def pose() -> carom.CuePose:
    """The cue that strikes along +x."""
    strike = carom.Strike(2.0, 0.0, ELEVATION, SIDE, HEIGHT)
    return carom.Shot(carom.Table.unbounded(), {"cue": (0.0, 0.0)}, strike).cue_pose()


def arrow(ax: Axes, start: Point, end: Point, text: str, shift: tuple[float, float]) -> None:
    """A named vector; ``shift`` moves the name, m."""
    style = {"arrowstyle": "-|>", "color": "black", "shrinkA": 0, "shrinkB": 0, "linewidth": 1.3}
    ax.annotate("", end, start, arrowprops=style, zorder=5)
    ax.text(*(end + shift), text, ha="center", va="center", fontsize=11, zorder=6)


def from_the_side(ax: Axes) -> None:
    """The vertical plane of the cue: x and z."""
    found = pose()
    tip, forward = (np.array(v)[[0, 2]] for v in (found.tip, found.direction))
    up = np.array([math.sin(ELEVATION), math.cos(ELEVATION)])
    centre = np.array([0.0, RADIUS])
    ax.axhline(0.0, color=plot.COLORS[0], linewidth=3)
    ax.add_patch(Circle(centre, RADIUS, facecolor="0.95", edgecolor="black", linewidth=1.4))
    far = tip - SHOWN * forward
    cue = [tip - TIP * up, tip + TIP * up, far + SHAFT * up, far - SHAFT * up]
    ax.add_patch(Polygon(cue, facecolor="#d9b382", edgecolor="black", linewidth=1.0, zorder=3))
    axis = np.array([centre - 3.3 * RADIUS * forward, centre + 1.25 * RADIUS * forward])
    ax.plot(*axis.T, "--", color="0.4", linewidth=1.0, zorder=4)
    ax.plot(*centre, "o", color="black", markersize=4, zorder=6)
    ax.text(centre[0] + 0.003, centre[1] - 0.006, "C", fontsize=11)
    arrow(ax, centre, centre + HEIGHT * RADIUS * up, "height·R·u", (0.002, 0.006))
    arrow(ax, centre, centre + 1.25 * RADIUS * forward, "d", (0.003, -0.005))
    ax.plot(*tip, "o", color=plot.COLORS[1], markersize=6, zorder=7)
    ax.text(tip[0] - 0.004, tip[1] + 0.014, "tip", color=plot.COLORS[1], fontsize=11, ha="center")
    level = centre - np.array([2.9 * RADIUS, 0.0])
    ax.plot([level[0], centre[0]], [level[1]] * 2, ":", color="0.4", linewidth=1.0)
    degrees = math.degrees(ELEVATION)
    size = 4.6 * RADIUS
    ax.add_patch(Arc((0.0, RADIUS), size, size, theta1=180 - degrees, theta2=180, color="0.3"))
    ax.text(-2.6 * RADIUS, RADIUS + 0.5 * RADIUS, "elevation θ", fontsize=10, ha="center")
    finish(ax, "From the side", (-0.098, 0.045), (-0.006, 0.1))


def along_the_cue(ax: Axes) -> None:
    """What the shooter sees: r to the right and u upwards, from the ball's centre."""
    ax.add_patch(Circle((0, 0), RADIUS, facecolor="0.95", edgecolor="black", linewidth=1.4))
    place = np.array([SIDE, HEIGHT]) * RADIUS
    ax.add_patch(Circle(tuple(place), TIP, facecolor="#d9b382", edgecolor="black", zorder=3))
    arrow(ax, np.zeros(2), np.array([SIDE * RADIUS, 0.0]), "side·R·r", (0.004, -0.005))
    arrow(ax, np.zeros(2), np.array([0.0, HEIGHT * RADIUS]), "height·R·u", (-0.009, 0.004))
    ax.plot([0, place[0]], [place[1]] * 2, ":", color="0.4")
    ax.plot([place[0]] * 2, [0, place[1]], ":", color="0.4")
    ax.plot(*place, "o", color=plot.COLORS[1], markersize=6, zorder=7)
    ax.plot(0, 0, "o", color="black", markersize=4)
    ax.text(-0.004, -0.005, "C", fontsize=11)
    finish(ax, "Along the cue, as the shooter sees it", (-0.036, 0.036), (-0.036, 0.036))


def finish(ax: Axes, title: str, x: tuple[float, float], y: tuple[float, float]) -> None:
    """Equal scales, and no axes."""
    ax.set_xlim(*x)
    ax.set_ylim(*y)
    ax.set_aspect("equal")
    ax.set_title(title, fontsize=11, y=0.95)
    ax.axis("off")


if __name__ == "__main__":
    sys.exit(main())
