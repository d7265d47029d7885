"""How long things take: shots of ours and of the peer, threads, a large batch, the import.

What one core does is measured in processor time, on both sides: the other work of a busy machine
then counts less. What many cores or a start from nothing do is measured by the clock on the wall.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.batch import simulate_batch
from carom.shot import Shot

if TYPE_CHECKING:
    from carom.bench.peer import Pooltool
    from carom.bench.states import State

#: Times that every state is timed, ours and the peer's taking turns: a median of five forgives
#: two disturbances by other work on the machine.
ROUNDS = 5
#: Length of one timing of ours, s: the fixed cost of a call (arrays, a pool of one thread; some
#: 0.05 ms) stays near a hundredth of it, and noise of the clock far below that.
STRETCH = 4e-3
#: Most repetitions of one shot in a call, so that its arrays stay in the cache.
MOST_REPETITIONS = 4096
#: Shots in a timing of many threads.
THREADED_SHOTS = 50_000
#: Variants in the large batch.
VARIANTS = 100_000
#: Spread of the large batch's strikes (one standard deviation): a good player's.
SPREAD = {"speed": 0.05, "azimuth": 0.005, "side": 0.02, "height": 0.02}
#: Fresh interpreters that import carom; the median counts.
IMPORTS = 7


@dataclass
class ClassTimes:
    """Seconds per shot for the states of one class; every list has one entry per state.

    Attributes:
        ours: Median without a trace.
        traced: Median with a trace, from the call in Python to the finished `Trace`.
        events: Number of events.
        mixed: Mean over all states in turn, each unlike the one before.
        peer: The peer's median; empty without a peer.
        peer_events: The peer's number of events.
        same_pocketed: Whether both sides pocket the same balls.
    """

    ours: list[float] = field(default_factory=list)
    traced: list[float] = field(default_factory=list)
    events: list[int] = field(default_factory=list)
    mixed: float = 0.0
    peer: list[float] = field(default_factory=list)
    peer_events: list[int] = field(default_factory=list)
    same_pocketed: list[bool] = field(default_factory=list)


@contextmanager
def one_core() -> Iterator[None]:
    """Keeps this process on one core, where the system can do so."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, cores)


def time_class(
    states: Sequence[State], peer: Pooltool | None, advance: Callable[[], None]
) -> ClassTimes:
    """Times every state of a class in turn, ours and the peer's.

    `advance` is called after every state of every round.
    """
    shots = [Shot.from_dict(state.shot_file()) for state in states]
    rounds = [[_Sample() for _ in states] for _ in range(ROUNDS)]
    times = ClassTimes()
    _warm_up(shots, states, peer, times)
    repetitions = [_repetitions(shot) for shot in shots]
    for samples in rounds:
        for state, shot, count, sample in zip(states, shots, repetitions, samples, strict=True):
            sample.ours = _untraced(shot, count)
            sample.traced = _traced(shot, count)
            if peer is not None:
                sample.peer, _ = peer.simulate(state)
            advance()
    for same in zip(*rounds, strict=True):
        times.ours.append(statistics.median(sample.ours for sample in same))
        times.traced.append(statistics.median(sample.traced for sample in same))
        if peer is not None:
            times.peer.append(statistics.median(sample.peer for sample in same))
    times.mixed = _mixed(shots, times.ours)
    return times


@dataclass
class _Sample:
    ours: float = 0.0
    traced: float = 0.0
    peer: float = 0.0


def _warm_up(
    shots: list[Shot], states: Sequence[State], peer: Pooltool | None, times: ClassTimes
) -> None:
    """Every state once on both sides: compiles the peer, and tells events and outcomes."""
    result = simulate_batch(shots, threads=1)
    if result.errors:
        index, text = next(iter(result.errors.items()))
        raise RuntimeError(f"bench state {index} was not simulated: {text}")
    times.events = result.events.tolist()
    if peer is None:
        return
    for state, shot, pocket in zip(states, shots, result.pocket, strict=True):
        _, system = peer.simulate(state)
        times.peer_events.append(peer.events(system))
        ours = {name for name, index in zip(shot.ids, pocket, strict=False) if index >= 0}
        times.same_pocketed.append(ours == set(peer.pocketed(system)))


