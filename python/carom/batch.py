"""Many shots at once, on all cores: results as arrays, without traces."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom import _core
from carom.arguments import angles, array, check_results, core, thread_count, warn_of_degrees
from carom.device import opened
from carom.errors import InputError
from carom.lazy import np
from carom.progress import progress_bar

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    import carom

# Shots that go to Rust in the first call. Ctrl-C is noticed between two calls.
_FIRST_CHUNK = 64
# A call should take about this long, s. A person notices a longer delay of Ctrl-C, and starting a
# call costs less than a thousandth of it.
_CHUNK_TIME = 0.1

# ``pocket`` where a shot has no such ball.
PADDING = -3

# The parameters of a strike, in the order in which Rust has them.
VARIABLES = ("speed", "azimuth", "elevation", "side", "height")


@dataclass(frozen=True, slots=True)
class BatchResult:
    """The ends of many shots, in the order of the arguments.

    Attributes:
        final_position: Centres at the end, m, float64 of shape (n_shots, n_balls, 3); NaN where
            a shot has fewer balls than the largest, or failed.
        pocket: int8 of shape (n_shots, n_balls): index of the pocket, in the order of
            ``carom tables``; −1 on the table, −2 off it, −3 padding.
        events: Number of events, int32 of shape (n_shots,); 0 where a shot failed.
        errors: Error messages of the shots that failed, by index.
    """

    final_position: NDArray[np.float64]
    pocket: NDArray[np.int8]
    events: NDArray[np.int32]
    errors: dict[int, str]

    def __len__(self) -> int:
        return len(self.events)


# The arrays from Rust: positions, pockets, events, errors.
Arrays = tuple["NDArray[np.float64]", "NDArray[np.int8]", "NDArray[np.int32]", dict[int, str]]


def simulate_batch(
    shots: Iterable[carom.Shot],
    *,
    threads: int | None = None,
    device: str = "cpu",
    progress: bool = False,
) -> BatchResult:
    """Simulate many shots on all cores, without traces.

    Args:
        shots: The shots; they may have different tables, physics and balls.
        threads: Number of threads; None is one per core. The result does not depend on it.
        device: ``"cpu"``, ``"cuda"`` or ``"cuda:1"``; see ``carom.device``.
        progress: Show a progress bar on stderr.

    Returns:
        Arrays in the order of ``shots``, padded to the shot with the most balls.

    Raises:
        InputError: ``shots`` is not a list, an item is not a ``carom.Shot``, ``threads`` is out of
            range, ``device`` cannot be used, or there are too many shots for one call. A shot that
            reaches its cap of events does not raise: it is in ``errors`` of the result.
    """
    # An empty string or dict would otherwise pass as an empty list.
    if isinstance(shots, str | bytes | bytearray | Mapping) or not isinstance(shots, Iterable):
        raise InputError(
            "wrong-type", "shots", f"found a {type(shots).__name__}", "give a list of carom.Shot"
        )
    cores = [
        core(f"shots[{index}]", shot, _core.Shot, "carom.Shot.from_dict(...)")
        for index, shot in enumerate(shots)
    ]
    balls = max(map(len, cores), default=0)
    card = opened(device)

    def run(start: int, end: int) -> Arrays:
        return _core.simulate_batch(cores[start:end], thread_count(threads), card)

    return in_chunks(run, len(cores), balls, progress=progress)


def batch(
    shot: carom.Shot,
    *,
    speed: ArrayLike | None = None,
    azimuth: ArrayLike | None = None,
    side: ArrayLike | None = None,
    height: ArrayLike | None = None,
    elevation: ArrayLike | None = None,
    azimuth_deg: ArrayLike | None = None,
    elevation_deg: ArrayLike | None = None,
    threads: int | None = None,
    device: str = "cpu",
    progress: bool = False,
) -> BatchResult:
    """Simulate many variants of a shot's strike, on all cores, without traces.

    Arguments that are None keep the value of the shot. Scalars and arrays broadcast against each
    other; the result is flat, in C order.

    Args:
        shot: The shot.
        speed: The cue's speed, m/s.
        azimuth: The cue's direction, counter-clockwise from +x, rad.
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
        elevation: Butt raised above horizontal, rad. If it was omitted in the shot, None is the
            default elevation of each variant.
        azimuth_deg: The azimuth in degrees, in place of ``azimuth``.
        elevation_deg: The elevation in degrees, in place of ``elevation``.
        threads: Number of threads; None is one per core. The result does not depend on it.
        device: ``"cpu"``, ``"cuda"`` or ``"cuda:1"``; see ``carom.device``.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The shot has no strike, the shapes do not broadcast, ``device`` cannot be used,
            or there are too many strikes for one call. A strike out of range does not raise: it is
            in ``errors`` of the result.
    """
    inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
    azimuth = angles("azimuth", azimuth, azimuth_deg)
    if azimuth_deg is None:
        warn_of_degrees("azimuth", azimuth)
    elevation = angles("elevation", elevation, elevation_deg)
    given = (speed, azimuth, elevation, side, height)
    columns = [
        array(name, default if value is None else value)
        for name, value, default in zip(VARIABLES, given, own_strike(inner), strict=True)
    ]
    try:
        shape = np.broadcast_shapes(*(column.shape for column in columns))
    except ValueError:
        shapes = ", ".join(
            f"{name} {column.shape}" for name, column in zip(VARIABLES, columns, strict=True)
        )
        raise InputError(
            "wrong-count", "", f"shapes do not broadcast: {shapes}", "make them agree"
        ) from None
    # Python's integers: a product of NumPy's could overflow.
    check_results("shapes", math.prod(shape), len(inner))
    full = [np.broadcast_to(column, shape) for column in columns]
    strikes = np.ascontiguousarray(np.stack([column.ravel() for column in full], axis=1))

    own = elevation is None and inner.has_default_elevation
    card = opened(device)

    def run(start: int, end: int) -> Arrays:
        rows = strikes[start:end]
        return _core.simulate_strikes(inner, rows, own, thread_count(threads), card)

    return in_chunks(run, len(strikes), len(inner), progress=progress)


def own_strike(shot: _core.Shot) -> tuple[float, float, float, float, float]:
    """The shot's own strike: speed, azimuth, elevation, side, height.

    Raises:
        InputError: The shot has none.
    """
    if shot.strike is None:
        raise InputError("no-strike", "strike", "the shot has no strike to vary", "give it one")
    return shot.strike


def in_chunks(
    run: Callable[[int, int], Arrays], count: int, balls: int, *, progress: bool
) -> BatchResult:
    """The results of many shots, simulated in chunks.

    Args:
        run: Simulates the shots from one index up to but not including another.
        count: Number of shots.
        balls: Number of balls of the largest shot.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The results would exhaust the memory.
    """
    check_results("shots", count, balls)
    # Not filled here: that would take seconds for a large array, and Ctrl-C would have to wait.
    position = np.empty((count, balls, 3))
    pocket = np.empty((count, balls), dtype=np.int8)
    events = np.empty(count, dtype=np.int32)
    errors: dict[int, str] = {}
    start, chunk = 0, _FIRST_CHUNK
    with progress_bar(count, show=progress) as advance:
        while start < count:
            end = min(start + chunk, count)
            began = time.perf_counter()
            places, pockets, events[start:end], failed = run(start, end)
            fast = time.perf_counter() - began < _CHUNK_TIME
            # A chunk is as wide as its own largest shot.
            width = places.shape[1]
            position[start:end, :width], pocket[start:end, :width] = places, pockets
            position[start:end, width:], pocket[start:end, width:] = np.nan, PADDING
            errors |= {start + index: text for index, text in failed.items()}
            advance(end - start)
            start, chunk = end, 2 * chunk if fast else max(chunk // 2, 1)
    return BatchResult(position, pocket, events, errors)
