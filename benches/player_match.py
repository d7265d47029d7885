"""Players learned from shots whose intentions are unknown.

    python benches/player_match.py [--players N] [--shots N]

A synthetic player aims at the middle of the azimuths that pot a ball, with a speed and a spin that
the estimate does not know. One shot in ten is not meant to pot: its azimuth is random. The result
is stored in ``benches/results/player_match.json``.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom import learn
from carom.bench import report
from carom.learn.player_errors import NUMBERS, SCALE

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "player_match.json"
#: Least share of a beginner's σ.
LEAST = 0.15
#: Share of the shots that are not meant to pot.
OTHERS = 0.1


def main() -> int:
    """Measures, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--players", type=int, default=20)
    parser.add_argument("--shots", type=int, default=40)
    options = parser.parse_args()
    result: dict[str, Any] = report.where() | vars(options)
    began = time.perf_counter()
    random = np.random.default_rng(1)
    sigma = np.array(SCALE) * np.exp(random.uniform(math.log(LEAST), 0.0, (options.players, 5)))
    played, by_shot = [], {}
    for player, own in enumerate(sigma):
        for index in range(options.shots):
            name = f"{player:03}-{index}"
            played.append(learn.PlayedStrike.exact(name, match_shot(random, own)))
            by_shot[name] = f"{player:03}"
    found = learn.players(played, None, by_shot, pooled=False, draws=400)
    people = [found[name] for name in sorted(found)]
    ends = np.array([[one.interval(name) for name in NUMBERS] for one in people])
    inside = (ends[..., 0] < sigma) & (sigma < ends[..., 1])
    result["covered"] = dict(zip(NUMBERS, inside.mean(axis=0).tolist(), strict=True))
    result["says_as_much_as"] = dict(
        zip(NUMBERS, np.median([one.information for one in people], axis=0).tolist(), strict=True)
    )
    result["azimuth"] = azimuths(people, sigma[:, 1])
    result["background"] = float(np.mean([one.background for one in people]))
    result["seconds"] = round(time.perf_counter() - began)
    print(json.dumps(result, indent=1))
    STORED.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


def azimuths(people: list[learn.PlayerPosterior], sigma: Any) -> dict[str, Any]:
    """For every choice about the intentions: coverage, and the median of found over true σ."""
    rows = {}
    low, high = [], []
    for index, choice in enumerate(people[0].choices):
        ends = np.array([one.choices[index].sigma[1] for one in people])
        inside = (ends[:, 0] < sigma) & (sigma < ends[:, 2])
        rows[choice.name] = {
            "covered": float(inside.mean()),
            "found_over_true": float(np.median(ends[:, 1] / sigma)),
        }
        low.append(ends[:, 0])
        high.append(ends[:, 2])
    inside = (np.min(low, axis=0) < sigma) & (sigma < np.max(high, axis=0))
    rows["all intervals together"] = {"covered": float(inside.mean())}
    return rows


def middle_of_window(shot: carom.Shot, aim: float) -> float | None:
    """Middle of the azimuths about ``aim`` that pot ball 1; None if they are not one piece."""
    azimuth = aim + np.linspace(-0.06, 0.06, 241)
    pocket = shot.batch(azimuth=azimuth).pocket
    pots = (pocket[:, 1] >= 0) & (pocket[:, 0] == -1)
    edges = np.flatnonzero(np.diff(np.concatenate(([0], pots, [0])).astype(int)))
    if len(edges) != 2 or edges[0] == 0 or edges[1] == len(azimuth):
        return None
    return float(azimuth[edges[0] : edges[1]].mean())


def match_shot(random: np.random.Generator, sigma: Any) -> carom.Shot:
    """A shot as it was played."""
    while True:
        ball = random.uniform((0.3, 1.4), (0.97, 2.2))
        cue = random.uniform((0.2, 0.3), (1.07, 0.9))
        aim = math.atan2(*(ball - cue)[::-1])
        meant = carom.Strike(
            float(np.exp(random.uniform(0.3, 1.2))),
            aim,
            side=random.uniform(-0.2, 0.2),
            height=random.uniform(-0.2, 0.2),
            elevation=random.uniform(0.04, 0.1),
        )
        shot = carom.Shot("wpa-9ft", {"cue": cue.tolist(), "1": ball.tolist()}, meant)
        middle = middle_of_window(shot, aim)
        if middle is None:
            continue
        if random.random() < OTHERS:
            middle += random.uniform(-0.15, 0.15)
        noise = carom.Noise(
            speed_relative=sigma[0],
            azimuth=sigma[1],
            elevation=sigma[2],
            side_m=sigma[3],
            height_m=sigma[4],
        )
        return noise.variant(shot.with_strike(azimuth=middle), seed=int(random.integers(2**32)))


if __name__ == "__main__":
    sys.exit(main())
