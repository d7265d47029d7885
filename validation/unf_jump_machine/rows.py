"""The jump-cue machine of the University of North Florida (2006): two cues, launches and ranges."""

import math

from carom.validation.lab import INCH, JSON, Run, ball, crossing, simulate
from carom.validation.row import Kind, Range, relative, row

#: Launch angle, °, and speed, m/s, worked out from the measured ranges.
LAUNCHES = {"cue X": (25.2, 3.54), "cue Y": (27.6, 4.42)}


def launched(angle: float, speed: float) -> Run:
    """A ball that leaves the cloth towards +y, at an angle (°) and speed (m/s)."""
    up = math.radians(angle)
    velocity = (0.0, speed * math.cos(up), speed * math.sin(up))
    return simulate(ball(velocity=velocity))


def flight(run: Run) -> tuple[float, float]:
    """Range and apex of the first hop, m."""
    landing = run.first("slate-collision")
    apex = float(run.trace.at(landing.time / 2).position[0][2])
    return float(landing.after["cue"].position[1]), apex - float(landing.after["cue"].position[2])


#: A jump cue: half as heavy as a playing cue (Simpson 2000), with a phenolic tip of restitution
#: 0.87 (TP A.30) that is on the ball for 0.8 ms.
JUMP_CUE: JSON = {
    "base": "pool",
    "cue": {"mass": 0.25, "tip_restitution": 0.87},
    "contact_times": {"tip": 8e-4},
}


def struck(elevation: float, physics: JSON | str = "pool", speed: float = 3.0, *more: JSON) -> Run:
    """A centre-ball stroke along +y, by default of the `pool` cue; `more` balls are in the way."""
    strike = {"ball": "cue", "speed": speed, "azimuth_deg": 90.0, "elevation_deg": elevation}
    return simulate(ball(), *more, strike=strike, physics=physics)


def launch(elevation: float, physics: JSON | str = "pool") -> tuple[float, float]:
    """How the ball leaves the cloth: angle, °, and speed per cue speed."""
    run = struck(elevation, physics)
    rising = (e.after["cue"] for e in run.events if e.after["cue"].velocity[2] > 0.0)
    cue = next(rising)
    angle = math.degrees(math.atan2(cue.velocity[2], cue.speed))
    return angle, math.hypot(*cue.velocity) / 3.0


@row(
    "SL7",
    "Jump shots of a machine: range and apex of the launches worked out from the ranges",
    unit="in",
    source="UNF jump-cue machine, 2006",
    kind=Kind.READ_BACK,
    reference={
        "cue X: range": 38.80,
        "cue X: apex": 4.56,
        "cue Y: range": 64.28,
        "cue Y: apex": 8.39,
    },
    tolerance=relative(2e-2),
)
def sl7() -> list[float]:
    return [x / INCH for start in LAUNCHES.values() for x in flight(launched(*start))]


def elevation_for(angle: float, physics: JSON | str) -> float:
    """Elevation of the cue that makes the ball leave the cloth at `angle`, °."""
    return crossing(lambda e: launch(e, physics)[0] - angle, 5.0, 75.0, width=1e-6)


@row(
    "SL12",
    "Elevation and speed of a jump cue that give the machine's launches",
    unit="°, m/s",
    source="our own bar: a player can raise a jump cue and swing it so",
    kind=Kind.RANGE,
    reference={
        f"{name}: {what}": range_
        for name in LAUNCHES
        for what, range_ in (("elevation", Range(30.0, 65.0)), ("cue speed", Range(2.0, 7.0)))
    },
    note="Cue of 0.25 kg, phenolic tip (restitution 0.87, 0.8 ms), centre ball. The elevation of "
    "the machine's cues is not known to us. The `pool` cue, with a leather tip, does not reach "
    "these angles.",
)
def sl12() -> list[float]:
    numbers = []
    for angle, speed in LAUNCHES.values():
        elevation = elevation_for(angle, JUMP_CUE)
        numbers += [elevation, speed / launch(elevation, JUMP_CUE)[1]]
    return numbers


def jumps(physics: JSON | str, speed: float) -> float:
    """Whether a strike at 45° jumps a ball whose centre is 12 in away: 1 or 0."""
    run = struck(45.0, physics, speed, ball("object", position=(0.0, 12 * INCH)))
    return float(len(run.trace.outcome.jumped))


@row(
    "SL13",
    "Strike at 45° over a ball 12 in away: 1 if it jumps the ball",
    unit="–",
    source="Roque, Viking Cues 2017: 45° with a jump cue; Cuesight: a playing cue does not jump a "
    "whole ball so near",
    kind=Kind.RANGE,
    reference={
        "jump cue, 4.5 m/s": Range(1.0, 1.0),
        "jump cue, 6 m/s": Range(1.0, 1.0),
        "`pool` cue, 4.5 m/s": Range(0.0, 0.0),
    },
    note="The jump cue of SL12.",
)
def sl13() -> list[float]:
    return [jumps(JUMP_CUE, 4.5), jumps(JUMP_CUE, 6.0), jumps("pool", 4.5)]
