"""The fixed-step simulator of validation/leckie_greenspan_2006 against the exact engine.

    python scripts/fixed_step_errors.py

It stores validation/leckie_greenspan_2006/fixed_step.json: for a set of random shots, several steps
Δt, and steps with and without the term ½aΔt², the distance between the balls' ends, the error of
the first collision's time, and whether the collisions happen between the same balls in the same
order. It takes a few minutes. Every shot is written when it is done; a stopped run is continued by
the same command, unless the goldens or the settings have changed.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from carom.bench import goldens
from carom.validation.lab import Run, ball, simulate
from carom.validation.leckie_greenspan_2006 import fixed_step
from carom.validation.leckie_greenspan_2006.rows import TABLE, laws

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "validation" / "leckie_greenspan_2006" / "fixed_step.json"
#: Shots, their seed, and the numbers of their balls.
SHOTS, SEED, BALLS = 24, 2006, (2, 3, 4)
#: Steps, s.
STEPS = (1.6e-2, 8e-3, 4e-3, 2e-3, 1e-3, 5e-4)
#: The orders of `fixed_step.stepped`, by the name that is stored.
ORDERS = {"v dt": 1, "v dt + a dt^2 / 2": 2}

JSON = dict[str, Any]


def main() -> int:
    """Simulates the shots that are not stored yet."""
    result = begun()
    for index in range(len(result["shots"]), SHOTS):
        result["shots"].append(compare(index))
        write(result)
        print(f"{index + 1} of {SHOTS} shots", file=sys.stderr)
    return 0


def begun() -> JSON:
    """The stored result if this run continues it, otherwise an empty one."""
    new = goldens.stamp("python scripts/fixed_step_errors.py")
    new |= {"seed": SEED, "wanted": SHOTS, "steps": list(STEPS), "shots": []}
    if not STORED.is_file():
        return new
    old: JSON = json.loads(STORED.read_text(encoding="utf-8"))
    same = ("goldens", "seed", "wanted", "steps")
    return old if all(old.get(key) == new[key] for key in same) else new


def shot(index: int) -> tuple[list[JSON], Run]:
    """A shot in which balls collide, and its simulation by events."""
    random = np.random.default_rng([SEED, index])
    while True:
        balls = layout(random, BALLS[index % len(BALLS)])
        run = simulate(*balls, physics=laws(), table=TABLE)
        if any(run.all("ball-collision")):
            return balls, run


def layout(random: np.random.Generator, count: int) -> list[JSON]:
    """A moving cue ball with spin and `count` − 1 balls at rest, none of them touching."""
    low, high = 2 * fixed_step.RADIUS, np.array([fixed_step.WIDTH, fixed_step.LENGTH])
    places: list[Any] = []
    while len(places) < count:
        place = random.uniform(low, high - low)
        if all(np.linalg.norm(place - other) > 2 * low for other in places):
            places.append(place)
    # The cue ball moves towards the second ball, a little beside it, so that most meet.
    aim = places[1] - places[0]
    angle = np.arctan2(aim[1], aim[0]) + random.uniform(-0.05, 0.05)
    speed = random.uniform(0.8, 2.0)
    velocity = (speed * np.cos(angle), speed * np.sin(angle), 0.0)
    spin = random.uniform(-40.0, 40.0, 3)
    return [ball("cue", places[0], velocity, spin)] + [
        ball(str(k), place) for k, place in enumerate(places[1:], start=1)
    ]


def compare(index: int) -> JSON:
    """One shot by events and by all steps."""
    balls, run = shot(index)
    entry: JSON = {"balls": len(balls), "events": len(run.events), "by_steps": {}}
    for name, order in ORDERS.items():
        entry["by_steps"][name] = [by_steps(balls, run, dt, order) for dt in STEPS]
    return entry


def by_steps(balls: list[JSON], run: Run, dt: float, order: int) -> JSON:
    """One shot by steps of `dt` s: its errors, m and s, and its number of steps."""
    end = fixed_step.simulate(fixed_step.start(balls), dt, order)
    ids = [b["id"] for b in balls]
    errors = [
        float(np.linalg.norm(place - run.final[name].position[:2]))
        for place, name in zip(end.position, ids, strict=True)
    ]
    exact = [
        (event.time, sorted(map(ids.index, event.after))) for event in run.all("ball-collision")
    ]
    return {
        "end_error": max(errors),
        "first_contact_error": abs(end.contacts[0] - exact[0][0]) if end.contacts else None,
        "same_collisions": [sorted(pair) for pair in end.pairs] == [pair for _, pair in exact],
        "steps": end.steps,
    }


def write(result: JSON) -> None:
    """Replaces the stored file at once, so that a stopped run leaves a whole one."""
    part = STORED.with_suffix(".part")
    part.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    part.replace(STORED)


if __name__ == "__main__":
    sys.exit(main())
