"""Reports: tables of whole folders of matches, and their page."""

from __future__ import annotations

import base64
import csv
import gzip
import json
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import carom
import pytest
from carom.arena import SequentialTest, Tournament
from carom.arena import report as reports
from carom.arena.report import Report, read_report
from carom.arena.report_page import report_html
from tests.conftest import CommandLine


class Loser:
    """Concedes after a refused answer."""

    name = "loser"

    def choose(self, situation: carom.Situation) -> str | dict[str, object]:
        return "concede" if situation.refused else {"play": {}}


class Breaker:
    """Fails on the first request."""

    name = "<breaker> & co"

    def choose(self, situation: carom.Situation) -> str:
        raise RuntimeError("no idea")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("matches")
    options = {"game": "nine-ball", "pairs": 2, "noise": carom.Noise.olympiad()}
    carom.play_match(Loser, Breaker, out=root / "a", **options)
    carom.play_match(Loser, "level-1", out=root / "deep" / "b", **options)
    return root


@pytest.fixture(scope="module")
def report(folder: Path) -> Report:
    return read_report(folder)


def test_a_report_counts_frames_costs_and_losses_by_reason(report: Report) -> None:
    assert [match.folder for match in report.matches] == ["a", "deep/b"]
    rows = {row.name: row for table in report.tables for row in table.rows if row.name != "loser"}
    losers = [row for table in report.tables for row in table.rows if row.name == "loser"]
    # The player of the first request loses the frame: in a pair each player once.
    assert (rows["<breaker> & co"].won, rows["<breaker> & co"].lost) == (2, 2)
    assert rows["<breaker> & co"].losses == {"crash": 2}
    assert sum(row.costs.refused for row in losers) == sum(row.losses["conceded"] for row in losers)
    assert all(row.costs.refused > 0 for row in losers)
    assert rows["level-1"].costs.simulations > 0
    share = rows["<breaker> & co"].share
    assert share is not None
    assert (share.value, share.low < 0.5 < share.high) == (0.5, True)


def test_shares_are_those_of_the_match(folder: Path, report: Report) -> None:
    score = carom.replay_match((folder / "deep/b/match.jsonl").read_text()).score
    (table,) = [t for t in report.tables if any(row.name == "level-1" for row in t.rows)]
    share = table.cross["loser", "level-1"]
    assert (share.value, (share.low, share.high)) == (score.share, score.share_interval)
    other = table.cross["level-1", "loser"]
    assert other.value == pytest.approx(1.0 - share.value)


def test_the_page_contains_every_game_and_loads_nothing(report: Report) -> None:
    page = report_html(report, title="A & B")
    assert "<title>A &amp; B · carom</title>" in page
    assert "&lt;breaker&gt; &amp; co" in page
    assert "<breaker>" not in page
    assert not re.search(r'(?:src|href)="(?!#)', page)
    assert len(re.findall(r'href="#game-\d-\d"', page)) == 8
    (packed,) = re.findall(r'id="match-1">([^<]*)<', page)
    header, *lines = gzip.decompress(base64.b64decode(packed)).decode().split("\n")
    assert json.loads(header)["players"][1]["name"] == "level-1"
    assert [json.loads(line)["frame"] for line in lines] == [0, 1, 2, 3]
    # The same records give the same bytes.
    assert page == report_html(report, title="A & B")
    assert "href=" not in report_html(report, title="A", games=False)


def test_a_match_that_goes_on_is_reported_without_its_incomplete_line(
    folder: Path, tmp_path: Path
) -> None:
    lines = (folder / "a/match.jsonl").read_text().split("\n")
    played = tmp_path / "played.jsonl"
    played.write_text("\n".join([lines[0], lines[3], lines[4], lines[1][:40]]))
    found = read_report(tmp_path)
    assert not found.finished
    assert [frame.number for frame in found.matches[0].frames] == [2, 3]
    assert "goes on" in report_html(found, title="goes on", games=False)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("carom-match/1", "carom-match/7"), "line 1, format: it is not a record of a match"),
        (("\n", "\nnot JSON\n"), "line 2: it is not a JSON object"),
        (('"seats"', '"seat"'), "line 2: a value is missing or wrong (KeyError"),
    ],
)
def test_a_damaged_record_is_refused_with_its_line(
    folder: Path, tmp_path: Path, change: tuple[str, str], words: str
) -> None:
    text = (folder / "a/match.jsonl").read_text().replace(*change, 1)
    (tmp_path / "match.jsonl").write_text(text)
    with pytest.raises(carom.InputError) as refused:
        read_report(tmp_path)
    assert words in str(refused.value)
    assert "match.jsonl" in refused.value.place


