"""Matches between players: `carom.play_match`, `carom match`, their records."""

from __future__ import annotations

import inspect
import json
import math
import signal
import subprocess
import sys
import time
from dataclasses import FrozenInstanceError
from typing import TYPE_CHECKING, Any

import carom
import pytest
from carom import InputError, Noise, Perception, Play, Strike
from carom.arena import SequentialTest

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

SECRET = "ab" * 32
# Matches of a second: two pairs of nine-ball between players that hardly search.
SHORT: dict[str, Any] = {"game": "nine-ball", "pairs": 2, "secret": SECRET}
FLAGS = ["--game", "nine-ball", "--pairs", "2", "--secret", SECRET]


def refused(place: str, call: Any) -> None:
    with pytest.raises(InputError) as caught:
        call()
    assert str(caught.value).startswith(f"{place}: "), caught.value
    assert ";" in str(caught.value), "and the remedy"


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> carom.MatchResult:
    """A finished match."""
    out = tmp_path_factory.mktemp("match")
    return carom.play_match("carom:60", "carom:300", out=out, **SHORT)


def header_of(result: carom.MatchResult) -> dict[str, Any]:
    assert result.record is not None
    header: dict[str, Any] = json.loads(result.record.read_text().splitlines()[0])
    return header


def test_a_match_counts_the_frames_of_all_pairs(played: carom.MatchResult) -> None:
    score = played.score
    assert played.finished
    assert played.played_pairs == 2
    assert score.wins + score.draws + score.losses + score.void == 4
    assert sum(score.reasons.values()) == 4
    points = sum(half * count for half, count in enumerate(score.pair_counts)) / 2
    assert points == score.wins + 0.5 * score.draws
    assert score.share == points / (2 * score.pairs)
    low, high = score.share_interval
    assert 0 <= low <= score.share <= high <= 1
    assert score.win_share.count == score.wins
    with pytest.raises(FrozenInstanceError):
        score.wins = 9  # type: ignore[misc]


def test_a_match_prints_both_players_and_its_record(played: carom.MatchResult) -> None:
    said = str(played)
    assert said.startswith("nine-ball: 2 pairs of frames, finished\n")
    for word in ("carom:60", "carom:300", "Elo difference", played.secret_sha256):
        assert word in said
    assert said.endswith(f"record: {played.record}")


def test_a_match_is_plain_values(played: carom.MatchResult) -> None:
    written = json.loads(json.dumps(played.to_dict(), allow_nan=False))
    assert written["players"] == ["carom:60", "carom:300"]
    assert written["record"] == str(played.record)


def test_the_record_does_not_depend_on_the_number_of_threads(
    played: carom.MatchResult, tmp_path: Path
) -> None:
    again = carom.play_match("carom:60", "carom:300", out=tmp_path / "m", threads=1, **SHORT)
    assert again.record is not None
    assert played.record is not None
    assert again.record.read_bytes() == played.record.read_bytes()
    assert again.score == played.score


def test_a_finished_match_is_not_played_again(played: carom.MatchResult) -> None:
    assert played.record is not None
    before = played.record.stat().st_mtime_ns
    again = carom.play_match("carom:60", "carom:300", out=played.record.parent, **SHORT)
    assert again == played
    assert played.record.stat().st_mtime_ns == before


def test_a_record_replays_to_the_bit(played: carom.MatchResult) -> None:
    assert played.record is not None
    text = played.record.read_text()
    found = carom.replay_match(text)
    assert found.difference is None
    assert found.frames == 4
    assert found.score == played.score
    assert not found.other_engine
    key = '"executed": {"strike": {"speed": '
    changed = text.replace(key, f"{key}1", 1)
    assert changed != text
    difference = carom.replay_match(changed).difference
    assert difference is not None
    assert (difference["line"], difference["key"]) == (2, "moves[0].executed.strike.speed")
    refused("line 7", lambda: carom.replay_match(text + "{}"))


