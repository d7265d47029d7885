"""Every example shot gives its golden bits in a release build, with one and two threads."""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import carom
import numpy as np
import pytest
from carom import Shot

ROOT = Path(__file__).parents[2]
GOLDENS = {
    name: (golden["events"], golden["hash"])
    for name, golden in json.loads((ROOT / "goldens" / "shots.json").read_text()).items()
}

GAMES = json.loads((ROOT / "goldens" / "games.json").read_text())
DECISIONS = json.loads((ROOT / "goldens" / "decisions.json").read_text())
LEARNED = json.loads((ROOT / "goldens" / "learned.json").read_text())


def test_every_example_shot_has_a_golden() -> None:
    assert GOLDENS.keys() == {path.stem for path in (ROOT / "shots").glob("*.json")}


@pytest.mark.parametrize("name", GOLDENS)
def test_events_and_final_states_have_their_golden_bits(name: str) -> None:
    trace = Shot.load(ROOT / "shots" / f"{name}.json").simulate()
    assert (len(trace), trace.hash) == GOLDENS[name]


@pytest.mark.parametrize("threads", [1, 2])
def test_a_batch_of_all_examples_has_the_same_bits_as_single_shots(threads: int) -> None:
    shots = [Shot.load(ROOT / "shots" / f"{name}.json") for name in GOLDENS]
    result = carom.simulate_batch(shots, threads=threads)
    assert result.errors == {}
    for index, (shot, (events, _)) in enumerate(zip(shots, GOLDENS.values(), strict=True)):
        final = np.array([ball["position"] for ball in shot.simulate().to_dict()["final"]])
        assert result.events[index] == events
        assert result.final_position[index, : len(final)].tobytes() == final.tobytes()


@pytest.fixture(scope="module")
def write_goldens() -> Iterator[ModuleType]:
    """The module scripts/write_goldens.py."""
    sys.path.insert(0, str(ROOT / "scripts"))
    yield importlib.import_module("write_goldens")
    sys.path.remove(str(ROOT / "scripts"))


@pytest.mark.parametrize("golden", DECISIONS)
def test_a_player_decides_and_recommends_as_its_golden(
    golden: dict[str, Any], write_goldens: ModuleType
) -> None:
    frame = carom.Frame.replay(golden["record"])
    row = write_goldens.decided(frame, golden["options"], golden.get("count"))
    assert json.loads(json.dumps(row)) == golden


@pytest.mark.parametrize("golden", LEARNED)
def test_chances_on_a_learned_table_are_those_of_their_golden(
    golden: dict[str, Any], write_goldens: ModuleType
) -> None:
    shot, learned = Shot.from_dict(golden["shot"]), golden["learned"]
    for asked in golden["evaluations"]:
        row = write_goldens.evaluated(shot, learned, asked["options"])
        assert json.loads(json.dumps(row)) == asked
        assert asked["result"]["tables"] > 1
    known = carom.plan.ListedTables.from_dict(learned)
    for asked in golden["decisions"]:
        frame = carom.Frame.replay(asked["record"])
        row = write_goldens.decided(frame, asked["options"], asked.get("count"), known)
        assert json.loads(json.dumps(row)) == asked


@pytest.mark.parametrize("golden", GAMES, ids=lambda golden: golden["game"])
def test_the_moves_of_a_game_have_their_golden_rulings(
    golden: dict[str, Any],
) -> None:
    frame = carom.Frame(golden["game"], seed=golden["seed"])
    for move in golden["moves"]:
        ruling = _answer(frame, move)
        if "hash" in move:
            assert ruling.trace is not None
            assert ruling.trace.hash == move["hash"]
        assert frame.hash == move["frame"]
        said = move["ruling"]
        assert [ruling.legal, ruling.racked] == [said["legal"], said["racked"]]
        assert [list(ruling.fouls), list(ruling.points)] == [said["fouls"], said["points"]]
        assert list(ruling.spotted) == said["spotted"]
    assert json.loads(json.dumps(frame.to_dict())) == golden["end"]


def test_the_hash_of_a_frame_is_that_of_its_copy_and_of_its_record() -> None:
    frame = carom.Frame("eight-ball", seed=5)
    before = frame.hash
    assert len(before) == 16
    twin = frame.copy()
    frame.play(carom.Strike(8.0, 1.57), cue_ball=(0.635, 0.6))
    assert frame.hash != before == twin.hash
    record = frame.record
    assert record["engine"] == frame.copy().record["engine"]
    assert carom.Frame.replay(record).hash == frame.hash
    # A bit more speed is another position.
    nudged = np.nextafter(8.0, 9.0)
    twin.play(carom.Strike(float(nudged), 1.57), cue_ball=(0.635, 0.6))
    assert twin.hash != frame.hash


def test_a_record_names_its_engine_and_an_older_one_is_readable() -> None:
    frame = carom.Frame("nine-ball", seed=2)
    record = frame.record
    assert record["engine"] == carom.break_shot("nine-ball").simulate().to_dict()["engine"]
    without = {key: value for key, value in record.items() if key != "engine"}
    assert carom.Frame.replay(without).hash == frame.hash
    moves = [{"choice": "play-on"}]
    with pytest.raises(
        carom.InputError, match=r"^moves\[0\]\.choice: .*made by carom 0\.0\.1, and this is"
    ):
        carom.Frame.replay({**record, "engine": "carom 0.0.1", "moves": moves})
    with pytest.raises(carom.InputError) as error:
        carom.Frame.replay({**record, "moves": moves})
    assert "made by" not in str(error.value)


def _answer(frame: carom.Frame, move: dict[str, Any]) -> carom.Ruling:
    if "choice" in move:
        return frame.choose(move["choice"])
    play = move["play"]
    call = carom.Call(**play["call"]) if "call" in play else None
    return frame.play(carom.Strike(**play["strike"]), cue_ball=play.get("cue_ball"), call=call)
