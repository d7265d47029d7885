"""The frame of a robot: its calibration, cue motions in it, and the errors that it causes."""

from __future__ import annotations

import math
from typing import Any

import carom
import numpy as np
import pytest
from carom import Noise, RobotFrame, Strike

RADIUS = 0.028575
# Balls on the cloth and two marks on posts, m.
POINTS = np.array(
    [
        [0.1, 0.2, RADIUS],
        [1.1, 0.3, RADIUS],
        [0.6, 2.3, RADIUS],
        [0.2, 1.5, RADIUS],
        [1.2, 1.9, 0.3],
        [0.0, 1.0, 0.4],
    ]
)
OFFSET = np.array([2.0, -1.0, 0.8])


def rotation(*vector: float) -> np.ndarray:
    """By a rotation vector, as the matrix exponential's series."""
    x, y, z = vector
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0.0]])
    term, total = np.eye(3), np.eye(3)
    for k in range(1, 40):
        term = term @ cross / k
        total = total + term
    return total


TURN = rotation(0.3, -0.2, 2.5)
UP = TURN[:, 2]


def seen(scale: float = 1.0, points: np.ndarray = POINTS) -> np.ndarray:
    return scale * points @ TURN.T + OFFSET


def shot(**strike: Any) -> carom.Shot:
    given = {"speed": 2.0, "azimuth": 1.4, "elevation": 0.2, "side": 0.3, "height": -0.2}
    balls = {"cue": (0.6, 0.6), "1": (0.7, 1.3)}
    return carom.Shot("wpa-9ft", balls, Strike(**{**given, **strike}))


@pytest.mark.parametrize("scale", [1.0, 1.02])
@pytest.mark.parametrize(("count", "vertical"), [(6, None), (3, None), (6, 2 * UP), (2, 2 * UP)])
def test_exact_points_give_the_exact_frame(scale: float, count: int, vertical: Any) -> None:
    points = POINTS[:count]
    frame = RobotFrame.fit(points, seen(scale, points), scale=scale != 1.0, vertical=vertical)
    assert frame.rotation == pytest.approx(TURN, abs=1e-12)
    assert frame.offset == pytest.approx(OFFSET, abs=1e-12)
    assert frame.scale == pytest.approx(scale, abs=1e-12)
    assert frame.to_table(seen(scale)) == pytest.approx(POINTS, abs=1e-12)
    assert frame.deviations.max() < 1e-12


