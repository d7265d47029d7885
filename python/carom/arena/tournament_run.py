"""Playing the missing blocks of a tournament on the cores of this machine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from threading import Event, Lock
from typing import Any

from carom.arena.match import play_match
from carom.arena.pair import OpenMatch
from carom.arena.pair_queue import PairQueue
from carom.arena.plan import MatchPlan
from carom.arena.processes import check, play_in_processes
from carom.arena.tournament_folder import Block, secret_of
from carom.errors import InputError
from carom.files import shown

# Seconds between two looks at Ctrl-C.
_PATIENCE = 0.2


class _Stopped(Exception):  # noqa: N818 -- a stop is not an error
    """Another block has failed, or Ctrl-C has come."""


@dataclass(frozen=True, slots=True)
class Worker:
    """Plays blocks.

    Attributes:
        root: The folder of the tournament.
        contestants: The players by their names in the tournament (``Contestant``).
        secret: The secret of the tournament; None if every block has one of its own.
    """

    root: Path
    contestants: Mapping[str, Any]
    secret: str | None

    def plan(self, block: Block) -> MatchPlan:
        """The match of a block."""
        one, other = (self.contestants[name] for name in block.encounter.players)
        return MatchPlan(
            one,
            other,
            pairs=block.pairs,
            test=block.encounter.event.test,
            secret=None if self.secret is None else secret_of(self.secret, self.root, block),
            **block.encounter.condition.arguments(),
        )

    def matches(self, blocks: Iterable[Block]) -> Iterator[OpenMatch]:
        """The matches of blocks, each opened when it is taken."""
        for block in blocks:
            yield OpenMatch(self.plan(block), block.folder)

    def play(self, block: Block, threads: int, report: Callable[[int, int], object]) -> None:
        """Play a block to its end, or continue it.

        Args:
            block: The block.
            threads: Number of threads.
            report: Called with the pairs done and all pairs now and then; its exception stops the
                block, which is continued with the next call.
        """
        one, other = (self.contestants[name] for name in block.encounter.players)
        play_match(
            one,
            other,
            out=block.folder,
            pairs=block.pairs,
            test=block.encounter.event.test,
            secret=None if self.secret is None else secret_of(self.secret, self.root, block),
            threads=threads,
            progress=report,
            **block.encounter.condition.arguments(),
        )

    def check_players(self, blocks: Sequence[Block]) -> None:
        """Refuse a built-in player that decides otherwise than in the records of the blocks.

        Raises:
            InputError: With the name of the player.
        """
        entries = {name: player.entry for name, player in self.contestants.items()}
        for block in blocks:
            header = block.header()
            if header is None:
                continue
            for name, found in zip(block.encounter.players, header["players"], strict=True):
                now = entries[name]
                if now is None or found == now:
                    continue
                what = f"it decides otherwise than in {shown(block.record)}"
                remedy = "give the changed player another name, or choose another folder"
                raise InputError("changed", f"players.{name}", what, remedy)


def process_count(worker: Worker, count: int) -> int:
    """The number of processes for a tournament.

    Raises:
        InputError: The number is out of range, or a player cannot be pickled; the place is that of
            its name.
    """
    return check({f"players.{name}": each for name, each in worker.contestants.items()}, count)


def play_in_others(
    worker: Worker, blocks: Sequence[Block], count: int, advance: Callable[[int], object]
) -> None:
    """Play blocks pair by pair in ``count`` other processes: players in Python use all cores.

    Raises:
        InputError: A process has ended, or cannot load the players.
    """
    with PairQueue(worker.matches(blocks), OpenMatch.close) as queue:
        most = min(count, sum(block.pairs for block in blocks))
        play_in_processes(queue, most, lambda: advance(1))


def play_here(
    worker: Worker, blocks: Sequence[Block], threads: int, advance: Callable[[int], object]
) -> None:
    """Play blocks, several at once: Rust releases the interpreter's lock.

    Every block has one thread. If there are fewer blocks than threads, they share the threads.
    """
    stop, lock = Event(), Lock()
    each = max(1, threads // len(blocks))

    def play(block: Block) -> None:
        before = 0

        def report(done: int, _: int) -> None:
            nonlocal before
            if stop.is_set():
                raise _Stopped
            with lock:
                advance(done - before)
            before = done

        worker.play(block, each, report)

    left = iter(blocks)
    with ThreadPoolExecutor(threads) as pool:
        running: list[Future[None]] = []
        try:
            while True:
                for block in left:
                    running.append(pool.submit(play, block))
                    if len(running) >= threads:
                        break
                if not running:
                    return
                wait(running, timeout=_PATIENCE, return_when=FIRST_COMPLETED)
                # In the order of the blocks, so that an error is that of the first of them.
                for future in [one for one in running if one.done()]:
                    running.remove(future)
                    future.result()
        finally:
            # After Ctrl-C, or an error such as a full disk, the blocks stop until the next run.
            stop.set()
            for future in running:
                future.cancel()
