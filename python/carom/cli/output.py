"""Output of the command line: data to stdout, messages to stderr; and input from stdin."""

from __future__ import annotations

import contextlib
import json as js
import signal
import sys
from pathlib import Path
from typing import Any, Protocol

import carom
from carom.errors import InputError
from carom.event_table import printable
from carom.files import at_file, shown, text_of
from carom.streams import emit

__all__ = [
    "emit",
    "emit_answer",
    "file_name",
    "keep_sockets",
    "read",
    "read_bytes",
    "read_shot",
    "say",
    "say_json",
]


class Answer(Protocol):
    """What a question finds: it prints as text, and has its values for JSON."""

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        ...


def say(text: str) -> None:
    """Print one sentence to stderr."""
    _print_error_line(f"carom: {printable(text)}")


def say_json(data: Any) -> None:
    """Print JSON to stderr, for a bug report."""
    _print_error_line(js.dumps(data))


def emit_answer(answer: Answer, *, json: bool) -> None:
    """Print an answer as JSON or as text."""
    emit(js.dumps(answer.to_dict()) if json else str(answer))


def _print_error_line(line: str) -> None:
    # Without a stderr, `print` would write to stdout.
    if sys.stderr is not None:
        # The exit code tells the same where stderr cannot.
        with contextlib.suppress(OSError):
            print(line, file=sys.stderr, flush=True)


def keep_sockets() -> None:
    """Let writing to a closed connection raise an error instead of ending the process.

    A filter should end quietly when its pipe is closed; a server should not.
    """
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)


def read(path: str) -> str:
    """The text of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8, or stdin is closed.
    """
    return text_of(read_bytes(path), file_name(path))


def read_shot(path: str) -> carom.Shot:
    """The shot of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not a valid shot; the error of a syntax fault names the file.
    """
    return carom.Shot._read(read(path), file_name(path))


def format_of(file: Any) -> str:
    """The format that a file of carom names; that of a shot file if it names none."""
    return str(file.get("format", "carom-shot")) if isinstance(file, dict) else "carom-shot"


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
        raise InputError("system", "stdin", "it is closed", "give the name of a file")
    with at_file(file_name(path)):
        return sys.stdin.buffer.read()
