"""How sure a strike of a filmed shot is: draws from its posterior."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn import levenberg
from carom.learn.observation import RATE
from carom.learn.strike_search import (
    LARGEST_ELEVATION,
    LARGEST_OFFSET,
    STEPS,
    StrikeProblem,
    leaves,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Number of draws.
DRAWS = 200
#: Standard deviation of what is known without the film: azimuth (rad), speed (m/s), side, height
#: (ball radii), elevation (rad), clock (s).
BEFORE = (0.4, 10.0, 0.5, 0.5, 0.3, 0.05)
#: The same of a place of rest, m, if it is not given.
REST = 0.001
#: Least standard deviation of model minus track, m.
LEAST_ERROR = 0.001


def strike_samples(problem: StrikeProblem, vector: Floats, seed: int) -> Floats:
    """Draws from the posterior of a strike, about the strike that explains its film best.

    The model is taken as linear there. The standard deviation of model minus track is that of the
    residuals. Residuals that follow each other are alike, so a number of them counts as one: the
    integrated autocorrelation time of a first-order process with their correlation, (1 + ρ)/(1 − ρ)
    (Priestley 1981, 5.3.5). The places where the balls lay are uncertain too.

    Args:
        problem: The shot.
        vector: The strike, as ``search`` found it.
        seed: Seed of the draws.

    Returns:
        Shape (200, 6): azimuth (rad), speed (m/s), side, height (ball radii), elevation (rad) and
        clock (s).
    """
    places = problem.places.size
    free = StrikeProblem(problem.observed, problem.shot, problem.frame, problem.rest or REST)
    point = np.pad(vector, (0, len(STEPS) + places - vector.size))
    at, steps = free.residuals(problem.observed.end), free.steps
    here, ahead = levenberg.derivatives(at, point[None], steps)
    _, behind = levenberg.derivatives(at, point[None], -steps)
    # Where a contact begins or ends between the two, one quotient is far too large. At a limit of
    # the search there is only one.
    ahead, behind = ahead[0], -behind[0]
    is_ahead = ~(np.abs(ahead) > np.abs(behind)) & np.isfinite(ahead)
    slopes = np.nan_to_num(np.where(is_ahead, ahead, behind))
    tracks = problem.observed.until(problem.observed.end)
    size = 2 * tracks.time.size
    # A film counts until the model leaves the track.
    until = leaves(here[0, :size].reshape(-1, 2), tracks.time)
    counts = np.repeat(tracks.time < until, 2)
    residual, slopes = here[0, :size][counts], slopes[:, :size][:, counts]
    square = float(residual @ residual) / max(residual.size, 1)
    variance = max(square, LEAST_ERROR**2) * _alike(residual)
    before = np.array([*BEFORE, *[problem.rest or REST] * places]) / steps
    precision = slopes @ slopes.T / variance + np.diag(1.0 / before**2)
    values, axes = np.linalg.eigh(precision)
    random = np.random.default_rng((seed, 0x5A3D))
    normal = random.standard_normal((DRAWS, steps.size))
    draws = point + (normal / np.sqrt(np.maximum(values, 1e-12))) @ axes.T * steps
    return _possible(draws[:, : len(STEPS)])


def _alike(residuals: Floats) -> float:
    """How many residuals count as one, from the correlation of neighbours of one coordinate."""
    pairs = residuals[: residuals.size // 2 * 2].reshape(-1, 2)
    if len(pairs) < 3:
        return 1.0
    centred = pairs - pairs.mean(axis=0)
    square = float((centred**2).sum())
    correlation = float((centred[1:] * centred[:-1]).sum()) / square if square > 0.0 else 0.0
    correlation = min(max(correlation, 0.0), 1.0 - 2.0 / (RATE + 1.0))
    return (1.0 + correlation) / (1.0 - correlation)


def _possible(draws: Floats) -> Floats:
    """The draws with every strike inside the limits of the search."""
    draws[:, 1] = np.maximum(draws[:, 1], 0.02)
    offset = np.hypot(draws[:, 2], draws[:, 3])
    draws[:, 2:4] *= np.minimum(1.0, LARGEST_OFFSET / np.maximum(offset, 1e-12))[:, None]
    draws[:, 4] = np.minimum(np.abs(draws[:, 4]), LARGEST_ELEVATION)
    return draws
