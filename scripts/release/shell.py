"""Commands of other programs."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]


class CheckError(Exception):
    """A check failed; the message is for the report."""


class NotRunError(Exception):
    """A check could not run here; the message names what is missing, and how to get it."""


def run(*command: str, at: Path = ROOT, **environment: str) -> str:
    """The output of a command.

    Args:
        command: The program and its arguments.
        at: Its working directory.
        environment: Variables to add.

    Raises:
        CheckError: It ended with an error; the message has its last lines.
    """
    # make passes a job server that these programs do not use.
    inherited = {k: v for k, v in os.environ.items() if k not in {"MAKEFLAGS", "MFLAGS"}}
    ended = subprocess.run(
        command,
        cwd=at,
        env={**inherited, **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    if ended.returncode:
        lines = "\n".join(ended.stdout.strip().splitlines()[-30:])
        raise CheckError(f"{' '.join(command)} ended with {ended.returncode}:\n{lines}")
    return ended.stdout


def need(program: str, remedy: str) -> str:
    """The path of a program.

    Raises:
        NotRunError: It is not installed.
    """
    found = shutil.which(program)
    if found is None:
        raise NotRunError(f"{program} is missing: {remedy}")
    return found
