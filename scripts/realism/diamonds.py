"""Diamond systems of two and three rails: where a ball with running English arrives.

The ball rolls with sidespin along the line through two sights. Players allow for squirt and swerve
when they aim, so the cue takes no part. The pool table has no pockets here, because a system also
counts diamonds at pockets.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.lab import JSON, ball, simulate

from realism.item import MEASURED, Choice, Item, Physics, Point, lines, rings
from realism.rails import SIGHT, SIZES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

#: Tables of the systems: the rectangle of a 9-ft table, and a carom table.
TABLES: dict[str, tuple[str, JSON | str]] = {
    "pool": ("wpa-9ft", {"length": 2.54, "width": 1.27, "pockets": "none"}),
    "carom": ("carom-10ft", "carom-10ft"),
}
#: Speed at the start, m/s: "medium".
SPEED = 2.5
#: Sidespin Rω_z/v, 5/2 of the tip's offset in radii: running English for the corner five, one tip
#: for the plus system. The sources give no numbers.
RUNNING, ONE_TIP = 0.75, 0.5


def third_rail(
    game: str, line: tuple[tuple[float, float], tuple[float, float]], spin: float, physics: Physics
) -> float:
    """Where a ball heads on the left line of sights after two rails, in diamonds from the bottom.

    `line` has two points, in diamonds from the nose lines and, at a rail, on its line of sights.
    If it meets the top rail first, its line is extended. NaN if it stops before, or does not move
    to the left.
    """
    name, table = TABLES[game]
    _, length, radius = SIZES[name]
    diamond = length / 8
    (x, y), (to_x, to_y) = line
    way = np.array([to_x - x, to_y - y])
    way /= np.linalg.norm(way)
    # It starts on the line, well inside the table.
    at = np.array([x, y]) * diamond + way * (0.3 / abs(way[0]))
    velocity = (*(SPEED * way), 0.0)
    rotation = (-velocity[1] / radius, velocity[0] / radius, spin * SPEED / radius)
    run = simulate(ball("cue", at, velocity, rotation, radius=radius), physics=physics, table=table)
    hits = list(run.all("rail-collision"))[:3]
    if len(hits) < 3 or hits[2].before["cue"].velocity[0] >= 0.0:
        return math.nan
    before = hits[2].before["cue"]
    slope = before.velocity[1] / -before.velocity[0]
    return float(before.position[1] + slope * (before.position[0] + SIGHT)) / diamond


def corner_five(
    game: str, start: float, first: float, physics: Physics, spin: float = RUNNING
) -> float:
    """The third rail's number of a ball from the `start` to the `first` rail's number (TP 7.2)."""
    width, length, _ = SIZES[TABLES[game][0]]
    diamond = length / 8
    behind = SIGHT / diamond
    # 5 is the top left corner; along the long rail each diamond is half a number.
    origin = (-behind, 8.0 - 2.0 * (5.0 - start))
    return third_rail(game, (origin, (width / diamond + behind, first)), spin, physics)


def plus(game: str, start: float, short: float, physics: Physics, spin: float = ONE_TIP) -> float:
    """Where a ball arrives on the long rail from which it started, by two rails (plus system).

    `short` is the number on the short rail: 3, 5 and 7 at its diamonds, the lowest farthest away.
    """
    _, length, _ = SIZES[TABLES[game][0]]
    behind = SIGHT / (length / 8)
    line = ((-behind, start), ((9.0 - short) / 2.0, -behind))
    return third_rail(game, line, -spin, physics)


def corner_points(game: str) -> list[tuple[str, float, float, float]]:
    """The label, start, first rail and third rail of each published combination."""
    data = MEASURED["corner_five"]
    return [
        (f"{game}, {start:g} − {first:g}", start, first, start - first)
        for start, first in zip(data["start"], data["first_rail"], strict=True)
    ]


def corner_five_points(game: str, physics: Physics) -> list[Point]:
    """The combinations of the corner-five system."""
    tolerance = MEASURED["corner_five"]["tolerance"]
    return [
        Point(label, third, tolerance, corner_five(game, start, first, physics))
        for label, start, first, third in corner_points(game)
    ]


def plus_points(physics: Physics) -> list[Point]:
    """The combinations of the plus system, on a pool table."""
    data = MEASURED["plus_two"]
    return [
        Point(f"{start:g} + {short:g}", start + short, data["tolerance"],
              plus("pool", start, short, physics))
        for start, short in zip(data["start"], data["short_rail"], strict=True)
    ]  # fmt: skip


def corner_figure(before: Choice | None, after: Choice) -> Figure:
    """Third rail against first rail from the corner, on both tables, and the plus system."""
    fig, (left, middle, right) = plot.panels(3)
    firsts = np.linspace(0.8, 4.2, 24)
    for ax, game in ((left, "carom"), (middle, "pool")):

        def curve(physics: Physics, spin: float = RUNNING, game: str = game) -> list[float]:
            return [corner_five(game, 5.0, float(f), physics, spin) for f in firsts]

        band: Sequence[list[float]] = [
            curve(after.physics(game), spin) for spin in (0.5 * RUNNING, 1.5 * RUNNING)
        ]
        ax.fill_between(firsts, *band, color=plot.COLORS[0], alpha=0.15, linewidth=0,
                        label="half and 1½ times the spin")  # fmt: skip
        lines(ax, firsts, curve, game, (before, after))
        rings(ax, [1, 2, 3, 4], [4, 3, 2, 1], MEASURED["corner_five"]["tolerance"], "5 − first")
        plot.name(ax, "first rail", "third rail", f"Corner five, {game}")

    data = MEASURED["plus_two"]
    shorts = np.linspace(2.5, 5.5, 20)
    for k, start in enumerate(sorted(set(data["start"]))):

        def bounce(physics: Physics, start: float = start) -> list[float]:
            return [plus("pool", start, float(n), physics) for n in shorts]

        lines(right, shorts, bounce, "pool", (before, after), f"from {start:g}", (0, 2)[k])
        numbers = np.array([3.0, 4.0, 5.0])
        rings(right, numbers, start + numbers, data["tolerance"], f"{start:g} + number", (0, 2)[k])
    plot.name(right, "number on the short rail", "arrival, diamonds", "Plus system, pool")
    return fig


CORNER_CAROM = Item(
    "corner-five-carom", "Corner five, carom table", "diamonds", ("corner_five",), "carom",
    lambda physics: corner_five_points("carom", physics), corner_figure,
)  # fmt: skip
CORNER_POOL = Item(
    "corner-five-pool", "Corner five, pool table", "diamonds", ("corner_five",), "pool",
    lambda physics: corner_five_points("pool", physics), corner_figure,
)  # fmt: skip
PLUS = Item(
    "plus-system", "Plus system, two rails", "diamonds", ("plus_two",), "pool", plus_points,
    corner_figure,
)  # fmt: skip
