"""Steps a second of the vector of environments, the rules' share of a step, and pooltool beside it.

    python benches/environments.py

4096 environments of eight-ball with 4 to 9 object balls, rules and the Computational Olympiad's
noise, actions at random that hit a ball. The wall clock says what this machine did beside its other
work; the processor time what one core does. The share of the rules is counted in instructions by
valgrind, where it is installed. pooltool's step is taken to be its simulation alone, of the
benchmark's states of mid-game eight-ball, where it is installed (``make bench-peer``). The result
is kept in ``benches/results/environments.json``.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import fmean
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
from carom.bench import report, states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "environments.json"
ENVIRONMENTS = 4096
STEPS = 20
#: The fastest of so many runs is kept: the others had more company.
ROUNDS = 5
#: What this must reach: steps a second on both cores, times pooltool, and the rules' share.
BAR_STEPS = 100_000
BAR_RATIO = 500
BAR_RULES = 0.05
#: The functions of carom-rules that rule on a shot; all the rest of it prepares and plays one.
RULES = ("carom_rules::facts::Facts::new", "Law::judge", "Frame::settle")
#: Environments and steps under valgrind, which is fifty times slower.
COUNTED = ("256", "4", "1")


def main() -> int:
    """Measures, prints, stores."""
    result: dict[str, Any] = report.where() | steps() | rules() | pooltool()
    if "pooltool_step_us" in result:
        result["times_pooltool"] = result["pooltool_step_us"] * result["steps_per_second"] / 1e6
    print(json.dumps(result, indent=2))
    print(f"bars: {BAR_STEPS} steps/s, {BAR_RATIO} x pooltool, rules under {BAR_RULES:.0%}")
    STORED.parent.mkdir(parents=True, exist_ok=True)
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def steps() -> dict[str, Any]:
    """Steps a second by the wall clock, and processor time of a step."""
    envs = gymnasium.make_vec(
        "carom/EightBall-v1",
        num_envs=ENVIRONMENTS,
        balls=(4, 9),
        noise=carom.Noise.olympiad(1.0),
        aim="relative",
        max_elevation=0.0,
    )
    random = np.random.default_rng(0)
    shape = (STEPS, *envs.action_space.shape)
    actions = random.uniform(-1, 1, shape).astype(np.float32)
    wall, processor, balls = [], [], []
    for seed in range(ROUNDS):
        observations, _ = envs.reset(seed=seed * ENVIRONMENTS)
        start = time.perf_counter(), time.process_time()
        for action in actions:
            observations, *_ = envs.step(action)
        wall.append(time.perf_counter() - start[0])
        processor.append(time.process_time() - start[1])
        balls.append(float(observations[:, 2:64:4].sum(axis=1).mean()))
    count = ENVIRONMENTS * STEPS
    return {
        "environments": ENVIRONMENTS,
        "balls_on_the_table": round(fmean(balls), 1),
        "steps_per_second": round(count / min(wall)),
        "steps_per_core_second": round(count / min(processor)),
    }


def rules() -> dict[str, Any]:
    """The rules' share of a step's instructions."""
    if shutil.which("valgrind") is None:
        print("valgrind is not installed: the rules' share was not counted", file=sys.stderr)
        return {}
    command = ["cargo", "build", "--quiet", "--profile", "bench", "-p", "carom-env"]
    command += ["--example", "steps", "--message-format", "json"]
    command += ["--manifest-path", str(ROOT / "Cargo.toml")]
    built = run(command)
    program = next(
        message["executable"]
        for message in map(json.loads, built.splitlines())
        if message.get("executable") and message["target"]["name"] == "steps"
    )
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind.out"
        count = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}"]
        run([*count, program, "eight-ball", *COUNTED])
        table = run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", str(out)])
    inclusive = re.findall(r"^ *([\d,]+) .*?:(\S.*?)(?: \[.*\])?$", table, re.MULTILINE)
    costs = [(int(cost.replace(",", "")), name) for cost, name in inclusive]
    step = most(costs, "VectorEnv::step")
    share = sum(most(costs, name) for name in RULES) / step
    return {"instructions_per_step": step // 1024, "rules_share": round(share, 4)}


def run(command: list[str]) -> str:
    """What the command prints."""
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def most(costs: list[tuple[int, str]], name: str) -> int:
    """The inclusive cost of a function; the largest of what its inlined parts are listed with."""
    found = [cost for cost, function in costs if name in function]
    if not found:
        raise SystemExit(f"{name} is not in callgrind's list: it was inlined, or has a new name")
    return max(found)


def pooltool() -> dict[str, Any]:
    """What pooltool's simulation of a mid-game shot takes."""
    from carom.bench.peer import Pooltool

    try:
        peer = Pooltool()
    except ImportError as error:
        print(error, file=sys.stderr)
        return {}
    members = states.load()["random_eight_ball"]
    peer.simulate(members[0])
    return {
        "peer": f"pooltool {peer.version}",
        "pooltool_step_us": round(1e6 * fmean(peer.simulate(state)[0] for state in members), 1),
    }


if __name__ == "__main__":
    sys.exit(main())
