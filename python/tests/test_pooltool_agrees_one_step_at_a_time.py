"""Single steps of pooltool 0.6.0 compared with ours, through the public API.

`data/README.md` describes the source of the samples and pooltool's faults, which the bounds below
allow for.
"""

from __future__ import annotations

import gzip
import json
import math
from functools import cache
from pathlib import Path
from typing import Any

import carom
import pytest

JSON = dict[str, Any]

DATA = Path(__file__).parent / "data" / "pooltool_0_6_0_one_step.json.gz"

#: pooltool's ball, cloth and cue, as it printed them.
MASS, RADIUS, GRAVITY = 0.170097, 0.028575, 9.81
NOSE_HEIGHT = 0.036576
PHYSICS: JSON = {
    "base": "pool",
    "gravity": GRAVITY,
    "ball": {"mass": MASS, "radius": RADIUS},
    "cloth": {
        "sliding_friction": 0.2,
        "rolling_friction": 0.01,
        # pooltool's μ_sp = 4/9·R gives α = 5 μ_sp g/(2R).
        "spin_deceleration": 2.5 * (4.0 / 9.0 * RADIUS) * GRAVITY / RADIUS,
    },
    "cue": {
        # pooltool's tip acts alone.
        "model": "sequential",
        "mass": 0.567,
        "end_mass": MASS / 30,
        "tip_radius": 0.0106045,
        # pooltool has no miscues; an offset of 0.7 needs at least 0.98.
        "tip_friction": 2.0,
        "tip_restitution": 1.0,
    },
}
ALCIATORE: JSON = {"a": 0.009951, "b": 0.108, "c": 1.088}
CLOTH: JSON = {"cloth": "unbounded"}
#: pooltool's motion states by number.
MOTIONS = ("stationary", "spinning", "sliding", "rolling")


@cache
def samples() -> JSON:
    data: JSON = json.loads(gzip.decompress(DATA.read_bytes()))
    return data


def ball(name: str, state: list[float], position: list[float] | None = None) -> JSON:
    return {
        "id": name,
        "position": (position or state)[:2],
        "velocity": state[3:6],
        "angular_velocity": state[6:9],
    }


def simulate(balls: list[JSON], table: JSON | str = CLOTH, **physics: JSON) -> Any:
    return carom.Shot.from_dict(
        {
            "format": "carom-shot/1",
            "table": table,
            "physics": {**PHYSICS, **physics},
            "balls": balls,
        }
    ).simulate()


def first(trace: Any, kind: str) -> JSON:
    event: JSON = next(e for e in trace.to_dict()["events"] if e["type"] == kind)
    return event


def off(ours: JSON, theirs: list[float]) -> float:
    """Largest difference of horizontal velocity and of spin × radius, m/s.

    The vertical velocity is left out: pooltool's models drop the vertical part of an impulse.
    """
    v = max(abs(a - b) for a, b in zip(ours["velocity"][:2], theirs[3:5], strict=True))
    w = max(abs(a - b) for a, b in zip(ours["angular_velocity"], theirs[6:9], strict=True))
    return max(v, RADIUS * w)


def speed(state: list[float]) -> float:
    """The scale of an impact: speed and surface speed together, m/s."""
    return math.hypot(*state[3:6]) + RADIUS * math.hypot(*state[6:9])


#: Largest difference, per speed before the impact, where both solve the same equations exactly.
SAME = 1e-12
#: The same where pooltool integrates in steps: 1000 for two balls, of 1e-3 N·s at a cushion.
COARSE_BALLS, COARSE_CUSHION = 1e-3, 2e-2
#: pooltool's `frictional_inelastic` has a friction impulse of μ·e·w, with w the approach speed, but
#: its normal impulse is (1 + e)/2·w. Its friction is therefore smaller by this factor.
FAULT = 2 * 0.95 / (1 + 0.95)


def spun_against(sample: JSON) -> bool:
    """Whether the sample shows the fault of pooltool's `frictional_mathavan`.

    It has the wrong sign for the spin of the ball that friction presses on the cloth. The fault
    has no effect if that ball has no horizontal spin.
    """
    a, b = sample["in"]
    spin = [a[k] + b[k] for k in (6, 7)]
    pressed = a if spin[1] * (b[0] - a[0]) - spin[0] * (b[1] - a[1]) < 0.0 else b
    return pressed[6] != 0.0 or pressed[7] != 0.0


