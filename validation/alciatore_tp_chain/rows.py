"""Balls frozen in a row, struck from behind (technical proof B.29)."""

from functools import cache

import numpy as np
from carom.validation.lab import TP_RADIUS, Vector, ball, simulate, tp_physics
from carom.validation.row import absolute, row


def chain(balls: int, restitution: float = 1.0, speed: float = 1.0) -> list[float]:
    """Speeds right after the first of touching balls in a line comes at `speed`, m/s."""
    law = {"model": "frictional", "restitution": restitution, "friction": 0.0}
    line = [ball(str(k), (0.0, 2 * TP_RADIUS * k)) for k in range(balls)]
    line[0]["velocity"] = [0.0, speed, 0.0]
    run = simulate(*line, physics=tp_physics(ball_ball=law))
    return [float(v[1]) for v in run.trace.at(AFTER).velocity]


#: When the impact is over and friction of the cloth has changed nothing yet, s.
AFTER = 1e-6


@cache
def hertz(balls: int) -> Vector:
    """The same by Newton's law: a force of (overlap)^(3/2) between neighbours.

    Integrated by the classical rule of Runge and Kutta, in the units in which the stiffness is 1:
    without losses the final speeds do not depend on it.
    """
    x, v = np.zeros(balls), np.zeros(balls)
    v[0] = 1.0

    def pull(x: Vector) -> Vector:
        force = np.maximum(-np.diff(x), 0.0) ** 1.5
        return np.concatenate(([0.0], force)) - np.concatenate((force, [0.0]))

    h = 0.01
    for _ in range(600 + 300 * balls):
        a1 = pull(x)
        a2 = pull(x + 0.5 * h * v)
        a3 = pull(x + 0.5 * h * (v + 0.5 * h * a1))
        a4 = pull(x + h * (v + 0.5 * h * a2))
        x = x + h * (v + h / 6 * (a1 + a2 + a3))
        v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    return v


@row(
    "BB19",
    "Three balls frozen in a line, the first comes at 1 m/s: speeds after",
    unit="m/s",
    source="TP B.29 (Hertz contacts)",
    status="R",
    published={"first": -0.071, "second": 0.076, "third": 0.995},
    tolerance=absolute(1e-3),
)
def bb19() -> list[float]:
    return chain(3)


@row(
    "BB19-longer",
    "Four to six balls: speeds of the first and the last less those of Hertz's law",
    unit="m/s",
    source="Hertz: force ∝ (overlap)^(3/2), integrated in the row",
    status="D",
    published={f"{n} balls, {which}": 0.0 for n in (4, 5, 6) for which in ("first", "last")},
    tolerance=absolute(2e-3),
)
def bb19_longer() -> list[float]:
    return [chain(n)[k] - float(hertz(n)[k]) for n in (4, 5, 6) for k in (0, -1)]
