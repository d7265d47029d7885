"""Plain values of results whose keys are also attributes."""

from __future__ import annotations

import keyword
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar


class Record(dict[str, Any]):
    """A dict whose keys are also attributes: ``event.time`` is ``event["time"]``.

    A key that is a word of Python has an underscore behind its attribute: ``event.from_`` is
    ``event["from"]``. A subclass declares its keys; a type checker and an editor know them then.
    """

    __slots__ = ()

    # What attributes give whose keys may be missing.
    _DEFAULTS: ClassVar[Mapping[str, Any]] = {}

    if not TYPE_CHECKING:
        # Hidden from type checkers, which would else accept every attribute.

        def __getattr__(self, name: str) -> Any:
            key = name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name
            if key in self:
                return self[key]
            if key in self._DEFAULTS:
                return self._DEFAULTS[key]
            known = ", ".join(self)
            raise AttributeError(f"no {name!r} here; there are: {known}")

    def __dir__(self) -> list[str]:
        words = (f"{key}_" if keyword.iskeyword(key) else key for key in self)
        return sorted({*super().__dir__(), *self._DEFAULTS, *words})