def test_the_settings_of_a_match_are_in_its_record(tmp_path: Path) -> None:
    the_break = Play(Strike(speed=8.0, azimuth=1.57, elevation=0.06), cue_ball=(0.495, 0.4))
    result = carom.play_match(
        "carom",
        "carom:40",
        out=tmp_path / "m",
        game="nine-ball",
        pairs=1,
        noise=(Noise.preset("club"), Noise.preset("professional")),
        perception=Perception(0.001),
        table="bar-7ft",
        simulations=50,
        breaker=1,
        same_break=the_break,
        disclosure="own",
        patience=30,
    )
    header = header_of(result)
    assert [noise["speed"] for noise in header["noise"]] == [0.15, 0.06]
    assert [sight["position"] for sight in header["perception"]] == [0.001, 0.001]
    assert [clock["simulations"] for clock in header["clock"]] == [50, 40]
    assert header["table"].startswith("bar-7ft")
    assert (header["breaker"], header["disclosure"]) == (1, "own")
    assert header["same_break"]["cue_ball"] == [0.495, 0.4]
    assert header["options"]["patience"] == 30
    assert header["test"] is None


def test_clocks_of_time_are_in_the_record(tmp_path: Path) -> None:
    for name, period in (("time", "decision"), ("clock", "frame")):
        result = carom.play_match(
            "carom", "carom:40", out=tmp_path / name, game="nine-ball", pairs=1, **{name: 0.001}
        )
        first, other = header_of(result)["clock"]
        assert first == {"seconds": 0.001, "per": period}
        assert other == {"simulations": 40, "per": "decision"}
    # The player without time loses both frames, at its first shot unless the other wins before.
    assert result.score.losses == 2
    assert set(result.score.reasons) <= {"time-over", "won"}


def test_simulated_shots_of_a_frame_are_a_clock(tmp_path: Path) -> None:
    result = carom.play_match(
        "carom", "carom:40", out=tmp_path / "m", game="nine-ball", pairs=1, frame_simulations=500
    )
    header = header_of(result)
    assert header["clock"][0] == {"simulations": 500, "per": "frame"}
    assert header["clock"][1] == {"simulations": 40, "per": "decision"}


def test_settings_of_a_player_stand_in_its_name(tmp_path: Path) -> None:
    name = "carom[shift=false,value=markov]:40"
    result = carom.play_match(name, "carom:40", out=tmp_path / "m", game="nine-ball", pairs=1)
    entry = header_of(result)["players"][0]
    assert entry["name"] == name
    assert len(entry["settings"].pop("decisions")) == 16
    assert entry["settings"] == {"player": "carom", "settings": {"shift": False, "value": "markov"}}


def test_a_player_may_break_from_the_middle(tmp_path: Path) -> None:
    result = carom.play_match(
        "carom[break=center]:3000", "carom:40", out=tmp_path / "m", game="nine-ball", pairs=1
    )
    assert result.record is not None
    frames = [json.loads(line) for line in result.record.read_text().splitlines()[1:3]]
    first = next(frame for frame in frames if frame["seats"][0] == 0)["moves"][0]["play"]
    assert first["strike"]["speed"] == 8.0
    assert first["cue_ball"][0] == pytest.approx(0.635)
    assert (first["strike"]["side"], first["strike"]["height"]) == (0.0, 0.0)


def test_a_test_ends_a_match_that_is_decided(tmp_path: Path) -> None:
    # A player whose time is over at once loses every frame.
    result = carom.play_match(
        "carom:40",
        "carom",
        out=tmp_path / "m",
        game="nine-ball",
        pairs=100,
        clock=1e-9,
        test=(0.4, 0.9),
    )
    assert result.test is not None
    assert result.test.accepted == "p1"
    assert result.test.llr >= result.test.upper
    assert result.score.share == 1.0
    assert result.score.elo == float("inf")
    assert result.to_dict()["elo"] is None
    assert 2 <= result.played_pairs < 20
    assert "test of 0.4 against 0.9: accepts 0.9" in str(result)


