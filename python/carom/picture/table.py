"""The table: rail, cloth, pockets, cushions and diamonds; or endless cloth with a scale."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Circle, FancyBboxPatch, PathPatch, Polygon, Rectangle
from matplotlib.path import Path

from carom.picture import colors

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.picture.paths import Point, Route

# Width of what surrounds the playing area in the picture, as a share of the table's width: a
# cushion is about 5 cm and the wood about 9 cm on a 1.27 m table.
CUSHION_SHARE = 0.042
WOOD_SHARE = 0.07
# Empty space around the paths on endless cloth, as a share of their extent.
MARGIN_SHARE = 0.09

Bounds = tuple[float, float, float, float]
"""Left, bottom, right, top, m."""


def bounds(geometry: dict[str, Any], routes: list[Route]) -> Bounds:
    """The region that the table (or, on endless cloth, what happens on it) takes."""
    if geometry["size"] is not None:
        width, length = geometry["size"]
        rim = (CUSHION_SHARE + WOOD_SHARE) * width
        return (-rim, -rim, width + rim, length + rim)
    corners = [
        (x + sign * route.radius, y + sign * route.radius)
        for route in routes
        for x, y in _hull(route)
        for sign in (-1.0, 1.0)
    ]
    left, right = min(x for x, _ in corners), max(x for x, _ in corners)
    bottom, top = min(y for _, y in corners), max(y for _, y in corners)
    # A single straight path would otherwise make a sliver.
    extent = max(right - left, top - bottom)
    margin = MARGIN_SHARE * extent
    missing_width = max(0.0, 0.6 * extent - (right - left)) / 2
    missing_height = max(0.0, 0.6 * extent - (top - bottom)) / 2
    return (
        left - missing_width - margin,
        bottom - missing_height - margin,
        right + missing_width + margin,
        top + missing_height + margin,
    )


def _hull(route: Route) -> list[Point]:
    """Points whose convex hull holds the route: a Bézier curve stays inside its polygon."""
    return [route.start, route.end, *(p for leg in route.legs for p in (leg.start, leg.control))]


def draw_table(ax: Axes, geometry: dict[str, Any], region: Bounds) -> None:
    """Draw what lies under the paths."""
    if geometry["size"] is None:
        _endless_cloth(ax, region)
        return
    width, length = geometry["size"]
    cushion, wood = CUSHION_SHARE * width, WOOD_SHARE * width
    left, bottom, right, top = region
    ax.add_patch(
        FancyBboxPatch(
            (left, bottom),
            right - left,
            top - bottom,
            boxstyle=f"round,pad=0,rounding_size={0.8 * wood}",
            facecolor=colors.RAIL,
            edgecolor=colors.RAIL_EDGE,
            linewidth=1.2,
            zorder=0,
        )
    )
    ax.add_patch(
        Rectangle(
            (-cushion, -cushion),
            width + 2 * cushion,
            length + 2 * cushion,
            facecolor=colors.CUSHION if not geometry["cushions"] else colors.CLOTH,
            edgecolor=colors.RAIL_EDGE,
            linewidth=0.8,
            zorder=1,
        )
    )
    ax.add_patch(Rectangle((0, 0), width, length, facecolor=colors.CLOTH, zorder=1.1))
    for pocket in geometry["pockets"]:
        _pocket(ax, pocket, geometry, cushion)
    for rail in dict.fromkeys(part["rail"] for part in geometry["cushions"]):
        parts = [part for part in geometry["cushions"] if part["rail"] == rail]
        _cushion(ax, parts, width, length, cushion)
    _marks(ax, width, length, cushion, wood, bool(geometry["pockets"]))


def _endless_cloth(ax: Axes, region: Bounds) -> None:
    left, bottom, right, top = region
    ax.add_patch(
        Rectangle((left, bottom), right - left, top - bottom, facecolor=colors.CLOTH, zorder=0)
    )
    step = 10.0 ** math.floor(math.log10((right - left) / 2))
    for x in _multiples(left, right, step):
        ax.plot([x, x], [bottom, top], color="white", alpha=0.07, linewidth=0.7, zorder=0.5)
    for y in _multiples(bottom, top, step):
        ax.plot([left, right], [y, y], color="white", alpha=0.07, linewidth=0.7, zorder=0.5)
    x, y = left + 0.04 * (right - left), bottom + 0.04 * (top - bottom)
    ax.plot([x, x + step], [y, y], color="white", linewidth=1.6, zorder=8, solid_capstyle="butt")
    ax.annotate(
        f"{step:g} m",
        (x + step / 2, y),
        xytext=(0, 3),
        textcoords="offset points",
        ha="center",
        color="white",
        fontsize=7.5,
        zorder=8,
    )


def _multiples(low: float, high: float, step: float) -> list[float]:
    return [i * step for i in range(math.ceil(low / step), math.floor(high / step) + 1)]


def _pocket(ax: Axes, pocket: dict[str, Any], geometry: dict[str, Any], cushion: float) -> None:
    """The hole in the slate, and the opening that the pocket cuts into the rail behind it."""
    x, y = pocket["center"]
    radius = pocket["radius"]
    ax.add_patch(Circle((x, y), radius + 0.22 * cushion, facecolor=colors.HOLE_EDGE, zorder=1.3))
    ax.add_patch(Circle((x, y), radius, facecolor=colors.HOLE, zorder=1.4))
    if pocket["capture"] == "mouth-line":
        (x0, y0), (x1, y1) = pocket["mouth"]
        ax.plot([x0, x1], [y0, y1], color="white", alpha=0.5, linewidth=0.8, ls=":", zorder=2.2)


def _cushion(
    ax: Axes, parts: list[dict[str, Any]], width: float, length: float, cushion: float
) -> None:
    """One rail's rubber: its nose line, closed behind at the wood."""
    line = nose_line(parts)
    first, last = _behind(line[0], width, length, cushion), _behind(
        line[-1], width, length, cushion
    )
    ax.add_patch(
        Polygon([first, *line, last], closed=True, facecolor=colors.CUSHION, zorder=1.6)
    )
    ax.add_patch(
        PathPatch(
            Path(line),
            facecolor="none",
            edgecolor=colors.CUSHION_EDGE,
            linewidth=0.9,
            joinstyle="round",
            zorder=1.7,
        )
    )


