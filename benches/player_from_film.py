"""A player learned from a film: synthetic tracks, their strikes, the player's errors.

    python benches/player_from_film.py [--players N] [--shots N]

Synthetic players repeat a drill on a carom table, and a camera with a noise of 1 mm films it at 50
pictures a second. The strikes are found on the true table. The result is stored in
``benches/results/player_from_film.json``.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from copy import deepcopy
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom import learn
from carom.bench import report
from carom.learn import levenberg
from carom.learn.observation import Observation, observe
from carom.learn.player_errors import NUMBERS, UNITS, PlayedStrike, vector_of
from carom.learn.strike_search import STEPS, StrikeProblem, residuals
from carom.learn.table_model import Frame
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "player_from_film.json"
LAYOUT = {"1": (0.5, 0.6), "2": (0.9, 2.2), "3": (0.3, 1.8)}
#: A search that misses the film by more than this, m, has failed.
MISSED = 0.005
#: Standard deviation of a strike about the intended one in the pull of ``near_intention``: azimuth
#: (rad), speed (m/s), side, height (ball radii), elevation (rad), clock (s).
PULL = (0.04, 1.0, 0.4, 0.4, 0.14, 0.05)
#: Noise of the camera, m.
NOISE = 0.001
#: Step of a difference quotient by a place, m.
MOVE = 1e-5
#: Standard deviation of what the film does not measure, in the same unit.
LOOSE = 10.0

Floats = NDArray[np.float64]


def main() -> int:
    """Measures, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--players", type=int, default=5)
    parser.add_argument("--shots", type=int, default=50)
    options = parser.parse_args()
    result: dict[str, Any] = report.where() | {"shots": options.shots, "players": []}
    random = np.random.default_rng(3)
    for seed in range(options.players):
        result["players"].append(player(random, options.shots, seed))
        print(json.dumps(result["players"][-1]), flush=True)
    STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


def player(random: np.random.Generator, shots: int, seed: int) -> dict[str, Any]:
    """True σ of a player, and what was learned, in percent, degrees and millimetres."""
    began = time.perf_counter()
    share = np.exp(random.uniform(math.log(0.15), 0.0, 5))
    sigma = share * (0.2, math.radians(0.6), math.radians(2.0), 0.003, 0.003)
    strike = carom.Strike(
        ball="1", speed=1.8, azimuth=1.2, side=0.15, height=0.15, elevation=math.radians(6.0)
    )
    drill = carom.Shot(
        "carom-10ft", LAYOUT, {**strike.to_dict(), "miscue": "report", "obstruction": "report"}
    )
    noise = carom.Noise(
        speed_relative=sigma[0],
        azimuth=sigma[1],
        elevation=sigma[2],
        side_m=sigma[3],
        height_m=sigma[4],
    )
    true = [noise.variant(drill, index, seed=seed) for index in range(shots)]
    film = learn.synthetic(true, clock_offset=0.3, seed=seed)
    played = measured(film.tracks, drill)
    found = learn.player(played, drill, name=str(seed))
    exact = learn.player(true, drill, name=str(seed))
    played_error = np.array(
        [
            one.vector - vector_of(shot)
            for one, shot in zip(played, film_order(true, played), strict=True)
        ]
    )
    rows = {}
    for index, name in enumerate(NUMBERS):
        _, factor = UNITS[name]
        ends = [round(factor * end, 3) for end in found.interval(name)]
        rows[name] = {
            "true": round(factor * float(sigma[index]), 3),
            "interval": ends,
            "interval_of_exact_strikes": [round(factor * e, 3) for e in exact.interval(name)],
            "measured_to": round(factor * float(found.measured[index]), 3),
            "error_of_the_strikes": round(
                factor * float(np.median(np.abs(played_error[:, index]))), 3
            ),
            "says_as_much_as": round(float(found.information[index]), 1),
        }
    return {
        "found": len(played),
        "background": round(found.background, 3),
        "numbers": rows,
        "seconds": round(time.perf_counter() - began),
    }


def film_order(true: list[carom.Shot], played: list[PlayedStrike]) -> list[carom.Shot]:
    """The true shots of the strikes that were found."""
    return [true[int(one.name) - 1] for one in played]


