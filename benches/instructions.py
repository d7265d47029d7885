"""Instructions per shot and per event, counted by valgrind's callgrind.

Times on a shared machine vary by tens of per cent; these counts do so by nothing. They are kept
in ``benches/results/instructions.json``, next to what the last commit has there: run this after a
change (`make bench` does), look at the difference, and commit the file with the change.

The counts are those of the processor that valgrind presents: AVX2 at most.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import callgrind
from carom.bench import states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "instructions.json"
#: A class is played this often in a second run, once in a first: the difference is free of
#: start, parsing and the first touch of memory.
PASSES = 3


def main() -> int:
    """Counts, compares, stores."""
    if not callgrind.is_installed():
        print("valgrind is not installed, so instructions were not counted: apt install valgrind")
        return 0
    program = callgrind.build("carom", "bench_shots")
    with tempfile.TemporaryDirectory() as folder:
        counts = {
            name: count(program, callgrind.write(members, Path(folder) / name))
            for name, members in states.load().items()
        }
    compare(counts, last_commits())
    STORED.parent.mkdir(parents=True, exist_ok=True)
    STORED.write_text(json.dumps(counts, indent=2) + "\n", encoding="utf-8")
    return 0


def count(program: Path, shots: Path) -> dict[str, float]:
    """Mean instructions per shot and per event of the shots in a file."""
    once, _, _ = passed(program, shots, 1)
    more, played, events = passed(program, shots, 1 + PASSES)
    total = (more - once) / PASSES
    return {
        "instructions_per_shot": round(total / played),
        "instructions_per_event": round(total / events),
        "events_per_shot": events / played,
    }


def passed(program: Path, shots: Path, passes: int) -> tuple[int, int, int]:
    """Instructions of the whole program; shots and events of one pass."""
    instructions, printed = callgrind.count(program, shots, passes)
    played, events = map(int, printed.split())
    return instructions, played, events


def last_commits() -> dict[str, Any]:
    """What the last commit has stored; nothing where there is none."""
    name = STORED.relative_to(ROOT).as_posix()
    command = ["git", "-C", str(ROOT), "show", f"HEAD:{name}"]
    try:
        shown = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
    return json.loads(shown)


def compare(counts: dict[str, Any], before: dict[str, Any]) -> None:
    """Prints the counts and how they differ from the stored ones."""
    print(f"{'instructions':32}{'per shot':>12}{'per event':>12}{'last commit':>14}{'change':>9}")
    for name, now in counts.items():
        line = f"{states.CLASSES[name]:32}{now['instructions_per_shot']:12,}"
        line += f"{now['instructions_per_event']:12,}"
        if name in before:
            then = before[name]["instructions_per_shot"]
            change = 100 * (now["instructions_per_shot"] / then - 1)
            line += f"{then:14,}{change:+8.2f}%"
        print(line)


if __name__ == "__main__":
    sys.exit(main())
