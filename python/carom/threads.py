"""Threads that the operating system may refuse to start, as under the limits of a container."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from threading import Event, Thread
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")


def startable(count: int) -> int:
    """The number of threads that the system starts now, at most ``count``."""
    end = Event()
    started: list[Thread] = []
    try:
        for _ in range(count):
            thread = Thread(target=end.wait, daemon=True)
            thread.start()
            started.append(thread)
    except RuntimeError:
        # The system has no more threads.
        pass
    finally:
        end.set()
        for thread in started:
            thread.join()
    return len(started)


def in_order(call: Callable[[T], R], items: Iterable[T], threads: int) -> Iterator[R]:
    """Call a function for all items on several threads; yield the results in order.

    Only a few calls wait at any time, so that Ctrl-C ends soon and long ranges need no memory.
    """
    if threads > 1:
        threads = startable(threads)
    if threads < 2:
        yield from map(call, items)
        return
    pending: deque[Future[R]] = deque()
    with ThreadPoolExecutor(threads) as pool:
        try:
            for item in items:
                pending.append(pool.submit(call, item))
                if len(pending) > 2 * threads:
                    yield pending.popleft().result()
            while pending:
                yield pending.popleft().result()
        finally:
            for future in pending:
                future.cancel()
