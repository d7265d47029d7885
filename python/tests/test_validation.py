"""The validation: a wrong row fails, kinds are counted apart, and the page prints the counts."""

from __future__ import annotations

import dataclasses
import io
import math
import re
import sys
from pathlib import Path
from typing import Any

import pytest
from carom.validation import Kind, Range, absolute, lab, papers, relative, report
from carom.validation.row import Row, check

ROOT = Path(__file__).parents[2]
FOLDERS = ROOT / "validation"

#: The rows that the validation must have.
REQUIRED = {
    *("CL1", "CL3", "CL5", "CL6", "CL7", "CL9", "CL10", "CL12", "CL14", "CL15", "CL17"),
    *("CU1", "CU2", "CU4", "CU6", "CU7", "CU8", "CU10"),
    *("BB1", "BB2", "BB3", "BB5", "BB7", "BB8", "BB10", "BB11", "BB13", "BB15", "BB18", "BB19"),
    *("BB20", "BB22", "BB23", "BB25", "BB27", "BB28"),
    *("CU-1", "CU-2", "CU-3", "CU-6", "CU-7", "CU-8", "CU-9", "CU-11", "CU-13", "CU-14"),
    *("CU-16", "CU-19", "SY1", "SY2", "SY3", "SY5"),
    *("BB27-surfaces", "DS-corner", "DS-plus", "BR-eight", "BR-8", "BR-nine", "RR4", "RR5"),
    *("HAN-default",),
    *("SL1", "SL3", "SL4", "SL7", "SL8", "SL10", "SL11", "SL12", "BB29", "CU3", "PO1", "PO3"),
}

EXAMPLE = Row(
    id="X1",
    title="an example",
    unit="m",
    source="an example",
    kind=Kind.PUBLISHED,
    reference={"a": 2.0, "b": Range(1.0, 3.0)},
    tolerance=relative(0.01),
    compute=lambda: [2.01, 3.0],
)


def all_rows() -> list[Row]:
    return [row for paper in papers() for row in report.rows(paper)]


def kinds(*ids: str) -> set[Kind]:
    return {row.kind for row in all_rows() if row.id in ids}


def test_a_row_passes_when_every_number_is_within_its_tolerance() -> None:
    check(EXAMPLE)


@pytest.mark.parametrize("ours", [[2.03, 2.0], [2.0, 3.1], [math.nan, 2.0]])
def test_a_row_that_must_agree_fails_when_one_number_is_outside(ours: list[float]) -> None:
    with pytest.raises(AssertionError, match="X1"):
        check(dataclasses.replace(EXAMPLE, compute=lambda: ours))


@pytest.mark.parametrize(
    "shown",
    [
        dataclasses.replace(EXAMPLE, kind=Kind.MEASURED),
        dataclasses.replace(EXAMPLE, kind=Kind.UNKNOWN_RULE),
        dataclasses.replace(EXAMPLE, shown_only=True),
    ],
    ids=["a measurement", "an unknown rule", "shown only"],
)
def test_a_row_that_is_only_shown_misses_exactly_where_it_says_so(shown: Row) -> None:
    shown = dataclasses.replace(shown, compute=lambda: [5.0, 2.0])
    assert not shown.must_agree
    check(dataclasses.replace(shown, misses=("a",)))
    with pytest.raises(AssertionError):
        check(shown)
    with pytest.raises(AssertionError):
        check(dataclasses.replace(shown, misses=("a", "b")))


def test_a_tuple_of_tolerances_repeats_over_the_numbers() -> None:
    row = dataclasses.replace(
        EXAMPLE,
        reference={"a": 1.0, "b": 10.0, "c": 1.0},
        tolerance=(absolute(0.1), absolute(2.0)),
        compute=lambda: [1.05, 11.0, 1.2],
    )
    assert [c.agrees for c in row.compare()] == [True, True, False]


def test_a_row_with_the_wrong_number_of_numbers_is_an_error() -> None:
    with pytest.raises(ValueError, match="2 reference numbers, but 1 of ours"):
        dataclasses.replace(EXAMPLE, compute=lambda: [1.0]).compare()


def test_every_required_row_exists() -> None:
    assert {row.id for row in all_rows()} >= REQUIRED


def test_only_published_numbers_that_the_engine_computes_count_as_published() -> None:
    counted = {kind for kind in Kind if kind.is_published_and_computed}
    assert counted == {Kind.PUBLISHED, Kind.FORMULA}
    # The engine takes no part in these formulas, or was given what is read back.
    assert kinds("CU-9", "CU-14", "LG-1") == {Kind.FORMULA_ONLY}
    assert kinds("HAN-e", "HAN-mu", "SL7") == {Kind.READ_BACK}
    # These are our own derivations, inequalities and stored results.
    assert kinds("CL6", "CL12", "CU-7", "CU-tip", "SL4", "LIP-roll") == {Kind.DERIVED}
    assert kinds("SY2", "PO-speed", "PO-angle", "PO-rail") == {Kind.RANGE}
    assert kinds("LG-4", "LG-5", "LG-6") == {Kind.STORED}


def test_formulas_that_the_engine_does_not_compute_are_counted_apart() -> None:
    tally = report.declared(["alciatore_tp_rail"])
    must_agree = {kind: count.numbers for (held, kind), count in tally.items() if held}
    assert must_agree == {Kind.FORMULA: 3, Kind.FORMULA_ONLY: 6, Kind.FITTED: 18}


def test_a_row_given_as_a_range_is_not_counted_as_a_published_number() -> None:
    for row in all_rows():
        if row.kind.is_published_and_computed:
            assert not any(isinstance(value, Range) for value in row.reference.values()), row


