"""Oracle A: the force laws, integrated through time (Dormand–Prince of order 8).

It uses no closed form. Friction is a force against the present slip, a rolling ball obeys its
constraint, and a flying ball falls. Events are the times when a gap, a slip or a spin falls through
zero.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar

from oracles import laws, rolling
from oracles.places import CLEAR, Circle, Place, edges_of, from_center, inside, on_top, places_of
from oracles.world import Happening, Hole, State, World, motion_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

Array = Any

#: Tolerances of the integrator per step, relative and absolute (m, m/s, rad/s).
RELATIVE, ABSOLUTE = 1e-13, 1e-14
#: Longest step, s, and number of samples of each step. At 10 m/s a ball moves 1 cm between two
#: samples; a value that may dip below zero between two samples is minimised.
STEP, LOOKS = 0.008, 8
#: Only values below this, m, are minimised.
NEAR = 0.05
#: Bodies with a smaller gap than this, m, touch.
TOUCH = 1e-10
#: Touching bodies collide if they approach faster than this, m/s.
PARTED = 1e-12
#: Rates below this, m/s, are rounding errors where a ball passes level over an edge.
LEVEL = 1e-9
#: Time after which such a ball is checked for approach, s; it falls 50 nm in it.
SOON = 1e-4

#: Signs of the angular velocities about y and x in the velocity of a ball's lowest point.
BELOW = np.array(((-1.0,), (1.0,)))

ON_CLOTH = ("sliding", "rolling", "spinning", "stationary")


@dataclass(frozen=True)
class Watch:
    """A possible event: it happens when `value` falls through zero."""

    key: tuple[str, ...]
    balls: tuple[int, ...]
    value: Callable[[Array], Array]  # of states (9, n) or (9, n, looks)
    contact: bool = False
    place: Place | None = None
    #: As in `Place`; the value of a ball outside it is at least the ball's distance from it.
    circle: Circle | None = None


class Stepping:
    """A shot that is advanced event by event from given states."""

    def __init__(self, world: World, states: Sequence[State], time: float = 0.0) -> None:
        self.world = world
        self.time = time
        n = len(world.ids)
        #: Positions, velocities and spins; one column per ball.
        self.y = np.zeros((9, n))
        self.motion = [""] * n
        #: The speeds at which the rolling balls' bands of rolling resistance end, m/s.
        self.low = [0.0] * n
        #: Number of collisions of two balls so far.
        self.met = 0
        self.radius = np.array(world.radius)
        self.places = [places_of(world, r) for r in world.radius]
        self.edges = [edges_of(world, r) for r in world.radius]
        for i, state in enumerate(states):
            self.replace(i, state)

    def replace(self, i: int, state: State) -> None:
        """Sets ball `i` at the present time."""
        self.y[:, i] = [*state.position, *state.velocity, *state.spin]
        self.motion[i] = state.motion

    def state(self, i: int) -> State:
        x, y, z, vx, vy, vz, wx, wy, wz = (float(c) for c in self.y[:, i])
        return State((x, y, z), (vx, vy, vz), (wx, wy, wz), self.motion[i])

    def next(self) -> Happening | None:
        """Advances to the next event and applies it; None when all balls are at rest."""
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
        in_roll = np.array([m == "rolling" for m in self.motion])
        flying = np.array([m == "airborne" for m in self.motion])
        slides, rolls = sliding.any(), in_roll.any()
        on_cloth = np.array([m in ON_CLOTH for m in self.motion])
        u0 = _slip(self.y, r)
        v0 = self.y[3:5].copy()
        bands = [rolling.band(cloth, speed) for speed in np.hypot(*v0)]
        drags = np.array([friction for friction, _ in bands]) * g * in_roll
        spin_sign = np.sign(self.y[8]) * on_cloth

        def rates(_: float, flat: Array) -> Array:
            y = flat.reshape(9, -1)
            d = np.zeros_like(y)
            d[0:2] = y[3:5] * (sliding | in_roll | flying)
            d[2] = y[5] * flying
            d[5] = -g * flying
            # The force continues unchanged after slip or speed vanishes, so that the integrator can
            # step over that instant, which is then found as a root.
            if slides:
                force = -cloth["sliding_friction"] * g * _unit(_slip(y, r), u0) * sliding
                d[3:5] += force
                d[6] += force[1] * 5 / (2 * r)
                d[7] -= force[0] * 5 / (2 * r)
            if rolls:
                drag = -drags * _unit(y[3:5], v0)
                d[3:5] += drag
                d[6] += -drag[1] / r
                d[7] += drag[0] / r
            d[8] = -cloth["spin_deceleration"] * spin_sign
            return d.ravel()

        return rates

    # -- what can happen -------------------------------------------------------------------------

    def _watches(self) -> list[Watch]:
        found: list[Watch] = []
        ids, r = self.world.ids, self.radius
        alive = [m not in ("pocketed", "off-table") for m in self.motion]
        moving = [m in ("sliding", "rolling", "airborne") for m in self.motion]
        for i, motion in enumerate(self.motion):
            if motion == "stationary" and self._is_on_top(i):
                # A ball cannot rest on a rail.
                return [Watch(("off-table", ids[i]), (i,), lambda y: np.asarray(-1.0))]
            if motion == "sliding":
                u0 = _slip(self.y, r)[:, i].copy()
                found.append(Watch(("slide", ids[i]), (i,), _along(u0, r, i, slip=True)))
            elif motion == "rolling":
                v0 = self.y[3:5, i].copy()
                self.low[i] = rolling.band(self.world.physics["cloth"], np.hypot(*v0))[1]
                value = _along(v0, r, i, slip=False, end=self.low[i])
                found.append(Watch(("roll", ids[i]), (i,), value))
            if motion in ON_CLOTH and self.y[8, i] != 0.0:
                sign = np.sign(self.y[8, i])
                found.append(Watch(("spin", ids[i]), (i,), lambda y, i=i, s=sign: s * y[8, i]))
            if motion == "airborne":
                found += [self._meets(i, place) for place in self.places[i]]
                found += self._fates(i)
            elif moving[i] and self._is_on_top(i):
                found += self._ends_of_the_top(i)
            elif moving[i]:
                found += [self._meets(i, place) for place in self.edges[i]]
                found += [self._comes_over(i, hole) for hole in self.world.holes]
        n = len(ids)
        found += [
            self._pair(i, j)
            for i in range(n)
            for j in range(i + 1, n)
            if alive[i] and alive[j] and (moving[i] or moving[j])
        ]
        return found

    def _pair(self, i: int, j: int) -> Watch:
        reach = self.radius[i] + self.radius[j]

        def gap(y: Array) -> Array:
            d = y[0:3, j] - y[0:3, i]
            return np.sqrt((d * d).sum(axis=0)) - reach

        names = sorted((self.world.ids[i], self.world.ids[j]))
        return Watch(("ball-collision", *names), (i, j), gap, contact=True)

    def _meets(self, i: int, place: Place) -> Watch:
        key = (place.key[0], self.world.ids[i], *place.key[1:])
        if place.key[0] == "slate-collision":
            key = key[:2]
        return Watch(key, (i,), lambda y: place.gap(y[0:3, i]), True, place, place.circle)

    def _comes_over(self, i: int, hole: Hole) -> Watch:
        def distance(y: Array) -> Array:
            return from_center(y[0:2, i], hole) - hole.radius

        key = ("tips", self.world.ids[i])
        return Watch(key, (i,), distance, circle=(hole.center, hole.radius))

    def _is_on_top(self, i: int) -> bool:
        return bool(self.y[2, i] > self.radius[i] + self.world.nose_height / 2)

    def _ends_of_the_top(self, i: int) -> list[Watch]:
        """The events of a ball on a rail's top: it reaches the edge or the table's border."""
        outline = self.world.inside

        def from_edge(y: Array) -> Array:
            """Distance to the nearest straight piece of the edges' line; negative inside it."""
            p = y[0:2, i]
            nearest = np.full(np.shape(p[0]), np.inf)
            a = np.array(outline[-1])
            for b in map(np.array, outline):
                t = b - a
                size = t @ t
                if size > 0.0:
                    s = np.clip(((p[0] - a[0]) * t[0] + (p[1] - a[1]) * t[1]) / size, 0.0, 1.0)
                    off = np.hypot(p[0] - a[0] - s * t[0], p[1] - a[1] - s * t[1])
                    nearest = np.minimum(nearest, off)
                a = b
            return np.where(inside(outline, p), -nearest, nearest)

        return [Watch(("tips", self.world.ids[i]), (i,), from_edge), self._border(i)]

    def _border(self, i: int) -> Watch:
        assert self.world.border is not None
        x0, y0, x1, y1 = self.world.border

        def within(y: Array) -> Array:
            sides = (y[0, i] - x0, y[1, i] - y0, x1 - y[0, i], y1 - y[1, i])
            return np.minimum.reduce(sides)

        return Watch(("off-table", self.world.ids[i]), (i,), within)

    def _fates(self, i: int) -> list[Watch]:
        """The final events of a flying ball: it leaves the table or falls into a pocket."""
        found = [self._border(i)] if self.world.border is not None else []
        depth = 0.0 if self._is_trapped(i) else -self.radius[i]
        for hole in self.world.holes:

            def height(y: Array, hole: Hole = hole) -> Array:
                over = from_center(y[0:2, i], hole) <= hole.radius
                return np.where(over, y[2, i] - depth, CLEAR)

            key = ("pocket-collision", self.world.ids[i], hole.name)
            found.append(Watch(key, (i,), height, circle=(hole.center, hole.radius)))
        return found

    def _is_trapped(self, i: int) -> bool:
        """Whether the ball has too little energy to return to the slate."""
        v, w, r = self.y[3:6, i], self.y[6:9, i], self.radius[i]
        energy = v @ v / 2 + w @ w * r * r / 5 + self.world.gravity * self.y[2, i]
        return bool(energy < self.world.gravity * r)

    # -- search ----------------------------------------------------------------------------------

    def _immediate(self, watches: list[Watch]) -> Watch | None:
        for w in watches:
            if w.key[0] in ("pocket-collision", "off-table") and w.value(self.y) < 0.0:
                return w
        for w in watches:
            if not w.contact or abs(w.value(self.y)) > TOUCH:
                continue
            rate = self._rate_of(w)
            if rate < -PARTED or (rate <= LEVEL and self._presses(w)):
                return w
        return None

    def _rate_of(self, watch: Watch) -> float:
        """The present rate of growth of a gap, from the bodies' velocities."""
        if watch.place is None:
            i, j = watch.balls
            d = self.y[0:3, j] - self.y[0:3, i]
            return float(d @ (self.y[3:6, j] - self.y[3:6, i]) / np.sqrt(d @ d))
        (i,) = watch.balls
        return -float(watch.place.normal(self.y[0:3, i]) @ self.y[3:6, i])

    def _presses(self, watch: Watch) -> bool:
        """Whether a ball that moves level over an edge, or along a round wall, presses on it."""
        if watch.place is None or watch.place.key[-1] in ("slate-collision", "top"):
            return False
        if self.motion[watch.balls[0]] != "airborne":
            return False
        (i,) = watch.balls
        soon = self.y[0:3, i] + SOON * self.y[3:6, i]
        soon[2] -= self.world.gravity * SOON**2 / 2
        return bool(watch.place.gap(soon) < 0.0)

    def _search(self, watches: list[Watch]) -> Watch:
        """Integrates to the first time at which a watched value falls through zero."""
        shape = self.y.shape
        solver = DOP853(
            self._forces(), self.time, self.y.ravel(), np.inf,
            rtol=RELATIVE, atol=ABSOLUTE, max_step=STEP, first_step=1e-4,
        )  # fmt: skip
        touching = [w.contact and abs(w.value(self.y)) <= TOUCH for w in watches]
        balls = [w.balls[0] for w in watches]
        centers = np.array([w.circle[0] if w.circle else (0.0, 0.0) for w in watches])
        reaches = np.array([w.circle[1] if w.circle else np.inf for w in watches])
        reaches += self.radius[balls] + NEAR
        while True:
            message = solver.step()
            if solver.status == "failed":
                raise RuntimeError(message)
            dense = solver.dense_output()
            times = np.linspace(solver.t_old, solver.t, LOOKS + 1)
            looks = dense(times).reshape(*shape, LOOKS + 1)
            off = np.hypot(*(looks[:2, balls] - centers.T[:, :, None])).min(axis=1)
            first: tuple[float, Watch] | None = None
            for k, w in enumerate(watches):
                if off[k] > reaches[k]:
                    touching[k] = False
                    continue
                values = np.array(w.value(looks))
                if touching[k]:
                    # The bodies touch and separate; a new contact needs a clear gap first.
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
        gentle = watch.contact and self._is_gentle(watch)
        key = watch.key
        physics, g = self.world.physics, self.world.gravity
        if kind in ("slide", "roll", "spin", "tips"):
            was = self.motion[i]
            self._transition(kind, i)
            if kind == "spin" and was != "spinning":
                return None
            key = ("motion-transition", watch.key[1], was, self.motion[i])
        elif kind == "ball-collision":
            j = watch.balls[1]
            bodies = laws.collide(
                self.world.law_of_balls(self.met),
                self._body(i),
                self._body(j),
                cloth=physics["cloth"]["sliding_friction"],
            )
            self.met += 1
            for k, body in zip((i, j), bodies, strict=True):
                self._take(k, body)
        elif kind == "slate-collision" or key[-1] == "top":
            self._take(i, laws.bounce(physics["slate"], g, self._body(i)))
        elif kind == "rail-collision":
            assert watch.place is not None
            nx, ny, nz = (float(c) for c in watch.place.normal(self.y[0:3, i]))
            law = self.world.law_of(key[-1])
            on_bed = self.motion[i] in ON_CLOTH
            if key[-1] == "liner" and nz == 0.0:
                body = laws.rebound_off_wall(law, self._body(i), (nx, ny, nz))
            else:
                cloth = physics["cloth"]["sliding_friction"]
                body = laws.rebound(law, self._body(i), (nx, ny, nz), on_bed, cloth=cloth)
            self._take(i, body)
        if kind in ("pocket-collision", "off-table"):
            self.motion[i] = "pocketed" if kind == "pocket-collision" else "off-table"
            self.y[3:, i] = 0.0
        after = tuple(self.state(k) for k in watch.balls)
        names = tuple(self.world.ids[k] for k in watch.balls)
        return Happening(self.time, key, names, before, after, gentle)

    def _is_gentle(self, watch: Watch) -> bool:
        approach = -self._rate_of(watch)
        if watch.place is None or self.motion[watch.balls[0]] != "airborne":
            return approach < 2 * laws.LOUD
        kind = watch.place.key[-1]
        if kind in ("slate-collision", "top"):
            return False
        return kind == "lip" or approach < laws.PRESSED

    def _transition(self, kind: str, i: int) -> None:
        y = self.y
        if kind == "tips":
            self.motion[i] = "airborne"
        elif kind == "spin":
            y[8, i] = 0.0
            if self.motion[i] == "spinning":
                self.motion[i] = "stationary"
        elif kind == "slide":
            y[6, i], y[7, i] = -y[4, i] / self.radius[i], y[3, i] / self.radius[i]
            self.motion[i] = "rolling"
        elif self.low[i] > 0.0:
            y[3:8, i] *= self.low[i] / np.hypot(y[3, i], y[4, i])
        else:
            y[3:8, i] = 0.0
            self.motion[i] = "stationary" if y[8, i] == 0.0 else "spinning"

    def _body(self, i: int) -> laws.Body:
        s = self.state(i)
        return laws.Body(self.world.mass[i], self.world.radius[i], s.position, s.velocity, s.spin)

    def _take(self, i: int, body: laws.Body) -> None:
        """Sets a ball after an impact; a ball that is on the slate stays there or leaves it."""
        borne = self.motion[i] in ON_CLOTH or self._is_down(i)
        if borne:
            body = laws.settle(self.world.physics["slate"], self.world.gravity, body)
        if borne and body.velocity[2] == 0.0:
            motion = motion_of(body.velocity, body.spin, body.radius)
        else:
            motion = "airborne"
        self.replace(
            i, replace(self.state(i), velocity=body.velocity, spin=body.spin, motion=motion)
        )

    def _is_down(self, i: int) -> bool:
        """Whether a flying ball touches the slate or a rail's top."""
        height = self.y[2, i] - self.radius[i]
        if self.world.inside and on_top(self.world, self.y[0:2, i]):
            height -= self.world.nose_height
        return bool(abs(height) <= TOUCH)


