"""The film of simulated shots in tracks/: it is read, checked, and its table is learned."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from carom import learn

ROOT = Path(__file__).parents[2]
FILM = ROOT / "tracks" / "three_cushion_film.csv.gz"
#: Largest errors of what is learned from six shots in two rounds. The fit begins with
#: the values of the preset, which are more than three times as far away.
BOUNDS = {"rolling.a": 0.001, "cushion.restitution.a": 0.011}


@pytest.fixture(scope="module")
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("film_shots", ROOT / "scripts" / "film_shots.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def tracks() -> learn.Tracks:
    return learn.read_tracks(FILM)


def test_the_stored_samples_are_those_that_the_script_makes(
    script: ModuleType, tracks: learn.Tracks
) -> None:
    made = script.film().tracks
    assert tracks.names == made.names
    for shot, other in zip(tracks, made, strict=True):
        for ball, track in shot.balls.items():
            np.testing.assert_allclose(track.time, other.balls[ball].time, atol=6e-5)
            np.testing.assert_allclose(track.position, other.balls[ball].position, atol=6e-6)


def test_the_film_is_read_as_a_match_and_is_good(tracks: learn.Tracks) -> None:
    assert any("three-cushion match" in str(finding) for finding in tracks.findings)
    found = learn.check(tracks)
    assert [shot.grade for shot in found.shots] == ["good"] * 6
    assert {shot.struck for shot in found.shots} == {"1"}
    assert found.sigma == pytest.approx(0.001, rel=0.2)


def test_a_sample_is_stored_only_when_a_ball_has_moved(tracks: learn.Tracks) -> None:
    for shot in tracks:
        for ball in shot.balls.values():
            steps = np.hypot(*np.diff(ball.position, axis=0).T)
            # The last picture is always stored.
            assert (steps[:-1] > 0.01498).all()


def test_the_numbers_of_the_table_are_found(script: ModuleType, tracks: learn.Tracks) -> None:
    learned = learn.table(tracks, free=[*script.TRUTH], rounds=2, starts=12)
    for name, mean, start in zip(learned.names, learned.mean, learned.model.start, strict=True):
        true = script.TRUTH[name]
        assert abs(mean - true) < BOUNDS[name], learned.summary()
        assert abs(start - true) > 3.0 * BOUNDS[name], name
