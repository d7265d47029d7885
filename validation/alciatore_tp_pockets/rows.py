"""Pocket acceptance by approach angle, offset and speed (technical proofs 3.5 to 3.8)."""

import math
from functools import cache, partial

import carom
import numpy as np
from carom.validation.lab import (
    INCH,
    JSON,
    TP_MASS_RATIO,
    TP_SPEEDS,
    Vector,
    ball,
    simulate,
    tp_physics,
)
from carom.validation.row import Kind, Range, absolute, row

#: Distance from the ball's start to the middle of the mouth, m.
RUN_UP = 1.0
#: Offsets of the path from the middle of the mouth, m.
OFFSETS = np.arange(-0.1, 0.1001, 0.0005)
#: Tip height that gives natural roll, in radii.
ROLLS = 0.4

#: The pockets of proofs 3.5 (side) and 3.8 (corner).
TABLE: JSON = {
    "base": "wpa-9ft",
    # Room for the holes.
    "rail_width": 0.18,
    "side_pocket": {
        "mouth": 5.0625 * INCH,
        "cut_angle_deg": 104.0,
        "shelf": 0.1875 * INCH,
        "hole_radius": 3.0 * INCH,
    },
    "corner_pocket": {
        "mouth": 4.58125 * INCH,
        "cut_angle_deg": 142.0,
        "shelf": 1.125 * INCH,
        "hole_radius": 2.75 * INCH,
    },
}
#: Facings without rebound, for the proof's slow ball.
DEAD: JSON = {"restitution": 0.0, "friction": 0.0}


class Pocket:
    """A pocket: its index, the middle of its mouth (m) and its axis, out of the pocket (rad)."""

    def __init__(self, index: int, middle: tuple[float, float], axis: float) -> None:
        self.index, self.middle, self.axis = index, middle, axis


SIDE = Pocket(2, (0.0, 1.27), 0.0)
#: Coordinate of the middle of a corner's mouth, from either rail, m.
_TIP = 4.58125 * INCH / math.sqrt(8.0)
CORNER = Pocket(0, (_TIP, _TIP), math.pi / 4)


def physics(**sections: JSON) -> JSON:
    """Physics with a ball of 6 oz and a cue of 19 oz."""
    cue = {"mass": 0.17 / TP_MASS_RATIO, "end_mass": 0.0, "tip_restitution": 0.75}
    return tp_physics(cue=cue, **sections)


def shot_at(pocket: Pocket, angle: float, sections: JSON) -> carom.Shot:
    """A shot at the middle of the mouth from `RUN_UP`, at `angle` (rad) from the pocket's axis."""
    out = pocket.axis + angle
    place = np.array(pocket.middle) + RUN_UP * np.array((math.cos(out), math.sin(out)))
    cue = ball(position=place)
    del cue["velocity"], cue["angular_velocity"]
    return carom.Shot.from_dict(
        {
            "format": "carom-shot/1",
            "table": TABLE,
            "physics": physics(**sections),
            "balls": [cue],
            "strike": {
                "ball": "cue",
                "speed": 1.0,
                "azimuth_deg": math.degrees(out) + 180.0,
                "elevation_deg": 0.0,
                "side": 0.0,
                "height": ROLLS,
            },
        }
    )


@cache
def speed_ratio() -> float:
    """Ball speed per cue speed of the strikes of `shot_at`."""
    strike = {"ball": "cue", "speed": 1.0, "azimuth_deg": 0.0, "elevation_deg": 0.0}
    run = simulate(ball(), physics=physics(), strike={**strike, "side": 0.0, "height": ROLLS})
    return run.first("cue-strike").after["cue"].speed


def made(pocket: Pocket, angle: float, speed: float, **sections: JSON) -> Vector:
    """Which of `OFFSETS` are pocketed at `angle` (rad) and `speed` (m/s, at the mouth)."""
    shot = shot_at(pocket, angle, sections)
    start = math.sqrt(speed**2 + 2 * 0.01 * 9.807 * RUN_UP) / speed_ratio()
    aims = pocket.axis + angle + math.pi + np.arcsin(OFFSETS / RUN_UP)
    result = shot.batch(speed=start, azimuth=aims)
    assert not result.errors, result.errors
    return np.asarray(result.pocket[:, 0] == pocket.index)


def width(pocket: Pocket, angle: float, speed: float, **sections: JSON) -> float:
    """Target width: the total width of the offsets that are pocketed, m."""
    step = float(OFFSETS[1] - OFFSETS[0])
    return step * float(np.count_nonzero(made(pocket, angle, speed, **sections)))


