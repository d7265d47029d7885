"""Ball on cloth: sliding, rolling, spinning, massé (technical proofs 4.1, A.4, A.18, A.19, B.2)."""

import math

from carom.validation.lab import (
    FOOT,
    MPH,
    TP_GRAVITY,
    TP_RADIUS,
    Run,
    ball,
    crossing,
    degrees_between,
    simulate,
    tp_physics,
)
from carom.validation.row import Kind, Range, absolute, relative, row

SPEEDS = {"3 mph": 3 * MPH, "7 mph": 7 * MPH, "12 mph": 12 * MPH}


def skid(speed: float, roll: float, friction: float = 0.2) -> Run:
    """A ball that moves along +y with `roll` times the spin of natural roll."""
    spin = (-roll * speed / TP_RADIUS, 0.0, 0.0)
    physics = tp_physics(cloth={"sliding_friction": friction})
    return simulate(ball(velocity=(0.0, speed, 0.0), spin=spin), physics=physics)


def distance_to_roll(speed: float, roll: float) -> float:
    return float(skid(speed, roll).rolling("cue").after["cue"].position[1])


def distance_to_stun(speed: float, roll: float) -> float:
    """Distance, m, at which the backspin is zero."""
    run = skid(speed, roll)
    time = crossing(
        lambda t: float(run.trace.at(t).angular_velocity[0][0]), 0.0, run.rolling("cue").time
    )
    return float(run.trace.at(time).position[0][1])


@row(
    "CL1",
    "Distance from stun to natural roll, μ_s = 0.2",
    unit="ft",
    source="TP 4.1",
    kind=Kind.PUBLISHED,
    reference={"3 mph": 0.737, "7 mph": 4.012, "12 mph": 11.789},
    tolerance=relative(1e-3),
)
def cl1() -> list[float]:
    return [distance_to_roll(v, 0.0) / FOOT for v in SPEEDS.values()]


@row(
    "CL3",
    "Tip ¼R below centre: distance to stun, and to natural roll",
    unit="ft",
    source="TP A.18",
    kind=Kind.PUBLISHED,
    reference={
        "3 mph, stun": 0.658,
        "7 mph, stun": 3.583,
        "12 mph, stun": 10.530,
        "3 mph, roll": 1.073,
        "7 mph, roll": 5.840,
        "12 mph, roll": 17.162,
    },
    tolerance=relative(1e-3),
)
def cl3() -> list[float]:
    stun = [distance_to_stun(v, -0.625) / FOOT for v in SPEEDS.values()]
    return stun + [distance_to_roll(v, -0.625) / FOOT for v in SPEEDS.values()]


@row(
    "CL5",
    "Tip ¼R above centre: distance to natural roll",
    unit="ft",
    source="TP A.18",
    kind=Kind.PUBLISHED,
    reference={"3 mph": 0.305, "7 mph": 1.661, "12 mph": 4.881},
    tolerance=relative(1e-3),
)
def cl5() -> list[float]:
    return [distance_to_roll(v, 0.625) / FOOT for v in SPEEDS.values()]


@row(
    "CL6",
    "Tip ½R above centre (more spin than roll): distance to natural roll",
    unit="ft",
    source="derived; TP A.18 prints 0.207, 1.128, 3.316 with a wrong sign of the friction",
    kind=Kind.DERIVED,
    reference={"3 mph": 0.2226, "7 mph": 1.2118, "12 mph": 3.5612},
    tolerance=relative(1e-3),
)
def cl6() -> list[float]:
    return [distance_to_roll(v, 1.25) / FOOT for v in SPEEDS.values()]


@row(
    "CL7",
    "Speed when rolling starts, as a fraction of the initial speed, at any friction",
    unit="v₀",
    source="TP 4.1; Shepard 1997; Leckie & Greenspan 2005",
    kind=Kind.FORMULA,
    reference={
        "stun, μ_s 0.1": 5 / 7,
        "stun, μ_s 0.4": 5 / 7,
        "reverse roll, μ_s 0.1": 3 / 7,
        "reverse roll, μ_s 0.4": 3 / 7,
        "2.5 × reverse roll, μ_s 0.1": 0.0,
        "2.5 × reverse roll, μ_s 0.4": 0.0,
    },
    tolerance=absolute(1e-9),
)
def cl7() -> list[float]:
    speed = 2.0
    ratios = []
    for roll in (0.0, -1.0, -2.5):
        for friction in (0.1, 0.4):
            end = skid(speed, roll, friction).first("motion-transition")
            ratios.append(float(end.after["cue"].velocity[1]) / speed)
    return ratios


