"""The settings of Matplotlib with which every picture is drawn and written."""

from __future__ import annotations

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
    with rc_context():
        with warnings.catch_warnings():
            # Of defaults that a version of Matplotlib is about to remove.
            warnings.simplefilter("ignore")
            # The backend is that of the user's own windows, which the context does not restore.
            rcParams.update({k: v for k, v in rcParamsDefault.items() if k != "backend"})
        yield
