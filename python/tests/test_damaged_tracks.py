"""Damaged files of tracks: each is refused or repaired, with a sentence that names the fault."""

from __future__ import annotations

import gzip
from collections.abc import Callable
from pathlib import Path

import carom
import pytest
from carom import InputError, learn

Lines = list[list[str]]
PLACES = {"first": 0.0, "early": 0.2, "middle": 0.5, "late": 0.8, "last": 1.0}


@pytest.fixture(scope="module")
def rows() -> Lines:
    """The cells of a good file: shot, ball, t, x, y."""
    balls = {"1": (0.5, 0.6), "2": (0.9, 1.3), "3": (1.1, 2.2)}
    shot = carom.Shot("carom-10ft", balls, carom.Strike(4.0, 1.2, ball="1"))
    tracks = learn.synthetic([shot, shot], least_move=0.02).tracks
    return [
        [one.name, ball, f"{t:.4f}", f"{x:.5f}", f"{y:.5f}"]
        for one in tracks
        for ball, track in one.balls.items()
        for t, (x, y) in zip(track.time, track.position, strict=True)
    ]


def cell(column: int, value: str) -> Callable[[Lines, int], None]:
    def damage(rows: Lines, at: int) -> None:
        rows[at][column] = value

    return damage


def twice(rows: Lines, at: int) -> None:
    rows.insert(at, list(rows[at]))


def two_places(rows: Lines, at: int) -> None:
    rows.insert(at, [*rows[at][:3], "0.7", "0.7"])


def short_row(rows: Lines, at: int) -> None:
    rows[at].pop()


def long_row(rows: Lines, at: int) -> None:
    rows[at].append("9")


# Damage to one row, and the kinds of findings that may report it.
OF_A_ROW: dict[str, tuple[Callable[[Lines, int], None], set[str]]] = {
    "a NaN for x": (cell(3, "nan"), {"no-place"}),
    "no y": (cell(4, ""), {"no-place"}),
    "null for x": (cell(3, "null"), {"no-place"}),
    "a text for x": (cell(3, "here"), {"bad-number"}),
    "two points in y": (cell(4, "1.2.3"), {"bad-number"}),
    "an underscore in x": (cell(3, "1_0"), {"bad-number"}),
    "an infinite x": (cell(3, "inf"), {"huge"}),
    "a huge y": (cell(4, "1e300"), {"huge"}),
    "a place in the hall": (cell(3, "7.5"), {"outside-table"}),
    "a place beyond the rails": (cell(4, "-0.9"), {"outside-table"}),
    "no time": (cell(2, ""), {"bad-time"}),
    "a NaN for the time": (cell(2, "nan"), {"bad-time"}),
    "an infinite time": (cell(2, "inf"), {"bad-time"}),
    "a text for the time": (cell(2, "12:30"), {"bad-time"}),
    "no ball": (cell(1, ""), {"no-name"}),
    "no shot": (cell(0, ""), {"no-name"}),
    "the same row twice": (twice, {"duplicate-row"}),
    "two places at one time": (two_places, {"two-places"}),
    "a cell too few": (short_row, {"wrong-count"}),
    "a cell too many": (long_row, {"wrong-count"}),
}


def text_of(rows: Lines, delimiter: str = ",") -> str:
    return "".join(delimiter.join(row) + "\n" for row in [["shot", "ball", "t", "x", "y"], *rows])


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("damage", OF_A_ROW)
def test_a_damaged_row_is_repaired_with_a_sentence(
    damage: str, place: str, rows: Lines, tmp_path: Path
) -> None:
    broken = [list(row) for row in rows]
    at = round(PLACES[place] * (len(rows) - 1))
    change, kinds = OF_A_ROW[damage]
    change(broken, at)
    path = tmp_path / "tracks.csv"
    path.write_text(text_of(broken), encoding="utf-8")
    found = learn.read_tracks(path, table="carom-10ft").findings
    told = [finding for finding in found if finding.kind in kinds]
    assert len(told) == 1
    assert told[0].count == 1
    line = at + (3 if "twice" in damage or "one time" in damage else 2)
    assert f"line {line}" in told[0].place or f"line {line - 1}" in told[0].place
    assert told[0].fault
    assert told[0].remedy


def changed(factor: float, columns: tuple[int, ...], shift: float = 0.0) -> Callable[[Lines], str]:
    def damage(rows: Lines) -> str:
        made = [list(row) for row in rows]
        for row in made:
            for column in columns:
                row[column] = f"{float(row[column]) * factor + shift:.6g}"
        return text_of(made)

    return damage


def swapped(rows: Lines) -> str:
    return text_of([[*row[:3], row[4], row[3]] for row in rows])


OF_A_FILE: dict[str, tuple[Callable[[Lines], str | bytes], str]] = {
    "millimetres": (changed(1000.0, (3, 4)), "unit=mm"),
    "centimetres": (changed(100.0, (3, 4)), "unit=cm"),
    "inches": (changed(1 / 0.0254, (3, 4)), "unit=in"),
    "x and y exchanged": (swapped, "x=length"),
    "milliseconds": (changed(1000.0, (2,)), "time unit ms"),
    "microseconds": (changed(1e6, (2,)), "time unit us"),
    "an empty file": (lambda rows: "", "empty"),
    "no rows": (lambda rows: text_of([]), "no samples"),
    "no names": (lambda rows: text_of(rows).split("\n", 1)[1], "names of the columns"),
    "a column less": (lambda rows: text_of(rows).replace("y\n", "z\n", 1), "no column for y"),
    "a name twice": (lambda rows: text_of(rows).replace("y\n", "x\n", 1), "two columns"),
    "decimal commas": (lambda rows: text_of(rows).replace(".", ","), "decimal commas"),
    "blanks between columns": (lambda rows: text_of(rows, " "), "no comma"),
    "UTF-16": (lambda rows: text_of(rows).encode("utf-16"), "UTF-16"),
    "a NUL": (lambda rows: text_of(rows).replace("0.5", "0\0005", 1), "NUL"),
    "Latin-1": (lambda rows: text_of(rows).encode() + b"\xfc\n", "UTF-8"),
    "cut gzip data": (lambda rows: gzip.compress(text_of(rows).encode())[:-900], "end early"),
    "one name for all balls": (
        lambda rows: text_of([[row[0], "1", *row[2:]] for row in rows]),
        "own name|time starts again",
    ),
    "one name for all shots": (
        lambda rows: text_of([["1", *row[1:]] for row in rows]),
        "own name|time starts again",
    ),
}


@pytest.mark.parametrize("damage", OF_A_FILE)
def test_a_damaged_file_is_refused_with_its_remedy(
    damage: str, rows: Lines, tmp_path: Path
) -> None:
    change, words = OF_A_FILE[damage]
    content = change(rows)
    path = tmp_path / "tracks.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(InputError, match=words) as error:
        learn.read_tracks(path, table="carom-10ft")
    assert error.value.remedy
