"""Stores the standing table of the built-in players, from the folder of ``carom arena ladder``.

    carom arena ladder --out ladder
    python benches/ladder.py ladder             # writes benches/results/ladder.json
    python benches/tables.py --write            # writes the tables of docs/ladder.md

Store it in the checkout that played it: the result has the commit and the goldens of the checkout.
``--commit`` names another commit of the same goldens.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from carom.arena import ratings
from carom.arena.sequential import rating
from carom.arena.tournament_folder import RECORD, TournamentFolder
from carom.arena.tournament_result import TournamentResult
from carom.bench import goldens, report
from carom.files import write_whole

JSON = dict[str, Any]
STORE = Path(__file__).resolve().parent / "results" / "ladder.json"
#: The noises of the table, by their names in its file.
NOISES = {"olympiad:0.5": "× 0.5", "olympiad": "× 1", "olympiad:2": "× 2"}


def main() -> None:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="the folder of `carom arena ladder`")
    parser.add_argument("--commit", help="the commit that played it, if it is not the checkout's")
    parser.add_argument("--threads", type=int, default=2, help="matches that were played at once")
    arguments = parser.parse_args()
    found = result(arguments.folder, arguments.threads)
    if arguments.commit is not None:
        found["commit"] = arguments.commit
    write_whole(STORE, json.dumps(found, indent=1, ensure_ascii=False) + "\n")
    print(f"{STORE}: {found['pairs']} of {found['planned_pairs']} pairs")


def result(root: Path, threads: int) -> JSON:
    """The stored result of a folder, whose tournament may go on."""
    folder = TournamentFolder.read(root)
    state = TournamentResult.read(folder)
    settings = {
        condition.title: condition.settings
        for event in folder.events
        for condition in event.conditions
    }
    tables = []
    for table in ratings(root):
        condition = settings[table.condition]
        tables.append(
            {"game": condition["game"], "noise": condition["noise"], **rounded(table.to_dict())}
        )
    return {
        **goldens.stamp(f"carom arena ladder --out ladder --threads {threads}"),
        "machine": report.where()["machine"],
        "threads": threads,
        "hours": hours(root),
        "planned_pairs": sum(each.event.pairs for each in folder.encounters()),
        "pairs": state.pairs,
        "finished": state.finished,
        "tables": tables,
    }


def rounded(value: Any) -> Any:
    """Plain values whose numbers have four digits behind the point."""
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    if isinstance(value, list):
        return [rounded(item) for item in value]
    return round(value, 4) if isinstance(value, float) else value


def hours(root: Path) -> float:
    """Time from the end of the first match to the end of the last one, h; with all stops."""
    times = [path.stat().st_mtime for path in root.rglob(RECORD)]
    return round((max(times) - min(times)) / 3600, 2)


def strengths(found: JSON, game: str) -> list[list[str]]:
    """The ratings and shares of all players of a game, for each noise."""
    tables = {table["noise"]: table for table in found["tables"] if table["game"] == game}
    noises = [noise for noise in NOISES if noise in tables]
    head = ["Player"]
    for noise in noises:
        head += [f"Elo, noise {NOISES[noise]}", "points, %"]
    names = [row["player"] for row in tables[noises[len(noises) // 2]]["players"]]
    lines = [head]
    for name in names:
        cells = [f"`{name}`"]
        for noise in noises:
            row = next((row for row in tables[noise]["players"] if row["player"] == name), None)
            cells += ["", ""] if row is None else [rated(row), f"{100 * row['share']:.0f}"]
        lines.append(cells)
    cells = ["the player who begins"]
    for noise in noises:
        elo, low, high = tables[noise]["breaker"]
        cells += [rated({"elo": elo, "interval": [low, high]}), ""]
    return [*lines, cells]


def other_games(found: JSON) -> list[list[str]]:
    """The ratings of three players in the other games, for each noise."""
    tables = [table for table in found["tables"] if table["game"] != "eight-ball"]
    names = sorted({row["player"] for table in tables for row in table["players"]})
    lines = [["Game", "noise", "pairs", *(f"`{name}`, Elo" for name in names), "begins, Elo"]]
    for table in tables:
        rows = {row["player"]: row for row in table["players"]}
        cells = [table["game"], NOISES[table["noise"]], str(table["pairs"])]
        cells += [rated(rows[name]) if name in rows else "" for name in names]
        elo, low, high = table["breaker"]
        lines.append([*cells, rated({"elo": elo, "interval": [low, high]})])
    return lines


def made(found: JSON) -> list[list[str]]:
    """How the table was made."""
    pairs = f"{found['pairs']}"
    if not found["finished"]:
        pairs += f" of {found['planned_pairs']}"
    machine = found["machine"]
    place = f"{found['threads']} threads, {machine['processor']}, {machine['cores']} cores"
    time = f"{found['hours']:.1f} h"
    return [
        ["Made by", "commit", "date", "pairs", "time", "on"],
        [f"`{found['command']}`", found["commit"], found["date"], pairs, time, place],
    ]


def rated(row: JSON) -> str:
    """A rating with its interval."""
    elo, low, high = map(rating, (row["elo"], *row["interval"]))
    return f"{elo} ({low} to {high})".replace("-", "−")


#: The tables of benches/results/ladder.json.
TABLES = {
    "ladder-eight-ball": lambda found: strengths(found, "eight-ball"),
    "ladder-games": other_games,
    "ladder-made": made,
}


if __name__ == "__main__":
    main()
