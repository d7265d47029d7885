"""The track of a ball cut into pieces of constant acceleration.

Between contacts a ball slides and then rolls, both on quadratic paths. The cut with the least sum
of squared residuals and a penalty for each piece is found exactly by dynamic programming (optimal
partitioning: Jackson et al., IEEE Signal Processing Letters 12, 2005).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

# What a further piece costs, in squared standard deviations. Six numbers of a quadratic and the
# time of its end fit noise by 7 to 20; a smaller penalty cuts noise, a larger one hides light
# contacts.
_PENALTY = 30.0
# Longest piece, samples; longer ones are cut, and joined again where the velocity does not change.
_LONGEST = 200
# Standard deviation of a coordinate's acceleration before anything is measured, m/s²: a sliding
# ball has 2. It keeps the velocity of short pieces finite.
_ACCELERATION = 2.0
# That of a velocity, m/s; a hard break has 10.
_VELOCITY = 10.0
# Samples are compared in blocks of so many, and of this time, s, to find rests; within a rest they
# lie within this number of standard deviations of their mean.
_REST_SAMPLES = 8
_REST_TIME = 0.2
_REST_SPREAD = 5.0
# A piece's motion at its end is fitted to so much of it, s: the acceleration of a rolling ball
# changes slowly with its speed.
_NEAR = 0.5


@dataclass(frozen=True, slots=True)
class Motion:
    """A quadratic path with its uncertainty.

    Attributes:
        time: s, at which the numbers hold.
        values: Place, velocity and half the acceleration, shape (3, 2).
        covariance: Of place, velocity and half the acceleration of one coordinate, shape (3, 3).
    """

    time: float
    values: Floats
    covariance: Floats

    def place(self, time: float) -> Floats:
        """The centre, m."""
        since = time - self.time
        found: Floats = np.array((1.0, since, since * since)) @ self.values
        return found

    def velocity(self, time: float) -> Floats:
        """The velocity, m/s."""
        found: Floats = self.values[1] + 2.0 * (time - self.time) * self.values[2]
        return found

    def place_sigma(self, time: float) -> float:
        """Standard deviation of a coordinate of the place, m."""
        since = time - self.time
        row = np.array((1.0, since, since * since))
        return float(np.sqrt(row @ self.covariance @ row))

    def velocity_sigma(self, time: float) -> float:
        """Standard deviation of a coordinate of the velocity, m/s."""
        row = np.array((0.0, 1.0, 2.0 * (time - self.time)))
        return float(np.sqrt(row @ self.covariance @ row))


def cut(time: Floats, place: Floats, sigma: Floats) -> list[tuple[int, int]]:
    """The first and the last sample of each piece.

    Args:
        time: s, shape (n,).
        place: m, shape (n, 2).
        sigma: Standard deviation of a coordinate, m, shape (n,).
    """
    kept = _without_rests(time, place, sigma)
    pieces = _best(time[kept], place[kept], sigma[kept])
    # A sample of a rest that was left out belongs to the piece around it.
    return [
        (int(kept[first]), int(kept[last + 1]) - 1 if last + 1 < len(kept) else len(time) - 1)
        for first, last in pieces
    ]


def _without_rests(time: Floats, place: Floats, sigma: Floats) -> NDArray[np.int64]:
    """The samples without those in the middle of long rests, which cost time and tell nothing."""
    count = len(time)
    step = float(np.median(np.diff(time))) if count > 1 else 1.0
    block = max(_REST_SAMPLES, int(_REST_TIME / step))
    blocks = count // block
    everything = np.arange(count)
    if blocks < 3:
        return everything
    cut_off = blocks * block
    parts = place[:cut_off].reshape(blocks, block, 2)
    means = parts.mean(axis=1)
    error = float(np.median(sigma))
    near = np.abs(parts - means[:, None]).max(axis=(1, 2)) < _REST_SPREAD * error
    same = np.abs(np.diff(means, axis=0)).max(axis=1) < 3.0 * error * np.sqrt(2.0 / block)
    still = np.zeros(blocks, dtype=np.bool_)
    still[1:-1] = near[1:-1] & near[:-2] & near[2:] & same[:-1] & same[1:]
    drop = np.zeros(count, dtype=np.bool_)
    drop[:cut_off] = np.repeat(still, block)
    return everything[~drop]


def _best(time: Floats, place: Floats, sigma: Floats) -> list[tuple[int, int]]:
    count = len(time)
    best = np.zeros(count + 1)
    begin = np.zeros(count, dtype=np.int64)
    weight = 1.0 / sigma**2
    first = 0
    for last in range(count):
        first = max(first, last + 1 - _LONGEST)
        costs = _costs(
            time[first : last + 1] - time[last],
            place[first : last + 1] - place[last],
            weight[first : last + 1],
        )
        total = best[first : last + 1] + costs
        index = int(np.argmin(total))
        begin[last] = first + index
        best[last + 1] = total[index] + _PENALTY
        # A beginning that is worse than a cut here stays so (Killick et al. 2012, PELT).
        better = np.flatnonzero(total <= best[last + 1])
        first += int(better[0]) if better.size else 0
    found = []
    last = count - 1
    while last >= 0:
        found.append((int(begin[last]), last))
        last = int(begin[last]) - 1
    return found[::-1]


def _costs(u: Floats, p: Floats, w: Floats) -> Floats:
    """The weighted squared residuals of quadratics through the samples from each to the last."""
    scale = -u[0] or 1.0
    u = u[::-1] / scale
    p, w = p[::-1], w[::-1]
    s0, s1, s2, s3, s4 = (np.cumsum(w * u**k) for k in range(5))
    mean = s1 / s0
    n1 = np.maximum(s2 - s1 * mean, 0.0)
    # u² less its part in 1 and u.
    slope = np.divide(s3 - s2 * mean, n1, out=np.zeros_like(n1), where=n1 > _TINY)
    base = s2 / s0
    n2 = np.maximum(s4 - s2 * base - slope * (s3 - s2 * mean), 0.0)
    # The prior of the acceleration, so that no quadratic bends through a contact.
    ridge = (0.5 * _ACCELERATION * scale**2) ** -2
    cost = np.zeros(len(u))
    for axis in (0, 1):
        q = p[:, axis]
        c0, c1, c2 = (np.cumsum(w * q * u**k) for k in range(3))
        square = np.cumsum(w * q * q)
        along1 = c1 - c0 * mean
        along2 = c2 - c0 * base - slope * along1
        part1 = np.divide(along1**2, n1, out=np.zeros_like(n1), where=n1 > _TINY)
        part2 = np.where(n2 > _TINY * s4, along2**2 / (n2 + ridge), 0.0)
        cost += np.maximum(square - c0**2 / s0 - part1 - part2, 0.0)
    # Two samples lie on a line.
    cost[:2] = 0.0
    return cost[::-1]


# Sums of squares below this, of times as shares of the longest, are rounding errors.
_TINY = 1e-13


def motion_at_end(time: Floats, place: Floats, sigma: Floats, *, end: bool) -> Motion:
    """The motion at the end of a piece, or at its beginning.

    Args:
        time: The samples of the piece, s, shape (n,).
        place: m, shape (n, 2).
        sigma: m, shape (n,).
        end: Whether its end is wanted.
    """
    at = float(time[-1] if end else time[0])
    near = np.abs(time - at) <= _NEAR
    if near.sum() < 4:
        near = np.zeros(len(time), dtype=np.bool_)
        near[slice(-4, None) if end else slice(0, 4)] = True
    u = time[near] - at
    rows = np.column_stack((np.ones_like(u), u, u * u)) / sigma[near, None]
    # The prior of the place is flat.
    prior = np.diag((0.0, _VELOCITY**-2, (0.5 * _ACCELERATION) ** -2))
    covariance: Floats = np.asarray(np.linalg.inv(rows.T @ rows + prior), dtype=np.float64)
    values: Floats = covariance @ rows.T @ (place[near] / sigma[near, None])
    return Motion(at, values, covariance)


def resting(place: Floats, sigma: float, time: float) -> Motion:
    """The motion of a ball at rest, from its samples."""
    values = np.zeros((3, 2))
    values[0] = place.mean(axis=0)
    covariance = np.zeros((3, 3))
    covariance[0, 0] = sigma**2 / len(place)
    return Motion(time, values, covariance)
