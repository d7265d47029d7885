"""The example of a league for self-play."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "examples" / "league.py"


def test_a_snapshot_that_has_learned_beats_the_first_one(
    capsys: pytest.CaptureFixture[str],
) -> None:
    league = runpy.run_path(str(SCRIPT))
    ratings = league["main"](["--snapshots", "2", "--steps", "10", "--pairs", "2"])
    assert len(ratings) == 3
    assert min(ratings[1:]) > ratings[0]
    printed = capsys.readouterr().out.splitlines()
    assert [line.split(":")[0] for line in printed] == [
        "1 against 0",
        "2 against 0",
        "2 against 1",
        "ratings",
    ]


def test_the_example_is_short() -> None:
    assert len(SCRIPT.read_text().splitlines()) <= 120
