"""Alciatore, TP B.29 and TP B.20: balls that touch when one of them is struck.

As in the proofs there is no friction and no loss (`physics` "ideal"); the balls stand on cloth.
"""

from carom.validation.lab import JSON, MPH, TP_RADIUS, ball, simulate
from carom.validation.row import Kind, Range, absolute, row

IDEAL: JSON = {"base": "ideal", "ball": {"radius": TP_RADIUS}}


def chain(number: int, moving: int = 1, speed: float = 1.0) -> list[float]:
    """Speeds, m/s, after the first `moving` balls of a row hit the others at `speed` m/s."""
    balls = [
        ball(
            str(k),
            (2.0 * TP_RADIUS * k, 0.0),
            (speed if k < moving else 0.0, 0.0, 0.0),
        )
        for k in range(number)
    ]
    after = simulate(*balls, physics=IDEAL).first("ball-collision").after
    return [float(after[str(k)].velocity[0]) for k in range(number)]


@row(
    "BB19",
    "Three frozen balls in a row, the first at 1 m/s: speeds after the impact",
    unit="m/s",
    source="TP B.29",
    kind=Kind.PUBLISHED,
    reference={"first": -0.071, "second": 0.076, "third": 0.995},
    tolerance=absolute(1e-3),
)
def bb19() -> list[float]:
    return chain(3)


def rack_rebound(speed: float) -> float:
    """The cue ball's rebound speed from fifteen frozen balls, hit along the axis of the rack."""
    step = 2.0 * TP_RADIUS
    rack = [
        ball(f"{line}{k}", (0.75**0.5 * step * line, step * (k - 0.5 * line)))
        for line in range(5)
        for k in range(line + 1)
    ]
    cue = ball("cue", (-step, 0.0), (speed, 0.0, 0.0))
    after = simulate(cue, *rack, physics=IDEAL).first("ball-collision", "cue").after
    return -float(after["cue"].velocity[0])


@row(
    "SY2",
    "A cue ball of 30 mph hits a frozen rack: rebound speed",
    unit="mph",
    source="TP B.20: estimate v/5 = 6 mph, from a rack of 1.5 balls' mass; ±30 %",
    kind=Kind.RANGE,
    reference={"rebound": Range(0.7 * 6.0, 1.3 * 6.0)},
    tolerance=absolute(0.0),
)
def sy2() -> list[float]:
    return [rack_rebound(30.0 * MPH) / MPH]
