"""Diamond systems of two and three rails: where a ball with running English arrives.

The ball rolls with sidespin along the line through two sights. Players allow for squirt and swerve
when they aim, so the cue takes no part here. The rows of validation/diamond_systems strike the
ball.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.diamond_systems.rows import (
    TABLES,
    Line,
    corner_five_line,
    diamond,
    heading,
    plus_line,
)
from carom.validation.lab import ball, simulate

from realism.item import MEASURED, Choice, Item, Physics, Point, lines, rings

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

#: Speed at the start, m/s: "medium".
SPEED = 2.5
#: Sidespin Rω_z/v, 5/2 of the tip's offset in radii: running English for the corner five, one tip
#: for the plus system. The sources give no numbers.
RUNNING, ONE_TIP = 0.75, 0.5


def third_rail(game: str, line: Line, spin: float, physics: Physics) -> float:
    """Where a ball heads on the left line of sights after two rails, in diamonds from the bottom.

    `line` has two points, in diamonds from the nose lines and, at a rail, on its line of sights.
    """
    table, radius = TABLES[game].table, TABLES[game].radius
    (x, y), (to_x, to_y) = line
    way = np.array([to_x - x, to_y - y])
    way /= np.linalg.norm(way)
    # It starts on the line, well inside the table.
    at = np.array([x, y]) * diamond(game) + way * (0.3 / abs(way[0]))
    velocity = (*(SPEED * way), 0.0)
    rotation = (-velocity[1] / radius, velocity[0] / radius, spin * SPEED / radius)
    run = simulate(ball("cue", at, velocity, rotation, radius=radius), physics=physics, table=table)
    return heading(run, game)


def corner_five(
    game: str, start: float, first: float, physics: Physics, spin: float = RUNNING
) -> float:
    """The third rail's number of a ball from the `start` to the `first` rail's number (TP 7.2)."""
    return third_rail(game, corner_five_line(game, start, first), spin, physics)


def plus(game: str, start: float, short: float, physics: Physics, spin: float = ONE_TIP) -> float:
    """Where a ball arrives on the long rail from which it started, by two rails (plus system).

    `short` is the number on the short rail: 3, 5 and 7 at its diamonds, the lowest farthest away.
    """
    return third_rail(game, plus_line(game, start, short), -spin, physics)


def corner_points(game: str) -> list[tuple[str, float, float, float]]:
    """The label, start, first rail and third rail of each published combination."""
    data = MEASURED["corner_five"]
    return [
        (f"{game}, {start:g} − {first:g}", start, first, start - first)
        for start, first in zip(data["start"], data["first_rail"], strict=True)
    ]


def corner_five_points(game: str, choice: Choice) -> list[Point]:
    """The combinations of the corner-five system."""
    physics = choice.physics(game)
    tolerance = MEASURED["corner_five"]["tolerance"]
    return [
        Point(label, third, tolerance, corner_five(game, start, first, physics))
        for label, start, first, third in corner_points(game)
    ]


def plus_points(choice: Choice) -> list[Point]:
    """The combinations of the plus system, on a pool table."""
    physics = choice.physics("pool")
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
    lambda choice: corner_five_points("carom", choice), corner_figure,
)  # fmt: skip
CORNER_POOL = Item(
    "corner-five-pool", "Corner five, pool table", "diamonds", ("corner_five",), "pool",
    lambda choice: corner_five_points("pool", choice), corner_figure,
)  # fmt: skip
PLUS = Item(
    "plus-system", "Plus system, two rails", "diamonds", ("plus_two",), "pool", plus_points,
    corner_figure,
)  # fmt: skip
