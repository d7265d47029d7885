"""Where things go: data to stdout, talk to stderr."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any


def say(text: str) -> None:
    """One sentence to stderr."""
    print(f"carom: {text}", file=sys.stderr)


def say_json(data: Any) -> None:
    """JSON to stderr, for a bug report."""
    print(json.dumps(data), file=sys.stderr)


def emit(text: str) -> None:
    """Data to stdout."""
    sys.stdout.write(text if text.endswith("\n") else text + "\n")
    # Here and not when Python ends, so that a full disk is an error like any other.
    sys.stdout.flush()


def save(path: Path, content: str | bytes) -> None:
    """Data to a file."""
    if isinstance(content, bytes):
        path.write_bytes(content)
    else:
        path.write_text(content, encoding="utf-8")


def read(path: str) -> str:
    """The text of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8.
    """
    from carom.errors import InputError
    from carom.shot import read_text

    if path != "-":
        return read_text(path)
    try:
        return sys.stdin.buffer.read().decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"stdin: not text ({error.reason}); JSON is UTF-8") from None
