"""The environments' names in Gymnasium's registry."""

from __future__ import annotations

import gymnasium

from carom import _core

# The versions of the tasks' environments. A version increases when the same actions give other
# results. A task that is not listed has version 1.
_VERSIONS = {
    "potting": 3,
    "eight-ball": 6,
    "nine-ball": 3,
    "ten-ball": 5,
    "straight-pool": 4,
    "snooker": 6,
    "three-cushion": 6,
    "sum-to-three": 3,
}


def _name(task: str) -> str:
    words = "".join(word.capitalize() for word in task.split("-"))
    return f"carom/{words}-v{_VERSIONS.get(task, 1)}"


# Every task, by the name of its environment.
ENVIRONMENTS = {_name(task): task for task in _core.tasks()}


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
