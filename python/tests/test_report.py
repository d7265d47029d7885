"""Reports: tables of whole folders of matches, and their page."""

from __future__ import annotations

import base64
import csv
import gzip
import json
import re
from pathlib import Path

import carom
import pytest
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
    assert sorted(path.name for path in tables.iterdir()) == [
        "cross.csv",
        "games.csv",
        "losses.csv",
        "players.csv",
    ]
    with (tables / "games.csv").open() as file:
        games = list(csv.DictReader(file))
    assert len(games) == len(json.loads(done.stdout)["games"]) == 8
    assert run("arena", "report", str(folder)).returncode == 2
    assert run("arena", "report", str(tmp_path / "tables"), "--json").returncode == 2
