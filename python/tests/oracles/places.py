"""Gaps and normals between a ball and the table, computed from the shapes.

Positions are arrays of shape (3, …). A gap is the distance of a ball of radius `r` from contact; it
is `CLEAR` where the shape cannot be touched from that place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.path import Path

if TYPE_CHECKING:
    from collections.abc import Callable

    from oracles.world import Hole, Point, Post, Wall, World

Array = Any
#: Centre and radius, m.
Circle = tuple[tuple[float, float], float]

#: The gap where a shape cannot be touched, m: large enough that no search looks closer.
CLEAR = 1.0
#: A centre that has just crossed an edge may be this far before it by rounding, m.
EDGE = 1e-12


@dataclass(frozen=True)
class Place:
    """A shape of the table that a ball can touch."""

    key: tuple[str, ...]
    gap: Callable[[Array], Array]
    normal: Callable[[Array], Array]
    #: A circle that contains the shape in plan view; None if the shape is everywhere.
    circle: Circle | None = None


def places_of(world: World, radius: float) -> list[Place]:
    """All shapes that a flying ball can touch."""
    h = world.nose_height
    found = [_slate(world, radius)]
    found += [_wall(w, h, radius) for w in world.walls]
    found += [_post(p, h, radius) for p in world.posts]
    if world.border is not None:
        found.append(_top(world, h, radius))
    for hole in world.holes:
        found += [_lip(hole, radius), _liner(hole, h, radius)]
    return found


def edges_of(world: World, radius: float) -> list[Place]:
    """The shapes that a ball on the slate can touch."""
    h = world.nose_height
    walls = [_wall(w, h, radius) for w in world.walls]
    return walls + [_post(p, h, radius) for p in world.posts]


def rail_key(piece: Wall | Post) -> tuple[str, ...]:
    """The event key of a piece of the rails; a liner belongs to no rail."""
    if piece.part == "liner":
        return ("rail-collision", "liner")
    return ("rail-collision", piece.rail, piece.part)


def inside(outline: list[Point], p: Array) -> Array:
    """Whether points lie in a polygon."""
    x, y = np.broadcast_arrays(p[0], p[1])
    points = np.column_stack((x.ravel(), y.ravel()))
    return Path([*outline, outline[0]]).contains_points(points).reshape(x.shape)


def from_center(p: Array, hole: Any) -> Array:
    """Horizontal distance from a hole's or a post's centre."""
    return np.hypot(p[0] - hole.center[0], p[1] - hole.center[1])


def on_top(world: World, p: Array) -> Array:
    """Whether the centre is above the rails, outside the line of their edges."""
    return ~inside(world.inside, p)


def _slate(world: World, radius: float) -> Place:
    def gap(p: Array) -> Array:
        over = np.ones(np.shape(p[0]), dtype=bool)
        if world.inside:
            over &= inside(world.inside, p)
        for hole in world.holes:
            over &= from_center(p, hole) > hole.radius
        return np.where(over, p[2] - radius, CLEAR)

    return Place(("slate-collision",), gap, lambda _: np.array((0.0, 0.0, -1.0)))


def _top(world: World, h: float, radius: float) -> Place:
    def gap(p: Array) -> Array:
        over = on_top(world, p) & (p[2] >= h)
        return np.where(over, p[2] - h - radius, CLEAR)

    return Place(("rail-collision", "top"), gap, lambda _: np.array((0.0, 0.0, -1.0)))


def _from_edge(off: Array, rise: Array, radius: float) -> Array:
    """The gap to an edge of a centre at the distance `off` before it and `rise` above it.

    The rubber recedes below the edge, so centres more than a radius below it reach the edge's line.
    """
    return np.where(rise < -radius, off, np.hypot(off, rise) - radius)


def _is_before(off: Array, rise: Array, radius: float) -> Array:
    """Whether a centre is before an edge; below the edge it may just have crossed its line."""
    return off >= np.where(rise < -radius, -radius, -EDGE)


def _to_edge(off: float, into: Array, rise: float, radius: float) -> Array:
    """The unit vector to the touched point; `rise` is the edge's height above the centre."""
    if rise > radius:
        return np.array((*into, 0.0))
    return _unit(np.array((*(off * into), rise)))


