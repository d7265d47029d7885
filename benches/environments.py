"""Steps a second of the vector environment, the rules' share of a step, and pooltool beside it.

    python benches/environments.py

The vector has 4096 environments of eight-ball with 4 to 9 object balls, rules and the Computational
Olympiad's noise. The actions are random, but aimed at a ball. Both wall time on all cores and
processor time per core are measured. The rules' share of the instructions is counted by valgrind
where it is installed. Where pooltool is installed (``make bench-peer``), an environment built on it
plays the same on the same table, in turns with ours. The result is stored in
``benches/results/environments.json``, or in ``environments_alone.json`` without pooltool.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import fmean, median
from typing import Any

import callgrind
import carom
import carom.env
import gymnasium
import numpy as np
from carom.bench import report
from numpy.typing import NDArray
from pooltool_environment import TABLE, EightBall, timed

Array = NDArray[Any]

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benches" / "results"
NOISE = carom.Noise.olympiad(1.0)
ENVIRONMENTS = 4096
STEPS = 20
#: Number of runs. The fastest counts: other work on the machine slowed the others.
ROUNDS = 5
#: Shots that compile pooltool's environment, and shots of a round.
PEER_WARM = 30
PEER_STEPS = 100
#: Required: steps a second on both cores, ratio to pooltool, and largest share of the rules.
BAR_STEPS = 100_000
BAR_RATIO = 500
BAR_RULES = 0.05
#: The functions that apply the rules to a shot: its outcome, the ruling, the next request. The
#: recording of contacts during the simulation is not counted.
RULES = ("OutcomeRecorder::finish", "GameRules>::judge", "Frame::settle")
#: Environments, steps and threads under valgrind, which is fifty times slower.
COUNTED = ("256", "4", "1")


def main() -> int:
    """Measures, prints and stores."""
    result: dict[str, Any] = report.where() | steps() | rules() | beside_pooltool()
    print(json.dumps(result, indent=2))
    print(f"bars: {BAR_STEPS} steps/s, {BAR_RATIO} x pooltool, rules under {BAR_RULES:.0%}")
    name = "environments.json" if "beside_pooltool" in result else "environments_alone.json"
    RESULTS.mkdir(parents=True, exist_ok=True)
    (RESULTS / name).write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def vector(**more: Any) -> Any:
    """The vector environment."""
    return gymnasium.make_vec(
        "carom/EightBall-v6",
        num_envs=ENVIRONMENTS,
        balls=(4, 9),
        noise=NOISE,
        aim="relative",
        max_elevation=0.0,
        # A level cue, as pooltool's environment has it.
        physics={"cue": {"stroke_elevation": 0.0}},
        **more,
    )


def some_actions(envs: Any) -> Array:
    """Random actions for all steps, shape (STEPS, ENVIRONMENTS, 7)."""
    random = np.random.default_rng(0)
    return random.uniform(-1, 1, (STEPS, *envs.action_space.shape)).astype(np.float32)


def play(envs: Any, actions: Array, seed: int) -> tuple[float, float, float]:
    """Wall time and processor time, s, and the mean number of balls on the table at the end."""
    observations, _ = envs.reset(seed=seed * ENVIRONMENTS)
    wall, processor = time.perf_counter(), time.process_time()
    for action in actions:
        observations, *_ = envs.step(action)
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    return wall, processor, float(observations[:, 2:64:4].sum(axis=1).mean())


def steps() -> dict[str, Any]:
    """Steps a second of wall time, and of processor time."""
    envs = vector()
    actions = some_actions(envs)
    wall, processor, balls = zip(*(play(envs, actions, s) for s in range(ROUNDS)), strict=True)
    count = ENVIRONMENTS * STEPS
    return {
        "environments": ENVIRONMENTS,
        "balls_on_the_table": round(fmean(balls), 1),
        "steps_per_second": round(count / min(wall)),
        "steps_per_core_second": round(count / min(processor)),
    }


def rules() -> dict[str, Any]:
    """The rules' share of a step's instructions."""
    if not callgrind.is_installed():
        print("valgrind is not installed: the rules' share was not counted", file=sys.stderr)
        return {}
    program = callgrind.build("carom-env", "steps")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind.out"
        callgrind.count(program, "eight-ball", *COUNTED, out=out)
        command = ["callgrind_annotate", "--inclusive=yes", "--threshold=100", str(out)]
        table = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    inclusive = re.findall(r"^ *([\d,]+) .*?:(\S.*?)(?: \[.*\])?$", table, re.MULTILINE)
    costs = [(int(cost.replace(",", "")), name) for cost, name in inclusive]
    step = most(costs, "VectorEnv::step")
    share = sum(most(costs, name) for name in RULES) / step
    return {"instructions_per_step": step // 1024, "rules_share": round(share, 4)}


def most(costs: list[tuple[int, str]], name: str) -> int:
    """The inclusive cost of a function: the largest of those listed for its inlined parts."""
    found = [cost for cost, function in costs if name in function]
    if not found:
        raise SystemExit(f"{name} is not in callgrind's list: it was inlined or renamed")
    return max(found)


def beside_pooltool() -> dict[str, Any]:
    """Our environments and pooltool's in turns, on pooltool's table; medians of the rounds."""
    envs = vector(table=TABLE)
    layouts, _ = envs.reset(seed=0)
    try:
        peer = EightBall(layouts, NOISE, seed=0)
    except ImportError as error:
        print(error, file=sys.stderr)
        return {}
    actions = some_actions(envs)
    timed(peer, actions[0, :PEER_WARM])
    wall, processor, theirs = [], [], []
    for seed in range(ROUNDS):
        one, other, _ = play(envs, actions, seed)
        wall.append(one / actions[..., 0].size)
        processor.append(other / actions[..., 0].size)
        theirs.append(timed(peer, actions[1 + seed, :PEER_STEPS]))
    every = [taken for row in theirs for taken in row]
    return {
        "beside_pooltool": {
            "peer": f"pooltool {peer.version}",
            "table": TABLE,
            "peer_steps": len(every),
            "peer_step_median_us": round(1e6 * median(every)),
            "peer_step_mean_us": round(1e6 * median(map(fmean, theirs))),
            "core_step_us": round(1e6 * median(processor), 2),
            "step_us": round(1e6 * median(wall), 2),
            # One core against one core, and all cores against one.
            "times_per_core": round(median(map(fmean, theirs)) / median(processor)),
            "times": round(median(map(fmean, theirs)) / median(wall)),
        }
    }


if __name__ == "__main__":
    sys.exit(main())
