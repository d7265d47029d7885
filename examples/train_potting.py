"""Train an agent to pot a ball with PPO of stable-baselines3, and draw its learning curve.

    pip install 'carom[env,train]'
    python examples/train_potting.py                       # four million shots, some minutes
    python examples/train_potting.py --steps 300000        # a first impression

The cue ball and one object ball are placed at random on a nine-foot table. The agent has one shot
with a level cue and the Computational Olympiad's noise. It is compared with a random player and
with a geometric aimer, which aims at the ghost ball of the easiest pocket with the same noise. The
agent observes the positions of balls, pockets and ghost balls, and learns everything else.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import carom.env
import gymnasium
import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Actions, shape (n, 5), for observations, shape (n, 19).
Player = Callable[[Array], Array]

TABLE = "wpa-9ft"
#: Least and largest speed of the cue, m/s.
SPEED = (0.2, 8.0)
#: The geometric aimer's speed, m/s, and the increase per metre of the balls' path, 1/s. They are
#: about its best values with this noise: a slower ball drops more often but is thrown more.
PACE = (0.7, 0.4)
#: First seed of the shots of the evaluation; the seeds of the training are much smaller.
EVALUATION_SEED = 10**9
#: Number of shots of an evaluation during the training and at its end.
CHECKPOINT_SHOTS = 8192
FINAL_SHOTS = 100_000
#: Confidence level of all intervals.
LEVEL = 0.95
#: Largest number of environments of an evaluation.
EVALUATION_ENVS = 4096

#: PPO's settings. An episode is one shot, so there are no later rewards to discount.
LEARNING = {
    "n_steps": 4,
    "batch_size": 4096,
    "n_epochs": 8,
    "gamma": 0.0,
    "gae_lambda": 0.0,
    "device": "cpu",
}
#: The initial learning rate, and the share of it to which it falls linearly.
RATE = 3e-3
LEAST_RATE = 0.02
#: The networks of the agent and of its critic, and the log of the initial standard deviation of the
#: actions, for exploration.
POLICY = {"net_arch": {"pi": [128, 128], "vf": [64, 64]}, "log_std_init": -1.2}
#: Number of evaluations during the training.
CHECKPOINTS = 25


@dataclass(frozen=True)
class Geometry:
    """The geometry of balls and pockets, seen from behind the cue ball; lengths in m.

    The ghost ball of a pocket is the place of the cue ball from which the line of centres points to
    the pocket. All shapes except that of ``between`` are (n, 6), one column for each pocket.

    Attributes:
        between: Distance from the cue ball to the object ball, shape (n, 1).
        near: Distance from the cue ball to the ghost ball.
        far: Distance from the object ball to the pocket.
        fullness: Cosine of the cut angle: 1 for a straight pot, negative for an impossible one.
        across: Contact on the object ball on the way to the ghost ball, from its right edge (−1) to
            its left edge (1), in the units of the first action.
        into: Cosine of the angle between the ball's path and the pocket's axis.
    """

    between: Array
    near: Array
    far: Array
    fullness: Array
    across: Array
    into: Array


class Table:
    """The constants of the table: sizes and pockets, m."""

    def __init__(self, name: str = TABLE) -> None:
        shot = carom.Shot(name, {"cue": (0.5, 0.5)})
        geometry = shot.geometry()
        self.radius = float(shot.radius[0])
        self.size = np.array(geometry["size"])
        self.pockets = np.array([pocket["center"] for pocket in geometry["pockets"]])
        outwards = self.pockets - np.clip(self.pockets, 0, self.size)
        self.axes = outwards / np.linalg.norm(outwards, axis=1, keepdims=True)

    def geometry(self, observations: Array) -> Geometry:
        """The geometry of observations, shape (n, 19); meaningless after a ball is pocketed."""
        cue = 0.5 * (observations[:, 0:2] + 1) * self.size
        ball = 0.5 * (observations[:, 4:6] + 1) * self.size
        ahead, between = unit(ball - cue)
        to_pocket, far = unit(self.pockets - ball[:, None])
        to_ghost, near = unit(ball[:, None] - 2 * self.radius * to_pocket - cue[:, None])
        sine = ahead[:, None, 0] * to_ghost[..., 1] - ahead[:, None, 1] * to_ghost[..., 0]
        return Geometry(
            between=between[:, None],
            near=near,
            far=far,
            fullness=(to_pocket * to_ghost).sum(axis=2),
            across=np.clip(sine * between[:, None] / (2 * self.radius), -1, 1),
            into=(to_pocket * self.axes).sum(axis=2),
        )

    def view(self, observations: Array) -> Array:
        """The agent's input: positions of the balls and the geometry, shape (n, 35), float32."""
        lie = self.geometry(observations)
        places = observations[:, [0, 1, 4, 5]]
        columns = [places, lie.between, lie.near, lie.far, lie.fullness, lie.across, lie.into]
        return np.concatenate(columns, axis=1).astype(np.float32)


