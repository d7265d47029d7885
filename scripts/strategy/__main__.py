"""The experiments of docs/strategy.md: matches between players, and visits to the table.

    python scripts/strategy --list             # the experiments, and which are stored
    python scripts/strategy NAME ...           # make these; a part of a name is enough
    python scripts/strategy --threads 2 NAME ...

What is played is stored as it comes, under ``out/strategy``, and a run that was stopped continues
there. A complete experiment is summarised in ``benches/results/strategy/NAME.json``, from which
``benches/tables.py`` makes the tables of the page. Racks, errors and decisions depend on the name of the
experiment alone, so every result can be made again to the bit.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path

from carom.bench import goldens
from experiments import EXPERIMENTS

ROOT = Path(__file__).resolve().parents[2]
PLAYED = ROOT / "out" / "strategy"
STORED = ROOT / "benches" / "results" / "strategy"


def main() -> int:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("names", nargs="*", help="experiments, or parts of their names")
    parser.add_argument("--list", action="store_true", help="print the experiments")
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="number of threads")
    arguments = parser.parse_args()
    chosen = {
        name: experiment
        for name, experiment in EXPERIMENTS.items()
        if any(part in name for part in arguments.names or [""])
    }
    if not chosen:
        parser.error(f"there is no experiment {', '.join(arguments.names)}; see --list")
    if arguments.list or not arguments.names:
        for name, experiment in chosen.items():
            print(f"{state(name):8}  {name:36}  {experiment.describe()}")
        return 0
    STORED.mkdir(parents=True, exist_ok=True)
    for name, experiment in chosen.items():
        result = experiment.play(name, PLAYED / name, arguments.threads)
        stored = goldens.stamp(f"python scripts/strategy {name}") | {"name": name} | result
        path = STORED / f"{name}.json"
        path.write_text(json.dumps(stored, indent=1) + "\n", encoding="utf-8")
        print(f"{name}: {json.dumps(result)}", flush=True)
    return 0


def state(name: str) -> str:
    """Whether the result of an experiment is stored."""
    path = STORED / f"{name}.json"
    if not path.is_file():
        return "-"
    return "old" if goldens.changed(json.loads(path.read_text("utf-8"))) else "stored"


if __name__ == "__main__":
    sys.exit(main())
