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
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", str(program)]
    command += map(str, words)
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    collected = re.search(r"Collected\s*:\s*(\d+)", done.stderr)
    if collected is None:
        raise SystemExit(f"callgrind printed no count:\n{done.stderr}")
    return int(collected.group(1)), done.stdout