def test_the_command_writes_page_tables_and_json(
    run: CommandLine, folder: Path, tmp_path: Path
) -> None:
    page, tables = tmp_path / "report.html", tmp_path / "tables"
    done = run("arena", "report", str(folder), "-o", str(page), "--csv", str(tables), "--json")
    assert done.returncode == 0, done.stderr
    assert page.read_text().startswith("<!doctype html>")
    names = ("breaker", "cross", "games", "losses", "players", "tests")
    assert sorted(path.name for path in tables.iterdir()) == [f"{name}.csv" for name in names]
    with (tables / "games.csv").open() as file:
        games = list(csv.DictReader(file))
    assert len(games) == len(json.loads(done.stdout)["games"]) == 8
    assert run("arena", "report", str(folder)).returncode == 2
    assert run("arena", "report", str(tmp_path / "tables"), "--json").returncode == 2


@pytest.fixture(scope="module")
def tournament(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three players, of whom two have a clock of their own, and a sequential test."""
    out = tmp_path_factory.mktemp("tournament")
    players: list[Any] = [
        "greedy:9",
        {"name": "old", "player": "pool-master:9"},
        {"name": "new", "player": "pick-pocket"},
    ]
    settings = {"game": "nine-ball", "simulations": 12, "pairs": 2}
    events = [
        {"name": "all", "type": "round-robin", "noise": ["olympiad", "club"], **settings},
        {"name": "test", "type": "test", "players": ["new", "old"], "nelo": [-5, 150], **settings},
    ]
    file = {"format": "carom-tournament/1", "players": players, "events": events}
    Tournament(file | {"secret": "7" * 64}).run(out)
    return out


def test_the_ratings_of_a_report_are_those_of_the_tournament(tournament: Path) -> None:
    found = read_report(tournament)
    rated = [table for table in found.tables if table.breaker]
    expected = {table.condition: table for table in carom.arena.ratings(tournament)}
    assert {table.condition for table in rated} == expected.keys()
    assert len(expected) == 2
    for table in rated:
        other = expected[table.condition]
        assert [row.name for row in table.rows] == [row.player for row in other.players]
        for row, rating in zip(table.rows, other.players, strict=True):
            assert row.rating == pytest.approx((rating.elo, rating.low, rating.high))
            assert row.share is not None
            assert row.share.value == rating.share
        assert table.breaker == pytest.approx(other.breaker)


def test_ratings_are_on_the_page_and_in_csv_and_json(
    run: CommandLine, tournament: Path, tmp_path: Path
) -> None:
    page = tmp_path / "report.html"
    options = ("-o", str(page), "--no-games", "--csv", str(tmp_path), "--json")
    done = run("arena", "report", str(tournament), *options)
    assert done.returncode == 0, done.stderr
    (table, *_) = json.loads(done.stdout)["tables"]
    best = table["players"][0]
    assert best["elo_low"] < best["elo"] < best["elo_high"]
    assert table["breaker"]["elo_low"] < table["breaker"]["elo"]
    text = page.read_text()
    assert f"<td>{best['elo']:+.0f} <small>" in text
    assert "The player who begins a frame has an advantage of" in text
    with (tmp_path / "players.csv").open() as file:
        (row, *_) = csv.DictReader(file)
    assert (row["player"], float(row["elo"])) == (best["player"], best["elo"])
    with (tmp_path / "breaker.csv").open() as file:
        (row, *_) = csv.DictReader(file)
    assert float(row["elo_high"]) == table["breaker"]["elo_high"]


def test_a_sequential_test_has_a_table_of_its_own_without_ratings(tournament: Path) -> None:
    found = read_report(tournament)
    (table,) = [table for table in found.tables if table.tests]
    assert table.condition == "nine-ball, 12 simulations a decision, sequential tests"
    assert table.breaker is None
    (test,) = table.tests
    (match,) = [match for match in found.matches if match.test]
    assert match.test == SequentialTest(-5, 150, "nelo")
    assert (test.players, test.pairs) == (("new", "old"), 2)
    counts = [0] * 5
    for first, second in match.pairs():
        assert first.points is not None
        assert second.points is not None
        counts[int(2 * (first.points + second.points))] += 1
    assert test.test == SequentialTest(-5, 150, "nelo").state(counts)
    page = report_html(found, title="A", games=False)
    assert "−5 against 150 normalised Elo" in page
    assert reports.tests_of(table)[0]["unit"] == "nelo"


def test_a_report_without_statsmodels_says_so(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reports, "find_spec", lambda _: None)
    found = read_report(folder)
    assert all(table.breaker is None for table in found.tables)
    assert "pip install 'carom[arena]'" in report_html(found, title="A", games=False)


def test_players_of_one_class_have_their_names_in_the_tournament(tmp_path: Path) -> None:
    # Seen: two players called Mine in their records were one player of the report.
    players = [{"name": "new", "player": Loser}, {"name": "old + slow", "player": Loser}]
    event = {"name": "e", "type": "match", "game": "nine-ball", "pairs": 1}
    file = {"format": "carom-tournament/1", "players": players, "events": [event]}
    Tournament(file).run(tmp_path)
    (match,) = read_report(tmp_path).matches
    assert match.players == ("new", "old + slow")


def test_other_settings_have_tables_of_their_own(tmp_path: Path) -> None:
    options: dict[str, Any] = {"game": "nine-ball", "pairs": 1, "noise": carom.Noise.olympiad()}
    other = {"perception": carom.Perception(0.002), "disclosure": "own", "patience": 7}
    carom.play_match(Loser, "greedy:9", out=tmp_path / "a", **options)
    carom.play_match(Loser, "greedy:9", out=tmp_path / "b", **options, **other)
    one, two = (table.condition for table in read_report(tmp_path).tables)
    assert two == f"{one}, perception 2 mm, patience 7, disclosure own"


def test_luck_of_a_real_match_is_in_the_report_and_its_page(tmp_path: Path) -> None:
    result = carom.play_match(
        *("greedy:9", "pool-master:9"), game="nine-ball", pairs=2, luck=8, out=tmp_path
    )
    found = read_report(tmp_path)
    (table,) = found.tables
    adjusted = result.score.adjusted
    assert adjusted is not None
    row = next(row for row in table.rows if row.name == "greedy:9")
    assert row.adjusted == (adjusted.share, *adjusted.share_interval)
    page = report_html(found, title="A")
    assert "corrected for luck" in page
    low, high = (100 * end for end in adjusted.share_interval)
    assert f"<small>{low:.1f} to {high:.1f}</small>" in page.replace("−", "-")
    # The page of a game draws its curve from the luck of the moves.
    (packed,) = re.findall(r'id="match-0">([^<]*)<', page)
    _, *lines = gzip.decompress(base64.b64decode(packed)).decode().split("\n")
    for line in map(json.loads, lines):
        executed = [move for move in line["moves"] if "executed" in move]
        assert executed
        assert all({"before", "expected", "after"} <= move["luck"].keys() for move in executed)


def eventually(condition: Callable[[], object], seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it did not happen in time"
        time.sleep(0.05)


@pytest.mark.skipif(sys.platform == "win32", reason="it sends SIGINT")
def test_watch_writes_the_page_again_when_a_match_is_added(folder: Path, tmp_path: Path) -> None:
    watched, page = tmp_path / "watched", tmp_path / "report.html"
    for name in ("a", "b"):
        (watched / name).mkdir(parents=True)
    record = (folder / "a/match.jsonl").read_text()
    (watched / "a/match.jsonl").write_text(record)
    command = (sys.executable, "-m", "carom", "arena", "report", str(watched))
    with subprocess.Popen(
        [*command, "-o", str(page), "--no-games", "--watch"], stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            eventually(page.exists)
            assert "1 match, 4 frames" in page.read_text()
            # A record that is being written.
            lines = record.split("\n")
            (watched / "b/played.jsonl").write_text("\n".join([*lines[:3], lines[3][:40]]))
            eventually(lambda: "2 matches, 6 frames" in page.read_text())
            assert process.poll() is None
            process.send_signal(signal.SIGINT)
            assert process.wait(timeout=30) == 130
        finally:
            process.kill()
        assert process.stderr is not None
        assert "Traceback" not in process.stderr.read()
