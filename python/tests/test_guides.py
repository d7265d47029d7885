"""The commands of the guide for players and coaches run unchanged."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import carom
import pytest
from carom.cli.main import app
from typer.testing import CliRunner

GUIDE = Path(__file__).parents[2] / "docs" / "guide-coach.md"
BLOCK = re.compile(r"^```text\n(.*?)^```", re.DOTALL | re.MULTILINE)
COMMANDS = [
    line
    for block in BLOCK.findall(GUIDE.read_text(encoding="utf-8"))
    for line in block.splitlines()
    if line.startswith("carom ")
]


def test_the_guide_has_a_command_for_every_question() -> None:
    asked = {" ".join(word for word in line.split()[1:3]) for line in COMMANDS}
    for question in ("solve shot.json", "map pot", "map position", "map acceptance", "map kick"):
        assert question in asked
    assert {"evaluate best.json", "stats break"} <= asked


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_the_guide_runs(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The files that the page's snippets save, with the balls in the page's commands.
    balls = {"cue": (0.45, 0.75), "8": (0.8, 1.45), "9": (0.35, 2.2), "1": (1.0, 1.0)}
    shot = carom.Shot("wpa-9ft", balls, carom.Strike(speed=2.0, azimuth=1.05))
    for name in re.findall(r"\w+\.json", command):
        shot.save(tmp_path / name)
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(app, shlex.split(command)[1:], catch_exceptions=False)
    assert done.exit_code == 0
    assert done.stdout
    for name in re.findall(r"\w+\.png", command):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")
