"""Balls, their paths, and marks of events."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Circle, PathPatch, Polygon, Rectangle
from matplotlib.path import Path
from matplotlib.patheffects import Normal, Stroke

from carom.flights import runs
from carom.picture import colors
from carom.picture.colors import Look, look
from carom.picture.paths import SEEN

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from carom.picture.paths import Leg, Point, Route

# The mark of each kind of event: Matplotlib's marker, its size in points, whether it is filled, and
# the text of the legend.
MARKS = {
    "ball-collision": ("o", 3.4, True, "balls collide"),
    "rail-collision": ("D", 3.2, True, "ball hits cushion"),
    "motion-transition": ("o", 2.6, False, "sliding becomes rolling"),
    "slate-collision": ("v", 3.6, False, "ball bounces"),
    "pocket-collision": ("x", 4.2, True, "ball is pocketed"),
    "off-table": ("X", 4.6, True, "ball leaves the table"),
}
# Offset of a ball's shadow per metre of height: to the right and down.
SHADOW = (0.55, -0.75)
# Line style of a path in the air; dashes are for striped balls.
DOTTED = (0.0, (0.05, 1.7))


# The drawn cue: begin and end of tip, ferrule and shaft behind the ball's centre, ball radii.
CUE_PIECES = (
    (1.35, 1.6, colors.TIP),
    (1.6, 2.1, colors.IVORY),
    (2.1, 11.0, colors.SHAFT),
)
# Height of a ball's number, as a share of its radius.
LABEL_SHARE = 0.72


def points_per_metre(ax: Axes) -> float:
    """Typographic points per metre of the drawing."""
    box = ax.get_window_extent()
    bottom, top = ax.get_ylim()
    return 72 * box.height / ax.figure.dpi / (top - bottom)


def draw_paths(ax: Axes, routes: list[Route]) -> bool:
    """Draw every ball's exact path: one quadratic Bézier curve per leg.

    A path in the air is dotted, with its shadow.

    Returns:
        Whether a flight was drawn, for the legend.
    """
    flew = False
    for index, route in enumerate(routes):
        style = look(route.id, index)
        ground, aloft = route.split()
        if ground:
            dashes = (0, (5, 1.6)) if style.striped else "solid"
            _draw_curve(ax, ground, style.path, dashes, gid=f"path-{route.id}")
        if aloft:
            flew = True
            _draw_shadow(ax, aloft, route)
            _draw_curve(ax, aloft, style.path, DOTTED, gid=f"flight-{route.id}")
    return flew


def _draw_curve(ax: Axes, legs: list[Leg], color: str, dashes: Any, *, gid: str) -> None:
    dotted = dashes is DOTTED
    patch = PathPatch(
        curve([(leg.start, leg.control, leg.end) for leg in legs]),
        facecolor="none",
        edgecolor=color,
        linewidth=1.7 if dotted else 1.25,
        linestyle=dashes,
        joinstyle="round",
        capstyle="round",
        zorder=3,
        gid=gid,
    )
    if not dotted:
        patch.set_path_effects([Stroke(linewidth=2.3, foreground="#00000038"), Normal()])
    ax.add_patch(patch)


def _draw_shadow(ax: Axes, legs: list[Leg], route: Route) -> None:
    def cast(point: Point, height: float) -> Point:
        up = height - route.radius
        return (point[0] + SHADOW[0] * up, point[1] + SHADOW[1] * up)

    shadows = [
        tuple(
            cast(*pair) for pair in zip((leg.start, leg.control, leg.end), leg.heights, strict=True)
        )
        for leg in legs
    ]
    ax.add_patch(
        PathPatch(
            curve(shadows),
            facecolor="none",
            edgecolor="#000000",
            alpha=0.38,
            linewidth=2.2,
            joinstyle="round",
            capstyle="round",
            zorder=2.6,
            gid=f"shadow-{route.id}",
        )
    )


def curve(pieces: Sequence[Sequence[Point]]) -> Path:
    """One path of quadratic Bézier curves; a gap where a curve does not start at the last end."""
    vertices: list[Point] = []
    codes: list[Any] = []
    for start, control, end in pieces:
        if not vertices or vertices[-1] != start:
            vertices.append(start)
            codes.append(Path.MOVETO)
        vertices += [control, end]
        codes += [Path.CURVE3, Path.CURVE3]
    return Path(vertices, codes)


def draw_marks(ax: Axes, events: list[dict[str, Any]], routes: list[Route]) -> set[str]:
    """Draw a small mark at every event.

    In a run of hops over an edge only the first touch is marked. A bounce on the slate is marked
    only if the flight before or after it is high enough to be drawn.

    Returns:
        The kinds of marks that were drawn, for the legend.
    """
    by_id = {route.id: (index, route) for index, route in enumerate(routes)}
    seen = set()
    for event in (events[run[0]] for run in runs(events)):
        kind = mark(event, {ball: by_id[ball][1] for ball in event["balls"]})
        if kind is None:
            continue
        seen.add(kind)
        index, route = by_id[event["balls"][0]]
        color = colors.IVORY if kind == "ball-collision" else look(route.id, index).path
        x, y = _where(event, [by_id[ball][1].radius for ball in event["balls"]])
        draw_mark(ax, (x, y), kind, color)
    return seen


def mark(event: dict[str, Any], routes: dict[str, Route]) -> str | None:
    """The kind of an event's mark, a key of ``MARKS``; None if the event has no mark."""
    kind: str = event["type"]
    if kind == "cue-strike" and len(event["balls"]) > 1:
        # The cue ball moves the balls that touch it at once.
        kind = "ball-collision"
    if kind == "motion-transition":
        # The end of a speed band is not visible.
        return kind if event["to"] == "rolling" != event["from"] else None
    if kind == "rail-collision" and event["part"] == "top":
        kind = "slate-collision"
    if kind == "slate-collision":
        route = routes[event["balls"][0]]
        time = event["time"]
        near = [leg for leg in route.legs if time in (leg.start_time, leg.end_time)]
        height = event["before"][0]["position"][2]
        return kind if any(leg.flies and leg.top - height >= SEEN for leg in near) else None
    return kind if kind in MARKS else None


