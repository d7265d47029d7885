"""Oracle A: the force laws, integrated through time (Dormand–Prince of order 8).

Knows no closed form: friction is a force against the slip at this instant, a rolling ball is held
by its constraint, and events are found where a gap, a slip or a spin falls through zero.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar

from oracles import laws
from oracles.world import Happening, State, World, motion_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

Array = Any

#: Error per step that the integrator may make, relative and absolute (m, m/s, rad/s).
RELATIVE, ABSOLUTE = 1e-13, 1e-14
#: Longest step, s, and into how many parts it is looked at. At 10 m/s a ball moves 1 cm between
#: looks, and what dips below zero between two looks is searched for.
STEP, LOOKS = 0.008, 8
#: Gap below which two bodies touch, m.
TOUCH = 1e-10


@dataclass(frozen=True)
class Watch:
    """Something that happens where `value` falls through zero."""

    key: tuple[str, ...]
    balls: tuple[int, ...]
    value: Callable[[Array], Array]  # of states (7, n) or (7, n, looks)
    rate: Callable[[Array], float] | None  # for contacts: d(value)/dt, to tell parting from meeting


class Stepping:
    """A shot, advanced event by event from given states."""

    def __init__(self, world: World, states: Sequence[State], time: float = 0.0) -> None:
        self.world = world
        self.time = time
        n = len(world.ids)
        self.y = np.zeros((7, n))
        self.motion = [""] * n
        self.radius = np.array(world.radius)
        for i, state in enumerate(states):
            self.replace(i, state)

    def replace(self, i: int, state: State) -> None:
        """Sets ball `i` at the present time."""
        self.y[:, i] = [*state.position[:2], *state.velocity[:2], *state.spin]
        self.motion[i] = state.motion

    def state(self, i: int) -> State:
        x, y, vx, vy, wx, wy, wz = (float(c) for c in self.y[:, i])
        return State((x, y, self.world.radius[i]), (vx, vy, 0.0), (wx, wy, wz), self.motion[i])

    def next(self) -> Happening | None:
        """Advances to the next event and applies it; None when all is at rest."""
        while True:
            watches = self._watches()
            if not watches:
                return None
            found = self._immediate(watches) or self._search(watches)
            happening = self._apply(found)
            if happening is not None:
                return happening

    # -- force laws ------------------------------------------------------------------------------

    def _forces(self) -> Callable[[float, Array], Array]:
        cloth, g = self.world.physics["cloth"], self.world.gravity
        r = self.radius
        sliding = np.array([m == "sliding" for m in self.motion])
        rolling = np.array([m == "rolling" for m in self.motion])
        in_play = np.array([m not in ("pocketed", "off-table") for m in self.motion])
        u0 = _slip(self.y, r)
        v0 = self.y[2:4].copy()
        spin_sign = np.sign(self.y[6]) * in_play

        def rates(_: float, flat: Array) -> Array:
            y = flat.reshape(7, -1)
            d = np.zeros_like(y)
            d[0:2] = y[2:4] * (sliding | rolling)
            # Past the instant at which slip or speed vanishes the force goes on as it was, so that
            # the integrator may step over that instant, which is then found as a root.
            u = _unit(_slip(y, r), u0)
            force = -cloth["sliding_friction"] * g * u * sliding
            d[2:4] += force
            d[4] += sliding * force[1] * 5 / (2 * r)
            d[5] -= sliding * force[0] * 5 / (2 * r)
            drag = -cloth["rolling_friction"] * g * _unit(y[2:4], v0) * rolling
            d[2:4] += drag
            d[4] += -drag[1] / r
            d[5] += drag[0] / r
            d[6] = -cloth["spin_deceleration"] * spin_sign
            return d.ravel()

        return rates

    # -- what can happen -------------------------------------------------------------------------

    def _watches(self) -> list[Watch]:
        found: list[Watch] = []
        ids, r = self.world.ids, self.radius
        alive = [m not in ("pocketed", "off-table") for m in self.motion]
        moving = [m in ("sliding", "rolling") for m in self.motion]
        for i, motion in enumerate(self.motion):
            if motion == "sliding":
                u0 = _slip(self.y, r)[:, i].copy()
                found.append(Watch(("slide", ids[i]), (i,), _along(u0, r, i, slip=True), None))
            elif motion == "rolling":
                v0 = self.y[2:4, i].copy()
                found.append(Watch(("roll", ids[i]), (i,), _along(v0, r, i, slip=False), None))
            if alive[i] and self.y[6, i] != 0.0:
                sign = np.sign(self.y[6, i])
                found.append(
                    Watch(("spin", ids[i]), (i,), lambda y, i=i, s=sign: s * y[6, i], None)
                )
            if moving[i]:
                found += self._features(i)
        n = len(ids)
        found += [
            self._pair(i, j)
            for i in range(n)
            for j in range(i + 1, n)
            if alive[i] and alive[j] and (moving[i] or moving[j])
        ]
        return found

    def _pair(self, i: int, j: int) -> Watch:
        reach = 2.0 * np.sqrt(self.radius[i] * self.radius[j])

        def gap(y: Array) -> Array:
            return np.hypot(y[0, j] - y[0, i], y[1, j] - y[1, i]) - reach

        def rate(y: Array) -> float:
            d, v = y[0:2, j] - y[0:2, i], y[2:4, j] - y[2:4, i]
            return float(d @ v / np.hypot(*d))

        names = sorted((self.world.ids[i], self.world.ids[j]))
        return Watch(("ball-collision", *names), (i, j), gap, rate)

    def _features(self, i: int) -> list[Watch]:
        world, name = self.world, self.world.ids[i]
        found: list[Watch] = []
        reach = np.sqrt(self.radius[i] ** 2 - (world.nose_height - self.radius[i]) ** 2)
        for wall in world.walls:
            a, n = np.array(wall.start), np.array(wall.inward)
            t = np.array(wall.end) - a
            length = np.hypot(*t)
            t = t / length

            def gap(y: Array, a: Array = a, n: Array = n) -> Array:
                return (y[0, i] - a[0]) * n[0] + (y[1, i] - a[1]) * n[1] - reach

            def reaching(
                y: Array, gap: Any = gap, a: Array = a, t: Array = t, length: float = length
            ) -> Array:
                s = (y[0, i] - a[0]) * t[0] + (y[1, i] - a[1]) * t[1]
                # Beside the wall's ends nothing is met.
                return np.where((s >= 0) & (s <= length), gap(y), np.abs(gap(y)) + 1.0)

            def rate(y: Array, n: Array = n) -> float:
                return float(y[2:4, i] @ n)

            key = ("rail-collision", name, wall.rail, wall.part)
            found.append(Watch(key, (i,), reaching, rate))
        round_ = [(("rail-collision", name, p.rail, p.part), p, reach) for p in world.posts]
        round_ += [(("pocket-collision", name, h.name), h, 0.0) for h in world.holes]
        return found + [self._round(i, *feature) for feature in round_]

    def _round(self, i: int, key: tuple[str, ...], round_: Any, reach: float) -> Watch:
        c, r = round_.center, round_.radius + reach

        def gap(y: Array) -> Array:
            return np.hypot(y[0, i] - c[0], y[1, i] - c[1]) - r

        def rate(y: Array) -> float:
            d = y[0:2, i] - np.array(c)
            return float(d @ y[2:4, i] / np.hypot(*d))

        return Watch(key, (i,), gap, rate)

    # -- search ----------------------------------------------------------------------------------

    def _immediate(self, watches: list[Watch]) -> Watch | None:
        for w in watches:
            if w.rate is not None and abs(w.value(self.y)) <= TOUCH and w.rate(self.y) < -1e-12:
                return w
        return None

    def _search(self, watches: list[Watch]) -> Watch:
        """Integrates to the first instant at which a watched value falls through zero."""
        shape = self.y.shape
        solver = DOP853(
            self._forces(), self.time, self.y.ravel(), np.inf,
            rtol=RELATIVE, atol=ABSOLUTE, max_step=STEP, first_step=1e-4,
        )  # fmt: skip
        touching = [w.rate is not None and abs(w.value(self.y)) <= TOUCH for w in watches]
        while True:
            message = solver.step()
            if solver.status == "failed":
                raise RuntimeError(message)
            dense = solver.dense_output()
            times = np.linspace(solver.t_old, solver.t, LOOKS + 1)
            looks = dense(times).reshape(*shape, LOOKS + 1)
            first: tuple[float, Watch] | None = None
            for k, w in enumerate(watches):
                values = np.array(w.value(looks))
                if touching[k]:
                    # Just touched, and parting: it counts again once it is clear.
                    values[0] = TOUCH
                    touching[k] = False
                time = _first_fall(w, values, times, dense, shape)
                if time is not None and (first is None or time < first[0]):
                    first = (time, w)
            if first is not None:
                self.time = first[0]
                self.y = dense(first[0]).reshape(shape)
                return first[1]

    # -- what happens ----------------------------------------------------------------------------

    def _apply(self, watch: Watch) -> Happening | None:
        kind, i = watch.key[0], watch.balls[0]
        before = tuple(self.state(k) for k in watch.balls)
        key = watch.key
        if kind in ("slide", "roll", "spin"):
            was = self.motion[i]
            self._transition(kind, i)
            if kind == "spin" and was != "spinning":
                return None
            key = ("motion-transition", watch.key[1], was, self.motion[i])
        elif kind == "ball-collision":
            j = watch.balls[1]
            bodies = laws.collide(self.world.physics["ball_ball"], self._body(i), self._body(j))
            for k, body in zip((i, j), bodies, strict=True):
                self._take(k, body)
        elif kind == "rail-collision":
            self._take(i, self._rebound(i, key))
        else:
            self.motion[i] = "pocketed"
            self.y[2:, i] = 0.0
        after = tuple(self.state(k) for k in watch.balls)
        names = tuple(self.world.ids[k] for k in watch.balls)
        return Happening(self.time, key, names, before, after)

    def _transition(self, kind: str, i: int) -> None:
        y = self.y
        if kind == "spin":
            y[6, i] = 0.0
            if self.motion[i] == "spinning":
                self.motion[i] = "stationary"
            return
        if kind == "slide":
            y[4, i], y[5, i] = -y[3, i] / self.radius[i], y[2, i] / self.radius[i]
            self.motion[i] = "rolling"
            return
        y[2:6, i] = 0.0
        self.motion[i] = "stationary" if y[6, i] == 0.0 else "spinning"

    def _rebound(self, i: int, key: tuple[str, ...]) -> laws.Body:
        """Off the piece of this rail and part that the ball touches; a rail has two points."""
        world, here = self.world, self.y[0:2, i]
        reach = np.sqrt(self.radius[i] ** 2 - (world.nose_height - self.radius[i]) ** 2)
        candidates: list[tuple[float, Array]] = []
        for wall in world.walls:
            if (wall.rail, wall.part) == key[2:]:
                a, b, n = (np.array(p) for p in (wall.start, wall.end, wall.inward))
                beside = max(0.0, (a - here) @ (b - a), (here - b) @ (b - a))
                candidates.append((abs((here - a) @ n - reach) + beside, -n))
        for post in world.posts:
            if (post.rail, post.part) == key[2:]:
                d = np.array(post.center) - here
                distance = np.hypot(*d)
                candidates.append((abs(distance - post.radius - reach), d / distance))
        into = min(candidates, key=lambda c: c[0])[1]
        law = world.physics["cushion"]
        return laws.rebound(law, world.nose_height, self._body(i), (*into.tolist(), 0.0))

    def _body(self, i: int) -> laws.Body:
        s = self.state(i)
        return laws.Body(self.world.mass[i], self.world.radius[i], s.position, s.velocity, s.spin)

    def _take(self, i: int, body: laws.Body) -> None:
        motion = motion_of(body.velocity, body.spin, body.radius)
        self.replace(
            i, replace(self.state(i), velocity=body.velocity, spin=body.spin, motion=motion)
        )


def _slip(y: Array, r: Array) -> Array:
    return np.stack((y[2] - r * y[5], y[3] + r * y[4]))


def _unit(v: Array, before: Array) -> Array:
    """v/|v|, turned round where v points against `before`; 0 where v is 0."""
    size = np.hypot(v[0], v[1])
    size = np.where(size == 0.0, 1.0, size)
    return v / size * np.where((v * before).sum(axis=0) < 0.0, -1.0, 1.0)


def _along(v0: Array, r: Array, i: int, slip: bool) -> Callable[[Array], Array]:
    """The part of slip or velocity along what it was at first."""
    n = v0 / np.hypot(*v0)

    def value(y: Array) -> Array:
        if slip:
            return n[0] * (y[2, i] - r[i] * y[5, i]) + n[1] * (y[3, i] + r[i] * y[4, i])
        return n[0] * y[2, i] + n[1] * y[3, i]

    return value


def _first_fall(
    watch: Watch, values: Array, times: Array, dense: Any, shape: tuple[int, int]
) -> float | None:
    """The first time in the step at which the value falls through zero."""

    def at(t: float) -> float:
        return float(watch.value(dense(t).reshape(shape)))

    for k in range(len(times) - 1):
        if values[k] > 0.0 >= values[k + 1]:
            low = times[k]
            # A body that has just parted from this one starts inside by a rounding.
            while at(low) <= 0.0:
                low += 0.01 * (times[k + 1] - low)
                if times[k + 1] - low < 1e-12:
                    return None
            return float(brentq(at, low, times[k + 1], xtol=1e-16, rtol=8.9e-16))
        if watch.rate is None or k == 0:
            continue
        dips = values[k] < values[k - 1] and values[k] < values[k + 1]
        if dips and 0.0 < values[k] < 0.05:
            bounds = (times[k - 1], times[k + 1])
            lowest = minimize_scalar(at, bounds=bounds, method="bounded", options={"xatol": 1e-12})
            if lowest.fun < 0.0:
                return float(brentq(at, bounds[0], lowest.x, xtol=1e-16, rtol=8.9e-16))
    return None
