"""Matches on several processes, and pairs that are played one by one."""

from __future__ import annotations

import os
import pickle
import random
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import pytest
from carom import InputError
from carom.arena import MatchPlan, OpenMatch, play_pair

if TYPE_CHECKING:
    from conftest import CommandLine

# Frames of a tenth of a second.
SHORT: dict[str, Any] = {
    "game": "nine-ball",
    "pairs": 3,
    "secret": "cd" * 32,
    "patience": 6,
    "simulations": 50,
}
OTHER = "greedy:40"


class Drawing:
    """A strike in a drawn direction."""

    def choose(self, situation: carom.Situation) -> Any:
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        azimuth = random.Random(situation.seed).uniform(0, 6.28)
        return carom.Play(
            carom.Strike(3.0, azimuth), cue_ball=(0.635, 0.5) if request.in_hand else None
        )


class Failing:
    def choose(self, _: carom.Situation) -> Any:
        return {}["strike"]


class OddError(Exception):
    """An exception that cannot be unpickled."""

    def __init__(self, one: str, other: str) -> None:
        super().__init__(one)
        self.other = other


class Deadly(Drawing):
    """Kills its process while the file exists."""

    def __init__(self, file: Path) -> None:
        self.file = file

    def choose(self, situation: carom.Situation) -> Any:
        if self.file.exists():
            os.kill(os.getpid(), signal.SIGKILL)
        return super().choose(situation)


class RaisingOdd:
    def choose(self, _: carom.Situation) -> Any:
        raise OddError("one", "other")


def played(out: Path, player: Any = Drawing, **settings: Any) -> bytes:
    result = carom.play_match(player, OTHER, out=out, **{**SHORT, **settings})
    assert result.record is not None
    return result.record.read_bytes()


def test_several_processes_give_the_record_of_one_thread(tmp_path: Path) -> None:
    one = played(tmp_path / "one")
    assert played(tmp_path / "two", processes=2) == one
    assert played(tmp_path / "object", Drawing(), processes=1) == one
    # A finished match is not played again.
    assert played(tmp_path / "two", Drawing, processes=2) == one


def test_pairs_may_be_played_in_any_order_and_anywhere(tmp_path: Path) -> None:
    one = played(tmp_path / "one")
    plan = MatchPlan(Drawing, OTHER, **SHORT)
    with OpenMatch(plan, tmp_path / "open") as match:
        numbers = [match.next_pair() for _ in range(4)]
        assert numbers == [0, 1, 2, None]
        copy = pickle.loads(pickle.dumps(match.plan))
        for number in (2, 0, 1):
            match.add(pickle.loads(pickle.dumps(play_pair(copy, number))))
        result = match.close()
    assert result.record is not None
    assert result.record.read_bytes() == one


def test_a_pair_has_to_be_the_one_that_it_says_it_is(tmp_path: Path) -> None:
    match = OpenMatch(MatchPlan("greedy:9", "greedy:9", **SHORT), tmp_path / "m")
    pair = play_pair(match.plan, 1)
    with pytest.raises(InputError, match=r"^line 2, frame: it is not frame 0"):
        match.add(carom.arena.PlayedPair(0, pair.lines))
    match.add(pair)
    assert match.played == 1
    with pytest.raises(InputError, match=r"^folder: another program is playing this match"):
        OpenMatch(match.plan, tmp_path / "m")
    assert not match.close().finished
    with pytest.raises(InputError, match=r"^match: it is closed; open it again"):
        match.next_pair()
    with pytest.raises(InputError, match=r"^plan.secret: the plan has none"):
        play_pair(MatchPlan("greedy:9", "greedy:9"), 0)


def test_exceptions_of_players_are_as_on_one_thread(tmp_path: Path) -> None:
    assert played(tmp_path / "two", Failing, processes=2) == played(tmp_path / "one", Failing)
    log = (tmp_path / "two" / "errors.log").read_text()
    assert log.count('return {}["strike"]') == 6
    for player, kind, words in (
        (Failing, KeyError, "strike"),
        (RaisingOdd, RuntimeError, "OddError: one"),
    ):
        out = tmp_path / kind.__name__
        with pytest.raises(kind, match=words) as caught:
            played(out, player, processes=1, strict=True)
        notes = "".join(caught.value.__notes__)
        assert f"player {player.__name__} at seat" in notes
        assert "In the process that played pair" in notes
        assert not (out / "match.jsonl").exists()
        assert played(out, player)


