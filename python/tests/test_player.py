"""Players: decisions, analyses, budgets, Ctrl-C, errors, pictures, `carom think`."""

from __future__ import annotations

import json
import math
import signal
import subprocess
import sys
import threading
import time
from dataclasses import FrozenInstanceError
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import carom
import pytest
from carom import Frame, InputError, Noise, Player, Shot
from carom.picture import plays, save
from carom.player import words

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

# Simulated shots of a decision: few, so that the tests are fast, and more than one round.
FEW = 5000
CLUB = Noise.preset("club")
OTHER = Noise.preset("professional")

# A straight shot: the 9 hangs over the top right pocket, and the cue ball is 0.5 m behind it.
HANGER = {"cue": (0.85, 2.12), "9": (1.2, 2.47)}
MIDDLE = {"cue": (0.5, 1.2), "1": (0.9, 1.9), "3": (0.8, 0.6), "9": (0.3, 2.0)}


@pytest.fixture(scope="module")
def middle() -> Frame:
    """Nine-ball with three balls left."""
    return Frame.of_shot("nine-ball", Shot("wpa-9ft", MIDDLE))


@pytest.fixture(scope="module")
def analysis(middle: Frame) -> carom.Analysis:
    return Player(noise=CLUB, simulations=FEW, seed=5).explain(middle, 4)


def refused(place: str, call: Any) -> None:
    with pytest.raises(InputError) as caught:
        call()
    assert str(caught.value).startswith(f"{place}: "), caught.value
    assert ";" in str(caught.value), "and the remedy"


def test_a_decision_is_the_same_for_any_number_of_threads(middle: Frame) -> None:
    found = [
        Player(noise=CLUB, simulations=FEW, threads=threads).choose(middle)
        for threads in (1, 2, None)
    ]
    assert found[0] == found[1] == found[2]
    assert found[0].rounds > 1


def test_the_number_of_rounds_repeats_a_decision_that_a_clock_ended(middle: Frame) -> None:
    timed = Player(noise=CLUB, time=0.2).choose(middle)
    assert Player(noise=CLUB, rounds=timed.rounds).choose(middle) == timed
    fewer = Player(noise=CLUB, rounds=1).choose(middle)
    assert fewer.rounds == 1
    assert fewer.simulations <= timed.simulations


def test_a_decision_has_at_least_one_round(middle: Frame) -> None:
    assert Player(time=1e-9).choose(middle).rounds == 1


def test_another_seed_gives_other_random_numbers(middle: Frame) -> None:
    one, other = (Player(simulations=FEW, seed=seed).choose(middle) for seed in (0, 1))
    assert one.win_chance != other.win_chance


def test_a_number_behind_the_name_is_the_budget(middle: Frame) -> None:
    named = Player(f"carom:{FEW}", noise=CLUB)
    assert named.choose(middle) == Player(noise=CLUB, simulations=FEW).choose(middle)
    assert named.name == "carom"
    assert carom.players()[0] == "carom"


def test_a_hanging_ball_is_potted() -> None:
    frame = Frame.of_shot("nine-ball", Shot("wpa-9ft", HANGER))
    decision = Player(noise=CLUB, simulations=FEW).choose(frame)
    assert decision.win_chance is not None
    assert decision.win_chance > 0.9
    ruling = decision.apply(frame)
    assert ruling.legal
    assert frame.request.winner == 0


def test_choosing_and_explaining_leave_the_frame_unchanged(middle: Frame) -> None:
    before = middle.record
    player = Player(simulations=100)
    player.choose(middle)
    player.explain(middle, 1)
    assert middle.record == before


@pytest.mark.parametrize("game", carom.rule_sets())
def test_the_opening_of_every_game_gets_an_answer_that_the_rules_allow(game: str) -> None:
    frame = Frame(game, seed=3)
    decision = Player(noise=CLUB, simulations=600).choose(frame)
    assert decision.play is not None
    decision.apply(frame)
    assert len(frame.record["moves"]) == 1


