"""Mathavan, Jackson & Parkin 2010: a snooker ball at a cushion, impulse by impulse.

A theoretical analysis of billiard ball–cushion dynamics under cushion impacts, Proc. IMechE C
224 (2010) 1863–1873. Ball and cushion as there: M = 0.1406 kg, R = 26.25 mm, nose at 7R/5,
e_e = 0.98, μ_w = 0.14 and μ_s = 0.212.
"""

import math

from carom.validation.lab import JSON, Ball, ball, simulate
from carom.validation.row import Kind, absolute, relative, row

RADIUS = 0.02625
NOSE = 1.4 * RADIUS
TABLE: JSON = {"length": 3.0, "width": 2.0, "pockets": "none", "cushion_height": NOSE}
PHYSICS: JSON = {
    "base": "snooker",
    "ball": {"mass": 0.1406, "radius": RADIUS},
    "cloth": {"sliding_friction": 0.212},
    "cushion": {"model": "mathavan-2010", "restitution": 0.98, "friction": 0.14},
}
#: Distance of the ball's centre from the nose line at contact.
REACH = math.sqrt(RADIUS**2 - (NOSE - RADIUS) ** 2)


def rebound(incidence: float, roll: float, side: float = 0.0, speed: float = 1.0) -> Ball:
    """The ball just after a hit of the top rail.

    `incidence` (rad) is measured from the rail, which lies along +x; `roll` is k_T = ω_T R/V₀ and
    `side` is k_S = ω_z R/V₀.
    """
    vx, vy = speed * math.cos(incidence), speed * math.sin(incidence)
    spin = (-roll * vy / RADIUS, roll * vx / RADIUS, side * speed / RADIUS)
    run = simulate(
        ball(position=(1.0, 3.0 - REACH), velocity=(vx, vy, 0.0), spin=spin),
        physics=PHYSICS,
        table=TABLE,
    )
    return run.first("rail-collision").after["cue"]


def angle(after: Ball) -> float:
    """Rebound angle in degrees, from the rail's +x."""
    return math.degrees(math.atan2(-after.velocity[1], after.velocity[0]))


@row(
    "CU-1",
    "Rolling, perpendicular: rebound speed at any speed",
    unit="V₀",
    source="the paper's equations; Fig. 9 has .912, the film of 2009 an initial slope of .910",
    kind=Kind.FORMULA,
    reference={"0.5 m/s": 0.911, "1 m/s": 0.911, "2.4 m/s": 0.911},
    tolerance=relative(3e-3),
)
def cu_1() -> list[float]:
    return [rebound(math.pi / 2, 1.0, speed=v).speed / v for v in (0.5, 1.0, 2.4)]


@row(
    "CU-2",
    "Perpendicular, with backspin and without spin: rebound speed",
    unit="V₀",
    source="the paper's equations; as Fig. 9",
    kind=Kind.FORMULA,
    reference={"k_T = −1": 0.866, "k_T = 0": 0.837},
    tolerance=relative(3e-3),
)
def cu_2() -> list[float]:
    return [rebound(math.pi / 2, k).speed for k in (-1.0, 0.0)]


ANGLES = (10, 20, 30, 45, 60, 80)


@row(
    "CU-3",
    "Rolling, α from the rail: rebound speed",
    unit="V₀",
    source="the paper's equations integrated with 20 000 steps; as Fig. 9",
    kind=Kind.FORMULA,
    reference=dict(
        zip((f"α = {a}°" for a in ANGLES), (0.943, 0.895, 0.861, 0.848, 0.867, 0.905), strict=True)
    ),
    tolerance=relative(5e-3),
)
def cu_3_speed() -> list[float]:
    return [rebound(math.radians(a), 1.0).speed for a in ANGLES]


@row(
    "CU-3",
    "Rolling, α from the rail: rebound angle",
    unit="°",
    source="the paper's equations integrated with 20 000 steps; as Fig. 9",
    kind=Kind.FORMULA,
    reference=dict(
        zip((f"α = {a}°" for a in ANGLES), (10.34, 21.75, 34.0, 52.68, 68.83, 83.39), strict=True)
    ),
    tolerance=absolute(0.3),
)
def cu_3_angle() -> list[float]:
    return [angle(rebound(math.radians(a), 1.0)) for a in ANGLES]


SIDES = tuple((side, a) for side in (-1.0, 1.0) for a in (30, 60, 90))
SIDE_LABELS = tuple(f"k_S = {side:+.0f}, α = {a}°" for side, a in SIDES)


@row(
    "CU-6",
    "Rolling with sidespin: rebound speed",
    unit="V₀",
    source="the paper's equations integrated with 20 000 steps",
    kind=Kind.FORMULA,
    reference=dict(zip(SIDE_LABELS, (0.857, 0.867, 0.967, 0.909, 0.970, 0.968), strict=True)),
    tolerance=relative(5e-3),
)
def cu_6_speed() -> list[float]:
    return [rebound(math.radians(a), 1.0, side).speed for side, a in SIDES]


@row(
    "CU-6",
    "Rolling with sidespin: rebound angle",
    unit="°",
    source="the paper's equations integrated with 20 000 steps",
    kind=Kind.FORMULA,
    reference=dict(zip(SIDE_LABELS, (34.5, 73.4, 103.85, 30.5, 54.6, 76.0), strict=True)),
    tolerance=absolute(0.4),
)
def cu_6_angle() -> list[float]:
    return [angle(rebound(math.radians(a), 1.0, side)) for side, a in SIDES]


@row(
    "CU-7",
    "Perpendicular with +k_S and −k_S: the angles add up to 180° (not so in the paper's Fig. 10)",
    unit="°",
    source="mirror symmetry",
    kind=Kind.DERIVED,
    reference={"k_S = ±1": 180.0, "k_S = ±2": 180.0},
    tolerance=absolute(1e-9),
)
def cu_7() -> list[float]:
    return [
        angle(rebound(math.pi / 2, 1.0, k)) + angle(rebound(math.pi / 2, 1.0, -k))
        for k in (1.0, 2.0)
    ]
