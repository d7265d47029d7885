"""Where things go: data to stdout, talk to stderr."""

from __future__ import annotations

import json
import signal
import sys
from pathlib import Path
from typing import Any

from carom.errors import InputError


def say(text: str) -> None:
    """One sentence to stderr."""
    from carom.event_table import printable

    _talk(f"carom: {printable(text)}")


def say_json(data: Any) -> None:
    """JSON to stderr, for a bug report."""
    _talk(json.dumps(data))


def _talk(line: str) -> None:
    # Without a stderr, `print` would talk to stdout.
    if sys.stderr is not None:
        print(line, file=sys.stderr)


def keep_sockets() -> None:
    """Have a connection that the other side closes be an error, not the end of the process.

    To end quietly is right for a filter whose pipe is closed, and wrong for a server.
    """
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)


def emit(text: str) -> None:
    """Data to stdout."""
    if sys.stdout is None:
        raise InputError("stdout: it is closed; send it to a file or to a program")
    sys.stdout.write(text if text.endswith("\n") else text + "\n")
    # Here and not when Python ends, so that a full disk is an error like any other.
    sys.stdout.flush()


def save(path: Path, content: str | bytes) -> None:
    """Data to a file."""
    data = content if isinstance(content, bytes) else content.encode()
    try:
        path.write_bytes(data)
    except OSError as error:
        # A full disk does not say which file it has no room for.
        error.filename = error.filename or str(path)
        raise


def read(path: str) -> str:
    """The text of a file, or of stdin for ``-``.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8, or stdin is closed.
    """
    from carom.shot import read_text

    if path != "-":
        return read_text(path)
    try:
        return read_bytes(path).decode("utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"stdin: not text ({error.reason}); JSON is UTF-8") from None


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
