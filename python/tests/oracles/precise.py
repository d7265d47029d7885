"""Oracle B: the event simulation of Leckie & Greenspan with 50 digits (mpmath).

Contacts are roots of the quartic, found all four at once; no proof, no shortcut, no rounding that
matters. For a few balls.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from mpmath import mp, mpf, polyroots

from oracles import laws
from oracles.world import Happening, State, World, motion_of

if TYPE_CHECKING:
    from collections.abc import Sequence

Number = Any

DIGITS = 50
#: An imaginary part below this is rounding of `polyroots` (double roots keep half the digits).
REAL = mpf(10) ** -20
#: Times this close to zero are the contact that has just been resolved, s.
NOW = mpf(10) ** -25


@dataclass(frozen=True)
class Leg:
    """The closed-form path of one motion state: r + v t + h t², from `start` for `lasts`."""

    start: Number
    state: State
    half: tuple[Number, Number]
    turn: tuple[Number, Number, Number]
    lasts: Number


class Precise:
    """A shot, advanced event by event from given states."""

    def __init__(self, world: World, states: Sequence[State], time: float = 0.0) -> None:
        mp.dps = DIGITS
        self.world = world
        self.time = mpf(time)
        self.leg: list[Leg] = []
        for i, state in enumerate(states):
            self.leg.append(self._leg(i, _exact(state)))

    def replace(self, i: int, state: State) -> None:
        """Sets ball `i` at the present time."""
        self.leg[i] = self._leg(i, _exact(state))

    def resume(self, time: float) -> None:
        """Sets the clock; balls that are not replaced keep their paths."""
        self.time = mpf(time)

    def next(self) -> Happening | None:
        """Advances to the next event and applies it; None when all is at rest."""
        best: tuple[Number, tuple[str, ...], tuple[int, ...]] | None = None
        for i, leg in enumerate(self.leg):
            if leg.state.motion in ("sliding", "rolling", "spinning"):
                time = leg.start + leg.lasts
                best = _earlier(best, (time, ("transition", self.world.ids[i]), (i,)))
            if leg.state.motion in ("sliding", "rolling"):
                for key, time in self._walls(i):
                    best = _earlier(best, (time, key, (i,)))
        n = len(self.leg)
        for i in range(n):
            for j in range(i + 1, n):
                time = self._contact(i, j, None if best is None else best[0])
                if time is not None:
                    names = sorted((self.world.ids[i], self.world.ids[j]))
                    best = _earlier(best, (time, ("ball-collision", *names), (i, j)))
        if best is None:
            return None
        self.time = best[0]
        return self._apply(best[1], best[2])

    # -- paths -----------------------------------------------------------------------------------

    def _leg(self, i: int, state: State) -> Leg:
        cloth, g = self.world.physics["cloth"], mpf(self.world.gravity)
        r = mpf(self.world.radius[i])
        v, w = state.velocity, state.spin
        decay = -mp.sign(w[2]) * mpf(cloth["spin_deceleration"])
        if state.motion == "sliding":
            u = (v[0] - r * w[1], v[1] + r * w[0])
            size = mp.hypot(*u)
            a = mpf(cloth["sliding_friction"]) * g
            e = (u[0] / size, u[1] / size)
            turn = (-e[1] * 5 * a / (2 * r), e[0] * 5 * a / (2 * r), decay)
            half = (-e[0] * a / 2, -e[1] * a / 2)
            return Leg(self.time, state, half, turn, 2 * size / (7 * a))
        if state.motion == "rolling":
            size = mp.hypot(v[0], v[1])
            a = mpf(cloth["rolling_friction"]) * g
            e = (v[0] / size, v[1] / size)
            turn = (e[1] * a / r, -e[0] * a / r, decay)
            return Leg(self.time, state, (-e[0] * a / 2, -e[1] * a / 2), turn, size / a)
        lasts = mp.inf
        if state.motion == "spinning":
            lasts = abs(w[2]) / mpf(cloth["spin_deceleration"])
        return Leg(self.time, state, (mpf(0), mpf(0)), (mpf(0), mpf(0), decay), lasts)

    def _at(self, i: int, time: Number) -> State:
        leg = self.leg[i]
        t, s = time - leg.start, leg.state
        x, v, w = s.position, s.velocity, s.spin
        wz = w[2] + leg.turn[2] * t
        if wz * w[2] <= 0:
            wz = mpf(0)
        return State(
            (x[0] + (v[0] + leg.half[0] * t) * t, x[1] + (v[1] + leg.half[1] * t) * t, x[2]),
            (v[0] + 2 * leg.half[0] * t, v[1] + 2 * leg.half[1] * t, mpf(0)),
            (w[0] + leg.turn[0] * t, w[1] + leg.turn[1] * t, wz),
            s.motion,
        )

    def _motion(self, i: int) -> tuple[State, tuple[Number, Number]]:
        """The path re-centred on the present time."""
        return self._at(i, self.time), self.leg[i].half

    # -- event times -----------------------------------------------------------------------------

    def _contact(self, i: int, j: int, before: Number | None) -> Number | None:
        """First contact of two balls: the first root of the quartic at which they approach."""
        (a, ha), (b, hb) = self._motion(i), self._motion(j)
        if not {a.motion, b.motion} & {"sliding", "rolling"}:
            return None
        if "pocketed" in (a.motion, b.motion):
            return None
        reach2 = 4 * mpf(self.world.radius[i]) * mpf(self.world.radius[j])
        d = [b.position[k] - a.position[k] for k in (0, 1)]
        v = [b.velocity[k] - a.velocity[k] for k in (0, 1)]
        h = [hb[k] - ha[k] for k in (0, 1)]
        c = [
            h[0] ** 2 + h[1] ** 2,
            2 * (v[0] * h[0] + v[1] * h[1]),
            v[0] ** 2 + v[1] ** 2 + 2 * (d[0] * h[0] + d[1] * h[1]),
            2 * (d[0] * v[0] + d[1] * v[1]),
            d[0] ** 2 + d[1] ** 2 - reach2,
        ]
        time = _first_approach(c)
        if time is None or (before is not None and self.time + time > before):
            return None
        return self.time + time

    def _walls(self, i: int) -> list[tuple[tuple[str, ...], Number]]:
        found = []
        state, half = self._motion(i)
        r, nose = mpf(self.world.radius[i]), mpf(self.world.nose_height)
        reach = mp.sqrt(r**2 - (nose - r) ** 2) if self.world.walls else mpf(0)
        for wall in self.world.walls:
            n = [mpf(k) for k in wall.inward]
            gap = sum((state.position[k] - mpf(wall.start[k])) * n[k] for k in (0, 1)) - reach
            rate = sum(state.velocity[k] * n[k] for k in (0, 1))
            bend = sum(half[k] * n[k] for k in (0, 1))
            time = _first_approach([bend, rate, gap])
            if time is not None:
                key = ("rail-collision", self.world.ids[i], wall.rail, wall.part)
                found.append((key, self.time + time))
        return found

    # -- what happens ----------------------------------------------------------------------------

    def _apply(self, key: tuple[str, ...], balls: tuple[int, ...]) -> Happening:
        before = tuple(self._at(i, self.time) for i in balls)
        i = balls[0]
        if key[0] == "transition":
            after = self._successor(i, before[0])
            key = ("motion-transition", key[1], before[0].motion, after.motion)
            self.leg[i] = self._leg(i, after)
        elif key[0] == "ball-collision":
            bodies = laws.collide(
                _exact_law(self.world.physics["ball_ball"]),
                self._body(i, before[0]), self._body(balls[1], before[1]), mp,
            )  # fmt: skip
            for k, s, body in zip(balls, before, bodies, strict=True):
                self._take(k, s, body)
        else:
            wall = next(w for w in self.world.walls if (w.rail, w.part) == key[2:])
            into = (-mpf(wall.inward[0]), -mpf(wall.inward[1]), mpf(0))
            law = _exact_law(self.world.physics["cushion"])
            nose = mpf(self.world.nose_height)
            self._take(i, before[0], laws.rebound(law, nose, self._body(i, before[0]), into, mp))
        after_states = tuple(self.leg[k].state for k in balls)
        names = tuple(self.world.ids[k] for k in balls)
        return Happening(self.time, key, names, before, after_states)

    def _successor(self, i: int, s: State) -> State:
        r, zero = mpf(self.world.radius[i]), mpf(0)
        wz = s.spin[2]
        if s.motion == "sliding":
            w = (-s.velocity[1] / r, s.velocity[0] / r, wz)
            return replace(s, spin=w, motion="rolling")
        rest = "stationary" if wz == 0 or s.motion == "spinning" else "spinning"
        spin = (zero, zero, wz if rest == "spinning" else zero)
        return replace(s, velocity=(zero, zero, zero), spin=spin, motion=rest)

    def _body(self, i: int, s: State) -> laws.Body:
        mass, radius = mpf(self.world.mass[i]), mpf(self.world.radius[i])
        return laws.Body(mass, radius, s.position, s.velocity, s.spin)

    def _take(self, i: int, s: State, body: laws.Body) -> None:
        motion = motion_of(body.velocity, body.spin, body.radius)
        state = replace(s, velocity=body.velocity, spin=body.spin, motion=motion)
        self.leg[i] = self._leg(i, state)


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


def _first_approach(c: Sequence[Number]) -> Number | None:
    """The first t ≥ 0 with f ≤ 0 and f′ < 0, f being given highest power first."""
    if c[-1] <= 0 and c[-2] < 0:
        return mpf(0)
    candidates = list(_real_roots(c))
    if c[-1] < 0:
        # A rounding inside: what turns back before it is clear meets where it turns.
        n = len(c) - 1
        candidates += _real_roots([k * (n - p) for p, k in enumerate(c[:-1])])
    for t in sorted(candidates):
        if t > NOW:
            f, g = _value(c, t)
            if g < 0 or (f < -NOW and g <= NOW):
                return t
    return None


def _real_roots(c: Sequence[Number]) -> list[Number]:
    c = list(c)
    while c and c[0] == 0:
        c.pop(0)
    if len(c) < 2:
        return []
    roots = polyroots(c[::-1], maxsteps=500, extraprec=400, asc=True)
    return [z.real for z in map(mp.mpc, roots) if abs(z.imag) < REAL * (1 + abs(z))]


def _earlier(a: Any, b: Any) -> Any:
    return b if a is None or b[0] < a[0] else a
