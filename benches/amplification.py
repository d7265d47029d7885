"""The growth of a tiny shift of the cue ball until the balls rest.

    python benches/amplification.py

The cue ball of every state of `carom bench` is shifted in four directions, by 1e-12 m and by
1e-6 m, before the strike. Two figures are printed and stored in
``benches/results/amplification.json``:

- the median growth of the first shift: the largest distance between a ball's final places with and
  without it, divided by the shift;
- the share of shots in which the second shift moves some ball's final place by more than 1 mm.

A ball that is pocketed in only one of the two shots counts as moved by more than 1 mm. The results
do not depend on the machine or its load.
"""

from __future__ import annotations

import dataclasses
import json
import math
import statistics
import sys
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom.bench import report, states
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "amplification.json"
#: A shift far above rounding (1e-16 m) whose effect stays small until the end, m.
SMALL = 1e-12
#: The distance by which pooltool separates balls that touch, m.
NUDGE = 1e-6
#: A ball that ends this far away is in a visibly different place, m.
SEEN = 1e-3
DIRECTIONS = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
CLASSES = ("random_eight_ball", "eight_ball_break", "nine_ball_break")


def main() -> int:
    """Measures, prints and stores."""
    loaded = states.load()
    result = report.where() | {
        "shift_m": SMALL,
        "nudge_m": NUDGE,
        "seen_m": SEEN,
        "classes": {name: measure(loaded[name]) for name in CLASSES},
    }
    print(json.dumps(result, indent=2))
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def measure(members: list[states.State]) -> dict[str, Any]:
    """Growth of the small shift, and the share of shots that the nudge changes visibly."""
    growths = [moved / SMALL for moved in distances(members, SMALL)]
    nudged = distances(members, NUDGE)
    return {
        "shots": len(growths),
        "median_growth": float(f"{statistics.median(growths):.2g}"),
        "nudge_seen": round(sum(moved > SEEN for moved in nudged) / len(nudged), 3),
    }


def distances(members: list[states.State], shift: float) -> list[float]:
    """Largest distance between a ball's ends with and without a shift, m, for every direction."""
    reference = ends(members)
    found = []
    for x, y in DIRECTIONS:
        moved = ends([shifted(state, x * shift, y * shift) for state in members])
        found += [largest(a, b) for a, b in zip(reference, moved, strict=True)]
    return found


def shifted(state: states.State, dx: float, dy: float) -> states.State:
    """The state with the cue ball moved by (dx, dy) m."""
    x, y = state.balls["cue"]
    return dataclasses.replace(state, balls=state.balls | {"cue": (x + dx, y + dy)})


def ends(members: list[states.State]) -> list[NDArray[np.float64]]:
    """Final places of each shot's balls, shape (n, 2), m; NaN for a ball that is pocketed."""
    found = []
    for state in members:
        final = carom.Shot.from_dict(state.shot_file()).simulate().to_dict()["final"]
        found.append(
            np.array(
                [
                    (math.nan, math.nan) if ball["motion"] != "stationary" else ball["position"][:2]
                    for ball in final
                ]
            )
        )
    return found


def largest(a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
    """Largest distance, m; infinite where a ball is on the table in one of the two only."""
    gone = np.isnan(a[:, 0]), np.isnan(b[:, 0])
    if (gone[0] != gone[1]).any():
        return math.inf
    return float(np.nanmax(np.linalg.norm(a - b, axis=1), initial=0.0))


if __name__ == "__main__":
    sys.exit(main())
