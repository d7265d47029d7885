"""Conservation laws and symmetries that every model must obey (row SY5)."""

import math
from collections.abc import Iterator

import numpy as np
from carom.validation.lab import (
    JSON,
    Ball,
    Event,
    Run,
    Vector,
    ball,
    simulate,
)
from carom.validation.row import Kind, Range, absolute, row

RADIUS, MASS = 0.028575, 0.17
SHOTS = 40
BALLS = 9
TABLE = "wpa-9ft"
WIDTH, LENGTH = 1.27, 2.54
MODELS: tuple[JSON, ...] = (
    {"model": "elastic", "restitution": 0.95},
    {"model": "frictional", "restitution": 0.93, "friction": {"a": 0.01, "b": 0.11, "c": 1.1}},
    {"model": "compliant", "restitution": 0.94, "friction": 0.08},
)


def physics(ball_ball: JSON) -> JSON:
    return {
        "base": "pool",
        "ball": {"mass": MASS, "radius": RADIUS},
        "ball_ball": ball_ball,
    }


def random_balls(seed: int) -> list[JSON]:
    """A layout away from the rails, with one fast spinning ball on its way to another."""
    rng = np.random.default_rng(seed)
    placed: list[Vector] = []
    while len(placed) < BALLS:
        p = rng.uniform((0.1, 0.2), (WIDTH - 0.1, LENGTH - 0.2))
        if all(math.dist(p, q) > 2.05 * RADIUS for q in placed):
            placed.append(p)
    ahead = placed[1] - placed[0]
    # Within the target's angular radius: it is hit unless another ball is in the way.
    spread = 2 * RADIUS / float(np.linalg.norm(ahead))
    heading = math.atan2(ahead[1], ahead[0]) + rng.uniform(-spread, spread)
    speed = rng.uniform(2.0, 6.0)
    velocity = (speed * math.cos(heading), speed * math.sin(heading), 0.0)
    balls = [ball(f"{k}", p) for k, p in enumerate(placed)]
    balls[0] = ball("0", placed[0], velocity, rng.uniform(-80.0, 80.0, 3))
    return balls


def random_runs() -> Iterator[Run]:
    """One shot per seed, with the ball–ball models in turn."""
    for seed in range(SHOTS):
        law = MODELS[seed % len(MODELS)]
        yield simulate(*random_balls(seed), physics=physics(law), table=TABLE)


def energy(b: Ball) -> float:
    v2 = float(b.velocity @ b.velocity)
    return 0.5 * MASS * v2 + 0.2 * MASS * RADIUS**2 * float(b.spin @ b.spin)


def momentum(event: Event) -> float:
    """A scale for the errors, kg m/s: mass times the balls' speeds and spin surface speeds."""
    speeds = [
        float(np.linalg.norm(b.velocity) + RADIUS * np.linalg.norm(b.spin))
        for b in event.before.values()
    ]
    return MASS * sum(speeds)


def momentum_error(event: Event) -> float:
    """Change of the two balls' momentum in the plane, relative to `momentum`."""
    changes = [event.after[b].velocity - event.before[b].velocity for b in event.after]
    total: Vector = np.sum(changes, axis=0)
    return MASS * float(np.linalg.norm(total[:2])) / momentum(event)


def angular_momentum_error(event: Event) -> float:
    """Difference of the spins' changes from those of one impulse P at the contact, relative.

    Angular momentum about the contact is conserved for each ball: I Δω = R n × P, where P is the
    momentum exchanged. The slate takes the vertical part of P. Therefore the components of Δω along
    the vertical and along n are compared with P; the third component, which the vertical part of P
    changes equally in both balls, is compared between the balls.
    """
    a, b = event.after
    before, after = event.before, event.after
    n = before[b].position - before[a].position
    n = n / np.linalg.norm(n)
    inertia = 0.4 * MASS * RADIUS**2
    impulse = MASS * (after[a].velocity - before[a].velocity)
    torque = RADIUS * np.cross(n, impulse)
    turns = [inertia * (after[k].spin - before[k].spin) for k in (a, b)]
    errors = [abs(t[2] - torque[2]) for t in turns] + [abs(float(t @ n)) for t in turns]
    errors.append(float(np.linalg.norm(turns[0] - turns[1])))
    scale: float = RADIUS * momentum(event)
    return float(max(errors)) / scale


def collisions() -> list[Event]:
    return [
        event
        for run in random_runs()
        for event in run.all("ball-collision")
        if len(event.after) == 2
    ]


