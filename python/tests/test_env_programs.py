"""Programs and files of players as the opponents of environments."""

from __future__ import annotations

import os
import pickle
import shlex
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom.errors import InputError

on_linux = pytest.mark.skipif(sys.platform != "linux", reason="programs play on Linux")

EXAMPLE = Path(__file__).parents[2] / "examples" / "arena" / "player.py"
SOFT = np.array([0.5, -0.9, 0, 0, 0, 0, 0], dtype=np.float32)

# A program that greets and then runs ANSWER for every request.
PROGRAM = """
import json, os, sys, time
def send(**message):
    print(json.dumps(message), flush=True)
for line in sys.stdin:
    message = json.loads(line)
    kind = message["type"]
    if kind == "hello":
        send(type="hello", name="test")
    elif kind == "match":
        send(type="ready")
    elif kind in ("request", "refused"):
        ANSWER
"""
CONCEDE = 'send(type="concede", id=message["id"])'


@pytest.fixture
def program(tmp_path: Path) -> Any:
    def write(answer: str = CONCEDE, name: str = "a program.py") -> str:
        file = tmp_path / name
        file.write_text(PROGRAM.replace("ANSWER", answer), encoding="utf-8")
        return f"exec:{shlex.quote(sys.executable)} {shlex.quote(str(file))}"

    return write


def running(word: str) -> int:
    """Number of processes with ``word`` in their command line."""
    count = 0
    for folder in Path("/proc").iterdir():
        try:
            count += word.encode() in (folder / "cmdline").read_bytes()
        except OSError:
            continue
    return count


def example() -> str:
    return f"exec:{shlex.quote(sys.executable)} {shlex.quote(str(EXAMPLE))}"


@on_linux
def test_the_example_plays_whole_episodes_in_vectors_as_in_single_environments() -> None:
    settings: dict[str, Any] = {
        "opponent": example(),
        "seat": "alternate",
        "noise": carom.Noise.olympiad(1.0),
        "balls": (2, 3),
        "aim": "relative",
        "patience": 6,
    }
    vector = gymnasium.make_vec("carom/NineBall-v3", num_envs=3, **settings)
    single = gymnasium.make("carom/NineBall-v3", **settings)
    rows, info = vector.reset(seed=7)
    row, one = single.reset(seed=8)
    np.testing.assert_array_equal(rows[1], row)
    random, ended = np.random.default_rng(1), 0
    for _ in range(12):
        assert info["player"][1] == one["seat"]
        action = random.uniform(-1, 1, vector.action_space.shape).astype(np.float32)
        rows, rewards, terminated, truncated, info = vector.step(action)
        row, reward, over, cut, one = single.step(action[1])
        assert (rewards[1], terminated[1], truncated[1]) == (reward, over, cut)
        if over or cut:
            ended += 1
            assert "test" not in one["why"]
            row, one = single.reset()
        np.testing.assert_array_equal(rows[1], row)
    assert ended > 0
    vector.close()
    single.close()


@on_linux
def test_close_ends_every_process_and_another_step_starts_them_again(program: Any) -> None:
    word = f"program {time.time_ns()}.py"
    answer = (
        'play = {"strike": {"speed": 1.0, "azimuth": 1.2}}\n'
        '        if message.get("in_hand"): play["cue_ball"] = [0.635, 0.5]\n'
        '        send(type="play", id=message["id"], **play)'
    )
    opponent = program(answer, word)
    envs = carom.env.CaromVectorEnv("nine-ball", 3, opponent=opponent)
    envs.reset(seed=1)
    assert running(word) == 0
    soft = np.tile(SOFT, (3, 1))
    envs.step(soft)
    # A program in a namespace has a process outside of it too.
    three = running(word)
    assert three in (3, 6)
    twin = envs.copy()
    twin.step(soft)
    assert running(word) == 2 * three
    twin.close()
    envs.reset(seed=2)
    assert running(word) == 0
    state = envs.get_state()
    envs.step(soft)
    envs.set_state(state)
    assert running(word) == 0
    envs.step(soft)
    assert running(word) == three
    envs.close()
    assert running(word) == 0
    envs.step(soft)
    assert running(word) == three
    del envs, twin
    assert running(word) == 0


