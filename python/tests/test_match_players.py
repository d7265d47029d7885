"""Players of one's own in matches: objects with `choose(situation)`."""

from __future__ import annotations

import json
import pickle
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import carom
import pytest
from carom import InputError, Noise, Perception

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

SECRET = "cd" * 32
# Frames of a second; 50 simulated shots are the clock of players without a number of their own.
SHORT: dict[str, Any] = {
    "game": "nine-ball",
    "pairs": 1,
    "secret": SECRET,
    "patience": 10,
    "simulations": 50,
}
OTHER = "greedy:40"


class Drawing:
    """Ten lines: a strike in a drawn direction."""

    def choose(self, situation: carom.Situation) -> Any:
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        azimuth = random.Random(situation.seed).uniform(0, 6.28)
        cue_ball = (0.635, 0.5) if request.in_hand else None
        return carom.Play(carom.Strike(3.0, azimuth), cue_ball=cue_ball)


class Telling(Drawing):
    """Keeps the situations in a list, which copies share, and gives the listed answers first."""

    def __init__(self, seen: list[carom.Situation], answers: tuple[Any, ...] = ()) -> None:
        self.seen, self.answers = seen, list(answers)

    def __deepcopy__(self, _: dict[int, Any]) -> Telling:
        return Telling(self.seen, tuple(self.answers))

    def choose(self, situation: carom.Situation) -> Any:
        self.seen.append(situation)
        return self.answers.pop(0) if self.answers else super().choose(situation)


class Failing:
    name = "unlucky"

    def choose(self, _: carom.Situation) -> Any:
        return {}["strike"]


def lines_of(result: carom.MatchResult) -> list[dict[str, Any]]:
    assert result.record is not None
    return [json.loads(line) for line in result.record.read_text().splitlines()]


def test_a_player_of_ten_lines_plays_a_level_and_the_record_replays(tmp_path: Path) -> None:
    result = carom.play_match(Drawing(), "level-1", out=tmp_path / "m", **SHORT)
    assert result.finished
    assert result.score.players == ("Drawing", "level-1")
    header, one, other, _ = lines_of(result)
    assert header["players"][0] == {"name": "Drawing", "settings": {"python": "Drawing"}}
    assert any(move["seat"] == 0 and "executed" in move for move in one["moves"])
    assert one["seats"] == [0, 1]
    assert other["seats"] == [1, 0]
    assert result.record is not None
    found = carom.replay_match(result.record.read_text())
    assert found.difference is None
    assert found.score == result.score


def make_drawing() -> Drawing:
    return Drawing()


def test_an_object_a_class_and_a_function_are_the_same_player_on_any_number_of_threads(
    tmp_path: Path,
) -> None:
    records = []
    for index, (player, threads) in enumerate(
        [(Drawing(), 1), (Drawing, 2), (make_drawing, 2), (Drawing(), None)]
    ):
        settings = {**SHORT, "pairs": 3, "threads": threads}
        result = carom.play_match(player, OTHER, out=tmp_path / str(index), **settings)
        assert result.record is not None
        records.append(result.record.read_bytes())
    assert len(set(records)) == 1


def test_a_frame_does_not_depend_on_the_frames_before_it(tmp_path: Path) -> None:
    class Counting:
        def __init__(self) -> None:
            self.asked = 0

        def choose(self, _: carom.Situation) -> Any:
            self.asked += 1
            return carom.Decision(win_chance=0.25, simulations=self.asked)

    player = Counting()
    result = carom.play_match(player, OTHER, out=tmp_path / "m", **{**SHORT, "breaker": 0})
    for frame in lines_of(result)[1:3]:
        assert frame["end"]["reason"] == "conceded"
        assert frame["moves"][-1]["win_chance"] == 0.25
        assert frame["moves"][-1]["cost"] == {"simulations": 1, "rounds": 0}
    assert player.asked == 0


def test_a_built_in_player_may_be_given_as_an_object(tmp_path: Path) -> None:
    player = carom.Player("carom:60", noise=Noise.preset("club"))
    result = carom.play_match(player, OTHER, out=tmp_path / "m", **SHORT)
    header, *frames, _ = lines_of(result)
    assert header["noise"][0]["speed"] == Noise.preset("club").speed
    costs = [move["cost"] for frame in frames for move in frame["moves"]]
    assert any(cost["simulations"] > 0 for cost in costs)


# What a player sees.


