"""Kim 2024: a full hit by a rolling ball, with restitution."""

from carom.validation.alciatore_tp_collision.rows import impact
from carom.validation.row import absolute, row


@row(
    "BB18",
    "Full hit by a rolling cue ball: its speed once it rolls again",
    unit="v",
    source="Kim 2024 (formula): 2/7 + 5/14 (1 − e)",
    status="P",
    published={"e = 1": 0.2857, "e = .95": 0.3036, "e = .94": 0.3071, "e = .89": 0.3250},
    tolerance=absolute(1e-4),
)
def bb18() -> list[float]:
    return [
        impact(0.0, roll=1.0, restitution=e).rolling("cue").after["cue"].speed
        for e in (1.0, 0.95, 0.94, 0.89)
    ]
