"""The tables of docs/many-balls.md: rows of balls, and breaks by the gaps in the rack.

    python benches/many_balls.py

Printed and stored in ``benches/results/many_balls.json``. The results do not depend on the machine
or its load.
"""

from __future__ import annotations

import json
import statistics
import sys
from pathlib import Path
from typing import Any

import carom
from carom.bench import report

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "many_balls.json"
#: A pool ball's radius, m, and the number of balls in a row.
RADIUS, BALLS = 0.028575, 5
#: Mean gaps in the rack, m; racks for each; speed of the cue, m/s.
GAPS, RACKS, SPEED = (0.0, 1e-5, 1e-4, 3e-4), 100, 10.0
#: Time from the first contact after which the cue ball's contacts with the rack have ended, s.
REBOUND_TIME = 5e-3


def main() -> int:
    """Computes, prints and stores."""
    result = report.where() | {
        "speeds_after_m_s": {f"{k} moving": row(k) for k in (1, 2)},
        "breaks": [{"gap_mm": 1000 * gap} | breaks(gap) for gap in GAPS],
    }
    print(json.dumps(result, indent=2))
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def row(moving: int) -> list[float]:
    """Speeds, m/s, after the first `moving` balls of a row hit the others at 1 m/s, no losses."""
    balls = [
        {
            "id": str(k),
            "position": [2 * RADIUS * k, 0.0],
            "velocity": [1.0 if k < moving else 0.0, 0.0, 0.0],
            "angular_velocity": [0.0, 0.0, 0.0],
        }
        for k in range(BALLS)
    ]
    shot = carom.Shot.from_dict(
        {
            "format": "carom-shot/1",
            "table": {"cloth": "unbounded"},
            "physics": {"base": "ideal", "ball": {"radius": RADIUS}},
            "balls": balls,
        }
    )
    event = next(e for e in shot.simulate().to_dict()["events"] if e["type"] == "ball-collision")
    return [round(ball["velocity"][0], 3) for ball in event["after"]]


def breaks(gap: float) -> dict[str, Any]:
    """Means over eight-ball breaks of racks with a mean gap, m."""
    found = [one_break(gap, seed) for seed in range(RACKS)]
    rebounds, to_rail, pocketed = zip(*found, strict=True)
    return {
        "racks": RACKS,
        "rebound_median": round(statistics.median(rebounds), 2),
        "rebound_range": [round(min(rebounds), 2), round(max(rebounds), 2)],
        "balls_to_a_rail": round(statistics.mean(to_rail), 1),
        "pocketed": round(statistics.mean(pocketed), 1),
    }


def one_break(gap: float, seed: int) -> tuple[float, int, int]:
    """The cue ball's rebound as a share of its speed; object balls to a rail; balls pocketed."""
    trace = carom.break_shot("eight-ball", speed=SPEED, seed=seed, gap=gap).simulate()
    events = trace.to_dict()["events"]
    cue = trace.outcome["cue_ball"]
    hits = [e for e in events if e["type"] == "ball-collision" and cue in e["balls"]]
    hits = [e for e in hits if e["time"] < hits[0]["time"] + REBOUND_TIME]
    before, after = velocity_of(cue, hits[0]["before"]), velocity_of(cue, hits[-1]["after"])
    forward = (before[0] ** 2 + before[1] ** 2) ** 0.5
    back = -(after[0] * before[0] + after[1] * before[1]) / forward
    touched = {
        ball for e in events if e["type"] == "rail-collision" for ball in e["balls"] if ball != cue
    }
    return back / forward, len(touched), len(trace.outcome["pocketed"])


def velocity_of(name: str, balls: list[dict[str, Any]]) -> list[float]:
    """The velocity of a ball in a list of states, m/s."""
    velocity: list[float] = next(ball["velocity"] for ball in balls if ball["id"] == name)
    return velocity


if __name__ == "__main__":
    sys.exit(main())