@pytest.mark.parametrize("vertical", [None, UP])
def test_the_covariance_is_that_of_repeated_calibrations(vertical: Any) -> None:
    rng, sigma, errors, estimates = np.random.default_rng(3), 0.002, [], []
    for _ in range(2000):
        noisy = seen(1.01) + rng.normal(0, sigma, POINTS.shape)
        frame = RobotFrame.fit(POINTS, noisy, scale=True, vertical=vertical)
        turn = frame.rotation @ TURN.T
        small = np.array(
            [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
        )
        centre = frame.to_robot(frame.centre) - (1.01 * TURN @ frame.centre + OFFSET)
        errors.append([*small / 2, *centre, frame.scale / 1.01 - 1])
        estimates.append(np.trace(frame.covariance))
    stated = RobotFrame.fit(POINTS, noisy, sigma=sigma, scale=True, vertical=vertical).covariance
    found = np.cov(np.array(errors).T)
    size = np.sqrt(np.outer(np.diagonal(stated), np.diagonal(stated))) + 1e-12
    # A sample covariance of 2000 has a relative standard deviation of at most √(2 / 2000) = 3 %.
    assert np.abs((found - stated) / size).max() < 0.13
    # The deviation of one coordinate is estimated from 11 or 13 degrees of freedom.
    assert np.mean(estimates) == pytest.approx(np.trace(stated), rel=0.05)


@pytest.mark.parametrize(
    "strike",
    [
        {},
        {"elevation": 1.3},
        {"elevation": 0.0},
        {"azimuth": -3.1, "height": 0.3},
        {"azimuth": 3.14159},
    ],
)
def test_a_strike_comes_back_from_its_command(strike: dict[str, float]) -> None:
    own = shot(**strike)
    frame = RobotFrame.fit(POINTS, seen(1.02), scale=True)
    command = frame.command(own, run_up=0.2)
    assert math.dist(command.tip, command.start) == pytest.approx(0.2)
    assert np.linalg.norm(command.direction) == pytest.approx(1.0)
    pose = own.cue_pose()
    assert pose.clearance is not None
    assert command.clearance == pytest.approx(1.02 * pose.clearance)
    assert command.nearest == pose.nearest
    assert command.speed == pytest.approx(2.04)
    for point in (command.tip, command.start):
        again = frame.strike(own, point, command.direction, command.speed)
        assert own.strike is not None
        for name in ("speed", "azimuth", "elevation", "side", "height"):
            expected = getattr(own.strike, name)
            assert getattr(again, name) == pytest.approx(expected, abs=1e-9), name


def noisy_frame(sigma: float = 0.001) -> RobotFrame:
    noise = np.random.default_rng(5).normal(0, sigma, POINTS.shape)
    return RobotFrame.fit(POINTS, seen() + noise, sigma=sigma, scale=True)


def test_the_noise_is_that_of_strikes_in_drawn_frames() -> None:
    own, frame = shot(), noisy_frame()
    command = frame.command(own)
    struck = [
        true.strike(own, command.tip, command.direction, command.speed)
        for true in frame.draw(4000, seed=1)
    ]
    rows = np.array(
        [[s.speed, s.azimuth, s.elevation, s.side * RADIUS, s.height * RADIUS] for s in struck]
    )
    stated = np.array(frame.noise(own).covariance)
    size = np.sqrt(np.outer(np.diagonal(stated), np.diagonal(stated)))
    assert np.abs((np.cov(rows.T) - stated) / size).max() < 0.1
    assert rows.mean(axis=0) == pytest.approx(
        [2.0, 1.4, 0.2, 0.3 * RADIUS, -0.2 * RADIUS], abs=1e-3
    )


@pytest.mark.parametrize("azimuth", [1.4, math.pi])
def test_a_turn_about_the_vertical_is_an_error_of_the_azimuth(azimuth: float) -> None:
    own = shot(azimuth=azimuth, side=0.0, height=0.0, elevation=0.0)
    tip = np.array(own.cue_pose().tip)
    covariance = np.diag([0, 0, 0.01**2, 0, 0, 0.002**2, 0])
    frame = RobotFrame(np.eye(3), np.zeros(3), covariance=covariance, centre=tip)
    deviations = frame.noise(own).deviations()
    # The tip is a radius behind the centre, so a turn there moves the axis aside at the centre.
    expected = [0.0, 0.01, 0.0, 0.01 * RADIUS, 0.002]
    assert deviations == pytest.approx(expected, rel=1e-6, abs=1e-6)


# The errors of rotation from the table's axes to the robot's.
TURN_FULL = np.eye(7)
TURN_FULL[:3, :3] = TURN


def test_a_level_cue_has_noise_of_its_elevation() -> None:
    covariance = np.diag([0.01**2, 0.01**2, 0, 0, 0, 0, 0])
    frame = RobotFrame(TURN, OFFSET, covariance=TURN_FULL @ covariance @ TURN_FULL.T)
    level = frame.noise(shot(elevation=0.0)).deviations()
    raised = frame.noise(shot(elevation=1e-3)).deviations()
    assert level[2] == pytest.approx(0.01, rel=1e-4)
    assert level == pytest.approx(raised, rel=0.02, abs=1e-4)


def test_the_chance_with_the_noise_is_that_over_drawn_frames() -> None:
    pot = carom.Shot(
        "wpa-9ft",
        {"cue": (0.45, 0.75), "8": (0.80, 1.45)},
        Strike(1.84, 1.09816, elevation=0.1, side=0.07, height=-0.23),
    )
    robot = Noise(azimuth=0.001)
    frame = noisy_frame(0.003)
    command = frame.command(pot)
    chances = []
    for k, true in enumerate(frame.draw(400, seed=2)):
        s = true.strike(pot, command.tip, command.direction, command.speed)
        executed = carom.Shot(pot.table, pot.balls, s, physics=pot.physics)
        chances.append(executed.evaluate(robot, 20, seed=k).pot("8").probability)
    both = pot.evaluate(robot + frame.noise(pot), 4000).pot("8").probability
    alone = pot.evaluate(robot, 4000).pot("8").probability
    # Three standard deviations of both samples, and 0.02 for the linear errors.
    bound = 3 * math.hypot(np.std(chances) / 20, 0.5 / math.sqrt(4000)) + 0.02
    assert abs(np.mean(chances) - both) < bound
    assert both < alone - 0.1


def test_the_sum_of_two_noises_adds_their_covariances() -> None:
    one = Noise(0.03, bias=[0, 0.1, 0, 0, 0], covariance=np.eye(5) * 1e-5, speed_relative=0.03)
    other = Noise(0.04, covariance=np.eye(5) * 3e-5, speed_relative=0.04, cling_probability=0.1)
    both = one + other
    assert both.speed == pytest.approx(0.05)
    assert both.speed_relative == pytest.approx(0.05)
    assert np.array(both.covariance) == pytest.approx(np.eye(5) * 4e-5)
    assert both.bias == one.bias
    assert both.cling_probability == 0.1
    with pytest.raises(carom.InputError, match="both have cling"):
        other + other
    with pytest.raises(carom.InputError, match=r"samples cannot be added.*covariance"):
        one + Noise(samples=np.zeros((2, 5)))
    with pytest.raises(TypeError):
        one + 1  # type: ignore[operator]


MIRROR = np.diag([1.0, -1.0, 1.0])
LINE = np.linspace(0, 1, 4)[:, None] * [1.0, 2.0, 0.0]
ABOVE = np.array([[0.5, 0.5, 0.0], [0.5, 0.5, 1.0]])
MISSED = np.where(np.arange(6)[:, None] == 2, np.nan, POINTS)


@pytest.mark.parametrize(
    ("table", "robot", "options", "message"),
    [
        (POINTS, seen() @ MIRROR, {}, "robot: .*mirrored; give right-handed axes"),
        (POINTS[:4], seen()[:4], {"vertical": -UP}, "robot: .*mirrored"),
        (POINTS[:4], seen()[:4] @ MIRROR, {"vertical": MIRROR @ UP}, "robot: .*mirrored"),
        (LINE, seen(points=LINE), {}, "table: the points are on a line; add a point"),
        (ABOVE, seen(points=ABOVE), {"vertical": UP}, "table: the points are above each other"),
        (POINTS[[0, 0]], seen()[[0, 0]], {"vertical": UP}, "table: the points are on a line"),
        (POINTS[:2], seen()[:2], {}, "table: 2 points are too few; give three"),
        (POINTS[:1], seen()[:1], {"vertical": UP}, "table: 1 points are too few"),
        (POINTS, seen()[:5], {}, "robot: 5 points for 6 of the table"),
        (MISSED, seen(), {}, "table: a number is not finite; remove the pairs"),
        (POINTS[:, :2], seen(), {}, r"table: has the shape \(6, 2\); give x, y, z"),
        (POINTS[0], seen()[0], {}, "table: has the shape .*n_points, 3"),
        (POINTS, 1000 * seen(), {"scale": True}, "robot: .* 1000 times .*both in metres"),
        (POINTS, seen()[::-1], {}, "robot: the pairs do not fit.*same order"),
        (POINTS, seen(), {"sigma": 0.0}, "sigma: 0 is out of range"),
        (POINTS, seen(), {"vertical": (0, 0, 0)}, "vertical: has no length"),
    ],
)
def test_points_that_give_no_frame_are_named(table, robot, options, message: str) -> None:
    with pytest.raises(carom.InputError, match=message):
        RobotFrame.fit(table, robot, **options)


def test_a_wrong_frame_or_motion_is_named() -> None:
    with pytest.raises(carom.InputError, match=r"rotation: .*−1; give right-handed axes"):
        RobotFrame(MIRROR, np.zeros(3))
    with pytest.raises(carom.InputError, match="rotation: the rows are not unit vectors"):
        RobotFrame(2 * np.eye(3), np.zeros(3))
    with pytest.raises(carom.InputError, match="covariance: not symmetric and positive"):
        RobotFrame(np.eye(3), np.zeros(3), covariance=-np.eye(7))
    frame = RobotFrame(TURN, OFFSET)
    with pytest.raises(carom.InputError, match="run_up: -1 m is out of range"):
        frame.command(shot(), run_up=-1)
    with pytest.raises(carom.InputError, match="the shot has no strike"):
        frame.noise(carom.Shot("wpa-9ft", {"cue": (0.6, 0.6)}))
    with pytest.raises(carom.InputError, match="tip: the cue's axis passes"):
        frame.strike(shot(), OFFSET, UP @ np.diag([1, 1, 0.5]) * -1, 1.0)
