"""Functions about a shot that are methods of ``Shot`` as well."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable
from typing import Any, Concatenate, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")

# The entry of the first argument in a docstring, with its further lines.
_SHOT = re.compile(r"^( *)shot: .*\n(?:\1 +.*\n)*", re.MULTILINE)


def method(function: Callable[Concatenate[Any, P], R]) -> Callable[Concatenate[Any, P], R]:
    """The method that calls ``function`` with the object as its first argument.

    Its signature has ``self``, and its docstring does not list the shot.
    """

    @functools.wraps(function)
    def call(self: Any, /, *args: P.args, **kwargs: P.kwargs) -> R:
        return function(self, *args, **kwargs)

    signature = inspect.signature(function)
    _, *others = signature.parameters.values()
    own = inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)
    call.__signature__ = signature.replace(parameters=[own, *others])  # type: ignore[attr-defined]
    call.__doc__ = _SHOT.sub("", function.__doc__ or "", count=1)
    call.__qualname__ = f"Shot.{function.__name__}"
    return call
