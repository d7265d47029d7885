"""Oracle B: the event simulation of Leckie & Greenspan with 50 digits (mpmath), and with flight.

All roots of each contact's polynomial are computed, without proofs or shortcuts; rounding errors
are negligible. It is for a few balls on unbounded cloth, between four straight rails, or on a table
with pockets for as long as no ball falls into a pocket or flies over its jaws.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from mpmath import mp, mpf, polyroots

from oracles import laws, rolling
from oracles.world import Happening, Post, State, Wall, World, motion_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

Number = Any

DIGITS = 50
#: A smaller imaginary part is a rounding error of `polyroots`; double roots keep half the digits.
REAL = mpf(10) ** -20
#: A root this close to zero, s, is the contact that has just been resolved.
NOW = mpf(10) ** -25
#: A flying ball whose gap to the slate or a rail's top is smaller than this, m, touches it.
TOUCH = mpf(10) ** -10


ON_CLOTH = ("sliding", "rolling", "spinning", "stationary")
Three = tuple[Number, Number, Number]
Edge = Wall | Post


@dataclass(frozen=True)
class Leg:
    """The closed-form path r + v t + h t² of one motion state, from `start`, for `lasts`."""

    start: Number
    state: State
    half: Three
    turn: Three
    lasts: Number


class Precise:
    """A shot that is advanced event by event from given states."""

    def __init__(self, world: World, states: Sequence[State], time: float = 0.0) -> None:
        mp.dps = DIGITS
        self.world = world
        self.time = mpf(time)
        #: Number of collisions of two balls so far.
        self.met = 0
        self.leg: list[Leg] = []
        self.found: dict[tuple[int, ...], tuple[list[Leg], Any]] = {}
        for i, state in enumerate(states):
            self.leg.append(self._leg(i, _exact(state)))

    def replace(self, i: int, state: State) -> None:
        """Sets ball `i` at the present time."""
        self.leg[i] = self._leg(i, _exact(state))

    def next(self) -> Happening | None:
        """Advances to the next event and applies it; None when all balls are at rest."""
        best: tuple[Number, tuple[str, ...], tuple[int, ...], Edge | None] | None = None
        for i, leg in enumerate(self.leg):
            if leg.state.motion == "stationary" and self._is_on_top(i, leg.state):
                # A ball cannot rest on a rail.
                best = _earlier(best, (self.time, ("off-table", self.world.ids[i]), (i,), None))
            if leg.state.motion in ("sliding", "rolling", "spinning"):
                time = leg.start + leg.lasts
                best = _earlier(best, (time, ("transition", self.world.ids[i]), (i,), None))
            if leg.state.motion in ("sliding", "rolling", "airborne"):
                for key, time, edge in self._kept((i,), lambda i=i: self._table(i)):
                    best = _earlier(best, (time, key, (i,), edge))
        n = len(self.leg)
        for i in range(n):
            for j in range(i + 1, n):
                time = self._kept((i, j), lambda i=i, j=j: self._contact(i, j))
                if time is not None:
                    names = sorted((self.world.ids[i], self.world.ids[j]))
                    best = _earlier(best, (time, ("ball-collision", *names), (i, j), None))
        if best is None:
            return None
        self.time = best[0]
        return self._apply(best[1], best[2], best[3])

    def _kept(self, balls: tuple[int, ...], compute: Callable[[], Any]) -> Any:
        """Contacts of balls, computed again after a change of their paths."""
        legs = [self.leg[i] for i in balls]
        known = self.found.get(balls)
        if known is None or any(a is not b for a, b in zip(known[0], legs, strict=True)):
            known = self.found[balls] = (legs, compute())
        return known[1]

    # -- paths -----------------------------------------------------------------------------------

    def _leg(self, i: int, state: State) -> Leg:
        cloth, g = self.world.physics["cloth"], mpf(self.world.gravity)
        r, zero = mpf(self.world.radius[i]), mpf(0)
        v, w = state.velocity, state.spin
        decay = -mp.sign(w[2]) * mpf(cloth["spin_deceleration"])
        if state.motion == "sliding":
            u = (v[0] - r * w[1], v[1] + r * w[0])
            size = mp.hypot(*u)
            a = mpf(cloth["sliding_friction"]) * g
            e = (u[0] / size, u[1] / size)
            turn = (-e[1] * 5 * a / (2 * r), e[0] * 5 * a / (2 * r), decay)
            half = (-e[0] * a / 2, -e[1] * a / 2, zero)
            return Leg(self.time, state, half, turn, 2 * size / (7 * a))
        if state.motion == "rolling":
            size = mp.hypot(v[0], v[1])
            friction, low = rolling.band(cloth, size)
            a = mpf(friction) * g
            e = (v[0] / size, v[1] / size)
            turn = (e[1] * a / r, -e[0] * a / r, decay)
            half = (-e[0] * a / 2, -e[1] * a / 2, zero)
            return Leg(self.time, state, half, turn, (size - mpf(low)) / a)
        lasts = mp.inf
        if state.motion == "airborne":
            return Leg(self.time, state, (zero, zero, -g / 2), (zero, zero, zero), lasts)
        if state.motion == "spinning":
            lasts = abs(w[2]) / mpf(cloth["spin_deceleration"])
        return Leg(self.time, state, (zero, zero, zero), (zero, zero, decay), lasts)

    def _at(self, i: int, time: Number) -> State:
        leg = self.leg[i]
        t, s = time - leg.start, leg.state
        x, v, w = s.position, s.velocity, s.spin
        wz = w[2] + leg.turn[2] * t
        if wz * w[2] <= 0:
            wz = mpf(0)
        h = leg.half
        return State(
            _three(lambda k: x[k] + (v[k] + h[k] * t) * t),
            _three(lambda k: v[k] + 2 * h[k] * t),
            (w[0] + leg.turn[0] * t, w[1] + leg.turn[1] * t, wz),
            s.motion,
        )

    def _motion(self, i: int) -> tuple[State, Three]:
        """The path, with time counted from the present."""
        return self._at(i, self.time), self.leg[i].half

    def _coordinate(self, i: int, axis: Sequence[Number], origin: Sequence[Number]) -> list[Number]:
        """The coordinate along an axis as a polynomial in time from now (highest power first)."""
        state, half = self._motion(i)
        n = len(axis)
        return [
            sum(half[k] * axis[k] for k in range(n)),
            sum(state.velocity[k] * axis[k] for k in range(n)),
            sum((state.position[k] - mpf(origin[k])) * axis[k] for k in range(n)),
        ]

    # -- event times -----------------------------------------------------------------------------

    def _contact(self, i: int, j: int) -> Number | None:
        """The first contact of two balls: the first root of the quartic at which they approach."""
        (a, ha), (b, hb) = self._motion(i), self._motion(j)
        if not {a.motion, b.motion} & {"sliding", "rolling", "airborne"}:
            return None
        if {a.motion, b.motion} & {"pocketed", "off-table"}:
            return None
        reach = mpf(self.world.radius[i]) + mpf(self.world.radius[j])
        squares = [
            _square([hb[k] - ha[k], b.velocity[k] - a.velocity[k], b.position[k] - a.position[k]])
            for k in range(3)
        ]
        c = [sum(column) for column in zip(*squares, strict=True)]
        c[-1] -= reach**2
        time = next(_approaches(c), None)
        return None if time is None else self.time + time

    def _table(self, i: int) -> list[tuple[tuple[str, ...], Number, Edge | None]]:
        """The pieces of the table that the ball hits, each with its first time."""
        world, name = self.world, self.world.ids[i]
        state = self._at(i, self.time)
        r, h = mpf(world.radius[i]), mpf(world.nose_height)
        flies = state.motion == "airborne"
        found = []

        def first(
            key: tuple[str, ...], c: Sequence[Number], valid: Any, edge: Edge | None = None
        ) -> None:
            time = next((t for t in _approaches(c) if valid(self._at(i, self.time + t))), None)
            if time is not None:
                found.append((key, self.time + time, edge))

        up = self._coordinate(i, (0, 0, 1), (0, 0, 0))
        if flies:

            def above(level: Number) -> list[Number]:
                return [up[0], up[1], up[2] - level]

            first(("slate-collision", name), above(r), self._is_over_bed)
            if world.walls:
                key = ("rail-collision", name, "top")
                first(key, above(h + r), lambda s: not self._is_over_bed(s))
        if flies or state.position[2] < r + h / 2:
            # Liners are behind the holes.
            for wall in (w for w in world.walls if w.part != "liner"):
                key = ("rail-collision", name, wall.rail, wall.part)
                off = self._coordinate(i, [mpf(k) for k in wall.inward], wall.start)
                c = [
                    a + b
                    for a, b in zip(_square(off), _square([up[0], up[1], up[2] - h]), strict=True)
                ]
                c[-1] -= r**2
                first(key, c, lambda s, w=wall: self._faces(w, s), wall)
            if not flies:
                for post in world.posts:
                    # On the slate the edge is a circle at the height of the nose.
                    reach = mpf(post.radius) + mp.sqrt(r**2 - (h - state.position[2]) ** 2)
                    x = self._coordinate(i, (1, 0), post.center)
                    y = self._coordinate(i, (0, 1), post.center)
                    c = [a + b for a, b in zip(_square(x), _square(y), strict=True)]
                    c[-1] -= reach**2
                    key = ("rail-collision", name, post.rail, post.part)
                    first(key, c, lambda s, p=post: _is_before(p, s), post)
        else:
            for wall in world.walls:
                off = self._coordinate(i, [-mpf(k) for k in wall.inward], wall.start)
                first(("tips", name), off, self._is_within_noses)
        if world.border is not None and (flies or state.position[2] > r + h / 2):
            x0, y0, x1, y1 = world.border
            for axis, origin in (
                ((1, 0), (x0, y0)),
                ((0, 1), (x0, y0)),
                ((-1, 0), (x1, y1)),
                ((0, -1), (x1, y1)),
            ):
                c = self._coordinate(i, axis, origin)
                first(("off-table", name), c, lambda _: True)
        return found

    def _is_over_bed(self, s: State) -> bool:
        return all(_off(w, s) >= 0 for w in self.world.walls if w.part == "nose")

    def _is_within_noses(self, s: State) -> bool:
        """Whether the centre is inside the line of the edges, with the rounding of a crossing."""
        return all(_off(w, s) >= -NOW for w in self.world.walls)

    def _faces(self, wall: Wall, s: State) -> bool:
        """Whether the centre is before a wall, between its ends."""
        x, y = (s.position[k] - mpf(wall.start[k]) for k in (0, 1))
        t = [mpf(wall.end[k]) - mpf(wall.start[k]) for k in (0, 1)]
        along = x * t[0] + y * t[1]
        return bool(_off(wall, s) >= 0 and 0 <= along <= t[0] ** 2 + t[1] ** 2)

    # -- what happens ----------------------------------------------------------------------------

    def _apply(self, key: tuple[str, ...], balls: tuple[int, ...], edge: Edge | None) -> Happening:
        before = tuple(self._at(i, self.time) for i in balls)
        i = balls[0]
        gentle, approach = False, mpf(0)
        physics, g = _exact_law(self.world.physics), mpf(self.world.gravity)
        cloth = physics["cloth"]["sliding_friction"]
        s = before[0]
        if key[0] in ("transition", "tips"):
            after = (
                self._successor(i, s) if key[0] == "transition" else replace(s, motion="airborne")
            )
            key = ("motion-transition", key[1], s.motion, after.motion)
            self.leg[i] = self._leg(i, after)
        elif key[0] == "ball-collision":
            apart = laws.add(s.velocity, before[1].velocity, -1)
            pair = self._body(i, s), self._body(balls[1], before[1])
            law = _exact_law(self.world.law_of_balls(self.met))
            self.met += 1
            bodies = laws.collide(law, *pair, mp, cloth)
            d = laws.add(before[1].position, s.position, -1)
            approach = laws.dot(apart, d) / mp.sqrt(laws.dot(d, d))
            gentle = approach < 2 * laws.LOUD
            for k, state, body in zip(balls, before, bodies, strict=True):
                self._take(k, state, body)
        elif key[0] == "slate-collision" or key[-1] == "top":
            self._take(i, s, laws.bounce(physics["slate"], g, self._body(i, s), mp))
        elif key[0] == "rail-collision":
            assert edge is not None
            to = (*_to_edge(edge, s), mpf(self.world.nose_height) - s.position[2])
            normal = laws.scale(to, 1 / mp.sqrt(laws.dot(to, to)))
            law = _exact_law(self.world.law_of(edge.part))
            on_bed = s.motion in ON_CLOTH
            slow = 2 * laws.LOUD if on_bed else laws.PRESSED
            approach = laws.dot(s.velocity, normal)
            gentle = approach < slow
            body = laws.rebound(law, self._body(i, s), normal, on_bed, mp, cloth)
            self._take(i, s, body)
        if key[0] == "off-table":
            none = (mpf(0), mpf(0), mpf(0))
            self.leg[i] = self._leg(i, State(s.position, none, none, "off-table"))
        after_states = tuple(self.leg[k].state for k in balls)
        names = tuple(self.world.ids[k] for k in balls)
        return Happening(self.time, key, names, before, after_states, gentle, approach)

    def _successor(self, i: int, s: State) -> State:
        r, zero = mpf(self.world.radius[i]), mpf(0)
        wz = s.spin[2]
        if s.motion == "sliding":
            w = (-s.velocity[1] / r, s.velocity[0] / r, wz)
            return replace(s, spin=w, motion="rolling")
        first = self.leg[i].state.velocity
        _, low = rolling.band(self.world.physics["cloth"], mp.hypot(first[0], first[1]))
        if s.motion == "rolling" and low > 0:
            v = laws.scale(s.velocity, mpf(low) / mp.hypot(s.velocity[0], s.velocity[1]))
            return replace(s, velocity=v, spin=(-v[1] / r, v[0] / r, wz))
        rest = "stationary" if wz == 0 or s.motion == "spinning" else "spinning"
        spin = (zero, zero, wz if rest == "spinning" else zero)
        return replace(s, velocity=(zero, zero, zero), spin=spin, motion=rest)

    def _body(self, i: int, s: State) -> laws.Body:
        mass, radius = mpf(self.world.mass[i]), mpf(self.world.radius[i])
        return laws.Body(mass, radius, s.position, s.velocity, s.spin)

    def _take(self, i: int, s: State, body: laws.Body) -> None:
        """Sets a ball after an impact; a ball that is on the slate stays there or leaves it."""
        down = s.position[2] - body.radius
        if self.world.walls and not self._is_over_bed(s):
            down -= mpf(self.world.nose_height)
        borne = s.motion in ON_CLOTH or abs(down) < TOUCH
        if borne:
            slate, g = _exact_law(self.world.physics["slate"]), mpf(self.world.gravity)
            body = laws.settle(slate, g, body, mp)
        motion = "airborne"
        if borne and body.velocity[2] == 0:
            motion = motion_of(body.velocity, body.spin, body.radius)
        state = replace(s, velocity=body.velocity, spin=body.spin, motion=motion)
        self.leg[i] = self._leg(i, state)

    def _is_on_top(self, i: int, s: State) -> bool:
        return bool(s.position[2] > self.world.radius[i] + self.world.nose_height / 2)


def _three(f: Any) -> Three:
    return f(0), f(1), f(2)


def _to_edge(edge: Edge, s: State) -> tuple[Number, Number]:
    """The horizontal vector from a ball's centre to the nearest point of an edge."""
    if isinstance(edge, Wall):
        off = _off(edge, s)
        return (-off * mpf(edge.inward[0]), -off * mpf(edge.inward[1]))
    x, y = (mpf(edge.center[k]) - s.position[k] for k in (0, 1))
    size = mp.hypot(x, y)
    off = size - mpf(edge.radius)
    return (x / size * off, y / size * off)


