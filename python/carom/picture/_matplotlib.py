"""Matplotlib, prevented from writing to the home directory."""

from __future__ import annotations

import atexit
import os
import shutil
import sys
import tempfile


def prepare() -> None:
    """Import Matplotlib with its cache in a temporary directory, deleted when the process ends.

    By default Matplotlib writes a cache to the user's home when it is first imported. A program
    that has imported it already, or has set ``MPLCONFIGDIR``, keeps its own directory.
    """
    if "matplotlib" in sys.modules or "MPLCONFIGDIR" in os.environ:
        return
    directory = tempfile.mkdtemp(prefix="carom-")
    atexit.register(shutil.rmtree, directory, ignore_errors=True)
    os.environ["MPLCONFIGDIR"] = directory
    try:
        import matplotlib

        # Matplotlib remembers the directory from now on; child processes must not inherit it.
        matplotlib.get_configdir()
        matplotlib.get_cachedir()
    finally:
        del os.environ["MPLCONFIGDIR"]


prepare()
