"""Least squares from many starts at once: Levenberg–Marquardt in arrays.

A library's optimiser follows one start at a time, and asks for one shot at a time. Here every
iteration plays all derivatives of all starts in one call of the engine, on all cores.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Step of a difference quotient, in units of a parameter's scale.
STEP = 1e-3
#: Largest step of an iteration, in the same unit.
REACH = 3.0
#: Damping that an iteration tries, relative to the last one that helped.
DAMPING = (0.2, 1.0, 8.0, 60.0)
#: Relative gain below which a start has converged.
CONVERGED = 1e-4


def costs(residuals: Floats, scale: float) -> Floats:
    """The sum of a robust loss of each row, infinite where a row is not a number.

    Args:
        residuals: Shape (n, m).
        scale: Residuals that are larger count less (Cauchy's loss c² ln(1 + r²/c²)); infinite for
            squares.
    """
    squares = residuals * residuals
    if np.isfinite(scale):
        squares = scale * scale * np.log1p(squares / (scale * scale))
    total = squares.sum(axis=1)
    return np.where(np.isfinite(total), total, np.inf)


def weights(residuals: Floats, scale: float) -> Floats:
    """The weights with which squares have the derivative of the loss of ``costs``."""
    if not np.isfinite(scale):
        return np.ones_like(residuals)
    return 1.0 / (1.0 + (residuals / scale) ** 2)


def derivatives(
    residuals: Callable[[Floats], Floats], at: Floats, steps: Floats
) -> tuple[Floats, Floats]:
    """Residuals at some points, and their derivatives by difference quotients.

    Args:
        residuals: Of each row of parameters; a row of NaN where they are not possible.
        at: Shape (n, p).
        steps: The scale of each parameter, shape (p,); derivatives are in this unit.

    Returns:
        Shapes (n, m) and (n, p, m).
    """
    count, size = at.shape
    tried = np.repeat(at[:, None, :], size + 1, axis=1)
    index = np.arange(size)
    tried[:, index + 1, index] += STEP * steps
    found = residuals(tried.reshape(-1, size)).reshape(count, size + 1, -1)
    return found[:, 0], (found[:, 1:] - found[:, :1]) / STEP


def refine(
    residuals: Callable[[Floats], Floats],
    starts: Floats,
    steps: Floats,
    *,
    iterations: int,
    scale: float = math.inf,
) -> tuple[Floats, Floats]:
    """Moves every start to a near minimum of the sum of its squared residuals.

    Args:
        residuals: Of each row of parameters, shape (n, p) to (n, m); a row of NaN where they are
            not possible.
        starts: Shape (n, p).
        steps: How far each parameter can usefully move at once, shape (p,).
        iterations: Most iterations.
        scale: Scale of the robust loss, as in ``costs``.

    Returns:
        The points, shape (n, p), and their costs, shape (n,).

    Levenberg 1944, Marquardt 1963; the damping is relative to the diagonal, as in Moré 1978.
    """
    points = np.array(starts, dtype=np.float64)
    count, size = points.shape
    best = np.full(count, np.inf)
    damping = np.full(count, 1e-2)
    active = np.arange(count)
    for _ in range(iterations):
        here, slopes = derivatives(residuals, points[active], steps)
        best[active] = costs(here, scale)
        good = np.isfinite(best[active]) & np.isfinite(slopes).all(axis=(1, 2))
        active, here, slopes = active[good], here[good], slopes[good]
        if not active.size:
            break
        weighted = slopes * weights(here, scale)[:, None, :]
        normal = weighted @ slopes.transpose(0, 2, 1)
        gradient = (weighted @ here[:, :, None])[:, :, 0]
        factors = damping[active][:, None] * np.array(DAMPING)
        diagonal = np.einsum("nii->ni", normal) + 1e-12
        damped = normal[:, None] + np.einsum("nk,ni,ij->nkij", factors, diagonal, np.eye(size))
        moves = np.linalg.solve(damped, np.repeat(gradient[:, None, :, None], len(DAMPING), 1))
        moves = np.clip(moves[..., 0], -REACH, REACH) * steps
        tried = points[active][:, None, :] - moves
        found = costs(residuals(tried.reshape(-1, size)), scale).reshape(-1, len(DAMPING))
        chosen = found.argmin(axis=1)
        row = np.arange(active.size)
        lower = found[row, chosen]
        better = lower < best[active]
        gain = np.where(better, (best[active] - lower) / np.maximum(best[active], 1e-300), 0.0)
        damping[active] = np.where(
            better, np.maximum(factors[row, chosen], 1e-8), damping[active] * 100.0
        )
        points[active[better]] = tried[row, chosen][better]
        best[active[better]] = lower[better]
        # A start that no damping improved has one more iteration with a stronger one.
        active = active[(gain > CONVERGED) | (~better & (damping[active] < 1e3))]
        if not active.size:
            break
    return points, best
