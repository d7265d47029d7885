"""Balls, their paths, and marks where something happened."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Circle, PathPatch, Polygon, Rectangle
from matplotlib.path import Path
from matplotlib.patheffects import Normal, Stroke

from carom.picture import colors
from carom.picture.colors import Look, look

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.picture.paths import Point, Route

# How each kind of event is marked: matplotlib's marker, its size in points, filled or not, and
# what the key says.
MARKS = {
    "ball-collision": ("o", 3.4, True, "balls collide"),
    "rail-collision": ("D", 3.2, True, "ball meets cushion"),
    "motion-transition": ("o", 2.6, False, "sliding becomes rolling"),
    "pocket-collision": ("x", 4.2, True, "ball falls"),
}


# The cue as drawn: tip, ferrule, shaft; where each begins and ends behind the ball's centre, in
# ball radii.
CUE_PIECES = (
    (1.35, 1.6, colors.TIP),
    (1.6, 2.1, colors.IVORY),
    (2.1, 11.0, colors.SHAFT),
)
# Height of a ball's number, as a share of its radius.
LABEL_SHARE = 0.72


def points_per_metre(ax: Axes) -> float:
    """How large a metre is drawn, typographic points."""
    box = ax.get_window_extent()
    bottom, top = ax.get_ylim()
    return 72 * box.height / ax.figure.dpi / (top - bottom)


def draw_paths(ax: Axes, routes: list[Route]) -> None:
    """Every ball's path, exact: one quadratic Bézier curve per leg."""
    for index, route in enumerate(routes):
        if not route.legs:
            continue
        vertices: list[Point] = [route.legs[0].start]
        codes = [Path.MOVETO]
        for leg in route.legs:
            vertices += [leg.control, leg.end]
            codes += [Path.CURVE3, Path.CURVE3]
        style = look(route.id, index)
        patch = PathPatch(
            Path(vertices, codes),
            facecolor="none",
            edgecolor=style.path,
            linewidth=1.25,
            linestyle=(0, (5, 1.6)) if style.striped else "solid",
            joinstyle="round",
            capstyle="round",
            zorder=3,
            gid=f"path-{route.id}",
        )
        patch.set_path_effects([Stroke(linewidth=2.3, foreground="#00000038"), Normal()])
        ax.add_patch(patch)


def draw_marks(ax: Axes, events: list[dict[str, Any]], routes: list[Route]) -> set[str]:
    """A small mark at every event, as a rail or pocket or colleague was met.

    Returns:
        The kinds that occurred, for the key.
    """
    by_id = {route.id: (index, route) for index, route in enumerate(routes)}
    seen = set()
    for event in events:
        kind = event["type"]
        if kind not in MARKS or (kind == "motion-transition" and event["to"] != "rolling"):
            continue
        seen.add(kind)
        marker, size, filled, _ = MARKS[kind]
        index, route = by_id[event["balls"][0]]
        color = colors.IVORY if kind == "ball-collision" else look(route.id, index).path
        x, y = _where(event, [by_id[ball][1].radius for ball in event["balls"]])
        ax.plot(
            [x],
            [y],
            marker=marker,
            markersize=size,
            markerfacecolor=color if filled else colors.CLOTH,
            markeredgecolor="#1a1a1a" if filled and marker != "x" else color,
            markeredgewidth=1.1 if marker == "x" else 0.5 if filled else 0.9,
            alpha=0.9,
            zorder=4,
        )
    return seen


def _where(event: dict[str, Any], radii: list[float]) -> Point:
    """The point of contact of two balls; otherwise the centre of the ball (of the group)."""
    points = [state["position"] for state in event["before"]]
    if len(points) == 2:
        share = radii[0] / (radii[0] + radii[1])
        (ax, ay, *_), (bx, by, *_) = points
        return (ax + share * (bx - ax), ay + share * (by - ay))
    return (
        math.fsum(p[0] for p in points) / len(points),
        math.fsum(p[1] for p in points) / len(points),
    )


def draw_balls(ax: Axes, routes: list[Route], smallest: float) -> None:
    """Hollow where a ball started, solid where it ended.

    Args:
        ax: Where to draw, in m.
        routes: The balls.
        smallest: Radius, m, below which a ball is drawn larger than it is, to be seen at all.
    """
    for index, route in enumerate(routes):
        style = look(route.id, index)
        radius = max(route.radius, smallest)
        if route.legs:
            ax.add_patch(
                Circle(
                    route.start,
                    radius,
                    facecolor="#ffffff14",
                    edgecolor=style.path,
                    linewidth=0.9,
                    zorder=2.5,
                    gid=f"start-{route.id}",
                )
            )
        if route.fate not in {"pocketed", "off-table"}:
            draw_ball(ax, route.end, radius, style, gid=f"ball-{route.id}")


def draw_cue(ax: Axes, tip: Point, azimuth: float, radius: float) -> None:
    """The cue's front end, as it meets the ball.

    Args:
        ax: Where to draw, in m.
        tip: Centre of the struck ball, m.
        azimuth: Direction in which the cue moves, rad.
        radius: The ball's radius as drawn, m.
    """
    along, across = (math.cos(azimuth), math.sin(azimuth)), (-math.sin(azimuth), math.cos(azimuth))

    def at(behind: float, aside: float) -> Point:
        return (
            tip[0] - radius * (behind * along[0] - aside * across[0]),
            tip[1] - radius * (behind * along[1] - aside * across[1]),
        )

    for near, far, color in CUE_PIECES:
        thin, thick = _half_width(near), _half_width(far)
        outline = [at(near, -thin), at(near, thin), at(far, thick), at(far, -thick)]
        ax.add_patch(Polygon(outline, facecolor=color, edgecolor="none", zorder=5, gid="cue"))


def _half_width(behind: float) -> float:
    """Half the cue's width, ball radii, so far behind the ball's centre: 13 mm, growing."""
    return 0.22 + 0.008 * behind


def draw_ball(
    ax: Axes, center: Point, radius: float, style: Look, *, gid: str | None = None
) -> None:
    """One ball with its stripe and its number."""
    x, y = center
    rim = Circle(
        center,
        radius,
        facecolor=colors.IVORY if style.striped else style.body,
        edgecolor="#15181a",
        linewidth=0.6,
        zorder=6,
        gid=gid,
    )
    ax.add_patch(rim)
    if style.striped:
        band = Rectangle(
            (x - radius, y - 0.56 * radius), 2 * radius, 1.12 * radius, facecolor=style.body
        )
        band.set_zorder(6.1)
        ax.add_patch(band)
        band.set_clip_path(rim)
    if style.label:
        ax.add_patch(
            Circle(center, 0.5 * radius, facecolor=colors.IVORY, edgecolor="none", zorder=6.2)
        )
        ax.text(
            x,
            y,
            style.label,
            ha="center",
            va="center_baseline",
            fontsize=LABEL_SHARE * radius * points_per_metre(ax),
            fontweight="bold",
            color="#111111",
            zorder=6.3,
        )
