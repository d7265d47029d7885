"""`carom arena check`: a player in situations of every kind."""

from __future__ import annotations

import json
from pathlib import Path

import carom
import pytest
from carom import Play, Situation, Strike
from conftest import CommandLine

PLAYER = '''
import carom

class Careless:
    """Calls nothing."""
    def choose(self, situation):
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        return carom.Play(carom.Strike(2.0, 1.2))

class Broken:
    def choose(self, situation):
        raise RuntimeError("it does not work")
'''


def test_a_built_in_player_passes_every_situation_that_concerns_it() -> None:
    report = carom.arena.check("carom:60")
    assert report.passed
    asked = [verdict for verdict in report.verdicts if verdict.passed is not None]
    assert len(asked) >= 28
    assert all(verdict.answer for verdict in asked)
    assert f"passed {len(asked)} of {len(asked)} situations" in str(report)


def test_a_failure_has_its_place_and_remedy() -> None:
    class Careless:
        def choose(self, situation: Situation) -> Play | str:
            request = situation.frame.request
            if request.kind == "choice":
                return request.choices[0]
            return Play(Strike(2.0, 1.2))

    report = carom.arena.check(Careless())
    failed = {verdict.situation: verdict for verdict in report.failures()}
    assert {"called shot", "free ball"} <= failed.keys()
    assert "opening of nine-ball" not in failed
    verdict = failed["called shot"]
    assert (verdict.kind, verdict.place) == ("no-call", "call")
    assert verdict.remedy == "call a ball and its pocket, or a safety"
    assert "call: nothing is called" in str(report)


def test_the_command_prints_verdicts_and_its_exit_status_tells_a_failure(
    run: CommandLine, tmp_path: Path
) -> None:
    (tmp_path / "mine.py").write_text(PLAYER)
    done = run("arena", "check", f"{tmp_path}/mine.py:Careless", "--json")
    assert done.returncode == 2
    report = json.loads(done.stdout)
    assert not report["passed"]
    assert {"situation", "passed", "place", "fault", "remedy"} <= report["verdicts"][0].keys()
    done = run("arena", "check", f"{tmp_path}/mine.py:Broken")
    assert done.returncode == 2
    assert "RuntimeError: it does not work" in done.stdout
    assert "Traceback" in done.stderr


@pytest.mark.parametrize("player", ["croquet", "carom:x"])
def test_an_unknown_player_is_bad_input(run: CommandLine, player: str) -> None:
    done = run("arena", "check", player)
    assert done.returncode == 2
    assert done.stdout == ""
