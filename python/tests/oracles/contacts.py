"""The first contact of a flying ball with the table, with a proof that no earlier one exists.

Sturm's theorem isolates the roots of each contact's polynomial in exact rational arithmetic; then
they are refined to 50 digits. The squared distance of a parabola from a line is a polynomial of
degree 4 in time, the distance from a plane of degree 2. The distance from a circle of radius ρ is
not a polynomial, but the square of |p|² + ρ² − R² = 2ρ·(distance from the axis) is one of degree 8.
Its roots are those of the near and of the far side of the circle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from mpmath import mp, mpf

from oracles.places import rail_key

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from oracles.world import Hole, State, World

#: A polynomial, lowest power first.
Poly = list[Fraction]

DIGITS = 50
#: Rounding error of a distance that is 0, with 50 digits, m.
ON_LINE = mpf(10) ** -30
#: Number of bisections of a root before Newton's steps.
BISECTED = 40


@dataclass(frozen=True)
class Meeting:
    """A contact: its time, what is touched, and the degree of its polynomial."""

    time: Any
    key: tuple[str, ...]
    degree: int


@dataclass(frozen=True)
class Shape:
    """The ball touches where `poly` falls to 0, if `valid` holds at that place."""

    key: tuple[str, ...]
    poly: Poly
    valid: Callable[[Any], bool]


def first_meeting(world: World, radius: float, state: State, until: float) -> Meeting | None:
    """The first contact of a flying ball with the table, up to a time (s) from now."""
    mp.dps = DIGITS
    path = [
        [Fraction(state.position[k]), Fraction(state.velocity[k]), Fraction(0)] for k in range(3)
    ]
    path[2][2] = -Fraction(world.gravity) / 2

    def at(t: Any) -> tuple[Any, ...]:
        return tuple(_value(p, t) for p in path)

    best: Meeting | None = None
    end = Fraction(until)
    for shape in _shapes(world, Fraction(radius), path):
        for t in _falls(shape.poly, end):
            if best is not None and t >= best.time:
                break
            if shape.valid(at(t)):
                best = Meeting(t, shape.key, len(shape.poly) - 1)
                end = Fraction(str(t)) + Fraction(1, 10**30)
                break
    return best


def _shapes(world: World, r: Fraction, path: list[Poly]) -> Iterator[Shape]:
    x, y, z = path
    h = Fraction(world.nose_height)
    rise = _minus(z, [h])
    under = mpf(world.nose_height) - mpf(r.numerator) / r.denominator

    def over_bed(p: Any) -> bool:
        far = all(_from(p, hole.center) > hole.radius for hole in world.holes)
        return far and _inside(world.inside, p)

    yield Shape(("slate-collision",), _minus(z, [r]), over_bed)
    yield Shape(
        ("rail-collision", "top"), _minus(rise, [r]), lambda p: not _inside(world.inside, p)
    )
    for w in world.walls:
        a, n = [Fraction(k) for k in w.start], [Fraction(k) for k in w.inward]
        off = _plus(_times([n[0]], _minus(x, [a[0]])), _times([n[1]], _minus(y, [a[1]])))
        gap = _minus(_plus(_times(off, off), _times(rise, rise)), [r * r])

        def before(p: Any, w: Any = w) -> bool:
            d = [p[k] - mpf(w.start[k]) for k in (0, 1)]
            t = [mpf(w.end[k]) - mpf(w.start[k]) for k in (0, 1)]
            along = d[0] * t[0] + d[1] * t[1]
            off = d[0] * mpf(w.inward[0]) + d[1] * mpf(w.inward[1])
            return bool(off >= -ON_LINE and 0 <= along <= t[0] ** 2 + t[1] ** 2)

        yield Shape(rail_key(w), gap, before)
        # The rubber recedes below an edge, so a centre there reaches the edge's line.
        yield Shape(rail_key(w), off, lambda p, before=before: before(p) and p[2] < under)
    for post in world.posts:
        ends = [[mpf(e[k]) - mpf(post.center[k]) for k in (0, 1)] for e in post.ends]
        middle = [ends[0][k] + ends[1][k] for k in (0, 1)]
        least = (ends[0][0] * middle[0] + ends[0][1] * middle[1]) / mp.hypot(*ends[0])

        def faces(p: Any, c: Any = post, m: Any = middle, least: Any = least) -> bool:
            d = [p[k] - mpf(c.center[k]) for k in (0, 1)]
            size = mp.hypot(*d)
            return bool(size >= c.radius - ON_LINE and d[0] * m[0] + d[1] * m[1] >= least * size)

        yield Shape(rail_key(post), _ring(post.center, post.radius, r, x, y, rise), faces)
        line = _minus(_round(post.center, x, y), [Fraction(post.radius) ** 2])
        yield Shape(rail_key(post), line, lambda p, faces=faces: faces(p) and p[2] < under)
    for hole in world.holes:
        yield from _pocket(hole, r, h, (x, y, z))


def _pocket(hole: Hole, r: Fraction, h: Fraction, path: Any) -> Iterator[Shape]:
    x, y, z = path
    rho = mpf(hole.radius)
    begins, ends = (
        mp.atan2(w[1] - mpf(hole.center[1]), w[0] - mpf(hole.center[0])) for w in hole.wall
    )

    def behind(p: Any) -> bool:
        angle = mp.atan2(p[1] - mpf(hole.center[1]), p[0] - mpf(hole.center[0]))
        return bool((angle - begins) % (2 * mp.pi) <= (ends - begins) % (2 * mp.pi))

    def within(p: Any) -> bool:
        return bool(_from(p, hole.center) <= rho)

    lip = _ring(hole.center, hole.radius, r, x, y, z)
    yield Shape(("slate-collision",), lip, lambda p: within(p) and p[2] >= 0)
    # The wall, as the distance inside the circle of the centres, so that the polynomial falls.
    above = mpf(h.numerator) / h.denominator
    wall = _minus([(Fraction(hole.radius) - r) ** 2], _round(hole.center, x, y))
    key = ("rail-collision", "liner")
    yield Shape(key, wall, lambda p: within(p) and behind(p) and p[2] <= above)
    yield Shape(("slate-collision",), wall, lambda p: within(p) and not behind(p) and p[2] <= 0)
    for end in hole.wall:
        # The upright ends of the wall.
        post = _minus(_round(end, x, y), [r * r])
        yield Shape(key, post, lambda p: within(p) and not behind(p) and p[2] <= above)
    rim = _ring(hole.center, hole.radius, r, x, y, _minus(z, [h]))
    yield Shape(key, rim, lambda p: within(p) and behind(p) and p[2] >= above)


def _ring(center: Any, radius: float, r: Fraction, x: Poly, y: Poly, z: Poly) -> Poly:
    """A polynomial that falls to 0 where the distance from a horizontal circle falls to r."""
    rho = Fraction(radius)
    axis = _round(center, x, y)
    s = _plus(_plus(axis, _times(z, z)), [rho * rho - r * r])
    return _minus(_times(s, s), _times([4 * rho * rho], axis))


def _round(center: Any, x: Poly, y: Poly) -> Poly:
    """The squared distance from an upright axis."""
    dx, dy = _minus(x, [Fraction(center[0])]), _minus(y, [Fraction(center[1])])
    return _plus(_times(dx, dx), _times(dy, dy))


def _from(p: Any, center: Any) -> Any:
    return mp.hypot(p[0] - mpf(center[0]), p[1] - mpf(center[1]))


def _inside(outline: Any, p: Any) -> bool:
    odd, a = False, outline[-1]
    for b in outline:
        if (a[1] > p[1]) != (b[1] > p[1]):
            odd ^= bool(p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        a = b
    return odd


# -- polynomials and their real roots ------------------------------------------------------------


def _plus(a: Poly, b: Poly) -> Poly:
    n = max(len(a), len(b))
    return [(a[k] if k < len(a) else Fraction(0)) + (b[k] if k < len(b) else 0) for k in range(n)]


def _minus(a: Poly, b: Poly) -> Poly:
    return _plus(a, [-k for k in b])


def _times(a: Poly, b: Poly) -> Poly:
    c = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, p in enumerate(a):
        for j, q in enumerate(b):
            c[i + j] += p * q
    return c


def _value(c: Poly, t: Any) -> Any:
    f: Any = 0
    for k in reversed(c):
        f = f * t + (k if isinstance(t, Fraction) else mpf(k.numerator) / k.denominator)
    return f


def _trim(c: Poly) -> Poly:
    c = list(c)
    while c and c[-1] == 0:
        c.pop()
    return c


def _sturm(c: Poly) -> list[Poly]:
    """Sturm's chain; each member is scaled, so that the numbers stay short."""
    chain = [c, [k * p for k, p in enumerate(c)][1:]]
    while True:
        rest, by = list(chain[-2]), chain[-1]
        while len(rest) >= len(by):
            q = rest[-1] / by[-1]
            shift = len(rest) - len(by)
            for k, p in enumerate(by):
                rest[shift + k] -= q * p
            rest.pop()
        rest = _trim(rest)
        if not rest:
            return chain
        scale = abs(rest[-1])
        chain.append([-k / scale for k in rest])


