"""Checks, and the table of their results."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TextIO

from release.shell import CheckError, NotRunError


@dataclass(frozen=True)
class Check:
    """A check: its name, and a function that gives one sentence on what was found."""

    name: str
    find: Callable[[], str]


def report(checks: Iterable[Check], kept: TextIO | None = None) -> int:
    """Run the checks and print a line for each; progress goes to stderr.

    Args:
        checks: The checks, in their order.
        kept: A file for the same lines.

    Returns:
        The exit status: 1 if a check failed. One that could not run is printed and does not fail.
    """
    failed = 0
    for check in checks:
        print(f"{check.name} ...", file=sys.stderr, flush=True)
        try:
            word, text = "ok", check.find()
        except NotRunError as missing:
            word, text = "NOT RUN", str(missing)
        except CheckError as fault:
            word, text = "FAILED", str(fault)
            failed = 1
        for stream in (sys.stdout, kept):
            if stream is not None:
                print(f"{check.name:32} {word:8} {text}", file=stream, flush=True)
    return failed
