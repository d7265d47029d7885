"""Ratings of tournaments: `carom.arena.ratings`, `carom arena ratings`."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterator, Sequence
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

import choix
import numpy as np
import pytest
from carom import InputError
from carom.arena import SequentialTest, Tournament, ratings
from carom.arena.bradley_terry import ELO, Game, fit
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pathlib import Path

    from conftest import CommandLine

NORMAL = NormalDist()


def chance(strength: float) -> float:
    """The chance of the breaker with this advantage to win."""
    return float(1 / (1 + np.exp(-strength)))


def simulated(
    random: np.random.Generator,
    strengths: Sequence[float],
    breaker: float,
    pairs: int,
    correlation: float,
) -> Iterator[Game]:
    """A round robin of players a, b, c and so on with known strengths.

    The frames of a pair depend on each other through normal numbers (a Gaussian copula), so each
    frame alone has exactly the chance of the model.
    """
    for i, j in itertools.combinations(range(len(strengths)), 2):
        numbers = random.normal(size=(pairs, 2))
        numbers[:, 1] *= np.sqrt(1 - correlation**2)
        numbers[:, 1] += correlation * numbers[:, 0]
        for pair, (first, second) in enumerate(numbers):
            for number, one, other in ((first, i, j), (second, j, i)):
                p = chance(strengths[one] - strengths[other] + breaker)
                won = number < NORMAL.inv_cdf(p)
                yield Game("abcdef"[one], "abcdef"[other], float(won), (i, j, pair))


@pytest.mark.parametrize("correlation", [0.5, -0.4])
def test_intervals_cover_the_true_ratings(correlation: float) -> None:
    strengths = np.array([0.0, 0.3, 0.7, 1.4])
    true = ELO * (strengths - strengths.mean())
    random = np.random.default_rng(7)
    covered = []
    for _ in range(60):
        table = fit(list(simulated(random, strengths, 0.5, 20, correlation)))
        covered += [row.low <= true["abcd".index(row.player)] <= row.high for row in table.players]
        covered.append(table.breaker[1] <= 0.5 * ELO <= table.breaker[2])
    # 300 intervals, of which about 5 % miss.
    assert 0.9 <= np.mean(covered) <= 0.98


def test_without_an_advantage_the_ratings_are_those_of_choix() -> None:
    random = np.random.default_rng(3)
    games = list(simulated(random, [0.0, 0.5, 1.0, 1.2], 0.0, 300, 0.0))
    # The order of the seats carries no information; both directions make the advantage 0.
    both = games + [Game(game.other, game.breaker, 1 - game.points, game.pair) for game in games]
    table = fit(both)
    assert abs(table.breaker[0]) < 1e-6
    won = [
        ("abcd".index(game.breaker), "abcd".index(game.other))
        if game.points == 1
        else ("abcd".index(game.other), "abcd".index(game.breaker))
        for game in both
    ]
    other: NDArray[Any] = ELO * choix.opt_pairwise(4, won)
    other -= other.mean()
    for row in table.players:
        # The prior of two frames a player moves the ratings by less than a point.
        assert abs(row.elo - other["abcd".index(row.player)]) < 1.0


def test_an_unbeaten_player_has_a_finite_rating_and_a_wide_interval() -> None:
    games = [Game("a", "b", 1.0, k) for k in range(10)] + [
        Game("b", "a", 0.0, k) for k in range(10)
    ]
    table = fit(games)
    best = table.players[0]
    assert best.player == "a"
    assert 200 < best.elo < 800
    assert best.high - best.low > 200
    elo, low, high = table.difference("a", "b")
    assert low > 0
    assert elo == pytest.approx(best.elo - table.players[1].elo)
    assert (elo - low) == pytest.approx(high - elo)
    with pytest.raises(InputError, match="the table has no 'c'"):
        table.difference("a", "c")


def test_a_draw_is_half_a_won_frame() -> None:
    drawn = fit([Game("a", "b", 0.5, k) for k in range(20)])
    assert drawn.players[0].elo == pytest.approx(0, abs=1e-6)
    assert drawn.players[0].share == 0.5


def test_few_null_tests_pass() -> None:
    """Two hundred sequential tests between equal players whose pairs depend on each other."""
    random = np.random.default_rng(11)
    passed = 0
    for _ in range(200):
        counts = [0] * 5
        accepted: str | None = None
        while accepted is None:
            first, second = random.normal(size=2)
            second = 0.4 * first + np.sqrt(1 - 0.4**2) * second
            breaker = NORMAL.inv_cdf(0.6)
            # Player 0 breaks first; in the other frame it wins if the breaker loses.
            counts[2 * (int(first < breaker) + int(second > breaker))] += 1
            if sum(counts) % 10 == 0:
                accepted = SequentialTest(0.5, 0.6).state(counts).accepted
        passed += accepted == "p1"
    assert passed <= 10


FILE: dict[str, Any] = {
    "format": "carom-tournament/1",
    "players": ["greedy:10", "pool-master:10", "deep-green-0:10"],
    "events": [
        {
            "name": "all",
            "type": "round-robin",
            "game": "nine-ball",
            "noise": ["olympiad", "olympiad:2"],
            "pairs": 2,
        },
        {
            "name": "change",
            "type": "test",
            "players": ["greedy:10", "pool-master:10"],
            "shares": [0.2, 0.8],
            "game": "nine-ball",
            "noise": "olympiad",
        },
    ],
}


def test_a_tournament_has_a_table_for_each_condition(run: CommandLine, tmp_path: Path) -> None:
    Tournament(FILE).run(tmp_path / "out", threads=2)
    tables = ratings(tmp_path / "out")
    assert [table.condition for table in tables] == [
        "nine-ball, noise olympiad",
        "nine-ball, noise olympiad:2",
    ]
    for table in tables:
        assert table.pairs == 6, "those of the test do not count"
        assert {row.player for row in table.players} == set(FILE["players"])
        assert sum(row.elo for row in table.players) == pytest.approx(0, abs=1e-6)
    done = run("arena", "ratings", "out", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == [json.loads(json.dumps(table.to_dict())) for table in tables]


def test_a_folder_without_a_tournament_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="the folder has no tournament") as refused:
        ratings(tmp_path)
    assert refused.value.kind == "missing"
    with pytest.raises(InputError, match="level"):
        fit([Game("a", "b", 1.0, 0)], level=1.0)
    with pytest.raises(InputError, match="there is no frame"):
        fit([])
