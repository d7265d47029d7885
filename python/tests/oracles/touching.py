"""Bodies that touch, as a network of springs that SciPy integrates in time.

Balls, a cue that moves along its axis, and walls (cushions, slate) keep their places; every contact
has a spring. The normal force is k δ^(3/2), and while the contact opens e² times as much. A rigid
contact has Coulomb friction. A compliant one has a tangential spring with the stiffness
(5/4)(2/7)(ω_t/ω_n)² times F/δ; its force is at most μF, and falls in proportion to its stiffness
where the contact opens. μ is that of the fastest slip so far. These are the documented springs of
docs/many-balls.md; the way to solve them is another one: SciPy's Runge–Kutta method of order 3
chooses its steps for an error of 1e-5.

That needs continuous forces. So the force rises from e²F to F within ±`SHARP` of the fastest
speed around the turning point, friction reverses within ±`SHARP`, and a tangential spring that
pulls more than μF slackens within `SOON` of a contact's time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import solve_ivp

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

Array = np.ndarray[Any, np.dtype[np.float64]]

#: Width of the transitions, in units of the fastest speed and of the shortest contact.
SHARP, SOON = 5e-4, 5e-3
#: The method of SciPy, and the error of its steps, relative and absolute.
RELATIVE, ABSOLUTE = 1e-5, 1e-7
METHOD = "RK23"
#: A lossless contact lasts this many times (m²/(k²V))^(1/5), and this many times its depth / speed.
#: Both follow from Hertz's force; the second is 2∫dx/√(1 − x^(5/2)) from 0 to 1.
CONTACT_TIME, TIME_PER_DEPTH = 3.2181, 2.94327
#: A force below this, in units of a contact's forces, is none.
NO_FORCE = 1e-6
#: The longest integration, in times of the shortest contact.
LONGEST = 400.0
#: The force that compresses two 2¼ in balls by 0.2 mm (TP B.29), N; their radius, m.
TP_FORCE, TP_DEPTH, TP_RADIUS = 2270.0, 0.2e-3, 1.125 * 0.0254


def ball_stiffness(radius_a: float, radius_b: float) -> float:
    """k of two balls of TP B.29's material, N/m^(3/2), as √(R_a R_b/(R_a + R_b))."""
    return (
        TP_FORCE
        / TP_DEPTH**1.5
        * math.sqrt(radius_a * radius_b / (radius_a + radius_b) / (0.5 * TP_RADIUS))
    )


def stiffness_of_time(mass: float, time: float) -> float:
    """k of a contact of reduced mass `mass` that lasts `time`, s, without losses at 1 m/s."""
    return 1.25 * mass / (time / TIME_PER_DEPTH) ** 2.5


@dataclass(frozen=True)
class Law:
    """A contact's restitution and friction; `ratio` is ω_t/ω_n, or None for a rigid contact."""

    restitution: float
    friction: float | Callable[[float], float] = 0.0
    ratio: float | None = None


@dataclass
class Contact:
    """One spring: its rows give approach and slip from the velocities of all bodies."""

    normal: Array
    across: Array
    stiffness: float
    law: Law
    gap: float


