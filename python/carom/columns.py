"""Columns of text that stay aligned: Chinese characters and emoji take two cells of a terminal."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Sequence


def cells(text: str) -> int:
    """The number of cells of a terminal that a line of text takes."""
    if all(map(_takes_one_cell, text)):
        return len(text)
    # Its tables take long to load, and few texts need them.
    from rich.cells import cell_len

    return cell_len(text)


def _takes_one_cell(character: str) -> bool:
    """Whether a character takes one cell, whatever its neighbours are."""
    # Letters with accents come before all combining characters.
    return character < "\u0300" or (
        unicodedata.east_asian_width(character) not in ("W", "F")
        and unicodedata.category(character) not in ("Mn", "Me", "Cf")
    )


def left(text: str, width: int) -> str:
    """The text with blanks behind it, ``width`` cells in all; a longer one is unchanged."""
    return text + " " * (width - cells(text))


def right(text: str, width: int) -> str:
    """The text with blanks before it, ``width`` cells in all; a longer one is unchanged."""
    return " " * (width - cells(text)) + text


def lines(rows: Sequence[Sequence[str]], *, right_aligned: Collection[int] = ()) -> list[str]:
    """Rows as lines with aligned columns.

    Args:
        rows: The texts of each row, as many as there are columns.
        right_aligned: The indices of the columns whose texts end at the same cell.
    """
    widths = [max(map(cells, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(
            (right if index in right_aligned else left)(text, width)
            for index, (text, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]
