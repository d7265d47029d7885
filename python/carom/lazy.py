"""Heavy libraries, loaded at their first use, so that ``import carom`` stays fast.

The rule of the package: a module imports carom's modules and the standard library at its top.
NumPy and pyarrow come from here, Ray from ``carom.cluster``. Three parts load heavy libraries
at their top, so other modules import them inside the function that uses them: ``carom.picture``
(Matplotlib), ``carom.env`` (Gymnasium) and ``carom.serve`` (an HTTP server).
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from carom.errors import InputError

__all__ = ["np", "pa", "pq"]


class LazyModule:
    """Stands for a module and imports it when an attribute is read.

    Args:
        name: The module's full name.
        missing: The fault and the remedy if the module is not installed; None raises ImportError.
    """

    def __init__(self, name: str, missing: tuple[str, str] | None = None) -> None:
        self._name = name
        self._missing = missing

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("__"):
            # Tools look for such names in every object; they must not load the module.
            raise AttributeError(attribute)
        try:
            module = import_module(self._name)
        except ImportError:
            if self._missing is None:
                raise
            raise InputError("unsupported", "", *self._missing) from None
        value = getattr(module, attribute)
        # Kept as an attribute of its own, so that the next read does not call this method.
        setattr(self, attribute, value)
        return value

    def __reduce__(self) -> tuple[type[LazyModule], tuple[Any, ...]]:
        # Functions sent to Ray's workers take their globals along.
        return (LazyModule, (self._name, self._missing))


if TYPE_CHECKING:
    import numpy as np
    import pyarrow as pa
    import pyarrow.parquet as pq
else:
    _NO_ARROW = ("a sweep needs pyarrow", "install it: pip install 'carom[sweep]'")
    np = LazyModule("numpy")
    pa = LazyModule("pyarrow", _NO_ARROW)
    pq = LazyModule("pyarrow.parquet", _NO_ARROW)