@row(
    "SY5",
    f"Ball against ball in {SHOTS} random shots, three models: momentum and angular momentum",
    unit="relative",
    source="physics",
    kind=Kind.DERIVED,
    reference={"momentum": 0.0, "angular momentum about the contact": 0.0},
    tolerance=absolute(1e-12),
)
def sy5_momentum() -> list[float]:
    events = collisions()
    return [max(map(momentum_error, events)), max(map(angular_momentum_error, events))]


@row(
    "SY5",
    "Largest rise of energy at any event, relative to the energy at the start",
    unit="relative",
    source="physics",
    kind=Kind.RANGE,
    reference={"rise": Range(-math.inf, 1e-12)},
)
def sy5_energy() -> list[float]:
    worst = -math.inf
    for run in random_runs():
        # Only the first ball moves at the start, and no energy is added later.
        start = max(energy(b) for b in run.events[0].before.values())
        for event in run.events:
            rise = sum(energy(event.after[b]) - energy(event.before[b]) for b in event.after)
            worst = max(worst, rise / start)
    return [worst]


def largest_distance(a: Run, b: Run, map_b: Vector, shift: Vector) -> float:
    """Largest distance, m, between a ball's final place in `a` and the mapped one in `b`."""
    return max(
        float(np.linalg.norm(a.final[k].position - (map_b @ b.final[k].position + shift)))
        for k in a.final
        if a.final[k].motion != "pocketed"
    )


def mapped(balls: list[JSON], matrix: Vector, shift: Vector) -> list[JSON]:
    """The balls under p → M p + s; a mirror reverses the spin, which is a pseudovector."""
    sign = float(np.linalg.det(matrix))
    flat = matrix[:2, :2]
    return [
        ball(
            b["id"],
            flat @ np.array(b["position"]) + shift[:2],
            matrix @ np.array(b["velocity"]),
            sign * matrix @ np.array(b["angular_velocity"]),
        )
        for b in balls
    ]


FEW = 12
LAW = MODELS[1]


@row(
    "SY5",
    f"Mirror image and rotation of a shot: largest difference of a final place, {FEW} shots",
    unit="m",
    source="physics",
    kind=Kind.DERIVED,
    reference={"mirror, on the table": 0.0, "rotation by 1 rad, on unbounded cloth": 0.0},
    tolerance=absolute(1e-9),
)
def sy5_symmetry() -> list[float]:
    mirror, shift = np.diag([-1.0, 1.0, 1.0]), np.array([WIDTH, 0.0, 0.0])
    c, s = math.cos(1.0), math.sin(1.0)
    rotation, none = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]), np.zeros(3)
    mirrored, rotated = 0.0, 0.0
    for seed in range(FEW):
        balls = random_balls(seed)
        a = simulate(*mapped(balls, mirror, shift), physics=physics(LAW), table=TABLE)
        b = simulate(*balls, physics=physics(LAW), table=TABLE)
        mirrored = max(mirrored, largest_distance(a, b, mirror, shift))
        a = simulate(*mapped(balls, rotation, none), physics=physics(LAW))
        b = simulate(*balls, physics=physics(LAW))
        rotated = max(rotated, largest_distance(a, b, rotation, none))
    return [mirrored, rotated]


@row(
    "SY5",
    f"Speed scaling, constant μ and e: twice the speed at four times g, {FEW} shots",
    unit="m",
    source="physics (v² ∝ g)",
    kind=Kind.DERIVED,
    reference={"largest difference of a final place": 0.0},
    tolerance=absolute(1e-9),
)
def sy5_scaling() -> list[float]:
    law: JSON = {"model": "frictional", "restitution": 0.95, "friction": 0.06}
    worst = 0.0
    for seed in range(FEW):
        slow = random_balls(seed)
        fast = [
            ball(
                b["id"],
                b["position"],
                2 * np.array(b["velocity"]),
                2 * np.array(b["angular_velocity"]),
            )
            for b in slow
        ]
        ends = []
        for balls, g in ((slow, 9.81), (fast, 4 * 9.81)):
            laws = physics(law)
            laws["gravity"] = g
            laws["cloth"] = {"spin_deceleration": 10.0 * g / 9.81}
            ends.append(simulate(*balls, physics=laws))
        worst = max(worst, largest_distance(ends[0], ends[1], np.eye(3), np.zeros(3)))
    return [worst]