def test_a_test_of_normalised_elo_ends_a_match(run: CommandLine, tmp_path: Path) -> None:
    result = carom.play_match(
        *("carom:40", "carom"),
        out=tmp_path / "m",
        game="nine-ball",
        pairs=100,
        clock=1e-9,
        test=SequentialTest(0, 100, "nelo"),
    )
    assert result.test is not None
    assert (result.test.accepted, result.test.unit) == ("p1", "nelo")
    assert result.to_dict()["test"]["unit"] == "nelo"
    assert "test of 0 against 100 normalised Elo: accepts 100" in str(result)
    assert f"normalised {result.score.nelo:+.0f} (" in str(result)
    done = run(
        *("match", "carom:40", "carom", "--game", "nine-ball", "--clock", "1e-9"),
        *("--pairs", "100", "--test", "nelo:0,100", "--out", "n", "--json"),
    )
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert (found["test"]["p1"], found["test"]["accepted"]) == (100, "p1")
    assert found["pairs"] == result.played_pairs


def test_the_state_of_a_test_follows_from_counts_of_pairs() -> None:
    test = SequentialTest(0, 30, "nelo")
    assert test.state([0] * 5).accepted is None
    assert test.state([10, 0, 100, 0, 60]).accepted == "p1"
    assert test.state([60, 0, 100, 0, 10]).accepted == "p0"
    # The formula of the docs, with ten pairs of variance 1/8.
    counts, scale = [4, 3, 30, 6, 9], 800 / math.log(10)
    pairs = sum(counts)
    shares = [0.25 * k for k, count in enumerate(counts) for _ in range(count)]
    mean = sum(shares) / pairs

    def variance(about: float) -> float:
        return (sum((x - about) ** 2 for x in shares) + 1.25) / (pairs + 10)

    bounds = [0.5 + nelo / scale * math.sqrt(2 * variance(mean)) for nelo in (0, 30)]
    llr = pairs / 2 * math.log(variance(bounds[0]) / variance(bounds[1]))
    assert test.state(counts).llr == pytest.approx(llr)
    for wrong, place in (
        (lambda: SequentialTest(0.5, 0.6, "points"), "test.unit"),
        (lambda: SequentialTest(30, 0, "nelo"), "test.p1"),
        (lambda: SequentialTest(0, 3000, "nelo"), "test.p1"),
        (lambda: SequentialTest(0, 30), "test.p0"),
        (lambda: SequentialTest(0.5, 0.6, alpha=0.7), "test.alpha"),
        (lambda: test.state([1, 2, 3]), "pair_counts"),
    ):
        refused(place, wrong)


def test_a_plan_has_the_settings_and_defaults_of_a_match() -> None:
    played = inspect.signature(carom.play_match).parameters
    planned = inspect.signature(carom.arena.MatchPlan).parameters
    # The other arguments say how the match is run.
    assert set(played) - set(planned) == {"out", "level", "threads", "processes", "progress"}
    for name, parameter in planned.items():
        assert (parameter.default, parameter.annotation, parameter.kind) == (
            played[name].default,
            played[name].annotation,
            played[name].kind,
        ), name


# Errors.


