"""Old spellings of renamed things: each still works and warns with the new name.

The warning is a ``FutureWarning``, which Python shows to every user; a ``DeprecationWarning`` would
be hidden outside ``__main__``.
"""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable, Mapping
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")
C = TypeVar("C", bound=type)


def warn(old: str, new: str, *, stacklevel: int = 2) -> None:
    """Warn that ``old`` is now called ``new``.

    Args:
        old: The old spelling, as the user wrote it.
        new: The new spelling.
        stacklevel: As in ``warnings.warn``: 2 points at the caller of the calling function.
    """
    warnings.warn(f"{old} is now {new}", FutureWarning, stacklevel=stacklevel + 1)


def renamed_arguments(**renamed: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let a function accept old names of its keyword arguments.

    Args:
        renamed: ``old="new"`` for each renamed argument.

    The decorated function raises ``TypeError`` when both spellings are given.
    """

    def decorate(function: Callable[P, R]) -> Callable[P, R]:
        # Callers write the class's name, not ``__init__``.
        name = function.__qualname__.removesuffix(".__init__")

        @functools.wraps(function)
        def wrapper(*args: P.args, **kwargs: P.kwargs) -> R:
            given: dict[str, Any] = kwargs
            for old in renamed.keys() & given.keys():
                new = renamed[old]
                if new in given:
                    raise TypeError(f"{name}() got both {new!r} and its old spelling {old!r}")
                warn(f"{name}({old}=...)", f"{name}({new}=...)")
                given[new] = given.pop(old)
            return function(*args, **kwargs)

        return wrapper

    return decorate


def renamed_attribute(old: str, new: str) -> property:
    """A property under the old name of an attribute, to be assigned in the class body."""

    def get(self: Any) -> Any:
        kind = type(self).__name__
        warn(f"{kind}.{old}", f"{kind}.{new}")
        return getattr(self, new)

    return property(get, doc=f"Old spelling of ``{new}``.")


def renamed_fields(**renamed: str) -> Callable[[C], C]:
    """Let a dataclass accept old names of its fields, as arguments and as attributes.

    Args:
        renamed: ``old="new"`` for each renamed field.
    """

    def decorate(cls: C) -> C:
        made: Any = cls
        made.__init__ = renamed_arguments(**renamed)(made.__init__)
        for old, new in renamed.items():
            setattr(cls, old, renamed_attribute(old, new))
        return cls

    return decorate


def renamed_function(old: str, new: Callable[P, R], *, name: str | None = None) -> Callable[P, R]:
    """A function under an old name, which calls the new one.

    Args:
        old: The old spelling, in full.
        new: The function itself.
        name: The new spelling in full; the function's own name if None.
    """

    @functools.wraps(new)
    def wrapper(*args: P.args, **kwargs: P.kwargs) -> R:
        warn(f"{old}()", f"{name or new.__qualname__}()")
        return new(*args, **kwargs)

    return wrapper


def renamed_keys(
    place: str, given: Mapping[str, Any], renamed: Mapping[str, str]
) -> dict[str, Any]:
    """A dictionary of options with old keys replaced by new ones.

    Args:
        place: Name of the dictionary in messages.
        given: The dictionary.
        renamed: New keys by old ones. Where both are given, the new one is used.
    """
    found = dict(given)
    for old, new in renamed.items():
        if old in found:
            warn(f"{place}.{old}", f"{place}.{new}", stacklevel=3)
            value = found.pop(old)
            found.setdefault(new, value)
    return found
