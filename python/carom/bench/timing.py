"""Times of shots of carom and of the peer, of threads, of a large batch and of the import.

Single-core work is measured in processor time, for both engines, because other work on the machine
disturbs it less. Work on many cores and new processes are measured in wall time.
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

from carom.batch import VARIABLES, own_strike, simulate_batch
from carom.shot import Shot

if TYPE_CHECKING:
    from carom.bench.peer import Pooltool
    from carom.bench.states import State

#: Number of rounds. Each round times every state once, in both engines. Two rounds that other work
#: on the machine slowed do not change a median of five.
ROUNDS = 5
#: Duration of one timing of carom, s. The fixed cost of a call (arrays, a pool of one thread; about
#: 0.05 ms) is then about a hundredth of it, and the resolution of the clock is far below that.
STRETCH = 4e-3
#: Duration of one timing of carom's shots in turn, s: a few passes over the states of a class.
IN_TURN = 20e-3
#: Most repetitions of one shot in a call, so that its arrays stay in the cache.
MOST_REPETITIONS = 4096
#: Shots in a timing of many threads.
THREADED_SHOTS = 50_000
#: Variants in the large batch.
VARIANTS = 100_000
#: Standard deviations of the large batch's strikes, those of a good player.
SPREAD = {"speed": 0.05, "azimuth": 0.005, "side": 0.02, "height": 0.02}
#: Fresh interpreters that import carom; the median counts.
IMPORTS = 7


@dataclass
class ClassTimes:
    """Seconds per shot for the states of one class; every list has one entry per state.

    Attributes:
        ours: Median over the rounds, the same shot repeated, without a trace.
        traced: The same with a trace, from the call in Python to the finished `Trace`.
        events: Number of events.
        mixed: Mean over all states in turn, each unlike the one before; median over the rounds.
        peer: The peer's median over the rounds; empty without a peer.
        peer_mixed: The peer's mean over all states in turn; median over the rounds.
        peer_events: The peer's number of events.
        same_pocketed: Whether both engines pocket the same balls.
    """

    ours: list[float] = field(default_factory=list)
    traced: list[float] = field(default_factory=list)
    events: list[int] = field(default_factory=list)
    mixed: float = 0.0
    peer: list[float] = field(default_factory=list)
    peer_mixed: float = 0.0
    peer_events: list[int] = field(default_factory=list)
    same_pocketed: list[bool] = field(default_factory=list)


@contextmanager
def one_core() -> Iterator[None]:
    """Keeps this process on one core, if the operating system supports that."""
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
    """Times every state of a class in both engines.

    A round times every state once: carom by repeating the shot, then the peer. It ends with carom's
    shots in turn. The peer plays each shot once, so that its round is already one of shots in turn.

    Args:
        states: The states of the class.
        peer: The engine to compare with, if it is installed.
        advance: Called after every state of every round.

    Raises:
        RuntimeError: A state was not simulated, or did not pocket the ball that it must pocket.
    """
    shots = [Shot.from_dict(state.shot_file()) for state in states]
    rounds = [[_Sample() for _ in states] for _ in range(ROUNDS)]
    times = ClassTimes()
    _warm_up(shots, states, peer, times)
    repetitions = [_repetitions(shot) for shot in shots]
    mixed = []
    for samples in rounds:
        for state, shot, count, sample in zip(states, shots, repetitions, samples, strict=True):
            sample.ours = _untraced(shot, count)
            sample.traced = _traced(shot, count)
            if peer is not None:
                sample.peer, _ = peer.simulate(state)
            advance()
        mixed.append(_mixed(shots, sum(sample.ours for sample in samples)))
    times.mixed = statistics.median(mixed)
    for same in zip(*rounds, strict=True):
        times.ours.append(statistics.median(sample.ours for sample in same))
        times.traced.append(statistics.median(sample.traced for sample in same))
        if peer is not None:
            times.peer.append(statistics.median(sample.peer for sample in same))
    if peer is not None:
        times.peer_mixed = statistics.median(
            statistics.mean(sample.peer for sample in samples) for samples in rounds
        )
    return times


@dataclass
class _Sample:
    ours: float = 0.0
    traced: float = 0.0
    peer: float = 0.0


def _warm_up(
    shots: list[Shot], states: Sequence[State], peer: Pooltool | None, times: ClassTimes
) -> None:
    """Plays every state once in both engines: compiles the peer, counts events, checks the pots."""
    result = simulate_batch(shots, threads=1)
    if result.errors:
        index, text = next(iter(result.errors.items()))
        raise RuntimeError(f"bench state {index} was not simulated: {text}")
    times.events = result.events.tolist()
    for state, shot, pocket in zip(states, shots, result.pocket, strict=True):
        ours = {name for name, index in zip(shot.ids, pocket, strict=False) if index >= 0}
        _check_pot(state, ours, "carom")
        if peer is None:
            continue
        _, system = peer.simulate(state)
        theirs = set(peer.pocketed(system))
        _check_pot(state, theirs, f"pooltool {peer.version}")
        times.peer_events.append(peer.events(system))
        times.same_pocketed.append(ours == theirs)


def _check_pot(state: State, pocketed: set[str], engine: str) -> None:
    """Rejects a pot that misses, because its time would not be that of a pot."""
    if state.pots is not None and pocketed != {state.pots}:
        found = ", ".join(sorted(pocketed)) or "nothing"
        raise RuntimeError(
            f"{engine} pockets {found} where ball {state.pots} alone must fall; choose another "
            "state in python/carom/data/bench_states.json.gz"
        )


def _repetitions(shot: Shot) -> int:
    """Number of repetitions of a shot that take about `STRETCH`."""
    count = 16
    while count < MOST_REPETITIONS:
        seconds = _untraced(shot, count) * count
        if seconds > STRETCH / 2:
            return min(MOST_REPETITIONS, max(1, round(count * STRETCH / seconds)))
        count *= 4
    return MOST_REPETITIONS


def _untraced(shot: Shot, count: int) -> float:
    """Seconds per shot of a batch of `count` times the same strike."""
    speed = np.full(count, own_strike(shot._core)[0])
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


def _mixed(shots: list[Shot], seconds: float) -> float:
    """Mean seconds per shot of a batch in which each shot differs from the one before.

    The processor's branch prediction adapts to a shot that is repeated a thousand times, so the
    median of repeated shots is too low for mixed work. `seconds` is roughly the time that all
    shots together take once.
    """
    many = shots * max(1, round(IN_TURN / seconds))
    start = time.process_time()
    simulate_batch(many, threads=1)
    return (time.process_time() - start) / len(many)


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
    """Seconds that one call takes for `VARIANTS` variants of one shot, on all cores."""
    rng = np.random.default_rng(0)
    mean = dict(zip(VARIABLES, own_strike(shot._core), strict=True))
    given: dict[str, Any] = {
        name: mean[name] + sigma * rng.standard_normal(VARIANTS) for name, sigma in SPREAD.items()
    }
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
        printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
        seconds.append(float(printed[0]))
        peaks.append(float(printed[1]))
    return {"seconds": statistics.median(seconds), "megabytes": statistics.median(peaks)}