def _is_before(post: Post, s: State) -> bool:
    """Whether the centre is before a round edge, in the directions between its ends."""
    x, y = (s.position[k] - mpf(post.center[k]) for k in (0, 1))
    a, b = ([mpf(e[k]) - mpf(post.center[k]) for k in (0, 1)] for e in post.ends)
    middle = (a[0] + b[0], a[1] + b[1])
    least = (a[0] * middle[0] + a[1] * middle[1]) / mpf(post.radius)
    return bool(x * middle[0] + y * middle[1] >= least * mp.hypot(x, y))


def _off(wall: Wall, s: State) -> Number:
    """Distance of the centre before a wall's line."""
    return sum((s.position[k] - mpf(wall.start[k])) * mpf(wall.inward[k]) for k in (0, 1))


def _square(c: Sequence[Number]) -> list[Number]:
    """A quadratic squared, highest power first."""
    a, b, d = c
    return [a * a, 2 * a * b, b * b + 2 * a * d, 2 * b * d, d * d]


def _exact(state: State) -> State:
    return State(
        tuple(mpf(x) for x in state.position),  # type: ignore[arg-type]
        tuple(mpf(x) for x in state.velocity),  # type: ignore[arg-type]
        tuple(mpf(x) for x in state.spin),  # type: ignore[arg-type]
        state.motion,
    )


