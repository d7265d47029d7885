"""Stated chances and results of the robot of ``examples/robot_loop.py``.

    python benches/robot_loop.py [--robots N] [--shots N] [--cushions MODEL] [--first SEED]

Every robot has a table, errors and a calibration of its own. It learns from 50 shots and then
plays, and states the chance of each shot before it. A run continues where a stopped one was, robot
by robot; the result is in ``benches/results/robot_loop.json``.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from carom.bench import report

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "examples"))

import robot_loop  # noqa: E402

STORED = ROOT / "benches" / "results" / "robot_loop.json"
LEARN = 50
SIMULATIONS = 2000


def main() -> int:
    """Measures, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robots", type=int, default=10)
    parser.add_argument("--shots", type=int, default=100)
    parser.add_argument("--cushions", default="han-2005")
    parser.add_argument("--first", type=int, default=1)
    options = parser.parse_args()
    for seed in range(options.first, options.first + options.robots):
        key = f"{options.cushions} {seed}"
        if key not in stored()["robots"]:
            robot = measured(seed, options.cushions, options.shots)
            # Another run may have stored a robot meanwhile.
            result = stored()
            result["robots"][key] = robot
            STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
            print(key, summary([robot]), flush=True)
    robots = stored()["robots"]
    for model in sorted({key.split()[0] for key in robots}):
        print(model, summary([robots[key] for key in robots if key.split()[0] == model]))
    return 0


def stored() -> dict[str, Any]:
    """What is measured so far."""
    if STORED.exists():
        found: dict[str, Any] = json.loads(STORED.read_text(encoding="utf-8"))
        return found
    return report.where() | {"learned_from": LEARN, "simulations": SIMULATIONS, "robots": {}}


def measured(seed: int, cushions: str, shots: int) -> dict[str, Any]:
    """One robot: the stated chance and the result of every shot, and what it learned."""
    began = time.perf_counter()
    world = robot_loop.World(seed, cushions)
    robot = robot_loop.Robot(world.marks, world.marks_measured(), SIMULATIONS)
    for _ in range(LEARN):
        robot_loop.play(world, robot)
    robot.learn()
    played = [robot_loop.play(world, robot) for _ in range(shots)]
    assert robot.table is not None
    return {
        "stated": [round(float(chance or 0.0), 4) for chance, _ in played],
        "made": [int(made) for _, made in played],
        "used": robot.table.shots,
        "mean": [float(f"{x:.6g}") for x in robot.table.mean],
        "sigma": [float(f"{x:.3g}") for x in robot.table.sigma],
        "seconds": round(time.perf_counter() - began),
    }


def summary(robots: list[dict[str, Any]]) -> str:
    """Stated minus made, with the standard error of the results if the chances are true."""
    stated = np.concatenate([robot["stated"] for robot in robots])
    made = np.concatenate([robot["made"] for robot in robots])
    error = float(np.sqrt((stated * (1 - stated)).sum())) / len(made)
    away = float(stated.mean() - made.mean())
    return (
        f"{len(made)} shots: stated {stated.mean():.1%}, made {made.mean():.1%}, "
        f"{100 * away:+.1f} ± {100 * error:.1f} points"
    )


if __name__ == "__main__":
    sys.exit(main())
