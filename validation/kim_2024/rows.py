"""Kim 2024: a full hit by a rolling ball, with restitution and friction."""

from carom.validation.alciatore_tp_collision.rows import impact
from carom.validation.lab import TP_GRAVITY, TP_RADIUS
from carom.validation.row import Kind, absolute, relative, row


@row(
    "BB18",
    "Full hit by a rolling cue ball: its speed when it rolls again",
    unit="v",
    source="Kim 2024 (formula): 2/7 + 5/14 (1 − e)",
    kind=Kind.FORMULA,
    reference={"e = 1": 0.2857, "e = .95": 0.3036, "e = .94": 0.3071, "e = .89": 0.3250},
    tolerance=absolute(1e-4),
)
def bb18() -> list[float]:
    return [
        impact(0.0, roll=1.0, restitution=e).rolling("cue").after["cue"].speed
        for e in (1.0, 0.95, 0.94, 0.89)
    ]


#: Speed, m/s, and friction of each hop.
HOPS = ((2.0, 0.06), (4.0, 0.03), (4.0, 0.06))


def hop(speed: float, friction: float) -> float:
    """Height of the cue ball's hop after a full hit, m."""
    run = impact(0.0, speed, roll=1.0, friction=friction)
    leaves = run.first("ball-collision").time
    lands = run.first("slate-collision", "cue").time
    return float(run.trace.at((leaves + lands) / 2).position[0][2]) - TP_RADIUS


@row(
    "BB-hop",
    "Full hit by a rolling ball, e = 1: height of the hop that friction at the contact causes",
    unit="m",
    source="Kim 2024 (formula): μ²U²/2g",
    kind=Kind.FORMULA,
    reference={f"{u:g} m/s, μ = {mu:g}": (mu * u) ** 2 / (2 * TP_GRAVITY) for u, mu in HOPS},
    tolerance=relative(1e-9),
)
def bb_hop() -> list[float]:
    return [hop(u, mu) for u, mu in HOPS]