def _exact_law(law: Any) -> Any:
    if isinstance(law, dict):
        return {k: _exact_law(v) for k, v in law.items()}
    return mpf(law) if isinstance(law, float) else law


def _value(c: Sequence[Number], t: Number) -> tuple[Number, Number]:
    """A polynomial (highest power first) and its derivative."""
    f, g = mpf(0), mpf(0)
    for k in c:
        f, g = f * t + k, g * t + f
    return f, g


def _approaches(c: Sequence[Number]) -> Iterator[Number]:
    """The times t ≥ 0 with f ≤ 0 and f′ < 0, in order; f is given highest power first."""
    if c[-1] <= NOW and c[-2] < -NOW:
        yield mpf(0)
    meets = [t for t in _real_roots(c) if t > NOW and _value(c, t)[1] < 0]
    if c[-1] < 0:
        # Bodies overlap by a rounding. If they turn back before they separate, they meet there.
        n = len(c) - 1
        turns = _real_roots([k * (n - p) for p, k in enumerate(c[:-1])])
        meets += [t for t in turns if t > NOW and _value(c, t)[0] < -NOW]
    yield from sorted(meets)


def _real_roots(c: Sequence[Number]) -> list[Number]:
    c = list(c)
    while c and c[0] == 0:
        c.pop(0)
    if len(c) < 2:
        return []
    # The search starts at the roots in double precision. It needs different complex numbers.
    rough = np.roots([float(k) for k in c])
    near = [mp.mpc(z + 1e-9 * (1 + abs(z)) * 1j**k) for k, z in enumerate(rough)]
    roots = polyroots(c[::-1], maxsteps=500, extraprec=400, roots_init=near, asc=True)
    return [z.real for z in map(mp.mpc, roots) if abs(z.imag) < REAL * (1 + abs(z))]


def _earlier(a: Any, b: Any) -> Any:
    return b if a is None or b[0] < a[0] else a
