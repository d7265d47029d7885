"""A league for self-play: a policy learns nine-ball from its own snapshots, rated as they come.

    pip install 'carom[env]'
    python examples/league.py                             # six snapshots, some minutes
    python examples/league.py --snapshots 2 --steps 5     # a first impression

The policy is linear in the geometry of the lowest ball. It begins with full hits at one speed, and
learns by evolution strategies (Salimans, Ho, Chen, Sidor & Sutskever 2017): every environment of a
vector has changed weights of its own, and plays an earlier snapshot. Every snapshot becomes a
player, and plays matches with those before it; Elo ratings (K = 32) follow from their results.
"""

from __future__ import annotations

import argparse
import tempfile
from functools import partial
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
GAME = "nine-ball"
SETTINGS: dict[str, Any] = {"aim": "relative", "speed": (0.2, 8.0)}
NOISE = carom.Noise.preset("club")
_SHOT = carom.Shot("wpa-9ft", {"cue": (0.5, 0.5)})
SIZE, RADIUS = np.array(_SHOT.geometry()["size"]), float(_SHOT.radius[0])
POCKETS = np.array([pocket["center"] for pocket in _SHOT.geometry()["pockets"]])
#: Weights of the aim (ghost ball, constant), the speed (constant, distances to and from the ball,
#: cut) and the choice of the pocket (cut, distance).
FIRST = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, -0.3])
#: Environments of a generation, their steps, the size of a change of the weights, the step size.
ENVIRONMENTS, STEPS, CHANGE, RATE = 256, 12, 0.2, 0.3


def act(weights: Array, rows: Array) -> Array:
    """Actions, shape (n, 7), for observations; weights have the shape (8,) or (n, 8)."""
    w = np.broadcast_to(weights, (len(rows), len(FIRST))).T
    balls, every = rows[:, :40].reshape(-1, 10, 4), np.arange(len(rows))
    lowest = np.argmax(balls[:, 1:, 2] > 0.5, axis=1) + 1
    cue = 0.5 * (balls[:, 0, :2] + 1) * SIZE
    ball = 0.5 * (balls[every, lowest, :2] + 1) * SIZE
    ahead, near = unit(ball - cue)
    to_pocket, far = unit(POCKETS - ball[:, None])
    to_ghost, _ = unit(ball[:, None] - 2 * RADIUS * to_pocket - cue[:, None])
    cut = (to_pocket * to_ghost).sum(axis=2)
    sine = ahead[:, None, 0] * to_ghost[..., 1] - ahead[:, None, 1] * to_ghost[..., 0]
    ghost = np.clip(sine * near[:, None] / (2 * RADIUS), -1, 1)
    best = every, (w[6, :, None] * cut + w[7, :, None] * far).argmax(axis=1)
    actions = np.zeros((len(rows), 7), dtype=np.float32)
    actions[:, 0] = w[0] * ghost[best] + w[1]
    actions[:, 1] = w[2] + w[3] * near + w[4] * far[best] + w[5] * (1 - cut[best])
    return actions


def unit(vectors: Array) -> tuple[Array, Array]:
    """Directions and lengths of vectors along the last axis."""
    length = np.maximum(np.linalg.norm(vectors, axis=-1), 1e-9)
    return vectors / length[..., None], length


def learn(weights: Array, rival: Array, generations: int, seed: int) -> Array:
    """The weights after some generations against an earlier snapshot."""
    rng, count = np.random.default_rng(seed), ENVIRONMENTS // 2
    play: dict[str, Any] = {"opponent": partial(act, rival), "seat": "alternate"}
    play["rewards"] = carom.env.Rewards(win=1.0, pot=0.5, foul=-0.2)
    start: dict[str, Any] = {"num_envs": ENVIRONMENTS, "balls": (2, 4), "noise": NOISE}
    envs: Any = gymnasium.make_vec("carom/NineBall-v3", **start, **play, **SETTINGS)
    for generation in range(generations):
        half = rng.normal(size=(count, len(FIRST)))
        changes = CHANGE * np.concatenate([half, -half])
        # Both signs of a change play the same starts.
        seeds = (1000 * seed + generation) * ENVIRONMENTS + np.arange(ENVIRONMENTS) % count
        rows, _ = envs.reset(seed=seeds.tolist())
        gained = np.zeros(ENVIRONMENTS)
        for _ in range(STEPS):
            rows, reward, *_ = envs.step(act(weights + changes, rows))
            gained += reward
        better = (gained[:count] - gained[count:]) / (gained.std() + 1e-9)
        weights = weights + RATE * (better[:, None] * half).mean(axis=0)
    return weights


def share(one: int, other: int, snapshots: list[Array], pairs: int) -> float:
    """The share of the points of a snapshot in a match with another one."""
    first, second = (
        carom.env.as_player(partial(act, snapshots[k]), GAME, name=f"snapshot-{k}", **SETTINGS)
        for k in (one, other)
    )
    rules: dict[str, Any] = {"game": GAME, "noise": NOISE, "patience": 30, "secret": "ab" * 32}
    with tempfile.TemporaryDirectory() as out:
        return carom.play_match(first, second, out=out, pairs=pairs, **rules).score.share


def main(arguments: list[str] | None = None) -> list[float]:
    """Run a league, and return the ratings of its snapshots."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--snapshots", type=int, default=6, help="number of new snapshots")
    parser.add_argument("--steps", type=int, default=30, help="generations between snapshots")
    parser.add_argument("--pairs", type=int, default=5, help="pairs of frames of a match")
    given = parser.parse_args(arguments)
    snapshots, ratings = [FIRST], [0.0]
    for k in range(1, given.snapshots + 1):
        snapshots.append(learn(snapshots[-1], snapshots[(k - 1) // 2], given.steps, seed=k))
        ratings.append(ratings[-1])
        for rival in sorted({0, (k - 1) // 2, k - 1}):
            won = share(k, rival, snapshots, given.pairs)
            step = 64 * given.pairs * (won - 1 / (1 + 10 ** ((ratings[rival] - ratings[k]) / 400)))
            ratings[k], ratings[rival] = ratings[k] + step, ratings[rival] - step
            print(f"{k} against {rival}: {100 * won:.0f} %, rating {ratings[k]:+.0f}", flush=True)
    print("ratings: " + ", ".join(f"{rating:+.0f}" for rating in ratings))
    return ratings


if __name__ == "__main__":
    main()
