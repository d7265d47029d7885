"""The experiments of strategy count what was played, and go on where they were stopped."""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path
from typing import Any

import carom
import pytest
from carom import _core

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "scripts" / "strategy"


@pytest.fixture(scope="module")
def modules() -> Any:
    """The modules of the folder, which import each other by name."""
    names = (
        "catalogue",
        "matches",
        "visits",
        "endings",
        "stated",
        "processes",
        "seeds",
        "tutorial",
        "identical",
    )
    sys.path.insert(0, str(FOLDER))
    try:
        yield {name: __import__(name) for name in names}
    finally:
        sys.path.remove(str(FOLDER))
        for name in names:
            sys.modules.pop(name, None)


def test_the_counts_of_a_match_are_those_of_its_record(modules: Any, tmp_path: Path) -> None:
    match = modules["matches"].Match("carom:60", "greedy:60", pairs=2, game="eight-ball")
    result = match.play("a test", tmp_path / "m", 1)
    assert result["pairs"] == 2
    frames = [
        json.loads(line)
        for line in (tmp_path / "m" / "match.jsonl").read_text("utf-8").splitlines()[1:-1]
    ]
    one, other = result["counts"]
    assert (one["breaks"], other["breaks"]) == (2, 2)
    moves = sum(len(frame["moves"]) for frame in frames)
    assert one["decisions"] + other["decisions"] == moves
    wins = [frame["end"]["winner"] == frame["seats"][0] for frame in frames]
    assert one["break_wins"] + other["break_wins"] == sum(wins)
    for player in (one, other):
        assert player["made"] <= player["pots"]
        assert player["runs"] <= player["break_wins"] <= player["breaks"]


def test_a_break_that_is_followed_by_a_choice_or_wins_keeps_the_turn(
    modules: Any, tmp_path: Path
) -> None:
    play, choice = {"seat": 0, "play": {}}, {"seat": 0, "choice": "spot-eight"}
    other = {"seat": 1, "play": {}}
    frames = [
        {"moves": moves, "seats": seats, "end": {"winner": winner}}
        for moves, seats, winner in [
            ([play, choice, other], [0, 1], 1),
            ([play], [0, 1], 0),
            ([play], [1, 0], 0),
            ([play, other], [1, 0], 0),
            ([play, play], [0, 1], 0),
            ([play], [0, 1], None),
        ]
    ]
    record = tmp_path / "match.jsonl"
    record.write_text("\n".join(json.dumps(line) for line in [{}, *frames, {}]), "utf-8")
    one, two = modules["matches"].counts(record)["counts"]
    assert (one["breaks"], one["kept"]) == (4, 3)
    assert (two["breaks"], two["kept"]) == (2, 0)


def test_a_match_of_the_same_name_has_the_same_frames(modules: Any, tmp_path: Path) -> None:
    match = modules["matches"].Match("carom:40", "carom:60", pairs=1, game="nine-ball")
    one = match.play("a name", tmp_path / "one", 1)
    assert match.play("a name", tmp_path / "other", 2) == one
    assert match.play("another name", tmp_path / "third", 1) != one


def test_visits_go_on_where_they_were_stopped(modules: Any, tmp_path: Path) -> None:
    visits = modules["visits"].Visits("carom:40", count=3, game="nine-ball")
    whole = visits.play("a test", tmp_path / "whole", 1)
    assert whole["visits"] == 3
    assert whole["shots"] >= 3
    stored = (tmp_path / "whole" / "visits.jsonl").read_text("utf-8").splitlines()
    (tmp_path / "stopped").mkdir()
    (tmp_path / "stopped" / "visits.jsonl").write_text(stored[1] + "\n", encoding="utf-8")
    assert visits.play("a test", tmp_path / "stopped", 1) == whole


def test_stated_chances_are_compared_with_other_errors(modules: Any, tmp_path: Path) -> None:
    experiment = modules["stated"].Stated("carom:60", decisions=6, noise=2.0)
    whole = experiment.play("a test", tmp_path / "whole", 1)
    assert sum(tenth["decisions"] for tenth in whole["kept"]["tenths"]) == 6
    rows = (tmp_path / "whole" / "decisions.jsonl").read_text("utf-8").splitlines()
    shares = [json.loads(row)["kept"] for row in rows[:6]]
    assert any(stated != counted for stated, counted in shares)
    assert whole["kept"]["counted"] == pytest.approx(sum(c for _, c in shares) / 6, abs=1e-4)
    (tmp_path / "stopped").mkdir()
    (tmp_path / "stopped" / "decisions.jsonl").write_text(rows[0] + "\n", encoding="utf-8")
    assert experiment.play("a test", tmp_path / "stopped", 1) == whole


