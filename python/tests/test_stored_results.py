"""Stored results are not older than the engine's physics, and the counting methods count."""

from __future__ import annotations

import importlib.util
import sys
from collections import Counter
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from carom.bench import goldens

ROOT = Path(__file__).parents[2]


def load(path: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    # Dataclasses look their module up there; benches/ import each other by name.
    sys.modules[spec.name] = module
    sys.path.insert(0, str((ROOT / path).parent))
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path.pop(0)
    return module


experiments: Any = load("scripts/experiments.py")
kinds: Any = load("benches/operation_kinds.py")


@pytest.mark.parametrize("experiment", experiments.EXPERIMENTS, ids=lambda e: e.name)
def test_a_stored_result_is_of_the_present_physics(experiment: Any) -> None:
    reason = experiment.outdated()
    assert reason is None, (
        f"{experiment.file.relative_to(ROOT)}: {reason}. Make it again: "
        f"python scripts/experiments.py {experiment.name}, or all that are older: make experiments"
    )


def test_a_shot_with_another_hash_is_named() -> None:
    stored = {"goldens": {"break": "1", "masse": "2"}}
    assert goldens.changed(stored, {"break": "1", "masse": "3"}) == ["masse"]


def test_a_new_example_shot_makes_no_result_older_but_a_removed_one_does() -> None:
    stored = {"goldens": {"break": "1"}}
    assert goldens.changed(stored, {"break": "1", "new": "5"}) == []
    assert goldens.changed(stored, {"new": "5"}) == ["break"]


def test_a_result_without_hashes_is_refused() -> None:
    with pytest.raises(ValueError, match="make it again"):
        goldens.changed({"commit": "0123456"}, {"break": "1"})


def test_the_hashes_are_those_of_the_goldens() -> None:
    stamp = goldens.stamp("a command")
    assert stamp["goldens"] == goldens.hashes()
    assert len(stamp["goldens"]) == len(list((ROOT / "shots").glob("*.json")))
    assert stamp["command"] == "a command"


def test_a_stopped_run_is_not_complete() -> None:
    whole = {"finders": [{"shots": 5, "wanted": 5}]}
    assert experiments.is_complete(whole)
    assert not experiments.is_complete({"finders": [{"shots": 4, "wanted": 5}]})
    assert not experiments.is_complete({"wanted": 3, "shots": [{}, {}]})


def test_the_cost_of_a_call_is_counted_where_it_is_executed(tmp_path: Path) -> None:
    profile = tmp_path / "counts.1"
    profile.write_text(
        "ob=/a/kinds\nfn=main\n0x10 3 1\ncalls=2 0x20 7\n0x14 3 500\n0x20 7 4\n"
        "ob=/lib/libc.so\n0x20 0 9\n"
    )
    counts = kinds.executed(profile)
    assert counts == Counter({("kinds", 0x10): 1, ("kinds", 0x20): 4, ("libc.so", 0x20): 9})


def test_an_instruction_on_a_vector_counts_for_each_double() -> None:
    counts = Counter({("p", 1): 10, ("p", 2): 10, ("p", 3): 5, ("p", 4): 7})
    weights = {("p", 1): ("add", 1), ("p", 2): ("mul", 4), ("p", 3): ("div", 2)}
    found = kinds.per_input(counts, weights, inputs=10)
    assert found == {"operations": 6.0, "divisions": 1.0, "square_roots": 0.0, "instructions": 3.2}


@pytest.mark.parametrize(
    ("mnemonic", "found"),
    [("addsd", ("add", "s")), ("vmulpd", ("mul", "p")), ("sqrtsd", ("sqrt", "s")),
     ("movsd", None), ("addss", None), ("ucomisd", None), ("paddd", None)],
)  # fmt: skip
def test_only_arithmetic_of_doubles_is_counted(mnemonic: str, found: Any) -> None:
    match = kinds.ARITHMETIC.match(mnemonic)
    assert (match and match.groups()) == found
