"""Instructions of our example programs, counted by valgrind's callgrind."""

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
    """Whether there is a valgrind."""
    return shutil.which("valgrind") is not None


def build(package: str, example: str) -> Path:
    """Builds an example with the profile of the benchmarks, and tells where the program is."""
    command = ["cargo", "build", "--quiet", "--profile", "bench", "-p", package]
    command += ["--example", example, "--message-format", "json"]
    built = subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout
    messages = map(json.loads, built.splitlines())
    return next(
        Path(message["executable"])
        for message in messages
        if message.get("executable") and message["target"]["name"] == example
    )


def write(members: Iterable[State], path: Path) -> Path:
    """Writes shots, one in a line, as the examples read them."""
    lines = (json.dumps(state.shot_file()) + "\n" for state in members)
    path.write_text("".join(lines), encoding="utf-8")
    return path


def count(program: Path, *words: object, out: Path = Path("/dev/null")) -> tuple[int, str]:
    """Instructions of a whole run, and what it printed; ``out`` gets those of each function."""
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", str(program)]
    command += map(str, words)
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    collected = re.search(r"Collected\s*:\s*(\d+)", done.stderr)
    if collected is None:
        raise SystemExit(f"callgrind did not say what it counted:\n{done.stderr}")
    return int(collected.group(1)), done.stdout
