"""What the engine knows by itself: the tables' presets and the schemas of its files."""

from __future__ import annotations

import json
from typing import Any, Literal

from carom import _core
from carom.errors import InputError


def tables() -> list[dict[str, Any]]:
    """Every preset with its dimensions, cushions and pockets, m.

    Batch results number the pockets in the order that they have here.
    """
    return _core.tables()


def schema(kind: Literal["shot", "trace", "sweep"] = "shot") -> dict[str, Any]:
    """The JSON Schema of the shot file, of the trace, or of a sweep's spec.

    Raises:
        InputError: There is no such file.
    """
    if kind == "sweep":
        # Here, since it takes time to import.
        from importlib.resources import files

        text = files("carom").joinpath("data", "carom-sweep-1.json").read_text(encoding="utf-8")
    elif kind in ("shot", "trace"):
        text = _core.schema(kind)
    else:
        raise InputError(f'there is no schema "{kind}"; write "shot", "trace" or "sweep"')
    result: dict[str, Any] = json.loads(text)
    return result
