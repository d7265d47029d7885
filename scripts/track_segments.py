"""Print how well `carom.learn.segment` finds the contacts of synthetic shots, as a Markdown table.

    python scripts/track_segments.py [SHOTS]

SHOTS three-cushion shots and as many pool shots (100 each by default) are filmed with each camera
of the table. A true contact counts from a change of velocity of 5 cm/s. It is found if there is a
contact of the same balls, or of the same ball and rail, within 30 ms and one and a half pictures.
"""

from __future__ import annotations

import math
import sys
from typing import NamedTuple

import carom
import numpy as np
from carom import learn

LEAST_CHANGE = 0.05
CAMERAS: tuple[dict[str, float], ...] = (
    {"rate": 50, "sigma": 0.0003},
    {"rate": 50, "sigma": 0.001},
    {"rate": 50, "sigma": 0.003},
    {"rate": 25, "sigma": 0.001},
    {"rate": 120, "sigma": 0.001},
    {"rate": 240, "sigma": 0.001},
    {"rate": 50, "sigma": 0.001, "lost": 0.1, "gap": 0.1},
    {"rate": 50, "sigma": 0.001, "least_move": 0.02},
    {"rate": 50, "sigma": 0.001, "jitter": 0.001, "clock_drift": 1e-3},
)


class Score(NamedTuple):
    """What was found in some shots."""

    true: int
    found: int
    false: int
    unknown: int
    times: list[float]
    places: list[float]
    starts: list[float]
    struck: int


def random_shots(kind: str, count: int, seed: int) -> list[carom.Shot]:
    """Shots with random layouts and strikes on a carom or a pool table."""
    rng = np.random.default_rng(seed)
    shots: list[carom.Shot] = []
    while len(shots) < count:
        if kind == "carom":
            table, ids, high = "carom-10ft", ["cue", "red", "yellow"], (1.37, 2.79)
        else:
            number = int(rng.integers(3, 8))
            table, ids, high = "wpa-9ft", ["cue", *map(str, range(1, number))], (1.22, 2.49)
        places = rng.uniform((0.05, 0.05), high, (len(ids), 2))
        side, height = rng.uniform(-0.4, 0.4, 2)
        speed, azimuth = rng.uniform(1.0, 6.0), rng.uniform(0.0, 2.0 * math.pi)
        layout = {ball: (float(x), float(y)) for ball, (x, y) in zip(ids, places, strict=True)}
        try:
            strike = carom.Strike(speed, azimuth, side=side, height=height)
            shots.append(carom.Shot(table, layout, strike))
        except carom.InputError:
            # The balls overlap, or the cue has no room.
            continue
    return shots


def is_same(true: learn.TrueContact, found: learn.Contact) -> bool:
    """Whether a contact of the tracks has the balls and the rail of a true one."""
    if true.rail is not None:
        rail = found.rail is not None and found.rail.split("-")[0] == true.rail.split("-")[0]
        return rail and found.balls == true.balls
    return found.rail is None and len(found.balls) == 2 and set(found.balls) <= set(true.balls)


def score(shots: list[carom.Shot], camera: dict[str, float], seed: int = 5) -> Score:
    """Film shots with a camera, and compare the contacts of the tracks with the engine's."""
    rng = np.random.default_rng(seed)
    offsets = rng.uniform(0.2, 0.4, len(shots))
    made = learn.synthetic(shots, clock_offset=offsets, seed=seed, **camera)  # type: ignore[arg-type]
    within = max(0.03, 1.5 / camera["rate"])
    true = hits = false = unknown = struck = 0
    times, places, starts = [], [], []
    for index, shot in enumerate(made.tracks):
        found = learn.segment(shot, made.tracks.header)
        left = [contact for contact in found.contacts if contact.is_known]
        unknown += len(found.contacts) - len(left)
        for contact in made.contacts(index):
            near = [f for f in left if abs(f.time - contact.time) <= within and is_same(contact, f)]
            counts = contact.change >= LEAST_CHANGE
            true += counts
            if near:
                best = min(near, key=lambda f: abs(f.time - contact.time))
                left.remove(best)
                hits += counts
                times.append(abs(best.time - contact.time))
                places.append(
                    max(math.dist(best.place[ball], contact.place[ball]) for ball in best.balls)
                )
        false += len(left)
        struck += found.struck == "cue"
        if found.struck is not None:
            starts.append(abs(found.start - offsets[index]))
    return Score(true, hits, false, unknown, times, places, starts, struck)


def main() -> None:
    """Print the table."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    print(
        "| Table | Camera | Contacts | Found | False | Unknown | Time, ms | Place, mm | Start, ms |"
    )
    print("|---|---|---|---|---|---|---|---|---|")
    for kind, seed in (("carom", 1), ("pool", 2)):
        shots = random_shots(kind, count, seed)
        for camera in CAMERAS:
            s = score(shots, camera)
            words = ", ".join(f"{key} {value:g}" for key, value in camera.items())
            share = 100 * s.found / s.true
            errors = " | ".join(
                f"{1e3 * np.median(values):.1f} / {1e3 * np.quantile(values, 0.95):.1f}"
                for values in (s.times, s.places, s.starts)
            )
            print(
                f"| {kind} | {words} | {s.true} | {share:.1f} % | {s.false} | {s.unknown} | "
                f"{errors} |",
                flush=True,
            )
            if s.struck < count:
                print(f"{count - s.struck} of {count} struck balls are wrong", file=sys.stderr)


if __name__ == "__main__":
    main()