def draw_mark(ax: Axes, place: Point, kind: str, color: str) -> None:
    """Draw one mark at ``place``."""
    marker, size, filled, _ = MARKS[kind]
    crossed = marker == "x"
    ax.plot(
        [place[0]],
        [place[1]],
        marker=marker,
        markersize=size,
        markerfacecolor=color if filled else colors.CLOTH,
        markeredgecolor="#1a1a1a" if filled and not crossed else color,
        markeredgewidth=1.1 if crossed else 0.5 if filled else 0.9,
        alpha=0.9,
        zorder=4,
    )


def _where(event: dict[str, Any], radii: list[float]) -> Point:
    """The contact point of two balls; else the centre of the ball or of the group."""
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
    """Draw each ball hollow at its start and solid at its end.

    Args:
        ax: Where to draw, in m.
        routes: The balls.
        smallest: Least drawn radius, m; smaller balls are drawn with this radius.
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
    """Draw the front end of the cue behind the ball.

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
    """Half the cue's width at a distance behind the ball's centre, both in ball radii.

    The tip is 13 mm wide, and the shaft grows from there.
    """
    return 0.22 + 0.008 * behind


def draw_ball(
    ax: Axes, center: Point, radius: float, style: Look, *, gid: str | None = None
) -> None:
    """Draw one ball with its stripe and its number."""
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


def draw_ring(ax: Axes, center: Point, radius: float, dashes: Any, *, gid: str) -> None:
    """Draw a ring, such as a ghost ball or a mark around a ball."""
    ax.add_patch(
        Circle(
            center,
            radius,
            facecolor="#ffffff22",
            edgecolor="white",
            linewidth=0.9,
            linestyle=dashes,
            zorder=5,
            gid=gid,
        )
    )
