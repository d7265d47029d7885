"""The two oracles agree with each other before they judge the engine.

One is a time-stepping integrator, the other a 50-digit event simulation. They share the impact
laws, the reading of shots and the description of the table.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from oracles.compare import follow, trace_of
from oracles.precise import Precise
from oracles.shots import random_flight, random_shot
from oracles.stepping import Stepping
from oracles.world import start_of, world_of

if TYPE_CHECKING:
    from collections.abc import Callable

#: Accuracy of the integrator, m and s, limited by its tolerances and by roots at grazing contacts.
ACCURACY = 1e-9


@pytest.mark.parametrize("make", [random_shot, random_flight])
@pytest.mark.parametrize("seed", range(4))
def test_both_oracles_find_the_same_events(seed: int, make: Callable[..., Any]) -> None:
    shot = make(seed, balls=3)
    world = world_of(shot)
    events = trace_of(Precise(world, start_of(shot)), limit=25)
    assert len(events) > 5
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < ACCURACY, worst
