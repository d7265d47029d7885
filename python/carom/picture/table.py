"""The table: rail, cloth, pockets, cushions and diamonds; or unbounded cloth with a scale."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Circle, FancyBboxPatch, PathPatch, Polygon, Rectangle
from matplotlib.path import Path

from carom.picture.colors import FELT, Palette

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.picture.paths import Point, Route

# Half width of a diamond, as a share of the rail's width.
SIGHT_SHARE = 0.06
# Width of the ring around a hole, as a share of its radius.
POCKET_RIM = 0.18
# Number of straight pieces of a drawn rounded point (a few mm to some cm).
ARC_CHORDS = 12
# Empty space around the paths on unbounded cloth, as a share of their extent.
MARGIN_SHARE = 0.09

Bounds = tuple[float, float, float, float]
"""Left, bottom, right, top, m."""


def bounds(geometry: dict[str, Any], routes: list[Route]) -> Bounds:
    """The region of the table; on unbounded cloth, of the paths."""
    if geometry["size"] is not None:
        width, length = geometry["size"]
        rim = geometry["rail_width"]
        # The pocket irons of some tables stand out beyond the wood.
        for pocket in geometry["pockets"]:
            x, y = pocket["center"]
            beyond = max(-x, x - width, -y, y - length) + pocket["radius"]
            rim = max(rim, beyond + POCKET_RIM * pocket["radius"])
        return (-rim, -rim, width + rim, length + rim)
    corners = [
        (x + sign * route.radius, y + sign * route.radius)
        for route in routes
        for x, y in _hull(route)
        for sign in (-1.0, 1.0)
    ]
    left, right = min(x for x, _ in corners), max(x for x, _ in corners)
    bottom, top = min(y for _, y in corners), max(y for _, y in corners)
    # Without this, a single straight path would give a very narrow picture.
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
    """Points whose convex hull contains the route: a Bézier curve stays inside its polygon."""
    return [route.start, route.end, *(p for leg in route.legs for p in (leg.start, leg.control))]


def draw_table(ax: Axes, geometry: dict[str, Any], region: Bounds, palette: Palette = FELT) -> None:
    """Draw the table or the unbounded cloth."""
    if geometry["size"] is None:
        _unbounded_cloth(ax, region, palette)
        return
    width, length = geometry["size"]
    cushion = geometry["cushion_width"]
    left, bottom, right, top = region
    wood = -left - cushion
    ax.add_patch(
        FancyBboxPatch(
            (left, bottom),
            right - left,
            top - bottom,
            boxstyle=f"round,pad=0,rounding_size={0.8 * wood}",
            facecolor=palette.rail,
            edgecolor=palette.rail_edge,
            linewidth=1.2,
            zorder=0,
        )
    )
    ax.add_patch(
        Rectangle(
            (-cushion, -cushion),
            width + 2 * cushion,
            length + 2 * cushion,
            facecolor=palette.cloth,
            edgecolor=palette.rail_edge,
            linewidth=0.8,
            zorder=1,
        )
    )
    ax.add_patch(Rectangle((0, 0), width, length, facecolor=palette.cloth, zorder=1.1))
    for pocket in geometry["pockets"]:
        _pocket(ax, pocket, palette)
    for parts in _rails(geometry):
        _cushion(ax, parts, (width, length, cushion), palette)
    _sights(ax, geometry, palette)
    _markings(ax, geometry, palette)


class Ground:
    """The kind of surface under a point."""

    def __init__(self, geometry: dict[str, Any]) -> None:
        self._size = geometry["size"]
        self._rubber: list[Path] = []
        # Unbounded cloth has no rails and no pockets.
        if self._size is None:
            return
        self._rail_width = geometry["rail_width"]
        self._cushion_width = geometry["cushion_width"]
        self._pockets = geometry["pockets"]
        width, length = self._size
        for parts in _rails(geometry):
            outline = _rubber(parts, width, length, self._cushion_width)
            self._rubber.append(Path([*outline, outline[0]]))

    def under(self, point: Point) -> str:
        """``"bed"``, ``"hole"``, ``"rail"`` or, beyond the rails, ``"floor"``."""
        if self._size is None:
            return "bed"
        x, y = point
        width, length = self._size
        beyond = max(-x, x - width, -y, y - length)
        if beyond <= 0 and not self._pockets:
            return "bed"
        if any(math.dist(point, pocket["center"]) < pocket["radius"] for pocket in self._pockets):
            return "hole"
        if beyond > self._rail_width:
            return "floor"
        wood = beyond > self._cushion_width
        return "rail" if wood or any(r.contains_point(point) for r in self._rubber) else "bed"


def _rails(geometry: dict[str, Any]) -> list[list[dict[str, Any]]]:
    """The parts of the cushions, rail by rail."""
    return [
        [part for part in geometry["cushions"] if part["rail"] == rail]
        for rail in dict.fromkeys(part["rail"] for part in geometry["cushions"])
    ]


def _unbounded_cloth(ax: Axes, region: Bounds, palette: Palette) -> None:
    left, bottom, right, top = region
    ax.add_patch(
        Rectangle((left, bottom), right - left, top - bottom, facecolor=palette.cloth, zorder=0)
    )
    step = 10.0 ** math.floor(math.log10((right - left) / 2))
    for x in _multiples(left, right, step):
        ax.plot([x, x], [bottom, top], color=palette.line, alpha=0.07, linewidth=0.7, zorder=0.5)
    for y in _multiples(bottom, top, step):
        ax.plot([left, right], [y, y], color=palette.line, alpha=0.07, linewidth=0.7, zorder=0.5)
    x, y = left + 0.04 * (right - left), bottom + 0.04 * (top - bottom)
    ax.plot(
        [x, x + step], [y, y], color=palette.line, linewidth=1.6, zorder=8, solid_capstyle="butt"
    )
    ax.annotate(
        f"{step:g} m",
        (x + step / 2, y),
        xytext=(0, 3),
        textcoords="offset points",
        ha="center",
        color=palette.line,
        fontsize=7.5,
        zorder=8,
    )


def _multiples(low: float, high: float, step: float) -> list[float]:
    return [i * step for i in range(math.ceil(low / step), math.floor(high / step) + 1)]


def _pocket(ax: Axes, pocket: dict[str, Any], palette: Palette) -> None:
    """Draw the hole in the slate and the opening in the rail behind it."""
    x, y = pocket["center"]
    radius = pocket["radius"]
    ax.add_patch(Circle((x, y), (1 + POCKET_RIM) * radius, facecolor=palette.hole_edge, zorder=1.3))
    ax.add_patch(Circle((x, y), radius, facecolor=palette.hole, zorder=1.4, gid="hole"))
    if "mouth" in pocket:
        (x0, y0), (x1, y1) = pocket["mouth"]
        ax.plot(
            [x0, x1], [y0, y1], color=palette.line, alpha=0.5, linewidth=0.8, ls=":", zorder=2.2
        )


def _cushion(
    ax: Axes, parts: list[dict[str, Any]], size: tuple[float, float, float], palette: Palette
) -> None:
    """Draw one rail's rubber, from its nose line to the wood; size: width, length, rubber, m."""
    outline = _rubber(parts, *size)
    ax.add_patch(Polygon(outline, closed=True, facecolor=palette.cushion, zorder=1.6))
    ax.add_patch(
        PathPatch(
            Path(outline[1:-1]),
            facecolor="none",
            edgecolor=palette.cushion_edge,
            linewidth=0.9,
            joinstyle="round",
            zorder=1.7,
        )
    )


