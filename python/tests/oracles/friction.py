"""Impacts with Coulomb friction at several contacts, integrated over the normal impulse.

Mathavan, Jackson & Parkin 2010 (a ball between cushion and cloth) and 2014 (two balls on the cloth)
are both of this kind. One contact has the normal impulse P, the independent variable. Each ball on
the cloth is held at its height: where the forces press it down, the cloth bears that load and acts
with friction. Compression ends where the approach speed is zero, and the impact where the normal
impulse has returned e² of the work that compression took (Stronge's energetic restitution).

Coulomb's law holds exactly: friction acts against the slip, and a contact without slip holds as
long as that needs at most μ times the load. Only an impact in which a contact slips again after it
held is not covered. The equations are built from the definitions (unit
impulses on rigid spheres) and not from the papers' components. They are integrated as Taylor series
with as many digits as are asked for. The time is stretched near the end of a slip, and each slip is
represented by its size and direction, so that the equations stay polynomials where a slip vanishes.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

from mpmath import findroot, mp, mpf

from oracles.series import Series, State, System, reciprocal

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

Number = Any
Vec = tuple[Number, Number, Number]
Pair = tuple[Number, Number]

#: Samples of each step at which a change of regime is looked for.
LOOKS = 8
#: Directions tried for a slip that begins.
DIRECTIONS = 180
#: The first step in a regime, in units of the smallest slip.
UNIT = mpf("0.05")
#: A slip may change by this factor before its unit is adapted, which costs as many digits.
WIDE, GUARD = 10**5, 6
#: The most steps of one impact; 40 to 150 are usual.
STEPS = 3000

FREE, SLIPS, HOLDS, STARTS = "free", "slips", "holds", "starts"


class NotCoveredError(ArithmeticError):
    """An impact that is not covered.

    A contact slips again after it held; or Coulomb's law gives several motions, or none, when a
    slip has ended; or both slips almost vanish at once.
    """


@dataclass(frozen=True)
class Ball:
    """A solid sphere; `axis` is the unit vector to the contact whose impulse is counted."""

    mass: Number
    radius: Number
    velocity: Vec
    spin: Vec
    axis: Vec


def squeeze(
    balls: Sequence[Ball], friction: Number, cloth: Number | None, e: Number, digits: int
) -> list[tuple[Vec, Vec]]:
    """Velocities and spins after the impact of a ball on a wall, or of two balls.

    `cloth` is its coefficient of friction, or None for balls that nothing holds down.
    """
    with mp.workprec(int(digits * 3.33) + 100):
        impact = _Impact(balls, mpf(friction), cloth, mpf(e), digits)
        return impact.play()


@dataclass
class _Response:
    """Changes by a unit impulse: of the balls, of the approach speed, and of the slips."""

    balls: list[tuple[Vec, Vec]]
    approach: Number
    slips: list[Pair]


@dataclass
class _Present:
    """The state between two steps: slips, impulses and work."""

    slips: list[Pair]
    size: list[Number]
    impulse: Number = field(default_factory=lambda: mpf(0))
    frictions: list[Pair] = field(default_factory=list)
    work: Number = field(default_factory=lambda: mpf(0))


class _Impact:
    """Contact 0 is the one whose normal impulse counts; contact 1 + k is ball k's on the cloth."""

    def __init__(
        self, balls: Sequence[Ball], friction: Number, cloth: Any, e: Number, digits: int
    ) -> None:
        self.balls, self.e, self.digits = list(balls), e, digits
        self.held = cloth is not None
        self.tiny = mpf(10) ** -(digits + 2)
        n = self.balls[0].axis
        level = mp.sqrt(n[0] ** 2 + n[1] ** 2)
        across = (-n[1] / level, n[0] / level, mpf(0)) if level else (mpf(1), mpf(0), mpf(0))
        self.normal = n
        self.tangents = (across, _cross(n, across))
        self.mu = [friction] + [mpf(cloth) if self.held else mpf(0)] * len(self.balls)
        self.contacts = 1 + (len(self.balls) if self.held else 0)
        self.push = self._response(self._at_contact(tuple(-c for c in n)))
        self.rub: list[tuple[_Response, _Response]] = [
            tuple(self._response(self._at_contact(t)) for t in self.tangents)  # type: ignore[misc]
        ]
        for k in range(self.contacts - 1):
            down = (mpf(0), mpf(0), mpf(-1))
            axes = ((mpf(1), mpf(0), mpf(0)), (mpf(0), mpf(1), mpf(0)))
            self.rub.append(
                tuple(self._response([(k, down, axis)]) for axis in axes)  # type: ignore[misc]
            )
        velocities = [(b.velocity, b.spin) for b in self.balls]
        self.scale, slips = self._measure(velocities)
        self.start = [(x / self.scale, y / self.scale) for x, y in slips]

    # -- the equations ---------------------------------------------------------------------------

    def _at_contact(self, force: Vec) -> list[tuple[int, Vec, Vec]]:
        """An impulse on the first ball at contact 0, and the opposite one on the second."""
        opposite = tuple(-c for c in force)
        both = [(0, self.balls[0].axis, force), (1, self.balls[-1].axis, opposite)]
        return both[: len(self.balls)]  # type: ignore[return-value]

    def _response(self, impulses: list[tuple[int, Vec, Vec]]) -> _Response:
        """The changes by impulses, each given by its ball, its point and itself."""
        zero = (mpf(0), mpf(0), mpf(0))
        change = [(zero, zero) for _ in self.balls]
        for k, towards, impulse in impulses:
            b = self.balls[k]
            inertia = 2 * b.mass * b.radius**2 / 5
            v = tuple(c / b.mass for c in impulse)
            w = tuple(b.radius * c / inertia for c in _cross(towards, impulse))
            if self.held:
                v = (v[0], v[1], mpf(0))
            change[k] = (v, w)  # type: ignore[assignment]
        return _Response(change, *self._measure(change))

    def _measure(self, moves: Sequence[tuple[Vec, Vec]]) -> tuple[Number, list[Pair]]:
        """The approach speed and the slips of balls with these velocities and spins."""
        surface = [
            _add(v, _cross(w, b.axis), b.radius)
            for (v, w), b in zip(moves, self.balls, strict=True)
        ]
        centre = moves[0][0]
        relative = surface[0]
        if len(moves) == 2:
            centre = _add(centre, moves[1][0], -1)
            relative = _add(relative, surface[1], -1)
        slips = [(_dot(relative, self.tangents[0]), _dot(relative, self.tangents[1]))]
        for (v, w), b in zip(moves, self.balls, strict=True):
            if self.held:
                slips.append((v[0] - b.radius * w[1], v[1] + b.radius * w[0]))
        return _dot(centre, self.normal), slips

    def load(self, k: int, rub: Pair) -> Number:
        """The load of ball k on the cloth, per normal impulse, under the friction at contact 0."""
        up = -self.normal[2] + rub[0] * self.tangents[0][2] + rub[1] * self.tangents[1][2]
        return -1 * up if k == 0 else up

    def rates(self, forces: Sequence[Pair]) -> list[Pair]:
        """The changes of all slips per normal impulse."""
        return [
            tuple(
                self.push.slips[i][c]
                + sum(
                    forces[j][d] * self.rub[j][d].slips[i][c]
                    for j in range(self.contacts)
                    for d in (0, 1)
                    if forces[j] is not None
                )
                for c in (0, 1)
            )
            for i in range(self.contacts)
        ]  # type: ignore[return-value]

    def forces(self, regimes: Sequence[str], way: Sequence[Pair | None]) -> list[Any]:
        """The friction per normal impulse at each contact; `way` is the direction of each slip.

        Works for numbers and for series.
        """
        found: list[Any] = [None] * self.contacts
        borne = next((k for k in range(1, self.contacts) if regimes[k] != FREE), None)
        if regimes[0] != HOLDS:
            u = way[0]
            assert u is not None
            found[0] = (-self.mu[0] * u[0], -self.mu[0] * u[1])
            if borne is not None and regimes[borne] == HOLDS:
                found[borne] = self._holding(borne, found)
        elif borne is not None and regimes[borne] == HOLDS:
            found[0], found[borne] = self._both_holding(borne)
        elif borne is not None:
            found[0] = self._holding_on_slip(borne, way[borne])
        else:
            found[0] = self._holding(0, found)
        if borne is not None and found[borne] is None:
            u = way[borne]
            assert u is not None
            most = self.load(borne - 1, found[0]) * -self.mu[borne]
            found[borne] = (most * u[0], most * u[1])
        return found

    def _drive(self, i: int, c: int, forces: Sequence[Any]) -> Any:
        """The change of one slip by the normal impulse and the known frictions."""
        total: Any = self.push.slips[i][c]
        for j in range(self.contacts):
            if forces[j] is not None:
                for d in (0, 1):
                    total = forces[j][d] * self.rub[j][d].slips[i][c] + total
        return total

    def _matrix(self, i: int, j: int) -> list[list[Number]]:
        """The changes of slip i by the frictions of contact j."""
        return [[self.rub[j][d].slips[i][c] for d in (0, 1)] for c in (0, 1)]

    def _holding(self, i: int, forces: Sequence[Any]) -> Pair:
        """The friction that keeps contact i without slip, if the others are known or absent."""
        return _solve(self._matrix(i, i), [-1 * self._drive(i, c, forces) for c in (0, 1)])

    def _both_holding(self, i: int) -> tuple[Pair, Pair]:
        rows = [
            [self.rub[j][d].slips[a][c] for j in (0, i) for d in (0, 1)]
            for a in (0, i)
            for c in (0, 1)
        ]
        drive = [-self.push.slips[a][c] for a in (0, i) for c in (0, 1)]
        x = mp.lu_solve(mp.matrix(rows), mp.matrix(drive))
        return (x[0], x[1]), (x[2], x[3])

    def _holding_on_slip(self, i: int, u: Any) -> Pair:
        """The friction that keeps contact 0 without slip while ball i slips on the cloth."""
        sign = 1 if i == 1 else -1
        lever = [-sign * self.tangents[d][2] for d in (0, 1)]
        bare = sign * self.normal[2]
        own, other = self._matrix(0, 0), self._matrix(0, i)
        # The cloth's friction is −μ (bare + lever·f) u.
        pull = [(other[c][0] * u[0] + other[c][1] * u[1]) * -self.mu[i] for c in (0, 1)]
        m = [[pull[c] * lever[d] + own[c][d] for d in (0, 1)] for c in (0, 1)]
        return _solve(m, [(pull[c] * bare + self.push.slips[0][c]) * -1 for c in (0, 1)])

    # -- regimes ---------------------------------------------------------------------------------

    def _settle(self, now: _Present) -> tuple[str, ...]:
        """The regimes at the start, or after a slip has ended. Sets a slip that begins."""
        way = [_unit(s) if r > 0 else None for s, r in zip(now.slips, now.size, strict=True)]
        for kind in (HOLDS, STARTS):
            found = {}
            for regimes in self._candidates(way, kind):
                for direction in self._consistent(regimes, way):
                    found[regimes] = direction
            if len(found) > 1:
                raise NotCoveredError(f"several motions: {sorted(found)}")
            for regimes, direction in found.items():
                if STARTS in regimes:
                    i = regimes.index(STARTS)
                    now.size[i], now.slips[i] = 2 * self.tiny, direction
                return tuple(SLIPS if r == STARTS else r for r in regimes)
        raise NotCoveredError("no motion")

    def _candidates(self, way: Sequence[Pair | None], kind: str) -> Iterator[tuple[str, ...]]:
        for borne in range(self.contacts):
            choices: list[tuple[str, ...]] = []
            for i in range(self.contacts):
                if i not in (0, borne):
                    choices.append((FREE,))
                elif way[i] is not None:
                    choices.append((SLIPS,))
                elif kind == HOLDS:
                    choices.append((HOLDS,))
                else:
                    choices.append((STARTS, HOLDS))
            for regimes in itertools.product(*choices):
                if kind == HOLDS or regimes.count(STARTS) == 1:
                    yield regimes

    def _consistent(
        self, regimes: tuple[str, ...], way: Sequence[Pair | None]
    ) -> Iterator[Pair | None]:
        """Yields the direction of the slip that begins (None if none does), if all laws hold."""
        if STARTS not in regimes:
            if self._holds(regimes, self.forces(regimes, way)):
                yield None
            return
        i = regimes.index(STARTS)

        def turning(angle: Number) -> tuple[Number, Number, list[Any]]:
            u = (mp.cos(angle), mp.sin(angle))
            forces = self.forces(regimes, [u if k == i else w for k, w in enumerate(way)])
            x, y = self.rates(forces)[i]
            return u[0] * y - u[1] * x, u[0] * x + u[1] * y, forces

        with mp.workprec(53):
            angles = [2 * mp.pi * k / DIRECTIONS for k in range(DIRECTIONS + 1)]
            values = [turning(a) for a in angles]
        for k in range(DIRECTIONS):
            if values[k][0] * values[k + 1][0] < 0 and values[k][1] > 0:
                bracket = (angles[k], angles[k + 1])
                angle = findroot(lambda a: turning(a)[0], bracket, solver="anderson")
                _, grows, forces = turning(angle)
                if grows > 0 and self._holds(regimes, forces):
                    yield (mp.cos(angle), mp.sin(angle))

    def _holds(self, regimes: Sequence[str], forces: Sequence[Any]) -> bool:
        """Whether loads and held frictions are within their limits.

        A ball without load is free.
        """
        least = {(i, "load"): self.tiny for i, r in enumerate(regimes) if r != FREE}
        margins = self._margins(regimes, forces)
        return all(value > least.get(key, -self.tiny) for key, value in margins.items())

    def _margins(self, regimes: Sequence[str], forces: Sequence[Any]) -> dict[tuple[int, str], Any]:
        """Quantities that are positive while the regimes last; numbers or series."""
        found: dict[tuple[int, str], Any] = {}
        for i, regime in enumerate(regimes):
            load = self.load(i - 1, forces[0]) if i else mpf(1)
            if i:
                found[i, "load"] = load * -1 if regime == FREE else load
            if regime == HOLDS:
                most = load * self.mu[i]
                fx, fy = forces[i]
                found[i, "hold"] = most * most - (fx * fx + fy * fy)
        return found

    # -- integration -----------------------------------------------------------------------------

    def play(self) -> list[tuple[Vec, Vec]]:
        zero = mpf(0)
        size = [mp.hypot(*s) for s in self.start]
        slips = [
            _unit(s) if r > self.tiny else (zero, zero)
            for s, r in zip(self.start, size, strict=True)
        ]
        size = [r if r > self.tiny else zero for r in size]
        now = _Present(slips, size, frictions=[(zero, zero)] * self.contacts)
        regimes = self._settle(now)
        kept = None
        stretch = _Stretch(self, now, regimes, UNIT)
        for _ in range(STEPS):
            approach = self._approach(now)
            if kept is None and approach <= self.tiny:
                kept = now.work * (1 - self.e**2)
            if kept is not None and now.work - kept <= self.tiny:
                return self._result(now)
            event = stretch.step(kept)
            if event is not None:
                regimes = self._change(now, regimes, event)
                stretch = _Stretch(self, now, regimes, UNIT)
            elif stretch.is_out_of_scale():
                stretch = _Stretch(self, now, regimes, stretch.system.unit)
        raise NotCoveredError("too many steps")

    def _approach(self, now: _Present) -> Number:
        total = 1 + now.impulse * self.push.approach
        for pair, rub in zip(now.frictions, self.rub, strict=True):
            total += pair[0] * rub[0].approach + pair[1] * rub[1].approach
        return total

    def _change(
        self, now: _Present, regimes: tuple[str, ...], event: tuple[int, str]
    ) -> tuple[str, ...]:
        i, kind = event
        if kind == "slip":
            now.size[i], now.slips[i] = mpf(0), (mpf(0), mpf(0))
            return self._settle(now)
        if kind == "hold":
            raise NotCoveredError("a contact slips again")
        # A load begins or ends; the slip is small enough to hold, or it slips.
        changed = list(regimes)
        if regimes[i] != FREE:
            changed[i] = FREE
            return tuple(changed)
        if now.size[i] > self.tiny:
            changed[i] = SLIPS
            return tuple(changed)
        raise NotCoveredError("a load on a contact without slip")

    def _result(self, now: _Present) -> list[tuple[Vec, Vec]]:
        total = []
        for k, ball in enumerate(self.balls):
            v, w = ball.velocity, ball.spin
            terms = [(self.push, now.impulse)]
            for pair, rub in zip(now.frictions, self.rub, strict=True):
                terms += [(rub[0], pair[0]), (rub[1], pair[1])]
            for response, amount in terms:
                dv, dw = response.balls[k]
                v, w = _add(v, dv, amount * self.scale), _add(w, dw, amount * self.scale)
            total.append((v, w))
        return total


