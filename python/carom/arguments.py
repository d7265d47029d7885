"""What a caller gives, before it goes to Rust: what is refused is named, with the remedy."""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, TypeVar

from carom.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

T = TypeVar("T")

# Seeds and indices are 64 bits wide.
WORD = 1 << 64

# More threads than any machine has cores; beyond it an operating system may have none to give.
_MOST_THREADS = 1024


def whole(name: str, value: Any, end: int = WORD, *, low: int = 0) -> int:
    """A whole number from ``low`` up to but not including ``end``, NumPy's as well."""
    try:
        # Python's own truth values are integers, and none that anyone means.
        found = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        found = None
    if found is None or not low <= found < end:
        raise InputError(
            f"{name}: {value!r} is out of range; give a whole number from {low} to {end - 1}"
        )
    return found


def number(name: str, value: Any) -> float:
    """A number, finite or not."""
    try:
        if not isinstance(value, str | bytes | bytearray | bool):
            return float(value)
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError(f"{name}: {_shown(value)} is not a number; write one")


def numbers(name: str, value: Any, count: int) -> tuple[float, ...]:
    """So many numbers, such as the coordinates of a place."""
    items = list(value) if isinstance(value, Iterable) and not isinstance(value, str) else []
    if len(items) != count:
        raise InputError(f"{name}: {_shown(value)} is not {count} numbers; write them as a list")
    return tuple(number(name, item) for item in items)


def array(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """A number or an array of any shape, finite or not."""
    import numpy as np

    try:
        found = np.asarray(value)
        # Integers beyond 64 bits are objects.
        if found.dtype.kind in "iufO":
            return found.astype(np.float64, copy=False)
    except (TypeError, ValueError, OverflowError):
        pass
    raise InputError(f"{name}: not a number or an array of numbers; give one")


def flat(name: str, values: ArrayLike, *, above: float = -math.inf) -> NDArray[np.float64]:
    """A flat array of finite numbers, all ``above``; a single number is one of length 1."""
    import numpy as np

    found = np.atleast_1d(array(name, values))
    if found.ndim != 1 or not found.size or not np.isfinite(found).all():
        raise InputError(f"{name}: neither a finite number nor a flat array of such; give one")
    if not (found > above).all():
        raise InputError(f"{name}: {found.min():g} is out of range; give more than {above:g}")
    return found


def text(name: str, value: Any, such_as: str = "") -> str:
    """A string that Rust can have; ``such_as`` says in the refusal what would be right."""
    remedy = f"write a text{such_as and f', such as {such_as}'}"
    if not isinstance(value, str):
        raise InputError(f"{name}: {_shown(value)} is not a text; {remedy}")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{name}: a text that is not Unicode; write valid Unicode") from None
    return value


def truth(name: str, value: Any) -> bool:
    """True or False, NumPy's as well."""
    if type(value).__name__ not in ("bool", "bool_"):
        raise InputError(f"{name}: {_shown(value)} is neither True nor False; give one of them")
    return bool(value)


def instance(name: str, value: Any, kind: type[T], such_as: str) -> T:
    """A value of a class of ours; ``such_as`` says how to come by one."""
    if not isinstance(value, kind):
        found = type(value).__name__
        raise InputError(
            f"{name}: found a {found}; give carom.{kind.__name__}, for example {such_as}"
        )
    return value


def thread_count(threads: int | None) -> int:
    """``threads`` as Rust takes it: 0 is one per core."""
    if threads is None:
        return 0
    try:
        return min(whole("threads", threads, low=1), _MOST_THREADS)
    except InputError:
        remedy = "give a whole number ≥ 1 or None"
        raise InputError(f"threads: {threads!r} is not a count; {remedy}") from None


def cores(threads: int | None) -> int:
    """How many threads that is here."""
    return thread_count(threads) or os.cpu_count() or 1


def _shown(value: Any) -> str:
    """A value in one line of a sentence, or what kind it is if it would be longer than that."""
    shown = repr(value)
    return shown if len(shown) <= 60 and "\n" not in shown else f"a {type(value).__name__}"
