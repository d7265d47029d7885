"""Fixtures of the tests: shots, and the command line as a user runs it."""

from __future__ import annotations

import copy
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import carom
import pytest

ROOT = Path(__file__).parents[2]

POT: dict[str, Any] = {
    "format": "carom-shot/1",
    "table": "wpa-9ft",
    "physics": "pool",
    "balls": [
        {"id": "cue", "position": [0.635, 0.635]},
        {"id": "1", "position": [0.635, 1.905]},
    ],
    "strike": {
        "ball": "cue",
        "speed": 2.0,
        "azimuth_deg": 90.0,
        "elevation_deg": 0.0,
        "side": 0.0,
        "height": 0.0,
    },
}

# A ball that rolls into a ball at rest, on unbounded cloth.
ENDLESS: dict[str, Any] = {
    "format": "carom-shot/1",
    "table": {"cloth": "unbounded"},
    "balls": [
        {"id": "a", "position": [0.0, 0.0], "velocity": [1.5, 0.0, 0.0]},
        {"id": "b", "position": [0.5, 0.01]},
    ],
}


@pytest.fixture
def pot() -> dict[str, Any]:
    """A two-ball shot on a pool table."""
    return copy.deepcopy(POT)


@pytest.fixture
def endless() -> dict[str, Any]:
    """Two balls on unbounded cloth, without a strike."""
    return copy.deepcopy(ENDLESS)


@pytest.fixture(scope="session")
def nine_ball() -> carom.Shot:
    """A nine-ball break."""
    return carom.Shot.load(ROOT / "shots" / "nine_ball_break.json")


@pytest.fixture(scope="session")
def nine_ball_trace(nine_ball: carom.Shot) -> carom.Trace:
    """The trace of a nine-ball break."""
    return nine_ball.simulate()


@pytest.fixture
def spec(pot: dict[str, Any]) -> dict[str, Any]:
    """A sweep of two layouts, grids of speeds and frictions, and a drawn azimuth."""
    other = copy.deepcopy(pot)
    other["balls"].append({"id": "8", "position": [0.9, 1.2]})
    return {
        "format": "carom-sweep/1",
        "shots": [pot, other],
        "vary": {
            "strike.speed": {"from": 1.0, "to": 3.0, "count": 5},
            "physics.cloth.sliding_friction": {"grid": [0.15, 0.2]},
            "strike.azimuth_deg": {"uniform": [85, 95]},
        },
        "samples": 10,
        "seed": 4,
    }


class CommandLine:
    """Runs ``carom`` in a separate process."""

    def __init__(self, cwd: Path) -> None:
        self.cwd = cwd

    def __call__(
        self, *args: str, stdin: str | bytes = "", **environment: str
    ) -> subprocess.CompletedProcess[str]:
        data = stdin.encode() if isinstance(stdin, str) else stdin
        done = subprocess.run(
            [sys.executable, "-m", "carom", *args],
            input=data,
            capture_output=True,
            cwd=self.cwd,
            env={**os.environ, **environment},
            timeout=120,
            check=False,
        )
        return subprocess.CompletedProcess(
            done.args, done.returncode, done.stdout.decode(), done.stderr.decode()
        )


@pytest.fixture
def run(tmp_path: Path) -> CommandLine:
    """The command line, in an empty directory."""
    return CommandLine(tmp_path)
