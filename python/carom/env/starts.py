"""The options of a reset."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from typing import Any

from carom import _core
from carom.errors import InputError
from carom.rules import Frame
from carom.shot import Shot

#: Where the first episode starts. Both keys take both values.
STARTS = ("shot", "frame")


def read_options(options: Any, known: Sequence[str]) -> dict[str, Any]:
    """The options of a reset; empty if there are none.

    Raises:
        InputError: They are not a dict, or have an unknown key.
    """
    if options is None:
        return {}
    if not isinstance(options, Mapping):
        found = type(options).__name__
        raise InputError(
            "wrong-type", "options", f"found a {found}", f"give a dict with {' or '.join(known)}"
        )
    for key in options:
        if key not in known:
            near = difflib.get_close_matches(str(key), known, 1)
            meant = f'did you mean "{near[0]}"? ' if near else ""
            raise InputError(
                "unknown-name",
                f"options.{key}",
                "there is no such option",
                f"{meant}(known: {', '.join(known)})",
            )
    return dict(options)


def read_starts(options: Mapping[str, Any], count: int) -> list[_core.Shot | _core.Frame | None]:
    """Where episodes start: nothing, one start, or one for each of ``count`` environments.

    Raises:
        InputError: There are two keys, another number of starts, or something that is neither a
            shot nor a frame.
    """
    given = [key for key in STARTS if options.get(key) is not None]
    if not given:
        return []
    if len(given) > 1:
        raise InputError(
            "conflict", "options.frame", "there is a shot too", "give only one of them"
        )
    key = given[0]
    value = options[key]
    if isinstance(value, Sequence) and not isinstance(value, str):
        if len(value) != count:
            raise InputError(
                "wrong-count",
                f"options.{key}",
                f"there are {len(value)} for {count} environments",
                "give one, or one for each (None for its usual start)",
            )
        return [
            None if one is None else start(one, f"options.{key}[{index}]")
            for index, one in enumerate(value)
        ]
    return [start(value, f"options.{key}")]


def start(value: Any, place: str) -> _core.Shot | _core.Frame:
    """A shot, a frame, or the dict of one, in the form that Rust accepts.

    Raises:
        InputError: It is none of these.
    """
    try:
        if isinstance(value, Mapping):
            is_frame = str(value.get("format", "")).startswith("carom-frame/")
            value = Frame.replay(value) if is_frame else Shot.from_dict(dict(value))
    except InputError as error:
        raise error.inside(place, ": ") from error
    if isinstance(value, Shot | Frame):
        return value._core
    raise InputError(
        "wrong-type",
        place,
        f"found a {type(value).__name__}",
        "give a carom.Shot, a carom.Frame, the dict of a shot, or a frame's record",
    )
