"""Reading another engine's data, with errors that name the place."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from carom.errors import InputError

_REMEDY = "give a system that pooltool 0.6 saved"


class Place:
    """A value and the path to it from the top of the file."""

    __slots__ = ("path", "value")

    def __init__(self, value: Any, path: str = "") -> None:
        self.value = value
        self.path = path

    def refuse(self, kind: str, fault: str, remedy: str = _REMEDY) -> InputError:
        """The error for this value."""
        return InputError(kind, self.path or "the file", fault, remedy)

    def __getitem__(self, key: str | int) -> Place:
        if isinstance(key, int):
            return Place(self.items()[key], f"{self.path}[{key}]")
        found = self.get(key)
        if found is None:
            raise self.refuse("missing", f'has no "{key}"')
        return found

    def get(self, key: str) -> Place | None:
        """The value at a key; None if it is missing or null."""
        if not isinstance(self.value, Mapping):
            raise self.refuse("wrong-type", "is not an object {...}")
        value = self.value.get(key)
        return None if value is None else Place(value, f"{self.path}.{key}".lstrip("."))

    def members(self) -> Iterator[tuple[str, Place]]:
        """The keys of an object, each with its value."""
        if not isinstance(self.value, Mapping):
            raise self.refuse("wrong-type", "is not an object {...}")
        return ((str(key), self[key]) for key in self.value)

    def items(self) -> Sequence[Any]:
        """The items of a list that is not empty."""
        if isinstance(self.value, str | bytes) or not isinstance(self.value, Sequence):
            raise self.refuse("wrong-type", "is not a list [...]")
        if not self.value:
            raise self.refuse("wrong-count", "is an empty list")
        return self.value

    def number(self) -> float:
        """A finite number."""
        if isinstance(self.value, bool) or not isinstance(self.value, int | float):
            raise self.refuse("wrong-type", f"is {self.value!r}", "write a number")
        if not math.isfinite(self.value):
            raise self.refuse("out-of-range", f"is {self.value}", "write a finite number")
        return float(self.value)

    def vector(self) -> list[float]:
        """Three finite numbers."""
        if len(self.items()) != 3:
            raise self.refuse(
                "wrong-count", f"has {len(self.items())} items", "write three numbers"
            )
        return [self[i].number() for i in range(3)]

    def text(self) -> str:
        """A string."""
        if not isinstance(self.value, str):
            raise self.refuse("wrong-type", f"is {self.value!r}", "write a text")
        return self.value
