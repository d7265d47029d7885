"""The picture of solutions: the best shots on the table, each with its probability."""

from __future__ import annotations

import math
from textwrap import wrap
from typing import TYPE_CHECKING

from matplotlib.patches import Circle, PathPatch

from carom.arguments import instance, numbers
from carom.errors import InputError
from carom.picture import colors
from carom.picture.balls import DOTTED, curve, draw_ball, points_per_metre
from carom.picture.output import as_written, to_png, to_svg
from carom.picture.paths import routes, starts
from carom.picture.sheet import MARGIN_INCHES, sheet
from carom.picture.style import own_style
from carom.plan import Solution
from carom.plan.solve import signed
from carom.shot import Shot

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from carom.picture.paths import Route
    from carom.plan import Chance

# Number of solutions that are drawn; more lines would be hard to tell apart.
SHOWN = 6
# Their colours, the best solution first; they differ clearly from each other and from the cloth.
PAINT = ("#ffd23f", "#7fb2ff", "#ff7d6b", "#c9f26b", "#e0a3ff", "#8fe3e8")
# Size of a label on the table, points.
LABEL_POINTS = (31.0, 10.0)
# Letters in a line of the panel.
LINE = 52
# Width of the panel beside the table, and height of one entry in it, inches.
PANEL_INCHES = 3.5
ENTRY_INCHES = 1.02


@own_style()
def draw(
    shot: Shot,
    solutions: Sequence[Solution],
    *,
    leave: tuple[Sequence[float], float] | None = None,
    title: str | None = None,
) -> Figure:
    """Draw the best solutions of ``Shot.solve``.

    Args:
        shot: The shot whose ``solve`` was called.
        solutions: The solutions; the first six are drawn.
        leave: The disc for the cue ball that was passed to ``solve``.
        title: Heading of the panel; None writes the table's name.

    Returns:
        A matplotlib figure, not attached to any window.

    Raises:
        InputError: An argument has a wrong type, or the cloth has no edges.
    """
    instance("shot", shot, Shot, 'Shot.load("shot.json")')
    for solution in solutions:
        instance("solutions", solution, Solution, "those that shot.solve() returned")
    figure, ax = sheet(shot, PANEL_INCHES)
    if leave is not None:
        _draw_area(ax, leave)
    shown = list(solutions[:SHOWN])
    labels = _Labels(ax)
    for index, solution in enumerate(shown):
        _draw_solution(ax, solution, index, labels)
    _draw_balls(ax, shot)
    _draw_list(figure, shown, title or shot.geometry()["name"] or "shot")
    return as_written(figure)


def svg(
    shot: Shot,
    solutions: Sequence[Solution],
    *,
    leave: tuple[Sequence[float], float] | None = None,
    title: str | None = None,
) -> str:
    """The picture as SVG text; the same text for the same solutions."""
    return to_svg(draw(shot, solutions, leave=leave, title=title))


def png(
    shot: Shot,
    solutions: Sequence[Solution],
    *,
    leave: tuple[Sequence[float], float] | None = None,
    title: str | None = None,
) -> bytes:
    """The picture as the content of a PNG file."""
    return to_png(draw(shot, solutions, leave=leave, title=title))


def _draw_area(ax: Axes, leave: tuple[Sequence[float], float]) -> None:
    try:
        place, size = leave
    except (TypeError, ValueError):
        raise InputError(
            "wrong-type",
            "leave",
            f"{leave!r} is not a disc",
            "give ((x, y), radius), such as ((0.6, 0.6), 0.2)",
        ) from None
    x, y, radius = numbers("leave", [*numbers("leave", place, 2), size], 3)
    ax.add_patch(
        Circle(
            (x, y),
            radius,
            facecolor="#ffffff22",
            edgecolor="white",
            linewidth=0.9,
            linestyle=(0, (3, 2)),
            zorder=2.3,
            gid="leave",
        )
    )


def _draw_solution(ax: Axes, solution: Solution, index: int, labels: _Labels) -> None:
    """Draw one solution: the cue ball's path solid, the other balls' dashed, flights dotted."""
    trace = solution.shot.simulate()
    struck = trace.to_dict()["events"][0]["balls"][0]
    for route in routes(trace.to_dict(), starts(trace)):
        if route.legs:
            _draw_route(ax, route, index, own=route.id == struck)
        if route.id == struck:
            _draw_end(ax, route, index)
            labels.put(f"{index + 1}: {_percent(solution.chance)}", route.end, index)