class Network:
    """Bodies and the springs between them."""

    def __init__(self) -> None:
        self.mass: list[float] = []
        self.start: list[float] = []
        self.radius: dict[int, float] = {}
        self._contacts: list[Callable[[int], Contact]] = []
        #: The times, s, and each contact's force at these times, N, of the last solution.
        self.times: Array = np.empty(0)
        self.forces: Array = np.empty((0, 0))

    def ball(
        self,
        mass: float,
        radius: float,
        velocity: Sequence[float] = (0.0, 0.0, 0.0),
        spin: Sequence[float] = (0.0, 0.0, 0.0),
    ) -> int:
        """Adds a ball; returns where its velocity begins, three numbers, and Rω, three more."""
        at = len(self.mass)
        self.mass += [mass] * 3 + [0.4 * mass] * 3
        self.start += [*velocity, *(radius * w for w in spin)]
        self.radius[at] = radius
        return at

    def cue(self, mass: float, speed: float) -> int:
        """Adds a cue; returns where its speed along its axis is."""
        self.mass.append(mass)
        self.start.append(speed)
        return len(self.mass) - 1

    def join_balls(
        self, a: int, b: int, normal: Sequence[float], law: Law, gap: float = 0.0
    ) -> None:
        """A contact of two balls; the normal points from a's centre to b's."""
        k = ball_stiffness(self.radius[a], self.radius[b])
        self._contacts.append(lambda n: _touch(n, a, b, np.array(normal), k, law, gap))

    def join_wall(
        self, ball: int, normal: Sequence[float], stiffness: float, law: Law, gap: float = 0.0
    ) -> None:
        """A contact with slate or cushion; the normal points from the ball's centre to it."""
        towards = np.array(normal)
        self._contacts.append(lambda n: _touch(n, ball, None, towards, stiffness, law, gap))

    def join_tip(
        self,
        cue: int,
        ball: int,
        axis: Sequence[float],
        launch: Sequence[float],
        arm: Sequence[float],
        stiffness: float,
        restitution: float,
    ) -> None:
        """A contact of the cue's tip with a ball.

        The tip pushes the centre along `launch` (the axis turned by squirt) and turns the ball as a
        force along `axis` at `arm`, in ball radii from the centre.
        """

        def contact(n: int) -> Contact:
            row = np.zeros(n)
            row[cue] = 1.0
            row[ball : ball + 3] = -np.array(launch)
            row[ball + 3 : ball + 6] = -np.cross(arm, axis)
            return Contact(row, np.zeros((2, n)), stiffness, Law(restitution), 0.0)

        self._contacts.append(contact)

    def solve(self) -> Array:
        """The velocities (m/s; of a ball v and Rω) after the impact."""
        return _Integration(self).run()


def _touch(
    n: int, a: int, b: int | None, normal: Array, stiffness: float, law: Law, gap: float
) -> Contact:
    normal = normal / np.linalg.norm(normal)
    helper = np.eye(3)[np.argmin(np.abs(normal))]
    first = np.cross(normal, helper)
    first /= np.linalg.norm(first)
    row, across = np.zeros(n), np.zeros((2, n))
    for at, sign in ((a, 1.0), (b, -1.0)):
        if at is None:
            continue
        row[at : at + 3] = sign * normal
        for slip, tangent in zip(across, (first, np.cross(normal, first)), strict=True):
            slip[at : at + 3] = sign * tangent
            # Surface velocity Rω × n of the first ball, −Rω × n of the second, seen from the first.
            slip[at + 3 : at + 6] = np.cross(normal, tangent)
    return Contact(row, across, stiffness, law, gap)


