"""Checks of the arena's statistics on simulated results: intervals of ratings, and null tests.

    python benches/arena_bars.py        # continues a stopped run

The results of frames are simulated from known strengths, with the advantage of the player who
begins. The two frames of a pair depend on each other through normal numbers (a Gaussian copula), so
each frame alone has exactly the chance of the model. Results are stored in
``benches/results/arena_bars.json`` as they come.
"""

from __future__ import annotations

import itertools
import json
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np
from carom.arena import SequentialTest
from carom.arena.bradley_terry import ELO, Game, fit
from carom.files import write_whole

ROOT = Path(__file__).resolve().parents[1]
STORE = ROOT / "benches" / "results" / "arena_bars.json"
NORMAL = NormalDist()

#: Strengths of the players (natural logarithm of odds), pairs of two players, correlation of the
#: frames of a pair. The advantage of the player who begins is 0.5.
TOURNAMENTS: dict[str, tuple[Sequence[float], int, float]] = {
    "five players, 20 pairs, correlation 0.5": ((0, 0.3, 0.6, 0.9, 1.5), 20, 0.5),
    "five players, 20 pairs, correlation -0.4": ((0, 0.3, 0.6, 0.9, 1.5), 20, -0.4),
    "four players, two far apart, 10 pairs, correlation 0.3": ((-1.5, 0, 0.2, 2), 10, 0.3),
    "two players, 30 pairs, correlation 0.3": ((0, 0.5), 30, 0.3),
}
BREAKER = 0.5
REPETITIONS = 500
#: Correlations of the frames of a pair in the null tests, and the hypotheses.
CORRELATIONS = (-0.4, 0.0, 0.4)
SHARES = ((0.5, 0.55), (0.5, 0.6))
TESTS = 200


def main() -> None:
    """Computes what is missing in the store."""
    found: dict[str, Any] = json.loads(STORE.read_text()) if STORE.exists() else {}
    found.setdefault("commit", commit())
    found.setdefault("ratings", {})
    found.setdefault("null_tests", {})
    for name, (strengths, pairs, correlation) in TOURNAMENTS.items():
        if name not in found["ratings"]:
            found["ratings"][name] = coverage(strengths, pairs, correlation)
            write_whole(STORE, json.dumps(found, indent=1) + "\n")
    for shares, correlation in itertools.product(SHARES, CORRELATIONS):
        name = f"{shares[0]} against {shares[1]}, correlation {correlation}"
        if name not in found["null_tests"]:
            found["null_tests"][name] = null_tests(shares, correlation)
            write_whole(STORE, json.dumps(found, indent=1) + "\n")
    print(json.dumps(found, indent=1))


def commit() -> str:
    """The commit of the checkout."""
    asked = ["git", "rev-parse", "--short=8", "HEAD"]
    return subprocess.run(
        asked, cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.strip()


def coverage(strengths: Sequence[float], pairs: int, correlation: float) -> dict[str, float]:
    """The share of the intervals at 95 % that contain the true value."""
    random = np.random.default_rng(1)
    names = [f"p{i}" for i in range(len(strengths))]
    true = ELO * (np.array(strengths) - np.mean(strengths))
    ratings, breaker = [], []
    for _ in range(REPETITIONS):
        table = fit(list(games(random, strengths, names, pairs, correlation)))
        ratings += [row.low <= true[names.index(row.player)] <= row.high for row in table.players]
        breaker.append(table.breaker[1] <= ELO * BREAKER <= table.breaker[2])
    return {
        "tournaments": REPETITIONS,
        "ratings": float(np.mean(ratings)),
        "breaker": float(np.mean(breaker)),
    }


def games(
    random: np.random.Generator,
    strengths: Sequence[float],
    names: Sequence[str],
    pairs: int,
    correlation: float,
) -> Iterator[Game]:
    """A round robin."""
    for i, j in itertools.combinations(range(len(strengths)), 2):
        for pair in range(pairs):
            for number, one, other in zip(
                correlated(random, correlation), (i, j), (j, i), strict=True
            ):
                odds = np.exp(strengths[one] - strengths[other] + BREAKER)
                won = number < NORMAL.inv_cdf(float(odds / (1 + odds)))
                yield Game(names[one], names[other], float(won), (i, j, pair))


def correlated(random: np.random.Generator, correlation: float) -> tuple[float, float]:
    """Two normal numbers with this correlation."""
    first, second = random.normal(size=2)
    return first, correlation * first + np.sqrt(1 - correlation**2) * second


def null_tests(shares: tuple[float, float], correlation: float) -> dict[str, float]:
    """Sequential tests between equal players; the one who begins wins 60 % of the frames."""
    random = np.random.default_rng(2)
    breaker, passed, played = NORMAL.inv_cdf(0.6), 0, 0
    for _ in range(TESTS):
        counts = [0] * 5
        while True:
            first, second = correlated(random, correlation)
            # Player 0 begins the first frame; it wins the second one if its beginner loses.
            counts[2 * (int(first < breaker) + int(second > breaker))] += 1
            accepted = SequentialTest(*shares).state(counts).accepted
            if accepted is not None:
                break
        passed += accepted == "p1"
        played += sum(counts)
    return {"tests": TESTS, "passed": passed, "mean_pairs": played / TESTS}


if __name__ == "__main__":
    main()
