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


def throw_at_object_speed(cut_degrees: float, target: float, physics: JSON | str = "pool") -> float:
    """The throw at the cue ball speed that gives the object ball the speed `target`, m/s."""
    cut = math.radians(cut_degrees)

    def excess(speed: float) -> float:
        event = stun_hit(cut, speed, physics).first("ball-collision")
        return event.after["object"].speed - target

    return throw(cut_degrees, crossing(excess, target, 2 * target, width=1e-6), physics)


def surface(friction: JSON | float | str) -> JSON:
    """The preset `pool` with another friction between the balls, or with a named surface."""
    return {"base": "pool", "ball_ball": {"friction": friction}}


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


#: Friction of a contact with chalk: the default of `carom.Noise` for a cling.
CHALK = 0.22
#: Friction of balls cleaned with alcohol, fitted to the one reading (scripts/contact_fits.json).
ALCOHOL = 0.198


@row(
    "BB23-dirty",
    "Throw at 30°, stun, against the object ball's speed: the surface `dirty`",
    unit="°",
    source="Alciatore, Throw follow-up II (2014 test, read off the plot)",
    kind=Kind.FITTED,
    reference=bb23.reference,
    tolerance=absolute(0.5),
    held=True,
)
def bb23_dirty() -> list[float]:
    physics = surface("dirty")
    speeds = (2.8, 3.55, 4.5, 7.2, 10.7)
    return [throw_at_object_speed(30.0, v * FOOT, physics) for v in speeds]


@row(
    "BB25-used",
    "Throw of stun shots at three speeds: the surface `used`",
    unit="°",
    source="Billiards Digest, September 2006, read off diagram 4",
    kind=Kind.FITTED,
    reference=bb25.reference,
    tolerance=absolute(0.5),
    misses=("10°, fast", "20°, medium", "45°, slow"),
    note="No friction that falls with the slip speed meets 30° slow and 45° slow together.",
)
def bb25_used() -> list[float]:
    physics = surface("used")
    return [throw(cut, v, physics) for cut in CUTS for v in TP_SPEEDS.values()]


@row(
    "BB27",
    "Throw at 45°, slow, by surface: `clean`, `used`, alcohol, and a contact that clings",
    unit="°",
    source="Alciatore, Throw follow-up I",
    kind=Kind.FITTED,
    reference={"ball cleaner": 3.6, "used": 4.9, "alcohol": 11.0, "chalked": 11.6},
    tolerance=absolute(0.5),
    held=True,
)
def bb27() -> list[float]:
    slow = TP_SPEEDS["slow"]
    return [throw(45.0, slow, surface(x)) for x in ("clean", "used", ALCOHOL, CHALK)]
