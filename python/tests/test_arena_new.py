"""`carom arena new`: the template of a program."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from carom.arena.new_program import TEMPLATES
from conftest import CommandLine

SESSION = [
    {"type": "hello", "protocol": "carom-arena/1"},
    {
        "type": "match",
        "balls": {"cue": {"radius": 0.028575}},
        "geometry": {"pockets": [{"name": "top-left", "center": [0.0, 2.54]}]},
    },
    {
        "type": "request",
        "id": 1,
        "kind": "shot",
        "cue_ball": "cue",
        "in_hand": None,
        "on": ["1"],
        "calls": ["pocket", "safety"],
        "opening": False,
        "balls": {"cue": [0.6, 1.0], "1": [0.3, 1.77]},
    },
    {"type": "news"},
    {"type": "request", "id": 2, "kind": "choice", "choices": ["play-on", "pass-back"]},
]


@pytest.mark.parametrize("language", TEMPLATES)
def test_a_new_folder_has_the_program_and_says_how_to_run_it(
    run: CommandLine, tmp_path: Path, language: str
) -> None:
    folder = tmp_path / "new"
    done = run("arena", "new", str(folder), "--language", language)
    assert done.returncode == 0
    template = TEMPLATES[language]
    readme = (folder / "README.md").read_text()
    assert template.command in readme
    assert template.build in readme
    assert (folder / template.file).read_text().count("\n") <= 100
    again = run("arena", "new", str(folder), "--language", language)
    assert again.returncode == 2
    assert "is not empty" in again.stderr


def test_an_unknown_language_is_refused(run: CommandLine, tmp_path: Path) -> None:
    done = run("arena", "new", str(tmp_path / "x"), "--language", "cobol")
    assert done.returncode == 2
    assert "python, cpp, node, rust" in done.stderr
    assert not (tmp_path / "x").exists()


def test_the_template_in_python_answers_with_a_called_pot_and_a_choice(
    run: CommandLine, tmp_path: Path
) -> None:
    run("arena", "new", str(tmp_path / "mine"))
    done = subprocess.run(
        [sys.executable, str(tmp_path / "mine" / "player.py")],
        input="".join(json.dumps(message) + "\n" for message in SESSION),
        capture_output=True,
        text=True,
        check=True,
    )
    hello, ready, play, choice = map(json.loads, done.stdout.splitlines())
    assert (hello["type"], ready) == ("hello", {"type": "ready"})
    assert play["call"] == {"kind": "pocket", "ball": "1", "into": "top-left"}
    assert play["id"] == 1
    assert choice == {"type": "choose", "id": 2, "choice": "play-on"}
