"""Random shots with each root finder in the event loop: how many results are impossible.

    python scripts/root_finders.py [--shots 100000] [--threads 1] [--timed 200]

It stores validation/leckie_greenspan_2006/root_finders.json: for every finder, rule and family of
shots the number of shots by the kind of their first fault, as the judge of whole shots
(crates/carom-check) finds it. 100 000 shots take about six minutes of one core.

The counts are written after every few thousand shots. If the run is stopped, the same command
continues it; it begins again if the program, the goldens or the number of shots has changed.
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

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "validation" / "leckie_greenspan_2006" / "root_finders.json"
BUILD = ("cargo", "build", "--quiet", "--release", "-p", "carom-peers", "--example", "root_finders")
PROGRAM = ROOT / "target" / "release" / "examples" / "root_finders"
#: Shots between two writes; and where many shots run until the limit of events.
CHUNK, SLOW_CHUNK = 5000, 200

JSON = dict[str, Any]


def main() -> int:
    """Checks what is not stored yet."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--shots", type=int, default=100_000, help="shots of most finders")
    parser.add_argument("--threads", type=int, default=0, help="threads; 0: all cores")
    parser.add_argument("--timed", type=int, default=0, help="time this many shots of each finder")
    options = parser.parse_args()
    os.environ["RAYON_NUM_THREADS"] = str(options.threads)
    subprocess.run(BUILD, check=True, cwd=ROOT)
    command = "python scripts/root_finders.py"
    if options.shots != parser.get_default("shots"):
        command += f" --shots {options.shots}"
    result = begun(goldens.stamp(command), options.shots)
    for finder in result["finders"]:
        while finder["shots"] < finder["wanted"]:
            check(finder)
            write(result)
        print(f"{names(finder)}: {finder['impossible']}", file=sys.stderr)
        if options.timed:
            words = ("time", *names(finder), min(options.timed, finder["wanted"]))
            finder["microseconds_per_shot"] = json.loads(answer(*words))
            write(result)
    return 0


def begun(stamp: JSON, shots: int) -> JSON:
    """The stored result if this run continues it, otherwise an empty one."""
    program = hashlib.sha256(PROGRAM.read_bytes()).hexdigest()[:16]
    new = stamp | {"program": program, "finders": [empty(f, shots) for f in listed()]}
    if not STORED.is_file():
        return new
    old: JSON = json.loads(STORED.read_text(encoding="utf-8"))
    same = ("program", "goldens", "command")
    wanted = [f.get("wanted") for f in old["finders"]] == [f["wanted"] for f in new["finders"]]
    return old if wanted and all(old.get(key) == new[key] for key in same) else new


def listed() -> list[JSON]:
    """The finders, rules and families that the program has."""
    return [json.loads(line) for line in answer("list").splitlines()]


def empty(finder: JSON, shots: int) -> JSON:
    """A finder without a checked shot."""
    wanted = max(shots // finder.pop("share"), 1)
    return finder | {"wanted": wanted, "shots": 0, "impossible": {}, "first_faults": {}}


def check(finder: JSON) -> None:
    """Checks the next shots of a finder and adds the counts."""
    size = SLOW_CHUNK if finder["reading"] == "smallest positive root" else CHUNK
    first = finder["shots"]
    found = json.loads(answer("check", *names(finder), first, min(size, finder["wanted"] - first)))
    finder["shots"] += found["shots"]
    for limit, kinds in found["first_faults"].items():
        sums = finder["first_faults"].setdefault(limit, {})
        for kind, count in kinds.items():
            sums[kind] = sums.get(kind, 0) + count
        finder["impossible"][limit] = sum(sums.values())


def names(finder: JSON) -> tuple[str, str, str]:
    """The words that name a finder for the program."""
    return finder["family"], finder["method"], finder["reading"]


def answer(*words: object) -> str:
    """What the program prints."""
    command = [PROGRAM, *map(str, words)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def write(result: JSON) -> None:
    """Replaces the stored file at once, so that a stopped run leaves a whole one."""
    part = STORED.with_suffix(".part")
    part.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    part.replace(STORED)


if __name__ == "__main__":
    sys.exit(main())