def _behind(point: Point, width: float, length: float, cushion: float) -> Point:
    """The point on the cushion's back from which the rubber starts: straight behind an end."""
    x, y = point
    beyond = {"left": -x, "right": x - width, "bottom": -y, "top": y - length}
    side = max(beyond, key=lambda name: beyond[name])
    return {
        "left": (-cushion, y),
        "right": (width + cushion, y),
        "bottom": (x, -cushion),
        "top": (x, length + cushion),
    }[side]


def nose_line(parts: list[dict[str, Any]]) -> list[Point]:
    """A rail's nose line from one end to the other, its round points as short chords.

    Args:
        parts: The rail's segments and arcs, in any order.
    """
    segments = [(tuple(p["start"]), tuple(p["end"])) for p in parts if p["shape"] == "segment"]
    arcs = [p for p in parts if p["shape"] == "arc"]
    nose = next(
        (tuple(p["start"]), tuple(p["end"]))
        for p in parts
        if p["part"] == "nose" and p["shape"] == "segment"
    )
    line: list[Point] = [nose[0], nose[1]]
    rest = [s for s in segments if s != nose]
    while rest:
        # Whatever lies nearest to an end of the line continues it.
        gaps = [
            (math.dist(line[end], segment[near]), end, near, segment)
            for segment in rest
            for end in (0, -1)
            for near in (0, 1)
        ]
        _, end, near, segment = min(gaps)
        rest.remove(segment)
        joint = _joint(line[end], segment[near], arcs)
        if end == 0:
            line[:0] = [segment[1 - near], segment[near], *reversed(joint)]
        else:
            line += [*joint, segment[near], segment[1 - near]]
    return line


def _joint(start: Point, end: Point, arcs: list[dict[str, Any]]) -> list[Point]:
    """Points along the arc that joins two pieces, without its ends."""
    if math.dist(start, end) == 0.0 or not arcs:
        return []
    arc = min(
        arcs,
        key=lambda a: abs(math.dist(start, a["center"]) - a["radius"])
        + abs(math.dist(end, a["center"]) - a["radius"]),
    )
    cx, cy = arc["center"]
    begin = math.atan2(start[1] - cy, start[0] - cx)
    sweep = math.remainder(math.atan2(end[1] - cy, end[0] - cx) - begin, math.tau)
    pieces = 12
    return [
        (
            cx + arc["radius"] * math.cos(begin + sweep * i / pieces),
            cy + arc["radius"] * math.sin(begin + sweep * i / pieces),
        )
        for i in range(1, pieces)
    ]


def _marks(
    ax: Axes, width: float, length: float, cushion: float, wood: float, pockets: bool
) -> None:
    """The sights (diamonds): quarters of the width, eighths of the length."""
    middle = cushion + wood / 2
    size = 0.16 * wood
    along = [i * length / 8 for i in range(0 if not pockets else 1, 9 if not pockets else 8)]
    across = [i * width / 4 for i in range(0 if not pockets else 1, 5 if not pockets else 4)]
    sights = [(x, y) for y in along if not (pockets and y == length / 2)
              for x in (-middle, width + middle)]
    sights += [(x, y) for x in across for y in (-middle, length + middle)]
    for x, y in sights:
        ax.add_patch(
            Polygon(
                [(x - size, y), (x, y - 1.5 * size), (x + size, y), (x, y + 1.5 * size)]
                if x in (-middle, width + middle)
                else [(x - 1.5 * size, y), (x, y - size), (x + 1.5 * size, y), (x, y + size)],
                facecolor=colors.DIAMOND,
                edgecolor="none",
                zorder=1.8,
            )
        )
