"""Stronge, Impact Mechanics (2000): a contact with a tangential spring.

The cushion of the engine's `stronge` model, its nose at the ball's centre so that the impact is
plane: β_t/β_n = 3.5, ω_t/ω_n = 1.7, e = 0.85, μ = 0.2.
"""

from carom.validation.lab import JSON, ball, simulate
from carom.validation.row import Kind, absolute, row

RADIUS = 0.028575
TABLE: JSON = {"length": 3.0, "width": 2.0, "pockets": "none", "cushion_height": RADIUS}
PHYSICS: JSON = {
    "base": "pool",
    "ball": {"radius": RADIUS},
    "cushion": {"model": "stronge", "restitution": 0.85, "friction": 0.2, "frequency_ratio": 1.7},
}
RATIOS = (0.05, 0.2, 0.4, 0.8, 1.2, 1.6)


def final_slip(ratio: float) -> float:
    """Tangential velocity of the contact point after the impact, per normal speed before it.

    `ratio` is |v_t|/v_n before it, in the negative sense.
    """
    run = simulate(
        ball(position=(1.0, 3.0 - RADIUS), velocity=(-ratio, 1.0, 0.0)),
        physics=PHYSICS,
        table=TABLE,
    )
    after = run.first("rail-collision").after["cue"]
    return float(after.velocity[0] - RADIUS * after.spin[2])


@row(
    "CU-11",
    "Tangential velocity of the contact after the impact",
    unit="v_n",
    source="an independent integration of the springs and pooltool's code, agreeing to 1e-5",
    kind=Kind.FORMULA,
    reference=dict(
        zip(
            (f"|v_t|/v_n = {r}" for r in RATIOS),
            (-0.00700, 0.02279, 0.19084, 0.38319, 0.09500, -0.30500),
            strict=True,
        )
    ),
    tolerance=absolute(1e-4),
)
def cu_11() -> list[float]:
    return [final_slip(r) for r in RATIOS]
