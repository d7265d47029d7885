"""The panel beside the table: title, one line for each ball, and the legend of the marks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from matplotlib.patches import Circle, PathPatch

from carom.picture import colors
from carom.picture.balls import DOTTED, MARKS, curve, draw_ball
from carom.picture.colors import look

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.picture.paths import Route


class Panel:
    """Writes lines from top to bottom; lengths in points, positions in m."""

    def __init__(self, ax: Axes, left: float, top: float, metres_per_point: float) -> None:
        self.ax = ax
        self.left = left
        self.y = top
        self.point = metres_per_point

    def write(self, text: str, size: float, *, indent: float = 0.0, **style: Any) -> None:
        """Write one line; the next one goes below it."""
        self.y -= 1.45 * size * self.point
        self.ax.text(
            self.left + indent * self.point,
            self.y,
            text,
            fontsize=size,
            va="baseline",
            **{"color": colors.INK, **style},
        )

    def skip(self, points: float) -> None:
        """Leave space."""
        self.y -= points * self.point


def draw_panel(
    panel: Panel,
    title: str,
    trace: dict[str, Any],
    routes: list[Route],
    seen: set[str],
    *,
    flew: bool,
) -> None:
    """Fill the panel."""
    panel.write(title, 15, fontweight="bold")
    panel.skip(2)
    count = len(trace["events"])
    panel.write(
        f"{trace['duration']:.3f} s · {count} event{'s' * (count != 1)}",
        8.5,
        color=colors.FAINT_INK,
    )
    panel.write(f"hash {trace['hash']}", 8.5, color=colors.FAINT_INK)
    panel.skip(10)
    # Lower lines for many balls, such as snooker's 22, so that all of them fit.
    row = min(17.0, 300.0 / max(1, len(routes)))
    _balls(panel, trace, routes, row)
    panel.skip(12)
    for kind, (marker, size, filled, text) in MARKS.items():
        if kind in seen:
            _legend_of_mark(panel, marker, size, filled, text)
    if flew:
        _flight(panel)
    panel.skip(17)
    panel.ax.add_patch(_ring(panel))
    _explain(panel, "start")
    panel.skip(14)
    panel.write(trace["engine"], 7, color=colors.FAINT_INK)


def _balls(panel: Panel, trace: dict[str, Any], routes: list[Route], row: float) -> None:
    fallen = {
        event["balls"][0]: (event["pocket"], event["time"])
        for event in trace["events"]
        if event["type"] == "pocket-collision"
    }
    radius = 0.36 * row * panel.point
    size = min(8.5, 0.56 * row)
    # The shot's order is that of a shuffled rack; the list is sorted.
    for index, route in sorted(enumerate(routes), key=lambda item: _natural(item[1].id)):
        panel.skip(row)
        style = look(route.id, index)
        draw_ball(panel.ax, (panel.left + 6 * panel.point, panel.y), radius, style)
        panel.ax.plot(
            [panel.left + 15 * panel.point, panel.left + 31 * panel.point],
            [panel.y, panel.y],
            color=style.path if style.path != "#ffffff" else "#c9c4b4",
            linewidth=1.6,
            linestyle=(0, (3, 1)) if style.striped else "solid",
            solid_capstyle="round",
        )
        cells = [(37, route.id, "left"), (104, f"{route.length:.2f} m", "right")]
        if route.id in fallen:
            pocket, time = fallen[route.id]
            cells.append((112, f"{pocket} at {time:.2f} s", "left"))
        elif route.fate == "off-table":
            cells.append((112, "off the table", "left"))
        elif not route.legs:
            cells[1] = (104, "–", "right")
        for offset, text, align in cells:
            panel.ax.text(
                panel.left + offset * panel.point,
                panel.y,
                text,
                fontsize=size,
                va="center",
                ha=align,
                color=colors.INK,
            )


def _natural(ball_id: str) -> tuple[bool, int]:
    """Sort key: names in their order first, then numbers by value."""
    return (ball_id.isdecimal(), int(ball_id) if ball_id.isdecimal() else 0)


def _legend_of_mark(panel: Panel, marker: str, size: float, filled: bool, text: str) -> None:
    panel.skip(14)
    panel.ax.plot(
        [panel.left + 6 * panel.point],
        [panel.y],
        marker=marker,
        markersize=1.25 * size,
        markerfacecolor=colors.IVORY if filled else "none",
        markeredgecolor=colors.INK,
        markeredgewidth=1.2 if marker == "x" else 0.7,
        linestyle="none",
    )
    _explain(panel, text)


def _explain(panel: Panel, text: str) -> None:
    panel.ax.text(
        panel.left + 17 * panel.point,
        panel.y,
        text,
        fontsize=8,
        va="center",
        color=colors.INK,
    )


def _flight(panel: Panel) -> None:
    """The legend of a path in the air."""
    panel.skip(14)
    left, middle, right = (panel.left + offset * panel.point for offset in (0, 6, 12))
    path, low = panel.y + 2 * panel.point, panel.y - 5 * panel.point
    panel.ax.add_patch(
        PathPatch(
            curve([((left, path), (middle, low), (right, path))]),
            facecolor="none",
            edgecolor="#000000",
            alpha=0.3,
            linewidth=2.2,
            capstyle="round",
        )
    )
    panel.ax.plot(
        [left, right], [path, path], color=colors.INK, lw=1.7, ls=DOTTED, dash_capstyle="round"
    )
    _explain(panel, "in the air, and its shadow")


def _ring(panel: Panel) -> Any:
    return Circle(
        (panel.left + 6 * panel.point, panel.y),
        4.2 * panel.point,
        facecolor="none",
        edgecolor=colors.INK,
        linewidth=0.9,
    )
