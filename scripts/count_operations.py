"""Counts the engine's tests and solutions in the shots of `carom bench`.

    python scripts/count_operations.py

It stores validation/leckie_greenspan_2006/operations.json, which also has the counts by the method
of the paper's section 3.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from carom.bench import goldens, states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "validation" / "leckie_greenspan_2006" / "operations.json"
PROGRAM = ("cargo", "run", "--quiet", "--release", "-p", "carom-peers", "--example", "operations")


def count(members: list[states.State]) -> dict[str, Any]:
    """The sums over the shots of one class."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "shots.jsonl"
        path.write_text("".join(json.dumps(s.shot_file()) + "\n" for s in members))
        done = subprocess.run(
            [*PROGRAM, "--", path], check=True, cwd=ROOT, stdout=subprocess.PIPE, text=True
        )
    counts: dict[str, Any] = json.loads(done.stdout)
    return counts


def main() -> None:
    """Counts every class and stores the result."""
    stamp = goldens.stamp("python scripts/count_operations.py")
    result = stamp | {"classes": {name: count(shots) for name, shots in states.load().items()}}
    STORED.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
