"""Pickles and copies of what carom returns, for processes and caches."""

from __future__ import annotations

import copy
import multiprocessing
import pickle
import threading
from typing import Any

import carom
import pytest
from carom import Noise, Perception, Player, Shot, Strike

SHOT = Shot("wpa-9ft", {"cue": (0.45, 0.75), "8": (0.8, 1.45), "9": (0.9, 1.9)}, Strike(1.8, 1.1))


def player() -> Player:
    return Player(
        "carom[shift=false]:60",
        noise=Noise.preset("club"),
        perception=Perception(0.001),
        rounds=2,
        seed=4,
        threads=1,
    )


def decided(of: Player) -> carom.Decision:
    return of.choose(SHOT, game="nine-ball")


@pytest.mark.parametrize(
    "copied", [lambda p: pickle.loads(pickle.dumps(p)), copy.copy, copy.deepcopy]
)
def test_a_copy_of_a_player_decides_the_same(copied: Any) -> None:
    own, twin = player(), copied(player())
    assert decided(own) == decided(twin)
    assert repr(own) == repr(twin)
    assert (own.name, own.noise) == (twin.name, twin.noise)


# Seen: "cannot pickle 'carom._core.Player' object", although a player is only settings.
def test_a_player_can_be_sent_to_another_process() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(decided, (player(),)) == decided(player())


def test_stopping_a_player_does_not_stop_its_copy() -> None:
    own = Player("carom", simulations=10**8, threads=1)
    twin = copy.copy(own)
    timer = threading.Timer(0.3, own.stop)
    timer.start()
    assert own.choose(SHOT, game="nine-ball").interrupted
    assert not decided(Player("carom:60", threads=1)).interrupted
    assert twin.noise == own.noise


def results() -> dict[str, Any]:
    frame = carom.Frame("nine-ball", seed=1)
    ruling = frame.play({"speed": 8.0, "azimuth_deg": 90.0}, cue_ball=(0.6, 0.5))
    trace = SHOT.simulate()
    return {
        "event": trace.events[1],
        "outcome": trace.outcome,
        "request": frame.request,
        "state": frame.state,
        "ruling": ruling,
        "ball": SHOT.balls[0],
        "strike": SHOT.strike,
        "table": SHOT.table,
        "physics": SHOT.physics,
        "call": carom.Call.pocket("9", "left"),
        "decision": decided(player()),
        "solution": SHOT.solve(pot="8", wanted=1, samples=64, n=8)[0],
        "evaluation": SHOT.evaluate(Noise.preset("club"), 8),
    }


def test_every_result_can_be_pickled_and_is_equal_and_of_its_class() -> None:
    for name, value in results().items():
        again = pickle.loads(pickle.dumps(value))
        assert type(again) is type(value), name
        assert repr(again) == repr(value), name


def test_an_analysis_keeps_its_plays_in_a_pickle() -> None:
    analysis = player().explain(SHOT, 2, game="nine-ball")
    assert str(pickle.loads(pickle.dumps(analysis))) == str(analysis)