@pytest.mark.parametrize("game", carom.rule_sets())
def test_requests_in_the_middle_of_every_game_get_answers(game: str) -> None:
    frame = Frame(game, seed=4)
    player = Player(noise=CLUB, simulations=300)
    for index in range(6):
        if frame.over:
            break
        decision = player.choose(frame)
        if decision.play is None:
            decision.apply(frame)
        else:
            # With errors, so that the frame comes to requests of every kind.
            play = decision.play
            strike = CLUB.draw(play.shot(frame), index)
            frame.play(strike, cue_ball=play.cue_ball, call=play.call)
    assert frame.over or len(frame.record["moves"]) == 6


def test_a_choice_is_one_of_those_that_the_frame_offers() -> None:
    frame = _push_out()
    assert frame.request.kind == "choice"
    choices = frame.request.choices
    decision = Player(simulations=500).choose(frame)
    assert (decision.play, decision.concession) == (None, False)
    assert decision.choice in choices
    assert decision.to_dict()["choice"] == decision.choice == str(decision).partition(";")[0]
    decision.apply(frame)
    assert frame.request.kind == "shot"
    refused("frame", lambda: Player().explain(_push_out()))


def _push_out() -> Frame:
    frame = Frame("nine-ball", seed=7)
    frame.play(carom.Strike(speed=8.0, azimuth=1.57), cue_ball=(0.635, 0.6))
    frame.play(carom.Strike(speed=1.0, azimuth=3.0), call=carom.Call.push_out())
    return frame


def test_a_concession_ends_the_frame() -> None:
    frame = Frame("snooker")
    decision = carom.Decision(
        play=None, choice=None, win_chance=0.0, simulations=9, rounds=1, interrupted=False
    )
    assert decision.concession
    assert decision.to_dict()["concede"] is True
    assert str(decision) == "concede; wins 0 %"
    decision.apply(frame)
    assert (frame.over, frame.request.winner) == (True, 1)


def test_the_errors_of_both_players_count(middle: Frame) -> None:
    player = Player(noise=CLUB, simulations=FEW)
    equal = player.explain(middle, 1).plays[0].win_chance
    against_better = player.explain(middle, 1, opponent_noise=OTHER).plays[0].win_chance
    better = player.explain(middle, 1, noise=OTHER, opponent_noise=CLUB).plays
    assert against_better != equal
    assert better[0].win_chance > equal
    same = Player(noise=OTHER, simulations=FEW).explain(middle, 1, opponent_noise=CLUB).plays
    assert better == same


def test_the_noise_belongs_to_the_player_who_is_asked() -> None:
    # Player 1 is asked after a miss: its own errors are small, those of player 0 large.
    frame = Frame.of_shot("nine-ball", Shot("wpa-9ft", MIDDLE))
    assert frame.play(carom.Strike(speed=2.5, azimuth=1.03)).legal
    assert frame.player == 1
    weak, strong = (
        Player(noise=own, simulations=FEW).explain(frame, 1, opponent_noise=CLUB).plays[0]
        for own in (Noise.preset("beginner"), OTHER)
    )
    assert strong.kept.probability > weak.kept.probability + 0.1


# Analyses.


def test_an_analysis_has_distinct_plays_with_the_best_first(analysis: carom.Analysis) -> None:
    assert len(analysis.plays) == 4
    assert analysis.best is analysis.plays[0]
    chances = [play.win_chance for play in analysis.plays]
    assert chances == sorted(chances, reverse=True)
    assert len({play.aim for play in analysis.plays}) > 1


def test_the_chances_of_an_analysis_agree_with_an_evaluation(analysis: carom.Analysis) -> None:
    best = analysis.plays[0]
    counted = best.shot.evaluate(CLUB, 4000, frame=analysis.frame, call=best.play.call, seed=99)
    assert counted.turn_kept is not None
    error = math.sqrt(0.25 / best.kept.trials + 0.25 / counted.n)
    assert abs(best.kept.probability - counted.turn_kept.probability) < 4 * error
    assert counted.legal is not None
    assert abs(1 - best.foul.probability - counted.legal.probability) < 4 * error
    distance = math.dist(best.leave.mean, counted.end_mean[0])
    assert distance < 5 * best.leave.spread / math.sqrt(best.leave.count) + 0.02


