"""Simulated positions at given times, and their differences from tracks, for many candidates."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import array, instance, thread_count, truth, whole
from carom.candidates import Candidates, broadcast, candidates_of, rows
from carom.errors import InputError
from carom.lazy import np
from carom.progress import progress_bar
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

# Candidates that go to Rust in the first call. Ctrl-C is noticed between two calls.
_FIRST_CHUNK = 256
# A call should take about this long, s.
_CHUNK_TIME = 0.1
# The most numbers of one result: 3 GB.
_MOST_NUMBERS = 4 * 10**8


@dataclass(frozen=True, slots=True)
class SampledStates:
    """States of balls at given times, in the order of the candidates.

    The rows of a candidate that failed are NaN, and so is what a shot with fewer balls, or a time
    that is NaN, does not have.

    Attributes:
        position: Centres, m, float64 of shape (n_candidates, n_times, n_balls, 3).
        velocity: m/s, of the same shape; None if it was not asked for.
        angular_velocity: rad/s, of the same shape; None if it was not asked for.
        in_play: Whether the ball takes part in the shot, bool of shape (n_candidates, n_times,
            n_balls): it is in no pocket, and on the table. A ball out of play has the position of
            ``Trace.at``: under the hole's centre, or where it left the table.
        errors: Error messages of the candidates that failed, by index.
    """

    position: NDArray[np.float64]
    velocity: NDArray[np.float64] | None
    angular_velocity: NDArray[np.float64] | None
    in_play: NDArray[np.bool_]
    errors: dict[int, str]

    def __len__(self) -> int:
        return len(self.position)


def sample_batch(
    candidates: Candidates | Shot | Iterable[Shot],
    times: ArrayLike,
    *,
    balls: Sequence[str | int] | None = None,
    velocity: bool = False,
    angular_velocity: bool = False,
    threads: int | None = None,
    progress: bool = False,
) -> SampledStates:
    """The states of balls at given times, for many shots on all cores, without traces.

    The states have the bits of ``candidates.shot(i).simulate().at(times)``. A simulation stops at
    the last of its times.

    Args:
        candidates: The candidates, a shot, or a list of shots.
        times: Times since the strike, s, ≥ 0, in any order: shape (n_times,), or (..., n_times),
            whose other axes broadcast to ``candidates.shape``. NaN stands for no time, so that
            candidates may have different numbers of times.
        balls: Ids or indices of the balls; None is all balls. With ids, every shot must have the
            ball at the same index.
        velocity: Whether velocities are wanted.
        angular_velocity: Whether spins are wanted.
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: A time is negative or infinite, shapes do not broadcast, there is no such ball,
            or the result would be too large. A candidate that is refused does not raise: it is in
            ``errors`` of the result.
    """
    asked = candidates_of(candidates)
    wanted = array("times", times)
    if wanted.ndim == 0:
        raise InputError("wrong-type", "times", "found a number", "give an array of times")
    _check_shape("times", wanted.shape[:-1], asked.shape)
    every = wanted.reshape(1, -1) if wanted.ndim == 1 else rows(wanted, asked.shape)
    columns = list(range(len(asked.ids))) if balls is None else _columns(balls, asked)
    shape = (len(asked), every.shape[1], len(columns), 3)
    parts = (truth("velocity", velocity), truth("angular_velocity", angular_velocity))
    _check_size(math.prod(shape) * (1 + sum(parts)))
    position = np.empty(shape)
    moving = [np.empty(shape) if part else None for part in parts]
    in_play = np.empty(shape[:-1], dtype=np.bool_)
    count = thread_count(threads)

    def run(part: _core.Candidates, rows_of: slice) -> dict[int, str]:
        own = every if len(every) == 1 else every[rows_of]
        found = _core.sample_states(part, own, columns, *parts, count)
        position[rows_of], in_play[rows_of] = found[0], found[3]
        for all_rows, own_rows in zip(moving, found[1:3], strict=True):
            if all_rows is not None and own_rows is not None:
                all_rows[rows_of] = own_rows
        return found[4]

    errors = _in_chunks(run, asked, progress=progress)
    return SampledStates(position, moving[0], moving[1], in_play, errors)


class BallTracks:
    """Observed positions of balls over time, such as a camera's.

    Every ball has its own times. In the arrays of all samples the balls follow each other in the
    order given, each with its samples in the order given.

    Args:
        balls: For each ball's id ``(times, positions)`` or ``(times, positions, sigma)``: times on
            the camera's clock, s, shape (n,), in any order; positions x, y, m, shape (n, 2); the
            standard deviation of each coordinate, m, a number or shape (n,), 1 if it is omitted.

    Attributes:
        ids: The balls' ids.
        ball: For each sample the index of its ball in ``ids``, int of shape (n_samples,).
        time: Times, s, shape (n_samples,).
        position: Positions, m, shape (n_samples, 2).
        sigma: Standard deviations, m, shape (n_samples,).

    Raises:
        InputError: A number is not finite, a standard deviation not above 0, or a shape is wrong.
    """

    __slots__ = ("_core", "ball", "ids", "position", "sigma", "time")

    ids: list[str]
    ball: NDArray[np.int64]
    time: NDArray[np.float64]
    position: NDArray[np.float64]
    sigma: NDArray[np.float64]

    def __init__(self, balls: Mapping[str, Sequence[ArrayLike]]) -> None:
        if not isinstance(balls, Mapping):
            _core.wrong_type(balls, "balls", '{"cue": (times, positions)}')
        given = [(str(ball), _observed(str(ball), track)) for ball, track in balls.items()]
        self._core = _core.BallTracks(given)
        self.ids = [ball for ball, _ in given]
        lengths = [len(times) for _, (times, _, _) in given]
        self.ball = np.repeat(np.arange(len(given)), lengths)
        self.time = np.concatenate([np.empty(0), *(times for _, (times, _, _) in given)])
        self.position = np.concatenate([np.empty((0, 2)), *(at for _, (_, at, _) in given)])
        self.sigma = np.concatenate([np.empty(0), *(sigma for _, (_, _, sigma) in given)])

    def __len__(self) -> int:
        return len(self.time)

    def __bool__(self) -> bool:
        return True

    def __reduce__(self) -> tuple[Any, ...]:
        return BallTracks, (dict(self._items()),)

    def _items(self) -> Iterator[tuple[str, tuple[NDArray[np.float64], ...]]]:
        for index, ball in enumerate(self.ids):
            own = self.ball == index
            yield ball, (self.time[own], self.position[own], self.sigma[own])

    def __repr__(self) -> str:
        return f"<carom.BallTracks: {len(self)} samples of {', '.join(self.ids)}>"


@dataclass(frozen=True, slots=True)
class TrackResiduals:
    """Simulated minus observed positions, divided by their standard deviations.

    The rows of a candidate that failed are NaN, and 0 in ``out_of_play``.

    Attributes:
        residual: x and y, float64 of shape (n_candidates, n_samples, 2), the samples in the order
            of the tracks; 0 behind the last horizon, and behind the samples of a shot whose tracks
            have fewer than others. None if it was not asked for.
        sum: Sums of the squares of both coordinates over the samples up to each horizon, shape
            (n_candidates, n_balls, n_horizons), the balls in the order of the tracks.
        count: Number of the samples in each of these sums, int of the same shape.
        out_of_play: Number of samples within the last horizon at whose time the simulated ball is
            in a pocket or off the table, int of shape (n_candidates, n_balls). These samples are
            compared with the place of ``Trace.at``, and are part of the sums.
        errors: Error messages of the candidates that failed, by index.
    """

    residual: NDArray[np.float64] | None
    sum: NDArray[np.float64]
    count: NDArray[np.int64]
    out_of_play: NDArray[np.uint32]
    errors: dict[int, str]

    def __len__(self) -> int:
        return len(self.sum)


def track_residuals(
    candidates: Candidates | Shot | Iterable[Shot],
    tracks: BallTracks | Sequence[BallTracks],
    *,
    clock: ArrayLike = 0.0,
    offset: ArrayLike = (0.0, 0.0),
    rotation: ArrayLike = 0.0,
    scale: ArrayLike = 1.0,
    horizons: ArrayLike | None = None,
    residuals: bool = True,
    threads: int | None = None,
    progress: bool = False,
) -> TrackResiduals:
    """The differences of simulated positions from tracks, for many candidates on all cores.

    Sample k at the camera's time t has the residual (x(t − clock) − p(k))/σ(k), where x is the
    simulated position and p the observed one, placed on the table: c + scale·R(rotation)(p − c) +
    offset with the centre c of the playing area (the origin on unbounded cloth). Before the strike
    a ball is at its start. ``clock``, ``offset``, ``rotation`` and ``scale`` may differ between
    candidates: their axes broadcast to ``candidates.shape``.

    A simulation stops at the last sample within the last horizon.

    Args:
        candidates: The candidates, a shot, or a list of shots.
        tracks: The tracks; or a list with those of each shot, for candidates of a list of shots.
        clock: Time of the strike on the camera's clock, s, shape (...).
        offset: Displacement of the camera's frame on the table, m, shape (..., 2).
        rotation: Its rotation, counter-clockwise, rad, shape (...).
        scale: Its scale, > 0, shape (...).
        horizons: Times on the camera's clock, s, ascending, shape (n_horizons,), up to which
            samples are summed; the samples behind the last one are left out. None is one horizon
            without a limit.
        residuals: Whether the residual of every sample is wanted; the sums alone need less memory.
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: A shot lacks a ball of its tracks, shapes do not broadcast, horizons do not
            ascend, or the result would be too large. A candidate that is refused, or whose clock or
            frame is out of range, does not raise: it is in ``errors`` of the result.
    """
    asked = candidates_of(candidates)
    every = _tracks_of(tracks, asked)
    placement = _placement(asked.shape, clock, offset, rotation, scale)
    limits = [math.inf] if horizons is None else _horizons(horizons)
    width = max((len(track.ids) for track in every), default=0)
    samples = max(map(len, every), default=0)
    shape = (len(asked), width, len(limits))
    wanted = truth("residuals", residuals)
    _check_size(len(asked) * samples * 2 * wanted + math.prod(shape))
    residual = np.empty((len(asked), samples, 2)) if wanted else None
    sums = np.empty(shape)
    out_of_play = np.empty(shape[:2], dtype=np.uint32)
    cores = [track._core for track in every]
    count = thread_count(threads)

    def run(part: _core.Candidates, rows_of: slice) -> dict[int, str]:
        own = placement if len(placement) == 1 else placement[rows_of]
        found = _core.track_residuals(part, cores, own, limits, wanted, count)
        if residual is not None and found[0] is not None:
            residual[rows_of] = found[0]
        sums[rows_of], out_of_play[rows_of] = found[1], found[2]
        return found[3]

    errors = _in_chunks(run, asked, progress=progress)
    counts = _counts(every, asked, shape, limits)
    return TrackResiduals(residual, sums, counts, out_of_play, errors)


def _counts(
    tracks: list[BallTracks], asked: Candidates, shape: tuple[int, ...], limits: list[float]
) -> NDArray[np.int64]:
    """Number of samples of each candidate, ball and horizon."""
    own = np.zeros((len(tracks), *shape[1:]), dtype=np.int64)
    for index, track in enumerate(tracks):
        own[index, : len(track.ids)] = np.reshape(
            track._core.counts(limits), (len(track.ids), len(limits))
        )
    if len(tracks) == 1:
        return np.broadcast_to(own, shape)
    # Only a list of shots, which is the last axis of the candidates, has several tracks.
    full = np.broadcast_to(own, (*asked.shape, *shape[1:]))
    return np.ascontiguousarray(full.reshape(shape))


def _tracks_of(tracks: BallTracks | Sequence[BallTracks], asked: Candidates) -> list[BallTracks]:
    if isinstance(tracks, BallTracks):
        return [tracks]
    if isinstance(tracks, str | bytes | Mapping) or not isinstance(tracks, Iterable):
        found = type(tracks).__name__
        raise InputError("wrong-type", "tracks", f"found a {found}", "give carom.BallTracks")
    every = [
        instance(f"tracks[{k}]", track, BallTracks, 'carom.BallTracks({"cue": (times, positions)})')
        for k, track in enumerate(tracks)
    ]
    if len(every) != len(asked._shots):
        raise InputError(
            "wrong-count",
            "tracks",
            f"found {len(every)} for {len(asked._shots)} shots",
            "give one for each shot",
        )
    return every


def _placement(
    shape: tuple[int, ...],
    clock: ArrayLike,
    offset: ArrayLike,
    rotation: ArrayLike,
    scale: ArrayLike,
) -> NDArray[np.float64]:
    """Clock, offset x, y, rotation, scale: (1, 5), or (n_candidates, 5)."""
    moved = array("offset", offset)
    if moved.ndim == 0 or moved.shape[-1] != 2:
        raise InputError(
            "wrong-count", "offset", f"found the shape {moved.shape}", "give x and y: (..., 2)"
        )
    columns = {
        "clock": array("clock", clock),
        "offset": moved[..., 0],
        "rotation": array("rotation", rotation),
        "scale": array("scale", scale),
    }
    for name, part in columns.items():
        _check_shape(name, part.shape, shape)
    own = broadcast({name: part.shape for name, part in columns.items()})
    every = (columns["clock"], moved[..., 0], moved[..., 1], columns["rotation"], columns["scale"])
    stacked = np.empty((*own, len(every)))
    for column, part in enumerate(every):
        stacked[..., column] = part
    return rows(stacked, shape) if own else stacked[None]


def _horizons(horizons: ArrayLike) -> list[float]:
    found = np.atleast_1d(array("horizons", horizons))
    if found.ndim != 1 or not found.size or np.isnan(found).any() or (np.diff(found) < 0).any():
        raise InputError(
            "out-of-range", "horizons", "not times in ascending order", "give a flat, sorted array"
        )
    numbers: list[float] = found.tolist()
    return numbers


def _observed(
    ball: str, track: Sequence[ArrayLike]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The times, positions and standard deviations of a ball's track."""
    if isinstance(track, str | Mapping) or len(track) not in (2, 3):
        raise InputError(
            "wrong-count",
            ball,
            "not times and positions",
            "give (times, positions), or (times, positions, sigma)",
        )
    times, positions = array(f"{ball}.times", track[0]), array(f"{ball}.positions", track[1])
    if times.ndim != 1 or positions.shape != (len(times), 2):
        raise InputError(
            "wrong-count",
            ball,
            f"times of shape {times.shape} and positions of shape {positions.shape}",
            "give times (n,) and positions (n, 2)",
        )
    sigma = array(f"{ball}.sigmas", track[2] if len(track) == 3 else 1.0)
    if sigma.ndim > 1 or (sigma.ndim == 1 and sigma.shape != times.shape):
        raise InputError(
            "wrong-count",
            f"{ball}.sigmas",
            f"found the shape {sigma.shape}",
            f"give a number, or {len(times)} numbers",
        )
    full = np.broadcast_to(sigma, times.shape)
    return np.array(times), np.array(positions), np.array(full)


