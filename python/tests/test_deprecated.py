"""Old spellings work as the new ones do, and warn with the new name."""

from __future__ import annotations

from dataclasses import dataclass

import pytest
from carom import deprecated


@deprecated.renamed_arguments(old="new")
def function(first: int, *, new: int = 0) -> tuple[int, int]:
    return first, new


@deprecated.renamed_fields(length="length_m")
@dataclass(frozen=True, slots=True)
class Thing:
    length_m: float = 0.0


def test_an_old_argument_reaches_the_new_one_with_a_warning_that_names_it() -> None:
    with pytest.warns(FutureWarning, match=r"function\(old=\.\.\.\) is now function\(new=\.\.\.\)"):
        assert function(1, old=2) == (1, 2)  # type: ignore[call-arg]


def test_the_warning_points_at_the_line_of_the_caller() -> None:
    with pytest.warns(FutureWarning) as caught:
        function(1, old=2)  # type: ignore[call-arg]
    assert caught[0].filename == __file__


def test_both_spellings_of_an_argument_at_once_are_refused() -> None:
    with pytest.raises(TypeError, match="both 'new' and its old spelling 'old'"):
        function(1, new=2, old=3)  # type: ignore[call-arg]


def test_a_renamed_field_is_accepted_and_read_by_its_old_name() -> None:
    with pytest.warns(
        FutureWarning, match=r"Thing\(length=\.\.\.\) is now Thing\(length_m=\.\.\.\)"
    ):
        thing = Thing(length=2.0)  # type: ignore[call-arg]
    assert thing == Thing(length_m=2.0)
    with pytest.warns(FutureWarning, match=r"Thing\.length is now Thing\.length_m") as caught:
        assert thing.length == 2.0  # type: ignore[attr-defined]
    assert caught[0].filename == __file__


def test_a_renamed_function_calls_the_new_one() -> None:
    old = deprecated.renamed_function("module.old", function, name="module.function")
    with pytest.warns(FutureWarning, match=r"module\.old\(\) is now module\.function\(\)"):
        assert old(1, new=2) == (1, 2)


def test_a_renamed_key_gives_way_to_the_new_one_where_both_are_written() -> None:
    with pytest.warns(FutureWarning, match=r"reward\.target is now reward\.points"):
        assert deprecated.renamed_keys("reward", {"target": 1}, {"target": "points"}) == {
            "points": 1
        }
    with pytest.warns(FutureWarning):
        found = deprecated.renamed_keys("reward", {"target": 1, "points": 2}, {"target": "points"})
    assert found == {"points": 2}
