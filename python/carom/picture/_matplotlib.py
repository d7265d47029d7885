"""Matplotlib, prevented from writing to the home directory."""

from __future__ import annotations

import atexit
import contextlib
import importlib
import os
import shutil
import sys
import tempfile

from carom.errors import InputError


def prepare() -> None:
    """Import Matplotlib with its cache in a temporary directory, deleted when the process ends.

    By default Matplotlib writes a cache to the user's home when it is first imported. A program
    that has imported it already, or has set ``MPLCONFIGDIR``, keeps its own directory.

    Raises:
        InputError: Matplotlib is not installed.
    """
    if sys.modules.get("matplotlib") is not None:
        return
    if "MPLCONFIGDIR" in os.environ:
        _import()
        return
    directory = tempfile.mkdtemp(prefix="carom-")
    atexit.register(shutil.rmtree, directory, ignore_errors=True)
    os.environ["MPLCONFIGDIR"] = directory
    try:
        _import()
        # Matplotlib remembers the directory from now on; child processes must not inherit it.
        matplotlib = sys.modules["matplotlib"]
        matplotlib.get_configdir()
        matplotlib.get_cachedir()
    finally:
        del os.environ["MPLCONFIGDIR"]


def _import() -> None:
    """Import Matplotlib, also where ``MPLBACKEND`` names no backend: pictures need none."""
    backend = os.environ.pop("MPLBACKEND", None)
    try:
        matplotlib = importlib.import_module("matplotlib")
    except ModuleNotFoundError as error:
        raise InputError(
            "unsupported",
            "",
            f"pictures need Matplotlib ({error})",
            "install it: pip install 'carom[picture]'",
        ) from None
    finally:
        if backend is not None:
            os.environ["MPLBACKEND"] = backend
    if backend:
        # As Matplotlib does when it is imported, but without an error.
        with contextlib.suppress(ValueError):
            matplotlib.rcParams["backend"] = backend


prepare()
