"""Runs of single balls beside a learned table: ``benches/single_runs.py`` on a synthetic film."""

from __future__ import annotations

from typing import Any

import carom
import numpy as np
import pytest
from carom import learn
from carom.learn.table_model import TableModel
from test_learn_table import TRUTH, three_cushion_shots
from test_stored_results import load

bench: Any = load("benches/single_runs.py")


@pytest.fixture(scope="module")
def film() -> learn.Tracks:
    return learn.synthetic(three_cushion_shots(3), rate=50.0, sigma=0.001, seed=5).tracks


def table_with(restitution: float) -> learn.Posterior:
    """The table of the film, but for the restitution of its rails."""
    model = TableModel("carom-10ft", TRUTH, ("cushion.restitution.a",), 0.03075)
    return learn.Posterior(model, np.array([restitution]), np.eye(1) * 1e-6, 3)


def test_runs_on_the_true_table_have_the_error_of_the_camera(film: learn.Tracks) -> None:
    """Of 1 mm in each coordinate: 1.4 mm. In the second shot two balls touch lightly."""
    for kind in bench.KINDS:
        errors = [error for _, error in bench.errors_of(film, table_with(0.88), kind)]
        assert len(errors) > 4
        assert all(0.0009 < error < 0.0019 for error in errors)


def test_a_wrong_rail_is_seen_over_rails_alone(film: learn.Tracks) -> None:
    found = {kind: bench.errors_of(film, table_with(0.8), kind) for kind in bench.KINDS}
    assert all(error < 0.0019 for _, error in found["free"])
    assert all(error > 0.004 for rails, error in found["over_rails"] if rails > 1)
    # The light touch cuts the second run of the film.
    assert [rails for rails, _ in found["over_rails"]] == [3, 3, 1, 0, 4]


def test_runs_are_joined_at_rails_alone() -> None:
    shot = carom.Shot(
        "carom-10ft",
        {"1": (0.4, 0.5), "2": (0.4, 1.6), "3": (1.1, 2.6)},
        carom.Strike(3.0, 0.0, ball="1"),
    )
    track = learn.synthetic([shot], rate=50.0, sigma=0.0005, seed=1).tracks
    rails = sum(event["type"] == "rail-collision" for event in shot.simulate().events)
    assert rails > 1
    (joined,) = bench.runs_of(track[0], track.header, "over_rails")
    assert joined.rails == rails
    apart = list(bench.runs_of(track[0], track.header, "free"))
    assert len(apart) == rails + 1
    assert sum(run.time.size for run in apart) == joined.time.size
    assert all(run.rails == 0 for run in apart)


def test_quantiles_are_listed_by_rails() -> None:
    rows = [(0, 0.001), (2, 0.002), (5, 0.003), (9, 0.005)]
    found = bench.summary(rows)
    assert found["runs"] == 4
    assert [part["runs"] for part in found["by_rails"]] == [1, 1, 2]
    assert found["by_rails"][2]["mm"][2] == 4.0
    assert "by_rails" not in bench.summary(rows[:1])
