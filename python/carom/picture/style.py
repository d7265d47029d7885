"""The settings of Matplotlib with which every picture is drawn and written."""

from __future__ import annotations

import logging
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from matplotlib import rc_context, rcParams, rcParamsDefault


@contextmanager
def own_style() -> Iterator[None]:
    """Draw with Matplotlib's defaults instead of the user's ``matplotlibrc``; also a decorator.

    Pictures are the same for everybody: ``text.usetex``, ``savefig.bbox`` or ``path.sketch`` of the
    user would change them or make them fail.
    """
    # A font of East Asia may have no bold letters; Matplotlib then takes the others, and says so.
    fonts = logging.getLogger("matplotlib.font_manager")
    level = fonts.level
    fonts.setLevel(logging.ERROR)
    try:
        yield from _with_defaults()
    finally:
        fonts.setLevel(level)


def _with_defaults() -> Iterator[None]:
    with rc_context():
        with warnings.catch_warnings():
            # Of defaults that a version of Matplotlib is about to remove.
            warnings.simplefilter("ignore")
            # The backend is that of the user's own windows, which the context does not restore.
            rcParams.update({k: v for k, v in rcParamsDefault.items() if k != "backend"})
        yield
