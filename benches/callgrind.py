"""Instruction counts of the example programs, by valgrind's callgrind."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path

from carom.bench.states import State

ROOT = Path(__file__).resolve().parents[1]


def is_installed() -> bool:
    """Whether valgrind is on the path."""
    return shutil.which("valgrind") is not None


def build(package: str, example: str, checkout: Path = ROOT) -> Path:
    """Builds an example with the profile `bench` and returns the path of the program."""
    command = ["cargo", "build", "--quiet", "--profile", "bench", "-p", package]
    command += ["--example", example, "--message-format", "json"]
    built = subprocess.run(
        command, check=True, cwd=checkout, stdout=subprocess.PIPE, text=True
    ).stdout
    messages = map(json.loads, built.splitlines())
    return next(
        Path(message["executable"])
        for message in messages
        if message.get("executable") and message["target"]["name"] == example
    )


def write(members: Iterable[State], path: Path) -> Path:
    """Writes shot files as the examples read them, one in a line; returns `path`."""
    lines = (json.dumps(state.shot_file()) + "\n" for state in members)
    path.write_text("".join(lines), encoding="utf-8")
    return path


def count(program: Path, *words: object, out: Path = Path("/dev/null")) -> tuple[int, str]:
    """The instructions of a whole run, and the program's output.

    Args:
        program: The program to run.
        words: Its arguments.
        out: File for the counts of each function.

    Raises:
        SystemExit: callgrind printed no count.
    """
    counts, printed = _run(program, words, [f"--callgrind-out-file={out}"])
    return counts["Ir"], printed


#: A level-one instruction cache of 32 KB, as most processors have: size, ways, bytes of a line.
INSTRUCTION_CACHE = "32768,8,64"


def misses(program: Path, *words: object) -> tuple[int, int]:
    """Mispredicted branches, and misses of the instruction cache, of a whole run.

    They are those of valgrind's models: a predictor by the branch's address and the last branches,
    which is simpler than that of a processor, and a cache without prefetch.
    """
    simulated = ["--branch-sim=yes", "--cache-sim=yes", f"--I1={INSTRUCTION_CACHE}"]
    counts, _ = _run(program, words, ["--callgrind-out-file=/dev/null", *simulated])
    return counts["Bcm"] + counts["Bim"], counts["I1mr"]


def _run(
    program: Path, words: Iterable[object], options: Iterable[str]
) -> tuple[dict[str, int], str]:
    """What callgrind counted by the names of its events, and the program's output."""
    command = ["valgrind", "--tool=callgrind", *options, str(program), *map(str, words)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    names = re.search(r"Events\s*:(.*)", done.stderr)
    collected = re.search(r"Collected\s*:(.*)", done.stderr)
    if names is None or collected is None:
        raise SystemExit(f"callgrind printed no count:\n{done.stderr}")
    counts = map(int, collected.group(1).split())
    return dict(zip(names.group(1).split(), counts, strict=False)), done.stdout
