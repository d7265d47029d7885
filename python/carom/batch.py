"""Many shots at once: all cores, no traces, arrays out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import array, thread_count
from carom.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from carom.shot import Shot

# Shots that go to Rust in one call. Between calls Ctrl-C is heard and the bar moves; at a few
# microseconds a shot a call takes some hundredths of a second, and starting one costs less than
# a thousandth of that.
CHUNK = 8192

# ``pocket`` where a shot has no such ball.
PADDING = -3

# The parameters of a strike, in the order in which Rust has them.
VARIABLES = ("speed", "azimuth", "elevation", "side", "height")


@dataclass(frozen=True, slots=True)
class BatchResult:
    """The ends of many shots, in the order in which they were given.

    Attributes:
        final_position: Centres at the end, m, float64 of shape (n_shots, n_balls, 3); NaN where
            a shot has fewer balls than the largest, or failed.
        pocket: int8 of shape (n_shots, n_balls): index of the pocket, in the order of
            ``carom tables``; −1 on the table, −2 off it, −3 padding.
        events: Number of events, int32 of shape (n_shots,); 0 where a shot failed.
        errors: What went wrong, by index; the other shots are unharmed.
    """

    final_position: NDArray[np.float64]
    pocket: NDArray[np.int8]
    events: NDArray[np.int32]
    errors: dict[int, str]

    def __len__(self) -> int:
        return len(self.events)


# What Rust gives: positions, pockets, events, errors.
Arrays = tuple["NDArray[np.float64]", "NDArray[np.int8]", "NDArray[np.int32]", dict[int, str]]


def simulate_batch(
    shots: Iterable[Shot], *, threads: int | None = None, progress: bool = False
) -> BatchResult:
    """Simulate many shots over all cores, without traces.

    Args:
        shots: The shots; they may differ in everything.
        threads: How many; None is one per core. Results do not depend on it.
        progress: Show a progress bar on stderr.

    Returns:
        Arrays in the order of ``shots``, padded to the shot with the most balls.

    Raises:
        InputError: One of them is no shot, or ``threads`` no count. A shot that reaches its cap of
            events does not raise: it is in ``errors`` of the result.
    """
    if not isinstance(shots, Iterable):
        raise InputError(f"shots: found a {type(shots).__name__}; give a list of carom.Shot")
    cores = [_core_of(shot, index) for index, shot in enumerate(shots)]
    balls = max((len(core) for core in cores), default=0)

    def run(start: int, end: int) -> Arrays:
        return _core.simulate_batch(cores[start:end], thread_count(threads))

    return in_chunks(run, len(cores), balls, progress=progress)


def vary(
    shot: _core.Shot,
    given: Mapping[str, ArrayLike | None],
    *,
    threads: int | None,
    progress: bool,
) -> BatchResult:
    """``Shot.batch``."""
    import numpy as np

    columns = []
    for name, default in zip(VARIABLES, own_strike(shot), strict=True):
        value = given[name]
        columns.append(array(name, default if value is None else value))
    try:
        full = np.broadcast_arrays(*columns)
    except ValueError:
        shapes = ", ".join(
            f"{name} {column.shape}" for name, column in zip(VARIABLES, columns, strict=True)
        )
        raise InputError(f"shapes do not broadcast: {shapes}; make them agree") from None
    strikes = np.ascontiguousarray(np.stack([column.ravel() for column in full], axis=1))

    def run(start: int, end: int) -> Arrays:
        return _core.simulate_strikes(shot, strikes[start:end], thread_count(threads))

    return in_chunks(run, len(strikes), len(shot), progress=progress)


def own_strike(shot: _core.Shot) -> tuple[float, float, float, float, float]:
    """The strike that is to be varied: speed, azimuth, elevation, side, height.

    Raises:
        InputError: The shot has none.
    """
    if shot.strike is None:
        raise InputError("strike: the shot has no strike to vary; give it one")
    return shot.strike


def _core_of(shot: Any, index: int) -> _core.Shot:
    from carom.shot import Shot

    if not isinstance(shot, Shot):
        raise InputError(
            f"shots[{index}]: found a {type(shot).__name__}; give carom.Shot, "
            "for example carom.Shot.from_dict(...)"
        )
    return shot._core


def in_chunks(
    run: Callable[[int, int], Arrays], count: int, balls: int, *, progress: bool
) -> BatchResult:
    """The results of ``run`` on row ``start`` up to ``end``, a chunk at a time."""
    import numpy as np

    position = np.full((count, balls, 3), np.nan)
    pocket = np.full((count, balls), PADDING, dtype=np.int8)
    events = np.empty(count, dtype=np.int32)
    errors: dict[int, str] = {}
    with progress_bar(count, show=progress) as advance:
        for start in range(0, count, CHUNK):
            end = min(start + CHUNK, count)
            places, pockets, events[start:end], failed = run(start, end)
            # A chunk is as wide as its own largest shot.
            width = places.shape[1]
            position[start:end, :width], pocket[start:end, :width] = places, pockets
            errors |= {start + index: text for index, text in failed.items()}
            advance(end - start)
    return BatchResult(position, pocket, events, errors)


@contextmanager
def progress_bar(
    count: int, *, show: bool, what: str = "shots"
) -> Iterator[Callable[[int], object]]:
    """A bar on stderr; what it yields is told how many more are done."""
    if not show:
        yield lambda _: None
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    with Progress(
        TextColumn(what),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        console=Console(stderr=True),
    ) as bar:
        task = bar.add_task(what, total=count)
        yield lambda done: bar.advance(task, done)
