"""Mathavan, Jackson & Parkin 2014: a numerical analysis of billiard ball collisions.

Numerical simulations of the frictional collisions of solid balls on a rough surface, Sports
Engineering 17 (2014) 227–237: μ_bb = 0.05, e = 0.89, μ_s = 0.21, against the film of their 2009
paper. Shots 2–4 of its table; the inputs of shots 1 and 5 are not given.
"""

import math

from carom.validation.lab import JSON, ball, degrees_between, simulate, touching
from carom.validation.row import Kind, relative, row

RADIUS = 0.02625
#: Cue ball's speed (m/s) and cut angle (°) of shots 2–4.
SHOTS = ((1.032, 26.36), (1.364, 40.52), (1.731, 46.50))
PHYSICS: JSON = {
    "base": "snooker",
    "ball": {"mass": 0.1406, "radius": RADIUS},
    "cloth": {"sliding_friction": 0.21},
    "ball_ball": {"model": "mathavan-2014", "restitution": 0.89, "friction": 0.05},
}
QUANTITIES = ("cue ball, m/s", "object ball, m/s", "cue ball, °", "object ball, °")


def rolled_out(physics: JSON | str, speed: float, cut_degrees: float) -> list[float]:
    """Speeds (m/s) and directions (° from the initial one) when both balls roll."""
    run = simulate(
        ball(velocity=(0.0, speed, 0.0), spin=(-speed / RADIUS, 0.0, 0.0), radius=RADIUS),
        ball("object", touching(math.radians(cut_degrees), RADIUS), radius=RADIUS),
        physics=physics,
    )
    cue = run.rolling("cue").after["cue"]
    obj = run.rolling("object").after["object"]
    aim = math.pi / 2
    return [
        cue.speed,
        obj.speed,
        degrees_between(aim, cue.heading),
        degrees_between(obj.heading, aim),
    ]


@row(
    "BB22",
    "Collision of a rolling snooker ball: speeds and directions when both balls roll",
    unit="m/s, m/s, °, °",
    source="Mathavan 2014, table (which misprints 1.28 m/s as 0.128)",
    kind=Kind.PUBLISHED,
    reference={
        f"shot {n}, {quantity}": value
        for n, values in (
            (2, (0.520, 0.599, 32.45, 25.07)),
            (3, (0.917, 0.676, 29.91, 38.62)),
            (4, (1.28, 0.780, 27.32, 44.38)),
        )
        for quantity, value in zip(QUANTITIES, values, strict=True)
    },
    tolerance=relative(5e-3),
)
def bb22() -> list[float]:
    return [value for shot in SHOTS for value in rolled_out(PHYSICS, *shot)]
