"""The pairs of matches on several processes."""

from __future__ import annotations

import contextlib
import functools
import multiprocessing
import os
import pickle
import signal
import traceback
from collections.abc import Callable, Iterator, Mapping
from multiprocessing import connection
from typing import TYPE_CHECKING, Any

from carom.arena.contestants import Contestant, line_of
from carom.arena.pair import OpenMatch, PlayedPair, play_pair
from carom.arena.pair_queue import PairQueue
from carom.arena.plan import MatchPlan
from carom.arguments import whole
from carom.errors import InputError

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from types import FrameType

# Most worker processes: eight times the cores of a large machine.
_MOST = 1024
# Begins the names of the processes.
_NAME = "carom worker"
# A program without this line begins again in every process that it starts.
_GUARD = 'in a program that is a file, put the call under if __name__ == "__main__":'
# Time in which a process ends after it was interrupted, and after it was terminated, s. A player
# that catches the interrupt, or computes outside of Python, needs the second or third way.
_GRACE = (2.0, 1.0)


def check(players: Mapping[str, Contestant], count: int) -> int:
    """The number of processes for players.

    Args:
        players: The players by the arguments that gave them.
        count: The number of processes that was given.

    Raises:
        InputError: The number is out of range, a player cannot be pickled, or this is a process
            that another call has started.
    """
    count = whole("processes", count, _MOST + 1, low=1)
    if multiprocessing.current_process().name.startswith(_NAME):
        raise InputError(
            "wrong-state", "processes", "the program has begun again in its own process", _GUARD
        )
    for argument, player in players.items():
        try:
            pickle.loads(pickle.dumps(player.make))
        except Exception as error:
            raise InputError(
                "unsupported",
                argument,
                f"the player cannot be pickled for another process ({line_of(error)})",
                "define its class at the top of a module, and give the class, or a function there "
                "that makes the player; or leave processes out",
            ) from error
    return count


def play_in_processes(queue: PairQueue, count: int, played: Callable[[], object]) -> None:
    """Play all pairs of a queue in ``count`` processes.

    After an exception or the end of a process, the other processes play the pairs that they have
    begun to their end.

    Args:
        queue: The pairs.
        count: Number of processes.
        played: Called when a pair was played.

    Raises:
        InputError: A process has ended, or cannot load the players.
        Exception: What a player raised, if the plan is strict.
        KeyboardInterrupt: Ctrl-C; all processes have ended.
    """
    pickled = _Plans()
    with _workers(count) as workers:
        failure: BaseException | None = None
        begun = [worker for worker in workers if worker.give(queue.next_pair(), pickled)]
        busy: dict[Any, _Worker] = {worker.connection: worker for worker in begun}
        while busy:
            for ready in connection.wait(list(busy)):
                worker = busy.pop(ready)
                try:
                    queue.add(*worker.played())
                except BaseException as error:  # noqa: BLE001 -- raised when the others are done
                    failure = failure or error
                    continue
                played()
                if failure is None and worker.give(queue.next_pair(), pickled):
                    busy[worker.connection] = worker
    if failure is not None:
        raise failure


class _Plans:
    """The pickled plan of the match whose pairs are given out."""

    def __init__(self) -> None:
        self._match: OpenMatch | None = None
        self._plan = b""

    def of(self, match: OpenMatch) -> bytes:
        if match is not self._match:
            self._match, self._plan = match, pickle.dumps(match.plan)
        return self._plan


