"""Random shots with every parameter written out, for oracles that know no presets."""

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
}

RECTANGLE: JSON = {"length": 2.0, "width": 1.0, "pockets": "none", "cushion_height": 0.0365}


def random_shot(
    seed: int,
    balls: int,
    table: JSON | str = RECTANGLE,
    size: tuple[float, float] = (1.0, 2.0),
    **physics: JSON,
) -> JSON:
    """Balls at random places, of unequal mass and radius for every third seed; two of them move,
    one of them fast, roughly towards another ball.
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
