"""Tables of text keep their columns with names of any script."""

from __future__ import annotations

import re
from typing import Any

import carom
import pytest
from carom import Shot, columns
from carom.event_table import printable
from rich.cells import cell_len

# Chinese, Korean, a family of emoji in one character, a letter with a combining accent, a flag.
NAMES = ["白球", "공", "👨\u200d👩\u200d👧", "e\u0301", "🇨🇳", "９"]


def starts(lines: list[str], text: str) -> set[int]:
    """The cells at which a text begins, in the lines that have it."""
    return {cell_len(line[: line.index(text)]) for line in lines if text in line}


@pytest.mark.parametrize("name", NAMES)
def test_wide_characters_keep_the_columns_of_events(name: str) -> None:
    balls: Any = {"cue": (0.5, 1.2), name: (0.9, 1.9)}
    shot = Shot("wpa-9ft", balls, carom.Strike(2.0, 1.05))
    lines = str(shot.simulate()).splitlines()
    where = starts(lines[:1], "where")
    changes = [line for line in lines if "sliding→rolling" in line]
    assert any(printable(name) in line for line in changes)
    assert any("cue" in line for line in changes)
    assert starts(changes, "sliding→rolling") == where


@pytest.mark.parametrize("name", NAMES)
def test_wide_characters_keep_the_columns_of_chances(name: str) -> None:
    balls: Any = {"cue": (0.5, 1.2), name: (0.9, 1.9)}
    shot = Shot("wpa-9ft", balls, carom.Strike(2.0, 1.05))
    text = str(shot.evaluate(carom.Noise.preset("club"), 200))
    values = [re.split("   *", line.strip())[1] for line in text.splitlines()[1:]]
    places = [
        starts([line], value) for line, value in zip(text.splitlines()[1:], values, strict=True)
    ]
    assert len(values) > 3
    assert all(place == places[0] for place in places), text


def test_wide_characters_keep_the_columns_of_plays() -> None:
    rows = [("1", "白球", "90 %"), ("10", "cue", "5 %")]
    assert columns.lines(rows, right_aligned={0, 2}) == [" 1  白球  90 %", "10  cue    5 %"]


@pytest.mark.parametrize(
    ("text", "cells"),
    [
        ("", 0),
        ("cue", 3),
        ("½ é →", 5),
        ("白球", 4),
        ("e\u0301", 1),
        ("👨\u200d👩\u200d👧", 2),
        ("❤\ufe0f", 2),
    ],
)
def test_a_text_has_as_many_cells_as_a_terminal_shows(text: str, cells: int) -> None:
    assert columns.cells(text) == cells
    assert columns.left(text, 6) == text + " " * (6 - cells)
    assert columns.right(text, 6) == " " * (6 - cells) + text