class _Integration:
    """The equations in units of the fastest approach, the heaviest mass and the shortest time."""

    def __init__(self, network: Network) -> None:
        n = len(network.mass)
        self.network = network
        contacts = [make(n) for make in network._contacts]
        self.n, self.count = n, len(contacts)
        mass = np.array(network.mass)
        self.normal = np.array([c.normal for c in contacts])
        across = np.array([c.across for c in contacts])
        stiffness = np.array([c.stiffness for c in contacts])
        start = np.array(network.start)
        reduced = 1.0 / np.einsum("ci,i,ci->c", self.normal, 1.0 / mass, self.normal)
        self.speed = float(np.max(self.normal @ start))
        unit_mass = float(np.max(mass))
        times = (reduced**2 / (stiffness**2 * self.speed)) ** 0.2
        self.time = float(np.min(times))
        self.slowest = float(np.max(times)) / self.time
        length = self.speed * self.time
        self.stiffness = stiffness * length**1.5 * self.time / (unit_mass * self.speed)
        self.unit_force = unit_mass * self.speed / self.time
        mobility = unit_mass / mass
        self.push = -(self.normal * mobility).T
        self.retained = np.array([c.law.restitution for c in contacts]) ** 2
        rubs = [c.law.friction != 0.0 for c in contacts]
        self.sprung = np.flatnonzero(
            [r and c.law.ratio is not None for r, c in zip(rubs, contacts, strict=True)]
        )
        self.rigid = np.flatnonzero(
            [r and c.law.ratio is None for r, c in zip(rubs, contacts, strict=True)]
        )
        self.rows = {
            kind: across[kind_at].reshape(-1, n)
            for kind, kind_at in (("sprung", self.sprung), ("rigid", self.rigid))
        }
        self.drag = {kind: -(rows * mobility).T for kind, rows in self.rows.items()}
        ratios = np.array([contacts[k].law.ratio or 0.0 for k in self.sprung])
        self.grip = 1.25 * (2.0 / 7.0) * ratios**2
        # Friction that depends on the slip needs the fastest slip so far, as part of the state.
        self.friction = np.zeros(self.count)
        self.varying: list[tuple[int, Callable[[float], float]]] = []
        for k, c in enumerate(contacts):
            if callable(c.law.friction):
                self.varying.append((k, c.law.friction))
            else:
                self.friction[k] = c.law.friction
        self.across = across
        at = [k for k, _ in self.varying]
        first_slip = np.linalg.norm(across[at] @ start, axis=1) / self.speed
        self.begin = np.concatenate(
            [
                start / self.speed,
                [-c.gap / length for c in contacts],
                np.zeros(2 * len(self.sprung)),
                first_slip,
            ]
        )

    def normal_force(self, approach: Array, depth: Array) -> tuple[Array, Array]:
        """Force and F/δ of a closing contact."""
        deep = np.maximum(depth, 0.0)
        spring = self.stiffness * np.sqrt(deep)
        closing = np.clip(0.5 * (approach / SHARP + 1.0), 0.0, 1.0)
        return spring * deep * (self.retained + (1.0 - self.retained) * closing), spring

    def rates(self, _t: float, state: Array) -> Array:
        n, m, s = self.n, self.count, 2 * len(self.sprung)
        velocity, depth = state[:n], state[n : n + m]
        approach = self.normal @ velocity
        force, spring = self.normal_force(approach, depth)
        acceleration = self.push @ force
        rates = np.zeros_like(state)
        if self.varying:
            at = [k for k, _ in self.varying]
            fastest = state[n + m + s :]
            self.friction[at] = [
                law(v * self.speed) for (_, law), v in zip(self.varying, fastest, strict=True)
            ]
            slip = np.linalg.norm(self.across[at] @ velocity, axis=1)
            growth = np.where(depth[at] > 0.0, np.maximum(slip - fastest, 0.0), 0.0)
            rates[n + m + s :] = growth / SOON
        if len(self.sprung):
            k = self.sprung
            pull = state[n + m : n + m + s].reshape(-1, 2)
            slip = (self.rows["sprung"] @ velocity).reshape(-1, 2)
            most = self.friction[k] * force[k]
            size = np.maximum(np.linalg.norm(pull, axis=1), 1e-300)
            held = np.minimum(most / size, 1.0)[:, None]
            acceleration += self.drag["sprung"] @ (pull * held).ravel()
            opens = np.minimum(approach[k], 0.0) / np.maximum(2.0 * depth[k], SOON)
            slack = np.maximum(size - most, 0.0) / size / SOON
            change = slip * (self.grip * spring[k])[:, None] + pull * (opens - slack)[:, None]
            rates[n + m : n + m + s] = np.where(
                (depth[k] > 0.0)[:, None], change, -pull / SOON
            ).ravel()
        if len(self.rigid):
            k = self.rigid
            slip = (self.rows["rigid"] @ velocity).reshape(-1, 2)
            size = np.maximum(np.linalg.norm(slip, axis=1), SHARP)
            pull = slip * (self.friction[k] * force[k] / size)[:, None]
            acceleration += self.drag["rigid"] @ pull.ravel()
        rates[:n] = acceleration
        rates[n : n + m] = approach
        return rates

    def run(self) -> Array:
        state, now, forces, times = self.begin, 0.0, [], []
        chunk = CONTACT_TIME * max(1.0, 0.25 * self.slowest)
        while now < LONGEST * CONTACT_TIME:
            part = solve_ivp(
                self.rates,
                (now, now + chunk),
                state,
                method=METHOD,
                rtol=RELATIVE,
                atol=ABSOLUTE,
                max_step=0.3 * CONTACT_TIME,
            )
            assert part.success, part.message
            state, now = part.y[:, -1], now + chunk
            for y in part.y.T:
                approach, depth = self.normal @ y[: self.n], y[self.n : self.n + self.count]
                forces.append(self.normal_force(approach, depth)[0])
            times.append(part.t)
            if self.is_over(state):
                break
        else:
            raise AssertionError("the impact does not end")
        self.network.times = np.concatenate(times) * self.time
        self.network.forces = np.array(forces).T * self.unit_force
        result: Array = state[: self.n] * self.speed
        return result

    def is_over(self, state: Array) -> bool:
        """Whether no contact has a force, and none will have one soon."""
        depth = state[self.n : self.n + self.count]
        approach = self.normal @ state[: self.n]
        comes = (approach > SHARP) & (depth + approach * LONGEST > 0.0)
        presses = self.normal_force(approach, depth)[0] > NO_FORCE
        return not np.any(presses | comes)
