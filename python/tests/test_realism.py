"""The page of measured tables: its data agree with the validation, and its numbers are computed."""

from __future__ import annotations

import importlib
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from carom.validation import papers, report
from carom.validation.row import Range

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "realism.md"
STORED: Any = json.loads(
    (ROOT / "benches" / "results" / "realism.json").read_text(encoding="utf-8")
)
MEASURED: Any = json.loads((ROOT / "validation" / "measured.json").read_text(encoding="utf-8"))
ROWS = {row.id: row for paper in papers() for row in report.rows(paper)}


@pytest.fixture(scope="module")
def figures() -> Iterator[Any]:
    """The module scripts/realism_figures.py, which imports modules beside it."""
    sys.path.insert(0, str(ROOT / "scripts"))
    try:
        yield importlib.import_module("realism_figures")
    finally:
        sys.path.pop(0)


def numbers(value: Any) -> list[float]:
    """All numbers in nested lists and dictionaries, in order."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for item in value for number in numbers(item)]
    return [value]


@pytest.mark.parametrize(
    ("key", "values"),
    [("throw_2014", "throw_deg"), ("throw_2006", "throw_deg"), ("banks", "start")],
)
def test_measured_numbers_are_those_of_the_validation(key: str, values: str) -> None:
    row = ROWS[MEASURED[key]["row"]]
    assert sorted(numbers(MEASURED[key][values])) == sorted(numbers(list(row.reference.values())))


def test_the_range_of_rolling_is_that_of_the_validation() -> None:
    rolling = ROWS[MEASURED["rolling_snooker"]["row"]].reference["rolling"]
    assert isinstance(rolling, Range)
    assert MEASURED["rolling_snooker"]["range"] == [rolling.low, rolling.high]


def test_the_surfaces_of_the_validation_are_measured_ones() -> None:
    surface = MEASURED["throw_surface"]
    rows = {**ROWS[surface["row"]].reference, **ROWS["BB27-surfaces"].reference}
    assert surface["throw_deg"] == rows


def test_every_measurement_has_a_source_a_unit_and_a_title() -> None:
    for key, data in MEASURED.items():
        for word in ("source", "unit", "title"):
            assert data[word], f"{key}: {word}"
        assert ("tolerance" in data) != ("range" in data), key


def test_every_measurement_is_used_by_an_item(figures: Any) -> None:
    assert {key for item in figures.ITEMS for key in item.data} == set(MEASURED)


def test_the_stored_numbers_are_those_that_the_engine_gives(figures: Any) -> None:
    # The rest is made by the same code; the hashes of the goldens tell whether it is older.
    for item in figures.ITEMS:
        if item.name in {"snooker-rolling", "carom-returns", "plus-system"}:
            fresh = figures.compared(item, None, figures.Choice("default", ""))
            stored = STORED["items"][item.name]
            assert [p["label"] for p in fresh["points"]] == [p["label"] for p in stored["points"]]
            for now, then in zip(fresh["points"], stored["points"], strict=True):
                assert now["after"] == pytest.approx(then["after"], abs=2e-6)


def test_another_physics_gives_other_numbers(figures: Any, tmp_path: Path) -> None:
    file = tmp_path / "sticky.json"
    file.write_text('{"ball_ball": {"friction": 0.2}}', encoding="utf-8")
    throw = figures.ITEMS[0]
    default, sticky = (throw.points(figures.Choice(c, "")) for c in ("default", str(file)))
    pairs = list(zip(default, sticky, strict=True))
    assert all(a.label == b.label and a.measured == b.measured for a, b in pairs)
    assert sum(b.ours > a.ours for a, b in pairs) > len(pairs) // 2


def test_a_choice_names_dated_presets_files_and_presets(figures: Any, tmp_path: Path) -> None:
    file = tmp_path / "old.json"
    file.write_text('{"gravity": 9.8}', encoding="utf-8")
    chosen = {text: figures.Choice(text, "").physics("pool") for text in
              ("default", "2026-11", str(file), "snooker")}  # fmt: skip
    assert list(chosen.values()) == [
        "pool", "pool-2026-11", {"base": "pool", "gravity": 9.8}, "snooker",
    ]  # fmt: skip


def test_a_preset_that_is_newer_than_a_date_has_the_physics_of_its_game(figures: Any) -> None:
    assert figures.Choice("2026-11", "").physics("pool-valley") == "pool-2026-11"
    assert figures.Choice("2026-12", "").physics("pool-valley") == "pool-valley-2026-12"


def test_a_range_agrees_up_to_its_ends(figures: Any) -> None:
    point = importlib.import_module("realism.item").Point
    assert point("x", 0.125, 0.001, 0.126).agrees
    assert not point("x", 0.125, 0.001, 0.1261).agrees
    assert not point("x", 0.125, 0.001, float("nan")).agrees


def test_the_page_shows_every_figure_and_every_item(figures: Any) -> None:
    page = PAGE.read_text(encoding="utf-8")
    shown = set(re.findall(r"images/realism_(\w+)\.png", page))
    assert shown == set(figures.FIGURES)
    assert all((ROOT / "docs" / "images" / f"realism_{name}.png").exists() for name in shown)
    tables = set(re.findall(r"<!-- table: realism-(\S+) realism.json -->", page))
    assert tables == {item.name for item in figures.ITEMS} | {"summary"}
