"""Times of `evaluate`, `solve`, maps and tables.

    python benches/questions.py

`evaluate` runs with 10 000 variants of every mid-game shot of `carom bench`, with the Computational
Olympiad's noise. It is measured in wall time on all cores, for which its user waits, and in
processor time on one thread, which other work disturbs less. The instructions of a variant, which
other work does not disturb, are counted by valgrind where it is installed. The other functions are
timed on one shot of ``shots/``. The result is stored in ``benches/results/questions.json``.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

import callgrind
import carom
import numpy as np
from carom.bench import report, states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "questions.json"
VARIANTS = 10_000
#: The most that `evaluate` of these variants may take on all cores, ms.
BAR = 60.0
#: Number of runs. The fastest counts: other work on the machine slowed the others.
ROUNDS = 3
#: Variants of each shot in two runs under valgrind. Their difference contains no start or parsing.
COUNTED = (8, 40)


def main() -> int:
    """Measures, prints and stores."""
    result: dict[str, Any] = report.where() | {"variants": VARIANTS}
    result["evaluate"] = evaluations()
    result |= instructions()
    result["others_ms"] = others()
    print(json.dumps(result, indent=2))
    worst = result["evaluate"]["wall_ms"]["worst"]
    print(f"bar: {BAR:g} ms on all cores; the slowest shot takes {worst:g} ms")
    STORED.parent.mkdir(parents=True, exist_ok=True)
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def evaluations() -> dict[str, Any]:
    """Times of `evaluate` over the mid-game states: median, 90th percentile and maximum, ms."""
    noise, seen = carom.Noise.olympiad(1.0), carom.Perception(position=0.001)
    shots = [carom.Shot.from_dict(s.shot_file()) for s in states.load()["random_eight_ball"]]
    asked: dict[str, Callable[[carom.Shot], object]] = {
        "wall_ms": lambda shot: shot.evaluate(noise, VARIANTS),
        "one_thread_ms": lambda shot: shot.evaluate(noise, VARIANTS, threads=1),
        "with_perception_wall_ms": lambda shot: shot.evaluate(noise, VARIANTS, perception=seen),
    }
    result: dict[str, Any] = {
        "shots": len(shots),
        "balls": round(float(np.mean([len(shot.ids) for shot in shots])), 1),
    }
    for name, ask in asked.items():
        clock = time.process_time if name == "one_thread_ms" else time.perf_counter
        times = [fastest(lambda shot=shot, ask=ask: ask(shot), clock) for shot in shots]
        result[name] = {
            "median": round(median(times), 1),
            "percentile_90": round(float(np.percentile(times, 90)), 1),
            "worst": round(max(times), 1),
        }
    return result


def instructions() -> dict[str, int]:
    """Instructions of a variant: drawing, simulating and counting."""
    if not callgrind.is_installed():
        print("valgrind is not installed: instructions were not counted", file=sys.stderr)
        return {}
    program = callgrind.build("carom-plan", "chances")
    members = states.load()["random_eight_ball"]
    with tempfile.TemporaryDirectory() as folder:
        shots = callgrind.write(members, Path(folder) / "shots")
        few, many = (callgrind.count(program, shots, variants)[0] for variants in COUNTED)
    variants = len(members) * (COUNTED[1] - COUNTED[0])
    return {"instructions_per_variant": round((many - few) / variants)}


def others() -> dict[str, float]:
    """Wall times of the other functions, ms."""
    shot = carom.Shot.load(ROOT / "shots" / "side_pocket_cut.json")
    speeds, heights = np.linspace(0.8, 4.0, 65), np.linspace(-0.4, 0.4, 5)
    asked: dict[str, Callable[[], object]] = {
        "solve": lambda: shot.solve(pot=("1", "right")),
        "solve_with_jumps": lambda: shot.solve(pot=("1", "right"), elevation=1.2),
        "pot_map_2048_cells": lambda: carom.pot_map(shot, "1", "right", columns=32),
        "position_map_325_cells": lambda: carom.position_map(
            shot, "1", "right", speed=speeds, height=heights
        ),
        "acceptance_77924_balls": lambda: carom.acceptance(shot, "top-left"),
        "kick_table_648_kicks": lambda: carom.kick_table(shot),
        "bank_table_216_banks": lambda: carom.bank_table(shot, "1"),
        "break_statistics_1000_racks": lambda: carom.break_statistics("nine-ball", 1000),
    }
    return {name: round(fastest(ask, time.perf_counter), 1) for name, ask in asked.items()}


def fastest(ask: Callable[[], object], clock: Callable[[], float]) -> float:
    """The time of the fastest of `ROUNDS` runs, ms."""
    times = []
    for _ in range(ROUNDS):
        start = clock()
        ask()
        times.append(clock() - start)
    return 1e3 * min(times)


if __name__ == "__main__":
    sys.exit(main())