@pytest.mark.parametrize(
    ("place", "given"),
    [
        ("one", {"one": "someone"}),
        ("other", {"other": "carom:x"}),
        ("one.exploring", {"one": "carom[exploring=2]"}),
        ("one.break", {"one": "carom[break=rail]"}),
        ("other", {"other": 5}),
        ("out", {"out": 5}),
        ("game", {"game": "billiards"}),
        ("pairs", {"pairs": 0}),
        ("noise", {"noise": "club"}),
        ("noise", {"noise": (Noise(), Noise(), Noise())}),
        ("perception", {"perception": 0.1}),
        ("table", {"table": "carom-10ft"}),
        ("simulations", {"simulations": 0}),
        ("simulations", {"simulations": 1.5}),
        ("time", {"time": 0.0}),
        ("clock", {"clock": float("nan")}),
        ("clock", {"time": 1.0, "clock": 2.0}),
        ("frame_simulations", {"frame_simulations": 0}),
        ("breaker", {"breaker": "me"}),
        ("same_break", {"same_break": Strike(speed=1.0, azimuth=0.0)}),
        ("same_break.strike.side", {"same_break": Play(Strike(1.0, 0.0, 0.1, side=0.9))}),
        ("disclosure", {"disclosure": "all"}),
        ("test", {"test": 0.5}),
        ("test.p1", {"test": (0.6, 0.5)}),
        ("test", {"test": "0.5,0.6"}),
        ("secret", {"secret": "12"}),
        ("miss", {"miss": "yes"}),
        ("level", {"level": 1.0}),
        ("threads", {"threads": 0}),
    ],
)
def test_bad_arguments_of_a_match_are_refused(
    place: str, given: dict[str, Any], tmp_path: Path
) -> None:
    arguments: dict[str, Any] = {"one": "carom", "other": "carom", "out": tmp_path / "m", **given}
    refused(place, lambda: carom.play_match(**arguments))
    assert not (tmp_path / "m").exists(), "nothing was begun"


def test_the_folder_of_another_match_is_refused(played: carom.MatchResult) -> None:
    assert played.record is not None
    folder = played.record.parent
    refused("folder", lambda: carom.play_match("carom:60", "carom:90", out=folder, **SHORT))
    file: Any = played.record / "below"
    with pytest.raises(NotADirectoryError) as caught:
        carom.play_match("carom:60", "carom:300", out=file, **SHORT)
    assert str(played.record) in str(caught.value)


# The command line.


def test_match_prints_the_score(run: CommandLine, played: carom.MatchResult) -> None:
    done = run("match", "carom:60", "carom:300", *FLAGS, "--out", "m")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == str(played).replace(str(played.record), "m/match.jsonl") + "\n"
    done = run("match", "carom:60", "carom:300", *FLAGS, "--out", "m", "--json")
    assert json.loads(done.stdout)["wins"] == played.score.wins
    done = run("match", "--replay", "m/match.jsonl")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("reproduced bit by bit: 4 frames\n")
    done = run("match", "--replay", "m/match.jsonl", "--json")
    assert json.loads(done.stdout)["reproduced"] is True
    text = (run.cwd / "m/match.jsonl").read_text()
    done = run("match", "--replay", "-", stdin=text.replace('"legal": true', '"legal": false', 1))
    assert (done.returncode, done.stdout) == (2, "")
    assert "not reproduced: line 2, moves[" in done.stderr


def test_match_passes_its_options_on(run: CommandLine) -> None:
    done = run(
        *("match", "carom", "carom", "--out", "m", "--pairs", "1", "--game", "nine-ball"),
        *("--simulations", "40,50", "--noise", "club,olympiad:0.5", "--perception", "0,0.001"),
        *("--same-break", "rail", "--breaker", "B", "--test", "0.5,0.6", "--table", "bar-7ft"),
    )
    assert done.returncode == 0, done.stderr
    header = json.loads((run.cwd / "m/match.jsonl").read_text().splitlines()[0])
    assert [clock["simulations"] for clock in header["clock"]] == [40, 50]
    assert [noise["speed"] for noise in header["noise"]] == [0.15, 0.0375]
    assert [sight["position"] for sight in header["perception"]] == [0.0, 0.001]
    assert header["breaker"] == 1
    assert header["test"] == {"p0": 0.5, "p1": 0.6, "alpha": 0.05, "beta": 0.05}
    rail = carom.break_shot("nine-ball", preset="rail", table="bar-7ft")
    assert header["same_break"]["strike"]["azimuth"] == rail.azimuth


