"""Data to stdout: all of it, or an error."""

from __future__ import annotations

import io
import select
import sys
from typing import TYPE_CHECKING, TextIO

from carom.errors import InputError

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

STDOUT = "stdout"


def emit(text: str) -> None:
    """Write data to stdout, with a newline at its end.

    Raises:
        InputError: Stdout is closed.
        OSError: Stdout cannot take all of the data, such as on a full disk; its ``filename`` is
            ``stdout``.
    """
    if sys.stdout is None:
        raise InputError("system", STDOUT, "it is closed", "send it to a file or to a program")
    stream = whole(sys.stdout, STDOUT)
    stream.write(text if text.endswith("\n") else text + "\n")
    # Flushed here and not when Python ends, so that a full disk is an error like any other.
    stream.flush()


def whole(stream: TextIO, name: str) -> TextIO:
    """The stream, made to write everything that it is given or to raise an error.

    With ``PYTHONUNBUFFERED`` Python's own stream ignores that a file or a pipe took only a part of
    a text. A pipe that does not block is waited for.

    Args:
        stream: Stdout or stderr. A stream that is not a file, such as in a notebook, is
            returned unchanged.
        name: What errors name as their file.
    """
    if not isinstance(stream, io.TextIOWrapper):
        return stream
    raw = getattr(stream.buffer, "raw", stream.buffer)
    if not isinstance(raw, io.FileIO):
        return stream
    stream.flush()
    return io.TextIOWrapper(
        io.BufferedWriter(_WholeFile(raw, name)),
        encoding=stream.encoding,
        errors=stream.errors,
        line_buffering=stream.line_buffering or stream.write_through,
    )


class _WholeFile(io.RawIOBase):
    """A file below a buffer, which repeats a write of which the file took only a part."""

    def __init__(self, file: io.FileIO, name: str) -> None:
        self.file = file
        self.name = name

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        return self.file.fileno()

    def isatty(self) -> bool:
        return self.file.isatty()

    def write(self, data: ReadableBuffer, /) -> int:
        try:
            while (count := self.file.write(data)) is None:
                # The pipe does not block, and it is full.
                select.select([], [self.file], [])
        except OSError as error:
            error.filename = self.name
            raise
        return count