def simulated_by(row: Row, monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    """The shots that a row simulates, as shot files."""
    shots: list[dict[str, Any]] = []

    def recorded(trace: Any) -> lab.Run:
        shots.append(trace.shot.to_dict())
        return lab_run(trace)

    lab_run = lab.Run
    monkeypatch.setattr(lab, "Run", recorded)
    # Another row may have simulated the shots of this one already.
    for function in vars(sys.modules[row.compute.__module__]).values():
        if hasattr(function, "cache_clear"):
            function.cache_clear()
    row.compute()
    return shots


@pytest.mark.parametrize("row", [row for row in all_rows() if row.uses_preset], ids=str)
def test_a_row_that_counts_for_the_presets_simulates_them_unmodified(
    row: Row, monkeypatch: pytest.MonkeyPatch
) -> None:
    shots = simulated_by(row, monkeypatch)
    assert shots, "the row simulates nothing"
    for shot in shots:
        # An object is a preset with changes; a name, or nothing, is a preset as it is.
        assert not isinstance(shot.get("physics"), dict)
        assert not any({"mass", "radius"} & ball.keys() for ball in shot["balls"])
        assert "strike" in shot, "a ball that moves from the start does not test the cue"


def test_the_share_of_the_presets_is_computed_from_the_marks() -> None:
    marked = dataclasses.replace(EXAMPLE, uses_preset=True)
    fitted = dataclasses.replace(EXAMPLE, kind=Kind.FITTED, held=True, uses_preset=True)
    measured = dataclasses.replace(EXAMPLE, kind=Kind.MEASURED, uses_preset=True)
    derived = dataclasses.replace(EXAMPLE, kind=Kind.DERIVED, uses_preset=True)
    line = "{} of the {} numbers from a source that must agree are computed with an unmodified"

    def printed(*rows: Row) -> str:
        tally: report.Tally = {}
        for row in rows:
            report.add(tally, row, 0)
        return report.summary(tally)

    # Our own rules, fitted numbers and measurements that are only shown do not count.
    assert line.format(0, 2) in printed(EXAMPLE, fitted, measured, derived)
    assert line.format(2, 4) in printed(EXAMPLE, marked, fitted)
    held = dataclasses.replace(measured, held=True)
    assert line.format(4, 6) in printed(EXAMPLE, marked, held)


def test_a_measured_row_that_is_held_must_agree() -> None:
    held = dataclasses.replace(EXAMPLE, kind=Kind.MEASURED, held=True)
    check(held)
    with pytest.raises(AssertionError):
        check(dataclasses.replace(held, compute=lambda: [5.0, 2.0]))


def test_a_row_that_reads_a_stored_file_says_so() -> None:
    for path in FOLDERS.glob("*/rows.py"):
        declarations = path.read_text(encoding="utf-8").split("@row(")[1:]
        for block in (declaration.split("\n\n\n")[0] for declaration in declarations):
            if re.search(r"\b(impossible|counted|finders|stored)\(", block):
                assert "Kind.STORED" in block, f"{path}: {block.splitlines()[1]}"


@pytest.mark.parametrize("paper", papers())
def test_a_paper_has_rows_a_test_a_figure_and_a_page_that_names_every_row(paper: str) -> None:
    folder = FOLDERS / paper
    assert (folder / f"test_{paper}.py").exists()
    assert (folder / "figure.png").stat().st_size > 0
    readme = (folder / "README.md").read_text()
    assert "figure.png" in readme
    for row in report.rows(paper):
        assert row.id in readme, f"{paper}/README.md does not name {row.id}"


def test_the_report_prints_reference_ours_difference_tolerance_and_kind() -> None:
    out = io.StringIO()
    assert report.run("kim_2024", out) == 0
    text = out.getvalue()
    for word in ("BB18", "0.3036", "pass", "± 0.0001", Kind.FORMULA.value):
        assert word in text
    assert "7 numbers are published and computed by the engine" in text
    assert "7 numbers must agree, 0 failed" in text


def test_the_report_counts_each_kind_apart() -> None:
    out = io.StringIO()
    assert report.run("alciatore_tp_rail", out) == 0
    text = out.getvalue()
    assert f"     3  {Kind.FORMULA.value}" in text
    assert f"     6  {Kind.FORMULA_ONLY.value}" in text
    assert "3 numbers are published and computed by the engine" in text
    # The measured banks of three tables.
    assert f"    18  {Kind.FITTED.value}\n" in text


def test_the_report_counts_the_numbers_that_the_presets_are_known_to_miss() -> None:
    out = io.StringIO()
    assert report.run("three_cushion_tracks", out) == 0
    # One of three decelerations, and two of five returns.
    assert f"     8  {Kind.FITTED.value} (3 outside the tolerance)" in out.getvalue()


def test_the_report_returns_one_when_a_number_that_must_agree_is_off(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    broken = dataclasses.replace(EXAMPLE, compute=lambda: [9.0, 9.0])
    monkeypatch.setattr(report, "rows", lambda _: [broken])
    out = io.StringIO()
    assert report.run("kim_2024", out) == 1
    assert "FAIL" in out.getvalue()


def test_an_unknown_paper_is_refused_with_the_names_that_exist() -> None:
    with pytest.raises(ValueError, match="mathavan_2010"):
        report.run("mathavan", io.StringIO())


def test_the_documentation_shows_the_counts_that_the_command_prints() -> None:
    page = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    printed = report.summary(report.declared(papers()))
    assert printed in page, "run: python scripts/validation_gallery.py --counts"