def measured(tracks: learn.Tracks, drill: carom.Shot) -> list[PlayedStrike]:
    """The strikes of a film, with the covariances of least squares."""
    played = []
    found = {strike.name: strike for strike in learn.strikes(tracks, starts=24)}
    for shot in tracks:
        if shot.name in found and found[shot.name].rmse < MISSED:
            one = near_intention(shot, found[shot.name], drill)
            if one is not None:
                played.append(one)
    return played


def near_intention(
    shot: learn.TrackedShot, found: learn.FilmedStrike, drill: carom.Shot
) -> PlayedStrike | None:
    """The strike that explains a film as well as any and is near the intended one.

    Elevation, azimuth and tip offset trade off along a curve. Least squares with a weak pull to the
    intended strike find the part of the curve where the player's errors are. The pull is taken off
    again, so that the result is the likelihood there.
    """
    observed = observe(shot)
    scale, steps = np.array(PULL), np.array(STEPS)
    target = vector_in_search(drill, found.clock)
    variance = max(found.rmse**2 / 2.0, 1e-8)
    at = StrikeProblem(observed, found.shot, Frame()).residuals(observed.end)

    def pulled(vectors: Floats) -> Floats:
        # The last residual is the preference of the search for a flat cue. It is not a measurement.
        pull = math.sqrt(variance) * (vectors - target) / scale
        return np.concatenate((at(vectors)[:, :-1], pull), axis=1)

    starts = np.array((target, vector_in_search(found.shot, found.clock)))
    vectors, costs = levenberg.refine(pulled, starts, steps, iterations=30)
    if not np.isfinite(costs).any():
        return None
    vector = vectors[costs.argmin()]
    here, ahead = levenberg.derivatives(at, vector[None], steps)
    _, behind = levenberg.derivatives(at, vector[None], -steps)
    # Where a contact begins or ends between the two, one difference quotient is far too large.
    ahead, behind = ahead[0, :, :-1], -behind[0, :, :-1]
    slopes = np.where(np.abs(ahead) < np.abs(behind), ahead, behind) / steps[:, None]
    rest = here[0, :-1]
    curvature = slopes @ slopes.T / variance + np.diag(1.0 / (LOOSE * scale) ** 2)
    covariance = np.linalg.inv(curvature)
    vector = vector - covariance @ (slopes @ rest) / variance
    lead = covariance @ (slopes @ by_place(found, observed, vector).T) / variance
    covariance = covariance + lead @ lead.T * place_variance(observed)
    radius = float(drill.radius[0])
    order = [1, 0, 4, 2, 3]
    unit = np.array((1.0 / target[1], 1.0, 1.0, radius, radius))
    moved = vector_of(drill) + (vector - target)[order] * unit
    moved[0] = math.log(max(vector[1], 0.1 * target[1]))
    spread = covariance[np.ix_(order, order)] * np.outer(unit, unit)
    if not np.isfinite(spread).all():
        return None
    return PlayedStrike(found.name, found.shot, moved, spread)


def by_place(found: learn.FilmedStrike, observed: Observation, vector: Floats) -> Floats:
    """Derivatives of the residuals by the place of rest of the struck ball, shape (2, m)."""
    file = found.shot.to_dict()
    shots = [found.shot]
    for axis in (0, 1):
        moved = deepcopy(file)
        ball = next(ball for ball in moved["balls"] if ball["id"] == observed.struck)
        ball["position"][axis] += MOVE
        shots.append(carom.Shot.from_dict(moved))
    here, *there = residuals(
        shots, np.repeat(vector[None], 3, axis=0), observed.until(observed.end), Frame()
    )
    return np.array([(one - here) / MOVE for one in there])


def place_variance(observed: Observation) -> float:
    """Variance of a coordinate of the place of rest, m²: that of the median of its pictures."""
    ball = observed.samples[observed.struck]
    count = int((ball.time - ball.time[0] < observed.first_move).sum())
    return math.pi / 2.0 * NOISE**2 / max(count - 1, 1)


def vector_in_search(shot: carom.Shot, clock: float) -> Floats:
    """The strike of a shot in the order of the search."""
    strike = shot.strike
    assert strike is not None
    assert strike.elevation is not None
    return np.array(
        (strike.azimuth, strike.speed, strike.side, strike.height, strike.elevation, clock)
    )


if __name__ == "__main__":
    sys.exit(main())
