"""Networks of springs integrated in time: published and exact cases, and the engine's impacts."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from oracles.networks import MASS, RADIUS, difference, random_cluster
from oracles.touching import Law, Network, stiffness_of_time

#: Accuracy of the integration with its smoothed transitions, as a share of the fastest speed.
SMOOTHED = 1e-3
#: A cue of 20 oz, and how long a tip stays on the ball at 1 m/s without losses, s.
CUE, TIP = 0.567, 1e-3

KINDS = [(m, a) for m in ("elastic", "frictional", "compliant") for a in (True, False)]


def row_of_balls(speeds: list[float], law: Law) -> list[float]:
    network = Network()
    at = [network.ball(MASS, RADIUS, (v, 0.0, 0.0)) for v in speeds]
    for a, b in pairwise(at):
        network.join_balls(a, b, (1.0, 0.0, 0.0), law)
    after = network.solve()
    return [float(after[k]) for k in at]


def test_three_balls_in_a_row_part_as_published() -> None:
    # TP B.29.
    after = row_of_balls([1.0, 0.0, 0.0], Law(1.0))
    assert after == pytest.approx([-0.071, 0.076, 0.995], abs=1e-3)


@pytest.mark.parametrize("restitution", [0.0, 0.5, 0.9, 1.0])
def test_two_balls_part_with_the_restitution(restitution: float) -> None:
    after = row_of_balls([1.0, 0.0], Law(restitution))
    assert after[1] - after[0] == pytest.approx(restitution, abs=SMOOTHED)
    assert sum(after) == pytest.approx(1.0, abs=1e-9)


def test_a_contact_lasts_as_long_as_its_stiffness_was_chosen_for() -> None:
    network = Network()
    ball = network.ball(MASS, RADIUS, (0.0, 0.0, -1.0))
    network.join_wall(ball, (0.0, 0.0, -1.0), stiffness_of_time(MASS, 2e-3), Law(1.0))
    assert network.solve()[ball + 2] == pytest.approx(1.0, abs=SMOOTHED)
    pressed = network.times[network.forces[0] > 0.0]
    assert pressed[-1] == pytest.approx(2e-3, rel=1e-2)


@pytest.mark.parametrize("friction", [0.05, 0.2, 1.0])
def test_a_rigid_contact_stops_the_slip_or_slides(friction: float) -> None:
    # A sphere of speed 1 along a wall: the impulse μ(1 + e) stops the slip at 2/7.
    network = Network()
    ball = network.ball(MASS, RADIUS, (1.0, 0.0, -1.0))
    network.join_wall(ball, (0.0, 0.0, -1.0), stiffness_of_time(MASS, 1e-3), Law(0.5, friction))
    after = network.solve()
    lost = min(1.5 * friction, 2.0 / 7.0)
    assert after[ball] == pytest.approx(1.0 - lost, abs=SMOOTHED)
    assert after[ball + 4] == pytest.approx(2.5 * lost, abs=3 * SMOOTHED)


def strike(
    elevation: float, side: float, height: float, friction: float | None
) -> tuple[Network, np.ndarray[tuple[int], np.dtype[np.float64]]]:
    """A cue at 3 m/s strikes a ball at rest; with a slate under it if `friction` is given."""
    cos, sin = math.cos(elevation), math.sin(elevation)
    axis = np.array([cos, 0.0, -sin])
    arm = side * np.array([0.0, -1.0, 0.0]) + height * np.array([sin, 0.0, cos])
    network = Network()
    ball = network.ball(MASS, RADIUS)
    cue = network.cue(CUE, 3.0)
    stiffness = stiffness_of_time(MASS * CUE / (MASS + CUE), TIP)
    network.join_tip(cue, ball, axis, axis, arm, stiffness, 0.6)
    if friction is not None:
        slate = stiffness_of_time(MASS, 0.5 * TIP)
        network.join_wall(ball, (0.0, 0.0, -1.0), slate, Law(0.5, friction))
    return network, network.solve()


@pytest.mark.parametrize(("side", "height"), [(0.0, 0.0), (0.3, 0.2), (0.0, -0.5)])
def test_a_tip_alone_gives_the_speed_of_leckie_and_greenspan(side: float, height: float) -> None:
    _, after = strike(0.4, side, height, None)
    expected = 1.6 * 3.0 / (MASS / CUE + 1.0 + 2.5 * (side**2 + height**2))
    assert np.linalg.norm(after[:3]) == pytest.approx(expected, abs=3 * SMOOTHED)
    assert np.linalg.norm(after[3:6]) == pytest.approx(
        2.5 * math.hypot(side, height) * expected, abs=3 * SMOOTHED
    )


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.4])
def test_the_direction_of_a_masse_does_not_depend_on_the_friction(friction: float) -> None:
    # TP A.19: tan θ = a sin φ/(R cos φ + b), for a = ¼R on the right and b = ¼R below the centre.
    elevation = math.radians(75.0)
    _, after = strike(elevation, 0.25, -0.25, friction)
    vx, vy, _, wx, wy = after[:5]
    # What rolls at the end: 5/7 v + 2/7 Rω × ẑ; friction at the cloth does not change it.
    x, y = 5 * vx + 2 * wy, 5 * vy - 2 * wx
    theta = math.degrees(math.atan2(-y, x))
    expected = math.degrees(math.atan2(0.25 * math.sin(elevation), math.cos(elevation) - 0.25))
    assert theta == pytest.approx(expected, abs=0.01)


def test_a_cue_that_presses_a_ball_on_the_slate_holds_it_down() -> None:
    # Taken one after another, tip and slate make the ball hop by 12 cm (e = 0.73).
    _, after = strike(math.radians(75.0), 0.25, -0.25, 0.2)
    assert 0.0 < after[2] ** 2 / (2 * 9.80665) < 0.015


#: Largest and median differences from the engine, as a share of the fastest ball's speed, by model
#: and by whether the balls are alike. The engine takes 11 steps in a contact; with 400 steps the
#: medians of eight networks of each kind are below 3e-4.
BOUNDS = {
    ("elastic", True): (4e-3, 1e-3),
    ("elastic", False): (2e-2, 2e-3),
    ("frictional", True): (4e-2, 8e-3),
    ("frictional", False): (4e-2, 1e-2),
    ("compliant", True): (2e-2, 4e-3),
    ("compliant", False): (2e-2, 4e-3),
}


@pytest.mark.parametrize(("model", "alike"), KINDS)
def test_the_engine_resolves_a_network_as_its_springs_do(model: str, alike: bool) -> None:
    sizes = (3, 5, 8, 11, 15)
    apart = [difference(random_cluster(k, n, model, alike)) for k, n in enumerate(sizes)]
    most, middle = BOUNDS[model, alike]
    assert max(apart) < most, apart
    assert np.median(apart) < middle, apart


@pytest.mark.stress
@pytest.mark.parametrize(("model", "alike"), KINDS)
def test_the_engine_resolves_thousands_of_networks(model: str, alike: bool) -> None:
    apart = [difference(random_cluster(k, 3 + k % 13, model, alike)) for k in range(1000, 2700)]
    assert np.median(apart) < BOUNDS[model, alike][1]
