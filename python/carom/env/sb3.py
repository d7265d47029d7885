"""The vector of environments as stable-baselines3 has it: ``pip install 'carom[train]'``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium.spaces import Box
from gymnasium.vector import AutoresetMode, VectorEnv

from carom.errors import InputError

try:
    from stable_baselines3.common.vec_env import VecEnv
except ImportError as error:
    raise ImportError(
        "carom.env.sb3 needs stable-baselines3: pip install 'carom[train]'"
    ) from error

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]


class SB3VecEnv(VecEnv):  # type: ignore[misc]
    """A Gymnasium vector that resets in the same step, for the algorithms of stable-baselines3.

        envs = gymnasium.make_vec("carom/Potting-v0", num_envs=1024)
        model = stable_baselines3.PPO("MlpPolicy", SB3VecEnv(envs))

    The vector steps at once, in Rust; there are no single environments to reach into.

    Args:
        envs: The vector, in the mode ``same-step``, with spaces that are boxes.
        view: What the agent sees in place of the observations: a function from rows of them,
            shape (n, size), to as many rows of float32. The observations themselves if None.

    Raises:
        InputError: The vector resets otherwise.
    """

    def __init__(
        self,
        envs: VectorEnv[Any, Any, Any],
        *,
        view: Callable[[Array], Array] | None = None,
    ) -> None:
        if envs.metadata.get("autoreset_mode") is not AutoresetMode.SAME_STEP:
            raise InputError(
                "envs: stable-baselines3 wants the new episode in the step that ends the old one; "
                'make the vector with autoreset_mode="same-step"'
            )
        self.envs = envs
        self._view = view or _as_it_is
        seen = envs.single_observation_space
        if view is not None:
            size = view(envs.single_observation_space.sample()[None]).shape[1]
            seen = Box(-np.inf, np.inf, (size,), np.float32)
        self._actions: Array = np.empty(0)
        super().__init__(envs.num_envs, seen, envs.single_action_space)

    def reset(self) -> Array:
        """Begins an episode in every environment; the seeds are those of the last :meth:`seed`."""
        # Gymnasium's vectors take a list as well, which their type does not say.
        seeds: Any = None if self._seeds[0] is None else list(self._seeds)
        observations, _ = self.envs.reset(seed=seeds)
        self._reset_seeds()
        self._reset_options()
        return self._view(observations)

    def step_async(self, actions: Array) -> None:
        """Takes the actions, shape (num_envs, action size)."""
        self._actions = actions

    def step_wait(self) -> tuple[Array, Array, Array, list[dict[str, Any]]]:
        """Plays them: observations, rewards, which episodes have ended, and what else is known."""
        observations, rewards, terminated, truncated, more = self.envs.step(self._actions)
        done = terminated | truncated
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        ended = np.flatnonzero(done)
        if len(ended):
            rows = more["final_obs"][ended]
            # In Gymnasium's own vectors each row is an object.
            last = self._view(np.stack(rows) if rows.dtype == object else rows)
            for row, index in enumerate(ended):
                infos[index] = {
                    "terminal_observation": last[row],
                    "TimeLimit.truncated": bool(truncated[index]),
                }
        return self._view(observations), rewards.astype(np.float32), done, infos

    def close(self) -> None:
        """Closes the vector."""
        self.envs.close()

    def get_images(self) -> Sequence[Array | None]:
        """A picture of every table, if the vector was made with ``render_mode="rgb_array"``."""
        pictures: Any = self.envs.render()
        return [None] * self.num_envs if pictures is None else list(pictures)

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """The vector's own attribute, once for every environment that is asked."""
        return [getattr(self.envs, attr_name) for _ in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Refused: a setting is of the whole vector, and made with it."""
        raise NotImplementedError(f"make another vector, with another {attr_name}")

    def env_method(
        self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any
    ) -> list[Any]:
        """Refused: there are no single environments that could have methods."""
        raise NotImplementedError(f"{method_name}: the environments step at once, in Rust")

    def env_is_wrapped(self, wrapper_class: type[Any], indices: Any = None) -> list[bool]:
        """That no environment is wrapped."""
        del wrapper_class
        return [False for _ in self._get_indices(indices)]


def _as_it_is(observations: Array) -> Array:
    return observations
