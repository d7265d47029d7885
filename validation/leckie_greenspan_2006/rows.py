"""Leckie & Greenspan 2006: pool physics simulation by event prediction II, collisions.

ICGA Journal 29 (2006) 24–31. The rows repeat its experiments: operation counts (section 3), 100 000
random shots for each root finder (section 3), and the fixed-step simulator that the paper argues
against (section 2).
"""

from __future__ import annotations

import json
import statistics
from functools import cache
from importlib import resources

import numpy as np
from carom.validation.lab import JSON, Run, ball
from carom.validation.lab import simulate as simulate_events
from carom.validation.leckie_greenspan_2006 import fixed_step
from carom.validation.row import Kind, Range, absolute, row


def integration_operations(moving: int, steps: int, balls: int = 16) -> int:
    """Operations of the fixed-step method for `steps` steps without an event.

    A step costs 3 for the state of each moving ball, 12 to test it against 6 rails and 6 pockets,
    and 1 for every pair with a moving ball. With 16 balls that is N(61n − n²)/2.
    """
    pairs = moving * (moving - 1) // 2 + moving * (balls - moving)
    return steps * (3 * moving + 12 * moving + pairs)


def event_operations(moving: int, balls: int = 16) -> int:
    """Operations of the event-based method for one event, whatever the time until it.

    Each moving ball costs 1 for its transition, 24 for its rails and pockets, and 3 to advance it;
    the quartic of every pair with a moving ball costs 19. With 16 balls that is (645n − 19n²)/2.
    """
    pairs = moving * (moving - 1) // 2 + moving * (balls - moving)
    return moving + 24 * moving + 19 * pairs + 3 * moving


@row(
    "LG-1",
    "Operations for one second of three moving balls among 16",
    unit="operations",
    source="section 3: N(61n − n²)/2 at Δt = 1 ms, and (645n − 19n²)/2",
    kind=Kind.FORMULA_ONLY,
    reference={"integration": 87000.0, "event-based": 882.0},
    tolerance=absolute(0.0),
)
def lg_1() -> list[float]:
    return [float(integration_operations(3, 1000)), float(event_operations(3))]


def shot() -> list[JSON]:
    """A cue ball with topspin and sidespin that meets two balls and several rails."""
    return [
        ball("cue", (0.30, 0.40), (0.55, 1.60, 0.0), (-20.0, 35.0, 30.0)),
        ball("1", (0.475, 0.88)),
        ball("2", (0.80, 1.48)),
    ]


def laws() -> JSON:
    """The engine's physics with the parameters of `fixed_step`."""
    return {
        "base": "ideal",
        "gravity": fixed_step.GRAVITY,
        "ball": {"radius": fixed_step.RADIUS, "mass": 0.17},
        "cloth": {
            "sliding_friction": fixed_step.SLIDING,
            "rolling_friction": fixed_step.ROLLING,
            "spin_deceleration": fixed_step.SPIN_DOWN,
        },
        "ball_ball": {"model": "elastic", "restitution": fixed_step.BALL_RESTITUTION},
        "cushion": {"model": "restitution", "restitution": fixed_step.RAIL_RESTITUTION},
    }


#: The table of `fixed_step`.
TABLE: JSON = {
    "length": fixed_step.LENGTH,
    "width": fixed_step.WIDTH,
    "pockets": "none",
    "cushion_height": fixed_step.RADIUS,
}


@cache
def exact() -> Run:
    """The shot as the engine simulates it."""
    return simulate_events(*shot(), physics=laws(), table=TABLE)


@cache
def by_steps(dt: float, order: int = 1) -> fixed_step.Balls:
    """The shot by steps of `dt` s, of the order of `fixed_step.stepped`."""
    return fixed_step.simulate(fixed_step.start(shot()), dt, order)


def end_error(dt: float, order: int = 1) -> float:
    """Largest distance, m, between a ball's end by steps and by events."""
    final = exact().final
    return max(
        float(np.linalg.norm(p - final[b["id"]].position[:2]))
        for p, b in zip(by_steps(dt, order).position, shot(), strict=True)
    )


STEPS = (4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4)


@row(
    "LG-2",
    "The fixed-step simulator with the same laws: how its error falls with Δt",
    unit="order",
    source="section 2 (constant velocity during Δt; the simulator goes back to an event)",
    kind=Kind.DERIVED,
    reference={"slope of log error over log Δt": 1.0},
    tolerance=absolute(0.3),
)
def lg_2() -> list[float]:
    slope, _ = np.polyfit(np.log(STEPS), np.log([end_error(dt) for dt in STEPS]), 1)
    return [float(slope)]


