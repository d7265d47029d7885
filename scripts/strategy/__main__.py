"""The experiments of docs/strategy.md: matches between players, and visits to the table.

    python scripts/strategy --list             # the experiments, and which are stored
    python scripts/strategy NAME ...           # make these; a part of a name is enough
    python scripts/strategy --threads 2 NAME ...

What is played is stored as it comes, under ``out/strategy/VERSION``, and a run that was stopped
continues there. VERSION is a hash of the example shots and of the crates that decide, so that
players of different versions are never mixed. A complete experiment is summarised in
``benches/results/strategy.json``, from which ``benches/tables.py`` makes the tables of the page.
Racks, errors and decisions depend on the name of the experiment alone, so every result without a
clock can be made again to the bit.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from carom.bench import goldens
from catalogue import EXPERIMENTS

ROOT = Path(__file__).resolve().parents[2]
PLAYED = ROOT / "out" / "strategy"
STORED = ROOT / "benches" / "results" / "strategy.json"
#: The crates on which a decision and its outcome depend, besides the physics.
DECIDING = ("carom-rules", "carom-plan", "carom-mind", "carom-arena")


def main() -> int:
    """Reads the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", help="experiments, or parts of their names")
    parser.add_argument("--list", action="store_true", help="print the experiments")
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="number of threads")
    arguments = parser.parse_args()
    chosen = {
        name: experiment
        for name, experiment in EXPERIMENTS.items()
        if any(
            name == wanted or (wanted not in EXPERIMENTS and wanted in name)
            for wanted in arguments.names or [""]
        )
    }
    if not chosen:
        parser.error(f"there is no experiment {', '.join(arguments.names)}; see --list")
    if arguments.list or not arguments.names:
        for name, experiment in chosen.items():
            made = stored()["experiments"].get(name, {}).get("commit", "-")
            print(f"{made:10}  {name:36}  {experiment.describe()}")
        return 0
    for name, experiment in chosen.items():
        store(name, experiment.play(name, PLAYED / version() / name, arguments.threads))
    return 0


def version() -> str:
    """A hash of the example shots, and of the sources that are committed of the deciding crates."""
    command = ["git", "rev-parse", *(f"HEAD:crates/{crate}" for crate in DECIDING)]
    found = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    shots = json.dumps(goldens.hashes(), sort_keys=True)
    return hashlib.sha256((shots + found.stdout).encode()).hexdigest()[:10]


def stored() -> dict[str, Any]:
    """All stored results."""
    if not STORED.is_file():
        return {"experiments": {}}
    return json.loads(STORED.read_text("utf-8"))


def store(name: str, result: dict[str, Any]) -> None:
    """Adds the result of an experiment to the stored ones, or replaces it."""
    stamp = goldens.stamp("python scripts/strategy NAME")
    made = {"commit": stamp["commit"], "date": stamp["date"]}
    experiments = stored()["experiments"] | {name: made | result}
    whole = stamp | {"experiments": dict(sorted(experiments.items()))}
    STORED.write_text(json.dumps(whole, indent=1) + "\n", encoding="utf-8")
    print(f"{name}: {json.dumps(result)}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
