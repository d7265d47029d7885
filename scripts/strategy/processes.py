"""Independent parts of an experiment, on several processes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any


def each(
    function: Callable[[int], dict[str, Any]], numbers: list[int], threads: int
) -> Iterator[dict[str, Any]]:
    """The results of ``function``, in the order of the numbers.

    One thread is this process. New processes are spawned: a fork of a process that has threads,
    such as those of the engine, may wait for ever.
    """
    if threads <= 1:
        yield from map(function, numbers)
        return
    with ProcessPoolExecutor(threads, get_context("spawn")) as pool:
        yield from pool.map(function, numbers)