def test_the_chance_of_winning_is_the_mean_over_kept_and_missed_turns(
    analysis: carom.Analysis,
) -> None:
    for play in analysis.plays:
        kept = play.kept.probability
        if play.win_if_kept is None or play.win_if_missed is None:
            continue
        mean = kept * play.win_if_kept + (1 - kept) * play.win_if_missed
        # The search of replies corrects the chance, but not its parts.
        assert abs(mean - play.win_chance) < 0.2
    assert any(play.win_if_kept is not None for play in analysis.plays)


def test_the_shot_of_a_play_does_what_its_aim_says(analysis: carom.Analysis) -> None:
    pots = [play for play in analysis.plays if play.ball is not None]
    assert pots
    for play in pots:
        assert [play.ball, play.pocket] in play.shot.simulate().to_dict()["outcome"]["pocketed"]
        if play.kind == "indirect":
            assert play.legs == ()
        else:
            assert play.legs[-1][0] == play.ball
        assert play.shot == play.play.shot(analysis.frame)


def test_an_analysis_prints_as_a_table_and_in_notebooks(analysis: carom.Analysis) -> None:
    head, titles, *rows = str(analysis).splitlines()
    assert head.startswith("nine-ball, player 0 to shoot; ")
    assert "turn kept" in titles
    assert len(rows) == 4
    assert all("m/s" in row and "%" in row for row in rows)
    table = ElementTree.fromstring(analysis._repr_html_())
    assert len(table.findall("tbody/tr")) == 4


def test_an_analysis_is_plain_values(analysis: carom.Analysis) -> None:
    written = analysis.to_dict()
    assert json.loads(json.dumps(written, allow_nan=False)) == json.loads(json.dumps(written))
    play = written["plays"][0]
    assert play["play"]["strike"]["speed"] == analysis.plays[0].play.strike.speed
    assert 0 <= play["kept"]["low"] <= play["kept"]["probability"] <= play["kept"]["high"] <= 1
    assert written["thinking"]["noise"]["speed"] == CLUB.speed
    with pytest.raises(FrozenInstanceError):
        analysis.rounds = 1  # type: ignore[misc]


def test_a_shot_is_explained_in_a_game(middle: Frame, analysis: carom.Analysis) -> None:
    shot = Shot("wpa-9ft", MIDDLE)
    found = Player(noise=CLUB, simulations=FEW, seed=5).explain(shot, 4, game="nine-ball")
    assert found.plays == analysis.plays
    refused("game", lambda: Player().explain(shot))
    refused("game", lambda: Player().explain(middle, game="nine-ball"))


@pytest.mark.parametrize(
    ("side", "height", "said"),
    [
        (0.0, 0.0, "centre"),
        (0.04, -0.04, "centre"),
        (0.17, 0.0, "1 tip of right"),
        (-0.08, -0.34, "½ tip of left, 2 tips of draw"),
        (0.0, 0.34, "2 tips of follow"),
        (0.25, 0.0, "1½ tips of right"),
        (0.0, 0.5, "3 tips of follow"),
    ],
)
def test_tip_offsets_in_words(side: float, height: float, said: str) -> None:
    # Seen: a tip was 0.45 R here and R/6 on the page, so one stroke had two names.
    assert words.tip_offset(side, height) == said


def test_a_raised_cue_and_a_cue_ball_in_hand_are_named() -> None:
    strike = carom.Strike(speed=2.0, azimuth=0.0, elevation=math.radians(35), height=-0.2)
    play = carom.Play(strike, (0.5, 0.25), carom.Call.pocket("3", "left"))
    said = "3 into left, 2.0 m/s, 1 tip of draw, cue raised 35°, cue ball at (0.50, 0.25) m"
    assert str(play) == said


# Ctrl-C and stop.


def test_another_thread_can_stop_a_decision(middle: Frame) -> None:
    player = Player(noise=CLUB, simulations=10**8)
    timer = threading.Timer(0.2, player.stop)
    timer.start()
    decision = player.choose(middle)
    timer.join()
    assert decision.interrupted
    assert decision.play is not None
    again = Player(noise=CLUB, simulations=10**8, rounds=decision.rounds).choose(middle)
    assert not again.interrupted
    assert (again.play, again.win_chance) == (decision.play, decision.win_chance)


