"""Reference data of the engine: the tables' presets and the schemas of its files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal

from carom import _core
from carom.arguments import text as checked
from carom.errors import InputError


def tables() -> list[dict[str, Any]]:
    """All presets of tables, with dimensions, cushions and pockets, m.

    Batch results number the pockets in the order given here.
    """
    return _core.tables()


def schema(kind: Literal["shot", "trace", "sweep"] = "shot") -> dict[str, Any]:
    """The JSON Schema of the shot file, of the trace, or of a sweep's spec.

    Raises:
        InputError: There is no schema of that name.
    """
    if checked("kind", kind, '"shot"') == "sweep":
        path = Path(__file__).with_name("data") / "carom-sweep-1.json"
        text = path.read_text(encoding="utf-8")
    elif kind in ("shot", "trace"):
        text = _core.schema(kind)
    else:
        raise InputError(f'kind: there is no schema "{kind}"; write "shot", "trace" or "sweep"')
    result: dict[str, Any] = json.loads(text)
    return result
