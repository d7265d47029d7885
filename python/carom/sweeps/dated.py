"""Dated names of presets in a spec, so that it means the same when presets have new values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

from carom import _core

# The parts of a shot file that may be the name of a preset, or contain one.
_PRESETS = ("table", "table.base", "table.physics", "physics", "physics.base")
# The ways to vary a parameter that list its values.
_LISTS = ("grid", "choice")


def shots(layouts: tuple[_core.Shot, ...], vary: Any) -> list[dict[str, Any]]:
    """The files of the layouts with dated names.

    The physics that belongs to the table is named too, as in a record. It is not if the table
    varies: every table then has its own physics.
    """
    tables = isinstance(vary, Mapping) and any(
        isinstance(path, str) and path.split(".")[0] == "table" for path in vary
    )
    dated: Literal["all", "named"] = "named" if tables else "all"
    return [shot.to_object(elevation=False, dated=dated) for shot in layouts]


def vary(given: Any) -> Any:
    """The ``vary`` of a spec with dated names; what is not valid there stays as it is."""
    if not isinstance(given, Mapping):
        return given
    return {path: _how(path, how) for path, how in given.items()}


def _how(path: Any, how: Any) -> Any:
    if path not in _PRESETS or not isinstance(how, Mapping):
        return how
    return {
        key: [_core.dated_value(path, item) for item in value]
        if key in _LISTS and isinstance(value, list | tuple)
        else value
        for key, value in how.items()
    }
