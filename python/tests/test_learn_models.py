"""Fits that were stopped go on, and models are compared by shots that were held out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import carom
import numpy as np
import pytest
from carom import learn
from carom.errors import InputError
from carom.learn import model_scores as module
from carom.learn.observation import observe
from carom.learn.tracks import TrackedBall, TrackedShot
from test_learn_table import three_cushion_shots

FEW: dict[str, Any] = {"physics": "carom", "free": ["rolling.a"], "starts": 8}
MODELS = [("restitution", "compliant"), ("han-2005", "compliant")]


@pytest.fixture(scope="module")
def film() -> learn.Tracks:
    return learn.synthetic(three_cushion_shots(6), clock_offset=0.3, seed=2).tracks


def test_a_fit_that_was_stopped_goes_on_to_the_same_bits(
    film: learn.Tracks, tmp_path: Path
) -> None:
    whole = learn.table(film, rounds=2, **FEW)
    learn.table(film, rounds=1, keep=tmp_path / "work.json", **FEW)
    resumed = learn.table(film, rounds=2, keep=tmp_path / "work.json", **FEW)
    assert resumed.to_json() == whole.to_json()


def test_the_work_of_another_fit_is_refused(film: learn.Tracks, tmp_path: Path) -> None:
    path = tmp_path / "work.json"
    learn.table(film[:3], rounds=1, keep=path, **FEW)
    with pytest.raises(InputError, match=r"work\.json.*other shots.*delete it"):
        learn.table(film[:4], rounds=1, keep=path, **FEW)
    with pytest.raises(InputError, match="other options"):
        learn.table(film[:3], rounds=1, keep=path, **FEW | {"starts": 9})
    path.write_text('{"results": 3')
    with pytest.raises(InputError, match="not the work of a fit"):
        learn.table(film[:3], rounds=1, keep=path, **FEW)


def test_the_model_that_made_a_film_has_the_best_score(
    film: learn.Tracks, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    how: dict[str, Any] = {"models": MODELS, "rounds": 1, **FEW, "keep": tmp_path / "models.json"}
    best, other = learn.compare_models(film, **how)
    assert best.model == "han-2005, compliant"
    assert best.standard_error == 0.0
    assert best.score - other.score > 2.0 * other.standard_error > 0.0

    def refuse(*_: Any, **__: Any) -> None:
        raise AssertionError("a model was fitted again")

    monkeypatch.setattr(module, "fit", refuse)
    assert learn.compare_models(film, **how) == [best, other]


SENSORS = carom.Noise(azimuth=2e-4, side_m=1e-4, height_m=1e-4, elevation=1e-3, speed=0.005)


def test_a_drill_that_ends_after_the_rail_compares_models_by_its_intentions() -> None:
    """Half a second of film is too short to tell a strike that is not known."""
    balls = {"1": (0.7, 0.7), "2": (0.4, 2.4), "3": (1.0, 2.5)}
    drill = carom.Shot("carom-10ft", balls, carom.Strike(2.5, 0.4, side=0.3, ball="1"))
    played = [SENSORS.variant(drill, index).with_until(0.6) for index in range(6)]
    drills = learn.synthetic(played, clock_offset=0.1, seed=4).tracks
    how: dict[str, Any] = {"models": MODELS, "rounds": 1, **FEW}
    unknown = learn.compare_models(drills, **how)
    assert [one.score for one in unknown] == pytest.approx([module._worst()] * 2)
    best, other = learn.compare_models(drills, intended=drill, noise=SENSORS, **how)
    assert best.model == "han-2005, compliant"
    assert best.score - other.score > 2.0 * other.standard_error > 0.0
    assert best.score > module._worst()


def test_shots_that_are_held_out_have_strikes_near_their_intentions(film: learn.Tracks) -> None:
    shots = dict(zip([shot.name for shot in film], three_cushion_shots(6), strict=True))
    turned = {name: shot.with_strike(azimuth_deg=-90.0) for name, shot in shots.items()}
    how: dict[str, Any] = {"models": MODELS[1:], "rounds": 1, "noise": SENSORS, **FEW}
    (right,) = learn.compare_models(film, intended=shots, **how)
    # Every second shot is held out of a fit to shots whose intentions are right.
    wrong = {name: turned[name] for name in list(turned)[::2]}
    (half,) = learn.compare_models(film, intended=shots | wrong, **how)
    assert half.score < right.score - 1.0


def test_intentions_of_a_comparison_are_checked_and_part_of_its_question(
    film: learn.Tracks, tmp_path: Path
) -> None:
    how: dict[str, Any] = {"models": MODELS[1:], "rounds": 1, **FEW}
    with pytest.raises(InputError, match="no shot is called 'ten'"):
        learn.compare_models(film, intended={"ten": three_cushion_shots(1)[0]}, **how)
    with pytest.raises(InputError, match="give intended too"):
        learn.compare_models(film, noise=SENSORS, **how)
    learn.compare_models(film[:4], keep=tmp_path / "models.json", **how)
    with pytest.raises(InputError, match="other options"):
        learn.compare_models(
            film[:4], intended=three_cushion_shots(1)[0], keep=tmp_path / "models.json", **how
        )


def test_every_model_of_the_engine_is_compared_by_default() -> None:
    base = module.TableModel("carom-10ft", "carom", (), 0.03075)
    pairs = module._usual(base)
    assert pairs[0] == ("han-2005", "compliant")
    assert len(pairs) == len(set(pairs)) == 5 + 4 - 1
    for rails, balls in pairs:
        physics = module._with_models(base.physics, rails, balls)
        layout, strike = {"1": (0.5, 0.5)}, {"ball": "1", "speed": 1.0, "azimuth": 0.0}
        shot = carom.Shot("carom-10ft", layout, strike, physics=physics)
        assert shot.to_dict()["physics"]["cushion"]["model"] == rails


def test_a_comparison_of_three_shots_is_refused(film: learn.Tracks) -> None:
    with pytest.raises(InputError, match="at least 4"):
        learn.compare_models(film[:3])


def moving(time: list[float], x: list[float]) -> TrackedBall:
    places = np.column_stack((x, np.full(len(x), 0.5)))
    return TrackedBall(time, places)


def test_a_ball_rests_until_it_moves_and_slows_down_evenly_to_rest() -> None:
    """It is stored when it has moved: at 2 m/s from 0.03 s on, and at rest from 1.5 s on."""
    time = [0.0, 0.04, 0.06, 0.08, 1.0, 1.2, 1.4, 3.0]
    x = [0.5, 0.52, 0.56, 0.60, 0.70, 0.72, 0.74, 0.745]
    seen = observe(TrackedShot("1", {"1": moving(time, x)}), rate=100.0)
    places = dict(zip(seen.time.round(3), seen.position["1"][:, 0], strict=True))
    assert places[0.02] == places[0.03] == 0.5
    assert places[0.04] == pytest.approx(0.52)
    # From 1.4 s on at 0.1 m/s: 5 mm to rest take 0.1 s, and half of the time three quarters of it.
    assert places[1.45] == pytest.approx(0.74375)
    assert places[1.5] == places[2.9] == pytest.approx(0.745)
