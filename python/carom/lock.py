"""One run at a time writes to a folder.

The operating system locks a file in the folder for a run, and unlocks it when the run ends, also by
a kill. Some network drives have no such locks. There a file that names the machine and the process
of its run keeps other runs out; after a kill it is recognised on the same machine, where this
process no longer exists.
"""

from __future__ import annotations

import contextlib
import errno
import os
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from carom.errors import InputError

# Errors in a folder that cannot be written to, so that it needs no lock.
_READ_ONLY = {errno.EACCES, errno.EPERM, errno.EROFS}
# Attempts to lock a file that ending runs remove.
_ATTEMPTS = 100
# The byte that Windows locks; it need not exist.
_BYTE = 0


@contextmanager
def locked(folder: Path, what: str) -> Iterator[None]:
    """Keep other runs out of a folder.

    Args:
        folder: The folder.
        what: What runs there, such as "sweep"; the files of the lock begin with it.

    Raises:
        InputError: Another run has the folder.
        OSError: The folder does not exist or is full.
    """
    path, release = folder / f"{what}.lock", contextlib.ExitStack()
    with release:
        try:
            file = _open_locked(path)
            if file is None:
                path.unlink(missing_ok=True)
                path = path.with_suffix(".running")
                _claim(path)
        except OSError as error:
            if error.errno not in _READ_ONLY or path.exists():
                raise
        else:
            if file is not None:
                release.callback(os.close, file)
            # Before it is unlocked, so that no run locks a file that is then removed.
            release.callback(_remove, path)
        yield


def _remove(path: Path) -> None:
    # Windows removes no open file; an unlocked one does no harm.
    with contextlib.suppress(OSError):
        path.unlink()


def _refusal(folder: Path, more: str = "") -> InputError:
    return InputError(
        "busy",
        str(folder),
        "another run writes to it",
        f"wait until it ends, or choose another folder{more}",
    )


def _open_locked(path: Path) -> int | None:
    """The file of the lock, open and locked; None if the system has no locks.

    Raises:
        InputError: Another run has it.
    """
    for _ in range(_ATTEMPTS):
        file = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            lock(file)
        except BlockingIOError:
            os.close(file)
            break
        except OSError:
            os.close(file)
            return None
        with contextlib.suppress(FileNotFoundError):
            if os.path.samestat(os.fstat(file), path.stat()):
                return file
        # A run that has ended removed the file after it was opened here.
        os.close(file)
    raise _refusal(path.parent)


def lock(file: int) -> None:
    """Lock an open file until it is closed.

    Raises:
        BlockingIOError: Another run has locked it.
        OSError: The system has no locks.
    """
    if sys.platform == "win32":
        import msvcrt

        os.lseek(file, _BYTE, os.SEEK_SET)
        try:
            msvcrt.locking(file, msvcrt.LK_NBLCK, 1)
        except PermissionError:
            raise BlockingIOError from None
    else:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _claim(path: Path) -> None:
    """Make the file that keeps other runs out, or take over that of a killed run.

    Raises:
        InputError: Another run has made it.
    """
    owner = _owner(os.getpid())
    with contextlib.suppress(FileExistsError):
        _make(path, owner)
        return
    with contextlib.suppress(FileNotFoundError):
        found = path.read_text(encoding="utf-8", errors="replace")
        # Of several runs that find the file of a killed one, one can make this file.
        claim = path.with_name(f"{path.name}.claim")
        if _is_gone(found):
            with contextlib.suppress(FileExistsError):
                _make(claim, owner)
                try:
                    if path.read_text(encoding="utf-8", errors="replace") == found:
                        path.write_text(owner, encoding="utf-8")
                        return
                finally:
                    claim.unlink()
    raise _refusal(path.parent, f"; if that run was killed, delete {path}")


def _make(path: Path, text: str) -> None:
    with path.open("x", encoding="utf-8") as file:
        file.write(text)


def _owner(process: int) -> str:
    """Machine, number and start of a process; the system uses the numbers again."""
    try:
        # The fields after the name of the program, which may have blanks.
        fields = Path(f"/proc/{process}/stat").read_text(errors="replace").rpartition(")")[2]
        start = fields.split()[19]
    except (OSError, IndexError):
        start = "-"
    return f"{socket.gethostname()} {process} {start}"


def _is_gone(owner: str) -> bool:
    """Whether this was a process of this machine that has ended."""
    host, _, rest = owner.partition(" ")
    number = rest.partition(" ")[0]
    # On Windows a signal, even 0, would end the process.
    if host != socket.gethostname() or not number.isdecimal() or sys.platform == "win32":
        return False
    try:
        os.kill(int(number), 0)
    except ProcessLookupError:
        return True
    except (OSError, OverflowError):
        return False
    return _owner(int(number)) != owner
