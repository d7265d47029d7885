"""The impact laws from the papers, for any kind of number (float or mpmath's).

They are written with vectors and from the definitions (velocity of the contact points, impulse,
torque), not with the engine's components.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Protocol

from mpmath import mp, mpf

from oracles import friction, springs

Number = Any
Vec = tuple[Number, Number, Number]

#: The engine's documented rule at low speed (m/s): restitution is 1 up to the first and the law's
#: own from the second.
QUIET, LOUD = 1e-3, 2e-3
#: The engine's documented rule for the last hop: a ball that would rise less than this, m, stays.
LAST_HOP = 5e-5
#: Digits to which impacts are integrated for mpmath's numbers and for doubles.
DIGITS, DIGITS_OF_DOUBLES = 34, 17
#: Contacts of a flying ball slower than this, m/s, may be persistent: tipping over an edge.
PRESSED = 0.1


class Functions(Protocol):
    """The functions that the laws use; the modules `math` and `mpmath.mp` both have them."""

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
    """The share of lossless reflection in a slow impact: 1 below `QUIET`, 0 from `LOUD` up."""
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


def collide(
    law: dict[str, Any], a: Body, b: Body, fn: Functions = math, cloth: Number = 0
) -> tuple[Body, Body]:
    """A collision of two balls, on the cloth or in the air.

    `law` is the section `ball_ball` of a shot file, with the friction as an object or a number;
    `cloth` is the friction coefficient of the cloth, for `mathavan-2014`.
    """
    d = add(b.position, a.position, -1)
    n = scale(d, 1 / fn.sqrt(dot(d, d)))
    relative = add(a.velocity, b.velocity, -1)
    approach = dot(relative, n)
    share = quiet_share(approach)
    e = share + (1 - share) * law["restitution"]
    reduced = a.mass * b.mass / (a.mass + b.mass)
    normal = (1 + e) * reduced * approach

    impulse = scale(n, normal)
    turning = add(scale(a.spin, a.radius), scale(b.spin, b.radius))
    slip = add(add(relative, n, -approach), cross(turning, n))
    speed = fn.sqrt(dot(slip, slip))
    if law["model"] == "mathavan-2014":
        mu = slip_friction(law["friction"], speed, fn)
        # The paper has balls of one size on the cloth.
        level = n[2] == 0 and a.velocity[2] == 0 and b.velocity[2] == 0
        after = squeeze([(a, n), (b, scale(n, -1))], mu, cloth if level else None, e, fn)
        return after[0], after[1]
    if law["model"] in ("frictional", "compliant") and speed > 0:
        mu = slip_friction(law["friction"], speed, fn)
        if law["model"] == "frictional":
            # Two solid spheres stop slipping after an impulse of 2/7 of the reduced mass × slip.
            grip = min(mu * normal, reduced * speed * 2 / 7)
        else:
            grip = reduced * sprung(approach, speed, e, mu, law["frequency_ratio"], fn)
        impulse = add(impulse, slip, grip / speed)
    elif law["model"] not in ("frictional", "compliant", "elastic"):
        raise NotImplementedError(law["model"])
    return push(a, n, scale(impulse, -1)), push(b, scale(n, -1), impulse)


def sprung(
    approach: Number, slip: Number, e: Number, mu: Number, ratio: Number, fn: Functions
) -> Number:
    """The friction impulse per (reduced) mass between surfaces with a tangential spring."""
    last = springs.final_slip(approach, slip, e, mu, ratio)
    # The impulse changes the slip of solid spheres by 7/2 of itself.
    return like((slip - last) * 2 / 7, fn)


def squeeze(
    balls: list[tuple[Body, Vec]], mu: Number, cloth: Number | None, e: Number, fn: Functions
) -> list[Body]:
    """An impact integrated over the normal impulse, each ball with the direction to the contact."""
    given = [
        friction.Ball(mpf(b.mass), mpf(b.radius), exact(b.velocity), exact(b.spin), exact(axis))
        for b, axis in balls
    ]
    digits = DIGITS if fn is mp else DIGITS_OF_DOUBLES
    found = friction.squeeze(given, mu, cloth, e, digits)
    return [
        replace(b, velocity=tuple(like(c, fn) for c in v), spin=tuple(like(c, fn) for c in w))
        for (b, _), (v, w) in zip(balls, found, strict=True)
    ]


def exact(v: Vec) -> Vec:
    return (mpf(v[0]), mpf(v[1]), mpf(v[2]))


def like(x: Number, fn: Functions) -> Number:
    """A number of the kind that the functions take."""
    return x if fn is mp else float(x)


def push(ball: Body, towards: Vec, impulse: Vec) -> Body:
    """A solid sphere after an impulse (kg m/s) at its surface point in the direction `towards`."""
    inertia = ball.mass * ball.radius**2 * 2 / 5
    torque = cross(scale(towards, ball.radius), impulse)
    return replace(
        ball,
        velocity=add(ball.velocity, impulse, 1 / ball.mass),
        spin=add(ball.spin, torque, 1 / inertia),
    )


#: Angle by which a liner's wall leans over the hole in an impact, rad.
LINER_LEAN = math.radians(15)


def rebound_off_wall(law: dict[str, Any], ball: Body, normal: Vec) -> Body:
    """A flying ball that hits the round wall of a liner, detected as upright: `normal` is level.

    It rebounds as from a wall that leans over the hole, unless it moves away along that slope.
    """
    cos, sin = math.cos(LINER_LEAN), math.sin(LINER_LEAN)
    leaning = (cos * normal[0], cos * normal[1], sin)
    if dot(ball.velocity, leaning) > 0:
        thrown = rebound(law, ball, leaning, on_bed=False)
        if dot(thrown.velocity, normal) <= 0:
            return thrown
    return rebound(law, ball, normal, on_bed=False)


def rebound(
    law: dict[str, Any],
    ball: Body,
    normal: Vec,
    on_bed: bool,
    fn: Functions = math,
    cloth: Number = 0,
) -> Body:
    """A ball that hits an edge, a wall or a rail's top.

    `restitution`, `factors` (FastFiz), `han-2005`, `stronge` or `mathavan-2010`. `normal` is the
    unit vector from the ball's centre to the contact point. On the bed the slate supports the ball:
    its approach is horizontal, and it moves neither into the rail nor down. `cloth` is its friction
    coefficient.
    """
    level = fn.sqrt(normal[0] ** 2 + normal[1] ** 2)
    into: Vec = (normal[0] / level, normal[1] / level, 0) if on_bed else normal
    approach = dot(ball.velocity, into)
    share = quiet_share(approach)
    e = law["restitution"]
    if isinstance(e, dict):
        fitted = e["a"] + e["b"] * approach + e["c"] * approach**2
        e = min(max(fitted, e.get("lowest", 0)), e.get("highest", 1))
    # `restitution` and `factors` have no friction.
    mu = law.get("friction", 0)
    if isinstance(mu, dict):
        across = add(ball.velocity, into, -approach)
        mu = max(mu["a"] + mu["b"] * fn.atan2(fn.sqrt(dot(across, across)), approach), 0)

    impulse = scale(into, -(1 + e) * approach)  # per unit mass
    spin_change: Vec = (0, 0, 0)
    if law["model"] == "factors":
        across = add(ball.velocity, into, -approach)
        impulse = add(impulse, across, law["tangential_factor"] - 1)
        spin_change = scale(ball.spin, law["spin_factor"] - 1)
    elif law["model"] == "mathavan-2010":
        bed = cloth if on_bed else None
        (after,) = squeeze([(ball, normal)], mu, bed, e, fn)
        impulse, spin_change = (
            add(after.velocity, ball.velocity, -1),
            add(after.spin, ball.spin, -1),
        )
    elif law["model"] in ("han-2005", "stronge"):
        head_on = dot(ball.velocity, normal)
        u = add(ball.velocity, cross(ball.spin, scale(normal, ball.radius)))
        u = add(u, normal, -dot(u, normal))
        slip = fn.sqrt(dot(u, u))
        impulse = scale(normal, -(1 + e) * head_on)
        if slip > 0:
            if law["model"] == "han-2005":
                drag = min(mu * (1 + e) * head_on, slip * 2 / 7)
            else:
                drag = sprung(head_on, slip, e, mu, law["frequency_ratio"], fn)
            tangential = scale(u, -drag / slip)
            impulse = add(impulse, tangential)
            spin_change = scale(cross(normal, tangential), 5 / (2 * ball.radius))
    elif law["model"] != "restitution":
        raise NotImplementedError(law["model"])
    # Slate and nose hold the ball like a wedge.
    left = dot(impulse, into) + approach
    if on_bed and left > 0:
        impulse = add(impulse, into, -left)
    if on_bed:
        # The slate takes the downward part of the nose's impulse.
        impulse = (impulse[0], impulse[1], max(impulse[2], 0))

    impulse = add(scale(impulse, 1 - share), into, -2 * approach * share)
    return replace(
        ball,
        velocity=add(ball.velocity, impulse),
        spin=add(ball.spin, spin_change, 1 - share),
    )


def bounce(law: dict[str, Any], gravity: Number, ball: Body, fn: Functions = math) -> Body:
    """A ball that lands on the slate or on a rail's top.

    Restitution, and Coulomb friction against the slip, at most until the slip stops; the spin about
    the vertical stays. A ball that would rise less than `LAST_HOP` stays down.
    """
    fall = -ball.velocity[2]
    e = law["restitution"]
    down: Vec = (0, 0, -1)
    u = add(ball.velocity, cross(ball.spin, scale(down, ball.radius)))
    slip = fn.sqrt(u[0] ** 2 + u[1] ** 2)
    impulse: Vec = (0, 0, (1 + e) * fall * ball.mass)
    if slip > 0:
        drag = min(law["friction"] * impulse[2], ball.mass * slip * 2 / 7)
        impulse = (-u[0] / slip * drag, -u[1] / slip * drag, impulse[2])
    after = push(ball, down, impulse)
    if after.velocity[2] >= last_hop(gravity, fn):
        return after
    return replace(after, velocity=(after.velocity[0], after.velocity[1], 0 * fall))


def settle(law: dict[str, Any], gravity: Number, ball: Body, fn: Functions = math) -> Body:
    """A ball on the slate after an impact there.

    It stays on the slate if it moves up too slowly, or down too slowly to rise again. Otherwise its
    velocity is unchanged, and it flies or bounces next.
    """
    up = ball.velocity[2]
    if (up if up >= 0 else law["restitution"] * -up) >= last_hop(gravity, fn):
        return ball
    return replace(ball, velocity=(ball.velocity[0], ball.velocity[1], 0 * up))


def last_hop(gravity: Number, fn: Functions = math) -> Number:
    """The least upward speed with which a ball leaves the slate, m/s."""
    return fn.sqrt(2 * gravity * LAST_HOP)


def strike(cue: dict[str, Any], stroke: dict[str, Any], ball: Body, fn: Any = math) -> Body:
    """A resting ball after the cue (Leckie & Greenspan 2005; TP A.30 and A.31).

    The contact point is given perpendicular to the cue's axis; the impulse acts along the axis. The
    tip's restitution falls off the centre (docs/contact.md).
    The end of the cue, which has to follow the ball's surface sideways, turns the velocity.
    """
    azimuth, elevation = (fn.radians(stroke[k]) for k in ("azimuth_deg", "elevation_deg"))
    x, y = stroke["side"], stroke["height"]
    level: Vec = (fn.cos(azimuth), fn.sin(azimuth), 0)
    axis = add(scale(level, fn.cos(elevation)), (0, 0, 1), -fn.sin(elevation))
    right: Vec = (level[1], -level[0], 0)
    above = cross(right, axis)
    arm = add(scale(right, x), above, y)
    inverse_inertia = 1 + (x * x + y * y) * 5 / 2
    ratio = ball.mass / cue["mass"]
    if "tip_efficiency" in cue:
        eta = cue["tip_efficiency"]
        recoil = fn.sqrt(eta - (1 - eta) * inverse_inertia / ratio)
    else:
        offset = x * x + y * y
        loss = 1 + cue.get("tip_off_centre_loss", 0) * offset / (1 - offset)
        recoil = cue["tip_restitution"] / fn.sqrt(loss)
    speed = (1 + recoil) * stroke["speed"] / (ratio + inverse_inertia)
    spin = scale(cross(arm, axis), speed * 5 / (2 * ball.radius))
    squirt = 0 * x
    if cue["end_mass"] > 0:
        inward = (1 - x * x) * 5 / 2
        squirt = x * fn.sqrt(1 - x * x) * 5 / 2 / (1 + ball.mass / cue["end_mass"] + inward)
    # tan of the angle to the left for right English.
    way = add(axis, right, -squirt)
    return replace(ball, velocity=scale(way, speed / fn.sqrt(1 + squirt * squirt)), spin=spin)
