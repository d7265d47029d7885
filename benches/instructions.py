"""Instructions, missed branches and missed code per shot, counted by valgrind's callgrind.

Times on a shared machine vary by tens of per cent; these counts do not vary. They are stored in
``benches/results/instructions.json`` and compared with those of the last commit: after a change of
the engine run this (`make bench` does), look at the difference, and commit the file with the
change. Counts are compared only for classes whose states have not changed.

The counts are those of the processor that valgrind emulates, which has AVX2 at most.
"""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import callgrind
from carom.bench import report, states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "instructions.json"
#: Additional passes over a class in the second run. The difference between the two runs contains
#: neither the program's start nor parsing nor the first touch of memory.
PASSES = 3


def main() -> int:
    """Counts, compares and stores."""
    if not callgrind.is_installed():
        print("valgrind is not installed, so instructions were not counted: apt install valgrind")
        return 0
    program = callgrind.build("carom", "bench_shots")
    with tempfile.TemporaryDirectory() as folder:
        classes = {
            name: count(program, callgrind.write(members, Path(folder) / name))
            for name, members in states.load().items()
        }
    compare(classes, of_last_commit())
    STORED.parent.mkdir(parents=True, exist_ok=True)
    result = report.where() | {"classes": classes}
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def count(program: Path, shots: Path) -> dict[str, Any]:
    """Mean instructions per shot and per event of the shots in a file."""
    once, _, _ = run(program, shots, 1)
    more, played, events = run(program, shots, 1 + PASSES)
    total = (more - once) / PASSES
    return {
        "instructions_per_shot": round(total / played),
        "instructions_per_event": round(total / events),
        "events_per_shot": events / played,
        **missed(program, shots, played),
        "states": hashlib.sha256(shots.read_bytes()).hexdigest()[:16],
    }


def missed(program: Path, shots: Path, played: int) -> dict[str, dict[str, int]]:
    """Misses per shot: of shots each after another one, and each after itself."""
    once = callgrind.misses(program, shots, 1, 1)

    def more(passes: int, repeats: int) -> dict[str, int]:
        most = callgrind.misses(program, shots, passes, repeats)
        branches, cache = (
            round((b - a) / PASSES / played) for a, b in zip(once, most, strict=True)
        )
        return {"branch_misses_per_shot": branches, "instruction_cache_misses_per_shot": cache}

    return {"in_turn": more(1 + PASSES, 1), "repeated": more(1, 1 + PASSES)}


def run(program: Path, shots: Path, passes: int) -> tuple[int, int, int]:
    """Instructions of the whole program, and the shots and events of one pass."""
    instructions, printed = callgrind.count(program, shots, passes)
    played, events = map(int, printed.split())
    return instructions, played, events


def of_last_commit() -> dict[str, Any]:
    """The classes that the last commit has stored; empty without any."""
    name = STORED.relative_to(ROOT).as_posix()
    command = ["git", "-C", str(ROOT), "show", f"HEAD:{name}"]
    try:
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    except (OSError, subprocess.CalledProcessError):
        if not STORED.is_file():
            return {}
        text = STORED.read_text(encoding="utf-8")
    classes: dict[str, Any] = json.loads(text)["classes"]
    return classes


def compare(counts: dict[str, Any], before: dict[str, Any]) -> None:
    """Prints the counts and their change since the last commit."""
    print(f"{'instructions':32}{'per shot':>12}{'per event':>12}{'last commit':>14}{'change':>9}")
    for name, now in counts.items():
        line = f"{states.CLASSES[name]:32}{now['instructions_per_shot']:12,}"
        line += f"{now['instructions_per_event']:12,}"
        then = before.get(name)
        if then is None:
            line += "    not stored"
        elif then["states"] != now["states"]:
            line += "    other states"
        else:
            change = 100 * (now["instructions_per_shot"] / then["instructions_per_shot"] - 1)
            line += f"{then['instructions_per_shot']:14,}{change:+8.2f}%"
        print(line)
    print()
    print(f"{'misses per shot':32}{'branches, in turn':>20}{'repeated':>10}", end="")
    print(f"{'code cache, in turn':>22}{'repeated':>10}")
    for name, now in counts.items():
        print(f"{states.CLASSES[name]:32}", end="")
        for key, width in (
            ("branch_misses_per_shot", 20),
            ("instruction_cache_misses_per_shot", 22),
        ):
            print(f"{now['in_turn'][key]:{width},}{now['repeated'][key]:10,}", end="")
        print()


if __name__ == "__main__":
    sys.exit(main())
