"""Data to stdout."""

from __future__ import annotations

import sys

from carom.errors import InputError


def emit(text: str) -> None:
    """Write data to stdout, with a newline at its end.

    Raises:
        InputError: Stdout is closed.
    """
    if sys.stdout is None:
        raise InputError("stdout: it is closed; send it to a file or to a program")
    sys.stdout.write(text if text.endswith("\n") else text + "\n")
    # Flushed here and not when Python ends, so that a full disk is an error like any other.
    sys.stdout.flush()
