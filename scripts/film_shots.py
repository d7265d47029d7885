"""Writes tracks/three_cushion_film.csv.gz: six simulated three-cushion shots, as a camera saw them.

    python scripts/film_shots.py

The columns and the frame are those of a public match: shot, ball, t_s, x_m, y_m, with x along the
length. Pictures come 50 times a second with errors of 1 mm, and a sample of a ball is stored only
when it has moved by 15 mm. Rolling resistance and restitution of the rails differ from those of the
preset ``carom``: ``TRUTH`` has them.
"""

from __future__ import annotations

import csv
import gzip
import io
import sys
from pathlib import Path

import carom
import numpy as np
from carom import learn

PATH = Path(__file__).resolve().parents[1] / "tracks" / "three_cushion_film.csv.gz"
#: Rolling resistance a of a + b·v, m/s², with the b of the preset; restitution e(0) of the rails.
TRUTH = {"rolling.a": 0.048, "cushion.restitution.a": 0.88}
ROLLING_B = 0.0142
SHOTS, SEED = 6, 16


def film() -> learn.SyntheticTracks:
    """Tracks of random shots of ball 1 with side and a raised cue."""
    rng = np.random.default_rng(SEED)
    shots = [_shot(rng) for _ in range(SHOTS)]
    clock = rng.uniform(0.0, 0.04, SHOTS)
    return learn.synthetic(shots, sigma=0.001, least_move=0.015, clock_offset=clock, seed=SEED)


def _shot(rng: np.random.Generator) -> carom.Shot:
    # One ball in each third of the table, so that no two of them overlap.
    thirds = rng.permutation(3)
    along = 0.1 + 0.92 * thirds + rng.uniform(0.0, 0.8, 3)
    across = rng.uniform(0.1, 1.32, 3)
    strike = {
        "ball": "1",
        "speed": rng.uniform(1.6, 2.8),
        "azimuth": rng.uniform(-np.pi, np.pi),
        "elevation_deg": rng.uniform(2.0, 6.0),
        "side": rng.uniform(-0.35, 0.35),
        "height": rng.uniform(-0.2, 0.3),
    }
    physics = {
        "base": "carom",
        "cloth": {"rolling_friction": carom.rolling_bands(TRUTH["rolling.a"], ROLLING_B)},
        "cushion": {"restitution": {"a": TRUTH["cushion.restitution.a"]}},
    }
    balls = {str(i + 1): (float(across[i]), float(along[i])) for i in range(3)}
    return carom.Shot("carom-10ft", balls, strike, physics=physics)


def to_bytes(tracks: learn.Tracks) -> bytes:
    """The samples as gzipped CSV, the places to 10 µm and the times to 0.1 ms."""
    frame = learn.FileFrame(x="length")
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(("shot", "ball", "t_s", "x_m", "y_m"))
    for shot in tracks:
        for ball, track in shot.balls.items():
            places = frame.to_file(track.position, tracks.header.table_size)
            for time, (x, y) in zip(track.time, places, strict=True):
                rows.writerow((shot.name, ball, f"{time:.4f}", f"{x:.5f}", f"{y:.5f}"))
    # Without the time and the name, so that equal tracks are equal files.
    return gzip.compress(text.getvalue().encode(), mtime=0)


def main() -> int:
    """Writes the file."""
    PATH.write_bytes(to_bytes(film().tracks))
    print(PATH, file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
