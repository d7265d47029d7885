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
    from carom.validation.lab import Vector
    from numpy.typing import NDArray

#: Ball, cloth and rail of the comparison, in SI units; `rows.laws` gives the engine the same.
RADIUS, GRAVITY, SLIDING, ROLLING, SPIN_DOWN = 0.028575, 9.81, 0.2, 0.01, 10.0
BALL_RESTITUTION, RAIL_RESTITUTION = 0.95, 0.85
WIDTH, LENGTH = 1.0, 2.0


@dataclass
class Balls:
    """n balls: position (m) and velocity (m/s), shape (n, 2); spin (rad/s), shape (n, 3).

    `rolls` says of each ball whether it rolls. `steps` and `contacts` (s) describe the simulation
    that led here: its number of steps, and the times of the ball–ball collisions.
    """

    position: Vector
    velocity: Vector
    spin: Vector
    rolls: NDArray[np.bool_]
    steps: int = 0
    contacts: list[float] = field(default_factory=list)

    @property
    def slip(self) -> Vector:
        v, w = self.velocity, self.spin
        return np.stack((v[:, 0] - RADIUS * w[:, 1], v[:, 1] + RADIUS * w[:, 0]), axis=1)

    @property
    def at_rest(self) -> bool:
        return not (self.velocity.any() or self.spin.any())


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


def fall(before: float, after: float) -> float | None:
    """The fraction of the step at which a value fell through zero; None if it did not."""
    return before / (before - after) if before > 0.0 >= after else None


def events(a: Balls, b: Balls) -> list[tuple[float, str, int, int]]:
    """The events between `a` and `b`: fraction of the step, kind, ball, other ball or axis."""
    found = []
    n = len(a.position)
    turned = np.sum(a.slip * b.slip, axis=1) <= 0.0
    stopped = np.sum(a.velocity * b.velocity, axis=1) <= 0.0
    for i in range(n):
        if not a.rolls[i] and a.slip[i].any() and turned[i]:
            before, after = np.linalg.norm(a.slip[i]), np.linalg.norm(b.slip[i])
            found.append((float(before / (before + after)), "rolls", i, i))
        if a.rolls[i] and a.velocity[i].any() and stopped[i]:
            before, after = np.linalg.norm(a.velocity[i]), np.linalg.norm(b.velocity[i])
            found.append((float(before / (before + after)), "stops", i, i))
        for axis, size in ((0, WIDTH), (1, LENGTH)):
            for side in (0, 1):
                gaps = [
                    (s.position[i, axis] if side == 0 else size - s.position[i, axis]) - RADIUS
                    for s in (a, b)
                ]
                fraction = fall(*gaps)
                if fraction is not None:
                    found.append((fraction, "rail", i, axis))
        for j in range(i + 1, n):
            gaps = [
                float(np.linalg.norm(s.position[j] - s.position[i])) - 2 * RADIUS for s in (a, b)
            ]
            fraction = fall(*gaps)
            if fraction is not None:
                found.append((fraction, "balls", i, j))
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
    now, time, steps, contacts = start, 0.0, 0, []
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
        now, time = following, time + size
    now.steps, now.contacts = steps, contacts
    return now
