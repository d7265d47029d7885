"""The rotation between two frames from pairs of points, with checks that name what is wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.arguments import array, number, numbers
from carom.errors import InputError
from carom.lazy import np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

# Least width of the points across the line through them, as a share of their length along it.
# With less, the rotation about the line is a hundred times as uncertain as the others.
_WIDTH = 0.01
# Largest relative difference of the scales of the two frames. Robots and tape measures differ by
# less than 1 %; units differ by a factor of 2.54 or more.
_SCALE = 0.1
# Largest root mean square of the residuals, as a share of the points' distance from their centre.
# Pairs in a wrong order have about 1.
_MISFIT = 0.1
# Points are of a mirrored frame if mirroring lowers the root mean square of the residuals by this
# factor, and if without mirroring it is more than this share of the points' distance.
_MIRROR_GAIN, _MIRROR_MISFIT = 3.0, 1e-3


def pairs_of_points(table: ArrayLike, robot: ArrayLike) -> tuple[Array, Array]:
    """The points of both frames, m, each of shape (n_points, 3)."""
    seen, places = points("table", table), points("robot", robot)
    for name, found in (("table", seen), ("robot", places)):
        if found.ndim != 2:
            fault = f"has the shape {found.shape}"
            raise InputError("wrong-count", name, fault, "give an array of shape (n_points, 3)")
    if len(seen) != len(places):
        fault = f"{len(places)} points for {len(seen)} of the table"
        raise InputError("wrong-count", "robot", fault, "give the same points in the same order")
    return seen, places


def check_count(count: int, up: Array | None) -> None:
    """Refuse fewer points than a rotation needs."""
    least = 3 if up is None else 2
    if count < least:
        fault = f"{count} points are too few"
        remedy = "give three or more points, or two and the vertical"
        raise InputError("wrong-count", "table", fault, remedy)


def check_spread(x: Array, y: Array, up: Array | None) -> None:
    """Refuse points that leave the rotation open, and frames in different units."""
    level = x if up is None else x[:, :2]
    for name, arms in (("table", x), ("robot", y)):
        spread = np.linalg.svd(arms, compute_uv=False)
        if spread[0] == 0.0 or (up is None and spread[1] < _WIDTH * spread[0]):
            remedy = "add a point away from the line, or give two points and the vertical"
            raise InputError("out-of-range", name, "the points are on a line", remedy)
    if np.linalg.norm(level) < _WIDTH * np.linalg.norm(x):
        fault, remedy = "the points are above each other", "give points that are apart on the table"
        raise InputError("out-of-range", "table", fault, remedy)
    ratio = float(np.linalg.norm(y) / np.linalg.norm(x))
    if abs(ratio - 1) > _SCALE:
        fault = f"its points are {ratio:.4g} times as far apart as the table's"
        raise InputError("mismatch", "robot", fault, "give both in metres, in the same order")


def check_fit(x: Array, y: Array, up: Array | None, rotation: Array) -> None:
    """Refuse mirrored frames, and pairs that no rotation fits."""

    def misfit(arms: Array, rotation: Array) -> float:
        return float(np.linalg.norm(y - arms @ rotation.T) / np.linalg.norm(y))

    found = misfit(x, rotation)
    mirror = x * [-1, 1, 1]
    if found > max(_MIRROR_MISFIT, _MIRROR_GAIN * misfit(mirror, best_rotation(mirror, y, up))):
        raise mirrored("robot", "the points fit only if one frame is mirrored")
    if found > _MISFIT:
        fault = f"the pairs do not fit: their residuals are {found:.0%} of the points' distances"
        remedy = "give the same points in the same order, and the right vertical"
        raise InputError("mismatch", "robot", fault, remedy)


def mirrored(place: str, fault: str) -> InputError:
    """The error of a left-handed frame."""
    remedy = "give right-handed axes in both frames, and a vertical that is upward"
    return InputError("mismatch", place, fault, remedy)


def best_rotation(x: Array, y: Array, up: Array | None) -> Array:
    """The rotation that turns the rows of x to those of y best, about ``up`` if it is given."""
    found: Array
    if up is None:
        u, _, vt = np.linalg.svd(y.T @ x)
        found = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
        return found
    across = np.cross(np.eye(3)[np.argmin(np.abs(up))], up)
    across /= np.linalg.norm(across)
    upright = np.column_stack([across, np.cross(up, across), up])
    z = y @ upright
    angle = np.arctan2((x[:, 0] * z[:, 1] - x[:, 1] * z[:, 0]).sum(), (x * z)[:, :2].sum())
    found = upright @ turn(np.array([0.0, 0.0, angle]))
    return found


def unit_covariance(arms: Array, up: Array | None, *, fits_scale: bool) -> Array:
    """Covariance of the seven errors for points with a standard deviation of 1.

    About the points' centre the three groups are uncorrelated. A small rotation δ moves an arm a
    by δ × a, so the information on δ is the sum of |a|² I − a aᵀ.
    """
    information = (arms**2).sum() * np.eye(3) - arms.T @ arms
    covariance = np.zeros((7, 7))
    if up is None:
        covariance[:3, :3] = np.linalg.inv(information)
    else:
        covariance[:3, :3] = np.outer(up, up) / (up @ information @ up)
    covariance[3:6, 3:6] = np.eye(3) / len(arms)
    covariance[6, 6] = 1 / (arms**2).sum() if fits_scale else 0.0
    return covariance


def turn(vector: Array) -> Array:
    """The rotation by a rotation vector, rad (Rodrigues' formula)."""
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    rotation: Array = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return rotation


def points(name: str, value: ArrayLike) -> Array:
    """Finite coordinates, m, shape (..., 3)."""
    found = array(name, value)
    if found.ndim == 0 or found.shape[-1] != 3:
        fault, remedy = f"has the shape {found.shape}", "give x, y, z of every point"
        raise InputError("wrong-count", name, fault, remedy)
    return finite(name, found, found.shape)


def finite(name: str, value: ArrayLike, shape: tuple[int, ...]) -> Array:
    """Finite numbers of this shape."""
    found = array(name, value)
    if found.shape != shape:
        fault, remedy = f"has the shape {found.shape}", f"give an array of the shape {shape}"
        raise InputError("wrong-count", name, fault, remedy)
    if not np.isfinite(found).all():
        fault, remedy = "a number is not finite", "remove the pairs that were not measured"
        raise InputError("out-of-range", name, fault, remedy)
    return found


def positive(name: str, value: float) -> float:
    """A finite number above 0."""
    found = number(name, value)
    if not (np.isfinite(found) and found > 0):
        raise InputError("out-of-range", name, f"{found:g} is out of range", "give it above 0")
    return found


def unit_vector(name: str, value: Sequence[float]) -> Array:
    """The unit vector along three numbers."""
    found = finite(name, numbers(name, value, 3), (3,))
    length = np.linalg.norm(found)
    if length == 0:
        raise InputError("out-of-range", name, "has no length", "give an upward direction")
    unit: Array = found / length
    return unit
