"""matplotlib, kept from writing into the home directory and from reading more into names."""

from __future__ import annotations

import atexit
import os
import re
import shutil
import sys
import tempfile
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Control characters but for the end of a line, and what is no character.
_NOT_TO_BE_SHOWN = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\ufffe\uffff]")
_REPLACEMENT = "\N{REPLACEMENT CHARACTER}"


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


def as_written(figure: Figure) -> Figure:
    """The figure with all texts as they are written: a ball may be called ``$1``, or anything.

    matplotlib takes what stands between two dollars for mathematics, and writes characters into
    an SVG that no XML may have.
    """
    from matplotlib.text import Text

    for artist in figure.findobj():
        gid = artist.get_gid()
        if gid is not None:
            artist.set_gid(_NOT_TO_BE_SHOWN.sub(_REPLACEMENT, gid))
        if isinstance(artist, Text):
            artist.set_parse_math(False)
            artist.set_text(_NOT_TO_BE_SHOWN.sub(_REPLACEMENT, artist.get_text()))
    return figure
