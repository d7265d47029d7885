"""Mathavan, Jackson & Parkin 2009: a snooker table filmed at high speed.

Application of high-speed imaging to determine the dynamics of billiards, Am. J. Phys. 77 (2009)
788–794. The measurements are shown beside the defaults of the `snooker` preset.
"""

from carom.validation.lab import JSON, ball, simulate
from carom.validation.mathavan_2014.rows import QUANTITIES, SHOTS, rolled_out
from carom.validation.row import Kind, Range, absolute, row

GRAVITY = 9.81


@row(
    "CL15",
    "Deceleration while rolling, and sliding friction (default of `snooker`)",
    unit="m/s², –",
    source="Mathavan 2009",
    kind=Kind.FITTED,
    reference={"rolling": Range(0.124, 0.126), "sliding": Range(0.178, 0.245)},
    held=True,
)
def cl15() -> list[float]:
    run = simulate(ball(velocity=(0.0, 1.0, 0.0)), physics="snooker")
    roll = run.rolling("cue")
    speed = roll.after["cue"].speed
    # From stun the ball loses 2/7 of its speed while it slides.
    return [speed / (run.record["duration"] - roll.time), (1.0 - speed) / roll.time / GRAVITY]


@row(
    "BB20",
    "Collision of a rolling ball: speeds and direction when both roll (default of `snooker`)",
    unit="m/s, m/s, °",
    source="Mathavan 2009, table",
    kind=Kind.FITTED,
    reference={
        f"{speed} m/s at {cut}°, {quantity}": value
        for (speed, cut), values in zip(
            SHOTS,
            ((0.520, 0.629, 33.20), (0.925, 0.700, 30.50), (1.275, 0.787, 27.97)),
            strict=True,
        )
        for quantity, value in zip(QUANTITIES[:3], values, strict=True)
    },
    tolerance=(absolute(0.03), absolute(0.03), absolute(1.5)),
    held=True,
)
def bb20() -> list[float]:
    return [value for shot in SHOTS for value in rolled_out("snooker", *shot)[:3]]


INCIDENT = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5)


def film(x: float) -> float:
    """The paper's fit to 31 rebounds, Fig. 9: speed after against speed before, m/s."""
    return -0.0877 * x * x + 1.131 * x - 0.0953


def rebound_speed(x: float, physics: JSON | str = "snooker") -> float:
    """Speed after a perpendicular hit of the top rail at x m/s, rolling."""
    start = 3.4
    run = simulate(
        ball(
            position=(0.889, start),
            velocity=(0.0, x, 0.0),
            spin=(-x / 0.02625, 0.0, 0.0),
            radius=0.02625,
        ),
        physics=physics,
        table="snooker-12ft",
    )
    event = run.first("rail-collision")
    # The ball slows a little before the rail: the ratio is taken from its speed at the rail.
    return event.after["cue"].speed * x / event.before["cue"].speed


@row(
    "CU-8",
    "Perpendicular rebound of a rolling ball (default of `snooker`)",
    unit="m/s",
    source="Mathavan 2009, Fig. 9 (31 shots)",
    kind=Kind.FITTED,
    reference={f"{x} m/s": round(film(x), 4) for x in INCIDENT},
    tolerance=absolute(0.05),
    held=True,
)
def cu_8() -> list[float]:
    return [rebound_speed(x) for x in INCIDENT]


def fitted_rail(abc: tuple[float, float, float], lowest: float, **more: float | str) -> JSON:
    """The preset `snooker` with a rail whose restitution was fitted to the film."""
    restitution = dict(zip("abc", abc, strict=True)) | {"lowest": lowest}
    return {"base": "snooker", "cushion": {"restitution": restitution, **more}}


#: The film's rail in two other models (scripts/contact_fits.json); the preset has `stronge`.
FILM_RAILS = {
    "restitution": fitted_rail((0.8665, 0.0828, -0.02958), 0.794, model="restitution"),
    "mathavan-2010": fitted_rail(
        (0.9348, 0.0849, -0.03162), 0.845, model="mathavan-2010", friction=0.14
    ),
}


@row(
    "CU-8-rails",
    "Perpendicular rebound of a rolling ball: restitution fitted in two other models",
    unit="m/s",
    source="Mathavan 2009, Fig. 9 (31 shots)",
    kind=Kind.FITTED,
    reference={
        f"{model}, {x} m/s": round(film(x), 4) for model in FILM_RAILS for x in (0.28, *INCIDENT)
    },
    tolerance=absolute(0.05),
    held=True,
)
def cu_8_rails() -> list[float]:
    rails = FILM_RAILS.values()
    return [rebound_speed(x, rail) for rail in rails for x in (0.28, *INCIDENT)]