@row(
    "LG-2b",
    "The same with ½aΔt² in each step: error at the end with Δt = 0.5 ms",
    unit="m",
    source="a better step than the paper's; without it the error is 1.3e-2 m",
    kind=Kind.RANGE,
    reference={"error": Range(0.0, 1e-3)},
)
def lg_2b() -> list[float]:
    return [end_error(5e-4, order=2)]


@row(
    "LG-2c",
    "The same over a set of random shots: median error at the end, Δt = 0.5 ms",
    unit="m",
    source="section 2; with ½aΔt² in each step, and as in the paper",
    kind=Kind.STORED,
    reference={"v Δt + ½aΔt²": Range(0.0, 1e-3), "v Δt": Range(1e-3, 1.0)},
)
def lg_2c() -> list[float]:
    return [median_end_error("v dt + a dt^2 / 2", 5e-4), median_end_error("v dt", 5e-4)]


@row(
    "LG-3",
    "The fixed-step simulator: time of the first collision, extrapolated to Δt → 0",
    unit="s",
    source="section 2; the event-based time is the engine's",
    kind=Kind.DERIVED,
    reference={"difference from the event's time": 0.0},
    tolerance=absolute(1e-5),
)
def lg_3() -> list[float]:
    event = exact().first("ball-collision").time
    fine, coarse = (by_steps(dt).contacts[0] for dt in (2.5e-4, 5e-4))
    return [2 * fine - coarse - event]


@cache
def stored(name: str) -> JSON:
    """The contents of a JSON file beside this one, which names its command, commit and date."""
    result: JSON = json.loads((resources.files(__package__) / name).read_text())
    return result


def stepped(form: str, dt: float) -> list[JSON]:
    """The stored shots by steps of `dt` s, with the named form of the step."""
    result = stored("fixed_step.json")
    place = result["steps"].index(dt)
    return [shot["by_steps"][form][place] for shot in result["shots"]]


def median_end_error(form: str, dt: float) -> float:
    """Median over the stored shots of the largest distance between a ball's ends, m."""
    return float(statistics.median(found["end_error"] for found in stepped(form, dt)))


@cache
def finders() -> list[JSON]:
    """The stored results of the random shots, one entry per root finder, reading and family."""
    found: list[JSON] = stored("root_finders.json")["finders"]
    return found


def impossible(method: str, reading: str, family: str = "ordinary") -> JSON:
    """Numbers of shots with an impossible result, by the limit of the judge."""
    wanted = {"method": method, "reading": reading, "family": family}
    found: JSON = next(f for f in finders() if wanted.items() <= f.items())["impossible"]
    return found


@cache
def counted() -> JSON:
    """The stored counts of tests and solutions, by class of shot."""
    classes: JSON = stored("operations.json")["classes"]
    return classes


@row(
    "LG-4",
    "Of 100 000 random shots, those with an impossible result, with the paper's two finders",
    unit="shots",
    source='section 3 ("approximately 50 times"; GSL\'s solver: none)',
    kind=Kind.STORED,
    reference={"textbook closed form": 50.0, "companion matrix (as in GSL)": 0.0},
    tolerance=absolute(25.0),
    shown_only=True,
    misses=("textbook closed form",),
    note="Impossible: wrong by more than 1 µm. The paper gives neither its shots nor its "
    "criterion.",
)
def lg_4() -> list[float]:
    methods = ("textbook closed form", "companion matrix")
    return [float(impossible(m, "at which they approach")["micrometre"]) for m in methods]


@row(
    "LG-5",
    "The same with the engine's finder and its own limits (1e-12 m; 1e-14 m at contacts)",
    unit="shots",
    source="required: no impossible result",
    kind=Kind.STORED,
    reference={"ordinary shots": 0.0, "balls frozen to each other and to rails": 0.0},
    tolerance=absolute(0.0),
)
def lg_5() -> list[float]:
    families = ("ordinary", "frozen")
    return [float(impossible("carom", "first contact", f)["promised"]) for f in families]


@row(
    "LG-6",
    "The engine's operations per event, counted as in section 3: no more than the paper's method",
    unit="operations",
    source="section 3: (645n − 19n²)/2 with the balls in play",
    kind=Kind.STORED,
    reference={
        name: Range(0.0, c["operations"]["the paper's events"] / c["events"])
        for name, c in counted().items()
    },
)
def lg_6() -> list[float]:
    return [c["operations"]["carom"] / c["events"] for c in counted().values()]
