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

    ``name`` has no date if the values are the newest; ``dated_name`` names them for ever. Older
    editions follow the newest ones. Batch results number the pockets in the order given here.
    """
    return _core.tables()


def physics() -> list[dict[str, Any]]:
    """All presets of physics with their values, and the source of every value.

    Each has ``name``, ``dated_name``, ``parameters`` (a list of ``key``, ``value``, ``unit``,
    ``evidence``, ``source``) and ``physics``, the same values as a shot file has them.
    ``evidence`` is ``measured``, ``fit``, ``specified`` (a rule book, a convention, a published
    model) or ``estimate``. Older editions follow the newest ones.
    """
    return _core.physics()


def schema(kind: Literal["shot", "trace", "play", "sweep"] = "shot") -> dict[str, Any]:
    """The JSON Schema of the shot file, of the trace, of a frame's play, or of a sweep's spec.

    ``Frame.answer_schema`` gives that of the answers to a frame's present request.

    Raises:
        InputError: There is no schema of that name.
    """
    if checked("kind", kind, '"shot"') == "sweep":
        path = Path(__file__).with_name("data") / "carom-sweep-1.json"
        text = path.read_text(encoding="utf-8")
    elif kind in ("shot", "trace", "play"):
        text = _core.schema(kind)
    else:
        raise InputError(
            f'kind: there is no schema "{kind}"; write "shot", "trace", "play" or "sweep"'
        )
    result: dict[str, Any] = json.loads(text)
    return result
