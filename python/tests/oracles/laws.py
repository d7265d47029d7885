"""The impact laws, from the papers, for any kind of number (float or mpmath's).

Written in vectors and from the definitions (velocity of the contact points, impulse, torque), not
in the engine's components.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Protocol

Number = Any
Vec = tuple[Number, Number, Number]

#: The engine's documented rule at low speed (m/s): restitution is 1 up to the first and the law's
#: own from the second.
QUIET, LOUD = 1e-3, 2e-3


class Functions(Protocol):
    """What the laws need of a kind of number; the modules `math` and `mpmath.mp` both have it."""

    def sqrt(self, x: Number, /) -> Number: ...
    def exp(self, x: Number, /) -> Number: ...
    def atan2(self, y: Number, x: Number, /) -> Number: ...


@dataclass(frozen=True)
class Body:
    """A ball at the instant of an impact."""

    mass: Number
    radius: Number
    position: Vec
    velocity: Vec
    spin: Vec


def dot(a: Vec, b: Vec) -> Number:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec, b: Vec) -> Vec:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def add(a: Vec, b: Vec, k: Number = 1) -> Vec:
    """a + k b."""
    return (a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2])


def scale(a: Vec, k: Number) -> Vec:
    return (a[0] * k, a[1] * k, a[2] * k)


def quiet_share(approach: Number) -> Number:
    """How much of a slow impact is a lossless reflection: 1 below `QUIET`, 0 from `LOUD` up."""
    if approach >= LOUD:
        return 0
    if approach <= QUIET:
        return 1
    return 2 - approach / QUIET


def slip_friction(law: Any, slip: Number, fn: Functions) -> Number:
    """μ(s) = a + b exp(−c s), or a number."""
    if isinstance(law, dict):
        return law["a"] + law["b"] * fn.exp(-law["c"] * slip)
    return law


def collide(law: dict[str, Any], a: Body, b: Body, fn: Functions = math) -> tuple[Body, Body]:
    """Two balls that touch: `elastic` or `frictional` (rigid Coulomb friction).

    Balls on the cloth move only horizontally: restitution holds for the horizontal approach, the
    impulse along the tilted line of centres is larger by 1/cos(tilt), and friction along the steep
    tangent turns the balls without moving them.
    """
    up: Vec = (0, 0, 1)
    d = add(b.position, a.position, -1)
    n = scale(d, 1 / fn.sqrt(dot(d, d)))
    level = fn.sqrt(n[0] ** 2 + n[1] ** 2)
    h: Vec = (n[0] / level, n[1] / level, 0)
    t1 = cross(up, h)
    t2 = cross(n, t1)

    relative = add(a.velocity, b.velocity, -1)
    approach = dot(relative, h)
    share = quiet_share(approach)
    e = share + (1 - share) * law["restitution"]
    reduced = a.mass * b.mass / (a.mass + b.mass)
    along = (1 + e) * reduced * approach

    push = scale(h, along)
    turn: Vec = (0, 0, 0)
    if law["model"] == "frictional":
        surface = cross(add(scale(a.spin, a.radius), scale(b.spin, b.radius)), n)
        u1, u2 = dot(relative, t1) + dot(surface, t1), dot(surface, t2)
        slip = fn.sqrt(u1 * u1 + u2 * u2)
        if slip > 0:
            grip = slip_friction(law["friction"], slip, fn) * along / level
            # Two solid spheres stop slipping after an impulse of 2/7 of the reduced mass × slip.
            friction = min(grip, reduced * slip * 2 / 7)
            push = add(push, t1, friction * u1 / slip)
            turn = add(scale(t1, friction * u1 / slip), t2, friction * u2 / slip)
    elif law["model"] != "elastic":
        raise NotImplementedError(law["model"])

    def after(ball: Body, sign: int) -> Body:
        inertia = ball.mass * ball.radius**2 * 2 / 5
        torque = scale(cross(n, turn), -ball.radius)
        return replace(
            ball,
            velocity=add(ball.velocity, push, sign / ball.mass),
            spin=add(ball.spin, torque, 1 / inertia),
        )

    return after(a, -1), after(b, 1)


def rebound(
    law: dict[str, Any], nose_height: Number, ball: Body, into: Vec, fn: Functions = math
) -> Body:
    """A ball that touches a cushion: `restitution` or `han-2005`.

    `into` is the horizontal unit vector from the ball's centre towards the nose.
    """
    approach = dot(ball.velocity, into)
    sine = (nose_height - ball.radius) / ball.radius
    cosine = fn.sqrt(1 - sine * sine)
    share = quiet_share(approach)
    e = law["restitution"]
    if isinstance(e, dict):
        e = min(max(e["a"] + e["b"] * approach + e["c"] * approach**2, 0), 1)

    impulse = scale(into, -(1 + e) * approach)  # per unit mass
    spin_change: Vec = (0, 0, 0)
    if law["model"] == "han-2005":
        n: Vec = (cosine * into[0], cosine * into[1], sine)
        u = add(ball.velocity, cross(ball.spin, scale(n, ball.radius)))
        u = add(u, n, -dot(u, n))
        slip = fn.sqrt(dot(u, u))
        mu = law["friction"]
        if isinstance(mu, dict):
            along = dot(ball.velocity, cross((0, 0, 1), into))
            mu = max(mu["a"] + mu["b"] * fn.atan2(abs(along), approach), 0)
        normal = (1 + e) * approach * cosine
        friction = min(mu * normal, slip * 2 / 7)
        impulse = scale(n, -normal)
        if slip > 0:
            tangential = scale(u, -friction / slip)
            impulse = add(impulse, tangential)
            spin_change = scale(cross(n, tangential), ball.radius * 5 / (2 * ball.radius**2))
        impulse = (impulse[0], impulse[1], 0)
        # Slate and nose hold the ball as a wedge does: it never goes on into the rail.
        left = dot(impulse, into) + approach
        if left > 0:
            impulse = add(impulse, into, -left)
    elif law["model"] != "restitution":
        raise NotImplementedError(law["model"])

    impulse = add(scale(impulse, 1 - share), into, -2 * approach * share)
    return replace(
        ball,
        velocity=add(ball.velocity, impulse),
        spin=add(ball.spin, spin_change, 1 - share),
    )