INTERRUPTED = """
import signal
import carom
signal.signal(signal.SIGINT, signal.default_int_handler)
frame = carom.Frame("eight-ball", seed=1)
player = carom.Player(simulations=10**8, threads=1)
print("ready", flush=True)
found = player.CALL
print(found.interrupted, found.rounds >= 1, flush=True)
"""


def interrupt(arguments: list[str], ready: str | None, cwd: Path) -> tuple[int, str, str]:
    """Exit code, stdout and stderr of a program that gets SIGINT while it thinks."""
    # A shell in the background lets its children ignore the interrupt.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with subprocess.Popen(
        [sys.executable, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=cwd,
    ) as process:
        assert process.stdout is not None
        if ready is not None:
            assert process.stdout.readline() == ready
            time.sleep(0.5)
        else:
            time.sleep(3.0)
        assert process.poll() is None, "the search is too short for this test"
        process.send_signal(signal.SIGINT)
        out, error = process.communicate(timeout=100)
    return process.returncode, out, error


@pytest.mark.parametrize("call", ["choose(frame)", "explain(frame, 2)"])
def test_ctrl_c_returns_the_best_play_so_far(call: str, tmp_path: Path) -> None:
    program = INTERRUPTED.replace("CALL", call)
    code, out, error = interrupt(["-c", program], "ready\n", tmp_path)
    assert (code, out) == (0, "True True\n"), error


def test_ctrl_c_ends_carom_think_with_the_table_so_far(tmp_path: Path) -> None:
    Shot("wpa-9ft", MIDDLE).save(tmp_path / "shot.json")
    think = ["-m", "carom", "think", "shot.json", "--game", "nine-ball", "--time", "1000"]
    code, out, error = interrupt(think, None, tmp_path)
    assert code == 0, error
    assert "interrupted" in out.splitlines()[0]
    assert "m/s" in out


# Errors.


@pytest.mark.parametrize(
    ("place", "given"),
    [
        ("player", {"level": "someone"}),
        ("player", {"level": "carom:0"}),
        ("level", {"level": 5}),
        ("simulations", {"level": "carom:100", "simulations": 100}),
        ("simulations", {"simulations": 0}),
        ("simulations", {"simulations": 10**9}),
        ("simulations", {"simulations": 1.5}),
        ("time", {"time": 0}),
        ("time", {"time": -1.0}),
        ("time", {"time": float("nan")}),
        ("time", {"time": float("inf")}),
        ("time", {"time": "long"}),
        ("rounds", {"rounds": 0}),
        ("seed", {"seed": -1}),
        ("noise", {"noise": "club"}),
        ("perception", {"perception": 0.001}),
        ("threads", {"threads": 0}),
    ],
)
def test_bad_arguments_of_a_player_are_refused(place: str, given: dict[str, Any]) -> None:
    refused(place, lambda: Player(**given))


def test_bad_arguments_of_a_decision_are_refused(middle: Frame) -> None:
    player = Player(simulations=100)
    over = middle.copy()
    over.concede()
    frame: Any = "eight-ball"
    noise: Any = "club"
    refused("frame", lambda: player.choose(over))
    refused("frame", lambda: player.explain(over))
    refused("frame", lambda: player.choose(frame))
    refused("noise", lambda: player.choose(middle, noise=noise))
    refused("opponent_noise", lambda: player.choose(middle, opponent_noise=noise))
    refused("count", lambda: player.explain(middle, 0))
    # A player of the literature plans with a number of simulated shots, not with a time.
    refused("simulations", lambda: Player("greedy", time=1.0).choose(middle))
    refused("player", lambda: Player("greedy:50").explain(middle))
    refused("frame", lambda: player.choose(middle).apply(frame))


# Pictures and the command line.


def test_the_picture_shows_the_best_play(analysis: carom.Analysis, tmp_path: Path) -> None:
    picture = plays.svg(analysis)
    assert picture == plays.svg(analysis)
    ids = {e.get("id") for e in ElementTree.fromstring(picture).iter()}
    assert {"ball-cue", "ghost-ball", "leave", "path-cue", "cue"} <= ids
    save(analysis, tmp_path / "best.png")
    assert (tmp_path / "best.png").read_bytes().startswith(b"\x89PNG")
    empty: Any = carom.Analysis(analysis.frame, (), analysis.thinking, 0, 0, interrupted=False)
    refused("analysis", lambda: plays.draw(empty))
    assert empty.best is None


