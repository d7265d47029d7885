r"""Fit the weights of the logistic regression that values positions (carom-mind, ``Logistic``).

    for noise in 0.5 0.7 1 1.4 2 2.5; do
        carom match carom:300 carom:400 --game eight-ball --noise olympiad:$noise \
            --pairs 700 --out played/$noise \
            --secret $(printf eight-ball-$noise-b | sha256sum | cut -c1-64)
    done
    cargo run --release -p carom-arena --example position_rows -- \
        played/*/match.jsonl > eight-ball.csv
    python scripts/fit_values.py eight-ball.csv nine-ball.csv

Every file holds the positions of one game with the seat that won, from matches between two almost
equal players. The weights are fitted to all of them. For the test, the racks with odd numbers fit
other weights that predict the even ones, and the reverse. So all positions of a rack are on one
side. A ridge penalty keeps weights of features without information small.

Written: ``crates/carom-mind/src/value/weights.rs``, and ``benches/results/values.json`` with the
log loss and the calibration of the predictions.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from carom.bench import report
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.special import expit

ROOT = Path(__file__).resolve().parents[1]
WEIGHTS = ROOT / "crates" / "carom-mind" / "src" / "value" / "weights.rs"
STORED = ROOT / "benches" / "results" / "values.json"
#: Columns before the features: pair of frames, error of the direction, seat, won, and the chance of
#: winning by the Markov chain.
BEFORE = 5
#: Strength of the ridge penalty, relative to the mean log loss.
RIDGE = 1e-4
Array = NDArray[np.float64]


def main() -> int:
    """Fits every game and writes the weights."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=Path, help="GAME.csv of the example position_rows")
    games = {path.stem: fit_game(path) for path in parser.parse_args().files}
    stored = json.loads(STORED.read_text("utf-8"))["games"] if STORED.exists() else {}
    games = dict(sorted((stored | games).items()))
    WEIGHTS.write_text(as_rust(games), encoding="utf-8")
    result = report.where() | {"games": games}
    STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


def fit_game(path: Path) -> dict[str, Any]:
    """The weights of a game, and how well they predict frames that were not fitted."""
    with path.open(encoding="utf-8") as file:
        names = file.readline().strip().split(",")[BEFORE:]
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    pair, won, features = table[:, 0], table[:, 3], table[:, BEFORE:]
    odd = pair % 2 == 1
    predicted = np.empty(len(won))
    for side in (odd, ~odd):
        predicted[~side] = expit(features[~side] @ fitted(features[side], won[side]))
    markov = table[:, 4]
    weights = fitted(features, won)
    result = {
        "pairs": len(np.unique(pair)),
        "positions": len(pair),
        "weights": dict(zip(names, map(float, np.round(weights, 6)), strict=True)),
        "log_loss": {
            "logistic": log_loss(predicted, won),
            "markov": log_loss(markov, won),
            "constant": log_loss(np.full(len(won), won.mean()), won),
        },
        "calibration": calibration(predicted, won),
        "calibration_of_markov": calibration(markov, won),
    }
    print(path.stem, json.dumps(result["log_loss"]), file=sys.stderr)
    return result


def fitted(features: Array, won: Array) -> Array:
    """The weights of least log loss; the penalty is on features scaled to unit variance."""
    mean, deviation = features.mean(axis=0), features.std(axis=0)
    # The first feature is constant, and so are those that a game does not have.
    used = deviation > 1e-9
    scaled = np.where(used, (features - mean) / np.where(used, deviation, 1.0), 0.0)
    scaled[:, 0] = 1.0

    def loss(weights: Array) -> tuple[float, Array]:
        score = scaled @ weights
        kept = np.concatenate([[0.0], weights[1:]])
        total = np.mean(np.logaddexp(0.0, score) - won * score) + RIDGE * (kept @ kept)
        slope = scaled.T @ (expit(score) - won) / len(won) + 2.0 * RIDGE * kept
        return float(total), slope

    best = minimize(loss, np.zeros(features.shape[1]), jac=True, method="L-BFGS-B").x
    weights = np.where(used, best / np.where(used, deviation, 1.0), 0.0)
    weights[0] = best[0] - weights @ mean
    return np.asarray(weights)


def log_loss(value: Array, won: Array) -> float:
    """The mean of -log p of what happened."""
    p = np.clip(value, 1e-6, 1.0 - 1e-6)
    return float(np.round(-np.mean(won * np.log(p) + (1.0 - won) * np.log(1.0 - p)), 5))


def calibration(value: Array, won: Array) -> list[dict[str, float]]:
    """For each tenth of stated values: how many, their mean, and the share that was won."""
    tenth = np.clip((10.0 * value).astype(int), 0, 9)
    rows = []
    for k in range(10):
        there = tenth == k
        if there.any():
            mean, share = value[there].mean(), won[there].mean()
            rows.append(
                {
                    "positions": int(there.sum()),
                    "stated": float(np.round(mean, 4)),
                    "won": float(np.round(share, 4)),
                }
            )
    return rows


def as_rust(games: dict[str, Any]) -> str:
    """The file with the weights."""
    names = max((result["weights"] for result in games.values()), key=len)
    lines = [
        "//! The weights of the logistic regression. Written by `scripts/fit_values.py`.",
        "",
        "use super::features::COUNT;",
        "",
        "/// The games, and the weights of their features in the order of",
        "/// [`super::features::NAMES`].",
        "#[rustfmt::skip]",
        f"pub(super) const WEIGHTS: [(&str, [f64; COUNT]); {len(games)}] = [",
    ]
    for game, result in games.items():
        lines += ["    (", f'        "{game}",', "        ["]
        # A game that was fitted before a feature existed has no weight for it.
        lines += [f"            {result['weights'].get(name, 0.0)!r}," for name in names]
        lines += ["        ],", "    ),"]
    return "\n".join([*lines, "];", ""])


if __name__ == "__main__":
    sys.exit(main())
