"""Trains an agent to pot a ball, by PPO of stable-baselines3, and draws how it learned.

    pip install 'carom[env,train]'
    python examples/train_potting.py                       # four million shots: some minutes
    python examples/train_potting.py --steps 300000        # a first impression

The cue ball and one object ball lie anywhere on a nine-foot table; the agent has one shot, with a
level cue that errs by the Computational Olympiad's values. Beside it play a player at random and a
geometric aimer, who hits the ghost ball of the easiest pocket and errs as much. The agent is told
where balls, pockets and ghost balls are, and has to find out all the rest.
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
#: The geometric aimer's speed, m/s, and what it adds for a metre that the balls have to go, 1/s:
#: about the best there is for it at these errors. Slow balls drop more often, and are thrown more.
PACE = (0.7, 0.4)
#: Seeds of the shots that players are judged by; those of training are far below.
JUDGED_FROM = 10**9
#: Shots that tell how far the agent is, and that judge the players at the end.
SHOTS_ON_THE_WAY = 8192
SHOTS_AT_THE_END = 100_000
#: Confidence of all intervals.
LEVEL = 0.95
#: Environments stepped at once where players are judged.
ROW = 4096

#: PPO's settings; an episode is one shot, so nothing comes after the reward.
LEARNING = {
    "n_steps": 4,
    "batch_size": 4096,
    "n_epochs": 8,
    "gamma": 0.0,
    "gae_lambda": 0.0,
    "device": "cpu",
}
#: The learning rate at the start; it falls in a straight line, to this part of it.
RATE = 3e-3
LEAST_RATE = 0.02
#: The networks of the agent and of its critic, and how far the agent strays at first to explore:
#: log of the standard deviation.
POLICY = {"net_arch": {"pi": [128, 128], "vf": [64, 64]}, "log_std_init": -1.2}
#: Evaluations on the way.
LOOKS = 25


@dataclass(frozen=True)
class Lie:
    """How balls and pockets lie, as who stands behind the cue ball sees it; lengths in m.

    The ghost ball of a pocket is where the cue ball must be for the line of centres to meet the
    pocket. All shapes are (n, 6), one column for each pocket, but that of ``between``.

    Attributes:
        between: From the cue ball to the object ball, shape (n, 1).
        near: From the cue ball to the ghost ball,
        far: and from the object ball to the pocket.
        fullness: Cosine of the cut: 1 for a straight pot, negative for an impossible one.
        across: Where the object ball is hit on the way to the ghost ball, from its right edge (−1)
            to its left edge (1), as the first action has it.
        into: Cosine of the angle at which the pocket is entered.
    """

    between: Array
    near: Array
    far: Array
    fullness: Array
    across: Array
    into: Array


class Table:
    """What does not change: sizes and pockets, m."""

    def __init__(self, name: str = TABLE) -> None:
        shot = carom.Shot(name, {"cue": (0.5, 0.5)})
        geometry = shot.geometry()
        self.radius = float(shot.radius[0])
        self.size = np.array(geometry["size"])
        self.pockets = np.array([pocket["center"] for pocket in geometry["pockets"]])
        outwards = self.pockets - np.clip(self.pockets, 0, self.size)
        self.axes = outwards / np.linalg.norm(outwards, axis=1, keepdims=True)

    def lie(self, observations: Array) -> Lie:
        """The geometry of observations, shape (n, 19); without meaning where a ball is gone."""
        cue = 0.5 * (observations[:, 0:2] + 1) * self.size
        ball = 0.5 * (observations[:, 4:6] + 1) * self.size
        ahead, between = unit(ball - cue)
        to_pocket, far = unit(self.pockets - ball[:, None])
        to_ghost, near = unit(ball[:, None] - 2 * self.radius * to_pocket - cue[:, None])
        sine = ahead[:, None, 0] * to_ghost[..., 1] - ahead[:, None, 1] * to_ghost[..., 0]
        return Lie(
            between=between[:, None],
            near=near,
            far=far,
            fullness=(to_pocket * to_ghost).sum(axis=2),
            across=np.clip(sine * between[:, None] / (2 * self.radius), -1, 1),
            into=(to_pocket * self.axes).sum(axis=2),
        )

    def view(self, observations: Array) -> Array:
        """What the agent sees: the balls' places and how all lies, shape (n, 35), float32."""
        lie = self.lie(observations)
        places = observations[:, [0, 1, 4, 5]]
        columns = [places, lie.between, lie.near, lie.far, lie.fullness, lie.across, lie.into]
        return np.concatenate(columns, axis=1).astype(np.float32)


def unit(vectors: Array) -> tuple[Array, Array]:
    """Directions and lengths of vectors along the last axis."""
    length = np.maximum(np.linalg.norm(vectors, axis=-1), 1e-9)
    return vectors / length[..., None], length


def random_player(seed: int) -> Player:
    """Hits the ball somewhere, somehow."""
    random = np.random.default_rng(seed)
    return lambda rows: random.uniform(-1, 1, (len(rows), 5)).astype(np.float32)


