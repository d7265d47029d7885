"""How near a learned table comes to shots that it was not learned from.

    python benches/film_errors.py TRACKS --table NAME --radius M

The table is learned from every second shot, and the strikes of the others are found on it; then the
other way round. The result has the root mean square distance of model and track, with the places of
rest as seen and with them free within 1.5 mm; that of the struck ball alone; the first 3 s; the
distance of the places where the balls came to rest; and whether the struck ball meets the same
rails and balls in the same order, as far as the film's contacts are known. Quantiles are 5, 25, 50,
75 and 95 %. ``learned`` has the numbers of the table that all shots together tell, with their
covariance. The result is stored in ``benches/results/film_errors.json``; of the film it has nothing
else.
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
from carom.files import write_whole
from carom.learn.contacts import ONE

STORED = Path(__file__).parent / "results" / "film_errors.json"
#: Error of the places of rest, m, where they are free.
REST = 0.0015
QUANTILES = (5, 25, 50, 75, 95)


def main() -> int:
    """Measures, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tracks", type=Path)
    parser.add_argument("--table", required=True)
    parser.add_argument("--radius", type=float, required=True)
    options = parser.parse_args()
    tracks = learn.read_tracks(options.tracks, table=options.table, radius=options.radius)
    rows: dict[str, list[dict[str, Any]]] = {"seen": [], "free": []}
    seconds: dict[str, list[float]] = {"table": [], "strike": []}
    for fold in range(2):
        fitted, held = tracks[1 - fold :: 2], tracks[fold::2]
        began = time.process_time()
        table = learn.table(fitted)
        seconds["table"].append((time.process_time() - began) / len(fitted))
        for name, rest in (("seen", None), ("free", REST)):
            began = time.process_time()
            found = learn.strikes(held, table, rest=rest)
            seconds["strike"].append((time.process_time() - began) / len(held))
            by_name = {strike.name: strike for strike in found}
            for shot in held:
                shown = learn.segment(shot, tracks.header)
                rows[name].append(errors(shown, by_name.get(shot.name)))
    posterior = learn.table(tracks).to_dict()["posterior"]
    result = report.where() | {
        "shots": len(tracks),
        "learned": {key: posterior[key] for key in ("names", "mean", "covariance", "shots")},
        "seconds_per_shot": seconds,
        **{f"places_{name}": summary(found) for name, found in rows.items()},
    }
    text = json.dumps(result, indent=1)
    print(text)
    write_whole(STORED, text + "\n")
    return 0


def errors(shown: learn.Segments, strike: learn.FilmedStrike | None) -> dict[str, Any]:
    """The errors of one shot, m; without a strike they are infinite."""
    if strike is None:
        return dict.fromkeys(("all", "first_3s", "struck"), np.inf) | {"rest": [], "order": False}
    trace = strike.shot.simulate()
    struck = str(strike.shot.strike.ball)
    places = {}
    for index, ball in enumerate(strike.shot.ids):
        seen = strike.shot.track[ball]
        model = trace.at(np.maximum(seen[:, 0], 0.0)).position[:, index, :2]
        places[ball] = (seen[:, 0], np.hypot(*(model - seen[:, 1:]).T))
    times, struck_errors = places[struck]
    share = np.gradient(times) if times.size > 1 else np.ones(1)
    return {
        "all": strike.rmse,
        "first_3s": strike.rmse_3s,
        "struck": float(np.sqrt(np.average(struck_errors**2, weights=share))),
        "rest": [float(error[-1]) for _, error in places.values() if len(error) > 1],
        "order": in_order(shown, strike, trace),
    }


def in_order(shown: learn.Segments, strike: learn.FilmedStrike, trace: carom.Trace) -> bool:
    """Whether the struck ball meets the rails and balls of the film, in the same order."""
    struck = str(strike.shot.strike.ball)
    film = [
        contact.rail or next(ball for ball in contact.balls if ball != struck)
        for contact in shown.contacts
        if struck in contact.balls and contact.is_known
    ]
    end = strike.shot.track[struck][-1, 0]
    met = [
        (event["time"], event.get("rail") or next(b for b in event["balls"] if b != struck))
        for event in trace.events
        if event["type"] in ("ball-collision", "rail-collision")
        and struck in event["balls"]
        and event["time"] < end
    ]
    # A film shows two contacts with one rail or ball as one if they follow each other so soon.
    model = [
        what
        for number, (when, what) in enumerate(met)
        if number == 0 or met[number - 1][1] != what or when - met[number - 1][0] > ONE
    ]
    return film == model


def summary(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Quantiles of the shots, cm."""
    found: dict[str, Any] = {
        key: np.percentile([100.0 * row[key] for row in rows], QUANTILES).round(2).tolist()
        for key in ("all", "first_3s", "struck")
    }
    rests = [100.0 * error for row in rows for error in row["rest"]]
    found["rest"] = np.percentile(rests, QUANTILES).round(2).tolist()
    found["in_order"] = sum(row["order"] for row in rows)
    return found


if __name__ == "__main__":
    sys.exit(main())
