"""Intervals and ranks of learned tables: the short form of ``benches/table_coverage.py``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import linear_films
import numpy as np
import pytest
from carom import learn
from carom.learn.table_model import TableModel
from scipy import stats
from test_stored_results import load

bench: Any = load("benches/table_coverage.py")


def test_intervals_of_simulated_tables_cover_the_truth() -> None:
    """Five tables of four shots, learned from 4 starts.

    Of 15 independent intervals of 90 %, fewer than 12 cover the truth with a probability of 5.6 %.
    The seeds are fixed. Intervals of half the width cover 11.
    """
    free = ("rolling.a", "cushion.restitution.a", "frame.x")
    covered = 0
    for seed in range(200, 205):
        row = bench.learned(bench.FITTED, seed, free, shots=4, rounds=1, starts=4)
        ends = zip(row["low"], row["truth"], row["high"], strict=True)
        covered += sum(low < true < high for low, true, high in ends)
    assert covered >= stats.binom.ppf(0.06, 15, 0.9)


def test_ranks_of_the_truth_among_draws_are_uniform_in_a_linear_model() -> None:
    """300 fits of a line to shots whose samples share an error; χ² over 10 bins, 9 degrees."""
    random = np.random.default_rng(3)
    free = ("cloth.sliding_friction", "rolling.a")
    model = TableModel("carom-10ft", "carom", free)
    truth = bench.values(learn.LearnedTable(*model.parts(model.start)), free)
    ranks = []
    for seed in range(300):
        found = linear_films.learned(random, model, shots=30, samples=10)
        draws = np.array([bench.values(draw, free) for draw in found.draw(39, seed)])
        ranks.append((draws < truth).sum(axis=0))
    counts = np.array([np.histogram(rank, 10, (0, 40))[0] for rank in np.array(ranks).T])
    assert (((counts - 30.0) ** 2 / 30.0).sum(axis=1) < stats.chi2.ppf(0.999, 9)).all(), counts


def test_stored_shares_are_those_of_the_stored_tables() -> None:
    stored = json.loads(bench.STORED.read_text(encoding="utf-8"))
    assert set(stored["films"]) == set(bench.FILMED)
    assert len(stored["tables"]) == sum(
        f["tables"] + f["refused"] for f in stored["films"].values()
    )
    for film, shares in stored["films"].items():
        assert bench.shares(stored["tables"], film) == shares


@pytest.mark.parametrize(("film", "count"), [("han-2005", 7), ("stronge", 5)])
def test_only_numbers_that_both_models_have_are_counted(film: str, count: int) -> None:
    counted = bench.counted(film, bench.FREE)
    assert len(counted) == count
    assert ("cushion.friction.a" in counted) == (film == bench.FITTED)


def test_a_table_stays_stored_until_its_new_one_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = tmp_path / "coverage.json"
    tables = json.loads(bench.STORED.read_text(encoding="utf-8"))["tables"]
    first = next(row for row in tables if row["film"] == bench.FITTED and "refused" not in row)
    new = {key: first[key] for key in ("names", "shots", "truth", "mean", "low", "high", "rank")}

    def learned(film: str, seed: int) -> dict[str, Any]:
        if seed == 1:
            raise KeyboardInterrupt
        return new | {"shots": 0}

    monkeypatch.setattr(bench, "learned", learned)
    bench.store(kept, {}, tables)
    arguments = ["--tables", "2", "--films", bench.FITTED, "--again", "--out", str(kept)]
    monkeypatch.setattr("sys.argv", ["table_coverage.py", *arguments])
    before = bench.STORED.read_bytes()
    with pytest.raises(KeyboardInterrupt):
        bench.main()
    after = json.loads(kept.read_text(encoding="utf-8"))["tables"]
    changed = [row for row, old in zip(after, tables, strict=True) if row != old]
    assert [(row["film"], row["seed"], row["shots"]) for row in changed] == [(bench.FITTED, 0, 0)]
    assert bench.STORED.read_bytes() == before
