"""What a report of a learned table shows of each shot: model and track beside each other."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn.filmed_strikes import FilmedStrike, strikes
from carom.learn.model_scores import ModelScore
from carom.learn.observation import Observation, observe
from carom.learn.posterior import LearnedNumbers
from carom.learn.quality import ShotQuality, check
from carom.learn.strike_search import leaves
from carom.learn.tracks import Tracks
from carom.trace import Trace

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: A ball moves if it is faster, m/s: slower ones have no direction.
MOVES = 0.1


@dataclass(frozen=True, slots=True, eq=False)
class ShotFit:
    """A filmed shot beside the simulation of its strike.

    Attributes:
        name: The shot.
        strike: Its strike.
        trace: The simulation.
        time: Of the pictures, s since the strike, shape (n,); some are before it.
        track: Places of each ball on the table, m, shape (n, 2); NaN while it was not seen.
        model: The same of the simulation, without NaN.
        left_at: When the model is 8 cm from the track for the first time, s since the strike; None
            if it never is.
        quality: What ``check`` says of the shot.
    """

    name: str
    strike: FilmedStrike
    trace: Trace
    time: Floats
    track: Mapping[str, Floats]
    model: Mapping[str, Floats]
    left_at: float | None
    quality: ShotQuality

    @property
    def end(self) -> float:
        """Time until which the model is on the track, s since the strike."""
        return float(self.time[-1]) if self.left_at is None else self.left_at

    def errors(self) -> Floats:
        """Model minus track of the moving balls while the model is on the track.

        Returns:
            Shape (n, 3): time since the strike, s; the part along the way of the track, m, positive
            where the model is ahead; and the part across it, m, positive to the left.
        """
        rows = []
        for ball, track in self.track.items():
            velocity = np.gradient(track, self.time, axis=0)
            speed = np.hypot(*velocity.T)
            chosen = (speed > MOVES) & (self.time > 0.0) & (self.time < self.end)
            if not chosen.any():
                continue
            way = velocity[chosen] / speed[chosen, None]
            error = (self.model[ball] - track)[chosen]
            along = (error * way).sum(axis=1)
            across = way[:, 0] * error[:, 1] - way[:, 1] * error[:, 0]
            rows.append(np.column_stack((self.time[chosen], along, across)))
        return np.concatenate(rows) if rows else np.empty((0, 3))


@dataclass(frozen=True, slots=True, eq=False)
class FitReport:
    """A learned table, and its model beside every filmed shot.

    Attributes:
        posterior: What was learned.
        shots: The shots whose strike was found, in the order of the tracks.
        missing: Names of the shots without a strike.
        models: Models that were compared; empty if none were.
    """

    posterior: LearnedNumbers
    shots: tuple[ShotFit, ...]
    missing: tuple[str, ...]
    models: tuple[ModelScore, ...] = ()


def fit_report(
    tracks: Tracks,
    posterior: LearnedNumbers,
    found: Sequence[FilmedStrike] | None = None,
    models: Iterable[ModelScore] = (),
    *,
    starts: int = 40,
    threads: int | None = None,
    progress: bool = False,
) -> FitReport:
    """Simulate the strikes of filmed shots, and compare them with their tracks.

    Args:
        tracks: The filmed shots.
        posterior: What was learned from them.
        found: Their strikes; None takes those with which the fit of the table ended, and searches
            the ones that ``posterior.strikes`` lacks.
        models: A comparison of models, if there is one.
        starts: Starts of the search for a strike.
        threads: Number of threads of the search; None for all cores.
        progress: Whether to show the progress of the search on stderr.

    Raises:
        InputError: A shot has no motion.
    """
    if found is None:
        found = strikes(
            tracks,
            posterior,
            begin=posterior.strikes,
            starts=starts,
            threads=threads,
            progress=progress,
        )
    qualities = {quality.name: quality for quality in check(tracks).shots}
    by_name = {strike.name: strike for strike in found}
    shots = tuple(
        _shot(observe(tracked), posterior, by_name[tracked.name], qualities[tracked.name])
        for tracked in tracks
        if tracked.name in by_name
    )
    missing = tuple(tracked.name for tracked in tracks if tracked.name not in by_name)
    return FitReport(posterior, shots, missing, tuple(models))


def _shot(
    observed: Observation, posterior: LearnedNumbers, strike: FilmedStrike, quality: ShotQuality
) -> ShotFit:
    trace = strike.shot.simulate()
    time = observed.time - strike.clock
    places = trace.at(np.maximum(time, 0.0)).position[:, :, :2]
    model = {ball: places[:, index] for index, ball in enumerate(strike.shot.ids)}
    size = posterior.model.size(posterior.mean)
    track = {ball: posterior.frame.to_table(seen, size) for ball, seen in observed.position.items()}
    left_at = min(leaves(model[ball] - places, time) for ball, places in track.items())
    left = left_at if math.isfinite(left_at) else None
    return ShotFit(observed.name, strike, trace, time, track, model, left, quality)