def _slip(y: Array, r: Array) -> Array:
    return y[3:5] + r * y[7:5:-1] * BELOW


def _unit(v: Array, before: Array) -> Array:
    """v/|v|, reversed where v points against `before`; 0 where v is 0."""
    size = np.hypot(v[0], v[1])
    size = np.where(size == 0.0, 1.0, size)
    return v / size * np.where((v * before).sum(axis=0) < 0.0, -1.0, 1.0)


def _along(v0: Array, r: Array, i: int, slip: bool, end: float = 0.0) -> Callable[[Array], Array]:
    """The component of slip or velocity along its initial direction, less `end`, m/s."""
    n = v0 / np.hypot(*v0)

    def value(y: Array) -> Array:
        if slip:
            return n[0] * (y[3, i] - r[i] * y[7, i]) + n[1] * (y[4, i] + r[i] * y[6, i])
        return n[0] * y[3, i] + n[1] * y[4, i] - end

    return value


def _first_fall(
    watch: Watch, values: Array, times: Array, dense: Any, shape: tuple[int, int]
) -> float | None:
    """The first time in the step at which the value falls through zero."""

    def at(t: float) -> float:
        return float(watch.value(dense(t).reshape(shape)))

    if values.min() >= NEAR:
        return None
    for k in range(len(times) - 1):
        if values[k] > 0.0 >= values[k + 1]:
            low = times[k]
            # Bodies that have just separated may start with an overlap by rounding.
            while at(low) <= 0.0:
                low += 0.01 * (times[k + 1] - low)
                if times[k + 1] - low < 1e-12:
                    return None
            return float(brentq(at, low, times[k + 1], xtol=1e-16, rtol=8.9e-16))
        if not watch.contact or k == 0:
            continue
        dips = values[k] < values[k - 1] and values[k] < values[k + 1]
        if dips and 0.0 < values[k] < NEAR:
            bounds = (times[k - 1], times[k + 1])
            lowest = minimize_scalar(at, bounds=bounds, method="bounded", options={"xatol": 1e-12})
            if lowest.fun < 0.0:
                return float(brentq(at, bounds[0], lowest.x, xtol=1e-16, rtol=8.9e-16))
    return None
