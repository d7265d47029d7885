"""The fixed-step simulator that the paper argues against, in plain form.

Time advances in steps of Δt, within which the acceleration is constant, and with order 1 the
velocity too. After each step every ball, pair and rail is tested for an event. If there is one, the
fraction of the step at which it happened is found by linear interpolation, all balls are stepped
again by that fraction, and the event is applied. The force laws are the engine's, and so are the
two impact laws used here: restitution along the line of centres and along the rail's normal.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from carom.validation.lab import JSON, Vector
    from numpy.typing import NDArray

#: Ball, cloth and rail of the comparison, in SI units; `rows.laws` gives the engine the same.
RADIUS, GRAVITY, SLIDING, ROLLING, SPIN_DOWN = 0.028575, 9.81, 0.2, 0.01, 10.0
BALL_RESTITUTION, RAIL_RESTITUTION = 0.95, 0.85
WIDTH, LENGTH = 1.0, 2.0


@dataclass
class Balls:
    """n balls: position (m) and velocity (m/s), shape (n, 2); spin (rad/s), shape (n, 3).

    `rolls` says of each ball whether it rolls. `steps`, `contacts` (s) and `pairs` describe the
    simulation that led here: its number of steps, and the times and balls of the collisions.
    """

    position: Vector
    velocity: Vector
    spin: Vector
    rolls: NDArray[np.bool_]
    steps: int = 0
    contacts: list[float] = field(default_factory=list)
    pairs: list[tuple[int, int]] = field(default_factory=list)

    @property
    def slip(self) -> Vector:
        v, w = self.velocity, self.spin
        return np.stack((v[:, 0] - RADIUS * w[:, 1], v[:, 1] + RADIUS * w[:, 0]), axis=1)

    @property
    def at_rest(self) -> bool:
        return not (self.velocity.any() or self.spin.any())


def start(balls: list[JSON]) -> Balls:
    """Balls in the form of a shot file, all of them sliding."""
    return Balls(
        np.array([b["position"] for b in balls]),
        np.array([b["velocity"][:2] for b in balls]),
        np.array([b["angular_velocity"] for b in balls]),
        np.zeros(len(balls), dtype=bool),
    )


def unit(v: Vector) -> Vector:
    size = np.linalg.norm(v, axis=1, keepdims=True)
    direction: Vector = np.divide(v, size, out=np.zeros_like(v), where=size > 0)
    return direction


def stepped(b: Balls, dt: float, order: int = 1) -> Balls:
    """All balls after `dt` s.

    Order 1 is Euler's method, in which a position changes by v Δt; order 2 adds ½ a Δt².
    """
    sliding = unit(b.slip) * ~b.rolls[:, None]
    rolling = unit(b.velocity) * b.rolls[:, None]
    acceleration = -GRAVITY * (SLIDING * sliding + ROLLING * rolling)
    velocity = b.velocity + acceleration * dt
    spin = b.spin.copy()
    spin[:, 0] -= 2.5 * SLIDING * GRAVITY / RADIUS * sliding[:, 1] * dt
    spin[:, 1] += 2.5 * SLIDING * GRAVITY / RADIUS * sliding[:, 0] * dt
    spin[b.rolls, 0] = -velocity[b.rolls, 1] / RADIUS
    spin[b.rolls, 1] = velocity[b.rolls, 0] / RADIUS
    left = np.maximum(np.abs(b.spin[:, 2]) - SPIN_DOWN * dt, 0.0)
    spin[:, 2] = np.copysign(left, b.spin[:, 2])
    mean = b.velocity if order == 1 else 0.5 * (b.velocity + velocity)
    return Balls(b.position + mean * dt, velocity, spin, b.rolls.copy())


def gaps(b: Balls) -> Vector:
    """Distances from touching: (n, 4) to the rails left, right, bottom and top; negative inside."""
    walls = np.array([[0.0, WIDTH, 0.0, LENGTH]])
    sign = np.array([[1.0, -1.0, 1.0, -1.0]])
    gap: Vector = sign * (np.repeat(b.position, 2, axis=1) - walls) - RADIUS
    return gap


def separations(b: Balls) -> Vector:
    """Distances from touching, of each ball to each other, (n, n)."""
    apart = b.position[:, None] - b.position[None, :]
    gap: Vector = np.sqrt(np.sum(apart * apart, axis=2)) - 2 * RADIUS
    return gap


def events(a: Balls, b: Balls) -> list[tuple[float, str, int, int]]:
    """The events between `a` and `b`: fraction of the step, kind, ball, other ball or axis."""
    found = []
    slip, velocity = a.slip, a.velocity
    turned = ~a.rolls & slip.any(axis=1) & (np.sum(slip * b.slip, axis=1) <= 0.0)
    stopped = a.rolls & velocity.any(axis=1) & (np.sum(velocity * b.velocity, axis=1) <= 0.0)
    for kind, ends, before, after in (
        ("rolls", turned, slip, b.slip),
        ("stops", stopped, velocity, b.velocity),
    ):
        for i in np.flatnonzero(ends):
            was, left = np.linalg.norm(before[i]), np.linalg.norm(after[i])
            found.append((float(was / (was + left)), kind, int(i), int(i)))
    for kind, before, after in (
        ("rail", gaps(a), gaps(b)),
        ("balls", separations(a), separations(b)),
    ):
        for i, k in np.argwhere((before > 0.0) & (after <= 0.0)):
            fraction = before[i, k] / (before[i, k] - after[i, k])
            if kind == "rail":
                found.append((float(fraction), kind, int(i), int(k) // 2))
            elif i < k:
                found.append((float(fraction), kind, int(i), int(k)))
    return found


def apply(b: Balls, kind: str, i: int, j: int) -> None:
    """Applies an event to the balls."""
    if kind == "rolls":
        b.rolls[i] = True
        b.spin[i, :2] = (-b.velocity[i, 1] / RADIUS, b.velocity[i, 0] / RADIUS)
    elif kind == "stops":
        b.velocity[i], b.spin[i, :2] = 0.0, 0.0
    elif kind == "rail":
        b.velocity[i, j] *= -RAIL_RESTITUTION
        b.rolls[i] = False
    else:
        n = b.position[j] - b.position[i]
        n /= np.linalg.norm(n)
        exchanged = 0.5 * (1 + BALL_RESTITUTION) * ((b.velocity[i] - b.velocity[j]) @ n) * n
        b.velocity[i] -= exchanged
        b.velocity[j] += exchanged
        b.rolls[i] = b.rolls[j] = False


def simulate(start: Balls, dt: float, order: int = 1) -> Balls:
    """Steps of `dt` s until all balls rest; records the number of steps and the collisions."""
    now, time, steps, contacts, pairs = start, 0.0, 0, [], []
    while not now.at_rest:
        size = dt
        following = stepped(now, size, order)
        happened = events(now, following)
        steps += 1
        if happened:
            fraction, kind, i, j = min(happened)
            following = stepped(now, fraction * size, order)
            apply(following, kind, i, j)
            size *= fraction
            if kind == "balls":
                contacts.append(time + size)
                pairs.append((i, j))
        now, time = following, time + size
    now.steps, now.contacts, now.pairs = steps, contacts, pairs
    return now
