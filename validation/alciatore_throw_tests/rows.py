"""Measured throw (Billiards Digest 2006; Alciatore's follow-up tests), beside the `pool` preset."""

import math

from carom.validation.lab import (
    FOOT,
    JSON,
    TP_SPEEDS,
    Run,
    ball,
    crossing,
    degrees_between,
    simulate,
    touching,
)
from carom.validation.row import Kind, absolute, row

RADIUS = 0.028575


def stun_hit(cut: float, speed: float, physics: JSON | str = "pool") -> Run:
    """A cue ball without spin along +y meets an object ball at `cut` rad."""
    return simulate(
        ball(velocity=(0.0, speed, 0.0), radius=RADIUS),
        ball("object", touching(cut, RADIUS), radius=RADIUS),
        physics=physics,
    )


def throw(cut_degrees: float, speed: float, physics: JSON | str = "pool") -> float:
    """Degrees by which the object ball leaves the line of centres."""
    cut = math.radians(cut_degrees)
    after = stun_hit(cut, speed, physics).first("ball-collision").after["object"]
    return degrees_between(math.pi / 2 + cut, after.heading)


def throw_at_object_speed(cut_degrees: float, target: float) -> float:
    """The throw at the cue ball speed that gives the object ball the speed `target`, m/s."""
    cut = math.radians(cut_degrees)

    def excess(speed: float) -> float:
        event = stun_hit(cut, speed).first("ball-collision")
        return event.after["object"].speed - target

    return throw(cut_degrees, crossing(excess, target, 2 * target, width=1e-6))


@row(
    "BB23",
    "Throw at 30°, stun, against the object ball's speed",
    unit="°",
    source="Alciatore, Throw follow-up II (2014 test, read off the plot)",
    kind=Kind.FITTED,
    reference={
        "2.8 ft/s": 6.05,
        "3.55 ft/s": 6.15,
        "4.5 ft/s": 5.5,
        "7.2 ft/s": 4.2,
        "10.7 ft/s": 3.45,
    },
    tolerance=absolute(0.5),
    misses=(
        "2.8 ft/s",
        "3.55 ft/s",
        "4.5 ft/s",
    ),
)
def bb23() -> list[float]:
    return [throw_at_object_speed(30.0, v * FOOT) for v in (2.8, 3.55, 4.5, 7.2, 10.7)]


CUTS = (10, 20, 30, 45, 60)


@row(
    "BB25",
    "Throw of stun shots at three speeds (only named in the source; taken as 1, 3 and 7 mph)",
    unit="°",
    source="Billiards Digest, September 2006, read off diagram 4",
    kind=Kind.FITTED,
    reference={
        f"{cut}°, {speed}": value
        for cut, values in zip(
            CUTS,
            (
                (1.6, 2.05, 1.55),
                (4.5, 3.5, 3.4),
                (4.5, 4.15, 3.45),
                (5.6, 3.9, 2.4),
                (4.6, 3.9, 2.05),
            ),
            strict=True,
        )
        for speed, value in zip(TP_SPEEDS, values, strict=True)
    },
    tolerance=absolute(0.5),
    misses=(
        "20°, medium",
        "20°, fast",
        "30°, slow",
        "30°, medium",
        "45°, medium",
        "60°, slow",
    ),
)
def bb25() -> list[float]:
    return [throw(cut, v) for cut in CUTS for v in TP_SPEEDS.values()]


#: Friction of the `pool` preset, fitted to the tests of 2006 and 2014 with compliant balls, and
#: Alciatore's factor for chalk at the contact point.
FRICTION = {"a": 0.0, "b": 0.115, "c": 0.41}
CHALK = 2.5


@row(
    "BB27",
    "Throw at 45°, slow, by the balls' surface: used (the default), chalked (2.5 × the friction)",
    unit="°",
    source="Alciatore, Throw follow-up I (also 11° cleaned with alcohol, 3.6° with ball cleaner)",
    kind=Kind.MEASURED,
    reference={"used": 4.9, "chalked": 11.6},
    tolerance=absolute(1.0),
)
def bb27() -> list[float]:
    chalked: JSON = {
        "base": "pool",
        "ball_ball": {"friction": {**FRICTION, "b": CHALK * FRICTION["b"]}},
    }
    slow = TP_SPEEDS["slow"]
    return [throw(45.0, slow), throw(45.0, slow, chalked)]
