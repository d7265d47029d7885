"""Measured throw (Billiards Digest 2006; Alciatore's follow-up tests).

The balls of each test have a preset of their own: `pool` has used balls, `pool-clean-balls` and
`pool-dirty-balls` cleaned and dirty ones.
"""

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


#: Speeds of the object ball in the test of 2014, ft/s.
OBJECT_SPEEDS = (2.8, 3.55, 4.5, 7.2, 10.7)


@row(
    "BB23",
    "Throw at 30°, stun, against the object ball's speed (`pool-dirty-balls`)",
    unit="°",
    source="Alciatore, Throw follow-up II (2014 test, read off the plot)",
    kind=Kind.FITTED,
    reference={
        f"{v:g} ft/s": angle
        for v, angle in zip(OBJECT_SPEEDS, (6.05, 6.15, 5.5, 4.2, 3.45), strict=True)
    },
    tolerance=absolute(0.5),
    held=True,
)
def bb23() -> list[float]:
    return [throw_at_object_speed(30.0, v * FOOT, "pool-dirty-balls") for v in OBJECT_SPEEDS]


CUTS = (10, 20, 30, 45, 60)


@row(
    "BB25",
    "Throw of stun shots at three speeds, only named in the source and taken as 1, 3 and 7 mph "
    "(`pool`)",
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
    misses=("10°, fast", "20°, medium", "45°, slow"),
    note="No friction that falls with the slip speed meets 30° slow and 45° slow together.",
)
def bb25() -> list[float]:
    return [throw(cut, v) for cut in CUTS for v in TP_SPEEDS.values()]


#: Gap between the balls before the strike of BB27, m. The cue ball hardly gains roll over it, and
#: the tip has left the cue ball before it meets the object ball.
GAP = 0.002


def struck_throw(cut_degrees: float, speed: float, friction: float | None = None) -> float:
    """The same throw from a strike with the preset `pool`, the cue ball `GAP` from the contact.

    `speed` is that of the cue ball at the object ball, m/s. `friction` is that of a contact that
    clings.
    """
    cut = math.radians(cut_degrees)
    x, y = touching(cut, RADIUS)

    def played(cue_speed: float) -> Run:
        strike: JSON = {"ball": "cue", "speed": cue_speed, "azimuth_deg": 90.0}
        strike |= {"elevation_deg": 0.0, "side": 0.0, "height": 0.0}
        cling = None if friction is None else {"contacts": [0], "friction": friction}
        return simulate(ball(), ball("object", (x, y + GAP)), strike=strike, cling=cling)

    def excess(cue_speed: float) -> float:
        return played(cue_speed).first("ball-collision").before["cue"].speed - speed

    run = played(crossing(excess, 0.5 * speed, 2.0 * speed, width=1e-6))
    after = run.first("ball-collision").after["object"]
    return degrees_between(math.pi / 2 + cut, after.heading)


@row(
    "BB27",
    "Throw at 45°, slow, used balls: from a strike (`pool`)",
    unit="°",
    source="Alciatore, Throw follow-up I",
    kind=Kind.MEASURED,
    reference={"used": 4.9},
    tolerance=absolute(0.5),
    held=True,
    uses_preset=True,
    note="The friction was fitted to the test of 2006, which had other balls.",
)
def bb27() -> list[float]:
    return [struck_throw(45.0, TP_SPEEDS["slow"])]


#: Friction of a contact with chalk: the default of `carom.Noise` for a cling.
CHALK = 0.22
#: Friction of balls cleaned with alcohol, fitted to the one reading (scripts/contact_fits.json).
ALCOHOL = 0.198


@row(
    "BB27-surfaces",
    "Throw at 45°, slow: `pool-clean-balls`, a constant friction, and a contact that clings",
    unit="°",
    source="Alciatore, Throw follow-up I",
    kind=Kind.FITTED,
    reference={"ball cleaner": 3.6, "cleaned with alcohol": 11.0, "chalked": 11.6},
    tolerance=absolute(0.5),
    held=True,
)
def bb27_surfaces() -> list[float]:
    slow = TP_SPEEDS["slow"]
    return [
        throw(45.0, slow, "pool-clean-balls"),
        throw(45.0, slow, {"base": "pool", "ball_ball": {"friction": ALCOHOL}}),
        struck_throw(45.0, slow, CHALK),
    ]
