"""The environments' names in Gymnasium's registry."""

from __future__ import annotations

import gymnasium

# A version goes up when the same actions give other results.
ENVIRONMENTS = {
    "carom/Potting-v0": "potting",
    "carom/EightBall-v1": "eight-ball",
    "carom/NineBall-v0": "nine-ball",
    "carom/TenBall-v0": "ten-ball",
    "carom/StraightPool-v0": "straight-pool",
    "carom/Snooker-v1": "snooker",
    "carom/ThreeCushion-v1": "three-cushion",
    "carom/SumToThree-v0": "sum-to-three",
}


def register() -> None:
    """Registers them, once."""
    for name, task in ENVIRONMENTS.items():
        if name not in gymnasium.registry:
            gymnasium.register(
                id=name,
                entry_point="carom.env.single:CaromEnv",
                vector_entry_point="carom.env.vector:CaromVectorEnv",
                kwargs={"task": task},
            )