@pytest.mark.parametrize(
    ("game", "preset"),
    [("straight-pool", "safety"), ("three-cushion", "opening"), ("snooker", "baulk")],
)
def test_a_break_preset_is_the_break_of_both_players(
    run: CommandLine, game: str, preset: str
) -> None:
    known = carom.break_shot(game, preset=preset)
    done = run(
        *("match", "carom:40", "carom:40", "--out", "m", "--pairs", "1", "--game", game),
        *("--same-break", preset, "--points", "2", "--json"),
    )
    assert done.returncode == 0, done.stderr
    header, *frames, _ = map(json.loads, (run.cwd / "m/match.jsonl").read_text().splitlines())
    assert header["same_break"]["strike"]["azimuth"] == known.azimuth
    for frame in frames:
        assert frame["moves"][0]["play"] == header["same_break"]


def test_a_given_break_has_the_default_elevation(tmp_path: Path) -> None:
    given = Play(Strike(8.0, 1.57), (0.635, 0.6))
    options = {"game": "nine-ball", "pairs": 1, "secret": SECRET, "simulations": 40}
    result = carom.play_match("carom", "carom", out=tmp_path / "m", same_break=given, **options)
    assert result.record is not None
    header = json.loads(result.record.read_text().splitlines()[0])
    usual = given.shot(carom.Frame("nine-ball")).elevation
    assert header["same_break"]["strike"]["elevation"] == usual
    assert usual is not None


def test_players_of_the_same_name_are_told_apart(tmp_path: Path) -> None:
    result = carom.play_match("greedy:40", "greedy:40", out=tmp_path / "m", pairs=1)
    _, _, one, other, *_ = str(result).splitlines()
    assert one.split()[:2] == ["greedy:40", "(A)"]
    assert other.split()[:2] == ["greedy:40", "(B)"]
    assert str(result).startswith("eight-ball: 1 pair of frames")


def test_ctrl_c_keeps_what_was_played(tmp_path: Path) -> None:
    flags = ["--game", "nine-ball", "--pairs", "1000", "--threads", "1", "--secret", SECRET]
    match = [sys.executable, "-m", "carom", "match", "carom:60", "carom:60", *flags, "--out", "m"]
    # A shell in the background lets its children ignore the interrupt.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    record = tmp_path / "m" / "played.jsonl"
    with subprocess.Popen(match, stderr=subprocess.PIPE, text=True, cwd=tmp_path) as process:
        end = time.monotonic() + 60
        while not (record.exists() and record.read_text().count("\n") > 4):
            assert process.poll() is None, process.stderr and process.stderr.read()
            assert time.monotonic() < end
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, error = process.communicate(timeout=60)
    assert process.returncode == 130
    assert error == "carom: stopped; the same command continues from here\n"
    played = record.read_text().splitlines()
    assert len(played) % 2 == 1, "the header, and whole pairs"
    frames = [json.loads(line)["frame"] for line in played[1:]]
    assert sorted(frames) == list(range(len(frames)))


@pytest.mark.parametrize(
    ("arguments", "place"),
    [
        (["carom"], "A: "),
        (["carom", "carom"], "--out: "),
        (["me", "carom", "--out", "m"], "one: "),
        (["carom", "carom:0", "--out", "m"], "other: "),
        (["carom", "carom", "--out", "m", "--time", "x"], "--time: "),
        (["carom", "carom", "--out", "m", "--simulations", "1.5"], "--simulations: "),
        (["carom", "carom", "--out", "m", "--clock", "1,2,3"], "--clock: "),
        (["carom", "carom", "--out", "m", "--noise", "x"], "noise: "),
        (["carom", "carom", "--out", "m", "--perception", "x"], "--perception: "),
        (["carom", "carom", "--out", "m", "--test", "0.5"], "--test: "),
        (["carom", "carom", "--out", "m", "--breaker", "C"], "--breaker: "),
        (["carom", "carom", "--out", "m", "--same-break", "x"], "preset: "),
        (["carom", "carom", "--replay", "m"], "--replay: "),
        (["--replay", "missing.jsonl"], "missing.jsonl: "),
    ],
)
def test_match_refuses_bad_input(run: CommandLine, arguments: list[str], place: str) -> None:
    done = run("match", *arguments)
    assert (done.returncode, done.stdout) == (2, ""), done.stderr
    assert done.stderr.startswith(f"carom: {place}"), done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
