"""Reading a spec strictly: every refusal names the place, what is wrong, what would be right."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

from carom.errors import InputError

# Numbers of a spec that Python and the engine count with, 2⁶³ − 1.
LARGEST_WHOLE = (1 << 63) - 1


def refuse(place: str, what: str, remedy: str) -> NoReturn:
    """Raise what is wrong at ``place``."""
    raise InputError(f"{place}: {what}; {remedy}")


def fields(place: str, value: Any, known: Sequence[str]) -> dict[str, Any]:
    """The fields of an object, none of which may be unknown."""
    if not isinstance(value, Mapping):
        refuse(place or "the spec", f"found {describe(value)}", "write an object {...}")
    for key in value:
        if not isinstance(key, str):
            refuse(place or "the spec", f"the key {key!r} is no text", "write a text")
        if key not in known:
            at = f"{place}.{key}" if place else str(key)
            refuse(at, "unknown key", nearest(str(key), known))
    return dict(value)


def nearest(word: str, known: Sequence[str]) -> str:
    """The remedy for a word that is none of the ``known`` ones."""
    # Here, since it takes time to import, and mistakes are rare.
    import difflib

    close = difflib.get_close_matches(word, known, n=1)
    words = ", ".join(known)
    return f"did you mean `{close[0]}`? (known here: {words})" if close else f"write one of {words}"


def number(place: str, value: Any) -> float:
    """A finite number."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        refuse(place, f"found {describe(value)}", "write a finite number")
    return float(value)


def whole(place: str, value: Any, low: int, high: int = LARGEST_WHOLE) -> int:
    """A whole number from ``low`` up to ``high``."""
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        refuse(place, f"found {describe(value)}", f"write a whole number from {low} to {high}")
    return value


def numbers(place: str, value: Any) -> tuple[float, ...]:
    """One finite number, or a list of some."""
    if isinstance(value, list | tuple):
        if not value:
            refuse(place, "found an empty list", "write some numbers")
        return tuple(number(f"{place}[{i}]", x) for i, x in enumerate(value))
    return (number(place, value),)


def describe(value: Any) -> str:
    """What a value is, in words."""
    match value:
        case None:
            return "null"
        case bool():
            return str(value).lower()
        case int() | float():
            return f"the number {value!r}"
        case str():
            return f'the text "{value}"' if len(value) <= 40 else "a text"
        case list() | tuple():
            return f"a list of {len(value)}"
        case Mapping():
            return "an object"
    return f"a {type(value).__name__}"
