"""A tournament on Ray has the records of one without Ray, also after a kill half-way.

Ray runs in a separate process, because it leaves threads, handlers and warnings behind.
"""

from __future__ import annotations

import json
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest
from carom.arena import Tournament
from test_tournament import event, records

if TYPE_CHECKING:
    from pathlib import Path

pytest.importorskip("ray", reason="the extra `ray` is not installed")

PROGRAM = """
import json, os, signal, sys
from carom.arena import Tournament, tournament_on_ray

file = json.loads(sys.argv[1])
add = tournament_on_ray.OpenMatch.add

def add_and_kill(match, pair):
    add(match, pair)
    os.kill(os.getpid(), signal.SIGKILL)

if sys.argv[2] == "killed":
    tournament_on_ray.OpenMatch.add = add_and_kill
print(Tournament(file).run("ray", threads=2, ray=True).pairs_now)
"""


def test_a_tournament_on_ray_has_the_same_records(tmp_path: Path) -> None:
    small = event(pairs=3, block=2)
    Tournament(small).run(tmp_path / "here")

    def run(how: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-c", PROGRAM, json.dumps(small), how],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
            timeout=300,
        )

    assert run("killed").returncode < 0
    done = run("to the end")
    assert done.returncode == 0, done.stderr
    assert int(done.stdout.splitlines()[-1]) == 8, "one pair was there"
    assert records(tmp_path / "ray") == records(tmp_path / "here")
