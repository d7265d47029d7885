"""The tables of docs/contact.md: a frozen cue ball, the slate's contact time, a blow's friction.

    python benches/contact.py

Printed and stored in ``benches/results/contact.json``. The results do not depend on the machine or
its load. It takes a few seconds.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from carom.bench import report
from carom.validation.alciatore_tp_collision.rows import FROZEN_ANGLES, FROZEN_CUTS, frozen
from carom.validation.alciatore_tp_flight.rows import preset_masse, rise, turn
from carom.validation.lab import JSON, Ball, Run, ball, simulate

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "contact.json"

#: Contact times of the slate, ms (the tip's is 1 ms), and restitutions of the slate.
SLATE_TIMES = [round(0.05 * k, 2) for k in range(4, 31)]
SLATE_RESTITUTIONS = (0.4, 0.5, 0.6, 0.7)
#: The bars: the hop of a massé, mm, its direction, °, and the rise of a strike at 45°, mm.
HIGHEST_HOP, DIRECTION, WIDTH, BALL = 15.0, 87.908, 1.0, 57.15
#: Elevations of the massés whose hop counts, °, and of those whose friction is computed.
HOP_ELEVATIONS, ELEVATIONS = (72.0, 75.0, 78.0), (15.0, 30.0, 45.0, 60.0, 70.0, 75.0, 80.0)
RADIUS = 0.028575


def main() -> int:
    """Computes, prints and stores."""
    result = report.where() | {
        "frozen": [frozen_cue_ball(*row) for row in zip(FROZEN_CUTS, FROZEN_ANGLES, strict=True)],
        "slate_times": [window(e) for e in SLATE_RESTITUTIONS],
        "friction_of_the_blow": [friction_of_blow(elevation) for elevation in ELEVATIONS],
    }
    print(json.dumps(result, indent=2))
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def frozen_cue_ball(cut: float, measured: float) -> dict[str, float]:
    """The angle at which a frozen cue ball leaves, ° off the line of centres."""
    return {
        "aim_deg": cut,
        "measured_deg": measured,
        "network_deg": round(frozen(cut), 1),
        "sequential_deg": round(frozen(cut, model="sequential"), 1),
    }


def window(restitution: float) -> dict[str, Any]:
    """The contact times of the slate, ms, that meet each bar, and those that meet all."""

    def physics(time: float) -> JSON:
        slate = {"restitution": restitution}
        return {"base": "pool", "slate": slate, "contact_times": {"slate": 1e-3 * time}}

    hops, rises, directions = [], [], []
    for time in SLATE_TIMES:
        runs = [preset_masse(phi, 3.5, physics=physics(time)) for phi in HOP_ELEVATIONS]
        hops.append(max(rise(run) for run in runs))
        directions.append(turn(runs[1]))
        rises.append(rise(centre_ball_at_45(physics(time))))
    low_hop = np.array(hops) <= HIGHEST_HOP
    straight = np.abs(np.array(directions) - DIRECTION) <= WIDTH
    jumps = np.array(rises) >= BALL
    return {
        "restitution": restitution,
        "hop_at_most_15_mm": span(low_hop),
        "direction_within_1_deg": span(straight),
        "45_deg_jumps_a_ball": span(jumps),
        "all": span(low_hop & straight & jumps),
        "hop_mm": [round(hop, 1) for hop in hops],
        "rise_at_45_deg_mm": [round(height, 1) for height in rises],
    }


def span(met: Any) -> list[float] | None:
    """The first and the last contact time of the first range that meets a bar, ms."""
    indices = np.flatnonzero(met)
    if not len(indices):
        return None
    gaps = np.flatnonzero(np.diff(indices) > 1)
    last = indices[gaps[0]] if len(gaps) else indices[-1]
    return [SLATE_TIMES[indices[0]], SLATE_TIMES[last]]


def centre_ball_at_45(physics: JSON) -> Run:
    """A centre-ball strike at 45° and 5 m/s."""
    strike = {"ball": "cue", "speed": 5.0, "azimuth_deg": 90.0, "elevation_deg": 45.0}
    return simulate(ball(), strike=strike, physics=physics)


def friction_of_blow(elevation: float) -> dict[str, float]:
    """The slate's friction impulse during the blow as a share of what the whole slide needs.

    The tip alone gives the ball the velocity and the slip of the model `sequential` before its
    bounce. Only the tip turns the ball about the vertical, so that spin gives the tip's impulse.
    The rest of the horizontal velocity is friction. Sliding ends when friction has changed the
    velocity by 2/7 of the slip.
    """

    def struck(model: str) -> Run:
        cue = {"model": model, "end_mass": 0.0}
        return preset_masse(elevation, 3.0, physics={"base": "pool", "cue": cue})

    alone = struck("sequential").first("cue-strike").after["cue"]
    bounce = struck("sequential").first("slate-collision").after["cue"]
    together = struck("network").first("cue-strike").after["cue"]
    return {
        "elevation_deg": elevation,
        "network_percent": round(100 * share(alone, together), 1),
        "sequential_percent": round(100 * share(alone, bounce), 1),
    }


def share(alone: Ball, after: Ball) -> float:
    """The part of the slide's friction impulse that `after` has already had."""
    impulse = after.spin[2] / alone.spin[2]
    used = np.linalg.norm(after.velocity[:2] - impulse * alone.velocity[:2])
    return float(used / (used + 2.0 / 7.0 * np.linalg.norm(slip(after))))


def slip(cue: Ball) -> Any:
    """Velocity of the ball's lowest point, m/s."""
    return cue.velocity[:2] + RADIUS * np.array([-cue.spin[1], cue.spin[0]])


if __name__ == "__main__":
    sys.exit(main())
