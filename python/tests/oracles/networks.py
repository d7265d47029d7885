"""Random networks of balls that touch, and their impact by the engine."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import carom
import numpy as np

from oracles.touching import Array, Law, Network

JSON = dict[str, Any]

#: Mass and radius of a pool ball.
MASS, RADIUS = 0.17, 0.028575
#: Gaps up to this count as touching, m.
TOUCH = 1e-9
#: Free space between balls that do not touch, m: more than an approach closes within 50 µs.
CLEAR = 2e-3


@dataclass(frozen=True)
class Cluster:
    """Balls on unbounded cloth; the first one moves and touches others."""

    balls: list[JSON]
    law: JSON

    def shot(self) -> JSON:
        """The shot file of it."""
        return {
            "format": "carom-shot/1",
            "table": {"cloth": "unbounded"},
            "physics": {"base": "pool", "ball_ball": self.law},
            "balls": self.balls,
        }


def random_cluster(seed: int, size: int, model: str, alike: bool = True) -> Cluster:
    """`size` balls, each of which touches one or two others; `alike`: of one size and mass."""
    draw = random.Random(f"{seed} {size} {model} {alike}")
    radii = [RADIUS if alike else draw.uniform(0.022, 0.034) for _ in range(size)]
    places = [(0.0, 0.0)]
    while len(places) < size:
        r = radii[len(places)]
        near = draw.sample(range(len(places)), min(len(places), 2))
        at = (
            _between(places, radii, near, r)
            if len(near) == 2 and draw.random() < 0.5
            else _beside(places[near[0]], _reach(radii[near[0]], r), draw.uniform(0, 2 * math.pi))
        )
        if at is not None and _is_free(at, r, places, radii):
            places.append(at)
    # The last ball moves towards the middle of those that it touches, more or less.
    order = [size - 1, *range(size - 1)]
    x, y = places[-1]
    met = [
        math.atan2(py - y, px - x)
        for (px, py), r in zip(places[:-1], radii[:-1], strict=True)
        if math.hypot(px - x, py - y) < _reach(r, radii[-1]) + TOUCH
    ]
    heading = draw.choice(met) + draw.uniform(-1.1, 1.1)
    speed = 10 ** draw.uniform(0.0, 1.0)
    balls = []
    for k in order:
        moves = k == size - 1
        v = (speed * math.cos(heading), speed * math.sin(heading), 0.0) if moves else (0.0,) * 3
        spin = [draw.uniform(-1, 1) * speed / RADIUS if moves else 0.0 for _ in range(3)]
        mass = MASS if alike else MASS * (radii[k] / RADIUS) ** 3
        balls.append(
            {
                "id": str(k),
                "position": list(places[k]),
                "velocity": list(v),
                "angular_velocity": spin,
                "mass": mass,
                "radius": radii[k],
            }
        )
    friction: Any = draw.choice([0.06, {"a": 0.01, "b": 0.11, "c": 1.1}])
    law = {
        "model": model,
        "restitution": draw.choice([0.85, 0.95, 1.0]),
        "friction": 0.0 if model == "elastic" else friction,
        "frequency_ratio": draw.uniform(1.3, 1.9),
    }
    return Cluster(balls, law)


def _reach(r: float, s: float) -> float:
    """Distance in plan view of two balls that touch on the cloth."""
    return 2.0 * math.sqrt(r * s)


def _beside(at: tuple[float, float], distance: float, angle: float) -> tuple[float, float]:
    return at[0] + distance * math.cos(angle), at[1] + distance * math.sin(angle)


def _between(
    places: list[tuple[float, float]], radii: list[float], near: list[int], r: float
) -> tuple[float, float] | None:
    """The place that touches two balls; None if they are too far apart."""
    (x, y), (u, v) = (places[k] for k in near)
    p, q = (_reach(radii[k], r) for k in near)
    d = math.hypot(u - x, v - y)
    if d > p + q:
        return None
    along = (d * d + p * p - q * q) / (2 * d)
    across = math.sqrt(max(p * p - along * along, 0.0))
    c, s = (u - x) / d, (v - y) / d
    return x + c * along - s * across, y + s * along + c * across


def _is_free(
    at: tuple[float, float],
    r: float,
    places: list[tuple[float, float]],
    radii: list[float],
) -> bool:
    gaps = [
        math.hypot(px - at[0], py - at[1]) - _reach(s, r)
        for (px, py), s in zip(places, radii, strict=False)
    ]
    return all(abs(g) < TOUCH or g > CLEAR for g in gaps)


def integrated(cluster: Cluster) -> Array:
    """Velocity and Rω of each ball after the impact, integrated."""
    network = Network()
    at = [
        network.ball(b["mass"], b["radius"], b["velocity"], b["angular_velocity"])
        for b in cluster.balls
    ]
    centres = [np.array([*b["position"], b["radius"]]) for b in cluster.balls]
    law = law_of(cluster.law)
    for i, j in combinations(range(len(at)), 2):
        d = centres[j] - centres[i]
        if np.linalg.norm(d) < cluster.balls[i]["radius"] + cluster.balls[j]["radius"] + TOUCH:
            network.join_balls(at[i], at[j], d, law)
    return network.solve().reshape(-1, 6)


def law_of(law: JSON) -> Law:
    """The springs of a `ball_ball` law."""
    friction = law["friction"]
    if isinstance(friction, dict):
        a, b, c = (friction[k] for k in "abc")
        friction = lambda s: a + b * math.exp(-c * s)  # noqa: E731
    ratio = law["frequency_ratio"] if law["model"] == "compliant" else None
    return Law(law["restitution"], friction, ratio)


def played(cluster: Cluster) -> Array:
    """Velocity and Rω of each ball right after the engine's first collision."""
    events = carom.Shot.from_dict(cluster.shot()).simulate().to_dict()["events"]
    first = next(e for e in events if e["type"] == "ball-collision")
    after = {b["id"]: b for b in first["after"]}
    result = []
    for b in cluster.balls:
        s = after.get(b["id"], b)
        result.append([*s["velocity"], *(b["radius"] * w for w in s["angular_velocity"])])
    return np.array(result)


def difference(cluster: Cluster) -> float:
    """The largest difference of a ball's velocity, as a share of the fastest ball's.

    A vertical velocity counts only where the engine has one: the slate stops slow ones.
    """
    exact = integrated(cluster)
    engine = played(cluster)
    apart = (engine - exact)[:, :3]
    apart[:, 2] *= engine[:, 2] != 0.0
    fastest = float(np.max(np.linalg.norm(exact[:, :3], axis=1)))
    return float(np.max(np.linalg.norm(apart, axis=1))) / fastest