def unit(vectors: Array) -> tuple[Array, Array]:
    """Directions and lengths of vectors along the last axis."""
    length = np.maximum(np.linalg.norm(vectors, axis=-1), 1e-9)
    return vectors / length[..., None], length


def random_player(seed: int) -> Player:
    """A player with uniformly random actions."""
    random = np.random.default_rng(seed)
    return lambda rows: random.uniform(-1, 1, (len(rows), 5)).astype(np.float32)


def geometric_aimer(table: Table) -> Player:
    """A player that aims at the centre of the ghost ball, with a speed that grows with distance.

    It chooses the pocket by a full hit, a short distance and a small angle to the pocket's axis.
    """

    def play(rows: Array) -> Array:
        lie = table.geometry(rows)
        ease = lie.fullness / ((lie.near + 0.3) * (lie.far + 0.3))
        # A pocket with too thin a cut or too flat an angle is chosen only if all are like that.
        ease[(lie.fullness < 0.26) | (lie.into < 0.42)] -= 100.0
        best = np.arange(len(rows)), ease.argmax(axis=1)
        way = lie.near[best] + lie.far[best] / np.maximum(lie.fullness[best], 0.26)
        slow, fast = SPEED
        speed = np.clip(PACE[0] + PACE[1] * way, slow, fast)
        actions = np.zeros((len(rows), 5), dtype=np.float32)
        actions[:, 0] = lie.across[best]
        actions[:, 1] = 2 * np.sqrt((speed - slow) / (fast - slow)) - 1
        return actions

    return play


def make(num_envs: int, noise: float) -> Any:
    """The vector of environments for training and evaluation."""
    return gymnasium.make_vec(
        "carom/Potting-v3",
        num_envs=num_envs,
        table=TABLE,
        aim="relative",
        speed=SPEED,
        max_elevation=0.0,
        noise=carom.Noise.olympiad(noise),
    )


def evaluate(player: Player, noise: float, shots: int) -> carom.Chance:
    """The share of pots of ``player``; all players have the same layouts and the same noise."""
    envs = make(min(shots, EVALUATION_ENVS), noise)
    rows, _ = envs.reset(seed=EVALUATION_SEED)
    potted = played = 0
    while played < shots:
        rows, rewards, *_ = envs.step(player(rows))
        potted += int((rewards[: shots - played] > 0).sum())
        played = min(played + len(rewards), shots)
    return carom.Chance.of(potted, shots, LEVEL)


@dataclass(frozen=True)
class Checkpoint:
    """An evaluation during the training.

    Attributes:
        shots: Number of training shots before it.
        seconds: Duration of the training before it.
        chance: Share of pots.
    """

    shots: int
    seconds: float
    chance: carom.Chance


