"""How hard people hit (Onoda; Dr. Dave's FAQ), and the break's head ball (TP B.20)."""

import math

from carom.validation.lab import JSON, MPH, TP_RADIUS, ball, simulate, tp_physics
from carom.validation.row import Range, relative, row

#: A break that still has to be simulated without trouble; the record is about 35 mph.
FASTEST = 40.0


def rack(gap: float = 1e-4) -> list[JSON]:
    """Fifteen balls in a triangle along +y, `gap` m apart."""
    pitch = 2 * TP_RADIUS + gap
    return [
        ball(f"{row}-{k}", ((k - row / 2) * pitch, row * pitch * math.sqrt(3) / 2))
        for row in range(5)
        for k in range(row + 1)
    ]


def head_on(speed: float, ball_ball: JSON) -> tuple[float, bool]:
    """The cue ball's rebound speed off the rack, and whether all came to rest."""
    cue = ball(position=(0.0, -0.3), velocity=(0.0, speed, 0.0))
    run = simulate(cue, *rack(), physics=tp_physics(ball_ball=ball_ball))
    rebound = 0.0
    for event in run.all("ball-collision", "cue"):
        # The rack hands its answer back within a few milliseconds.
        if event.time < 0.3 / speed + 0.005:
            rebound = -float(event.after["cue"].velocity[1])
    return rebound, all(b.motion == "stationary" for b in run.final.values())


@row(
    "SY2",
    "30 mph cue ball head-on into a rack (15 balls, 0.1 mm apart, e = 1): its rebound",
    unit="mph",
    source="TP B.20: an effective rack mass of 1.5 balls gives v/5",
    status="R",
    published={"rebound": 6.0},
    tolerance=relative(0.3),
)
def sy2() -> list[float]:
    return [head_on(30 * MPH, {"model": "elastic", "restitution": 1.0})[0] / MPH]


@row(
    "SY1",
    "Break speeds of men (22–26 mph) and women (18–22 mph), and 40 mph: all balls come to rest",
    unit="1 = they do",
    source="Onoda; Dr. Dave's FAQ",
    status="M",
    published={"18 mph": 1.0, "22 mph": 1.0, "26 mph": 1.0, f"{FASTEST:g} mph": 1.0},
)
def sy1() -> list[float]:
    law: JSON = {"model": "frictional", "restitution": 0.95, "friction": 0.05}
    return [float(head_on(v * MPH, law)[1]) for v in (18.0, 22.0, 26.0, FASTEST)]


@row(
    "SY3",
    "Names of speeds on a 9-ft table: lengths that a stunned ball covers along the middle",
    unit="lengths",
    source="Dr. Dave's FAQ: slow 1–2, medium 2–4, fast 4–7, power 7–10 mph (older pages: to 3, 7, "
    "12, 20)",
    status="M",
    published={
        "slow, 1–2 mph": Range(0.0, 1.5),
        "medium, 2–4 mph": Range(0.5, 3.0),
        "fast, 4–7 mph": Range(1.5, 5.0),
        "power, 7–10 mph": Range(3.0, 8.0),
    },
    note="The source gives names, not distances: the ranges are what the names promise a player.",
)
def sy3() -> list[float]:
    def lengths(mph: float) -> float:
        run = simulate(
            ball(position=(0.635, 0.635), velocity=(0.0, mph * MPH, 0.0)), table="wpa-9ft"
        )
        path, y = 0.0, 0.635
        for event in run.all("rail-collision", "cue"):
            now = float(event.after["cue"].position[1])
            path, y = path + abs(now - y), now
        return (path + abs(float(run.final["cue"].position[1]) - y)) / 2.54

    return [lengths(0.5 * (low + high)) for low, high in ((1, 2), (2, 4), (4, 7), (7, 10))]
