"""Ctrl-C ends every long call within about a second."""

from __future__ import annotations

import signal
import subprocess
import sys
import time

import pytest

# A break has many events, so that few shots take long.
SETUP = """
import signal
import carom, numpy as np
# A shell in the background lets its children ignore the interrupt.
signal.signal(signal.SIGINT, signal.default_int_handler)
club = carom.Noise.preset("club")
shot = carom.break_shot("snooker", seed=1)
cut = carom.Shot("wpa-9ft", {"cue": (0.5, 1.2), "1": (0.9, 1.9)}, carom.Strike(2.0, 1.0))
print("ready", flush=True)
try:
    CALL
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""

# Time limit of the interrupt, s: on a busy machine the process may wait for a core for seconds.
PATIENCE = 5.0


@pytest.mark.parametrize(
    "call",
    [
        "shot.evaluate(club, 10**9, threads=1)",
        "shot.vary(club, 2 * 10**6, threads=1)",
        "shot.vary(club, 2 * 10**6, perception=carom.Perception(0.001), threads=1)",
        "shot.batch(speed=np.full(2 * 10**6, 8.0), threads=1)",
        "carom.simulate_batch([shot] * 10**6, threads=1)",
        "cut.solve(pot='1', n=10**7, threads=1)",
        "cut.pot_map('1', 'top-right', columns=4, n=10**7, threads=1)",
        "cut.position_map('1', 'top-right', speed=1.0, side=np.full(10**5, 0.2), threads=1)",
        "cut.acceptance('left', speed=np.linspace(1, 9, 300), threads=1)",
        "cut.kick_table(azimuth=np.linspace(0, 6, 3 * 10**5), threads=1)",
        "carom.break_statistics('snooker', 10**6, threads=1)",
    ],
)
def test_ctrl_c_ends_a_long_call(call: str) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", SETUP.replace("CALL", call)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n", process.stderr and process.stderr.read()
        time.sleep(0.5)
        assert process.poll() is None, "the call is too short for this test"
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        out, error = process.communicate(timeout=60)
        took = time.monotonic() - sent
    assert out == "interrupted\n", error
    assert took < PATIENCE
