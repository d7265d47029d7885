"""Ball and rail: angles, spin, lags, banks (technical proofs 6.3, 7.3, B.6, B.28)."""

import math

from carom.validation.lab import (
    FOOT,
    INCH,
    JSON,
    MPH,
    TP_GRAVITY,
    TP_RADIUS,
    ball,
    crossing,
    simulate,
    tp_physics,
)
from carom.validation.row import Kind, absolute, relative, row

ANGLES = (15.0, 40.0, 70.0)
RESTITUTION = 0.7


def frictionless_rebound(angle: float) -> float:
    """tan θ_out of a ball that meets a frictionless rail at `angle` (rad) from its normal."""
    table: JSON = {"length": 3.0, "width": 2.0, "pockets": "none", "cushion_height": TP_RADIUS}
    law: JSON = {"model": "restitution", "restitution": RESTITUTION}
    run = simulate(
        ball(position=(1.0, 3.0 - TP_RADIUS), velocity=(math.sin(angle), math.cos(angle), 0.0)),
        physics=tp_physics(cushion=law),
        table=table,
    )
    after = run.first("rail-collision").after["cue"]
    return -float(after.velocity[0] / after.velocity[1])


@row(
    "CU-13",
    "Frictionless rail: tan θ_out = tan θ_in / e, e = 0.7",
    unit="–",
    source="TP 6.3",
    kind=Kind.FORMULA,
    reference={f"{a:g}° from the normal": math.tan(math.radians(a)) / RESTITUTION for a in ANGLES},
    tolerance=relative(1e-9),
)
def cu_13() -> list[float]:
    return [frictionless_rebound(math.radians(a)) for a in ANGLES]


@row(
    "CU-9",
    "TP 7.3's rail: v = 5 ft/s, rolling, e = 0.7, μ = 0.17, a = 0.08R",
    unit="ft/s, rad/s",
    source="TP 7.3",
    kind=Kind.FORMULA_ONLY,
    reference={"v′": 3.5, "ω′": 3.333},
    tolerance=absolute(0.01),
)
def cu_9() -> list[float]:
    v, e, mu, a = 5 * FOOT, 0.7, 0.17, 0.08 * TP_RADIUS
    spin = v / TP_RADIUS
    return [e * v / FOOT, 5 * (1 + e) * v * (mu * TP_RADIUS + a) / (2 * TP_RADIUS**2) - spin]


def lag_distance(speed: float) -> float:
    """Distance that a lagged ball travels in TP B.6, m.

    The ball starts rolling. At each rail it loses all its spin, and then slides from stun. The
    centre travels 100 in between the rails.
    """
    leg, mu_s, mu_r, e = 100 * INCH, 0.2, 0.01, 0.7
    travelled, left = 0.0, leg
    while True:
        roll = speed**2 / (2 * mu_r * TP_GRAVITY)
        if roll <= left:
            return travelled + roll
        rebound = e * math.sqrt(speed**2 - 2 * mu_r * TP_GRAVITY * left)
        slide = 12 * rebound**2 / (49 * mu_s * TP_GRAVITY)
        travelled += left + slide
        left = leg - slide
        speed = 5 / 7 * rebound


@row(
    "CU-14",
    "Lag on a 9-ft table, rolling start, stun after the rail: distance; speed for two lengths",
    unit="ft, ft, ft, mph",
    source="TP B.6",
    kind=Kind.FORMULA_ONLY,
    reference={
        "1.5 mph": 7.522,
        "3 mph": 14.033,
        "7 mph": 25.041,
        "two lengths": 3.465,
    },
    tolerance=relative(1e-3),
)
def cu_14() -> list[float]:
    two = crossing(lambda v: lag_distance(v * MPH) - 200 * INCH, 1.0, 7.0)
    return [*(lag_distance(v * MPH) / FOOT for v in (1.5, 3.0, 7.0)), two]


#: Distance of the sights behind the nose line (WPA), m.
SIGHT = 3.6875 * INCH
AIMS = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0)


def arrival(
    start: float,
    aim: float,
    table: str,
    size: tuple[float, float],
    physics: JSON | str = "pool",
) -> float:
    """The place at which a fast stun bank arrives, in diamonds along the rail that it started from.

    The ball moves from the sight `start` on the left rail towards the sight `aim` on the right
    rail, both counted from the corner, and meets the rail sliding, at 12 mph. The result is the
    point at which its line after the rail crosses the left line of sights.
    """
    width, length = size
    diamond, speed = length / 8, 12 * MPH
    direction = math.atan2((aim - start) * diamond, width + 2 * SIGHT)
    x = width - 0.05
    y = start * diamond + (x + SIGHT) * math.tan(direction)
    run = simulate(
        ball(
            position=(x, y),
            velocity=(speed * math.cos(direction), speed * math.sin(direction), 0.0),
        ),
        physics=physics,
        table=table,
    )
    after = run.first("rail-collision").after["cue"]
    slope = float(after.velocity[1] / -after.velocity[0])
    return (float(after.position[1]) + slope * (float(after.position[0]) + SIGHT)) / diamond


def bank(
    aim: float,
    table: str,
    size: tuple[float, float],
    physics: JSON | str = "pool",
) -> float:
    """The sight from which a bank towards the sight `aim` arrives at the corner."""
    return crossing(lambda start: arrival(start, aim, table, size, physics), aim, 8.0, width=1e-6)


NINE_FEET, SEVEN_FEET = ("wpa-9ft", (1.27, 2.54)), ("showood-7ft", (0.9906, 1.9812))

#: The tables of the source: a table of that size, and the preset with its rails.
TABLES = {
    "Olhausen 9 ft": (NINE_FEET, "pool"),
    "Gold Crown 9 ft": (NINE_FEET, "pool-gold-crown"),
    "Valley 7 ft": (SEVEN_FEET, "pool-valley"),
}


@row(
    "CU-16",
    "Fast sliding banks into the corner: the start for each aim (a preset for each table)",
    unit="diamonds",
    source="TP B.28",
    kind=Kind.FITTED,
    reference={
        f"{table}, aim {aim:g}": value
        for table, values in zip(
            TABLES,
            (
                (1.38, 2.72, 3.89, 5.07, 6.38, 7.74),
                (1.27, 2.88, 4.38, 5.38, 6.56, 7.96),
                (1.51, 2.74, 4.12, 5.19, 6.52, 7.54),
            ),
            strict=True,
        )
        for aim, value in zip(AIMS, values, strict=True)
    },
    tolerance=absolute(0.3),
    held=True,
    note="`pool` has the rails of the Olhausen, `pool-gold-crown` and `pool-valley` those of the "
    "others. The three presets differ in the friction of the rails alone.",
)
def cu_16() -> list[float]:
    return [bank(aim, *size, preset) for size, preset in TABLES.values() for aim in AIMS]
