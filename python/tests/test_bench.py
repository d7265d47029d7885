"""`carom bench`: its states, its figures and the file that it writes."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import carom
import numpy as np
import pytest
from carom import bench
from carom.bench import peer, report, states, timing


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """A bench of two shots per class, once each, without a peer."""
    few = {name: members[:2] for name, members in states.load().items()}
    monkeypatch.setattr(states, "load", lambda: few)
    monkeypatch.setattr(timing, "ROUNDS", 1)
    monkeypatch.setattr(timing, "STRETCH", 1e-4)
    monkeypatch.setattr(timing, "IN_TURN", 1e-4)
    monkeypatch.setattr(timing, "VARIANTS", 100)
    monkeypatch.setattr(timing, "THREADED_SHOTS", 100)
    monkeypatch.setattr(timing, "IMPORTS", 1)
    monkeypatch.setattr(peer, "VERSION", "none")


def test_every_state_is_a_valid_shot_that_ends() -> None:
    classes = states.load()
    assert {name: len(members) for name, members in classes.items()} == {
        "pots": 240,
        "random_eight_ball": 400,
        "nine_ball_break": 30,
        "eight_ball_break": 30,
    }
    for members in classes.values():
        shots = [carom.Shot.from_dict(state.shot_file()) for state in members]
        result = carom.simulate_batch(shots)
        assert not result.errors
        # There is at least the strike, and an event that ends the motion.
        assert (result.events >= 2).all()


def test_every_pot_pockets_its_ball_alone() -> None:
    pots = states.load()["pots"]
    shots = [carom.Shot.from_dict(state.shot_file()) for state in pots]
    pocket = carom.simulate_batch(shots).pocket
    for state, shot, fallen in zip(pots, shots, pocket, strict=True):
        potted = [name for name, index in zip(shot.ids, fallen, strict=False) if index >= 0]
        assert potted == [state.pots]


def test_the_pots_are_of_all_kinds() -> None:
    pots = states.load()["pots"]
    met = [
        [
            event["balls"]
            for event in carom.Shot.from_dict(state.shot_file()).simulate().events
            if event["type"] == "ball-collision" or event.get("part") == "nose"
        ]
        for state in pots
    ]
    assert sum(met[0] == ["cue"] for met in met) >= 40
    assert sum(["cue", state.pots] in met for state, met in zip(pots, met, strict=True)) >= 120
    assert sum(any(len(balls) == 2 and "cue" not in balls for balls in met) for met in met) >= 40


def test_a_pot_that_misses_is_refused() -> None:
    state = states.load()["pots"][0]
    missed = dataclasses.replace(state, azimuth_deg=state.azimuth_deg + 20.0)
    with pytest.raises(RuntimeError, match=f"carom pockets .* where ball {state.pots} alone"):
        timing.time_class([missed], None, lambda: None)


class _MissingPeer:
    """A peer that pockets the cue ball in every shot."""

    version = "0"

    def simulate(self, _: states.State) -> tuple[float, None]:
        return 1e-3, None

    def events(self, _: None) -> int:
        return 1

    def pocketed(self, _: None) -> list[str]:
        return ["cue"]


def test_a_peer_that_pots_something_else_is_refused() -> None:
    pots = states.load()["pots"][:1]
    with pytest.raises(RuntimeError, match=r"pooltool 0 pockets cue where ball \d alone"):
        timing.time_class(pots, _MissingPeer(), lambda: None)  # type: ignore[arg-type]


def test_the_breaks_move_the_rack() -> None:
    for name in ("nine_ball_break", "eight_ball_break"):
        for state in states.load()[name]:
            shot = carom.Shot.from_dict(state.shot_file())
            result = carom.simulate_batch([shot])
            start = np.array(list(state.balls.values()))
            moved = np.linalg.norm(result.final_position[0, :, :2] - start, axis=1) > 0.01
            assert moved.sum() > len(shot.ids) / 2


@pytest.mark.usefixtures("quick")
def test_json_is_printed_and_stored_in_the_folder(
    capsys: pytest.CaptureFixture[str], tmp_path: object
) -> None:
    assert bench.run(json=True, store=tmp_path) == 0  # type: ignore[arg-type]
    printed = json.loads(capsys.readouterr().out)
    (stored,) = tmp_path.iterdir()  # type: ignore[attr-defined]
    assert json.loads(stored.read_text()) == printed
    assert printed["format"] == "carom-bench/1"
    assert printed["peer"] is None
    assert list(printed["classes"]) == list(states.CLASSES)
    for row in printed["classes"].values():
        assert row["median_us"] > 0
        assert row["ns_per_event"] * row["events_mean"] == pytest.approx(1000 * row["mean_us"])
    assert printed["shots_per_second"]["1"] > 0


def test_a_run_without_the_peer_leaves_the_stored_run_with_it(tmp_path: Path) -> None:
    where = report.where()
    beside = report.store(where | {"peer": "pooltool 0.6.0"}, tmp_path)
    alone = report.store(where | {"peer": None}, tmp_path)
    assert json.loads(beside.read_text())["peer"] == "pooltool 0.6.0"
    assert json.loads(alone.read_text())["peer"] is None


@pytest.mark.usefixtures("quick")
def test_without_the_peer_a_message_says_how_to_install_it(
    capsys: pytest.CaptureFixture[str], tmp_path: object
) -> None:
    assert bench.run(store=tmp_path) == 0  # type: ignore[arg-type]
    told = capsys.readouterr()
    assert "make bench-peer" in told.err or "0.6.0" in told.err
    assert "eight-ball break" in told.out


def test_ratios_are_the_peers_time_over_ours() -> None:
    times = timing.ClassTimes(
        ours=[1e-6, 2e-6, 3e-6],
        traced=[2e-6, 4e-6, 6e-6],
        events=[10, 10, 10],
        mixed=4e-6,
        peer=[1e-3, 4e-3, 9e-3],
        peer_mixed=6e-3,
        peer_events=[10, 20, 10],
        same_pocketed=[True, False, True],
    )
    row = report.summary(times)
    assert row["median_us"] == pytest.approx(2)
    assert row["ns_per_event"] == pytest.approx(200)
    assert row["trace_ratio"] == pytest.approx(2)
    assert row["ratio_of_medians"] == pytest.approx(2000)
    assert row["ratio_of_mixed_means"] == pytest.approx(1500)
    assert row["ratio_per_event"] == pytest.approx(350e-6 / 200e-9)
