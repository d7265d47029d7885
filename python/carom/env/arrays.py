"""Arrays in the form that Rust accepts."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.errors import InputError


def floats(name: str, values: Any) -> NDArray[np.float32]:
    """Numbers in the form that Rust accepts.

    Raises:
        InputError: ``values`` is not an array of numbers.
    """
    try:
        return np.ascontiguousarray(values, dtype=np.float32)
    except (TypeError, ValueError):
        raise InputError("wrong-type", name, "not numbers", "give an array of numbers") from None
