"""Text files and paths."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from carom.errors import InputError


def checked_path(name: str, value: Any, such_as: str) -> Path:
    """A path that was passed as an argument.

    Args:
        name: The name of the argument.
        value: What the caller gave.
        such_as: An example of a path, for the error message.

    Raises:
        InputError: It is not a path, or it has a NUL character.
    """
    place = os.fspath(value) if isinstance(value, str | os.PathLike) else None
    if not isinstance(place, str):
        found = type(value).__name__
        raise InputError(f'{name}: found a {found}; give a path, such as "{such_as}"')
    if "\0" in place:
        raise InputError(f"{name}: the path has a NUL character; remove it")
    return Path(place)


def shown(path: str | os.PathLike[str]) -> str:
    """A path for an error message; bytes that are not UTF-8 are shown as ``?``."""
    return os.fspath(path).encode(errors="replace").decode()


def read_text(path: str | os.PathLike[str]) -> str:
    """The text of a UTF-8 file.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8.
    """
    try:
        return Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not UTF-8 text ({error.reason}); encode it as UTF-8") from None
