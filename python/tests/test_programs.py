"""External programs as players of a match: ``exec:COMMAND``."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import carom
import pytest
from carom.errors import InputError

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="programs play on Linux")

# A program that greets, complains, and then answers every request with ANSWER.
PROGRAM = """
import json, sys
print("a word for the log", file=sys.stderr)
for line in sys.stdin:
    message = json.loads(line)
    kind = message["type"]
    if kind == "hello":
        print(json.dumps({"type": "hello", "name": "test"}), flush=True)
    elif kind == "match":
        print(json.dumps({"type": "ready"}), flush=True)
    elif kind in ("request", "refused"):
        ANSWER
"""
CONCEDE = 'print(json.dumps({"type": "concede", "id": message["id"]}), flush=True)'


@pytest.fixture
def program(tmp_path: Path) -> Any:
    def write(answer: str = CONCEDE) -> str:
        file = tmp_path / "a program.py"
        file.write_text(PROGRAM.replace("ANSWER", answer), encoding="utf-8")
        return f"exec:'{sys.executable}' '{file}'"

    return write


def play(name: str, out: Path, **settings: Any) -> carom.arena.MatchResult:
    return carom.play_match(
        name, "greedy:9", game="nine-ball", pairs=1, secret="3" * 64, out=out, **settings
    )


def lines(out: Path) -> list[Any]:
    text = (out / "match.jsonl").read_text(encoding="utf-8")
    return [json.loads(line) for line in text.splitlines()]


def test_a_program_plays_a_match_that_replays(tmp_path: Path, program: Any) -> None:
    name = program()
    result = play(name, tmp_path / "match")
    assert result.score.share == 0.0
    assert result.score.reasons == {"conceded": 2}
    header, *frames, _ = lines(tmp_path / "match")
    settings = header["players"][0]["settings"]
    assert settings["program"] == [sys.executable, str(tmp_path / "a program.py")]
    assert len(settings["sha256"]) == 2
    assert settings["enforced"][:3] == ["limits", "environment", "tree"]
    assert [frame["end"]["reason"] for frame in frames] == ["conceded"] * 2
    assert carom.replay_match((tmp_path / "match/match.jsonl").read_text()).difference is None
    log = (tmp_path / "match/errors.log").read_text(encoding="utf-8")
    assert log.count("a word for the log") == 2
    assert "frame 1, player exec:" in log


def test_the_pairs_of_a_program_are_played_in_other_processes(tmp_path: Path, program: Any) -> None:
    play(program(), tmp_path / "one")
    play(program(), tmp_path / "two", processes=2)
    first, second = lines(tmp_path / "one"), lines(tmp_path / "two")
    assert [line.get("end") for line in first] == [line.get("end") for line in second]


def test_a_program_that_ends_loses_with_its_last_words(tmp_path: Path, program: Any) -> None:
    play(program('raise ValueError("no idea")'), tmp_path / "match")
    _, frame, _, _ = lines(tmp_path / "match")
    assert frame["end"]["reason"] == "crash"
    assert frame["end"]["why"] == (
        "the program ended with exit status 1; the last line on its stderr: ValueError: no idea"
    )


def test_a_program_whose_time_is_over_loses(tmp_path: Path, program: Any) -> None:
    begin = time.monotonic()
    play(program("import time; time.sleep(100)"), tmp_path / "match", clock=(0.2, 600.0))
    assert time.monotonic() - begin < 60
    _, *frames, _ = lines(tmp_path / "match")
    assert [frame["end"]["reason"] for frame in frames] == ["time-over"] * 2


def test_a_changed_program_does_not_continue_the_match(tmp_path: Path, program: Any) -> None:
    play(program(), tmp_path / "match")
    with pytest.raises(InputError, match="it has another match"):
        play(program(CONCEDE + "  # changed"), tmp_path / "match")


@pytest.mark.parametrize(
    ("name", "fault"),
    [
        ("exec:no-such-program", 'there is no program "no-such-program"'),
        ("exec:", "the command is empty"),
        ("exec:sh 'x", "has no end"),
        ("exec[menus=3]:sh", "unknown key"),
    ],
)
def test_rejects_a_program_that_cannot_be_started(name: str, fault: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as raised:
        carom.play_match("greedy:9", name, pairs=1, out=tmp_path / "match")
    assert raised.value.place.startswith("other")
    assert fault in raised.value.fault
    assert not (tmp_path / "match").exists()


def carom_match(*arguments: str, path: Path | None = None) -> subprocess.Popen[str]:
    code = "from carom.cli.main import run; run()"
    variables = dict(os.environ)
    if path is not None:
        variables["PATH"] = str(path)
    return subprocess.Popen(
        [sys.executable, "-c", code, "match", *arguments],
        env=variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_a_strict_match_does_not_start_a_program_that_cannot_be_confined(
    tmp_path: Path, program: Any
) -> None:
    tools = tmp_path / "tools"
    tools.mkdir()
    sh = shutil.which("sh")
    assert sh is not None
    (tools / "sh").symlink_to(sh)
    out = tmp_path / "match"
    run = carom_match(program(), "greedy:9", "--strict", "--out", str(out), path=tools)
    _, errors = run.communicate(timeout=120)
    assert run.returncode == 2
    assert "strict: network, processes and files cannot be closed off" in errors
    assert not out.exists()


def test_ctrl_c_ends_a_match_and_its_programs(tmp_path: Path, program: Any) -> None:
    name = program("import time; time.sleep(100)")
    run = carom_match(name, "greedy:9", "--out", str(tmp_path / "match"))
    words = f"{sys.executable}\0{tmp_path / 'a program.py'}\0"
    until = time.monotonic() + 60
    while not running(words) and time.monotonic() < until:
        time.sleep(0.05)
    assert running(words)
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate(timeout=60)
    assert run.returncode != 0
    assert "stopped; the same command continues" in errors
    assert not running(words)


def running(words: str) -> list[str]:
    """The command lines of the processes with these words."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            line = (process / "cmdline").read_text(errors="replace")
        except OSError:
            continue
        if words in line:
            found.append(line)
    return found