def steepest(pocket: Pocket, speed: float, up_to: float, **sections: JSON) -> float:
    """The largest angle from the axis, up to `up_to`, at which any offset is pocketed, °."""
    angles = np.arange(30.0, up_to, 0.25)
    accepted = [a for a in angles if made(pocket, math.radians(a), speed, **sections).any()]
    return float(max(accepted, default=math.nan))


#: A row of the largest angle of a proof whose rule is not known.
largest_angle = partial(
    row,
    unit="°",
    kind=Kind.UNKNOWN_RULE,
    tolerance=absolute(0.05),
    misses=("largest angle",),
)


@largest_angle(
    "PO1",
    "Side pocket, slow: the largest angle from its axis that is pocketed",
    source="TP 3.5, with its own idealised rule",
    reference={"largest angle": 68.292},
    note="Ours: 1 mph at the mouth, facings and points without rebound.",
)
def po1() -> list[float]:
    return [steepest(SIDE, TP_SPEEDS["slow"], 80.0, facing=DEAD)]


@largest_angle(
    "PO3",
    "Corner pocket, fast: the largest angle from its axis that is pocketed",
    source="TP 3.8, with its own idealised rule",
    reference={"largest angle": 59.841},
    note="Ours: 7 mph at the mouth. The rail is at 45° from the axis, so larger angles "
    "are impossible.",
)
def po3() -> list[float]:
    return [steepest(CORNER, TP_SPEEDS["fast"], 45.5)]


#: Approach angles of the comparison of speeds, °.
CORNER_ANGLES, SIDE_ANGLES = (0.0, 20.0, 40.0), (0.0, 20.0, 40.0)


def widths(pocket: Pocket, angle: float) -> list[float]:
    """Target widths of slow, medium and fast shots, mm."""
    return [1000 * width(pocket, math.radians(angle), v) for v in TP_SPEEDS.values()]


@row(
    "PO-speed",
    "A slower ball has a wider target: width lost from 1 to 3 mph, and from 3 to 7 mph",
    unit="mm",
    source="common experience; Alciatore, pocket target sizes",
    kind=Kind.RANGE,
    reference={
        f"{name} at {angle:g}°, {step}": Range(0.0, math.inf)
        for name, angles in (("corner", CORNER_ANGLES), ("side", SIDE_ANGLES))
        for angle in angles
        for step in ("1 to 3 mph", "3 to 7 mph")
    },
)
def po_speed() -> list[float]:
    lost = []
    for pocket, angles in ((CORNER, CORNER_ANGLES), (SIDE, SIDE_ANGLES)):
        for angle in angles:
            slow, medium, fast = widths(pocket, angle)
            lost += [slow - medium, medium - fast]
    return lost


@row(
    "PO-angle",
    "A side pocket's target is widest along its axis: width lost in steps of 15° from it",
    unit="mm",
    source="common experience; Alciatore, pocket target sizes",
    kind=Kind.RANGE,
    reference={f"{a:g}° to {a + 15:g}°, {s}": Range(0.0, math.inf)
               for s in TP_SPEEDS for a in (15.0, 30.0, 45.0)},
)  # fmt: skip
def po_angle() -> list[float]:
    return [
        1000 * (width(SIDE, math.radians(a), v) - width(SIDE, math.radians(a + 15.0), v))
        for v in TP_SPEEDS.values()
        for a in (15.0, 30.0, 45.0)
    ]


def touches_rail_first(angle: float, offset: float, speed: float) -> bool:
    """Whether the first thing that a ball on its way into the corner meets is a rail's nose."""
    shot = shot_at(CORNER, angle, {}).to_dict()
    shot["strike"]["azimuth_deg"] += math.degrees(math.asin(offset / RUN_UP))
    shot["strike"]["speed"] = speed / speed_ratio()
    for event in carom.Shot.from_dict(shot).simulate().to_dict()["events"]:
        if event["type"] == "rail-collision":
            return bool(event["part"] == "nose")
    return False


@row(
    "PO-rail",
    "Along the rail into a corner, slow: target width of direct paths and of those by the rail",
    unit="mm",
    source="common experience: a ball along the rail may touch it",
    kind=Kind.RANGE,
    reference={"direct": Range(1.0, math.inf), "by the rail first": Range(1.0, math.inf)},
)
def po_rail() -> list[float]:
    angle, speed = math.radians(-40.0), TP_SPEEDS["slow"]
    goes_in = OFFSETS[made(CORNER, angle, speed)]
    by_rail = [s for s in goes_in if touches_rail_first(angle, float(s), speed)]
    step = 1000 * float(OFFSETS[1] - OFFSETS[0])
    return [step * (len(goes_in) - len(by_rail)), step * len(by_rail)]
