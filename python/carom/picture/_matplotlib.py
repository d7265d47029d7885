"""matplotlib, kept from writing into the home directory."""

from __future__ import annotations

import atexit
import os
import shutil
import sys
import tempfile


def prepare() -> None:
    """Import matplotlib; its font list goes to a directory that ends with this process.

    matplotlib writes a cache into the user's home when it is first imported. Whoever has
    imported it already, or has set ``MPLCONFIGDIR``, keeps their own.
    """
    if "matplotlib" in sys.modules or "MPLCONFIGDIR" in os.environ:
        return
    directory = tempfile.mkdtemp(prefix="carom-")
    atexit.register(shutil.rmtree, directory, ignore_errors=True)
    os.environ["MPLCONFIGDIR"] = directory
    try:
        import matplotlib

        # The directory is read once and remembered; other processes must not inherit it.
        matplotlib.get_configdir()
        matplotlib.get_cachedir()
    finally:
        del os.environ["MPLCONFIGDIR"]
