"""Makes the list of puzzles: which numbers of each theme give a good one, and how hard it is.

    python scripts/puzzles.py            # go on, or begin again if the physics changed
    python scripts/puzzles.py --write    # only write the engine's list from the stored result

A puzzle is accepted if it has a solution, is neither too easy nor too hard, and is not ambiguous
(`carom_drill::puzzle`). The result is stored in benches/results/puzzles.json, with the chances of
each level and the numbers that were rejected, by reason. After every hundred numbers it is written;
a stopped run continues. At the end the engine's list, accepted.txt, is written from it.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import sys
from collections import Counter
from pathlib import Path
from typing import Any

from carom import _core
from carom.bench import goldens

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "benches" / "results" / "puzzles.json"
LIST = ROOT / "crates" / "carom-drill" / "src" / "puzzle" / "accepted.txt"

#: Puzzles of each theme, at least.
WANTED = 160

#: Numbers that are tried between two writings.
PART = 100

#: Processes. The result does not depend on it.
PROCESSES = 2


def tried(task: tuple[str, int]) -> tuple[int, str | list[float]]:
    """A number of a theme, with the reason of its rejection, or with its rating and chances."""
    theme, number = task
    made = _core.make_puzzle(theme, number)
    if isinstance(made, str):
        return number, made
    return number, [made["rating"], *made["chances"].values()]


def fresh() -> dict[str, Any]:
    """A result without puzzles."""
    stored = goldens.stamp("python scripts/puzzles.py")
    return {**stored, "per_theme": WANTED, "themes": {}}


def read() -> dict[str, Any]:
    """The stored result, if the engine still gives it; else a new one."""
    if not OUT.is_file():
        return fresh()
    stored: dict[str, Any] = json.loads(OUT.read_text(encoding="utf-8"))
    return fresh() if goldens.changed(stored) else stored


def write(result: dict[str, Any]) -> None:
    """Stores the result, a line for each theme."""
    themes = [
        f"{json.dumps(name)}: {json.dumps(theme)}" for name, theme in result["themes"].items()
    ]
    head = json.dumps({**result, "themes": None}, indent=1)
    text = head.replace('"themes": null', '"themes": {\n' + ",\n".join(themes) + "\n}")
    OUT.write_text(text + "\n", encoding="utf-8")


def write_list(result: dict[str, Any]) -> None:
    """Writes the engine's list."""
    lines = [
        " ".join(
            [name, *(f"{number}:{round(rating / 10)}" for number, rating, *_ in theme["puzzles"])]
        )
        for name, theme in result["themes"].items()
    ]
    LIST.write_text("\n".join(lines) + "\n", encoding="utf-8")


def make(result: dict[str, Any]) -> None:
    """Adds puzzles to the result until every theme has enough."""
    with multiprocessing.Pool(PROCESSES) as pool:
        for name in _core.puzzle_themes():
            empty = {"tried": 0, "rejected": {}, "puzzles": []}
            theme = result["themes"].setdefault(name, empty)
            while len(theme["puzzles"]) < WANTED:
                first = theme["tried"]
                part = pool.map(tried, [(name, first + k) for k in range(PART)], chunksize=5)
                add(theme, part)
                write(result)
                print(f"{name}: {len(theme['puzzles'])} of {theme['tried']}", file=sys.stderr)


def add(theme: dict[str, Any], part: list[tuple[int, str | list[float]]]) -> None:
    """Adds numbers that were tried, until the theme has enough puzzles."""
    rejected = Counter(theme["rejected"])
    for number, found in part:
        if len(theme["puzzles"]) == WANTED:
            break
        theme["tried"] = number + 1
        if isinstance(found, str):
            rejected[found] += 1
        else:
            theme["puzzles"].append([number, *(round(value, 4) for value in found)])
    theme["rejected"] = dict(sorted(rejected.items()))


def main() -> int:
    """Runs the command."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--write", action="store_true", help="only write the engine's list")
    options = parser.parse_args()
    result = read()
    if not options.write:
        make(result)
    write_list(result)
    return 0


if __name__ == "__main__":
    sys.exit(main())
