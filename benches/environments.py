"""Steps a second of the vector of environments, the rules' share of a step, and pooltool beside it.

    python benches/environments.py

4096 environments of eight-ball with 4 to 9 object balls, rules and the Computational Olympiad's
noise, actions at random that hit a ball. The wall clock says what this machine did beside its other
work; the processor time what one core does. The share of the rules is counted in instructions by
valgrind, where it is installed. Where pooltool is (``make bench-peer``), an environment that is
built on it plays the same on the same table, in turns with ours. The result is kept in
``benches/results/environments.json``.
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
STORED = ROOT / "benches" / "results" / "environments.json"
NOISE = carom.Noise.olympiad(1.0)
ENVIRONMENTS = 4096
STEPS = 20
#: The fastest of so many runs is kept: the others had more company.
ROUNDS = 5
#: Shots of pooltool's environment that compile it, and those of a round.
PEER_WARM = 30
PEER_STEPS = 100
#: What this must reach: steps a second on both cores, times pooltool, and the rules' share.
BAR_STEPS = 100_000
BAR_RATIO = 500
BAR_RULES = 0.05
#: The functions of carom-rules that rule on a shot; all the rest of it prepares and plays one.
RULES = ("carom_rules::facts::Facts::new", "games::Game>::judge", "Frame::settle")
#: Environments and steps under valgrind, which is fifty times slower.
COUNTED = ("256", "4", "1")


def main() -> int:
    """Measures, prints, stores."""
    result: dict[str, Any] = report.where() | steps() | rules() | beside_pooltool()
    print(json.dumps(result, indent=2))
    print(f"bars: {BAR_STEPS} steps/s, {BAR_RATIO} x pooltool, rules under {BAR_RULES:.0%}")
    STORED.parent.mkdir(parents=True, exist_ok=True)
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def vector(**more: Any) -> Any:
    """The environments that are stepped."""
    return gymnasium.make_vec(
        "carom/EightBall-v2",
        num_envs=ENVIRONMENTS,
        balls=(4, 9),
        noise=NOISE,
        aim="relative",
        max_elevation=0.0,
        **more,
    )


def some_actions(envs: Any) -> Array:
    """Steps of all environments, shape (STEPS, ENVIRONMENTS, 7)."""
    random = np.random.default_rng(0)
    return random.uniform(-1, 1, (STEPS, *envs.action_space.shape)).astype(np.float32)


def play(envs: Any, actions: Array, seed: int) -> tuple[float, float, float]:
    """Time by the clock and by the processor, s, and the balls on the table at the end, mean."""
    observations, _ = envs.reset(seed=seed * ENVIRONMENTS)
    wall, processor = time.perf_counter(), time.process_time()
    for action in actions:
        observations, *_ = envs.step(action)
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    return wall, processor, float(observations[:, 2:64:4].sum(axis=1).mean())


def steps() -> dict[str, Any]:
    """Steps a second by the wall clock, and by one core's time."""
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
    """The inclusive cost of a function; the largest of what its inlined parts are listed with."""
    found = [cost for cost, function in costs if name in function]
    if not found:
        raise SystemExit(f"{name} is not in callgrind's list: it was inlined, or has a new name")
    return max(found)


def beside_pooltool() -> dict[str, Any]:
    """Our environments and one on pooltool in turns, on pooltool's table; medians of the rounds."""
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
            # One core against one core; and as the vector is used, on all cores.
            "times_per_core": round(median(map(fmean, theirs)) / median(processor)),
            "times": round(median(map(fmean, theirs)) / median(wall)),
        }
    }


if __name__ == "__main__":
    sys.exit(main())