def _rubber(
    parts: list[dict[str, Any]], width: float, length: float, cushion: float
) -> list[Point]:
    """The outline of a rail's rubber: its nose line and two corners at the wood."""
    line = nose_line(parts)
    first, last = (_behind(end, width, length, cushion) for end in (line[0], line[-1]))
    return [first, *line, last]


def _behind(point: Point, width: float, length: float, cushion: float) -> Point:
    """The corner of the rubber at the wood, behind an end of its nose line."""
    x, y = point
    beyond = {"left": -x, "right": x - width, "bottom": -y, "top": y - length}
    furthest = max(beyond.values())
    # In a corner without a pocket two rails meet in a mitre, so the point is behind both.
    sides = {side for side, distance in beyond.items() if distance == furthest}
    return (
        -cushion if "left" in sides else width + cushion if "right" in sides else x,
        -cushion if "bottom" in sides else length + cushion if "top" in sides else y,
    )


def nose_line(parts: list[dict[str, Any]]) -> list[Point]:
    """A rail's nose line from one end to the other, with round points as short chords.

    Args:
        parts: The rail's cushion parts in their order along it.
    """
    pieces = [_chords(part) for part in parts]
    line = pieces[0]
    if len(pieces) > 1 and _gap(line[0], pieces[1]) < _gap(line[-1], pieces[1]):
        line = line[::-1]
    for piece in pieces[1:]:
        forward = math.dist(line[-1], piece[0]) <= math.dist(line[-1], piece[-1])
        line = line + (piece if forward else piece[::-1])
    return line


