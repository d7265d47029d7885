"""What a robot needs around a strike: the cue's pose, limits of reach, and rolling starts."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING

import carom
import numpy as np
import pytest
from carom import Strike

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

RADIUS = 0.028575
BALLS = {"cue": (0.6, 0.6), "1": (0.7, 1.3), "2": (0.3, 1.9)}


def shot(**strike: float) -> carom.Shot:
    given = {"speed": 2.0, "azimuth": 1.4, "elevation": 0.2, "side": 0.3, "height": -0.2}
    return carom.Shot("wpa-9ft", BALLS, Strike(**{**given, **strike}))


def test_a_level_cue_touches_the_ball_behind_its_centre() -> None:
    pose = shot(azimuth=math.pi / 2, elevation=0.0, side=0.0, height=0.0).cue_pose()
    assert pose.tip == pytest.approx((0.6, 0.6 - RADIUS, RADIUS), abs=1e-15)
    assert pose.direction == pytest.approx((0.0, 1.0, 0.0), abs=1e-15)
    assert pose.butt == pytest.approx((0.6, 0.6 - RADIUS - 1.47, RADIUS), abs=1e-15)


def test_side_and_height_are_across_the_cue_at_every_elevation() -> None:
    centre = np.array([0.6, 0.6, RADIUS])
    for elevation in (0.0, 0.4, 1.2):
        own = shot(elevation=elevation)
        pose = own.cue_pose()
        direction = np.array(pose.direction)
        right = np.array([math.sin(1.4), -math.cos(1.4), 0.0])
        up = np.cross(right, direction)
        arm = (np.array(pose.tip) - centre) / RADIUS
        assert np.linalg.norm(arm) == pytest.approx(1.0)
        assert [arm @ right, arm @ up] == pytest.approx([0.3, -0.2])
        assert arm @ direction < 0
    # A raised cue without an offset touches the ball above its equator.
    assert shot(elevation=0.4, height=0.0).cue_pose().tip[2] > RADIUS + 0.3 * RADIUS


def test_a_strike_comes_back_from_its_pose() -> None:
    for strike in (
        {},
        {"elevation": 1.3, "side": -0.4},
        {"elevation": 0.0, "azimuth": -2.5, "height": 0.3},
    ):
        own = shot(**strike)
        pose = own.cue_pose()
        # The tip is still 5 cm away, and the direction has any length.
        before = np.array(pose.tip) - 0.05 * np.array(pose.direction)
        again = Strike.from_pose(own, before, 3 * np.array(pose.direction), 2.0)
        written = own.to_dict()["strike"]
        for name in ("speed", "azimuth", "elevation", "side", "height"):
            expected = written.get(name, math.radians(written.get(f"{name}_deg", 0.0)))
            assert getattr(again, name) == pytest.approx(expected, abs=1e-12), name


def test_the_clearance_is_that_over_the_rail_behind_the_ball() -> None:
    # Frozen to the bottom rail, level: the nose is higher than the cue's lower edge.
    balls = {"cue": (0.6, 0.03)}
    own = carom.Shot("wpa-9ft", balls, Strike(1.0, math.pi / 2, 0.0))
    pose = own.cue_pose()
    assert pose.nearest == "bottom"
    assert pose.clearance is not None
    assert pose.clearance < 0
    raised = own.with_strike(elevation=carom.Shot("wpa-9ft", balls, Strike(1.0, 1.57)).elevation)
    assert raised.cue_pose().clearance == pytest.approx(0.0, abs=1e-4)
    # A ball behind the cue ball.
    behind = {"cue": (0.6, 1.2), "1": (0.6, 1.0)}
    assert carom.Shot("wpa-9ft", behind, Strike(1.0, math.pi / 2, 0.05)).cue_pose().nearest == "1"


@pytest.mark.parametrize(
    ("tip", "direction", "message"),
    [
        ((0.6, 0.5, RADIUS), (0, 1, 0.1), "direction: .* points up"),
        ((0.6, 0.6, 0.5), (0, 0, -1), "direction: .* has no azimuth"),
        ((0.65, 0.5, RADIUS), (0, 1, 0), "tip: the cue's axis passes the ball's centre at 1.74"),
        ((0.6, 0.5), (0, 1, 0), "tip: .* is not 3 numbers"),
    ],
)
def test_a_pose_that_is_no_strike_is_refused(tip, direction, message: str) -> None:
    with pytest.raises(carom.InputError, match=message):
        Strike.from_pose(shot(), tip, direction, 1.0)
    with pytest.raises(carom.InputError, match=r'ball: there is no ball "9"'):
        Strike.from_pose(shot(), (0.6, 0.5, RADIUS), (0, 1, 0), 1.0, ball="9")


def found(**limits) -> list[carom.plan.Solution]:
    return shot().solve(first="1", samples=512, n=50, wanted=12, **limits)


def within(azimuth: float, first: float, last: float) -> bool:
    return (azimuth - first) % math.tau <= (last - first) % math.tau


@pytest.mark.parametrize("azimuth", [(0, 1), (1.2, 1.6), (5.5, 0.5), (-1.0, 0.3), (3.0, 2.9)])
def test_solutions_keep_to_the_azimuths_that_a_robot_reaches(azimuth) -> None:
    solutions = found(azimuth=azimuth)
    assert solutions
    assert all(within(solution.azimuth, *azimuth) for solution in solutions)


def test_solutions_keep_to_the_elevations_that_a_robot_reaches() -> None:
    solutions = found(elevation=(0.1, 0.3))
    assert solutions
    assert all(0.1 <= solution.elevation <= 0.3 for solution in solutions)
    low = carom.Shot("wpa-9ft", BALLS, Strike(2.0, 1.4))
    solutions = low.solve(first="1", samples=256, n=50, elevation=(0.0, 0.05))
    assert all(solution.elevation <= 0.05 for solution in solutions)


def test_solutions_keep_the_butt_where_the_robot_is() -> None:
    corners = ((-0.5, -1.5), (0.7, -0.5))
    solutions = found(butt=corners)
    assert solutions
    for solution in solutions:
        x, y, _ = solution.shot.cue_pose().butt
        assert -0.5 <= x <= 0.7
        assert -1.5 <= y <= -0.5


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        ({"azimuth": (0, 1, 2)}, "azimuth: .* is not 2 numbers"),
        ({"azimuth": (0, math.nan)}, "azimuth: .*"),
        ({"elevation": (0.3, 0.1)}, "elevation: 0.3 to 0.1 rad is not a range of elevations"),
        ({"butt": (0, 1)}, r"butt\[0\]: .* is not 2 numbers"),
        ({"butt": 3}, "butt: 3 is not a rectangle"),
    ],
)
def test_limits_of_reach_that_are_no_limits_are_refused(limits, message: str) -> None:
    with pytest.raises(carom.InputError, match=message):
        found(**limits)


def test_the_command_takes_the_limits_of_reach(run: CommandLine, tmp_path: Path) -> None:
    file = tmp_path / "shot.json"
    file.write_text(shot().to_json())
    limits = ("--azimuth-deg", "60:120", "--elevation-deg", "5:20", "--butt=-3,-3,2,0.2")
    done = run(
        "solve", str(file), "--first", "1", "--samples", "256", "-n", "50", "--json", *limits
    )
    assert done.returncode == 0, done.stderr
    solutions = json.loads(done.stdout)
    assert solutions
    for solution in solutions:
        assert 60 <= solution["strike"]["azimuth_deg"] % 360 <= 120


def rolling(ball: dict) -> carom.Shot:
    balls = [{"id": "1", "position": [0.6, 0.6], **ball}, {"id": "2", "position": [0.9, 1.9]}]
    return carom.Shot("wpa-9ft", carom.Layout(balls))


def test_a_track_starts_with_a_ball_that_rolls() -> None:
    trace = rolling({"velocity": [0.3, 0.8, 0.0], "rolling": True}).simulate()
    assert trace.to_dict()["events"][0]["before"][0]["motion"] == "rolling"
    state = trace.at(0.0)
    assert state.angular_velocity[0] == pytest.approx([-0.8 / RADIUS, 0.3 / RADIUS, 0.0])
    by_hand = rolling(
        {"velocity": [0.3, 0.8, 0.0], "angular_velocity": [-0.8 / RADIUS, 0.3 / RADIUS, 0.0]}
    )
    assert trace.hash == by_hand.simulate().hash
    again = carom.Shot.from_dict(rolling({"velocity": [0, 1, 0], "rolling": True}).to_dict())
    assert (
        again.simulate().hash == rolling({"velocity": [0, 1, 0], "rolling": True}).simulate().hash
    )


@pytest.mark.parametrize(
    ("ball", "message"),
    [
        ({"rolling": True}, r"balls\[0\].rolling: the ball has no velocity; write"),
        (
            {"rolling": True, "velocity": [1, 0, 0], "angular_velocity": [0, 0, 1]},
            r"balls\[0\].rolling: a rolling ball's spin follows from its velocity; remove",
        ),
        ({"rolling": 1, "velocity": [1, 0, 0]}, r"balls\[0\].rolling: "),
    ],
)
def test_a_rolling_start_that_contradicts_itself_is_refused(ball, message: str) -> None:
    with pytest.raises(carom.InputError, match=message):
        rolling(ball)
