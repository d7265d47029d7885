"""Fonts for letters that Matplotlib's own font lacks, such as Chinese ones.

Matplotlib brings DejaVu Sans, which has no letters of East Asia. Those are drawn in a font that is
installed on the computer.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from functools import cache

from matplotlib import font_manager
from matplotlib.ft2font import FT2Font
from matplotlib.text import Text

# Families that have the letters of East Asia, in the order in which they are tried before all
# others: of Linux, Windows and macOS.
FAMILIES = (
    *("Noto Sans CJK SC", "Noto Sans SC", "Source Han Sans SC", "Source Han Sans CN"),
    *("WenQuanYi Micro Hei", "WenQuanYi Zen Hei", "Droid Sans Fallback"),
    *("Microsoft YaHei", "DengXian", "SimHei", "PingFang SC", "Heiti SC", "Hiragino Sans GB"),
    *("Arial Unicode MS",),
)
# Matplotlib's own, which has a box for every letter.
LAST_RESORT = "Last Resort"
# Letters that a warning names at most.
NAMED = 10


class FontWarning(UserWarning):
    """No installed font has a letter of a picture."""


def cover(texts: Iterable[Text]) -> None:
    """Draw letters that the font of a text lacks in an installed font that has them.

    Warns:
        FontWarning: No font has some of them; the picture has boxes in their places.
    """
    texts = list(texts)
    missing = {one for text in texts for one in text.get_text() if not one.isspace()}
    missing -= _letters(font_manager.findfont("DejaVu Sans"))
    families: list[str] = []
    for family, path in _candidates() if missing else ():
        found = missing & _letters(path)
        if found:
            families.append(family)
            missing -= found
        if not missing:
            break
    if families:
        for text in texts:
            text.set_fontfamily(["DejaVu Sans", *families])
    if missing:
        named = "".join(sorted(missing)[:NAMED]) + ("…" if len(missing) > NAMED else "")
        warnings.warn(
            f"no installed font has {named}; the picture has boxes in their places: install a font "
            "that has them, such as Noto Sans CJK (fonts-noto-cjk on Debian and Ubuntu)",
            FontWarning,
            stacklevel=2,
        )


def _candidates() -> list[tuple[str, str]]:
    """Family and file of every installed font, the known families first."""
    fonts = font_manager.fontManager.ttflist
    entries = {one.name: one.fname for one in fonts if not one.name.startswith(LAST_RESORT)}
    known = [family for family in FAMILIES if family in entries]
    return [(family, entries[family]) for family in [*known, *sorted(set(entries) - set(known))]]


@cache
def _letters(path: str) -> frozenset[str]:
    """The letters that a font has."""
    return frozenset(map(chr, FT2Font(path).get_charmap()))
