"""The validation's own machinery: a row that is off fails, every paper is complete."""

from __future__ import annotations

import dataclasses
import io
import math
from pathlib import Path

import pytest
from carom.validation import Range, absolute, papers, relative, report
from carom.validation.row import Row, check

FOLDERS = Path(__file__).parents[2] / "validation"

#: The published rows that concern what the engine does.
PUBLISHED = {
    *("CL1", "CL3", "CL5", "CL6", "CL7", "CL9", "CL10", "CL12", "CL14", "CL15", "CL17"),
    *("CU1", "CU2", "CU4", "CU6", "CU7", "CU8", "CU10"),
    *("BB1", "BB2", "BB3", "BB5", "BB7", "BB8", "BB10", "BB11", "BB13", "BB15", "BB18"),
    *("BB20", "BB22", "BB23", "BB25", "BB27", "BB28"),
    *("CU-1", "CU-2", "CU-3", "CU-6", "CU-7", "CU-8", "CU-9", "CU-11", "CU-13", "CU-14"),
    *("CU-16", "CU-19", "SY1", "SY2", "SY3", "SY5"),
    *("SL1", "SL3", "SL4", "SL7", "PO1", "PO3"),
}

EXAMPLE = Row(
    id="X1",
    title="an example",
    unit="m",
    source="nobody",
    status="R",
    published={"a": 2.0, "b": Range(1.0, 3.0)},
    tolerance=relative(0.01),
    compute=lambda: [2.01, 3.0],
)


def test_a_row_passes_when_every_number_is_within_its_tolerance() -> None:
    check(EXAMPLE)


@pytest.mark.parametrize("ours", [[2.03, 2.0], [2.0, 3.1], [math.nan, 2.0]])
def test_a_held_row_fails_when_one_number_is_outside(ours: list[float]) -> None:
    with pytest.raises(AssertionError, match="X1"):
        check(dataclasses.replace(EXAMPLE, compute=lambda: ours))


def test_a_measurement_must_miss_exactly_where_it_says_so() -> None:
    shown = dataclasses.replace(EXAMPLE, status="M", compute=lambda: [5.0, 2.0])
    check(dataclasses.replace(shown, misses=("a",)))
    with pytest.raises(AssertionError):
        check(shown)
    with pytest.raises(AssertionError):
        check(dataclasses.replace(shown, misses=("a", "b")))


def test_a_tuple_of_tolerances_repeats_over_the_numbers() -> None:
    row = dataclasses.replace(
        EXAMPLE,
        published={"a": 1.0, "b": 10.0, "c": 1.0},
        tolerance=(absolute(0.1), absolute(2.0)),
        compute=lambda: [1.05, 11.0, 1.2],
    )
    assert [c.agrees for c in row.compare()] == [True, True, False]


def test_a_row_with_the_wrong_number_of_numbers_is_an_error() -> None:
    with pytest.raises(ValueError, match="2 published numbers, 1 of ours"):
        dataclasses.replace(EXAMPLE, compute=lambda: [1.0]).compare()


def test_every_published_row_is_there() -> None:
    assert {row.id for paper in papers() for row in report.rows(paper)} >= PUBLISHED


def test_a_row_whose_rule_is_unknown_is_shown_as_a_measurement_is() -> None:
    shown = dataclasses.replace(EXAMPLE, rule_unknown=True, compute=lambda: [5.0, 2.0])
    assert not shown.held
    check(dataclasses.replace(shown, misses=("a",)))
    with pytest.raises(AssertionError):
        check(shown)


@pytest.mark.parametrize("paper", papers())
def test_a_paper_has_rows_a_test_a_figure_and_a_page_that_names_every_row(paper: str) -> None:
    folder = FOLDERS / paper
    assert (folder / f"test_{paper}.py").exists()
    assert (folder / "figure.png").stat().st_size > 0
    readme = (folder / "README.md").read_text()
    assert "figure.png" in readme
    for row in report.rows(paper):
        assert row.id in readme, f"{paper}/README.md does not name {row.id}"


def test_the_report_prints_published_ours_difference_and_tolerance() -> None:
    out = io.StringIO()
    assert report.run("kim_2024", out) == 0
    text = out.getvalue()
    for word in ("BB18", "0.3036", "pass", "± 0.0001", "7 numbers held, 0 failed"):
        assert word in text


def test_the_report_returns_one_when_a_held_number_is_off(monkeypatch: pytest.MonkeyPatch) -> None:
    broken = dataclasses.replace(EXAMPLE, compute=lambda: [9.0, 9.0])
    monkeypatch.setattr(report, "rows", lambda _: [broken])
    out = io.StringIO()
    assert report.run("kim_2024", out) == 1
    assert "FAIL" in out.getvalue()


def test_an_unknown_paper_is_refused_with_the_names_that_exist() -> None:
    with pytest.raises(ValueError, match="mathavan_2010"):
        report.run("mathavan", io.StringIO())