class _Stretch:
    """The equations in one regime."""

    def __init__(
        self, impact: _Impact, now: _Present, regimes: tuple[str, ...], unit: Number
    ) -> None:
        self.impact, self.now, self.regimes = impact, now, regimes
        system = self.system = System(impact.digits + GUARD)
        n = impact.contacts
        slips = [i for i in range(n) if regimes[i] == SLIPS]
        # Sizes of the slips, divided by those at the start.
        self.scale = list(now.size)
        self.size: dict[int, State] = {i: system.state(mpf(1)) for i in slips}
        self.way: list[Any] = [None] * n
        for i in slips:
            self.way[i] = (system.state(now.slips[i][0]), system.state(now.slips[i][1]))
        self.moves: dict[int, tuple[State, State]] = {}
        for i in range(n):
            if regimes[i] == FREE:
                x, y = (c * now.size[i] for c in now.slips[i])
                self.moves[i] = (system.state(x), system.state(y))
        forces = impact.forces(regimes, self.way)
        # The impulse per unit of the stretched time is the product of all sizes, so that a slip
        # ends only after an infinite time.
        self.least = min((now.size[i] for i in slips), default=mpf(1))
        system.unit = unit
        pace: Any = self.least
        for i in slips:
            pace = self.size[i] * pace
        rates = impact.rates(forces)
        for i in slips:
            u, (x, y) = self.way[i], rates[i]
            others: Any = self.least / now.size[i]
            for j in slips:
                if j != i:
                    others = self.size[j] * others
            growth = u[0] * x + u[1] * y
            u[0].rate = self._series(others * (x - growth * u[0]))
            u[1].rate = self._series(others * (y - growth * u[1]))
            self.size[i].rate = self._series(self.size[i] * (others * growth))
        for i, (a, b) in self.moves.items():
            a.rate, b.rate = (self._series(pace * r) for r in rates[i])
        self.impulse = system.state(now.impulse)
        self.impulse.rate = self._series(pace)
        self.frictions: list[tuple[State, State] | None] = [None] * n
        approach: Any = self.impulse * impact.push.approach + 1
        for i in range(n):
            given = now.frictions[i]
            states = None
            if forces[i] is not None:
                states = (system.state(given[0]), system.state(given[1]))
                for state, force in zip(states, forces[i], strict=True):
                    state.rate = self._series(pace * force)
                self.frictions[i] = states
            for d in (0, 1):
                amount = given[d] if states is None else states[d]
                approach = amount * impact.rub[i][d].approach + approach
        self.work = system.state(now.work)
        self.work.rate = self._series(pace * approach)
        self.approach = self._series(approach)
        self.margins = {
            key: margin
            for key, margin in impact._margins(regimes, forces).items()
            if isinstance(margin, Series)
        }
        system.close([self.approach, *self.margins.values()])

    def _series(self, x: Any) -> Any:
        """A series, also of a number."""
        return x if isinstance(x, Series) else self.system.constant(x)

    def step(self, kept: Number | None) -> tuple[int, str] | None:
        """Advances by one step, or until an event or the end of the phase. Returns the event."""
        system, now = self.system, self.now
        length = system.expand()
        watched: dict[Any, Callable[[Number], Number]] = {
            key: partial(system.at, margin) for key, margin in self.margins.items()
        }
        if kept is None:
            watched["phase"] = lambda t: system.at(self.approach, t)
        else:
            watched["phase"] = lambda t: system.at(self.work, t) - kept
        first, event = length, None
        for key, value in watched.items():
            end = self._first_fall(value, first)
            if end is not None:
                first, event = end, key
        system.advance(first)
        self._store()
        if event in (None, "phase"):
            ended = [i for i in self.size if now.size[i] < self.impact.tiny]
            return (ended[0], "slip") if ended else None
        return event

    def _first_fall(self, value: Callable[[Number], Number], length: Number) -> Number | None:
        """The first time in a step at which a value falls below 0."""
        before = mpf(0)
        for k in range(1, LOOKS + 1):
            t = length * k / LOOKS
            if value(t) < 0:
                if value(before) <= 0:
                    return before
                return findroot(value, (before, t), solver="anderson", tol=self.impact.tiny)
            before = t
        return None

    def is_out_of_scale(self) -> bool:
        """Whether a slip has changed so much that fixed-point numbers lose digits of it."""
        sizes = [self.system.number(size.value) for size in self.size.values()]
        return any(not 1 / WIDE < size < WIDE for size in sizes)

    def _store(self) -> None:
        number, now = self.system.number, self.now
        for i, size in self.size.items():
            now.size[i] = number(size.value) * self.scale[i]
            # The length of the direction is unstable while the slip shrinks.
            way = _unit((number(self.way[i][0].value), number(self.way[i][1].value)))
            now.slips[i] = way
            for state, value in zip(self.way[i], way, strict=True):
                state.value = self.system.fixed(value)
        for i, pair in self.moves.items():
            x, y = (number(s.value) for s in pair)
            now.size[i] = mp.hypot(x, y)
            now.slips[i] = _unit((x, y)) if now.size[i] > 0 else (x, y)
        now.impulse, now.work = number(self.impulse.value), number(self.work.value)
        for i, states in enumerate(self.frictions):
            if states is not None:
                now.frictions[i] = (number(states[0].value), number(states[1].value))


def _solve(m: Any, r: Any) -> Pair:
    """The solution of two linear equations, in numbers or series."""
    scale = reciprocal(m[0][0] * m[1][1] - m[0][1] * m[1][0])
    return (
        (r[0] * m[1][1] - r[1] * m[0][1]) * scale,
        (r[1] * m[0][0] - r[0] * m[1][0]) * scale,
    )


def _unit(s: Pair) -> Pair:
    size = mp.hypot(*s)
    return (s[0] / size, s[1] / size)


def _dot(a: Vec, b: Vec) -> Number:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vec, b: Vec) -> Vec:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _add(a: Vec, b: Vec, k: Number = 1) -> Vec:
    return (a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2])
