"""The events of shots in which a spinning ball pushes frozen balls or a rail.

    python benches/pushes.py

The first ball of a row is at rest with topspin. The row lies across `wpa-9ft`, or its last
ball touches a rail, or it lies on endless cloth. The number of events of each shot
is printed and stored in ``benches/results/pushes.json``; it does not depend on the machine.
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import carom
from carom.bench import report

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "pushes.json"
#: Radius of a pool ball, and width of the table, m.
RADIUS, WIDTH = 0.028575, 1.27
SPINS = (100.0, 300.0, 1000.0, 3000.0, 10_000.0)
#: Places of the first ball, m.
ON_CLOTH, ENDLESS = [0.5, 0.5], [0.0, 0.0]


def main() -> int:
    """Computes, prints and stores."""
    # The nose is higher than the centre of a ball that touches it.
    nose = carom.Frame("nine-ball").geometry()["cushion_height"]
    last = WIDTH - math.sqrt(RADIUS**2 - (nose - RADIUS) ** 2)
    at_rail = [
        (f"{balls}, at a rail", "wpa-9ft", balls, [last - 2 * RADIUS * (balls - 1), 0.5])
        for balls in (1, 2)
    ]
    rows = [(f"{balls}", "wpa-9ft", balls, ON_CLOTH) for balls in (2, 3, 5, 8)]
    endless = [(f"{balls}, on endless cloth", None, balls, ENDLESS) for balls in (2, 5)]
    result = report.where() | {
        "spins_rad_s": SPINS,
        "events": {
            name: [events(table, balls, first, spin) for spin in SPINS]
            for name, table, balls, first in rows + at_rail + endless
        },
    }
    print(json.dumps(result, indent=2))
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def events(table: str | None, balls: int, first: list[float], spin: float) -> int:
    """The events of the shot whose first ball has this topspin, rad/s."""
    row: list[dict[str, Any]] = [
        {"id": str(k), "position": [first[0] + 2 * RADIUS * k, first[1]]} for k in range(balls)
    ]
    row[0]["angular_velocity"] = [0.0, spin, 0.0]
    shot = {"format": "carom-shot/1", "table": table or {"cloth": "unbounded"}, "balls": row}
    return len(carom.Shot.from_dict(shot).simulate().events)


if __name__ == "__main__":
    sys.exit(main())