def test_a_process_that_is_killed_is_named_and_no_pair_is_lost(tmp_path: Path) -> None:
    file = tmp_path / "kill"
    file.touch()
    with pytest.raises(InputError) as caught:
        played(tmp_path / "m", Deadly(file), processes=2)
    error = caught.value
    assert error.kind == "stopped"
    assert error.place.startswith("carom worker ")
    assert "ended by signal 9 (Killed) while it played pair " in error.fault
    assert "the same call continues the match" in error.remedy
    file.unlink()
    record = played(tmp_path / "m", Deadly(file))
    assert record == played(tmp_path / "one", Deadly(file))


class Unloadable(Drawing):
    def __reduce__(self) -> Any:
        return _only_here, (os.getpid(),)


def _only_here(pid: int) -> Drawing:
    if pid != os.getpid():
        raise OSError("elsewhere")
    return Drawing()


def test_a_player_that_cannot_reach_another_process_is_refused_before_the_first_frame(
    tmp_path: Path,
) -> None:
    class Local(Drawing):
        pass

    refused = r"^one: the player cannot be pickled for another process \(.*; define its class at"
    with pytest.raises(InputError, match=refused):
        played(tmp_path / "m", Local, processes=2)
    assert not (tmp_path / "m").exists()
    refused = r"^processes: another process cannot load the players \(OSError: elsewhere\)"
    with pytest.raises(InputError, match=refused):
        played(tmp_path / "m", Unloadable(), processes=1)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"processes": 0}, r"^processes: 0 is out of range"),
        ({"processes": 2, "threads": 2}, r"^threads: processes is given too"),
    ],
)
def test_a_wrong_number_of_processes_is_refused(
    settings: dict[str, int], message: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=message):
        played(tmp_path / "m", **settings)


PROGRAM = """
import os, time
import carom

class Waiting:
    def choose(self, situation):
        os.write(1, b"choosing\\n")
        WAIT

def main():
    carom.play_match(Waiting, Waiting, out="m", game="nine-ball", pairs=4, processes=2)

BEGIN
"""
GUARDED = """if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        print("interrupted", flush=True)"""


def program(folder: Path, wait: str, begin: str) -> subprocess.Popen[str]:
    file = folder / "program.py"
    file.write_text(PROGRAM.replace("WAIT", wait).replace("BEGIN", begin))
    return subprocess.Popen(
        [sys.executable, file],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


def is_alone(group: int) -> bool:
    """Whether all processes of a group end soon."""
    for _ in range(100):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False


@pytest.mark.parametrize(
    ("wait", "send"), [("time.sleep(1000)", os.kill), ("while True: pass", os.killpg)]
)
def test_ctrl_c_ends_all_processes(wait: str, send: Any, tmp_path: Path) -> None:
    with program(tmp_path, wait, GUARDED) as process:
        assert process.stdout is not None
        assert [process.stdout.readline() for _ in range(2)] == ["choosing\n"] * 2
        send(process.pid, signal.SIGINT)
        out, told = process.communicate(timeout=60)
    assert out == "interrupted\n"
    assert told == ""
    assert is_alone(process.pid)


def test_a_program_that_would_begin_again_in_its_processes_is_explained(tmp_path: Path) -> None:
    with program(tmp_path, "return 'concede'", "main()") as process:
        _, told = process.communicate(timeout=60)
    assert process.returncode == 1
    assert 'put the call under if __name__ == "__main__":' in told.splitlines()[-1]
    assert is_alone(process.pid)


MINE = """
from beside import AZIMUTH
import carom

class Mine:
    def choose(self, situation):
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        place = (0.635, 0.5) if request.in_hand else None
        return carom.Play(carom.Strike(3.0, AZIMUTH), cue_ball=place)
"""


def test_the_command_line_plays_a_file_in_several_processes(run: CommandLine) -> None:
    (run.cwd / "mine.py").write_text(MINE)
    (run.cwd / "beside.py").write_text("AZIMUTH = 1.2\n")
    words = ["match", "mine.py:Mine", OTHER, "--game", "nine-ball", "--pairs", "2"]
    words += ["--simulations", "50", "--secret", "cd" * 32]
    records = []
    for name, more in (("one", ()), ("two", ("--processes", "2"))):
        done = run(*words, "--out", name, *more)
        assert done.returncode == 0, done.stderr
        records.append((run.cwd / name / "match.jsonl").read_bytes())
    assert records[0] == records[1]