def train(arguments: argparse.Namespace, table: Table) -> tuple[Player, list[Checkpoint]]:
    """Train an agent and print its share of pots at intervals."""
    import torch
    from carom.env.sb3 import SB3VecEnv
    from stable_baselines3 import PPO
    from stable_baselines3.common.callbacks import BaseCallback

    envs = SB3VecEnv(make(arguments.envs, arguments.noise), view=table.view)
    model = PPO(
        "MlpPolicy",
        envs,
        learning_rate=lambda left: RATE * max(left, LEAST_RATE),
        policy_kwargs={"activation_fn": torch.nn.ReLU} | POLICY,
        seed=arguments.seed,
        **LEARNING,
    )

    def agent(rows: Array) -> Array:
        return np.asarray(model.predict(table.view(rows), deterministic=True)[0])

    checkpoints: list[Checkpoint] = []
    start = time.perf_counter()

    class Progress(BaseCallback):  # type: ignore[misc]
        def _on_rollout_start(self) -> None:
            if self.num_timesteps < len(checkpoints) * arguments.steps / CHECKPOINTS:
                return
            chance = evaluate(agent, arguments.noise, CHECKPOINT_SHOTS)
            checkpoints.append(Checkpoint(self.num_timesteps, time.perf_counter() - start, chance))
            print(
                f"{checkpoints[-1].shots:>12,} {checkpoints[-1].seconds:>8.0f}   {chance}",
                flush=True,
            )

        def _on_step(self) -> bool:
            return True

    print(f"{'shots':>12} {'seconds':>8}   potted")
    model.learn(arguments.steps, callback=Progress())
    seconds = time.perf_counter() - start
    chance = evaluate(agent, arguments.noise, CHECKPOINT_SHOTS)
    checkpoints.append(Checkpoint(model.num_timesteps, seconds, chance))
    if arguments.model:
        model.save(arguments.model)
    return agent, checkpoints


def draw(checkpoints: list[Checkpoint], players: dict[str, carom.Chance], noise: float) -> Figure:
    """Draw the learning curve, with the other players as lines."""
    from carom.picture import colors
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 4.6), facecolor=colors.PAPER, layout="constrained")
    ax = figure.add_subplot(facecolor=colors.PAPER)
    shots = [checkpoint.shots / 1e6 for checkpoint in checkpoints]
    low, middle, high = (
        [100 * value(checkpoint.chance) for checkpoint in checkpoints]
        for value in (lambda c: c.low, float, lambda c: c.high)
    )
    ax.fill_between(shots, low, high, color=colors.CLOTH, alpha=0.25, linewidth=0)
    ax.plot(shots, middle, color=colors.CLOTH, marker="o", markersize=3, label="agent")
    for (name, chance), color in zip(players.items(), (colors.TIP, colors.FAINT_INK), strict=True):
        ax.axhspan(100 * chance.low, 100 * chance.high, color=color, alpha=0.25, linewidth=0)
        ax.axhline(100 * float(chance), color=color, linestyle="--", label=name)
    ax.set_xlabel("training shots, millions")
    ax.set_ylabel("pots, %")
    ax.set_ylim(bottom=0)
    ax.set_xlim(left=0)
    ax.set_title(f"One ball at random, one shot; Olympiad noise × {noise:g}")
    ax.legend(frameon=False, loc="center right", bbox_to_anchor=(1.0, 0.35))
    ax.spines[["top", "right"]].set_visible(False)
    return figure


def main(words: list[str] | None = None) -> int:
    """Train, compare and draw."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--steps", type=int, default=4_000_000, help="number of training shots")
    parser.add_argument("--envs", type=int, default=4096, help="number of environments")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--noise", type=float, default=1.0, help="multiple of the Olympiad noise")
    parser.add_argument(
        "--shots", type=int, default=FINAL_SHOTS, help="shots of the final evaluation"
    )
    parser.add_argument("--picture", type=Path, default=Path("potting_learned.png"))
    parser.add_argument("--json", type=Path, help="write the numbers to this file")
    parser.add_argument("--model", type=Path, help="write the agent to this file")
    arguments = parser.parse_args(words)

    table = Table()
    others = {"geometric aimer": geometric_aimer(table), "random": random_player(arguments.seed)}
    agent, checkpoints = train(arguments, table)
    chances = {
        name: evaluate(player, arguments.noise, arguments.shots)
        for name, player in ({"agent": agent} | others).items()
    }
    print(f"\n{arguments.shots:,} new shots, with {LEVEL:.0%} confidence intervals:")
    for name, chance in chances.items():
        print(f"{name:>20}   {chance}")
    beside = {name: chances[name] for name in others}
    figure = draw(checkpoints, beside, arguments.noise)
    figure.savefig(arguments.picture, dpi=150, metadata={"Software": None})
    if arguments.json:
        record = {
            "checkpoints": [asdict(checkpoint) for checkpoint in checkpoints],
            "players": {name: asdict(chance) for name, chance in chances.items()},
        }
        arguments.json.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
