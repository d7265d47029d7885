"""What the engine knows by itself: the tables' presets and the schemas of its files."""

from __future__ import annotations

import json
from typing import Any, Literal

from carom import _core


def tables() -> list[dict[str, Any]]:
    """Every preset with its dimensions, cushions and pockets, m.

    Batch results number the pockets in the order that they have here.
    """
    return _core.tables()


def schema(kind: Literal["shot", "trace"] = "shot") -> dict[str, Any]:
    """The JSON Schema of the shot file or of the trace.

    Raises:
        InputError: There is no such file.
    """
    result: dict[str, Any] = json.loads(_core.schema(kind))
    return result
