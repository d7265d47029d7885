"""Checks of arguments before they go to Rust. An error names the argument and the remedy."""

from __future__ import annotations

import math
import operator
import os
import sys
import warnings
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, TypeVar

from carom.errors import AngleWarning, InputError
from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

T = TypeVar("T")

# Seeds and indices have 64 bits.
WORD = 1 << 64

# Types that become a number but are a mistake where one is needed.
_NO_NUMBERS = (str, bytes, bytearray, bool)

# An azimuth beyond this, rad, was probably meant in degrees: a full turn, with room for rounding.
_FULL_TURN = 2 * math.pi * (1 + 1e-9)

# More threads than any machine has cores; an operating system may refuse to start more.
_MOST_THREADS = 1024

# Most numbers along one axis of a grid, as Rust limits a whole grid.
_MOST_NUMBERS = 10**7

# Most results of balls in one call: 25 bytes each, 10 GB in all. A larger array would exhaust the
# memory of most machines, and the operating system would end the process.
_MOST_RESULTS = 4 * 10**8


def whole(name: str, value: Any, end: int = WORD, *, low: int = 0) -> int:
    """A whole number, Python's or NumPy's, from ``low`` up to but not including ``end``."""
    try:
        # True and False are integers in Python, but a mistake here.
        found = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        found = None
    if found is None or not low <= found < end:
        raise InputError(
            "out-of-range",
            name,
            f"{value!r} is out of range",
            f"give a whole number from {low} to {end - 1}",
        )
    return found


def number(name: str, value: Any) -> float:
    """A number, which may be infinite or NaN."""
    if type(value) is float:
        # The usual case. A player in a match answers within some microseconds.
        return value
    try:
        if not isinstance(value, _NO_NUMBERS):
            return float(value)
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError("wrong-type", name, f"{_shown(value)} is not a number", "write one")


def numbers(name: str, value: Any, count: int) -> tuple[float, ...]:
    """A sequence of ``count`` numbers, such as coordinates."""
    if type(value) is tuple and len(value) == count:
        return tuple([number(name, item) for item in value])
    items = list(value) if isinstance(value, Iterable) and not isinstance(value, str) else []
    if len(items) != count:
        raise InputError(
            "wrong-count", name, f"{_shown(value)} is not {count} numbers", "write them as a list"
        )
    return tuple(number(name, item) for item in items)


