"""Shepard, Amateur Physics for the Amateur Pool Player, 3rd ed., 1997: problem 3.11."""

from carom.validation.alciatore_tp_strike.rows import strike
from carom.validation.lab import maximum
from carom.validation.row import Kind, absolute, row


def rolled_speed(height: float) -> float:
    """Speed of the rolling ball per cue speed, for an elastic tip."""
    run = strike(1.0, height=height, tip_restitution=1.0)
    return run.first("motion-transition").after["cue"].speed


@row(
    "CU6",
    "Tip height that makes the rolling ball fastest, elastic tip, m_r = 6/19",
    unit="R",
    source="Shepard 1997, problem 3.11; TP B.12: x = −1 + √(7/5 + 2/5 m_r)",
    kind=Kind.PUBLISHED,
    reference={"x": 0.235},
    tolerance=absolute(1e-3),
)
def cu6() -> list[float]:
    return [maximum(rolled_speed, 0.0, 0.5)[0]]
