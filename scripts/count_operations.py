"""Counts what the engine looks at and solves in the shots that are timed.

    python scripts/count_operations.py

stores validation/leckie_greenspan_2006/operations.json, beside the counts of the paper's section 3.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from carom.bench import states

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
    """Counts and stores."""
    classes = {name: count(members) for name, members in states.load().items()}
    result = {"command": "python scripts/count_operations.py", "classes": classes}
    STORED.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
