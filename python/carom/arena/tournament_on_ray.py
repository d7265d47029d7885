"""A tournament on Ray: pairs of frames are played by processes on one machine or on many.

The machine of the call has the folder, so the others need none. Every pair is a function of its
match and its number, so the records are those of a run without Ray.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from carom import __version__, cluster
from carom.arena.pair import OpenMatch, PlayedPair, play_pair
from carom.arena.pair_queue import PairQueue
from carom.arena.tournament_folder import Block
from carom.arena.tournament_run import Worker
from carom.errors import InputError

# The module that every worker needs.
_MODULE = "carom.arena.pair"
# Pairs that wait or are played, for each core: a core that ends one finds the next one there.
_PAIRS_OF_CORE = 2


def play_on_ray(
    worker: Worker,
    blocks: Sequence[Block],
    address: bool | str,
    threads: int,
    advance: Callable[[int], object],
) -> None:
    """Play blocks with Ray's workers.

    If a worker is lost, Ray gives its pair to another one, which plays the same pair.

    Raises:
        InputError: As for ``cluster.start``, or a worker refuses a pair.
    """
    cluster.start(address, threads, _MODULE)
    library = cluster.ray()
    version = __version__

    def work(plan: Any, number: int) -> PlayedPair | tuple[str, str, str, str]:
        # An error is returned as a value: Ray would add two pages of its own text to an exception.
        try:
            cluster.check_version(version)
            return play_pair(plan, number)
        except InputError as error:
            return error.kind, error.place, error.fault, error.remedy

    task = library.remote(num_cpus=1)(work)
    most = _PAIRS_OF_CORE * cluster.cores()
    # The match of each pair that is played.
    running: dict[Any, OpenMatch] = {}
    # The plan of the match whose pairs are given out, in Ray's store.
    stored: tuple[OpenMatch, Any] | None = None
    with PairQueue(worker.matches(blocks), OpenMatch.close) as queue:
        while True:
            while len(running) < most and (pair := queue.next_pair()):
                match, number = pair
                if stored is None or stored[0] is not match:
                    stored = match, library.put(match.plan)
                running[task.remote(stored[1], number)] = match
            if not running:
                return
            done, _ = library.wait(list(running))
            for each in done:
                of_pair, played = running.pop(each), library.get(each)
                if isinstance(played, tuple):
                    raise InputError(*played)
                queue.add(of_pair, played)
                advance(1)
