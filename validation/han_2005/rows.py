"""Han 2005: dynamics in carom and three cushion billiards.

J. Mech. Sci. Technol. 19 (2005) 976–984: the cushion as one impulse at the nose, with
restitution and friction fitted to measurements, e = 0.39 + 0.257 V − 0.044 V² (V the normal speed,
m/s) and μ = 0.471 − 0.241 γ (γ the incidence from the normal, rad).
"""

import math

from carom.validation.lab import JSON, Ball, ball, simulate
from carom.validation.row import Kind, absolute, row

RADIUS = 0.03275
TABLE: JSON = {"length": 3.0, "width": 2.0, "pockets": "none", "cushion_height": RADIUS}
PHYSICS: JSON = {
    "base": "carom",
    "ball": {"mass": 0.23, "radius": RADIUS},
    "cushion": {
        "model": "han-2005",
        "restitution": {"a": 0.39, "b": 0.257, "c": -0.044},
        "friction": {"a": 0.471, "b": -0.241},
    },
}


def rebound(speed: float, incidence: float) -> Ball:
    """A ball without spin after a hit of the top rail, whose nose is level with its centre.

    `incidence` (rad) is measured from the rail's normal.
    """
    velocity = (speed * math.sin(incidence), speed * math.cos(incidence), 0.0)
    run = simulate(
        ball(position=(1.0, 3.0 - RADIUS), velocity=velocity), physics=PHYSICS, table=TABLE
    )
    return run.first("rail-collision").after["cue"]


SPEEDS = (0.5, 1.0, 2.0, 3.0)


@row(
    "HAN-e",
    "Restitution of a perpendicular hit, whose fit is a parameter of the model",
    unit="–",
    source="Han 2005 (fit e(V))",
    kind=Kind.READ_BACK,
    reference={f"{v} m/s": round(0.39 + 0.257 * v - 0.044 * v * v, 6) for v in SPEEDS},
    tolerance=absolute(1e-9),
)
def han_e() -> list[float]:
    return [-float(rebound(v, 0.0).velocity[1]) / v for v in SPEEDS]


INCIDENCES = (60.0, 70.0, 80.0)


@row(
    "HAN-mu",
    "Tangential over normal impulse of a slipping hit, whose fit is a parameter of the model",
    unit="–",
    source="Han 2005 (fit μ(γ)); 1 m/s",
    kind=Kind.READ_BACK,
    reference={f"γ = {g:g}°": round(0.471 - 0.241 * math.radians(g), 9) for g in INCIDENCES},
    tolerance=absolute(1e-9),
)
def han_mu() -> list[float]:
    found = []
    for g in INCIDENCES:
        gamma = math.radians(g)
        after = rebound(1.0, gamma)
        tangential = math.sin(gamma) - float(after.velocity[0])
        found.append(tangential / (math.cos(gamma) - float(after.velocity[1])))
    return found


def returned(speed: float) -> float:
    """Share of the speed that the rails of the preset `carom` return to a rolling ball."""
    radius = 0.03075
    run = simulate(
        ball(
            position=(0.71, 2.74),
            velocity=(0.0, speed, 0.0),
            spin=(-speed / radius, 0.0, 0.0),
        ),
        physics="carom",
        table="carom-10ft",
    )
    event = run.first("rail-collision")
    return event.after["cue"].speed / event.before["cue"].speed


DEFAULT_SPEEDS = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0)


@row(
    "HAN-default",
    "Share of the speed that a rail returns to a rolling ball at right angles (default of `carom`)",
    unit="–",
    source="Han 2005 (fit e(V))",
    kind=Kind.MEASURED,
    reference={f"{v} m/s": round(0.39 + 0.257 * v - 0.044 * v * v, 6) for v in DEFAULT_SPEEDS},
    tolerance=absolute(0.05),
    misses=tuple(f"{v} m/s" for v in (0.5, 1.0, 1.5, 2.0)),
    note="Han's rails return less of a slow ball than of a fast one. Those of the tracked match, "
    "which the preset has, return more of it. No law agrees with both.",
)
def han_default() -> list[float]:
    return [returned(v) for v in DEFAULT_SPEEDS]
