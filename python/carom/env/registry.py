"""The environments' names in Gymnasium's registry."""

from __future__ import annotations

import gymnasium

# The version increases when the same actions give other results.
ENVIRONMENTS = {
    "carom/Potting-v3": "potting",
    "carom/EightBall-v6": "eight-ball",
    "carom/NineBall-v3": "nine-ball",
    "carom/TenBall-v5": "ten-ball",
    "carom/StraightPool-v4": "straight-pool",
    "carom/Snooker-v6": "snooker",
    "carom/ThreeCushion-v6": "three-cushion",
    "carom/SumToThree-v3": "sum-to-three",
}


def register() -> None:
    """Register all environments that are not registered yet."""
    for name, task in ENVIRONMENTS.items():
        if name not in gymnasium.registry:
            gymnasium.register(
                id=name,
                entry_point="carom.env.single:CaromEnv",
                vector_entry_point="carom.env.vector:CaromVectorEnv",
                kwargs={"task": task},
            )
