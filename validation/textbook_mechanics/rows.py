"""Results of textbook mechanics: a dropped ball, and a ball that tips over a lip."""

import math
from itertools import pairwise

from carom.validation.lab import Run, ball, simulate
from carom.validation.row import Kind, absolute, relative, row

GRAVITY, RADIUS = 9.81, 0.028575
#: The least speed at which a ball flies off a lip, m/s.
FLIES = math.sqrt(GRAVITY * RADIUS)

#: Height from which the ball is dropped, m, and restitution of the slate.
DROP, RETURNED = 0.3, 0.5
#: Number of bounces that are compared.
BOUNCES = 4


def dropped(height: float = DROP, restitution: float = RETURNED) -> Run:
    """A ball without spin that falls on unbounded cloth."""
    physics = {
        "gravity": GRAVITY,
        "ball": {"radius": RADIUS},
        "slate": {"restitution": restitution, "friction": 0.2},
    }
    return simulate(ball(position=(0.0, 0.0, RADIUS + height)), physics=physics)


def apexes(run: Run) -> list[float]:
    """Height to which the ball rises after each bounce, m: half-way to the next bounce."""
    times = [e.time for e in run.all("slate-collision")]
    return [float(run.trace.at((a + b) / 2).position[0][2]) - RADIUS for a, b in pairwise(times)]


@row(
    "SL4",
    "A ball dropped from 0.3 m, e = 0.5: heights of the bounces, and time until rest",
    unit="per height, per time of the series",
    source="textbook: e²h, e⁴h …; √(2h/g)(1 + e)/(1 − e)",
    kind=Kind.DERIVED,
    reference={
        **{f"apex {k}": RETURNED ** (2 * k) for k in range(1, BOUNCES + 1)},
        "time of the bounces, and of those left out": 1.0,
    },
    tolerance=relative(1e-6),
)
def sl4() -> list[float]:
    run = dropped()
    last = list(run.all("slate-collision"))[-1]
    # The engine leaves out the rest of the series after the last hop; its time is added here.
    left_out = -RETURNED * float(last.before["cue"].velocity[2])
    rest = 2 * left_out / GRAVITY / (1 - RETURNED)
    series = math.sqrt(2 * DROP / GRAVITY) * (1 + RETURNED) / (1 - RETURNED)
    return [*(h / DROP for h in apexes(run)[:BOUNCES]), (last.time + rest) / series]


#: The table whose side pocket the ball rolls into, and the x of that pocket's lip, m.
LIP_TABLE = {"base": "wpa-9ft"}
LIP_X = -0.0682625 + 0.0635


def over_the_lip(speed: float) -> Run:
    """A ball that rolls straight into a side pocket and comes to its lip with `speed`, m/s.

    The rolling friction is 0, so that the speed stays; the friction of the lip is large enough to
    prevent slip.
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
    """Angle from the vertical at which the ball last touches the lip, °; 0 if it flies at once."""
    touches = list(over_the_lip(speed).all("slate-collision"))
    if not touches:
        return 0.0
    x, _, z = touches[-1].after["cue"].position
    return math.degrees(math.atan2(LIP_X - x, z))


def rolls_to(speed: float) -> float:
    """The angle θ, °, of cos θ = (10 + 7v²/gR)/17."""
    return math.degrees(math.acos(min(1.0, (10 + 7 * (speed / FLIES) ** 2) / 17)))


#: Speeds at the lip, in units of √(gR).
SHARES = (0.05, 0.2, 0.4, 0.6, 0.8)


@row(
    "LIP-roll",
    "A ball that rolls over a hole's lip: the angle from the vertical at which it leaves the lip",
    unit="°",
    source="textbook: rolling without slip about an edge, cos θ = (10 + 7v²/gR)/17",
    kind=Kind.DERIVED,
    reference={f"v = {k:g} √(gR)": round(rolls_to(k * FLIES), 3) for k in SHARES},
    tolerance=absolute(4.0),
    note="In the engine a ball turns about an edge in hops of a few degrees. Its last touch is up "
    "to one hop before the angle, so all differences are negative.",
)
def lip_roll() -> list[float]:
    return [lift_off(k * FLIES) for k in SHARES]


@row(
    "LIP-fly",
    "At √(gR) or faster the ball flies off: number of touches of the lip",
    unit="touches",
    source="textbook: at this speed gravity does not keep it on the edge",
    kind=Kind.DERIVED,
    reference={"v = 1.001 √(gR)": 0.0, "v = 3 √(gR)": 0.0},
    tolerance=absolute(0.0),
)
def lip_fly() -> list[float]:
    return [float(len(list(over_the_lip(k * FLIES).all("slate-collision")))) for k in (1.001, 3.0)]