def test_a_player_sees_its_frame_its_noise_and_its_clock(tmp_path: Path) -> None:
    noises = (Noise.preset("club"), Noise.preset("professional"))
    for disclosure, own, other in [
        ("both", noises[0], noises[1]),
        ("own", noises[0], Noise()),
        ("nothing", Noise(), Noise()),
    ]:
        seen: list[carom.Situation] = []
        carom.play_match(
            Telling(seen),
            OTHER,
            out=tmp_path / disclosure,
            **{**SHORT, "noise": noises, "disclosure": disclosure},
            perception=Perception(0.001),
        )
        assert {(s.noise, s.opponent_noise) for s in seen} == {(own, other)}
        told = Perception() if disclosure == "nothing" else Perception(0.001)
        assert {s.perception.position for s in seen} == {told.position}
        assert {(s.clock, s.simulations, s.budget) for s in seen} == {(None, 50, 50.0)}
        assert {s.player for s in seen} == {0, 1}
        assert all(s.frame.player == s.player for s in seen)
        assert len({s.seed for s in seen}) == len(seen)


def test_the_clock_of_a_frame_runs_down(tmp_path: Path) -> None:
    seen: list[carom.Situation] = []
    settings = {key: value for key, value in SHORT.items() if key != "simulations"}
    carom.play_match(Telling(seen), OTHER, out=tmp_path / "m", clock=500.0, breaker=0, **settings)
    clocks = [s.clock for s in seen if s.clock is not None]
    assert len(clocks) == len(seen)
    assert clocks[0] == 500.0
    assert all(s.budget is not None and 0 < s.budget < 500 and s.simulations is None for s in seen)
    ends = [later > sooner for sooner, later in pairwise(clocks)]
    assert sum(ends) == 1, "the clock is full again in the second frame, and else it runs down"


def test_a_player_can_read_no_seed(tmp_path: Path) -> None:
    """Three-cushion starts at the same places, so only the seed can differ."""
    first = []
    for secret in ("11" * 32, "22" * 32):
        seen: list[carom.Situation] = []
        settings = {**SHORT, "game": "three-cushion", "points": 1, "secret": secret}
        result = carom.play_match(Telling(seen), OTHER, out=tmp_path / secret[:2], **settings)
        situation = seen[0]
        first.append(situation.frame.hash)
        with pytest.raises(InputError, match="copy for a player"):
            _ = situation.frame.record
        with pytest.raises(InputError, match="copy for a player"):
            pickle.dumps(situation.frame)
        with pytest.raises(InputError, match="copy for a player"):
            pickle.dumps(situation)
        shown = json.dumps(situation.frame.to_dict()) + repr(situation.frame)
        seeds = lines_of(result)[1]["seeds"]
        for seed in (seeds["rack"], *seeds["errors"], *seeds["sight"]):
            assert seed not in shown
            assert str(int(seed, 16)) not in shown
            assert situation.seed != int(seed, 16)
    assert first[0] == first[1]
    hashes = {carom.Frame("three-cushion", seed=seed, points=1).hash for seed in (1, 2)}
    assert len(hashes) == 2, "the hash of a whole frame covers its seed"


# Answers.


def plain(strike: dict[str, float], **rest: Any) -> dict[str, Any]:
    return {"play": {"strike": strike, **rest}}


FULL = {"speed": 8.0, "azimuth_deg": 90.0}


def test_plain_answers_are_taken(tmp_path: Path) -> None:
    seen: list[carom.Situation] = []
    answers = (plain(FULL, cue_ball=[0.635, 0.5]), {"concede": True})
    player = Telling(seen, answers)
    result = carom.play_match(player, OTHER, out=tmp_path / "m", **SHORT)
    first = lines_of(result)[1]["moves"][0]
    assert first["play"]["strike"]["speed"] == 8.0
    assert first["play"]["cue_ball"] == [0.635, 0.5]
    assert "executed" in first
    assert all(situation.refused is None for situation in seen)
    assert result.score.reasons["conceded"] >= 1


@pytest.mark.parametrize(
    ("answer", "place"),
    [
        (7, "answer"),
        (None, "answer"),
        ("sing", "choice"),
        ("play-on", "choice"),
        ("\ud800", "choice"),
        ({"\ud800": 1}, "answer"),
        ({1: 1}, "answer"),
        ({"plai": 1}, "answer.plai"),
        (plain({"speed": 1.0}), "strike.azimuth"),
        (plain(FULL, cue_ball=[9.0, 9.0]), "cue_ball"),
        (plain({**FULL, "side": 0.9}, cue_ball=[0.635, 0.5]), "strike.side"),
        (carom.Play(carom.Strike(float("nan"), 1.0), (0.635, 0.5)), "strike.speed"),
        (carom.Decision(choice="play-on"), "choice"),
        (carom.Decision(win_chance="high"), "win_chance"),
    ],
)
def test_a_refused_answer_is_explained_in_the_next_situation(
    answer: Any, place: str, tmp_path: Path
) -> None:
    seen: list[carom.Situation] = []
    player = Telling(seen, (answer, answer))
    result = carom.play_match(player, OTHER, out=tmp_path / "m", **{**SHORT, "breaker": 0})
    assert seen[0].refused is None
    for situation in seen[1:3]:
        assert situation.refused is not None
        assert situation.refused.place.startswith(place), situation.refused
        assert situation.refused.fault
        assert situation.refused.remedy
    assert seen[3].refused is None
    moves = lines_of(result)[1]["moves"]
    assert seen[1].refused is not None
    assert moves[0]["refused"]["what"] == seen[1].refused.fault
    assert "executed" in moves[2]
    assert result.record is not None
    assert carom.replay_match(result.record.read_text()).difference is None


