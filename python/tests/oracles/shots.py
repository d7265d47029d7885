"""Random shots with every parameter written out, because the oracles have no presets."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

JSON = dict[str, Any]

RADIUS, MASS = 0.028575, 0.17

PHYSICS: JSON = {
    "gravity": 9.81,
    "ball": {"mass": MASS, "radius": RADIUS},
    "cloth": {"sliding_friction": 0.2, "rolling_friction": 0.01, "spin_deceleration": 10.9},
    "ball_ball": {
        "model": "frictional",
        "restitution": 0.94,
        "friction": {"a": 0.01, "b": 0.108, "c": 1.09},
    },
    "cushion": {"model": "han-2005", "restitution": 0.85, "friction": 0.2},
    "facing": {"restitution": 0.7, "friction": 0.25},
    "liner": {"restitution": 0.4, "friction": 0.3},
    "slate": {"restitution": 0.55, "friction": 0.2},
    "cue": {
        # A raised cue first pushes the ball, and then the slate acts.
        "model": "sequential",
        "mass": 0.567,
        "end_mass": 0.0,
        "tip_radius": 0.0106,
        "tip_friction": 0.7,
        "tip_restitution": 0.75,
    },
}

RECTANGLE: JSON = {
    "length": 2.0,
    "width": 1.0,
    "pockets": "none",
    "cushion_height": 0.0365,
    "rail_width": 0.13,
}


def random_shot(
    seed: int,
    balls: int,
    table: JSON | str = RECTANGLE,
    size: tuple[float, float] = (1.0, 2.0),
    **physics: JSON,
) -> JSON:
    """Balls at random places; one moves fast towards another ball, and a second one moves slowly.

    For every third seed the balls have different masses and radii.
    """
    rng = np.random.default_rng(seed)
    width, length = size
    placed: list[JSON] = []
    while len(placed) < balls:
        radius = RADIUS * (1.0 if seed % 3 else float(rng.uniform(0.8, 1.1)))
        p = rng.uniform((0.12, 0.12), (width - 0.12, length - 0.12))
        if any(math.dist(p, q["position"]) < radius + q["radius"] + 1e-3 for q in placed):
            continue
        mass = MASS * (radius / RADIUS) ** 3
        placed.append({"id": str(len(placed)), "position": p.tolist(), "radius": radius})
        placed[-1]["mass"] = mass
    for k, (low, high) in enumerate(((1.5, 5.0), (0.3, 1.0))[: balls - 1]):
        here, there = placed[k]["position"], placed[k + 1]["position"]
        heading = math.atan2(there[1] - here[1], there[0] - here[0]) + rng.uniform(-0.06, 0.06)
        speed = rng.uniform(low, high)
        placed[k]["velocity"] = [speed * math.cos(heading), speed * math.sin(heading), 0.0]
        placed[k]["angular_velocity"] = rng.uniform(-60.0, 60.0, 3).tolist()
    laws = {**PHYSICS, **physics}
    return {"format": "carom-shot/1", "table": table, "physics": laws, "balls": placed}


def random_flight(seed: int, balls: int, **more: Any) -> JSON:
    """Like `random_shot`, but the fast ball starts in the air, thrown up or dropped."""
    shot = random_shot(seed, balls, **more)
    rng = np.random.default_rng([seed, 3])
    ball = shot["balls"][0]
    vx, vy, _ = ball["velocity"]
    if seed % 4 == 3:
        ball["position"] = [*ball["position"], ball["radius"] + float(rng.uniform(0.02, 0.3))]
        ball["velocity"] = [0.5 * vx, 0.5 * vy, float(rng.uniform(-2.0, 1.0))]
    else:
        ball["velocity"] = [vx, vy, float(rng.uniform(0.2, 2.2))]
    return shot


def random_stroke(seed: int, balls: int, **more: Any) -> JSON:
    """Balls at rest and a strike with an elevated cue and any spin, towards another ball."""
    shot = random_shot(seed, balls, **more)
    rng = np.random.default_rng([seed, 4])
    for ball in shot["balls"]:
        ball.pop("velocity", None)
        ball.pop("angular_velocity", None)
    (x, y), (u, v) = (b["position"] for b in shot["balls"][:2])
    azimuth = math.degrees(math.atan2(v - y, u - x)) + rng.uniform(-3.0, 3.0)
    offset, angle = 0.5 * math.sqrt(rng.uniform()), rng.uniform(0.0, 2 * math.pi)
    shot["strike"] = {
        "ball": shot["balls"][0]["id"],
        "speed": float(rng.uniform(1.0, 6.0)),
        "azimuth_deg": azimuth,
        "elevation_deg": float(rng.uniform(3.0, 75.0)),
        "side": offset * math.cos(angle),
        "height": offset * math.sin(angle),
    }
    return shot


def flight_at_a_pocket(seed: int, table: JSON) -> JSON:
    """A ball that flies at a pocket, one that rolls into a pocket, and others at rest."""
    shot = random_shot(seed, 4, table=table["name"], size=tuple(table["size"]))
    rng = np.random.default_rng([seed, 5])
    pockets = table["pockets"]
    for k, rise in ((0, True), (1, False)):
        ball = shot["balls"][k]
        pocket = min(pockets, key=lambda p: math.dist(p["center"], ball["position"]))
        target = np.array(pocket["center"]) + rng.normal(0.0, 0.04, 2)
        lasts = rng.uniform(0.15, 0.4) if rise else rng.uniform(0.2, 0.8)
        vx, vy = ((target - np.array(ball["position"])) / lasts).tolist()
        up = PHYSICS["gravity"] * lasts / 2 + rng.uniform(0.0, 0.06) / lasts if rise else 0.0
        ball["velocity"] = [vx, vy, up]
    return shot


def level_stroke(seed: int, balls: int, table: JSON | str, preset: JSON, **more: Any) -> JSON:
    """Balls of a preset at rest, and a level strike with any spin towards another ball.

    `more` are keys of the shot file; without `physics` the table's own preset applies.
    """
    rng = np.random.default_rng([seed, 6])
    width, length = more.pop("size")
    radius = preset["ball"]["radius"]
    placed: list[JSON] = []
    while len(placed) < balls:
        p = rng.uniform((0.12, 0.12), (width - 0.12, length - 0.12)).tolist()
        if all(math.dist(p, q["position"]) > 2 * radius + 1e-3 for q in placed):
            placed.append({"id": str(len(placed)), "position": p})
    (x, y), (u, v) = (b["position"] for b in placed[:2])
    offset, angle = 0.5 * math.sqrt(rng.uniform()), rng.uniform(0.0, 2 * math.pi)
    strike = {
        "ball": "0",
        "speed": float(rng.uniform(0.5, 4.0)),
        "azimuth_deg": math.degrees(math.atan2(v - y, u - x)) + float(rng.uniform(-3.0, 3.0)),
        "elevation_deg": 0.0,
        "side": offset * math.cos(angle),
        "height": offset * math.sin(angle),
    }
    return {"format": "carom-shot/1", "table": table, "balls": placed, "strike": strike, **more}


def rail_impact(seed: int) -> JSON:
    """A ball 1 mm before a cushion that follows `mathavan-2010`, with any spin and any friction."""
    rng = np.random.default_rng([seed, 7])
    lean = float(rng.uniform(-0.3, 0.6))
    speed = float(np.exp(rng.uniform(np.log(0.05), np.log(5.0))))
    angle = float(rng.uniform(-1.4, 1.4))
    v = (speed * math.cos(angle), speed * math.sin(angle))
    if rng.uniform() < 0.5:
        w = [-v[1] / RADIUS, v[0] / RADIUS, float(rng.uniform(-3.0, 3.0)) * speed / RADIUS]
    else:
        w = (rng.uniform(-3.0, 3.0, 3) * speed / RADIUS).tolist()
    reach = RADIUS * math.sqrt(1.0 - lean * lean)
    cushion = {
        "model": "mathavan-2010",
        "restitution": float(rng.uniform(0.3, 1.0)),
        "friction": float(rng.choice([0.02, 0.14, 0.2, 0.3, 0.5])),
    }
    cloth = {**PHYSICS["cloth"], "sliding_friction": float(rng.choice([0.1, 0.2, 0.4]))}
    ball = {
        "id": "0",
        "position": [RECTANGLE["width"] - reach - 1e-3, 1.0],
        "velocity": [*v, 0.0],
        "angular_velocity": w,
    }
    return {
        "format": "carom-shot/1",
        "table": {**RECTANGLE, "cushion_height": RADIUS * (1.0 + lean)},
        "physics": {**PHYSICS, "cushion": cushion, "cloth": cloth},
        "balls": [ball],
    }
