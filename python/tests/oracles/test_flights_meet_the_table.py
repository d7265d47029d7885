"""The time when a flying ball first hits the table, compared with exact arithmetic.

The reference isolates the roots of each contact's polynomial, of degree 2 to 8, by Sturm's theorem
in rational numbers, so that no root is missed, and refines them to 50 digits. The shapes of the
table come from the engine (`carom.tables()`).
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import Any

import carom
import numpy as np
import pytest

from oracles.contacts import first_meeting
from oracles.places import places_of
from oracles.shots import PHYSICS, RADIUS
from oracles.world import State, World, geometry_of, key_of, state_of, world_of

JSON = dict[str, Any]

#: Largest error of a time, as the distance that the ball moves in it, m: a few roundings of a
#: position. At a grazing contact the error of the time grows as the square root of a rounding.
WAY = 1e-14
#: Largest gap at the engine's contact, m.
GAP = 2e-15
#: A contact whose speed along the normal is below this, m/s, is grazing.
GRAZE = 0.02
#: Time for which a flight is followed, s; every flight here is shorter.
HORIZON = 2.0


@dataclass(frozen=True)
class Case:
    """A flight and the table under it."""

    shot: JSON
    world: World
    state: State


def cases(name: str, seed: int, count: int) -> list[Case]:
    """Flights that land near edges: at the rims of pockets, at jaws and at noses."""
    table = next(table for table in carom.tables() if table["name"] == name)
    geometry = geometry_of(table)
    size = np.array(table["size"])
    rng = np.random.default_rng([seed, len(name)])
    made = []
    for _ in range(count):
        holes = geometry["holes"]
        target = np.array(holes[rng.integers(len(holes))].center) + rng.normal(0.0, 0.07, 2)
        start = np.clip(target + rng.normal(0.0, 0.25, 2), 0.06, size - 0.06)
        lasts = rng.uniform(0.02, 0.3)
        low, high = (RADIUS + 0.12 * rng.uniform(size=2) ** 2).tolist()
        rise = (high - low) / lasts + PHYSICS["gravity"] * lasts / 2
        velocity = [*((target - start) / lasts).tolist(), rise]
        ball = {"id": "0", "position": [*start.tolist(), low], "velocity": velocity}
        shot = {"format": "carom-shot/1", "table": name, "physics": PHYSICS, "balls": [ball]}
        world = world_of(shot, geometry)
        state = State(tuple(ball["position"]), tuple(velocity), (0.0, 0.0, 0.0), "airborne")
        made.append(Case(shot, world, state))
    return made


@dataclass
class Worst:
    """The contacts, counted by kind, and the largest differences."""

    met: Counter[str]
    time: float = 0.0
    way: float = 0.0
    gap: float = 0.0


def judge(made: list[Case]) -> Worst:
    worst = Worst(Counter())
    for case in made:
        event = carom.Shot.from_dict(case.shot).simulate().to_dict()["events"][0]
        expected = first_meeting(case.world, RADIUS, case.state, HORIZON)
        if event["type"] in ("off-table", "pocket-collision"):
            # No contact: the ball flies over the rails, or falls through the middle of the hole.
            assert expected is None or float(expected.time) > event["time"] - WAY, case.shot
            continue
        assert expected is not None, case.shot
        before = state_of(event["before"][0])
        here = np.array(before.position)
        gaps = [(abs(float(p.gap(here))), p) for p in places_of(case.world, RADIUS)]
        gap, place = min(gaps, key=lambda g: g[0])
        speed = math.dist(before.velocity, (0.0, 0.0, 0.0))
        along = float(np.array(before.velocity) @ place.normal(here))
        if along < GRAZE:
            continue
        time = abs(float(expected.time - event["time"]))
        assert time * along < WAY, (case.shot, key_of(event), expected, time)
        assert gap < GAP, (case.shot, key_of(event), gap)
        key = key_of(event)
        assert (key[0], *key[2:]) == expected.key or time * speed < WAY, (case.shot, key, expected)
        worst.met[f"{key[-1] if len(key) > 2 else 'slate'}, degree {expected.degree}"] += 1
        worst.time = max(worst.time, time)
        worst.way, worst.gap = max(worst.way, time * along), max(worst.gap, gap)
    return worst


@pytest.mark.parametrize(("name", "count"), [("wpa-9ft", 40), ("snooker-12ft", 20)])
def test_a_flight_hits_the_table_when_and_where_exact_arithmetic_says(
    name: str, count: int
) -> None:
    worst = judge(cases(name, 1, count))
    assert len(worst.met) > 4, worst


@pytest.mark.stress
@pytest.mark.parametrize("name", ["wpa-9ft", "snooker-12ft", "english-7ft"])
def test_thousands_of_flights_hit_the_table_when_exact_arithmetic_says(name: str) -> None:
    worst = judge(cases(name, 2, 2000))
    assert {k.split()[-1] for k in worst.met} == {"2", "4", "8"}