@row(
    "CL10",
    "Massé: final direction from the initial one; tip ½R off, low right at 45°; elevation 4°",
    unit="°",
    source="TP A.19 eq. 7 (Coriolis)",
    kind=Kind.PUBLISHED,
    reference={
        "as a strike, 1 m/s": 2.193,
        "as a strike, 6 m/s": 2.193,
        "as a strike, μ_s 0.4": 2.193,
        "from the ball's velocities": 2.193,
    },
    tolerance=absolute(0.005),
)
def cl10() -> list[float]:
    offset = 0.5 * math.cos(math.radians(45.0))
    elevation = math.radians(4.0)

    def struck(speed: float, friction: float) -> float:
        run = simulate(
            ball(),
            physics=tp_physics(cue={"end_mass": 0.0}, cloth={"sliding_friction": friction}),
            strike={
                "ball": "cue",
                "speed": speed,
                "azimuth_deg": 90.0,
                "elevation_deg": 4.0,
                "side": offset,
                "height": -offset,
            },
        )
        return turn(run)

    def turn(run: Run) -> float:
        return degrees_between(math.pi / 2, run.rolling("cue").after["cue"].heading)

    v = 3.0
    spin = 2.5 * v * offset / TP_RADIUS
    moving = simulate(
        ball(
            velocity=(0.0, v * math.cos(elevation), 0.0),
            spin=(spin, spin * math.sin(elevation), 0.0),
        ),
        physics=tp_physics(),
    )
    return [struck(1.0, 0.2), struck(6.0, 0.2), struck(3.0, 0.4), turn(moving)]


def steep_masse() -> Run:
    """CL12: ball speed 9 mph along a cue at 75°, tip ¼R low and ¼R right."""
    v, elevation = 9.0 * MPH, math.radians(75.0)
    spin = 2.5 * v * 0.25 / TP_RADIUS
    return simulate(
        ball(
            velocity=(0.0, v * math.cos(elevation), 0.0),
            spin=(spin, spin * math.sin(elevation), 0.0),
        ),
        physics=tp_physics(),
    )


@row(
    "CL12",
    "Massé at 75°, from the ball's velocities (not a strike): end of the parabola",
    unit="s, m, m, m/s, °",
    source="closed form for the plot of TP A.19",
    kind=Kind.DERIVED,
    reference={
        "end of sliding, s": 0.6273,
        "lateral, m": 0.2177,
        "forward, m": 0.3346,
        "speed, m/s": 0.6944,
        "direction from aim, °": 87.908,
    },
    tolerance=relative(1e-3),
)
def cl12() -> list[float]:
    end = steep_masse().rolling("cue")
    cue = end.after["cue"]
    return [
        end.time,
        float(cue.position[0]),
        float(cue.position[1]),
        cue.speed,
        degrees_between(math.pi / 2, cue.heading),
    ]


@row(
    "CL14",
    "Slip while sliding: decreases at 7/2·μ_s g, in one direction, and ends at 2|u₀|/(7 μ_s g)",
    unit="ratio, ratio, rad",
    source="Leckie & Greenspan 2005; Han 2005; TP A.4",
    kind=Kind.FORMULA,
    reference={
        "|u| lost in half the time / (7/2 μ_s g t)": 1.0,
        "time of sliding / (2|u₀|/(7 μ_s g))": 1.0,
        "turn of û": 0.0,
    },
    tolerance=absolute(1e-9),
)
def cl14() -> list[float]:
    physics = tp_physics()
    run = simulate(ball(velocity=(0.7, 1.9, 0.0), spin=(31.0, -57.0, 44.0)), physics=physics)

    def slip(t: float) -> complex:
        now = run.trace.at(t)
        v, w = now.velocity[0], now.angular_velocity[0]
        return complex(v[0] - TP_RADIUS * w[1], v[1] + TP_RADIUS * w[0])

    end = run.first("motion-transition").time
    half = 0.5 * end
    rate = 3.5 * 0.2 * TP_GRAVITY
    lost = abs(slip(0.0)) - abs(slip(half))
    turn = math.atan2((slip(half) / slip(0.0)).imag, (slip(half) / slip(0.0)).real)
    return [lost / (rate * half), end / (abs(slip(0.0)) / rate), turn]


@row(
    "CL17",
    "Spin in place decreases by about 10 rad/s² (default of `pool`)",
    unit="rad/s²",
    source="TP B.2; Dr. Dave's properties FAQ",
    kind=Kind.FITTED,
    reference={"spin-down": Range(5.0, 15.0)},
)
def cl17() -> list[float]:
    spin = 40.0
    return [spin / simulate(ball(spin=(0.0, 0.0, spin))).record["duration"]]
