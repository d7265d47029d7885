"""Output of the command line: data to stdout, messages to stderr; and input from stdin."""

from __future__ import annotations

import json
import signal
import sys
from pathlib import Path
from typing import Any

import carom
from carom.errors import InputError
from carom.event_table import printable
from carom.files import read_text, shown
from carom.streams import emit

__all__ = [
    "emit",
    "file_name",
    "keep_sockets",
    "read",
    "read_bytes",
    "read_shot",
    "save",
    "say",
    "say_json",
]


def say(text: str) -> None:
    """Print one sentence to stderr."""
    _print_error_line(f"carom: {printable(text)}")


def say_json(data: Any) -> None:
    """Print JSON to stderr, for a bug report."""
    _print_error_line(json.dumps(data))


def _print_error_line(line: str) -> None:
    # Without a stderr, `print` would write to stdout.
    if sys.stderr is not None:
        print(line, file=sys.stderr)


def keep_sockets() -> None:
    """Let writing to a closed connection raise an error instead of ending the process.

    A filter should end quietly when its pipe is closed; a server should not.
    """
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)


def save(path: Path, content: str | bytes) -> None:
    """Write data to a file."""
    data = content if isinstance(content, bytes) else content.encode()
    try:
        path.write_bytes(data)
    except OSError as error:
        # The error of a full disk does not name the file.
        error.filename = error.filename or str(path)
        raise


def read(path: str) -> str:
    """The text of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8, or stdin is closed.
    """
    if path != "-":
        return read_text(path)
    try:
        return read_bytes(path).decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(
            f"stdin: not UTF-8 text ({error.reason}); encode the JSON as UTF-8"
        ) from None


def read_shot(path: str) -> carom.Shot:
    """The shot of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not a valid shot; the error of a syntax fault names the file.
    """
    return carom.Shot._read(read(path), file_name(path))


def file_name(path: str) -> str:
    """The name of a file in an error message, where ``-`` is stdin."""
    return "stdin" if path == "-" else shown(path)


def read_bytes(path: str) -> bytes:
    """The bytes of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: Stdin is closed.
    """
    if path != "-":
        return Path(path).read_bytes()
    if sys.stdin is None:
        raise InputError("stdin: it is closed; give the name of a file")
    return sys.stdin.buffer.read()
