"""The standing table: `benches/ladder.py`, and its stored result."""

from __future__ import annotations

import json
import os
import tomllib
from pathlib import Path
from typing import Any

import carom
import pytest
from carom.arena import Tournament
from carom.arena.tournament import LADDER
from tests.test_stored_results import load

ladder: Any = load("benches/ladder.py")
FILE = tomllib.loads(LADDER.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a small ladder."""
    out = tmp_path_factory.mktemp("ladder")
    players = ["greedy:9", "pool-master:9", "deep-green-0:9"]
    settings = {"type": "round-robin", "noise": ["olympiad", "olympiad:2"], "block": 1, "pairs": 1}
    events = [
        {"name": "eight-ball", "game": "eight-ball", **settings},
        {"name": "other-games", "game": ["nine-ball"], "players": players[:2], **settings},
    ]
    file = {"format": FILE["format"], "players": players, "events": events, "secret": "5" * 64}
    Tournament(file).run(out)
    return out


def test_a_folder_becomes_a_result_with_ratings_and_shares(folder: Path) -> None:
    first, *_, last = sorted(folder.rglob("match.jsonl"))
    os.utime(last, (0, first.stat().st_mtime + 7200))
    found = json.loads(json.dumps(ladder.result(folder, 2)))
    assert (found["pairs"], found["planned_pairs"], found["finished"]) == (8, 8, True)
    assert 1.9 < found["hours"] < 2.1
    assert [(table["game"], table["noise"]) for table in found["tables"]] == [
        ("eight-ball", "olympiad"),
        ("eight-ball", "olympiad:2"),
        ("nine-ball", "olympiad"),
        ("nine-ball", "olympiad:2"),
    ]
    rated = carom.arena.ratings(folder)
    for table, expected in zip(found["tables"], rated, strict=True):
        assert table["pairs"] == expected.pairs
        for row, player in zip(table["players"], expected.players, strict=True):
            assert row["player"] == player.player
            assert row["elo"] == pytest.approx(player.elo, abs=1e-4)
            assert row["share"] == pytest.approx(player.share, abs=1e-4)


def test_an_unfinished_folder_tells_how_much_is_missing(folder: Path, tmp_path: Path) -> None:
    for path in folder.rglob("*"):
        place = tmp_path / path.relative_to(folder)
        if path.is_dir():
            place.mkdir(parents=True, exist_ok=True)
        else:
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(path.read_bytes())
    next(tmp_path.rglob("match.jsonl")).unlink()
    found = ladder.result(tmp_path, 1)
    assert (found["pairs"], found["planned_pairs"], found["finished"]) == (7, 8, False)
    assert ladder.made(found)[1][3] == "7 of 8"


def test_the_tables_have_a_row_for_each_player_and_each_other_game(folder: Path) -> None:
    found = ladder.result(folder, 2)
    head, *rows, breaker = ladder.strengths(found, "eight-ball")
    assert head[0] == "Player"
    assert len(head) == 5
    assert {row[0] for row in rows} == {"`greedy:9`", "`pool-master:9`", "`deep-green-0:9`"}
    assert all(len(row) == len(head) for row in [*rows, breaker])
    games = ladder.other_games(found)
    assert [row[:3] for row in games[1:]] == [["nine-ball", "× 1", "1"], ["nine-ball", "× 2", "1"]]


def test_the_stored_table_has_the_players_and_the_conditions_of_the_ladder() -> None:
    found = json.loads(ladder.STORE.read_text(encoding="utf-8"))
    for event in FILE["events"]:
        games = event["game"] if isinstance(event["game"], list) else [event["game"]]
        for game in games:
            for noise in event["noise"]:
                (table,) = [
                    table
                    for table in found["tables"]
                    if (table["game"], table["noise"]) == (game, noise)
                ]
                names = {row["player"] for row in table["players"]}
                assert names == set(event.get("players", FILE["players"]))