def _gap(point: Point, piece: list[Point]) -> float:
    return min(math.dist(point, piece[0]), math.dist(point, piece[-1]))


def _chords(part: dict[str, Any]) -> list[Point]:
    start: Point = (part["start"][0], part["start"][1])
    end: Point = (part["end"][0], part["end"][1])
    if "center" not in part:
        return [start, end]
    cx, cy = part["center"]
    begin = math.atan2(start[1] - cy, start[0] - cx)
    # The part spans less than half a turn, so the shorter arc is the right one.
    sweep = math.remainder(math.atan2(end[1] - cy, end[0] - cx) - begin, math.tau)
    return [
        (cx + part["radius"] * math.cos(angle), cy + part["radius"] * math.sin(angle))
        for angle in (begin + sweep * i / ARC_CHORDS for i in range(ARC_CHORDS + 1))
    ]


def _sights(ax: Axes, geometry: dict[str, Any], palette: Palette) -> None:
    """Draw the diamonds on the rails, except where a pocket is."""
    sights = geometry.get("sights")
    if sights is None:
        return
    width, length = geometry["size"]
    back = sights["setback"]
    middle = SIGHT_SHARE * geometry["rail_width"]
    ends = bool(geometry["pockets"])
    for i in range(sights["along_length"] + 1):
        y = i * length / sights["along_length"]
        if ends and (i in (0, sights["along_length"]) or 2 * i == sights["along_length"]):
            continue
        for x in (-back, width + back):
            _diamond(ax, (x, y), (middle, 1.5 * middle), palette)
    for i in range(sights["along_width"] + 1):
        if ends and i in (0, sights["along_width"]):
            continue
        for y in (-back, length + back):
            at = (i * width / sights["along_width"], y)
            _diamond(ax, at, (1.5 * middle, middle), palette)


def _diamond(ax: Axes, at: Point, half: tuple[float, float], palette: Palette) -> None:
    (x, y), (half_width, half_height) = at, half
    corners = [
        (x - half_width, y),
        (x, y - half_height),
        (x + half_width, y),
        (x, y + half_height),
    ]
    ax.add_patch(Polygon(corners, facecolor=palette.diamond, edgecolor="none", zorder=1.8))


def _markings(ax: Axes, geometry: dict[str, Any], palette: Palette) -> None:
    """Draw the head string or baulk line, the D, and the spots."""
    markings = geometry.get("markings") or {}
    width, _ = geometry["size"]
    style: dict[str, Any] = {"color": palette.line, "alpha": 0.28, "linewidth": 0.8, "zorder": 1.2}
    string, radius = markings.get("head_string"), markings.get("d_radius")
    if string is not None:
        ax.plot([0, width], [string, string], **style)
    if string is not None and radius is not None:
        angles = [math.pi + math.pi * i / 60 for i in range(61)]
        ax.plot(
            [width / 2 + radius * math.cos(a) for a in angles],
            [string + radius * math.sin(a) for a in angles],
            **style,
        )
    for spot in markings.get("spots", []):
        x, y = spot["position"]
        ax.plot([x], [y], marker="o", markersize=1.8, **style)