@on_linux
def test_no_process_is_left_when_the_interpreter_ends(tmp_path: Path, program: Any) -> None:
    word = f"program {time.time_ns()}.py"
    answer = 'send(type="play", id=message["id"], strike={"speed": 1, "azimuth": 1})'
    opponent = program(answer, word)
    script = tmp_path / "script.py"
    script.write_text(
        "import numpy, os, carom.env\n"
        f"env = carom.env.CaromEnv('nine-ball', opponent={opponent!r}, balls=3)\n"
        "env.reset(seed=1)\n"
        f"env.step(numpy.array({SOFT.tolist()}, dtype=numpy.float32))\n"
        "print(env._core.player(0), flush=True)\n"
        "import sys\n"
        "sys.stdin.readline()\n"
        "os._exit(0)\n"
    )
    with subprocess.Popen(
        [sys.executable, str(script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as child:
        assert child.stdin is not None
        assert child.stdout is not None
        assert child.stdout.readline().strip() == b"0"
        assert running(word) > 0
        child.communicate(b"\n", timeout=60)
    deadline = time.monotonic() + 20
    while running(word) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert running(word) == 0


@on_linux
@pytest.mark.parametrize(
    ("answer", "clock", "why"),
    [
        (CONCEDE, None, "the other player conceded"),
        ('raise ValueError("no idea")', None, "crash: the program ended with exit status 1"),
        ("os._exit(3)", None, "crash: the program ended with exit status 3"),
        ("time.sleep(1000)", 0.3, "time-over: the player's time was over"),
        ('print("x\\n" * 100000, flush=True)', None, "flood: "),
        ('print("x" * 3000000, flush=True)', None, "long-line: "),
        ('print("[" * 100, flush=True)', None, "refusals: the player gave 11 refused answers"),
        (
            'send(type="play", id=message["id"], strike={"speed": -1, "azimuth": 1})',
            None,
            "refusals: the player gave 11 refused answers",
        ),
    ],
)
def test_a_program_that_fails_loses_the_frame_and_the_reason_is_in_info(
    program: Any, answer: str, clock: float | None, why: str
) -> None:
    word = f"program {time.time_ns()}.py"
    env = carom.env.CaromEnv("nine-ball", opponent=program(answer, word), clock=clock)
    env.reset(seed=1)
    _, reward, terminated, truncated, info = env.step(SOFT)
    assert (terminated, truncated) == (True, False)
    assert (info["winner"], info["player"]) == (0, -1)
    assert info["why"].startswith(why)
    assert reward > 0.5
    assert running(word) == 0
    # The next episode has another process.
    env.reset()
    assert env.step(SOFT)[4]["why"].startswith(why)


@on_linux
def test_a_program_that_fails_before_the_first_step_loses_in_it_also_after_a_copy_of_the_state(
    program: Any,
) -> None:
    env = carom.env.CaromEnv("nine-ball", opponent=program("os._exit(3)"), seat=1)
    _, info = env.reset(seed=1)
    assert info["player"] == -1
    twin = pickle.loads(pickle.dumps(env))
    for each in (env, twin):
        _, reward, terminated, _, info = each.step(SOFT)
        assert (reward, terminated, info["winner"]) == (1.0, True, 1)
        assert info["why"].startswith("crash: the program ended with exit status 3")


@on_linux
def test_a_program_is_told_why_an_answer_is_refused_and_what_came_before(program: Any) -> None:
    answer = """
        if kind == "request":
            told = message
            send(type="play", id=message["id"], strike={"speed": 99.0, "azimuth": 1})
        else:
            assert message["place"] == "strike.speed", message
            assert told["last"]["seat"] == 0 and told["last"]["strike"]["speed"] > 0
            assert told["clocks"][1]["left"] <= 600 and told["frame"] == 0 and told["seat"] == 1
            assert told["noise"][0]["speed"] == told["noise"][1]["speed"]
            send(type="concede", id=message["id"])
"""
    env = carom.env.CaromEnv("nine-ball", opponent=program(answer.strip()))
    env.reset(seed=1)
    assert env.step(SOFT)[4]["why"] == "the other player conceded"


@on_linux
def test_ctrl_c_stops_a_step_that_waits_for_a_program(
    program: Any, request: pytest.FixtureRequest
) -> None:
    # A shell ignores SIGINT in what it starts in the background.
    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, usual))
    word = f"program {time.time_ns()}.py"
    env = carom.env.CaromEnv("nine-ball", opponent=program("time.sleep(1000)", word))
    env.reset(seed=1)
    timer = threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        env.step(SOFT)
    assert running(word) == 0
    with pytest.raises(InputError, match="did not end"):
        env.step(SOFT)
    env.reset(seed=1)


@on_linux
def test_branches_have_processes_of_their_own_which_end_with_them(program: Any) -> None:
    word = f"program {time.time_ns()}.py"
    env = carom.env.CaromEnv("nine-ball", opponent=program(CONCEDE, word))
    env.reset(seed=1)
    *_, terminated, _, _ = env.branches(np.tile(SOFT, (3, 1)))
    assert terminated.all()
    assert running(word) == 0
    with pytest.raises(InputError, match="processes of its own in each of 257 environments"):
        env.branches(np.tile(SOFT, (257, 1)))


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"opponent": "exec:no-such-program"}, 'opponent: there is no program "no-such-program"'),
        ({"opponent": "exec[menus=3]:sh"}, "opponent.menus: unknown key"),
        ({"opponent": "exec:sh", "clock": -1.0}, "clock: "),
        ({"opponent": "potter", "clock": 5.0}, "clock: it is that of a program"),
        ({"opponent": "no_such_file.py:Mine"}, "opponent: there is no file"),
        ({"task": "sum-to-three", "opponent": "exec:sh"}, "opponent"),
    ],
)
@on_linux
def test_a_program_or_file_that_is_not_possible_is_refused(
    settings: dict[str, Any], message: str
) -> None:
    with pytest.raises(InputError) as raised:
        carom.env.CaromEnv(**{"task": "nine-ball", **settings})
    assert str(raised.value).startswith(message)


def test_a_class_of_a_file_is_an_opponent_as_its_object_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "mine.py").write_text(
        "class Mine:\n"
        "    def choose(self, situation):\n"
        "        return 'concede'\n"
        "def made():\n"
        "    return Mine()\n"
    )
    monkeypatch.chdir(tmp_path)
    for opponent in (
        "mine.py:Mine",
        "mine.py:made",
        type("P", (), {"choose": lambda s, _: "concede"}),
    ):
        env: Any = carom.env.CaromEnv("nine-ball", opponent=opponent)
        env.reset(seed=1)
        assert env.step(SOFT)[4]["why"] == "the other player conceded"
    with pytest.raises(InputError, match=r"^opponent: "):
        carom.env.CaromEnv("nine-ball", opponent="mine.py:Missing")
