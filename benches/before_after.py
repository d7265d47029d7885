"""Instructions per shot of an earlier commit and of this one, for the same shots and physics.

    python benches/before_after.py [COMMIT]

The classes are those of ``carom bench``, and 200 random pots. This commit plays them twice: with
the physics that the earlier one had as its default, under its dated name, and with its own
default. The result is ``benches/results/before_after.json``.
"""

from __future__ import annotations

import json
import math
import random
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import callgrind
import carom
from carom.bench import goldens, states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "before_after.json"
#: The last commit before tip, slate and balls were put into one network.
BEFORE = "d43317d"
#: The default physics of that commit, by the name that it has now.
DATED = "pool-2026-11"
#: Additional passes over a class in the second of two runs, whose difference is counted.
PASSES = 4
#: Random pots: their number, and the size of their table and the radius of their balls, m.
POTS = 200
WIDTH, LENGTH, RADIUS = 0.9906, 1.9812, 0.028575


def main() -> int:
    """Counts and stores."""
    if not callgrind.is_installed():
        print("valgrind is not installed, so instructions were not counted: apt install valgrind")
        return 1
    commit = sys.argv[1] if len(sys.argv) > 1 else BEFORE
    classes = {name: [s.shot_file() for s in members] for name, members in states.load().items()}
    classes["random_pot"] = list(random_pots())
    counts: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as folder:
        there = Path(folder) / "before"
        git("worktree", "add", "--quiet", "--detach", str(there), commit)
        try:
            before = callgrind.build("carom", "bench_shots", there)
            after = callgrind.build("carom", "bench_shots")
            for name, shots in classes.items():
                plain = write(shots, Path(folder) / "plain")
                dated = write((s | {"physics": DATED} for s in shots), Path(folder) / "dated")
                counts[name] = {
                    "before": count(before, plain),
                    "after": count(after, dated),
                    "after_default": count(after, plain),
                }
                print(name, counts[name], flush=True)
        finally:
            git("worktree", "remove", "--force", str(there))
    stamp = goldens.stamp("python benches/before_after.py")
    result = stamp | {"before": commit, "classes": counts}
    STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


def git(*words: str) -> None:
    """Runs git in the checkout."""
    subprocess.run(["git", *words], cwd=ROOT, check=True)


def write(shots: Iterable[dict[str, Any]], path: Path) -> Path:
    """Writes shot files, one in a line; returns `path`."""
    path.write_text("".join(json.dumps(shot) + "\n" for shot in shots), encoding="utf-8")
    return path


def count(program: Path, shots: Path) -> dict[str, float]:
    """Mean instructions and events per shot."""
    once, _ = callgrind.count(program, shots, 1)
    more, printed = callgrind.count(program, shots, 1 + PASSES)
    played, events = map(int, printed.split())
    return {"instructions": round((more - once) / PASSES / played), "events": events / played}


def random_pots() -> Iterable[dict[str, Any]]:
    """Straight and cut pots of one ball at 1.5 to 4 m/s, with follow, stun and draw."""
    rng = random.Random(5)
    # Between the points of each mouth, roughly: the aim decides only which shots are taken.
    mouths = [(x, y) for x in (0.0, WIDTH) for y in (0.0, LENGTH / 2, LENGTH)]
    taken = 0
    while taken < POTS:
        (cue, ball), mouth = (place(rng) for _ in range(2)), rng.choice(mouths)
        along = direction(ball, mouth)
        ghost = (ball[0] - 2 * RADIUS * along[0], ball[1] - 2 * RADIUS * along[1])
        aim = direction(cue, ghost)
        if math.dist(cue, ghost) < 0.15 or aim[0] * along[0] + aim[1] * along[1] < 0.7:
            continue
        strike = {
            "ball": "cue",
            "speed": rng.uniform(1.5, 4.0),
            "azimuth_deg": math.degrees(math.atan2(aim[1], aim[0])),
            "elevation_deg": 0.0,
            "height": rng.uniform(-0.3, 0.3),
        }
        balls = [{"id": "cue", "position": cue}, {"id": "1", "position": ball}]
        shot = {"format": "carom-shot/1", "table": "showood-7ft", "balls": balls, "strike": strike}
        if carom.Shot.from_dict(shot).simulate().outcome.pocketed:
            taken += 1
            yield shot


def place(rng: random.Random) -> list[float]:
    """A place on the cloth, m."""
    return [rng.uniform(0.1, WIDTH - 0.1), rng.uniform(0.1, LENGTH - 0.1)]


def direction(start: Iterable[float], end: Iterable[float]) -> tuple[float, float]:
    """The unit vector from a place to another."""
    dx, dy = (b - a for a, b in zip(start, end, strict=True))
    length = math.hypot(dx, dy)
    return dx / length, dy / length


if __name__ == "__main__":
    sys.exit(main())
