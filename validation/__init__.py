"""Reference numbers from the literature beside carom's.

Each paper has a folder. Its `rows.py` has the numbers and the functions that compute carom's own,
`figure.py` draws both, `README.md` describes the paper, and `test_<paper>.py` checks the rows.

    carom validate                # every paper
    carom validate mathavan_2010  # one

In the repository the folders are in `validation/`; the installed package has them as
`carom.validation`.
"""

from carom.validation.report import papers, run
from carom.validation.row import Comparison, Kind, Range, Row, absolute, relative

__all__ = ["Comparison", "Kind", "Range", "Row", "absolute", "papers", "relative", "run"]
