"""The documentation's tables are those of the stored results, and the pages name the commits."""

from __future__ import annotations

import importlib.util
import json
import re
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]


def load_tables() -> ModuleType:
    path = ROOT / "benches" / "tables.py"
    spec = importlib.util.spec_from_file_location("tables", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    # benches/ import each other by name.
    sys.path.insert(0, str(path.parent))
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path.pop(0)
    return module


tables: Any = load_tables()
#: The pages with tables, by name.
PAGES = {page.relative_to(ROOT).as_posix(): page for page in tables.PAGES}


@pytest.mark.parametrize("name", PAGES)
def test_a_page_has_the_tables_of_the_stored_results(name: str) -> None:
    page = PAGES[name].read_text(encoding="utf-8")
    assert tables.PLACE.search(page)
    assert tables.filled(page) == page, "run: python benches/tables.py --write"


@pytest.mark.parametrize("name", PAGES)
def test_a_page_names_the_commit_of_each_stored_result(name: str) -> None:
    page = PAGES[name].read_text(encoding="utf-8")
    for file in set(re.findall(r"<!-- table: \S+ (\S+) -->", page)):
        stored = json.loads(tables.path_of(file).read_text(encoding="utf-8"))
        assert stored["commit"].rstrip("+") in page, f"{PAGES[name]}: {file} has another commit"


def test_every_stored_result_names_its_commit() -> None:
    for path in (ROOT / "benches" / "results").glob("*.json"):
        stored = json.loads(path.read_text(encoding="utf-8"))
        # A file of several cases that were measured one by one has a commit in each.
        for result in [stored] if "commit" in stored else stored.values():
            assert re.fullmatch(r"[0-9a-f]{7,40}\+?", str(result.get("commit"))), path.name


def test_a_wrong_number_in_a_page_is_found() -> None:
    page = PAGES["docs/benchmarks.md"].read_text(encoding="utf-8")
    place = tables.PLACE.search(page)
    first_number = re.search(r"\d+", place[3])
    assert first_number is not None
    at = place.start(3) + first_number.start()
    changed = page[:at] + "9" + page[at:]
    assert tables.filled(changed) != changed
    assert tables.filled(changed) == page