def _wall(wall: Wall, h: float, radius: float) -> Place:
    a, n = np.array(wall.start), np.array(wall.inward)
    t = np.array(wall.end) - a
    length = np.hypot(*t)
    t = t / length

    def gap(p: Array) -> Array:
        along = (p[0] - a[0]) * t[0] + (p[1] - a[1]) * t[1]
        off = (p[0] - a[0]) * n[0] + (p[1] - a[1]) * n[1]
        # Behind the line is the rail's top; beyond its ends other edges continue.
        met = (along >= 0.0) & (along <= length) & _is_before(off, p[2] - h, radius)
        return np.where(met, _from_edge(off, p[2] - h, radius), CLEAR)

    def normal(p: Array) -> Array:
        off = float((p[:2] - a) @ n)
        return _to_edge(off, -n, h - p[2], radius)

    middle = (np.array(wall.start) + np.array(wall.end)) / 2
    return Place(rail_key(wall), gap, normal, ((middle[0], middle[1]), length / 2))


def _post(post: Post, h: float, radius: float) -> Place:
    c = np.array(post.center)
    ends = [np.array(e) - c for e in post.ends]
    middle = ends[0] + ends[1]
    if post.radius == 0.0 or np.hypot(*middle) == 0.0:
        raise NotImplementedError("sharp points")
    middle = middle / np.hypot(*middle)
    least = float(ends[0] @ middle) / post.radius

    def gap(p: Array) -> Array:
        d = from_center(p, post)
        facing = (p[0] - c[0]) * middle[0] + (p[1] - c[1]) * middle[1] >= least * d
        met = facing & _is_before(d - post.radius, p[2] - h, radius)
        return np.where(met, _from_edge(d - post.radius, p[2] - h, radius), CLEAR)

    def normal(p: Array) -> Array:
        d = float(from_center(p, post))
        return _to_edge(d - post.radius, (c - p[:2]) / d, h - p[2], radius)

    return Place(rail_key(post), gap, normal, (post.center, post.radius))


def _is_at_wall(hole: Hole, p: Array) -> Array:
    """Whether a point is at the angles of the wall behind the hole."""
    begins, ends = (np.arctan2(w[1] - hole.center[1], w[0] - hole.center[0]) for w in hole.wall)
    angle = np.arctan2(p[1] - hole.center[1], p[0] - hole.center[0])
    return (angle - begins) % (2 * np.pi) <= (ends - begins) % (2 * np.pi)


def _lip(hole: Hole, radius: float) -> Place:
    """The hole's edge, and below the slate's surface its wall on the side of the table."""

    def gap(p: Array) -> Array:
        short = hole.radius - from_center(p, hole)
        above = np.hypot(np.maximum(short, 0.0), np.maximum(p[2], 0.0)) - radius
        met = (short >= -EDGE) & ((p[2] >= 0.0) | ~_is_at_wall(hole, p))
        return np.where(met, above, CLEAR)

    def normal(p: Array) -> Array:
        d = p[:2] - np.array(hole.center)
        out = d / np.hypot(*d) * (hole.radius - np.hypot(*d))
        return _unit(np.array((*out, min(-float(p[2]), 0.0))))

    return Place(("slate-collision", "lip"), gap, normal, (hole.center, hole.radius))


def _liner(hole: Hole, h: float, radius: float) -> Place:
    """The wall behind the hole, and its upper edge at the height of the rails."""

    def gap(p: Array) -> Array:
        short = hole.radius - from_center(p, hole)
        met = _is_at_wall(hole, p) & (short >= 0.0)
        round_ = np.hypot(short, np.maximum(p[2] - h, 0.0)) - radius
        # Beside the wall a ball touches its upright ends, below the edges after the facings.
        post = np.minimum.reduce([np.hypot(p[0] - e[0], p[1] - e[1]) for e in hole.wall]) - radius
        return np.where(met, round_, np.where((p[2] <= h) & (short >= 0.0), post, CLEAR))

    def normal(p: Array) -> Array:
        d = p[:2] - np.array(hole.center)
        if not _is_at_wall(hole, p):
            end = min(hole.wall, key=lambda e: math.dist(e, p[:2]))
            return _unit(np.array((end[0] - p[0], end[1] - p[1], 0.0)))
        out = d / np.hypot(*d) * (hole.radius - np.hypot(*d))
        return _unit(np.array((*out, min(h - float(p[2]), 0.0))))

    return Place(("rail-collision", "liner"), gap, normal, (hole.center, hole.radius))


def _unit(v: Array) -> Array:
    return v / np.sqrt(v @ v)
