"""A table that is learned from films whose strikes are known apart from them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import carom
import numpy as np
import pytest
from carom import InputError, Noise, learn
from carom.learn.intended_strikes import intended_strikes
from carom.learn.observation import observe
from carom.learn.strike_search import StrikeProblem
from carom.learn.table_model import TableModel

if TYPE_CHECKING:
    from conftest import CommandLine

LAYOUT = {"1": (0.5, 0.6), "2": (0.9, 2.2), "3": (0.3, 1.8)}
SENSORS = Noise(azimuth=2e-4, elevation=2e-4, side_m=1e-4, height_m=1e-4, speed_relative=2e-3)
FREE = ["rolling.a", "cushion.restitution.a", "cushion.friction.a"]


@pytest.fixture(scope="module")
def played() -> list[carom.Shot]:
    """Shots on a table that differs from the preset by two steps of every number."""
    model = TableModel("carom-10ft", None, FREE)
    table, physics, _ = model.parts(model.start + 2 * model.steps * np.array((1, -1, 1)))
    strikes = [
        carom.Strike(speed, np.radians(angle), side=side, ball="1")
        for speed, angle, side in (
            (2.0, 50, 0.2),
            (2.5, 130, -0.1),
            (1.6, 250, 0.0),
            (3.0, 20, 0.3),
        )
    ]
    return [carom.Shot(table, LAYOUT, strike, physics=physics) for strike in strikes]


@pytest.fixture(scope="module")
def film(played: list[carom.Shot]) -> learn.Tracks:
    tracks = learn.synthetic(played, clock_offset=0.3, seed=1).tracks
    return learn.Tracks(learn.TracksHeader(table="carom-10ft"), tuple(tracks))


def test_known_strikes_tell_the_table_from_few_shots_and_starts(
    played: list[carom.Shot], film: learn.Tracks
) -> None:
    known = {str(k + 1): shot for k, shot in enumerate(played)}
    found = learn.table(film, free=FREE, intended=known, noise=SENSORS, rounds=3, starts=2)
    start, steps = found.model.start, found.model.steps
    away = (found.mean - start) / steps
    assert found.shots == 4
    assert away == pytest.approx([2, -2, 2], abs=0.3)


def test_strikes_are_found_near_the_intended_ones(
    played: list[carom.Shot], film: learn.Tracks
) -> None:
    known = {str(k + 1): shot for k, shot in enumerate(played)}
    table, physics = played[0].to_dict()["table"], played[0].to_dict()["physics"]
    found = learn.strikes(
        film, table=table, physics=physics, intended=known, noise=SENSORS, starts=4
    )
    for strike, shot in zip(found, played, strict=True):
        assert strike.shot.azimuth == pytest.approx(shot.azimuth, abs=5 * SENSORS.azimuth)
        assert strike.shot.side == pytest.approx(shot.side, abs=0.02)
        assert strike.rmse < 0.005


def test_the_command_reads_intended_strikes_from_a_folder(
    played: list[carom.Shot],
    film: learn.Tracks,
    run: CommandLine,
    tmp_path: Path,
) -> None:
    tracks, folder, noise = tmp_path / "film.csv", tmp_path / "known", tmp_path / "sensors.json"
    learn.write_tracks(film, tracks)
    folder.mkdir()
    for k, shot in enumerate(played):
        shot.save(folder / f"{k + 1}.json")
    noise.write_text(json.dumps(SENSORS.to_dict()))
    known = ["--intended", str(folder), "--noise", str(noise)]
    how = ["--starts", "4", "--rounds", "2", *(word for key in FREE for word in ("--free", key))]
    learned = tmp_path / "learned.json"
    assert run("learn", "table", str(tracks), "-o", str(learned), *known, *how).returncode == 0
    out = tmp_path / "strikes"
    words = ["--learned", str(learned), "-o", str(out), "--starts", "4", *known]
    assert run("learn", "strikes", str(tracks), *words).returncode == 0
    for k, shot in enumerate(played):
        replay = carom.Shot.load(out / f"{k + 1:04}.json")
        assert replay.azimuth == pytest.approx(shot.azimuth, abs=5 * SENSORS.azimuth)
    (folder / "9.json").write_text((folder / "1.json").read_text())
    done = run("learn", "strikes", str(tracks), *words)
    assert done.returncode == 2
    assert "intended: no shot is called '9'" in done.stderr


def test_a_search_begins_at_the_intended_strike_and_near_it(
    played: list[carom.Shot], film: learn.Tracks
) -> None:
    for noise, largest in ((SENSORS, 1e-3), (None, 0.05)):
        meant = intended_strikes(film, played[0], noise)
        assert len(meant) == 4
        problem = StrikeProblem(observe(film[0]), played[0], learn.Frame(), intended=meant[0])
        starts = problem.starts(50, np.random.default_rng(0))
        first = starts[0, :5].tolist()
        shot = played[0]
        assert first == [shot.azimuth, shot.speed, shot.side, shot.height, shot.elevation]
        scatter = starts[1:, 0].std()
        assert largest / 20 < scatter < largest


def test_a_strike_far_from_the_intended_one_costs_more(
    played: list[carom.Shot], film: learn.Tracks
) -> None:
    shot = played[0]
    (meant, *_) = intended_strikes(film, shot, SENSORS)
    assert meant is not None
    assert meant.sigma == pytest.approx(
        [2e-4, 4e-3, 1e-4 / 0.03075, 1e-4 / 0.03075, 2e-4], rel=1e-2
    )
    blind, known = (
        StrikeProblem(observe(film[0]), shot, learn.Frame(), intended=each)
        for each in (None, meant)
    )
    strikes = known.starts(2, np.random.default_rng(0))
    strikes[1] = strikes[0] + [4e-4, 0, 0, 0, 0, 0]
    with_it, without = (p.residuals(1.5)(strikes) for p in (known, blind))
    more = (with_it**2).sum(axis=1) - (without**2).sum(axis=1)
    # Two standard deviations are two errors of 4 mm in one coordinate.
    assert more == pytest.approx([0, 0.008**2], abs=1e-9)


def test_bad_intentions_are_refused_by_name(played: list[carom.Shot], film: learn.Tracks) -> None:
    still = carom.Shot("carom-10ft", LAYOUT)
    for intended, noise, message in (
        (None, SENSORS, "noise: there is no strike that it belongs to"),
        ({"9": played[0]}, None, "intended: no shot is called '9'"),
        ({"1": still}, None, "intended: the shot has no strike"),
        ({"1": "drill.json"}, None, "intended: found a str"),
        (played[0], 0.01, "noise: found a float"),
    ):
        with pytest.raises(InputError, match=message):
            learn.table(film, intended=intended, noise=noise)  # type: ignore[arg-type]