def _draw_route(ax: Axes, route: Route, index: int, *, own: bool) -> None:
    ground, aloft = route.split()
    for what, legs, line in (
        ("way", ground, "solid" if own else (0, (4, 1.8))),
        ("flight", aloft, DOTTED),
    ):
        if not legs:
            continue
        ax.add_patch(
            PathPatch(
                curve([(leg.start, leg.control, leg.end) for leg in legs]),
                facecolor="none",
                edgecolor=PAINT[index],
                linewidth=1.7 if own else 1.1,
                linestyle=line,
                alpha=0.95 if own or route.fate == "pocketed" else 0.45,
                joinstyle="round",
                capstyle="round" if what == "flight" else "butt",
                zorder=3 - 0.01 * index,
                gid=f"{what}-{index + 1}-{route.id}",
            )
        )


def _draw_end(ax: Axes, route: Route, index: int) -> None:
    ax.add_patch(
        Circle(
            route.end,
            route.radius,
            facecolor=PAINT[index],
            edgecolor="#15181a",
            linewidth=0.5,
            zorder=5 - 0.01 * index,
        )
    )


def _percent(chance: Chance) -> str:
    """Whole per cent; 0 % and 100 % only where all variants agree."""
    if chance.count == chance.trials or not chance.count:
        return f"{100 * float(chance):.0f} %"
    share = 100 * float(chance)
    return ">99 %" if share > 99 else "<1 %" if share < 1 else f"{share:.0f} %"


class _Labels:
    """Labels beside the cue ball's final positions that do not overlap."""

    def __init__(self, ax: Axes) -> None:
        self.ax = ax
        self.scale = points_per_metre(ax)
        self.taken: list[tuple[float, float]] = []

    def put(self, text: str, place: tuple[float, float], index: int) -> None:
        """Draw one label at the nearest free place."""
        wide, tall = LABEL_POINTS
        x, y = (self.scale * value for value in place)
        near = [
            (aside, up * tall)
            for up in (0.3, -0.9, 1.5, -2.1, 2.7, -3.3)
            for aside in (5.5, -5.5 - wide)
        ]
        corners = [(x + aside, y + up) for aside, up in near]
        free = (k for k, corner in enumerate(corners) if self._is_free(corner))
        chosen = next(free, 0)
        self.taken.append(corners[chosen])
        self.ax.annotate(
            text,
            place,
            xytext=near[chosen],
            textcoords="offset points",
            fontsize=6.5,
            fontweight="bold",
            color="#15181a",
            zorder=8 - 0.1 * index,
            bbox={"boxstyle": "round,pad=0.18", "facecolor": PAINT[index], "edgecolor": "none"},
            gid=f"chance-{index + 1}",
        )

    def _is_free(self, corner: tuple[float, float]) -> bool:
        wide, tall = LABEL_POINTS
        return all(
            abs(corner[0] - other[0]) >= wide or abs(corner[1] - other[1]) >= tall
            for other in self.taken
        )


def _draw_balls(ax: Axes, shot: Shot) -> None:
    for index, ball in enumerate(shot.to_dict()["balls"]):
        x, y, *_ = ball["position"]
        style = colors.look(ball["id"], index)
        draw_ball(ax, (x, y), float(shot.radius[index]), style, gid=f"ball-{ball['id']}")


def _draw_list(figure: Figure, shown: list[Solution], title: str) -> None:
    wide, tall = figure.get_size_inches()
    panel = figure.add_axes((1 - PANEL_INCHES / wide, 0, PANEL_INCHES / wide, 1))
    panel.set_xlim(0, PANEL_INCHES)
    panel.set_ylim(0, tall)
    panel.set_aspect("equal")
    panel.set_axis_off()
    top = tall - MARGIN_INCHES
    panel.text(0.1, top, title, fontsize=12, fontweight="bold", color=colors.INK, va="top")
    said = "solid: the cue ball · dashed: other balls · dotted: in the air"
    said += "\nside, height: in ball radii"
    said = said if shown else "no solution was found"
    panel.text(0.1, top - 0.32, said, fontsize=7, color=colors.FAINT_INK, va="top")
    for index, solution in enumerate(shown):
        y = top - 0.75 - index * ENTRY_INCHES
        panel.add_patch(
            Circle((0.24, y - 0.1), 0.13, facecolor=PAINT[index], edgecolor=colors.FAINT_INK)
        )
        panel.text(
            0.24, y - 0.1, f"{index + 1}", fontsize=8, ha="center", va="center", fontweight="bold"
        )
        panel.text(
            0.48, y, f"{solution.chance}", fontsize=9, va="top", color=colors.INK, weight="bold"
        )
        raised = math.degrees(solution.elevation)
        lines = (
            *wrap(f"{solution.kind}: {solution.route}" if solution.route else solution.kind, LINE),
            f"{solution.speed:.2f} m/s, azimuth {math.degrees(solution.azimuth) % 360:.1f}°",
            f"side {signed(solution.side)}, height {signed(solution.height)}"
            + (f", elevation {raised:.1f}°" if raised else ""),
        )
        panel.text(
            0.48,
            y - 0.2,
            "\n".join(lines),
            fontsize=7,
            va="top",
            color=colors.INK,
            linespacing=1.35,
        )
