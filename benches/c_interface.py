"""A batch through C beside the same in Rust, and what a game pays for pictures and objects.

    python benches/c_interface.py

`crates/carom-c/examples/interface_costs.rs` measures it, with ``shots/side_pocket_cut.json``: so
few balls that the interface has its largest share. The result is stored in
``benches/results/c_interface.json``.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from carom.bench import report

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "c_interface.json"
SHOT = ROOT / "shots" / "side_pocket_cut.json"
#: The most that a batch may take longer through C, percent.
BAR = 2.0
#: Number of rounds in turns. The fastest counts: other work on the machine slowed the others.
ROUNDS = 15


def main() -> int:
    """Measures, prints and stores."""
    command = ["cargo", "run", "--quiet", "--release", "-p", "carom-c", "--example"]
    command += ["interface_costs", "--", str(SHOT), str(ROUNDS)]
    printed = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    result: dict[str, Any] = report.where() | {"rounds": ROUNDS} | json.loads(printed.stdout)
    print(json.dumps(result, indent=2))
    batch = result["batch"]
    worst = max(batch[row]["more_percent"] for row in ("strikes_of_a_shot", "many_shots"))
    print(f"bar: {BAR:g} % more through C; measured {worst:.2f} %")
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0 if worst <= BAR else 1


if __name__ == "__main__":
    sys.exit(main())
