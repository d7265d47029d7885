"""A finished figure as SVG or PNG; the same bytes for the same figure."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from matplotlib import rc_context
from matplotlib.figure import Figure
from matplotlib.text import Text

from carom.arguments import whole
from carom.picture import fonts
from carom.picture.style import own_style

DOTS_PER_INCH = 150
# Largest resolution: a picture of a few inches then has a few hundred megabytes in memory.
MOST_DOTS_PER_INCH = 1200
# Control characters other than the newline, and code points that are not characters.
_NOT_TO_BE_SHOWN = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\ufffe\uffff]")
_REPLACEMENT = "\N{REPLACEMENT CHARACTER}"


def as_written(figure: Figure) -> Figure:
    """The figure with all texts drawn literally, because a ball may have any name, such as ``$1``.

    By default Matplotlib typesets text between two dollar signs as mathematics, and writes
    characters into an SVG that XML does not allow.
    """
    for artist in figure.findobj():
        gid = artist.get_gid()
        if gid is not None:
            artist.set_gid(_NOT_TO_BE_SHOWN.sub(_REPLACEMENT, gid))
        if isinstance(artist, Text):
            artist.set_parse_math(False)
            artist.set_text(_NOT_TO_BE_SHOWN.sub(_REPLACEMENT, artist.get_text()))
    fonts.cover(figure.findobj(Text))
    return figure


@own_style()
def to_svg(figure: Figure) -> str:
    """A figure as SVG text; the same text for the same figure."""
    out = io.StringIO()
    # By default Matplotlib writes a random salt and the date, so every file would differ.
    with rc_context({"svg.hashsalt": "carom", "svg.fonttype": "path"}), _any_glyph():
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    return out.getvalue()


@own_style()
def to_png(figure: Figure, *, dots_per_inch: int = DOTS_PER_INCH) -> bytes:
    """A figure as the content of a PNG file.

    Raises:
        InputError: The resolution is out of range.
    """
    dots = whole("dots_per_inch", dots_per_inch, MOST_DOTS_PER_INCH + 1, low=1)
    out = io.BytesIO()
    with _any_glyph():
        figure.savefig(out, format="png", dpi=dots, metadata={"Software": None})
    return out.getvalue()


@contextmanager
def _any_glyph() -> Iterator[None]:
    """Draw a box for a letter that no font has, without a second warning."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        yield