def test_the_eleventh_refused_answer_loses_the_frame(tmp_path: Path) -> None:
    result = carom.play_match(
        Telling([], (7,) * 11), OTHER, out=tmp_path / "m", **{**SHORT, "breaker": 0}
    )
    assert result.score.reasons == {"refusals": 2}
    assert result.score.losses == 2
    assert len(lines_of(result)[1]["moves"]) == 11


def test_an_answer_after_the_end_of_the_clock_loses_the_frame(tmp_path: Path) -> None:
    class Late(Drawing):
        def choose(self, situation: carom.Situation) -> Any:
            time.sleep(0.02)
            return super().choose(situation)

    settings = {key: value for key, value in SHORT.items() if key != "simulations"}
    result = carom.play_match(Late(), OTHER, out=tmp_path / "m", clock=0.001, breaker=0, **settings)
    assert result.score.reasons == {"time-over": 2}
    assert lines_of(result)[1]["moves"][0]["late"] is True


# Exceptions.


@pytest.mark.parametrize("threads", [1, 2])
def test_an_exception_loses_the_frame_and_its_traceback_is_in_the_log(
    threads: int, tmp_path: Path
) -> None:
    settings = {**SHORT, "breaker": 0, "pairs": 2, "threads": threads}
    result = carom.play_match(Failing, OTHER, out=tmp_path / "m", **settings)
    assert result.score.reasons == {"crash": 4}
    assert result.score.losses == 4
    end = lines_of(result)[1]["end"]
    assert end["why"] == "KeyError: 'strike'"
    log = (tmp_path / "m" / "errors.log").read_text()
    for frame in range(4):
        assert f"frame {frame}, player unlucky at seat 0:\nTraceback" in log
    assert log.count('return {}["strike"]') == 4
    assert result.record is not None
    assert carom.replay_match(result.record.read_text()).difference is None


def test_the_exit_of_a_player_is_not_the_end_of_the_match(tmp_path: Path) -> None:
    class Leaving:
        def choose(self, _: carom.Situation) -> Any:
            sys.exit(3)

    result = carom.play_match(Leaving(), OTHER, out=tmp_path / "m", **{**SHORT, "breaker": 0})
    assert result.score.reasons == {"crash": 2}


def test_an_answer_that_fails_when_it_is_read_loses_the_frame(tmp_path: Path) -> None:
    class Number:
        def __float__(self) -> float:
            raise OSError("no number today")

    class Returning:
        def choose(self, _: carom.Situation) -> Any:
            return carom.Decision(win_chance=Number())

    result = carom.play_match(Returning(), OTHER, out=tmp_path / "m", **{**SHORT, "breaker": 0})
    assert result.score.reasons == {"crash": 2}
    assert "no number today" in (tmp_path / "m" / "errors.log").read_text()


@pytest.mark.parametrize("threads", [1, 2])
def test_with_strict_an_exception_stops_the_match_which_can_go_on(
    threads: int, tmp_path: Path
) -> None:
    settings = {**SHORT, "pairs": 4, "threads": threads}
    with pytest.raises(KeyError) as caught:
        carom.play_match(Failing(), OTHER, out=tmp_path / "m", strict=True, **settings)
    assert "player unlucky at seat" in "".join(caught.value.__notes__)
    assert caught.traceback[-1].name == "choose"
    assert not (tmp_path / "m" / "errors.log").exists()
    assert not (tmp_path / "m" / "match.jsonl").exists()
    assert carom.play_match(Failing(), OTHER, out=tmp_path / "m", **settings).finished


class Locked(Drawing):
    """An object that cannot be copied."""

    def __init__(self) -> None:
        self.lock = threading.Lock()


class Nameless(Drawing):
    name = ""


