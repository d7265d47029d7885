"""``carom arena report``: a page about the matches in a folder."""

from __future__ import annotations

import csv
import io
import json as js
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from carom.arena.report import (
    Report,
    breaker_of,
    cross_of,
    games_of,
    players_of,
    read_report,
    tests_of,
)
from carom.arena.report_page import report_html
from carom.cli.options import Json, Level
from carom.cli.output import emit, say
from carom.errors import InputError
from carom.files import shown, write_whole

# Seconds between two looks at the records with --watch.
_LOOK = 2.0


def report(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="Folder of a match or of a tournament.")
    ],
    out: Annotated[
        Path | None, typer.Option("--out", "-o", metavar="FILE.html", help="Write the page.")
    ] = None,
    tables: Annotated[
        Path | None,
        typer.Option("--csv", metavar="DIR", help="Write the tables as CSV into this folder."),
    ] = None,
    games: Annotated[
        bool,
        typer.Option(
            "--games/--no-games",
            help="Whether the page has the games; a frame takes about 8 kB.",
        ),
    ] = True,
    watch: Annotated[
        bool, typer.Option("--watch", help="Write it again when a record changes, until Ctrl-C.")
    ] = False,
    level: Level = 0.95,
    json: Json = False,
) -> None:
    """Write a page about all matches in a folder: tables, and every game to look at.

    The matches may go on. The page is one file that needs neither a server nor a network.
    """
    if out is None and tables is None and not json:
        raise InputError(
            "missing",
            "--out",
            "there is nothing to write",
            "give -o FILE.html, --csv DIR or --json",
        )
    if watch and out is None:
        raise InputError("missing", "--out", "--watch writes a page", "give -o FILE.html")
    seen = _stamp(folder)
    _write(folder, out, tables, level, games=games, json=json)
    while watch:
        time.sleep(_LOOK)
        now = _stamp(folder)
        if now == seen:
            continue
        seen = now
        _write(folder, out, tables, level, games=games, json=False)


def _write(
    folder: Path, out: Path | None, tables: Path | None, level: float, *, games: bool, json: bool
) -> None:
    found = read_report(folder, level=level)
    if out is not None:
        title = f"Matches in {folder.resolve().name}"
        write_whole(out, report_html(found, title=title, games=games))
        say(f"{shown(out)}: {found}")
    if tables is not None:
        tables.mkdir(parents=True, exist_ok=True)
        for name, text in csv_tables(found).items():
            write_whole(tables / f"{name}.csv", text)
    if json:
        emit(js.dumps(found.to_dict()))


def csv_tables(found: Report) -> dict[str, str]:
    """The tables of a report as CSV, by name."""
    players = [
        {"condition": table.condition, **row} for table in found.tables for row in players_of(table)
    ]
    reasons = [
        {"condition": row["condition"], "player": row["player"], "reason": reason, "frames": count}
        for row in players
        for reason, count in row["losses"].items()
    ]
    plain = [{key: row[key] for key in row if key != "losses"} for row in players]
    cross = [
        {"condition": table.condition, **row} for table in found.tables for row in cross_of(table)
    ]
    breakers = [{"condition": table.condition, **breaker_of(table)} for table in found.tables]
    tests = [
        {"condition": table.condition, **row} for table in found.tables for row in tests_of(table)
    ]
    rows = {
        "players": plain,
        "breaker": breakers,
        "cross": cross,
        "losses": reasons,
        "tests": tests,
        "games": games_of(found),
    }
    return {name: _csv(table) for name, table in rows.items()}


def _csv(rows: Sequence[dict[str, Any]]) -> str:
    out = io.StringIO()
    if rows:
        writer = csv.DictWriter(out, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return out.getvalue()


def _stamp(folder: Path) -> list[tuple[str, int, int]]:
    """What changes when a record changes."""
    found = []
    for path in sorted(folder.rglob("*.jsonl")):
        try:
            stat = path.stat()
        except FileNotFoundError:
            # A match that ends removes the file of its frames.
            continue
        found.append((str(path), stat.st_mtime_ns, stat.st_size))
    return found
