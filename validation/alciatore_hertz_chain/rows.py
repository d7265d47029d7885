"""Alciatore, TP B.29 and TP B.20: balls that touch when one of them is struck.

Frictionless and without loss, as the proofs have it (`physics` "ideal"); the balls stand on cloth.
"""

from carom.validation.lab import JSON, MPH, TP_RADIUS, ball, simulate
from carom.validation.row import Kind, Range, absolute, row

IDEAL: JSON = {"base": "ideal", "ball": {"radius": TP_RADIUS}}


def chain(number: int, moving: int = 1, speed: float = 1.0) -> list[float]:
    """Speeds after balls in a row, the first `moving` of them at `speed`, hit those that rest."""
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
    "Three frozen balls in line, the first at 1 m/s: speeds after the impact",
    unit="m/s",
    source="TP B.29",
    kind=Kind.PUBLISHED,
    reference={"first": -0.071, "second": 0.076, "third": 0.995},
    tolerance=absolute(1e-3),
)
def bb19() -> list[float]:
    return chain(3)


def rack_rebound(speed: float) -> float:
    """Speed at which a cue ball comes back from fifteen frozen balls, hit in their axis."""
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
    "A cue ball of 30 mph hits a frozen rack: its rebound",
    unit="mph",
    source="TP B.20 (an estimate with a rack of 1.5 balls' mass, v/5 = 6 mph; ±30 %)",
    kind=Kind.RANGE,
    reference={"rebound": Range(0.7 * 6.0, 1.3 * 6.0)},
    tolerance=absolute(0.0),
)
def sy2() -> list[float]:
    return [rack_rebound(30.0 * MPH) / MPH]