@pytest.mark.parametrize(
    ("player", "message"),
    [
        (5, r"^one: found a int; give the name of a player"),
        (object, r"^one: the class object has no method choose; write one"),
        (dict, r"^one: the class dict has no method choose"),
        (lambda: 5, r"^one: int has no method choose"),
        (
            Locked(),
            r"^one: the player cannot be copied for a frame \(TypeError: .*; give its class",
        ),
        (Nameless(), r"^one\.name: '' is not a name; write 1 to 80"),
    ],
)
def test_what_is_no_player_is_refused_before_the_first_frame(
    player: Any, message: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=message):
        carom.play_match(player, OTHER, out=tmp_path / "m", **SHORT)
    assert not (tmp_path / "m").exists()
    assert carom.play_match(Locked, OTHER, out=tmp_path / "m", **SHORT).finished


# Ctrl-C.

STUCK = """
import os, signal, time
import carom
# A shell in the background lets its children ignore the interrupt.
signal.signal(signal.SIGINT, signal.default_int_handler)

class Stuck:
    def choose(self, situation):
        os.write(1, b"choosing\\n")  # one line in one piece, also on two threads
        WAIT

try:
    carom.play_match(Stuck, Stuck, out="m", game="nine-ball", pairs=4, threads=THREADS)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.parametrize(
    ("wait", "threads"),
    [
        ("while True: pass", 1),
        ("time.sleep(1000)", 1),
        ("while True: pass", 2),
        ("return carom.Player(time=100.0).choose(situation.frame)", 1),
        ("return carom.Player(time=100.0).choose(situation.frame).play", 1),
        ("try: time.sleep(1000)\n        except: return 5", 1),
    ],
)
def test_ctrl_c_ends_a_match_while_a_player_chooses(
    wait: str, threads: int, tmp_path: Path
) -> None:
    program = STUCK.replace("WAIT", wait).replace("THREADS", str(threads))
    with subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=tmp_path,
    ) as process:
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(threads)]
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        try:
            out, error = process.communicate(timeout=60)
        finally:
            process.kill()
    assert lines == ["choosing\n"] * threads, error
    assert out.endswith("interrupted\n"), error
    assert not (tmp_path / "m" / "match.jsonl").exists()


# The command line.

FILE = """
import carom
from helper import CHOICE

class Mine:
    def choose(self, situation):
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[CHOICE]
        cue_ball = (0.635, 0.5) if request.in_hand else None
        return carom.Play(carom.Strike(3.0, 1.2), cue_ball=cue_ball)

class Failing:
    def choose(self, situation):
        return 1 / 0

class Chooseless:
    pass

def make():
    return Mine()

NUMBER = 5
"""
FLAGS = ["--game", "nine-ball", "--pairs", "1", "--secret", SECRET, "--simulations", "50"]


@pytest.fixture
def folder(run: CommandLine) -> Callable[..., Any]:
    """Runs `carom match` where `mine.py` is."""
    (run.cwd / "mine.py").write_text(FILE)
    (run.cwd / "helper.py").write_text("CHOICE = 0\n")
    (run.cwd / "broken.py").write_text("1 / 0\n")
    return lambda *words: run("match", *words, *FLAGS, "--out", "m")


@pytest.mark.parametrize("name", ["Mine", "make"])
def test_a_file_and_a_name_are_a_player(folder: Any, run: CommandLine, name: str) -> None:
    done = folder(f"mine.py:{name}", OTHER)
    assert (done.returncode, done.stderr) == (0, "")
    assert "  Mine " in done.stdout
    done = run("match", "--replay", "m/match.jsonl")
    assert done.stdout.startswith("reproduced bit by bit: 2 frames\n"), done.stderr


@pytest.mark.parametrize(
    ("word", "message"),
    [
        ("none.py:Mine", "one: there is no file none.py; check the path"),
        ("mine.py", "one: mine.py names no class; write mine.py:NAME"),
        ("mine.py:Min", "one: mine.py has no 'Min'; write one of Mine, Failing"),
        ("mine.py:NUMBER", "one: NUMBER in mine.py is a int; write a class with a method choose"),
        ("mine.py:Chooseless", "one: the class Chooseless has no method choose; write one: def"),
        ("broken.py:Mine", "one: broken.py does not run (ZeroDivisionError: division by zero);"),
    ],
)
def test_a_file_without_such_a_player_is_refused(folder: Any, word: str, message: str) -> None:
    done = folder(word, OTHER)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"carom: {message}"), done.stderr
    assert len(done.stderr.strip().splitlines()) == 1


def test_strict_stops_at_the_exception_of_a_player(folder: Any) -> None:
    done = folder("mine.py:Failing", OTHER, "--strict")
    assert (done.returncode, done.stdout) == (2, "")
    assert "return 1 / 0" in done.stderr
    assert done.stderr.splitlines()[-1].startswith("carom: a player raised this exception")
    done = folder("mine.py:Failing", OTHER)
    assert done.returncode == 0
    assert "crash" in done.stdout