def geometric_aimer(table: Table) -> Player:
    """Hits the ghost ball in its centre, faster the longer the way.

    Of the pockets it plays the one that is full, near, and open to the ball's way.
    """

    def play(rows: Array) -> Array:
        lie = table.lie(rows)
        ease = lie.fullness / ((lie.near + 0.3) * (lie.far + 0.3))
        # Too thin a cut, too flat to the pocket: better any other.
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
    """The vector of environments that all play in."""
    return gymnasium.make_vec(
        "carom/Potting-v0",
        num_envs=num_envs,
        table=TABLE,
        aim="relative",
        speed=SPEED,
        max_elevation=0.0,
        noise=carom.Noise.olympiad(noise),
    )


def judge(player: Player, noise: float, shots: int) -> carom.Chance:
    """How often ``player`` pots; every player is given the same layouts and the same errors."""
    envs = make(min(shots, ROW), noise)
    rows, _ = envs.reset(seed=JUDGED_FROM)
    potted = played = 0
    while played < shots:
        rows, rewards, *_ = envs.step(player(rows))
        potted += int((rewards[: shots - played] > 0).sum())
        played = min(played + len(rewards), shots)
    return carom.Chance.of(potted, shots, LEVEL)


@dataclass(frozen=True)
class Look:
    """How far the agent was.

    Attributes:
        shots: Played in training,
        seconds: since its start.
        chance: How often it potted.
    """

    shots: int
    seconds: float
    chance: carom.Chance


def train(arguments: argparse.Namespace, table: Table) -> tuple[Player, list[Look]]:
    """Trains an agent; prints how far it is now and then."""
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

    looks: list[Look] = []
    start = time.perf_counter()

    class Progress(BaseCallback):  # type: ignore[misc]
        def _on_rollout_start(self) -> None:
            if self.num_timesteps < len(looks) * arguments.steps / LOOKS:
                return
            chance = judge(agent, arguments.noise, SHOTS_ON_THE_WAY)
            looks.append(Look(self.num_timesteps, time.perf_counter() - start, chance))
            print(f"{looks[-1].shots:>12,} {looks[-1].seconds:>8.0f}   {chance}", flush=True)

        def _on_step(self) -> bool:
            return True

    print(f"{'shots':>12} {'seconds':>8}   potted")
    model.learn(arguments.steps, callback=Progress())
    seconds = time.perf_counter() - start
    chance = judge(agent, arguments.noise, SHOTS_ON_THE_WAY)
    looks.append(Look(model.num_timesteps, seconds, chance))
    if arguments.model:
        model.save(arguments.model)
    return agent, looks


def draw(looks: list[Look], players: dict[str, carom.Chance], noise: float) -> Figure:
    """The learning curve with the other players' chances as lines."""
    from carom.picture import colors
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 4.6), facecolor=colors.PAPER, layout="constrained")
    ax = figure.add_subplot(facecolor=colors.PAPER)
    shots = [look.shots / 1e6 for look in looks]
    low, middle, high = (
        [100 * value(look.chance) for look in looks]
        for value in (lambda c: c.low, float, lambda c: c.high)
    )
    ax.fill_between(shots, low, high, color=colors.CLOTH, alpha=0.25, linewidth=0)
    ax.plot(shots, middle, color=colors.CLOTH, marker="o", markersize=3, label="agent")
    for (name, chance), color in zip(players.items(), (colors.TIP, colors.FAINT_INK), strict=True):
        ax.axhspan(100 * chance.low, 100 * chance.high, color=color, alpha=0.25, linewidth=0)
        ax.axhline(100 * float(chance), color=color, linestyle="--", label=name)
    ax.set_xlabel("shots played in training, millions")
    ax.set_ylabel("pots, %")
    ax.set_ylim(bottom=0)
    ax.set_xlim(left=0)
    ax.set_title(f"One ball anywhere, one shot; errors of the Olympiad × {noise:g}")
    ax.legend(frameon=False, loc="center right", bbox_to_anchor=(1.0, 0.35))
    ax.spines[["top", "right"]].set_visible(False)
    return figure


def main(words: list[str] | None = None) -> int:
    """Trains, compares, draws."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--steps", type=int, default=4_000_000, help="shots of training")
    parser.add_argument("--envs", type=int, default=4096, help="environments stepped at once")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--noise", type=float, default=1.0, help="times the Olympiad's errors")
    parser.add_argument("--shots", type=int, default=SHOTS_AT_THE_END, help="to judge a player by")
    parser.add_argument("--picture", type=Path, default=Path("potting_learned.png"))
    parser.add_argument("--json", type=Path, help="where the figures go, if anywhere")
    parser.add_argument("--model", type=Path, help="where the agent goes, if anywhere")
    arguments = parser.parse_args(words)

    table = Table()
    others = {"geometric aimer": geometric_aimer(table), "random": random_player(arguments.seed)}
    agent, looks = train(arguments, table)
    chances = {
        name: judge(player, arguments.noise, arguments.shots)
        for name, player in ({"agent": agent} | others).items()
    }
    print(f"\n{arguments.shots:,} other shots, with intervals of {LEVEL:.0%}:")
    for name, chance in chances.items():
        print(f"{name:>20}   {chance}")
    beside = {name: chances[name] for name in others}
    figure = draw(looks, beside, arguments.noise)
    figure.savefig(arguments.picture, dpi=150, metadata={"Software": None})
    if arguments.json:
        record = {
            "looks": [asdict(look) for look in looks],
            "players": {name: asdict(chance) for name, chance in chances.items()},
        }
        arguments.json.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
