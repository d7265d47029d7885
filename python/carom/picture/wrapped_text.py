"""Text below diagrams: its lines, and their height."""

from __future__ import annotations

import math
import re
import unicodedata

# Millimetres of a point.
POINT = 25.4 / 72.0
# Distance of two lines over the size of their letters.
LEADING = 1.25
# Width of an average letter over the size of the letters; those of East Asia are twice as wide.
LETTER = 0.52
# A letter of East Asia, or a word, each with the space behind it, or space.
WORD = re.compile(
    r"[\u2e80-\u9fff\uac00-\ud7af\uff00-\uffef]\s*"
    r"|[^\s\u2e80-\u9fff\uac00-\ud7af\uff00-\uffef]+\s*|\s+"
)


def leading(size: float) -> float:
    """The distance of two lines, mm."""
    return LEADING * size * POINT


def wrapped(text: str, wide: float, size: float) -> list[str]:
    """The lines of a text in letters of a size (points), at most about ``wide`` (mm) each."""
    most = wide / (LETTER * size * POINT)
    lines = []
    for paragraph in text.split("\n"):
        line, length = "", 0.0
        for word in WORD.findall(paragraph):
            own = _length(word)
            if line and length + _length(word.rstrip()) > most:
                lines.append(line.rstrip())
                line, length = "", 0.0
            line, length = line + word, length + own
        lines.append(line.rstrip())
    return lines


def _length(text: str) -> float:
    """Letters of a text, those of East Asia counted twice."""
    return sum(2.0 if unicodedata.east_asian_width(one) in "WF" else 1.0 for one in text)


def fitting(lines: list[str], room: float) -> list[str]:
    """The lines for which there is room; the last one says whether there are more."""
    most = max(1, math.floor(room))
    if len(lines) <= most:
        return lines
    return [*lines[: most - 1], f"{lines[most - 1]} …"]
