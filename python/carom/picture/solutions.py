"""The picture of solutions: the best ways on the table, each with its chance."""

from __future__ import annotations

import math
from textwrap import wrap
from typing import TYPE_CHECKING

from carom.picture import colors
from carom.picture._matplotlib import as_written
from carom.picture.canvas import to_png, to_svg
from carom.picture.sheet import MARGIN_INCHES, sheet

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from carom.picture.paths import Route
    from carom.plan import Chance
    from carom.shot import Shot
    from carom.solve import Solution

# Ways that are drawn; with more of them the lines cannot be told apart.
SHOWN = 6
# One colour for each, the best first: apart from each other and from the cloth.
PAINT = ("#ffd23f", "#7fb2ff", "#ff7d6b", "#c9f26b", "#e0a3ff", "#8fe3e8")
# Room that a chance takes on the table, points.
LABEL_POINTS = (31.0, 10.0)
# Letters in a line of the panel.
LINE = 52
# Width of the panel beside the table, and height of one entry in it, inches.
PANEL_INCHES = 3.5
ENTRY_INCHES = 1.02


def draw(
    shot: Shot,
    solutions: Sequence[Solution],
    *,
    leave: tuple[Sequence[float], float] | None = None,
    title: str | None = None,
) -> Figure:
    """Draw the best ways of ``Shot.solve``.

    Args:
        shot: The shot that was asked.
        solutions: What ``shot.solve`` found; the first six are drawn.
        leave: The disc in which the cue ball was to be left, as ``solve`` takes it.
        title: Heading of the panel; the table's name without it.

    Returns:
        A matplotlib figure, not attached to any window.

    Raises:
        InputError: The cloth has no edges, so there is no table to draw.
    """
    figure, ax = sheet(shot, PANEL_INCHES)
    if leave is not None:
        _draw_area(ax, leave)
    shown = list(solutions[:SHOWN])
    labels = _Labels(ax)
    for index, solution in enumerate(shown):
        _draw_way(ax, solution, index, labels)
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
    """The picture as a PNG file's content."""
    return to_png(draw(shot, solutions, leave=leave, title=title))


def _draw_area(ax: Axes, leave: tuple[Sequence[float], float]) -> None:
    from matplotlib.patches import Circle

    (x, y), radius = leave
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


def _draw_way(ax: Axes, solution: Solution, index: int, labels: _Labels) -> None:
    """The cue ball's path is solid, those of the balls that it sends off dashed; flights dotted."""
    from carom.picture.paths import routes, starts

    trace = solution.shot.simulate()
    struck = trace.to_dict()["events"][0]["balls"][0]
    for route in routes(trace.to_dict(), starts(trace)):
        if route.legs:
            _draw_route(ax, route, index, own=route.id == struck)
        if route.id == struck:
            _draw_end(ax, route, index)
            labels.put(f"{index + 1}: {_percent(solution.chance)}", route.end, index)


def _draw_route(ax: Axes, route: Route, index: int, *, own: bool) -> None:
    from matplotlib.patches import PathPatch

    from carom.picture.balls import DOTTED, curve

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
    from matplotlib.patches import Circle

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
    """In whole per cent, but never certain or impossible if it is not."""
    if chance.count == chance.trials or not chance.count:
        return f"{100 * float(chance):.0f} %"
    share = 100 * float(chance)
    return ">99 %" if share > 99 else "<1 %" if share < 1 else f"{share:.0f} %"


class _Labels:
    """Chances beside the places where the cue ball ends, none upon another."""

    def __init__(self, ax: Axes) -> None:
        from carom.picture.balls import points_per_metre

        self.ax = ax
        self.scale = points_per_metre(ax)
        self.taken: list[tuple[float, float]] = []

    def put(self, text: str, place: tuple[float, float], index: int) -> None:
        """One label, at the nearest place that is free."""
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
    from carom.picture.balls import draw_ball

    for index, ball in enumerate(shot.to_dict()["balls"]):
        x, y, *_ = ball["position"]
        style = colors.look(ball["id"], index)
        draw_ball(ax, (x, y), float(shot.radius[index]), style, gid=f"ball-{ball['id']}")


def _draw_list(figure: Figure, shown: list[Solution], title: str) -> None:
    from matplotlib.patches import Circle

    from carom.solve import signed

    wide, tall = figure.get_size_inches()
    panel = figure.add_axes((1 - PANEL_INCHES / wide, 0, PANEL_INCHES / wide, 1))
    panel.set_xlim(0, PANEL_INCHES)
    panel.set_ylim(0, tall)
    panel.set_aspect("equal")
    panel.set_axis_off()
    top = tall - MARGIN_INCHES
    panel.text(0.1, top, title, fontsize=12, fontweight="bold", color=colors.INK, va="top")
    said = "solid: the cue ball · dashed: what it sends off · dotted: in the air"
    said += "\nside, height: in ball radii"
    said = said if shown else "no strike was found"
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
            *wrap(f"{solution.kind}: {solution.way}" if solution.way else solution.kind, LINE),
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
