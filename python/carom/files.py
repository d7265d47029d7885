"""Text files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from carom.errors import InputError

if TYPE_CHECKING:
    import os


def read_text(path: str | os.PathLike[str]) -> str:
    """The text of a UTF-8 file.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8.
    """
    try:
        return Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not a text file ({error.reason}); JSON is UTF-8") from None