@pytest.mark.parametrize(
    ("theirs", "law", "bound"),
    [
        ("frictionless_elastic", {"model": "elastic", "restitution": 1.0}, SAME),
        (
            "frictional_inelastic",
            {
                "model": "frictional",
                "restitution": 0.95,
                "friction": {**ALCIATORE, "a": FAULT * ALCIATORE["a"], "b": FAULT * ALCIATORE["b"]},
            },
            SAME,
        ),
        (
            "frictional_mathavan",
            {"model": "mathavan-2014", "restitution": 0.95, "friction": ALCIATORE},
            COARSE_BALLS,
        ),
    ],
)
def test_two_balls_rebound_as_in_pooltool(theirs: str, law: JSON, bound: float) -> None:
    worst, compared = 0.0, 0
    for sample in samples()["ball_ball"]:
        if theirs == "frictional_mathavan" and spun_against(sample):
            continue
        compared += 1
        a, b = sample["in"]
        # pooltool moves the balls slightly first; its line of centres is that of the moved balls.
        p, q = (out[:2] for out in sample["out"][theirs])
        reach = 2 * RADIUS / math.dist(p, q)
        touching = [p[k] + reach * (q[k] - p[k]) for k in (0, 1)]
        balls = [ball("a", a, p), ball("b", b, touching)]
        event = first(simulate(balls, ball_ball=law), "ball-collision")
        assert event["time"] < 1e-9
        after = {item["id"]: item for item in event["after"]}
        scale = speed(a) + speed(b)
        for name, out in zip(("a", "b"), sample["out"][theirs], strict=True):
            worst = max(worst, off(after[name], out) / scale)
    assert compared >= 10
    assert worst < bound


CUSHION_LAWS = [
    ("unrealistic", {"model": "restitution", "restitution": 1.0}, SAME),
    ("han_2005", {"model": "han-2005", "restitution": 0.85, "friction": 0.2}, SAME),
    (
        "stronge_compliant",
        {"model": "stronge", "restitution": 0.85, "friction": 0.2, "frequency_ratio": 1.7},
        SAME,
    ),
    (
        "mathavan_2010",
        {"model": "mathavan-2010", "restitution": 0.85, "friction": 0.2},
        COARSE_CUSHION,
    ),
]


def nose_sine(theirs: str, distance: float) -> float:
    """pooltool's sine of the nose's angle above the ball's centre.

    It is (h − R)/R, except in `stronge_compliant`, which uses the direction from the ball's centre
    to the nose line, or to the centre of a jaw's arc, at the horizontal distance `distance`, m.
    """
    rise = NOSE_HEIGHT - RADIUS
    return rise / math.hypot(distance, rise) if theirs == "stronge_compliant" else rise / RADIUS


def rebound(state: list[float], into: tuple[float, float], sine: float, law: JSON) -> JSON:
    """The ball after our cushion, whose nose is at this angle.

    The top rail of a rectangle takes the place of the cushion; everything is turned so that `into`
    points in the direction of +y.
    """
    x, y = into

    def turned(v: list[float]) -> list[float]:
        return [y * v[0] - x * v[1], x * v[0] + y * v[1], v[2]]

    def turned_back(v: list[float]) -> list[float]:
        return [y * v[0] + x * v[1], -x * v[0] + y * v[1], v[2]]

    reach = RADIUS * math.sqrt(1 - sine * sine)
    table = {
        "length": 2.0,
        "width": 2.0,
        "pockets": "none",
        "cushion_height": RADIUS * (1 + sine),
    }
    start = [1.0, 2.0 - reach, RADIUS, *turned(state[3:6]), *turned(state[6:9])]
    event = first(simulate([ball("a", start)], table=table, cushion=law), "rail-collision")
    assert event["time"] < 1e-9
    after = event["after"][0]
    return {key: turned_back(after[key]) for key in ("velocity", "angular_velocity")}