def array(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """A number or an array of any shape, whose values may be infinite or NaN."""
    try:
        found = np.asarray(value)
        # Integers beyond 64 bits are objects.
        if found.dtype.kind in "iufO":
            return found.astype(np.float64, copy=False)
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError("wrong-type", name, "not a number or an array of numbers", "give one")


def flat(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """A flat array of finite numbers; a single number gives an array of length 1."""
    found = np.atleast_1d(array(name, values))
    if found.ndim != 1 or not found.size or not np.isfinite(found).all():
        raise InputError(
            "out-of-range",
            name,
            "not finite numbers in one dimension",
            "give a number or a flat array",
        )
    if found.size > _MOST_NUMBERS:
        raise InputError(
            "out-of-range",
            name,
            f"{found.size} numbers are too many",
            f"give at most {_MOST_NUMBERS}",
        )
    return found


def angle(name: str, radians: Any, degrees: Any) -> float | None:
    """An angle that is given in radians or in degrees, rad; None if it is not given.

    Args:
        name: The argument with radians; that with degrees has ``_deg`` behind it.
        radians: Its value, or None.
        degrees: The value of the other one, or None.

    Raises:
        InputError: Both are given, or a value is not a number.
    """
    _check_one_angle(name, radians, degrees)
    if degrees is not None:
        return math.radians(number(f"{name}_deg", degrees))
    return None if radians is None else number(name, radians)


def angles(name: str, radians: ArrayLike | None, degrees: ArrayLike | None) -> Any:
    """As ``angle``, for a number or an array of any shape."""
    _check_one_angle(name, radians, degrees)
    if degrees is not None:
        return np.radians(array(f"{name}_deg", degrees))
    return None if radians is None else array(name, radians)


def _check_one_angle(name: str, radians: Any, degrees: Any) -> None:
    if radians is not None and degrees is not None:
        raise InputError(
            "duplicate",
            name,
            f"{name}_deg gives the same angle",
            f"keep {name} (rad) or {name}_deg (degrees)",
        )


def warn_of_degrees(name: str, radians: Any) -> None:
    """Warn of an azimuth, or of several, beyond a full turn: probably it is in degrees.

    Args:
        name: The argument, or the place in a file.
        radians: A number or an array, rad; None does nothing.
    """
    if isinstance(radians, float | int):
        largest = abs(radians)
    elif radians is None or not np.size(radians):
        return
    else:
        largest = float(np.max(np.abs(radians)))
    # Infinity and NaN are refused elsewhere.
    if not _FULL_TURN < largest < math.inf:
        return
    warnings.warn(
        f"{name}: {largest:g} rad is more than a full turn; write degrees as {name}_deg",
        AngleWarning,
        stacklevel=_level_of_user(),
    )


def _level_of_user() -> int:
    """The ``stacklevel``, as seen from the calling function, of the first caller outside carom."""
    level, frame = 0, sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] == "carom":
        level, frame = level + 1, frame.f_back
    return level + 1


def text(name: str, value: Any, such_as: str = "") -> str:
    """A string in valid Unicode; ``such_as`` is an example for the error message."""
    if type(value) is str and value.isascii():
        # The usual case.
        return value
    if not isinstance(value, str):
        remedy = f"write a text{such_as and f', such as {such_as}'}"
        raise InputError("wrong-type", name, f"{_shown(value)} is not a text", remedy)
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(
            "syntax", name, "the text is not valid Unicode", "write one without surrogates"
        ) from None
    return value


def truth(name: str, value: Any) -> bool:
    """True or False, Python's or NumPy's."""
    if type(value).__name__ not in ("bool", "bool_"):
        raise InputError(
            "wrong-type", name, f"{_shown(value)} is neither True nor False", "give one of them"
        )
    return bool(value)


def instance(name: str, value: Any, kind: type[T], such_as: str) -> T:
    """An instance of one of carom's classes; ``such_as`` is an example for the error message."""
    if not isinstance(value, kind):
        found = type(value).__name__
        raise InputError(
            "wrong-type",
            name,
            f"found a {found}",
            f"give carom.{kind.__name__}, for example {such_as}",
        )
    return value


def core(name: str, value: Any, kind: type[T], such_as: str) -> T:
    """The Rust object inside one of carom's objects; ``such_as`` is an example for the error."""
    found = getattr(value, "_core", None)
    if not isinstance(found, kind):
        raise InputError(
            "wrong-type",
            name,
            f"found a {type(value).__name__}",
            f"give carom.{kind.__name__}, for example {such_as}",
        )
    return found


def check_results(name: str, shots: int, balls: int) -> None:
    """Reject a number of shots whose results would exhaust the memory."""
    most = _MOST_RESULTS // max(balls, 1)
    if shots > most:
        raise InputError(
            "out-of-range",
            name,
            f"{shots} shots of {balls} balls are too many for one call",
            f"give at most {most}, in several calls",
        )


def thread_count(threads: int | None) -> int:
    """``threads`` in the form that Rust accepts: 0 is one per core."""
    if threads is None:
        return 0
    try:
        return min(whole("threads", threads, low=1), _MOST_THREADS)
    except InputError:
        remedy = "give a whole number ≥ 1 or None"
        raise InputError("wrong-type", "threads", f"{threads!r} is not a count", remedy) from None


def cores(threads: int | None) -> int:
    """The number of threads on this machine."""
    return thread_count(threads) or os.cpu_count() or 1


def _shown(value: Any) -> str:
    """The value as written in Python if that is short, else its type."""
    shown = repr(value)
    return shown if len(shown) <= 60 and "\n" not in shown else f"a {type(value).__name__}"