def _changes(chain: list[Poly], t: Fraction) -> int:
    signs = [s for s in ((v > 0) - (v < 0) for v in (_value(c, t) for c in chain)) if s]
    return sum(a != b for a, b in pairwise(signs))


def _falls(c: Poly, end: Fraction) -> Iterator[Any]:
    """The times in (0, end] at which c falls through 0, in order."""
    c = _trim(c)
    if len(c) < 2:
        return
    chain = _sturm(c)
    pending = [(Fraction(0), end, _changes(chain, Fraction(0)), _changes(chain, end))]
    while pending:
        low, high, at_low, at_high = pending.pop()
        if at_low == at_high:
            continue
        if at_low - at_high == 1:
            # One root in this interval: c falls or rises through it.
            if _value(c, low) > 0:
                yield _refined(c, low, high)
            continue
        middle = (low + high) / 2
        at_middle = _changes(chain, middle)
        pending.append((middle, high, at_middle, at_high))
        pending.append((low, middle, at_low, at_middle))


def _refined(c: Poly, low: Fraction, high: Fraction) -> Any:
    """The only root in an interval, where c falls: bisection, then Newton's method."""
    for _ in range(BISECTED):
        middle = (low + high) / 2
        if _value(c, middle) > 0:
            low = middle
        else:
            high = middle
    slope = [k * p for k, p in enumerate(c)][1:]
    t = mpf(high.numerator) / high.denominator
    for _ in range(6):
        t -= _value(c, t) / _value(slope, t)
    return t