@pytest.mark.parametrize(("theirs", "law", "bound"), CUSHION_LAWS)
def test_a_ball_rebounds_off_a_straight_cushion_as_in_pooltool(
    theirs: str, law: JSON, bound: float
) -> None:
    worst = 0.0
    for sample in samples()["cushion_linear"]:
        lx, ly, l0 = samples()["meta"]["linear_cushions"][sample["segment"]]["line_lx_ly_l0"]
        state, out = sample["in"], sample["out"][theirs]
        size = -math.copysign(math.hypot(lx, ly), lx * state[0] + ly * state[1] + l0)
        distance = abs(lx * out[0] + ly * out[1] + l0) / math.hypot(lx, ly)
        ours = rebound(state, (lx / size, ly / size), nose_sine(theirs, distance), law)
        worst = max(worst, off(ours, out) / speed(state))
    assert worst < bound


@pytest.mark.parametrize(("theirs", "law", "bound"), CUSHION_LAWS)
def test_a_ball_rebounds_off_a_jaw_as_in_pooltool(theirs: str, law: JSON, bound: float) -> None:
    worst = 0.0
    for sample in samples()["cushion_circular"]:
        center = samples()["meta"]["circular_cushions"][sample["segment"]]["center"]
        state, out = sample["in"], sample["out"][theirs]
        distance = math.dist(out[:2], center[:2])
        into = ((center[0] - out[0]) / distance, (center[1] - out[1]) / distance)
        ours = rebound(state, into, nose_sine(theirs, distance), law)
        worst = max(worst, off(ours, out) / speed(state))
    assert worst < bound


def test_a_struck_ball_starts_as_in_pooltool() -> None:
    worst = 0.0
    for sample in samples()["stick_ball"]:
        shot = carom.Shot.from_dict(
            {
                "format": "carom-shot/1",
                "table": CLOTH,
                "physics": PHYSICS,
                "balls": [{"id": "cue", "position": sample["out"][:2]}],
                "strike": {
                    "ball": "cue",
                    "speed": sample["V0"],
                    "azimuth_deg": sample["phi"],
                    "elevation_deg": sample["theta"],
                    "side": -sample["a"],  # pooltool's a is positive to the left
                    "height": sample["b"],
                },
            }
        )
        after = first(shot.simulate(), "cue-strike")["after"][0]
        # In pooltool squirt turns the horizontal velocity, here the whole velocity, so our sideways
        # velocity does not decrease with elevation.
        azimuth, elevation = math.radians(sample["phi"]), math.radians(sample["theta"])
        c, s = math.cos(azimuth), math.sin(azimuth)
        x, y, z = after["velocity"]
        ahead, aside = c * x + s * y, (c * y - s * x) * math.cos(elevation)
        after["velocity"] = [c * ahead - s * aside, s * ahead + c * aside, z]
        worst = max(worst, off(after, sample["out"]) / speed(sample["out"]))
    assert worst < SAME


def test_a_ball_moves_on_the_cloth_as_in_pooltool() -> None:
    for sample in samples()["evolve"]:
        start, out, t = sample["in"], sample["out"], sample["t"]
        trace = simulate([ball("a", start)])
        transition = first(trace, "motion-transition")
        assert transition["from"] == MOTIONS[int(start[-1])]
        assert transition["time"] == pytest.approx(sample["phase_ends_at"], rel=1e-12)
        now = trace.at(t)
        assert now.position[0] == pytest.approx(out[:3], abs=1e-12)
        ours = {"velocity": now.velocity[0], "angular_velocity": now.angular_velocity[0]}
        assert off(ours, out) < 1e-12


def test_two_balls_collide_at_pooltools_time() -> None:
    met = 0
    for sample in samples()["ball_ball_times"]:
        a, b = sample["in"]
        events = simulate([ball("a", a), ball("b", b)]).to_dict()["events"]
        # pooltool's time is valid only until the first transition; it ignores later paths.
        before = [e for e in events if e["type"] == "motion-transition"]
        path_ends = before[0]["time"] if before else math.inf
        time = next((e["time"] for e in events if e["type"] == "ball-collision"), math.inf)
        theirs = math.inf if sample["t"] is None else sample["t"]
        if min(time, theirs) < path_ends:
            met += 1
            assert time == pytest.approx(theirs, abs=1e-9)
    assert met > 100
