"""Before they judge the engine: a time-stepping integrator and a 50-digit event simulation, which
share only the impact laws, tell the same story.
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

#: What the integrator can give, m and s: its tolerances, and roots near grazing contacts.
ACCURACY = 1e-9


@pytest.mark.parametrize("make", [random_shot, random_flight])
@pytest.mark.parametrize("seed", range(4))
def test_stepping_and_precise_tell_the_same_story_event_by_event(
    seed: int, make: Callable[..., Any]
) -> None:
    shot = make(seed, balls=3)
    world = world_of(shot)
    events = trace_of(Precise(world, start_of(shot)), limit=25)
    assert len(events) > 5
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < ACCURACY, worst
