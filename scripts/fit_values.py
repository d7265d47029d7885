"""Fit the weights of the logistic regression that values positions (carom-mind, ``Logistic``).

    cargo run --release -p carom-mind --example self_play -- eight-ball 0 2400 300 > eight-ball.csv
    python scripts/fit_values.py eight-ball.csv nine-ball.csv

Every file holds the positions of one game with the seat that won, from self-play. Every second
group of six frames, which have six levels of noise, fits the weights, and the others test them. So
all positions of a frame are on one side. A ridge penalty keeps weights of features without
information small.

Written: ``crates/carom-mind/src/value/weights.rs``, and ``benches/results/values.json`` with the
log loss and the calibration on the frames that were not fitted.
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
#: Columns before the features: frame, multiplier of the noise, seat, won.
BEFORE = 4
#: Number of levels of noise, which follow each other from frame to frame.
MULTIPLIERS = 6
#: Strength of the ridge penalty, relative to the mean log loss.
RIDGE = 1e-4
Array = NDArray[np.float64]


def main() -> int:
    """Fits every game and writes the weights."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=Path, help="GAME.csv of the example self_play")
    games = {path.stem: fit_game(path) for path in parser.parse_args().files}
    stored = json.loads(STORED.read_text("utf-8"))["games"] if STORED.exists() else {}
    games = dict(sorted((stored | games).items()))
    WEIGHTS.write_text(as_rust(games), encoding="utf-8")
    result = report.where() | {"games": games}
    STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


def fit_game(path: Path) -> dict[str, Any]:
    """The weights of a game, and how well they predict frames that were not fitted."""
    names = path.read_text("utf-8").splitlines()[0].split(",")[BEFORE:]
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    frame, won, features = table[:, 0], table[:, 3], table[:, BEFORE:]
    odd = frame // MULTIPLIERS % 2 == 1
    weights = fitted(features[odd], won[odd])
    value = expit(features[~odd] @ weights)
    markov = expit(features[~odd, names.index("markov")])
    result = {
        "frames": len(np.unique(frame)),
        "positions": len(frame),
        "weights": dict(zip(names, map(float, np.round(weights, 6)), strict=True)),
        "log_loss": {
            "logistic": log_loss(value, won[~odd]),
            "markov": log_loss(markov, won[~odd]),
            "constant": log_loss(np.full(len(value), won[odd].mean()), won[~odd]),
        },
        "calibration": calibration(value, won[~odd]),
        "calibration_of_markov": calibration(markov, won[~odd]),
    }
    print(path.stem, json.dumps(result["log_loss"]), file=sys.stderr)
    return result


def fitted(features: Array, won: Array) -> Array:
    """The weights of least log loss."""

    def loss(weights: Array) -> tuple[float, Array]:
        score = features @ weights
        total = np.mean(np.logaddexp(0.0, score) - won * score) + RIDGE * (weights @ weights)
        slope = features.T @ (expit(score) - won) / len(won) + 2.0 * RIDGE * weights
        return float(total), slope

    best = minimize(loss, np.zeros(features.shape[1]), jac=True, method="L-BFGS-B")
    return np.asarray(best.x)


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
        lines += [f"            {weight!r}," for weight in result["weights"].values()]
        lines += ["        ],", "    ),"]
    return "\n".join([*lines, "];", ""])


if __name__ == "__main__":
    sys.exit(main())
