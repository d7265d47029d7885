"""Published numbers, and ours beside them.

One folder per paper: `rows.py` holds its numbers and how the engine is asked for them, `figure.py`
draws them, `README.md` says what the paper says, `test_<paper>.py` holds the engine to it.

    carom validate                # every paper
    carom validate mathavan_2010  # one

The folders stand at `validation/` in the repository; the installed package has them as
`carom.validation`.
"""

from carom.validation.report import papers, run
from carom.validation.row import Comparison, Kind, Range, Row, absolute, relative

__all__ = ["Comparison", "Kind", "Range", "Row", "absolute", "papers", "relative", "run"]
