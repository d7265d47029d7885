"""Which paths a pocket accepts: against approach angle, offset and speed (proofs 3.5 to 3.8)."""

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

#: How far before the mouth the ball starts, m.
RUN_UP = 1.0
#: Offsets from the mouth's middle that are tried, m.
OFFSETS = np.arange(-0.1, 0.1001, 0.0005)
#: Tip height for natural roll from the strike on, in radii.
ROLLS = 0.4

#: The pockets of proofs 3.5 (side) and 3.8 (corner).
TABLE: JSON = {
    "base": "wpa-9ft",
    # Room behind the holes.
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
#: Facings that return nothing: a ball that touches one has no more energy to come out with.
DEAD: JSON = {"restitution": 0.0, "friction": 0.0}


class Pocket:
    """A pocket: its index, the middle of its mouth (m) and the direction out of it (rad)."""

    def __init__(self, index: int, middle: tuple[float, float], axis: float) -> None:
        self.index, self.middle, self.axis = index, middle, axis


SIDE = Pocket(2, (0.0, 1.27), 0.0)
#: Half the mouth, seen from either rail.
_TIP = 4.58125 * INCH / math.sqrt(8.0)
CORNER = Pocket(0, (_TIP, _TIP), math.pi / 4)


def physics(**sections: JSON) -> JSON:
    """A ball of 6 oz and a cue of 19 oz."""
    cue = {"mass": 0.17 / TP_MASS_RATIO, "end_mass": 0.0, "tip_restitution": 0.75}
    return tp_physics(cue=cue, **sections)


def shot_at(pocket: Pocket, angle: float, sections: JSON) -> carom.Shot:
    """A ball `RUN_UP` before the mouth's middle, at `angle` (rad) from the pocket's axis."""
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
    """Ball speed per cue speed of such a strike."""
    strike = {"ball": "cue", "speed": 1.0, "azimuth_deg": 0.0, "elevation_deg": 0.0}
    run = simulate(ball(), physics=physics(), strike={**strike, "side": 0.0, "height": ROLLS})
    return run.first("cue-strike").after["cue"].speed


def made(pocket: Pocket, angle: float, speed: float, **sections: JSON) -> Vector:
    """Which of `OFFSETS` go in, at `angle` (rad) from the axis and `speed` (m/s) at the mouth."""
    shot = shot_at(pocket, angle, sections)
    start = math.sqrt(speed**2 + 2 * 0.01 * 9.807 * RUN_UP) / speed_ratio()
    aims = pocket.axis + angle + math.pi + np.arcsin(OFFSETS / RUN_UP)
    result = shot.batch(speed=start, azimuth=aims)
    assert not result.errors, result.errors
    return np.asarray(result.pocket[:, 0] == pocket.index)


def width(pocket: Pocket, angle: float, speed: float, **sections: JSON) -> float:
    """How wide the target is: the sum of the offsets that go in, m."""
    step = float(OFFSETS[1] - OFFSETS[0])
    return step * float(np.count_nonzero(made(pocket, angle, speed, **sections)))


def steepest(pocket: Pocket, speed: float, up_to: float, **sections: JSON) -> float:
    """The largest angle from the axis at which any offset goes in, °, of those up to `up_to`."""
    angles = np.arange(30.0, up_to, 0.25)
    accepted = [a for a in angles if made(pocket, math.radians(a), speed, **sections).any()]
    return float(max(accepted, default=math.nan))


#: A row of a proof's largest angle, of which the proof's own rule is not known.
largest_angle = partial(
    row,
    unit="°",
    kind=Kind.UNKNOWN_RULE,
    tolerance=absolute(0.05),
    misses=("largest angle",),
)


@largest_angle(
    "PO1",
    "Side pocket, slow: the largest angle from its axis that goes in",
    source="TP 3.5, with its own idealised rule",
    reference={"largest angle": 68.292},
    note="Ours: 1 mph at the mouth, facings and points that return nothing.",
)
def po1() -> list[float]:
    return [steepest(SIDE, TP_SPEEDS["slow"], 80.0, facing=DEAD)]


@largest_angle(
    "PO3",
    "Corner pocket, fast: the largest angle from its axis that goes in",
    source="TP 3.8, with its own idealised rule",
    reference={"largest angle": 59.841},
    note="Ours: 7 mph at the mouth. A rail stands at 45° from the axis: nothing comes from beyond.",
)
def po3() -> list[float]:
    return [steepest(CORNER, TP_SPEEDS["fast"], 45.5)]


#: Approach angles at which speeds are compared, °.
CORNER_ANGLES, SIDE_ANGLES = (0.0, 20.0, 40.0), (0.0, 20.0, 40.0)


def widths(pocket: Pocket, angle: float) -> list[float]:
    """Target widths at the slow, medium and fast speed, mm."""
    return [1000 * width(pocket, math.radians(angle), v) for v in TP_SPEEDS.values()]


@row(
    "PO-speed",
    "Slower accepts more: target width lost from 1 to 3 mph, and from 3 to 7 mph",
    unit="mm",
    source="every player; Alciatore, pocket target sizes",
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
    "Steep accepts more at a side pocket: target width lost for each 15° from its axis",
    unit="mm",
    source="every player; Alciatore, pocket target sizes",
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
    """Whether a ball into the corner pocket meets a rail's nose before anything else."""
    shot = shot_at(CORNER, angle, {}).to_dict()
    shot["strike"]["azimuth_deg"] += math.degrees(math.asin(offset / RUN_UP))
    shot["strike"]["speed"] = speed / speed_ratio()
    for event in carom.Shot.from_dict(shot).simulate().to_dict()["events"]:
        if event["type"] == "rail-collision":
            return bool(event["part"] == "nose")
    return False


@row(
    "PO-rail",
    "Along the rail into a corner, slow: target width, and the part of it by the rail first",
    unit="mm",
    source="every player: a ball down the rail may touch it",
    kind=Kind.RANGE,
    reference={"direct": Range(1.0, math.inf), "by the rail first": Range(1.0, math.inf)},
)
def po_rail() -> list[float]:
    angle, speed = math.radians(-40.0), TP_SPEEDS["slow"]
    goes_in = OFFSETS[made(CORNER, angle, speed)]
    by_rail = [s for s in goes_in if touches_rail_first(angle, float(s), speed)]
    step = 1000 * float(OFFSETS[1] - OFFSETS[0])
    return [step * (len(goes_in) - len(by_rail)), step * len(by_rail)]