class _Worker:
    """A process that plays pairs, seen from the process that has the matches."""

    def __init__(self, number: int) -> None:
        context = multiprocessing.get_context("spawn")
        self.connection, far_end = context.Pipe()
        self.name = f"{_NAME} {number}"
        # The match and the number of the pair that it plays.
        self.pair: tuple[OpenMatch, int] | None = None
        self.process = context.Process(target=_work, args=(far_end,), name=self.name, daemon=True)
        with _no_interrupt():
            self.process.start()
        # Else the end of the process would not end the connection.
        far_end.close()

    def give(self, pair: tuple[OpenMatch, int] | None, plans: _Plans) -> bool:
        """Send a pair to play, with the plan of its match if it is another one than before.

        Returns:
            Whether there is a pair.
        """
        before, self.pair = self.pair, pair
        if pair is None:
            return False
        match, number = pair
        plan = None if before and match is before[0] else plans.of(match)
        # The end of a process is noticed when its answer is read.
        with contextlib.suppress(OSError):
            self.connection.send((plan, number))
        return True

    def played(self) -> tuple[OpenMatch, PlayedPair]:
        """The pair that it has played, and its match."""
        assert self.pair is not None
        try:
            said = self.connection.recv()
        except (EOFError, OSError):
            self.process.join()
            raise self._ended() from None
        if isinstance(said, PlayedPair):
            return self.pair[0], said
        error, notes = said
        for note in notes:
            error.add_note(note)
        raise error

    def _ended(self) -> InputError:
        assert self.pair is not None
        code = self.process.exitcode or 0
        how = f"with exit code {code}"
        if code < 0:
            how = f"by signal {-code} ({signal.strsignal(-code) or 'unknown'})"
        remedy = "the same call continues the match; all pairs that were finished are kept"
        if code > 0:
            remedy = f"{_GUARD}; else look at its messages above; {remedy}"
        place = f"{self.name} (process {self.process.pid})"
        return InputError(
            "stopped", place, f"ended {how} while it played pair {self.pair[1]}", remedy
        )

    def interrupt(self) -> None:
        """Interrupt the process, as Ctrl-C does."""
        if self.process.is_alive() and self.process.pid is not None and os.name == "posix":
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.process.pid, signal.SIGINT)


@contextlib.contextmanager
def _workers(count: int) -> Iterator[list[_Worker]]:
    """Processes that wait for pairs; they end with the context."""
    workers: list[_Worker] = []
    try:
        workers.extend(_Worker(number) for number in range(count))
        yield workers
    except BaseException:
        for worker in workers:
            worker.interrupt()
        raise
    finally:
        for worker in workers:
            # A process that waits for a pair ends when its connection does.
            worker.connection.close()
        for end, grace in (("terminate", _GRACE[0]), ("kill", _GRACE[1])):
            for worker in workers:
                worker.process.join(grace)
            for worker in workers:
                if worker.process.is_alive():
                    getattr(worker.process, end)()
        for worker in workers:
            worker.process.join()


@contextlib.contextmanager
def _no_interrupt() -> Iterator[None]:
    """Ctrl-C waits meanwhile; a process that is started here begins with it waiting."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work(mine: Connection[Any, Any]) -> None:
    """Play the pairs that come, until the connection ends, in a process of its own."""
    is_interrupted = False

    def interrupt(_number: int, _where: FrameType | None) -> None:
        # A terminal interrupts all processes, and then the first one does it again.
        nonlocal is_interrupted
        if not is_interrupted:
            is_interrupted = True
            raise KeyboardInterrupt

    # The other process may have closed the connection.
    with contextlib.suppress(KeyboardInterrupt, EOFError, OSError):
        signal.signal(signal.SIGINT, interrupt)
        if hasattr(signal, "pthread_sigmask"):
            signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
        plan = b""
        while True:
            other, number = mine.recv()
            plan = plan if other is None else other
            mine.send(_answer(plan, number))


def _answer(plan: bytes, number: int) -> PlayedPair | tuple[BaseException, list[str]]:
    """A pair that was played, or an exception with its notes."""
    try:
        return play_pair(_load(plan), number)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # noqa: BLE001 -- it is raised in the process that has the match
        told = "".join(traceback.format_exception(error))
        notes = [
            *getattr(error, "__notes__", ()),
            f"In the process that played pair {number}:\n{told}",
        ]
        try:
            pickle.loads(pickle.dumps(error))
        except Exception:  # noqa: BLE001 -- it may raise anything
            return RuntimeError(line_of(error)), notes
        return error, notes


@functools.lru_cache(maxsize=1)
def _load(plan: bytes) -> MatchPlan:
    try:
        return pickle.loads(plan)  # type: ignore[no-any-return]
    except Exception as error:
        raise InputError(
            "unsupported",
            "processes",
            f"another process cannot load the players ({line_of(error)})",
            "define their classes in a file or a module, not in a notebook; or leave processes out",
        ) from error
