"""Files and paths: reading text, and writing a file in one step."""

from __future__ import annotations

import errno
import os
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from carom.errors import InputError

# Errors of a folder in which no file can be made or replaced although the file itself may be
# writable, such as a single file that is mounted into a container.
_FIXED = {errno.EACCES, errno.EPERM, errno.EROFS, errno.EBUSY, errno.EXDEV}


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
        raise InputError(
            "wrong-type", name, f"found a {found}", f'give a path, such as "{such_as}"'
        )
    if "\0" in place:
        raise InputError("syntax", name, "the path has a NUL character", "remove it")
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
    return text_of(Path(path).read_bytes(), shown(path))


def text_of(data: bytes, name: str) -> str:
    """The text of the content of a UTF-8 file; with LF for every end of a line.

    Args:
        data: The content.
        name: The name of the file for an error message.

    Raises:
        InputError: It is not UTF-8.
    """
    refuse_other_encoding(data, name)
    try:
        return data.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        raise InputError(
            "syntax", name, f"not UTF-8 text ({error.reason})", "encode it as UTF-8"
        ) from None


def refuse_other_encoding(data: bytes, name: str) -> None:
    """Refuse text that another program saved as UTF-16 or UTF-32.

    Raises:
        InputError: The content is such a text.
    """
    if (found := _other_encoding(data)) is not None:
        raise InputError(
            "syntax",
            name,
            f"it is {found} text, not UTF-8",
            "save it as UTF-8, in PowerShell with Out-File -Encoding utf8 instead of >",
        )


def _other_encoding(data: bytes) -> str | None:
    """The encoding of a text that begins with a byte order mark or with an ASCII character."""
    if data.startswith((b"\xff\xfe\0\0", b"\0\0\xfe\xff")) or data[:4].count(0) == 3:
        return "UTF-32"
    # No text in UTF-8 has a NUL, and no MessagePack of a system begins with ASCII.
    begins = sorted(data[:2])
    is_marked = data.startswith((b"\xff\xfe", b"\xfe\xff"))
    if is_marked or (len(begins) == 2 and begins[0] == 0 < begins[1] < 0x80):
        return "UTF-16"
    return None


@contextmanager
def at_file(path: str | os.PathLike[str]) -> Iterator[None]:
    """Let an error of the system name this file: that of a full disk names none."""
    try:
        yield
    except OSError as error:
        error.filename = os.fspath(path)
        error.filename2 = None
        if error.errno is not None:
            # Libraries write sentences of their own here.
            error.strerror = os.strerror(error.errno)
        raise


def write_whole(path: str | os.PathLike[str], content: str | bytes) -> None:
    """Write a file in one step: it is complete, or what was there before.

    The content is written into another file of the folder, which is then moved. A device, a pipe,
    or a file in a folder that cannot be changed is written in place.

    Args:
        path: The file. Its permissions stay as they are.
        content: Bytes, or text that is written as UTF-8.

    Raises:
        OSError: It cannot be written; ``filename`` is the path.
    """
    data = content if isinstance(content, bytes) else content.encode()
    with at_file(path):
        # A link stays a link.
        target = Path(os.path.realpath(path))
        try:
            mode = target.stat().st_mode
        except FileNotFoundError:
            mode = None
        if mode is not None and not stat.S_ISREG(mode):
            target.write_bytes(data)
            return
        try:
            _replace(target, data, mode)
        except OSError as error:
            if mode is None or error.errno not in _FIXED:
                raise
            target.write_bytes(data)


def _replace(target: Path, data: bytes, mode: int | None) -> None:
    # The name is short, because that of the target may be as long as the system allows.
    unfinished = target.with_name(f".carom-{secrets.token_hex(8)}.tmp")
    try:
        unfinished.write_bytes(data)
        if mode is not None:
            unfinished.chmod(stat.S_IMODE(mode))
        unfinished.replace(target)
    finally:
        unfinished.unlink(missing_ok=True)
