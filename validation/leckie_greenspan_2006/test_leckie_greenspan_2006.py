import pytest
from carom.validation.leckie_greenspan_2006 import rows
from carom.validation.row import Row, check, rows_of


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
        for limit, count in found["impossible"].items():
            assert sum(found["first_faults"][limit].values()) == count


def test_only_the_engines_own_finder_ran_with_the_proofs() -> None:
    assert {f["method"] for f in rows.finders() if f["proofs"]} == {"carom"}
    assert all(f["proofs"] for f in rows.finders() if f["method"] == "carom")


def test_the_second_order_term_makes_the_steps_more_accurate_in_every_stored_shot_set() -> None:
    result = rows.stored("fixed_step.json")
    assert len(result["shots"]) == result["wanted"] >= 20
    medians = {
        form: [rows.median_end_error(form, dt) for dt in result["steps"]]
        for form in ("v dt", "v dt + a dt^2 / 2")
    }
    for first, second in zip(*medians.values(), strict=True):
        assert second < first
    # The steps are stored from the longest to the shortest.
    assert medians["v dt"][-1] < 0.2 * medians["v dt"][0]


def test_every_kind_of_impact_and_search_has_a_count() -> None:
    kinds = rows.stored("operation_kinds.json")["kinds"]
    groups = {kind["group"].partition(":")[0] for kind in kinds}
    assert groups == {"search", "motion", "impact"}
    for kind in kinds:
        assert 0 <= kind["divisions"] + kind["square_roots"] <= kind["operations"], kind
        assert kind["operations"] > 0, kind
        assert kind["inputs"] > 0, kind
    named = {(kind["group"], kind["name"]): kind["operations"] for kind in kinds}
    pair = "search: two balls"
    assert named[pair, "carom-roots, mid-game"] < named[pair, "companion eigenvalues, mid-game"]


def test_the_events_of_a_class_are_the_sum_of_its_kinds() -> None:
    for counts in rows.counted().values():
        assert sum(counts["by_kind"].values()) == counts["events"]


def test_the_stored_operations_follow_the_formulas_of_section_3() -> None:
    for counts in rows.counted().values():
        paper = 28 * counts["moving"] + 19 * counts["pairs"]
        assert counts["operations"]["the paper's events"] == paper
        assert counts["solved"] <= counts["looked_at"]
        assert counts["operations"]["carom"] < paper < counts["operations"]["by steps of 1 ms"]
