"""Makes the stored results again that are older than the engine's physics.

    python scripts/experiments.py            # those whose goldens have changed, and unfinished ones
    python scripts/experiments.py --list     # print which are older, and run nothing
    python scripts/experiments.py --all      # all of them
    python scripts/experiments.py NAME …     # these

`make experiments` calls it without arguments. A result is older if the hash of an example shot in
goldens/shots.json differs from the one that is stored with it (`carom.bench.goldens`). All runs
together take about half an hour of one core. The long ones write what they have, and continue
when they are started again. Afterwards the tables of the pages and the figures are made again.

To add a result: store it with `carom.bench.goldens.stamp`, and add a line to `EXPERIMENTS`.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from carom.bench import goldens

ROOT = Path(__file__).resolve().parents[1]
PAPER = ROOT / "validation" / "leckie_greenspan_2006"


@dataclass(frozen=True)
class Experiment:
    """A stored result that depends on the engine's physics."""

    name: str
    file: Path
    #: The arguments of Python that make it.
    command: tuple[str, ...]

    def outdated(self) -> str | None:
        """Why it has to be made again; None if it need not."""
        if not self.file.is_file():
            return "there is no stored result"
        stored: dict[str, Any] = json.loads(self.file.read_text(encoding="utf-8"))
        changed = goldens.changed(stored)
        if changed:
            return f"these example shots have other results now: {', '.join(changed)}"
        return None if is_complete(stored) else "its run was stopped before the end"


EXPERIMENTS = (
    Experiment("operations", PAPER / "operations.json", ("scripts/count_operations.py",)),
    Experiment("operation-kinds", PAPER / "operation_kinds.json", ("benches/operation_kinds.py",)),
    Experiment("fixed-step", PAPER / "fixed_step.json", ("scripts/fixed_step_errors.py",)),
    Experiment("root-finders", PAPER / "root_finders.json", ("scripts/root_finders.py",)),
    Experiment(
        "realism",
        ROOT / "benches" / "results" / "realism.json",
        ("scripts/realism_figures.py", "--before", "2026-11"),
    ),
    Experiment("puzzles", ROOT / "benches" / "results" / "puzzles.json", ("scripts/puzzles.py",)),
)

#: What shows the results: the tables of the pages, and the paper's figure.
SHOWN = (
    ("benches/tables.py", "--write"),
    ("scripts/validation_gallery.py", "--figures", PAPER.name),
)


def is_complete(stored: dict[str, Any]) -> bool:
    """Whether a run that writes what it has was not stopped."""
    finders = stored.get("finders", [])
    shots = stored.get("shots", [])
    themes = stored.get("themes", {}).values()
    if any(len(theme["puzzles"]) < stored["per_theme"] for theme in themes):
        return False
    return all(f["shots"] == f["wanted"] for f in finders) and (
        "wanted" not in stored or len(shots) == stored["wanted"]
    )


def main() -> int:
    """Reads the command line and makes the results again."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    known = [experiment.name for experiment in EXPERIMENTS]
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(known)}")
    parser.add_argument("--all", action="store_true", help="make all results again")
    parser.add_argument("--list", action="store_true", help="print the older ones, run nothing")
    options = parser.parse_args()
    for name in options.names:
        if name not in known:
            parser.error(f"there is no experiment {name!r}; there are {', '.join(known)}")
    wanted = [e for e in EXPERIMENTS if not options.names or e.name in options.names]
    made = False
    for experiment in wanted:
        reason = "wanted" if options.all or options.names else experiment.outdated()
        if reason is None:
            continue
        print(f"{experiment.name}: {reason}", file=sys.stderr)
        if not options.list:
            run(*experiment.command)
            made = True
    if made:
        for command in SHOWN:
            run(*command)
    return 0


def run(*command: str) -> None:
    """Runs a script of the project; an error ends this program."""
    subprocess.run([sys.executable, *command], check=True, cwd=ROOT)


if __name__ == "__main__":
    sys.exit(main())
