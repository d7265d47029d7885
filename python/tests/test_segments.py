"""Contacts, runs and shots that are found in tracks, compared with those of the engine."""

from __future__ import annotations

import math
import runpy
from pathlib import Path
from typing import Any

import carom
import numpy as np
import pytest
from carom import InputError, learn
from carom.learn import TrackedBall, TrackedShot, Tracks, TracksHeader

SCRIPT = runpy.run_path(str(Path(__file__).parents[2] / "scripts" / "track_segments.py"))


@pytest.mark.parametrize(
    ("kind", "camera", "least"),
    [
        ("carom", {"rate": 50, "sigma": 0.001}, 0.95),
        ("carom", {"rate": 50, "sigma": 0.001, "least_move": 0.02}, 0.9),
        ("pool", {"rate": 60, "sigma": 0.003}, 0.9),
        ("pool", {"rate": 25, "sigma": 0.001}, 0.85),
    ],
)
def test_the_contacts_of_synthetic_tracks_are_found(
    kind: str, camera: dict[str, float], least: float
) -> None:
    found = SCRIPT["score"](SCRIPT["random_shots"](kind, 8, 7), camera)
    assert found.true > 20
    assert found.found >= least * found.true
    assert found.false <= 0.05 * found.true
    assert found.struck == 8
    assert np.median(found.times) < 0.006
    assert np.median(found.places) < 0.004
    assert np.median(found.starts) < 0.002


def three_balls(**camera: Any) -> learn.SyntheticTracks:
    balls = {"1": (0.5, 0.6), "2": (0.9, 1.3), "3": (1.1, 2.2)}
    shot = carom.Shot("carom-10ft", balls, carom.Strike(3.0, 1.05, ball="1"))
    return learn.synthetic(shot, clock_offset=0.25, **camera)


def test_runs_begin_and_end_at_contacts_and_rests() -> None:
    made = three_balls(rate=100.0, after=1.0)
    found = learn.segment(made.tracks[0], made.tracks.header)
    assert found.struck == "1"
    assert abs(found.start - 0.25) < 0.002
    first = next(run for run in found.runs if run.ball == "1")
    assert first.before is None
    assert first.start == found.start
    for run in found.runs:
        ball = made.tracks[0].balls[run.ball].seen
        assert run.start <= ball.time[run.first] + 0.02
        assert ball.time[run.last] <= run.end + 0.02
        for index, time in ((run.before, run.start), (run.after, run.end)):
            if index is not None:
                assert found.contacts[index].time == time
                assert run.ball in found.contacts[index].balls
    # Every contact of two balls ends and begins a run of a ball that moved.
    used = {index for run in found.runs for index in (run.before, run.after)}
    assert set(range(len(found.contacts))) <= used
    assert {run.ball for run in found.runs if run.stops} == {"1", "2"}


def test_the_velocities_around_a_contact_are_those_of_the_engine() -> None:
    made = three_balls(rate=120.0, sigma=0.0005)
    found = learn.segment(made.tracks[0], made.tracks.header).contacts[0]
    true = made.contacts(0)[0]
    assert set(found.balls) == set(true.balls)
    for ball in true.balls:
        assert math.dist(found.before[ball], true.before[ball]) < 0.05
        assert math.dist(found.after[ball], true.after[ball]) < 0.05


def test_a_shot_without_motion_has_no_contacts() -> None:
    rng = np.random.default_rng(0)
    time = np.arange(100) / 50.0
    balls = {str(i): (time, rng.normal((0.3 * i, 0.5), 0.001, (100, 2))) for i in range(1, 4)}
    header = TracksHeader(table="carom-10ft", radius=0.03075)
    found = learn.segment(TrackedShot("1", balls), header)
    assert (found.contacts, found.runs, found.struck) == ((), (), None)


def test_a_strike_beside_a_rail_is_no_contact_with_it() -> None:
    """Seen: the first contact of a ball that lay at a rail was that rail, at the strike."""
    balls = {"1": (0.031, 1.0), "2": (0.9, 2.0), "3": (1.1, 2.6)}
    shot = carom.Shot("carom-10ft", balls, carom.Strike(2.0, 0.2, ball="1"))
    made = learn.synthetic(shot, clock_offset=0.25, rate=50.0)
    found = learn.segment(made.tracks[0], made.tracks.header)
    assert abs(found.start - 0.25) < 0.01
    assert [contact.rail for contact in found.contacts][:1] == ["right"]


def test_two_changes_at_one_rail_within_30_ms_are_one_contact() -> None:
    """Seen: a rail twice within 16 ms, because one picture showed the ball in the nose."""
    balls = {"1": (0.7, 1.0), "2": (0.2, 2.0), "3": (0.3, 2.6)}
    shot = carom.Shot("carom-10ft", balls, carom.Strike(2.0, 0.2, ball="1"))
    made = learn.synthetic(shot, clock_offset=0.25, rate=100.0, sigma=0.0003)
    ball = made.tracks[0].balls["1"]
    contact = made.contacts(0)[0]
    assert contact.rail == "right"
    # A slow picture smears the reversal: the ball stays at the nose for 20 ms.
    moved = ball.position.copy()
    near = np.abs(ball.time - contact.time) < 0.011
    moved[near, 0] = moved[near, 0].max() - 0.002
    shown = dict(made.tracks[0].balls) | {"1": TrackedBall(ball.time, moved)}
    found = learn.segment(TrackedShot("1", shown), made.tracks.header)
    rails = [one for one in found.contacts if one.rail is not None and one.balls == ("1",)]
    assert len([one for one in rails if abs(one.time - contact.time) < 0.05]) == 1


