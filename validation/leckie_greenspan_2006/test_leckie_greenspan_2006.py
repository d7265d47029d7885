from importlib import resources

import pytest
from carom.validation.leckie_greenspan_2006 import rows, tables
from carom.validation.row import Row, check, rows_of

PAGE = (resources.files(rows.__package__) / "README.md").read_text()


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_a_row_is_as_declared(row: Row) -> None:
    check(row)


def test_the_stored_shots_of_the_engines_finder_have_no_impossible_result() -> None:
    ours = [f for f in rows.finders() if f["method"] == "carom"]
    assert [(f["family"], f["shots"]) for f in ours] == [("ordinary", 100_000), ("frozen", 10_000)]
    for found in ours:
        assert set(found["impossible"].values()) == {0}


def test_every_finder_of_the_paper_was_run_on_100_000_shots() -> None:
    played = {
        f["method"]: f["shots"]
        for f in rows.finders()
        if f["family"] == "ordinary" and f["reading"] == "at which they approach"
    }
    assert played.keys() == {"textbook closed form", "companion matrix", "Algorithm 1010"}
    assert set(played.values()) == {100_000}


def test_a_narrower_limit_finds_at_least_as_many_impossible_shots() -> None:
    for found in rows.finders():
        wide, middle, narrow = (
            found["impossible"][name] for name in ("millimetre", "micrometre", "promised")
        )
        assert wide <= middle <= narrow <= found["shots"]
        assert sum(found[kind] for kind in ("overlap", "apart", "endless", "other")) == middle


def test_the_stored_operations_follow_the_formulas_of_section_3() -> None:
    for counts in rows.counted().values():
        paper = 28 * counts["moving"] + 19 * counts["pairs"]
        assert counts["operations"]["the paper's events"] == paper
        assert counts["solved"] <= counts["looked_at"]
        assert counts["operations"]["carom"] < paper < counts["operations"]["by steps of 1 ms"]


@pytest.mark.parametrize(
    "table",
    [tables.finder_table("ordinary"), tables.finder_table("frozen"), tables.operation_table()],
    ids=["ordinary shots", "frozen balls", "operations"],
)
def test_the_readme_has_the_tables_of_the_stored_results(table: str) -> None:
    assert table in PAGE


@pytest.mark.parametrize("name", ["operations.json", "root_finders.json"])
def test_the_readme_names_the_commit_and_date_of_a_stored_result(name: str) -> None:
    page = " ".join(PAGE.split())
    assert f"`{name}` is from {tables.made(name)}" in page
