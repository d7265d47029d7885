"""The errors of a camera, from the tracks themselves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn.tracks import TrackedBall

if TYPE_CHECKING:
    from numpy.typing import NDArray

# The median of |x| of a normal distribution with standard deviation 1, inverted.
_MEDIAN_TO_SIGMA = 1.4826
# Four samples over a longer time, s, may have a contact or a stop between them.
_LONGEST = 0.5
# Four samples over a shorter way, m, are those of a ball at rest.
_MOVES = 0.01
# Samples whose residuals from a quadratic are taken, within this time, s.
_GROUP = 9
_LONGEST_GROUP = 0.8
# Fewer groups of four samples give no usable median.
_LEAST = 8
#: Least standard deviation that is assumed, m; below it, paths are not exact quadratics.
LEAST_SIGMA = 1e-4
#: Standard deviation of tracks that are too short to tell, m: that of a usual camera.
USUAL_SIGMA = 1e-3


def noise_of(ball: TrackedBall) -> float | None:
    """The standard deviation of a measured coordinate of a ball, m; None if it is too short.

    It is the larger one of two: that of single samples, and that of the residuals of nine samples
    from a quadratic, which also has errors that neighbouring samples share.
    """
    seen = ball.seen
    single = _of_differences(seen)
    if single is None:
        return None
    return max(single, _of_residuals(seen) or 0.0)


def _of_residuals(seen: TrackedBall) -> float | None:
    """From quadratics through groups of samples of the moving ball; None if there are too few."""
    found = []
    for first in range(0, len(seen) - _GROUP + 1, _GROUP // 2):
        own = slice(first, first + _GROUP)
        time, place = seen.time[own], seen.position[own]
        if time[-1] - time[0] > _LONGEST_GROUP or np.hypot(*(place[-1] - place[0])) < _MOVES:
            continue
        rows = np.vander((time - time[0]) / (time[-1] - time[0]), 3)
        rest = place - rows @ np.linalg.lstsq(rows, place, rcond=None)[0]
        found.append(float((rest**2).sum()) / (2 * (_GROUP - 3)))
    # Contacts and the ends of sliding are in less than half of the groups.
    return float(np.sqrt(np.quantile(found, 0.4))) if len(found) >= _LEAST else None


def _of_differences(seen: TrackedBall) -> float | None:
    """From third differences.

    Free motion is a quadratic function of time, so the third divided difference of four samples is
    their error alone. It is scaled to the standard deviation of a sample; the median of its
    absolute values is not moved by the few that span a contact. Groups in which the ball moves are
    taken if there are enough of them, because the error of the clock belongs to theirs.
    """
    if len(seen) < 4:
        return None
    times = np.stack([seen.time[k : len(seen) - 3 + k] for k in range(4)])
    span = times[3] - times[0]
    weights = np.ones_like(times)
    for k in range(4):
        for other in range(4):
            if other != k:
                weights[k] /= (times[k] - times[other]) / span
    weights /= np.sqrt((weights**2).sum(axis=0))
    places = np.stack([seen.position[k : len(seen) - 3 + k] for k in range(4)])
    error = (weights[:, :, None] * places).sum(axis=0)
    way = np.hypot(*(places[3] - places[0]).T)
    short = span < _LONGEST
    moves = short & (way > _MOVES)
    chosen = moves if moves.sum() >= _LEAST else short
    if chosen.sum() < _LEAST:
        return None
    return float(_MEDIAN_TO_SIGMA * np.median(np.abs(error[chosen])))


def sigma_of(ball: TrackedBall, known: float | None) -> NDArray[np.float64]:
    """The standard deviation of each sample in which the ball was seen, m.

    It is that of the file, else that of the header, else that of ``noise_of``.
    """
    seen = ball.seen
    if seen.sigma is not None:
        return np.maximum(seen.sigma, LEAST_SIGMA)
    found = noise_of(ball)
    # A header's value is that of a good picture; errors of the clock come on top.
    value = max(known or 0.0, found or 0.0) or USUAL_SIGMA
    return np.full(len(seen), max(value, LEAST_SIGMA))
