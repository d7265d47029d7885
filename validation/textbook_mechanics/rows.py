"""What follows from mechanics alone: a dropped ball, and a ball that tips over a lip."""

import math
from itertools import pairwise

from carom.validation.lab import Run, ball, simulate
from carom.validation.row import Kind, absolute, relative, row

GRAVITY, RADIUS = 9.81, 0.028575
#: The speed at which a ball flies off a lip, m/s.
FLIES = math.sqrt(GRAVITY * RADIUS)

#: How high the ball is dropped from, m, and what the slate returns.
DROP, RETURNED = 0.3, 0.5
#: The bounces that are compared.
BOUNCES = 4


def dropped(height: float = DROP, restitution: float = RETURNED) -> Run:
    """A ball without spin that falls on endless cloth."""
    physics = {
        "gravity": GRAVITY,
        "ball": {"radius": RADIUS},
        "slate": {"restitution": restitution, "friction": 0.2},
    }
    return simulate(ball(position=(0.0, 0.0, RADIUS + height)), physics=physics)


def apexes(run: Run) -> list[float]:
    """How high the ball rises after each bounce, m: read off its path half way to the next."""
    times = [e.time for e in run.all("slate-collision")]
    return [float(run.trace.at((a + b) / 2).position[0][2]) - RADIUS for a, b in pairwise(times)]


@row(
    "SL4",
    "A ball dropped from 0.3 m, e = 0.5: how high it rises again, and when it rests",
    unit="of the height, of the series",
    source="textbook: e²h, e⁴h …; √(2h/g)(1 + e)/(1 − e)",
    kind=Kind.DERIVED,
    reference={
        **{f"apex {k}": RETURNED ** (2 * k) for k in range(1, BOUNCES + 1)},
        "time of the bounces and the hops left out": 1.0,
    },
    tolerance=relative(1e-6),
)
def sl4() -> list[float]:
    run = dropped()
    last = list(run.all("slate-collision"))[-1]
    # What the last hop would have risen with goes on as the rest of the series.
    left_out = -RETURNED * float(last.before["cue"].velocity[2])
    rest = 2 * left_out / GRAVITY / (1 - RETURNED)
    series = math.sqrt(2 * DROP / GRAVITY) * (1 + RETURNED) / (1 - RETURNED)
    return [*(h / DROP for h in apexes(run)[:BOUNCES]), (last.time + rest) / series]


#: A side pocket so wide that nothing but its lip is met.
LIP_TABLE = {"base": "wpa-9ft"}
LIP_X = -0.0682625 + 0.0635


def over_the_lip(speed: float) -> Run:
    """A ball that rolls straight into a side pocket and comes to its lip with `speed`, m/s.

    Rolling friction 0 keeps the speed, and the lip grips as well as it must.
    """
    physics = {
        "base": "pool",
        "gravity": GRAVITY,
        "ball": {"radius": RADIUS},
        "cloth": {"rolling_friction": 0.0},
        "slate": {"restitution": 0.5, "friction": 1.0},
    }
    roll = ball(position=(0.1, 1.27), velocity=(-speed, 0.0, 0.0), spin=(0.0, -speed / RADIUS, 0.0))
    return simulate(roll, physics=physics, table=LIP_TABLE)


def lift_off(speed: float) -> float:
    """The angle from the vertical at which the ball last touches the lip, °; 0 if it flies off."""
    touches = list(over_the_lip(speed).all("slate-collision"))
    if not touches:
        return 0.0
    x, _, z = touches[-1].after["cue"].position
    return math.degrees(math.atan2(LIP_X - x, z))


def rolls_to(speed: float) -> float:
    """cos θ = (10 + 7v²/gR)/17."""
    return math.degrees(math.acos(min(1.0, (10 + 7 * (speed / FLIES) ** 2) / 17)))


#: Speeds at the lip as shares of √(gR).
SHARES = (0.05, 0.2, 0.4, 0.6, 0.8)


@row(
    "LIP-roll",
    "A ball that rolls over the lip of a hole leaves it at the angle from the vertical",
    unit="°",
    source="textbook: rolling without slip about an edge, cos θ = (10 + 7v²/gR)/17",
    kind=Kind.DERIVED,
    reference={f"v = {k:g} √(gR)": round(rolls_to(k * FLIES), 3) for k in SHARES},
    tolerance=absolute(4.0),
    note="The engine turns a ball about an edge in hops of some degrees: the last touch comes up "
    "to a hop before the angle.",
)
def lip_roll() -> list[float]:
    return [lift_off(k * FLIES) for k in SHARES]


@row(
    "LIP-fly",
    "From √(gR) up it flies off, and touches the lip no more",
    unit="touches",
    source="textbook: gravity cannot hold it on the edge",
    kind=Kind.DERIVED,
    reference={"v = 1.001 √(gR)": 0.0, "v = 3 √(gR)": 0.0},
    tolerance=absolute(0.0),
)
def lip_fly() -> list[float]:
    return [float(len(list(over_the_lip(k * FLIES).all("slate-collision")))) for k in (1.001, 3.0)]
