"""The jump-cue machine of the University of North Florida (2006): two cues, launches and ranges."""

import math

from carom.validation.lab import INCH, Run, ball, crossing, simulate
from carom.validation.row import Kind, relative, row

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


def struck(elevation: float) -> Run:
    """A centre-ball stroke of the `pool` cue at 3 m/s, along +y."""
    strike = {
        "ball": "cue",
        "speed": 3.0,
        "azimuth_deg": 90.0,
        "elevation_deg": elevation,
        "side": 0.0,
        "height": 0.0,
    }
    return simulate(ball(), strike=strike)


def launch_angle(elevation: float) -> float:
    """Angle at which a strike with this elevation (°) makes the ball leave the cloth, °."""
    cue = struck(elevation).first("slate-collision").after["cue"]
    return math.degrees(math.atan2(cue.velocity[2], cue.speed))


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
    return [x / INCH for launch in LAUNCHES.values() for x in flight(launched(*launch))]


def elevation_for(angle: float) -> float:
    """Elevation of the cue that makes the ball leave the cloth at `angle`, °."""
    return crossing(lambda e: launch_angle(e) - angle, 5.0, 60.0, width=1e-6)