def test_a_hand_on_the_table_is_an_unknown_contact() -> None:
    time = np.arange(100) / 50.0
    x = np.where(time < 1.0, 0.5, 0.5 + 0.4 * (time - 1.0))
    track = TrackedBall(time, np.column_stack((x, np.minimum(0.4 + time, 1.4))), 0.0005)
    header = TracksHeader(table="carom-10ft", radius=0.03075)
    found = learn.segment(TrackedShot("1", {"cue": track}), header)
    assert [contact.is_known for contact in found.contacts] == [False]
    assert "away from rails and balls" in str(found.findings[0])


@pytest.mark.parametrize("sigma", [0.0005, 0.002])
def test_the_noise_is_estimated_from_the_tracks(sigma: float) -> None:
    made = three_balls(sigma=sigma)
    header = TracksHeader(table="carom-10ft", radius=0.03075)
    found = learn.segment(made.tracks[0], header)
    assert abs(found.sigma["1"] / sigma - 1.0) < 0.2


def recording() -> Tracks:
    """Two shots, one after the other, in one recording."""
    made = three_balls(after=2.0)
    first = made.tracks[0]
    end = first.end + 0.02
    balls = {}
    for ball, track in first.balls.items():
        # The second shot begins where the balls were at the start, as if they had been put back.
        time = np.r_[track.time, track.time + end]
        balls[ball] = TrackedBall(time, np.r_[track.position, track.position])
    return Tracks(made.tracks.header, (TrackedShot("a", balls),))


def test_a_recording_is_cut_where_all_balls_rest() -> None:
    made = three_balls()
    cut = learn.cut_into_shots(made.tracks)
    assert cut.shots == made.tracks.shots
    two = learn.cut_into_shots(recording())
    assert two.names == ["a/1", "a/2"]
    start = learn.segment(two[1], two.header).start
    assert two[1].start < start < two[1].end
    with pytest.raises(InputError, match="lead"):
        learn.cut_into_shots(made.tracks, rest=1.0, lead=0.6)


# The check.


def aimed_shots(count: int) -> list[carom.Shot]:
    """Shots that hit the ball 2, at a different part of it each."""
    shots = []
    for index in range(count):
        cue, ball = (0.3 + 0.1 * index, 0.6), (0.7, 1.4)
        far = math.dist(cue, ball)
        azimuth = math.atan2(ball[1] - cue[1], ball[0] - cue[0])
        azimuth += math.asin((-0.7 + 0.2 * index) * 0.0615 / far)
        strike = carom.Strike(2.0 + 0.2 * index, azimuth, ball="1")
        shots.append(carom.Shot("carom-10ft", {"1": cue, "2": ball, "3": (0.3, 2.4)}, strike))
    return shots


def test_the_check_grades_shots_and_measures_the_balls() -> None:
    report = learn.check(learn.synthetic(aimed_shots(8), clock_offset=0.2).tracks)
    assert report.radius == pytest.approx(0.03075, rel=0.02)
    assert 0.02 < (report.rolling_deceleration or 0.0) < 0.3
    assert report.sigma == pytest.approx(0.001, rel=0.2)
    assert sum(shot.grade == "good" for shot in report.shots) >= 6
    assert not [finding for finding in report.findings if finding.kind.startswith("wrong")]
    assert "radius of the balls from contacts" in str(report)
    assert report.to_dict()["shots"][0]["name"] == "1"


@pytest.mark.parametrize(
    ("changes", "kind"),
    [
        ({"radius": 0.0286}, "wrong-radius"),
        ({"rate": 25.0}, "wrong-rate"),
        ({"table": {"base": "carom-10ft", "width": 1.4}}, "rail-off"),
    ],
)
def test_the_check_finds_what_contradicts_the_header(changes: dict[str, Any], kind: str) -> None:
    tracks = learn.synthetic(aimed_shots(8), clock_offset=0.2).tracks
    header = TracksHeader(**({"table": "carom-10ft", "radius": 0.03075, "rate": 50.0} | changes))
    report = learn.check(Tracks(header, tracks.shots))
    assert kind in {finding.kind for finding in report.findings}


def test_the_check_finds_a_clock_that_is_too_fast() -> None:
    tracks = learn.synthetic(aimed_shots(8), clock_offset=0.2).tracks
    fast = [
        TrackedShot(
            shot.name,
            {ball: TrackedBall(t.time / 3.0, t.position) for ball, t in shot.balls.items()},
        )
        for shot in tracks
    ]
    report = learn.check(Tracks(TracksHeader(table="carom-10ft", radius=0.03075), tuple(fast)))
    assert "wrong-clock" in {finding.kind for finding in report.findings}