@pytest.fixture
def shot_file(tmp_path: Path) -> str:
    Shot("wpa-9ft", MIDDLE).save(tmp_path / "shot.json")
    return "shot.json"


def test_think_prints_the_plays_of_a_shot_file(
    run: CommandLine, shot_file: str, tmp_path: Path
) -> None:
    options = ["--game", "nine-ball", "--noise", "club", "--simulations", str(FEW), "--seed", "5"]
    done = run("think", shot_file, *options, "--plays", "2", "--svg", "a.svg", "--png", "a.png")
    assert (done.returncode, done.stderr) == (0, "")
    shot = Shot("wpa-9ft", MIDDLE)
    player = Player(noise=CLUB, simulations=FEW, seed=5)
    assert done.stdout == f"{player.explain(shot, 2, game='nine-ball')}\n"
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert ElementTree.parse(tmp_path / "a.svg").getroot().tag.endswith("svg")


def test_think_prints_its_plays_although_the_picture_cannot_be_written(
    run: CommandLine, shot_file: str
) -> None:
    options = ["--game", "nine-ball", "--simulations", str(FEW), "--svg", "missing/a.svg"]
    done = run("think", shot_file, *options)
    assert done.returncode == 2
    assert done.stdout.startswith("nine-ball, player 0 to shoot")
    assert "missing/a.svg" in done.stderr


def test_think_reads_the_record_of_a_frame(run: CommandLine, middle: Frame) -> None:
    options = ["--simulations", "500", "--json", "--opponent-noise", "club:0.5", "--threads", "1"]
    done = run("think", "-", *options, stdin=json.dumps(middle.record))
    assert done.returncode == 0, done.stderr
    player = Player(simulations=500)
    found = player.explain(middle, opponent_noise=Noise.preset("club:0.5")).to_dict()
    assert json.loads(done.stdout) == json.loads(json.dumps(found))


def test_think_prints_a_choice_where_the_frame_requests_one(run: CommandLine) -> None:
    record = json.dumps(_push_out().record)
    done = run("think", "-", "--simulations", "500", stdin=record)
    assert done.returncode == 0, done.stderr
    assert done.stdout.partition(";")[0] in _push_out().request.choices
    done = run("think", "-", "--json", "--svg", "a.svg", stdin=record)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("carom: --svg: ")


@pytest.mark.parametrize(
    ("arguments", "place"),
    [
        (["shot.json"], "--game"),
        (["missing.json", "--game", "nine-ball"], "missing.json"),
        (["shot.json", "--game", "billiards"], "game"),
        (["shot.json", "--game", "snooker"], "balls[1].id"),
        (["shot.json", "--game", "nine-ball", "--time", "0"], "time"),
        (["shot.json", "--game", "nine-ball", "--noise", "club:-1"], "noise.speed"),
        (["shot.json", "--game", "nine-ball", "--opponent-noise", "x"], "--opponent-noise"),
        (["shot.json", "--game", "nine-ball", "--perception", "9"], "perception.position"),
        (["shot.json", "--game", "nine-ball", "--player", "me"], "player"),
        (["frame.json", "--game", "nine-ball"], "--game"),
        (["over.json"], "frame"),
        (["broken.json"], ""),
        (["trace.json"], "trace.json: format: found 'carom-trace/1'"),
    ],
)
def test_think_refuses_bad_input(
    run: CommandLine, shot_file: str, middle: Frame, arguments: list[str], place: str
) -> None:
    over = middle.copy()
    over.concede()
    for name, record in (("frame.json", middle.record), ("over.json", over.record)):
        (run.cwd / name).write_text(json.dumps(record))
    (run.cwd / "broken.json").write_text('{"format": "carom-frame/1"')
    (run.cwd / "trace.json").write_text('{"format": "carom-trace/1"}')
    done = run("think", *arguments)
    assert (done.returncode, done.stdout) == (2, ""), done.stderr
    assert done.stderr.startswith(f"carom: {place}"), done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