def _repetitions(shot: Shot) -> int:
    """Repetitions of a shot that fill a `STRETCH`."""
    count = 16
    while count < MOST_REPETITIONS:
        seconds = _untraced(shot, count) * count
        if seconds > STRETCH / 2:
            return min(MOST_REPETITIONS, max(1, round(count * STRETCH / seconds)))
        count *= 4
    return MOST_REPETITIONS


def _untraced(shot: Shot, count: int) -> float:
    """Seconds per shot of a batch of `count` times the same strike."""
    strike = shot.to_dict()["strike"]
    speed = np.full(count, strike["speed"])
    start = time.process_time()
    shot.batch(speed=speed, threads=1)
    return (time.process_time() - start) / count


def _traced(shot: Shot, count: int) -> float:
    """Seconds per `Shot.simulate`."""
    count = max(1, count // 4)
    start = time.process_time()
    for _ in range(count):
        shot.simulate()
    return (time.process_time() - start) / count


def _mixed(shots: list[Shot], ours: list[float]) -> float:
    """Mean seconds per shot where no shot is like the one before.

    A processor learns the branches of a shot that it plays a thousand times; this is the check
    that the medians do not owe everything to that.
    """
    turns = max(1, round(ROUNDS * STRETCH / sum(ours)))
    many = shots * turns
    seconds = []
    for _ in range(ROUNDS):
        start = time.process_time()
        simulate_batch(many, threads=1)
        seconds.append((time.process_time() - start) / len(many))
    return statistics.median(seconds)


def time_threads(shots: list[Shot]) -> dict[int, float]:
    """Shots a second of `simulate_batch`, by number of threads: 1, 2, 4 … up to every core."""
    cores = os.cpu_count() or 1
    counts = sorted({1, *(n for n in (2, 4, 8, 16, 32, 64) if n < cores), cores})
    many = shots * max(1, round(THREADED_SHOTS / len(shots)))
    rates: dict[int, float] = {}
    for threads in counts:
        simulate_batch(shots, threads=threads)
        seconds = []
        for _ in range(3):
            start = time.perf_counter()
            simulate_batch(many, threads=threads)
            seconds.append(time.perf_counter() - start)
        rates[threads] = len(many) / statistics.median(seconds)
    return rates


def time_variants(shot: Shot) -> float:
    """Seconds that one call takes for `VARIANTS` variants of one shot, on every core."""
    rng = np.random.default_rng(0)
    strike = shot.to_dict()["strike"]
    mean = {
        "speed": strike["speed"],
        "azimuth": np.radians(strike["azimuth_deg"]),
        "side": strike.get("side", 0.0),
        "height": strike.get("height", 0.0),
    }
    given = {name: mean[name] + SPREAD[name] * rng.standard_normal(VARIANTS) for name in SPREAD}
    start = time.perf_counter()
    shot.batch(**given)
    return time.perf_counter() - start


_IMPORT = """
import time
start = time.perf_counter()
import carom
seconds = time.perf_counter() - start
import re, sys
try:
    status = open("/proc/self/status").read()
    peak = int(re.search(r"VmHWM:\\s+(\\d+)", status).group(1)) / 1024
except OSError:
    import resource
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** (
        20 if sys.platform == "darwin" else 10
    )
print(seconds, peak)
"""


def time_import() -> dict[str, Any]:
    """Seconds that `import carom` takes, and the peak memory of the whole process after it, MB."""
    seconds, peaks = [], []
    for _ in range(IMPORTS):
        command = [sys.executable, "-c", _IMPORT]
        told = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
        seconds.append(float(told[0]))
        peaks.append(float(told[1]))
    return {"seconds": statistics.median(seconds), "megabytes": statistics.median(peaks)}