def test_frames_against_the_planner_of_the_tutorial_go_on_where_they_were_stopped(
    modules: Any, tmp_path: Path
) -> None:
    experiment = modules["tutorial"].AgainstPlanner("carom:60", pairs=2)
    whole = experiment.play("a test", tmp_path / "whole", 1)
    rows = (tmp_path / "whole" / "frames.jsonl").read_text("utf-8").splitlines()
    (tmp_path / "stopped").mkdir()
    (tmp_path / "stopped" / "frames.jsonl").write_text(rows[0] + "\n", encoding="utf-8")
    assert experiment.play("a test", tmp_path / "stopped", 1) == whole
    points = [json.loads(row)["points"] for row in rows]
    assert whole["share"] == pytest.approx(sum(points) / 4)


def test_the_planner_of_the_tutorial_breaks_full_and_takes_a_ball_that_hangs(modules: Any) -> None:
    planner = modules["tutorial"].tutorial_robots(carom.Noise.olympiad(0.0))["planner"]
    strike, announced = planner(carom.Frame("eight-ball", seed=1))
    assert (strike.speed, announced) == (8.0, {})
    layout = carom.Shot("wpa-9ft", {"cue": (0.9, 1.9), "8": (0.2, 0.2), "1": (1.17, 2.44)})
    _, announced = planner(carom.Frame.of_shot("eight-ball", layout))
    assert (announced["call"].ball, announced["call"].into) == ("1", "top-right")


def test_an_interval_of_pairs_is_that_of_a_match(tmp_path: Path) -> None:
    result = carom.play_match("greedy:60", "deep-green-0:60", out=tmp_path / "m", pairs=6)
    ends = _core.pair_interval(list(result.score.pair_counts), level=0.95)
    assert ends == pytest.approx(result.score.share_interval)


@pytest.mark.parametrize("balls", [1, 7])
def test_a_visit_from_ball_in_hand_begins_on_an_open_table(modules: Any, balls: int) -> None:
    frame = modules["visits"].with_ball_in_hand(balls, 5)
    assert (frame.player, frame.request["in_hand"]) == (1, "anywhere")
    assert len(frame.balls) == 2 + 2 * balls
    assert frame.balls == modules["visits"].with_ball_in_hand(balls, 5).balls
    places = list(frame.balls.values())
    near = modules["visits"].RADIUS + modules["visits"].ROOM
    x, y = modules["visits"].SIZE
    assert all(near <= a <= x - near and near <= b <= y - near for a, b in places[1:])


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_visit_of_straight_pool_begins_with_a_break_shot(modules: Any, seed: int) -> None:
    frame = modules["visits"].with_break_shot(seed, 150)
    assert (frame.player, len(frame.balls), frame.request["in_hand"]) == (0, 16, None)
    low = sorted(y for ball, (_, y) in frame.balls.items() if ball != "cue")
    # Only the break ball may be below the second row of the rack.
    assert low[1] > 1.954
    decision = carom.Player("carom:2000", noise=carom.Noise.preset("olympiad:0.5")).choose(frame)
    decision.apply(frame)
    assert frame.scores[0] == 1


def test_every_experiment_names_players_that_exist(modules: Any) -> None:
    for name, experiment in modules["catalogue"].EXPERIMENTS.items():
        assert experiment.describe()
        for player in ("player", "one", "other"):
            if text := getattr(experiment, player, None):
                assert carom.Player(text).name == text.partition("[")[0].partition(":")[0], name


def test_frames_of_identical_players_have_shares_with_their_errors(
    modules: Any, tmp_path: Path
) -> None:
    identical = modules["identical"]
    lucks = [0.4, -0.5, 0.3, -0.4, 0.0, 0.2]
    rows = [
        {"frame": k, "points": float(k % 2 == 0), "logistic": luck, "noise": 0.1 - luck / 10}
        for k, luck in enumerate(lucks)
    ]
    rows.append({"frame": 6, "points": None, "logistic": 9.0, "noise": 9.0})
    (tmp_path / "0.jsonl").write_text("\n".join(map(json.dumps, rows)), encoding="utf-8")
    found = identical.Identical("greedy", frames=7).play("a test", tmp_path, 1)
    assert (found["frames"], found["raw"]["mean"]) == (7, 0.5)
    assert found["raw"]["error"] == pytest.approx((0.3 / 6) ** 0.5)
    assert found["logistic"]["plain"]["mean"] == pytest.approx(0.5 - sum(lucks) / 6)
    assert found["logistic"]["plain"]["error"] < found["raw"]["error"]
    assert found["noise"]["luck"]["mean"] == pytest.approx(0.1)


def test_the_tenths_of_a_match_are_added(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "benches"))
    tables = importlib.import_module("strategy")
    found = {
        "literature-level-two-off-01": {"pair_counts": [1, 0, 2, 0, 1]},
        "literature-level-two-off-02": {"pair_counts": [0, 0, 2, 0, 2]},
        "literature-samples-10": {"pair_counts": [9, 0, 0, 0, 0]},
    }
    match = tables.pooled("literature-level-two-off-", found)
    assert (match["pairs"], match["share"]) == (8, 0.625)
    # The variance of a pair is 7/64 about its mean.
    half = 1.96 * (7 / 64 / 8) ** 0.5
    assert match["share_interval"] == pytest.approx([0.625 - half, 0.625 + half])
    assert tables.pooled("literature-level-two-given-", found) is None
