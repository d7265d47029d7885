"""How often the intervals of a learned player cover the truth.

    python benches/player_coverage.py [--players N] [--cases I ...]

Synthetic players repeat a drill with a known intention, 10, 50 and 200 times. Their σ lie between
those of the presets `professional` and `beginner`, equally likely in the logarithm; their errors
are correlated and have a mean. Every strike is measured with an error whose covariance is known and
differs from strike to strike. Each player is learned alone, and with 10 strikes also together with
the others. Each case is stored in ``benches/results/player_coverage.json`` under
its index in ``CASES``; all of them take about an hour of one core.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom import learn
from carom.bench import report
from carom.learn.player_errors import NUMBERS, SCALE
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "player_coverage.json"
#: Least σ of a synthetic player over the largest, which is that of a beginner.
LEAST = np.array((0.15, 0.067, 0.15, 0.133, 0.133))
#: Strikes of each player, error of the measurement in σ of the player, and whether the players are
#: learned together.
CASES = (
    (50, 0.1, False),
    (50, 1.0, False),
    (10, 0.1, False),
    (10, 1.0, False),
    (10, 1.0, True),
    (200, 0.1, False),
    (200, 1.0, False),
)
#: Draws from the posterior of each player.
DRAWS = 600
#: Players that are learned in one call: more do not fit in the caches.
TOGETHER = 50

Floats = NDArray[np.float64]


def main() -> int:
    """Measures, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--players", type=int, default=200)
    parser.add_argument("--cases", type=int, nargs="*", default=range(len(CASES)))
    options = parser.parse_args()
    for index in options.cases:
        case = report.where() | coverage(*CASES[index], options.players, seed=1)
        print(json.dumps(case), flush=True)
        stored = json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
        stored[str(index)] = case
        STORED.write_text(json.dumps(stored, indent=1) + "\n", encoding="utf-8")
    return 0


def coverage(shots: int, error: float, pooled: bool, players: int, seed: int) -> dict[str, Any]:
    """Shares of the intervals of 90 % that cover the true σ, by number."""
    began = time.perf_counter()
    random = np.random.default_rng((seed, shots, int(10 * error)))
    truth, low, high = [], [], []
    size = players if pooled else TOGETHER
    for first in range(0, players, size):
        sigma, played, by_shot = drills(random, min(size, players - first), shots, error)
        found = learn.players(
            played, played[0].shot, by_shot, pooled=pooled, draws=DRAWS, seed=seed
        )
        truth.append(sigma)
        ends = np.array([[found[p].interval(name) for name in NUMBERS] for p in sorted(found)])
        low.append(ends[..., 0])
        high.append(ends[..., 1])
    true, under, over = (np.concatenate(part) for part in (truth, low, high))
    inside = (under < true) & (true < over)
    return {
        "players": players,
        "shots": shots,
        "error": error,
        "together": pooled,
        "covered": dict(zip(NUMBERS, np.round(inside.mean(axis=0), 3).tolist(), strict=True)),
        "all": round(float(inside.mean()), 3),
        "above": round(float((true >= over).mean()), 3),
        "below": round(float((true <= under).mean()), 3),
        "upper_over_lower": round(float(np.median(over / under)), 2),
        "seconds": round(time.perf_counter() - began),
    }


def drills(
    random: np.random.Generator, players: int, shots: int, error: float
) -> tuple[Floats, list[learn.PlayedStrike], dict[str, str]]:
    """True σ, measured strikes, and the player of each shot."""
    scale = np.array(SCALE)
    sigma = scale * np.exp(random.uniform(np.log(LEAST), 0.0, (players, 5)))
    shot = carom.Shot("wpa-9ft", {"cue": (0.6, 0.6), "1": (0.6, 1.6)}, carom.Strike(2.0, 1.57))
    centre = learn.PlayedStrike.exact("intended", shot).vector
    played, by_shot = [], {}
    for player in range(players):
        root = correlated(random, 1)[0] * sigma[player][:, None]
        own = random.normal(0.0, scale / 3.0) + random.standard_normal((shots, 5)) @ root.T
        spread = error * sigma[player] * np.exp(random.normal(0.0, 0.3, (shots, 5)))
        measured = correlated(random, shots) * spread[:, :, None]
        noise = np.einsum("nkl,nl->nk", measured, random.standard_normal((shots, 5)))
        for index in range(shots):
            name = f"{player:04}-{index}"
            covariance = measured[index] @ measured[index].T
            vector = centre + own[index] + noise[index]
            played.append(learn.PlayedStrike(name, shot, vector, covariance))
            by_shot[name] = f"{player:04}"
    return sigma, played, by_shot


def correlated(random: np.random.Generator, count: int) -> Floats:
    """Cholesky factors of random correlation matrices, shape (count, 5, 5)."""
    rows = random.standard_normal((count, 5, 8))
    matrix = rows @ rows.transpose(0, 2, 1)
    size = np.sqrt(np.einsum("nkk->nk", matrix))
    return np.linalg.cholesky(matrix / (size[:, :, None] * size[:, None, :]))


if __name__ == "__main__":
    sys.exit(main())
