"""Speeds of strikes and breaks (Onoda; Dr. Dave's FAQ), and the rebound from a rack (TP B.20)."""

import math

from carom.validation.lab import JSON, MPH, TP_RADIUS, ball, crossing, simulate, tp_physics
from carom.validation.row import Kind, Range, relative, row

#: Fastest break that must be simulated, mph; the record is about 35 mph.
FASTEST = 40.0
#: TP B.20 assumes no loss.
LOSSLESS: JSON = {"model": "elastic", "restitution": 1.0}


def rack(gap: float = 1e-4) -> list[JSON]:
    """Fifteen balls in a triangle along +y, `gap` m apart."""
    pitch = 2 * TP_RADIUS + gap
    return [
        ball(f"{row}-{k}", ((k - row / 2) * pitch, row * pitch * math.sqrt(3) / 2))
        for row in range(5)
        for k in range(row + 1)
    ]


def head_on(speed: float, ball_ball: JSON) -> tuple[float, bool]:
    """The cue ball's rebound speed, m/s, and whether all balls come to rest."""
    cue = ball(position=(0.0, -0.3), velocity=(0.0, speed, 0.0))
    run = simulate(cue, *rack(), physics=tp_physics(ball_ball=ball_ball))
    rebound = 0.0
    for event in run.all("ball-collision", "cue"):
        # The rack returns the impulse within a few milliseconds.
        if event.time < 0.3 / speed + 0.005:
            rebound = -float(event.after["cue"].velocity[1])
    return rebound, all(b.motion == "stationary" for b in run.final.values())


@row(
    "SY2",
    "30 mph cue ball head-on into a rack (15 balls, 0.1 mm apart, e = 1): its rebound",
    unit="mph",
    source="TP B.20: estimate v/5, from an effective rack mass of 1.5 balls; ±30 %",
    kind=Kind.RANGE,
    reference={"rebound": 6.0},
    tolerance=relative(0.3),
)
def sy2() -> list[float]:
    return [head_on(30 * MPH, LOSSLESS)[0] / MPH]


@row(
    "SY1",
    "Break speeds of men (22–26 mph) and women (18–22 mph), and 40 mph: all balls come to rest",
    unit="1 = yes",
    source="Onoda; Dr. Dave's FAQ",
    kind=Kind.DERIVED,
    reference={"18 mph": 1.0, "22 mph": 1.0, "26 mph": 1.0, f"{FASTEST:g} mph": 1.0},
)
def sy1() -> list[float]:
    law: JSON = {"model": "frictional", "restitution": 0.95, "friction": 0.05}
    return [float(head_on(v * MPH, law)[1]) for v in (18.0, 22.0, 26.0, FASTEST)]


def speed_for_lengths(lengths: float) -> float:
    """Speed (mph) of a stun shot that travels these lengths along the middle of a 9-ft table."""

    def excess(mph: float) -> float:
        run = simulate(
            ball(position=(0.635, 0.635), velocity=(0.0, mph * MPH, 0.0)), table="wpa-9ft"
        )
        path, y = 0.0, 0.635
        for event in run.all("rail-collision", "cue"):
            now = float(event.after["cue"].position[1])
            path, y = path + abs(now - y), now
        return (path + abs(float(run.final["cue"].position[1]) - y)) / 2.54 - lengths

    return crossing(excess, 1.0, 40.0, width=1e-4)


@row(
    "SY3",
    "Names of speeds: ball speed of a lag (two lengths) and of WPA's firm shot (four lengths)",
    unit="mph",
    source="Dr. Dave's FAQ: medium 2–4 (older page 5–7), power 7–10 (15–20) mph",
    kind=Kind.MEASURED,
    reference={"a lag is medium": Range(2.0, 7.0), "a firm shot is power": Range(7.0, 20.0)},
)
def sy3() -> list[float]:
    return [speed_for_lengths(2.0), speed_for_lengths(4.0)]
