"""Forked processes, and systems that refuse threads: the same results, and Ctrl-C ends the work."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

if not hasattr(os, "fork"):
    pytest.skip("the system has no fork", allow_module_level=True)

# A program that does nothing for so long, s, hangs. It is ended, and its test fails.
LIMIT = 240

# Calls that use all cores. Three threads also on a machine with one core.
SETUP = """
import multiprocessing, os, signal, sys
import carom, carom.env, gymnasium
import numpy as np

club = carom.Noise.preset("club")
cut = carom.Shot("wpa-9ft", {"cue": (0.5, 1.2), "9": (0.9, 1.9)}, carom.Strike(2.0, 1.05))
azimuths = cut.azimuth + np.linspace(-0.01, 0.01, 500)
player = carom.Player("carom:200", noise=club)
many = {"num_envs": 64, "vectorization_mode": "vector_entry_point"}
vector = gymnasium.make_vec("carom/Potting-v3", **many)

def step(environments):
    environments.reset(seed=7)
    actions = np.zeros(environments.action_space.shape, dtype=np.float32)
    return environments.step(actions)[0].tolist()

calls = {
    "batch": lambda: cut.batch(azimuth=azimuths).final_position.tolist(),
    "simulate_batch": lambda: carom.simulate_batch([cut] * 500).final_position.tolist(),
    "vary": lambda: cut.vary(club, 500).final_position.tolist(),
    "evaluate": lambda: str(cut.evaluate(club, 2000)),
    "solve": lambda: str(cut.solve(pot="9", n=200)),
    "map": lambda: cut.pot_map("9", "top-right", columns=8, n=20).chance.tolist(),
    "player": lambda: str(player.explain(cut, game="nine-ball")),
    "vector": lambda: step(vector),
    "breaks": lambda: str(carom.break_statistics("nine-ball", 100)),
    "sweep": lambda: carom.Sweep.from_dict(
        {"format": "carom-sweep/1", "shots": cut, "samples": 3000,
         "vary": {"strike.speed": {"uniform": [1, 3]}}}
    ).table().to_pylist(),
}
"""


def run(program: str, **variables: str) -> str:
    """What a program prints. A program that hangs is killed with its children."""
    environment = os.environ | {"RAYON_NUM_THREADS": "3"} | variables
    with subprocess.Popen(
        [sys.executable, "-c", SETUP + program],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment,
        text=True,
        start_new_session=True,
    ) as process:
        try:
            out, told = process.communicate(timeout=LIMIT)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            pytest.fail("the program hangs")
    assert process.returncode == 0, told
    return out


FORK = """
two = carom.Player("carom:200", noise=club, threads=2)
own = gymnasium.make_vec("carom/Potting-v3", **many, threads=2)
calls["player with two threads"] = lambda: str(two.explain(cut, game="nine-ball"))
calls["vector with two threads"] = lambda: step(own)
for name, call in calls.items():
    here = call()
    if (child := os.fork()) == 0:
        signal.alarm(60)
        os._exit(0 if call() == here else 1)
    _, status = os.waitpid(child, 0)
    print(name, "ok" if status == 0 else f"status {status}")
"""


def test_a_forked_child_works_on_all_cores_after_its_parent_did() -> None:
    # The child waited for ever for threads that only its parent had.
    told = run(FORK).splitlines()
    assert len(told) == 12
    assert [line for line in told if not line.endswith(" ok")] == []


POOL = """
from concurrent.futures import ProcessPoolExecutor

def work(seed):
    return str(cut.evaluate(club, 2000, seed=seed)), cut.batch(azimuth=azimuths).events.tolist()

here = [work(seed) for seed in range(4)]
context = multiprocessing.get_context("fork")
with context.Pool(2) as pool:
    assert pool.map(work, range(4)) == here
with ProcessPoolExecutor(2, mp_context=context) as pool:
    assert list(pool.map(work, range(4))) == here
print("same")
"""


def test_pools_of_forked_processes_give_the_results_of_their_parent() -> None:
    assert run(POOL) == "same\n"


GRANDCHILD = """
here = calls["batch"]()
if os.fork() == 0:
    signal.alarm(60)
    same = calls["batch"]() == here
    if (grandchild := os.fork()) == 0:
        signal.alarm(60)
        os._exit(0 if same and calls["batch"]() == here else 1)
    _, status = os.waitpid(grandchild, 0)
    os._exit(0 if status == 0 and calls["batch"]() == here else 1)
_, status = os.wait()
print(status, calls["batch"]() == here)
"""


def test_a_child_of_a_child_works_and_the_parents_keep_their_threads() -> None:
    assert run(GRANDCHILD) == "0 True\n"


BUSY_PARENT = """
import threading

stop = threading.Event()

def busy():
    while not stop.is_set():
        cut.batch(azimuth=azimuths)

here = calls["batch"]()
threads = [threading.Thread(target=busy) for _ in range(3)]
for thread in threads:
    thread.start()
