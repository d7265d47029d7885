"""The oracles agree with each other and with published numbers before they judge the engine.

One is a time-stepping integrator, the other a 50-digit event simulation. They share the impact
laws, the reading of shots and the description of the table.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from mpmath import mp, mpf

from oracles import laws
from oracles.compare import follow, trace_of
from oracles.friction import Ball, squeeze
from oracles.precise import Precise
from oracles.shots import random_flight, random_shot
from oracles.springs import final_slip
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


def test_the_tangential_spring_gives_the_slips_that_pooltool_gives() -> None:
    published = {0.05: -0.007, 0.2: 0.02279, 0.4: 0.19084, 0.8: 0.38319, 1.2: 0.095, 1.6: -0.305}
    for slip, last in published.items():
        found = -final_slip(1.0, slip, 0.85, 0.2, 1.7)
        assert float(found) == pytest.approx(last, abs=1e-5)


def stepped(slip: float, e: float, friction: float, ratio: float, steps: int = 100_000) -> float:
    """The springs of `springs`, in small steps of time."""
    compression, end = math.pi / 2, math.pi / 2 * (1 + e)
    h = end / steps
    t = h * (np.arange(steps) + 0.5)
    normal = np.sin(np.where(t < compression, t, compression + (t - compression) / e))
    v, held = slip, 0.0
    for limit in (friction * normal).tolist():
        held = min(max(held + ratio**2 / 3.5 * v * h, -limit), limit)
        v -= 3.5 * held * h
    return v


@pytest.mark.parametrize("seed", range(6))
def test_the_tangential_spring_agrees_with_small_steps(seed: int) -> None:
    rng = np.random.default_rng(seed)
    slip, e = float(rng.uniform(0.0, 1.0)), float(rng.uniform(0.2, 1.0))
    friction, ratio = float(rng.uniform(0.05, 0.4)), float(rng.uniform(1.05, 1.95))
    found = float(final_slip(1.0, slip, e, friction, ratio))
    assert found == pytest.approx(stepped(slip, e, friction, ratio), abs=1e-4)


def snooker_rail(angle: float, digits: int) -> tuple[Any, Any]:
    """Velocity and spin after a ball of 1 m/s has rolled into the rail of Mathavan 2010."""
    radius, lean = mpf("0.02625"), mpf("0.4")
    x, y = mp.cos(mp.radians(angle)), mp.sin(mp.radians(angle))
    axis = (mpf(0), mp.sqrt(1 - lean**2), lean)
    rolling = (-y / radius, x / radius, mpf(0))
    ball = Ball(mpf("0.1406"), radius, (x, y, mpf(0)), rolling, axis)
    return squeeze([ball], mpf("0.14"), mpf("0.212"), mpf("0.98"), digits)[0]


@pytest.mark.parametrize(
    ("angle", "speed", "out"), [(20, 0.895, 21.75), (45, 0.848, 52.68), (80, 0.905, 83.39)]
)
def test_exact_coulomb_friction_gives_the_rebounds_of_mathavans_figure_9(
    angle: float, speed: float, out: float
) -> None:
    (x, y, _), _ = snooker_rail(angle, 17)
    assert float(mp.hypot(x, y)) == pytest.approx(speed, abs=5e-4)
    assert math.degrees(math.atan2(-y, x)) == pytest.approx(out, abs=0.006)


def test_more_digits_change_an_integrated_impact_by_less_than_they_claim() -> None:
    mp.dps = 50
    (few, _), (many, spin) = snooker_rail(30, 34), snooker_rail(30, 44)
    assert max(abs(a - b) for a, b in zip(few, many, strict=True)) < mpf(10) ** -32
    (doubles, _) = snooker_rail(30, 17)
    assert max(abs(a - b) for a, b in zip(doubles, many, strict=True)) < mpf(10) ** -15
    assert spin[2] != 0


def test_without_a_cloth_the_integrated_impact_is_that_of_rigid_friction() -> None:
    ball = laws.Body(0.17, 0.028575, (0.0, 0.0, 0.3), (1.0, -0.6, -0.4), (20.0, -30.0, 11.0))
    normal = (0.8, 0.0, -0.6)
    for mu in (0.1, 0.6):
        law = {"restitution": 0.8, "friction": mu}
        closed = laws.rebound({"model": "han-2005", **law}, ball, normal, on_bed=False)
        found = laws.rebound({"model": "mathavan-2010", **law}, ball, normal, on_bed=False)
        assert found.velocity == pytest.approx(closed.velocity, abs=1e-14)
        assert found.spin == pytest.approx(closed.spin, abs=1e-12)
