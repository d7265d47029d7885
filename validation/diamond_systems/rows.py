"""Diamond systems of two and three rails: where a struck ball with sidespin arrives.

A system is not a measurement, but it was found on real tables, and many players use it. The sources
give neither the speed nor the spin in numbers, and no tolerance: ours is half a diamond.
"""

import json
import math
from importlib import resources
from typing import NamedTuple

from carom.validation.lab import INCH, JSON, Run, Vector, ball, crossing, simulate
from carom.validation.row import Kind, absolute, row

MEASURED: JSON = json.loads((resources.files("carom.validation") / "measured.json").read_text())

#: Distance of the sights behind the nose line (WPA), m.
SIGHT = 3.6875 * INCH


class SizedTable(NamedTuple):
    """A table, its width and length (m), and the radius of its balls (m)."""

    table: JSON | str
    width: float
    length: float
    radius: float


#: By preset of the physics. The pool table has no pockets here, because a system also counts
#: diamonds at pockets.
TABLES = {
    "pool": SizedTable({"length": 2.54, "width": 1.27, "pockets": "none"}, 1.27, 2.54, 0.028575),
    "carom": SizedTable("carom-10ft", 1.42, 2.84, 0.03075),
}
#: Speed of the cue, m/s. The ball has about 2.5 m/s at the first rail: "medium".
CUE_SPEED = 2.2
#: Height of the tip, ball radii: the ball rolls when it reaches the first rail.
HEIGHT = 0.3
#: Tip offsets to the side, ball radii: running English for the corner five (Rω_z/v = 0.75), "one
#: tip" for the plus system (0.5).
RUNNING, ONE_TIP = 0.3, 0.2

Line = tuple[tuple[float, float], tuple[float, float]]


def diamond(preset: str) -> float:
    """Distance of neighbouring sights of the long rail, m."""
    return TABLES[preset].length / 8


def heading(run: Run, preset: str) -> float:
    """Where the ball arrives on the left line of sights at its third rail, in diamonds from below.

    If it meets the top rail first, its line is extended. NaN if it stops before, or does not move
    to the left.
    """
    hits = list(run.all("rail-collision"))[:3]
    if len(hits) < 3 or hits[2].before["cue"].velocity[0] >= 0.0:
        return math.nan
    before = hits[2].before["cue"]
    slope = before.velocity[1] / -before.velocity[0]
    return float(before.position[1] + slope * (before.position[0] + SIGHT)) / diamond(preset)


def corner_five_line(preset: str, start: float, first: float) -> Line:
    """The sights from and to which the ball is played, in diamonds from the nose lines (TP 7.2).

    `start` and `first` are the numbers of the long rail and of the first rail. 5 is the top left
    corner, and along the long rail each diamond is half a number.
    """
    behind = SIGHT / diamond(preset)
    width = TABLES[preset].width / diamond(preset)
    return (-behind, 8.0 - 2.0 * (5.0 - start)), (width + behind, first)


def plus_line(preset: str, start: float, short: float) -> Line:
    """The same for the plus system: from the left rail to the number `short` of the bottom rail.

    The short rail's numbers are 3, 5 and 7 at its diamonds, the lowest farthest away.
    """
    behind = SIGHT / diamond(preset)
    return (-behind, start), ((9.0 - short) / 2.0, -behind)


def played(preset: str, line: Line, side: float) -> Run:
    """The strike with which the ball meets the first rail on the line.

    The azimuth is searched, as a player allows for squirt and swerve.
    """
    table = TABLES[preset].table
    (x, y), (to_x, to_y) = ((u * diamond(preset), v * diamond(preset)) for u, v in line)
    aim = math.atan2(to_y - y, to_x - x)
    # It starts on the line, well inside the table.
    run_in = 0.3 / math.cos(aim)
    start = (x + run_in * math.cos(aim), y + run_in * math.sin(aim))

    def shot(azimuth: float) -> Run:
        strike = {"ball": "cue", "speed": CUE_SPEED, "azimuth_deg": math.degrees(azimuth)}
        strike |= {"side": side, "height": HEIGHT}
        return simulate(ball("cue", start), physics=preset, table=table, strike=strike)

    def beside(azimuth: float) -> float:
        where: Vector = shot(azimuth).first("rail-collision").before["cue"].position
        return float((where[1] - y) * math.cos(aim) - (where[0] - x) * math.sin(aim))

    return shot(crossing(beside, aim - 0.1, aim + 0.1, width=1e-6))


CORNER_FIVE = MEASURED["corner_five"]
COMBINATIONS = tuple(zip(CORNER_FIVE["start"], CORNER_FIVE["first_rail"], strict=True))
PLUS = MEASURED["plus_two"]
PLUS_COMBINATIONS = tuple(zip(PLUS["start"], PLUS["short_rail"], strict=True))


@row(
    "DS-corner",
    "Corner-five system: third rail = start − first rail, running English (`carom`, `pool`)",
    unit="diamonds",
    source=CORNER_FIVE["source"],
    kind=Kind.MEASURED,
    held=True,
    uses_preset=True,
    reference={
        f"{preset}, {start:g} − {first:g}": float(start - first)
        for preset in ("carom", "pool")
        for start, first in COMBINATIONS
    },
    tolerance=absolute(CORNER_FIVE["tolerance"]),
    note="Half a diamond is our choice; the sources give no tolerance.",
)
def ds_corner() -> list[float]:
    return [
        heading(played(preset, corner_five_line(preset, *pair), RUNNING), preset)
        for preset in ("carom", "pool")
        for pair in COMBINATIONS
    ]


@row(
    "DS-plus",
    "Plus system, two rails: arrival = start + number of the short rail, one tip (`pool`)",
    unit="diamonds",
    source=PLUS["source"],
    kind=Kind.MEASURED,
    uses_preset=True,
    reference={f"{start} + {short}": float(start + short) for start, short in PLUS_COMBINATIONS},
    tolerance=absolute(PLUS["tolerance"]),
    misses=("3 + 5",),
    note="The arrival depends on the spin, which the source calls one tip: with 0.3 radii instead "
    "of 0.2, 3 + 5 arrives at 7.9.",
)
def ds_plus() -> list[float]:
    return [
        heading(played("pool", plus_line("pool", *pair), -ONE_TIP), "pool")
        for pair in PLUS_COMBINATIONS
    ]