def _columns(balls: Sequence[str | int], asked: Candidates) -> list[int]:
    """The indices of balls given by id or index."""
    if isinstance(balls, str) or not isinstance(balls, Iterable):
        raise InputError("wrong-type", "balls", f"{balls!r} is not a list", "give ids or indices")
    columns = []
    for k, ball in enumerate(balls):
        if not isinstance(ball, str):
            columns.append(whole(f"balls[{k}]", ball, len(asked.ids)))
            continue
        places = {shot.ids.index(ball) if ball in shot.ids else None for shot in asked._shots}
        if None in places or len(places) != 1:
            known = ", ".join(map(repr, asked.ids))
            fault = f"there is no ball {ball!r} at one index in every shot"
            raise InputError("unknown-ball", f"balls[{k}]", fault, f"write one of {known}")
        columns.append(places.pop() or 0)
    return columns


def _check_shape(name: str, shape: tuple[int, ...], candidates: tuple[int, ...]) -> None:
    """Reject an argument that does not broadcast to the shape of the candidates."""
    if shape and broadcast({"candidates": candidates, name: shape}) != candidates:
        raise InputError(
            "wrong-count",
            name,
            f"its shape {shape} has more entries than the candidates' {candidates}",
            "give the candidates these axes",
        )


def _check_size(numbers: int) -> None:
    if numbers > _MOST_NUMBERS:
        raise InputError(
            "out-of-range",
            "",
            f"a result of {numbers} numbers is too large for one call",
            f"ask for at most {_MOST_NUMBERS}, in several calls",
        )


def _in_chunks(
    run: Callable[[_core.Candidates, slice], dict[int, str]], asked: Candidates, *, progress: bool
) -> dict[int, str]:
    """Run the candidates in chunks, so that Ctrl-C is noticed between two of them.

    Args:
        run: Stores the results of candidates in some rows, and returns their errors by index.
        asked: All candidates.
        progress: Show a progress bar on stderr.

    Returns:
        The errors by index.
    """
    count, start, chunk = len(asked), 0, _FIRST_CHUNK
    if count <= chunk:
        return run(asked._core, slice(count))
    errors: dict[int, str] = {}
    with progress_bar(count, show=progress, what="candidates") as advance:
        while start < count:
            end = min(start + chunk, count)
            began = time.perf_counter()
            failed = run(asked._core.part(start, end), slice(start, end))
            errors |= {start + index: message for index, message in failed.items()}
            fast = time.perf_counter() - began < _CHUNK_TIME
            advance(end - start)
            start, chunk = end, 2 * chunk if fast else max(chunk // 2, 1)
    return errors