statuses = []
for _ in range(20):
    if (child := os.fork()) == 0:
        signal.alarm(60)
        os._exit(0 if calls["batch"]() == here else 1)
    statuses.append(os.waitpid(child, 0)[1])
stop.set()
for thread in threads:
    thread.join()
print(statuses)
"""


def test_a_child_works_that_was_forked_while_other_threads_computed() -> None:
    assert run(BUSY_PARENT) == f"{[0] * 20}\n"


INTERRUPTED = """
import threading

long = {
    "evaluate": lambda: cut.evaluate(club, 10**9),
    "solve": lambda: cut.solve(pot="9", n=10**7),
    "batch": lambda: cut.batch(speed=np.full(10**7, 3.0)),
    "player": lambda: carom.Player(f"carom:{10**8}", noise=club).explain(cut, game="nine-ball"),
    "vector": lambda: [step(vector) for _ in range(10**9)],
}
signal.signal(signal.SIGINT, signal.default_int_handler)
for name, call in calls.items():
    call()
for name, call in long.items():
    if (child := os.fork()) == 0:
        signal.alarm(60)
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        try:
            found = call()
        except KeyboardInterrupt:
            os._exit(0)
        # A player answers with what it has found so far.
        os._exit(0 if getattr(found, "interrupted", False) else 1)
    print(name, os.waitpid(child, 0)[1])
"""


def test_ctrl_c_ends_the_work_of_a_forked_child() -> None:
    told = run(INTERRUPTED).splitlines()
    assert told == [f"{name} 0" for name in ("evaluate", "solve", "batch", "player", "vector")]


# Refused threads.

# No system has room for a stack of this size, bytes, so it starts no thread at all.
STACK = 1 << 47

REFUSED = f"""
import threading

threading.stack_size({STACK})
try:
    threading.Thread(target=int).start()
except RuntimeError:
    pass
else:
    sys.exit("a thread could be started")
"""


def refused(program: str) -> str:
    """What a program prints to which the system refuses all threads."""
    return run(REFUSED + program, RUST_MIN_STACK=str(STACK))


PRINT = "print({name: call() for name, call in calls.items()})"


def test_without_any_thread_the_results_are_the_same() -> None:
    # A refused thread was a panic of Rust, which is not an Exception.
    assert refused(PRINT) == run(PRINT)


NUMBER = """
try:
    cut.batch(azimuth=azimuths, threads=2)
except carom.InputError as error:
    print(error)
"""


def test_a_number_of_threads_that_the_system_refuses_is_named() -> None:
    assert refused(NUMBER).startswith("threads: 2 threads could not be started (")


ALONE = """
import tempfile, time

long = {
    "evaluate": lambda: cut.evaluate(club, 10**9),
    "solve": lambda: cut.solve(pot="9", n=10**7),
    "map": lambda: cut.pot_map("9", "top-right", columns=4, n=10**7),
    "breaks": lambda: carom.break_statistics("snooker", 10**6),
    "player": lambda: carom.Player(f"carom:{10**8}", noise=club).explain(cut, game="nine-ball"),
}
signal.signal(signal.SIGINT, signal.default_int_handler)
for name, call in long.items():
    if (timer := os.fork()) == 0:
        time.sleep(0.5)
        os.kill(os.getppid(), signal.SIGINT)
        os._exit(0)
    signal.alarm(60)
    try:
        print(name, call().interrupted)
    except KeyboardInterrupt:
        print(name, True)
    os.waitpid(timer, 0)
"""


def test_ctrl_c_ends_work_that_no_thread_can_watch() -> None:
    told = refused(ALONE).splitlines()
    assert told == [f"{name} True" for name in ("evaluate", "solve", "map", "breaks", "player")]


BARS = """
import io, tempfile

sys.stderr = io.StringIO()
with tempfile.TemporaryDirectory() as folder:
    spec = {"format": "carom-sweep/1", "shots": cut, "samples": 3000,
            "vary": {"strike.speed": {"uniform": [1, 3]}}}
    print(carom.sweep(spec, folder, part_rows=1000, threads=3, progress=True).rows)
cut.evaluate(club, 2000, progress=True)
print("3000/3000" in sys.stderr.getvalue(), "2000/2000" in sys.stderr.getvalue())
"""


def test_sweeps_and_progress_bars_need_no_thread() -> None:
    assert refused(BARS) == "3000\nTrue True\n"


SERVED = """
import socket
from carom.serve import PageServer

with PageServer("<p>carom</p>") as server:
    with socket.create_connection(server.server_address) as browser:
        browser.sendall(b"GET / HTTP/1.1\\r\\nHost: 127.0.0.1:%d\\r\\n\\r\\n" % server.server_port)
        server.handle_request()
        print(browser.recv(1 << 16).decode().splitlines()[0])
"""


def test_a_page_is_served_without_a_thread() -> None:
    assert refused(SERVED) == "HTTP/1.1 200 OK\n"
