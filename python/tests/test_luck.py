"""The luck of the shots of a match: `luck=True`, `--luck`, `carom.arena.luck`."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import carom
import pytest
from carom import InputError, _core

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

SHORT: dict[str, Any] = {"game": "nine-ball", "pairs": 2, "secret": "ab" * 32}
FLAGS = ["--game", "nine-ball", "--pairs", "2", "--secret", "ab" * 32]


@pytest.fixture(scope="module")
def usual(tmp_path_factory: pytest.TempPathFactory) -> carom.MatchResult:
    """A match whose luck is not measured."""
    return carom.play_match("carom:40", "greedy:40", out=tmp_path_factory.mktemp("u"), **SHORT)


@pytest.fixture(scope="module")
def lucky(tmp_path_factory: pytest.TempPathFactory) -> carom.MatchResult:
    """The same match with its luck."""
    out = tmp_path_factory.mktemp("l")
    return carom.play_match("carom:40", "greedy:40", out=out, luck=4, **SHORT)


def text(result: carom.MatchResult) -> str:
    assert result.record is not None
    return result.record.read_text()


def test_a_score_has_the_share_that_is_corrected_for_luck(
    usual: carom.MatchResult, lucky: carom.MatchResult
) -> None:
    assert usual.score.adjusted is None
    assert "adjusted" not in usual.to_dict()
    adjusted = lucky.score.adjusted
    assert adjusted is not None
    assert adjusted.pairs == 2
    low, high = adjusted.share_interval
    assert low < adjusted.share < high
    assert (lucky.score.share, lucky.score.reasons) == (usual.score.share, usual.score.reasons)
    assert lucky.to_dict()["adjusted"]["share"] == adjusted.share
    assert f"corrected for luck {100 * adjusted.share:.1f} %" in str(lucky)


def test_the_luck_of_a_finished_record_is_that_of_the_match(
    usual: carom.MatchResult, lucky: carom.MatchResult
) -> None:
    assert carom.arena.luck(text(usual), draws=4) == text(lucky)
    found = carom.replay_match(text(usual), luck=4)
    assert found.score == lucky.score
    assert found.with_luck == text(lucky)
    again = carom.replay_match(text(lucky))
    assert (again.difference, again.score, again.with_luck) == (None, lucky.score, None)


def test_the_luck_of_a_frame_is_the_sum_of_its_shots(lucky: carom.MatchResult) -> None:
    header, *frames, _ = map(json.loads, text(lucky).splitlines())
    assert header["luck"] == {"draws": 4, "value": "logistic"}
    pairs = []
    for one, other in zip(frames[::2], frames[1::2], strict=True):
        points = (one["end"]["points"][0] + other["end"]["points"][0]) / 2
        luck = 0.0
        for frame in (one, other):
            for move in frame["moves"]:
                if "luck" in move:
                    own = 1 if frame["seats"][move["seat"]] == 0 else -1
                    luck += own * (move["luck"]["after"] - move["luck"]["expected"]) / 2
        pairs.append((points, luck))
    adjusted = _core.adjusted_share(pairs, 0.95)
    assert lucky.score.adjusted is not None
    assert adjusted["share"] == pytest.approx(lucky.score.adjusted.share, abs=1e-12)
    assert adjusted["weight"] == pytest.approx(lucky.score.adjusted.weight, abs=1e-12)


def test_the_command_line_measures_the_luck_of_a_match_and_of_a_record(
    run: CommandLine, tmp_path: Path, lucky: carom.MatchResult
) -> None:
    words = ["--luck", "--luck-draws", "4"]
    out = ["--out", str(tmp_path / "m")]
    played = run("match", "carom:40", "greedy:40", *out, *FLAGS, *words)
    assert played.returncode == 0, played.stderr
    assert "carom:40 has, corrected for luck " in played.stdout
    record = tmp_path / "m" / "match.jsonl"
    assert record.read_text() == text(lucky)
    replayed = run("match", "--replay", str(record), *words, "--json")
    found = json.loads(replayed.stdout)
    assert lucky.score.adjusted is not None
    assert found["adjusted"]["share"] == lucky.score.adjusted.share


def test_a_number_of_fresh_errors_out_of_range_is_refused(
    usual: carom.MatchResult, tmp_path: Path
) -> None:
    for luck in (0, -1, 1 << 20, 2.5):
        with pytest.raises(InputError, match=r"^luck: .* is out of range"):
            carom.play_match("greedy", "greedy", out=tmp_path / "m", luck=luck)
    with pytest.raises(InputError, match=r"^line \d+"):
        carom.arena.luck(text(usual) + "{}")


def test_a_record_that_does_not_replay_has_no_luck(usual: carom.MatchResult) -> None:
    changed = text(usual).replace(
        '"executed": {"strike": {"speed": ', '"executed": {"strike": {"speed": 1', 1
    )
    with pytest.raises(InputError, match="not reproduced") as caught:
        carom.arena.luck(changed, draws=2)
    assert caught.value.kind == "changed"
    assert caught.value.place == "line 2, moves[0].executed.strike.speed"
