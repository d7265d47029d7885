"""Reading the parts of ``carom-player/1``, with errors that name the key."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from carom.arguments import array, number, text
from carom.errors import InputError
from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

FORMAT = "carom-player/1"
#: What helps against a damaged file.
REMEDY = "write the file with carom learn player, or with PlayerPosterior.save"


def value_of(part: Any, key: str, within: str = "") -> Any:
    """The value of a key of the file, or of its part ``within``.

    Raises:
        InputError: The part is not an object, or lacks the key.
    """
    if not isinstance(part, Mapping):
        fault = f"found {type(part).__name__}, not an object"
        raise InputError("wrong-type", within or "the file", fault, REMEDY)
    if key not in part:
        place = f"{within}.{key}" if within else key
        raise InputError("missing", place, "the key is missing", REMEDY)
    return part[key]


def within(place: str, value: Any, low: float, high: float) -> float:
    """A number from ``low`` to ``high``.

    Raises:
        InputError: It is none, or out of this range.
    """
    found = number(place, value)
    if not low <= found <= high:
        remedy = f"write a number from {low:g} to {high:g}"
        raise InputError("out-of-range", place, f"{found:g} is out of range", remedy)
    return found


def vector(place: str, value: Any) -> Floats:
    """Five finite numbers from 0 on, shape (5,).

    Raises:
        InputError: They are not.
    """
    found = array(place, value)
    if found.shape != (5,):
        fault = f"its shape is {found.shape}, not five numbers"
        raise InputError("wrong-count", place, fault, REMEDY)
    return _finite(place, found, 0.0)


def rows(place: str, value: Any, width: int, *, low: float = -math.inf) -> Floats:
    """Rows of finite numbers from ``low`` on, at least one, shape (n, width).

    Raises:
        InputError: They are not.
    """
    found = array(place, value)
    if found.ndim != 2 or found.shape[0] == 0 or found.shape[1] != width:
        fault = f"its shape is {found.shape}, not rows of {width} numbers"
        raise InputError("wrong-count", place, fault, REMEDY)
    return _finite(place, found, low)


def _finite(place: str, found: Floats, low: float) -> Floats:
    if not (np.isfinite(found) & (found >= low)).all():
        fault = "a number is not finite" + (f", or below {low:g}" if low > -math.inf else "")
        raise InputError("out-of-range", place, fault, REMEDY)
    return found


def covariances(place: str, lower: Floats) -> Floats:
    """The matrices, shape (n, 5, 5), whose lower triangles are given by rows, shape (n, 15).

    Raises:
        InputError: One is not positive definite.
    """
    covariance = np.zeros((len(lower), 5, 5))
    covariance[:, *np.tril_indices(5)] = lower
    covariance += np.tril(covariance, -1).transpose(0, 2, 1)
    wrong = np.flatnonzero(np.linalg.eigvalsh(covariance)[:, 0] <= 0.0)
    if wrong.size:
        fault = "it is not positive definite"
        raise InputError("out-of-range", f"{place}[{wrong[0]}]", fault, REMEDY)
    return covariance


def choices(place: str, value: Any) -> Iterator[tuple[str, tuple[tuple[float, float, float], ...]]]:
    """The name and the quantiles of each choice about the intentions.

    Raises:
        InputError: They are not a list of objects with ``name`` and five rows ``sigma``.
    """
    if not isinstance(value, Sequence) or isinstance(value, str):
        raise InputError("wrong-type", place, f"found {type(value).__name__}, not a list", REMEDY)
    for index, row in enumerate(value):
        own = f"{place}[{index}]"
        name = text(f"{own}.name", value_of(row, "name", own))
        sigma = rows(f"{own}.sigma", value_of(row, "sigma", own), 3, low=0.0)
        if len(sigma) != 5:
            fault = f"found {len(sigma)} rows, not five"
            raise InputError("wrong-count", f"{own}.sigma", fault, REMEDY)
        yield name, tuple((low, middle, high) for low, middle, high in sigma.tolist())
