"""A vector of environments for stable-baselines3: ``pip install 'carom[train]'``."""

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
        "carom.env.sb3 needs stable-baselines3; install it: pip install 'carom[train]'"
    ) from error

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]


class SB3VecEnv(VecEnv):  # type: ignore[misc]
    """A Gymnasium vector that resets in the same step, as a vector of stable-baselines3.

        envs = gymnasium.make_vec("carom/Potting-v3", num_envs=1024)
        model = stable_baselines3.PPO("MlpPolicy", SB3VecEnv(envs))

    All environments step together in Rust, so single environments cannot be accessed.

    Args:
        envs: The vector, in the mode ``same-step``, with spaces that are boxes.
        view: A function that turns observations, shape (n, size), into the agent's input, the same
            number of rows of float32. None gives the agent the observations themselves.

    Raises:
        InputError: ``envs`` is not a vector, or resets in another mode.
    """

    def __init__(
        self,
        envs: VectorEnv[Any, Any, Any],
        *,
        view: Callable[[Array], Array] | None = None,
    ) -> None:
        """Wrap ``envs``, a vector in the mode ``same-step``; ``view`` makes the agent's input.

        ``view`` turns observations, shape (n, size), into as many rows of float32; None gives the
        agent the observations themselves.

        Raises:
            InputError: ``envs`` is not a vector, or resets in another mode.
        """
        if not isinstance(envs, VectorEnv):
            raise InputError(
                "wrong-type",
                "envs",
                f"found a {type(envs).__name__}",
                "give a Gymnasium vector, for example "
                'gymnasium.make_vec("carom/Potting-v3", num_envs=64)',
            )
        if envs.metadata.get("autoreset_mode") is not AutoresetMode.SAME_STEP:
            raise InputError(
                "unsupported",
                "envs",
                "stable-baselines3 needs the new episode in the step that ends the old one",
                'make the vector with autoreset_mode="same-step"',
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
        """Begin an episode in every environment, with the seeds of the last :meth:`seed`."""
        # Gymnasium's vectors accept a list as well, though their type annotation does not.
        seeds: Any = None if self._seeds[0] is None else list(self._seeds)
        observations, _ = self.envs.reset(seed=seeds)
        self._reset_seeds()
        self._reset_options()
        return self._view(observations)

    def step_async(self, actions: Array) -> None:
        """Keep the actions, shape (num_envs, action size), for :meth:`step_wait`."""
        self._actions = actions

    def step_wait(self) -> tuple[Array, Array, Array, list[dict[str, Any]]]:
        """Play the actions; return observations, rewards, ends of episodes, and infos."""
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
        """Close the vector."""
        self.envs.close()

    def get_images(self) -> Sequence[Array | None]:
        """A picture of every table, if the vector was made with ``render_mode="rgb_array"``."""
        pictures: Any = self.envs.render()
        return [None] * self.num_envs if pictures is None else list(pictures)

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """The vector's own attribute, once for every environment in ``indices``."""
        return [getattr(self.envs, attr_name) for _ in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Not supported: settings belong to the whole vector and are fixed when it is made."""
        raise NotImplementedError(
            f"{attr_name}: settings are fixed; make a new vector with another value"
        )

    def env_method(
        self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any
    ) -> list[Any]:
        """Not supported: the vector has no single environments with methods of their own."""
        raise NotImplementedError(
            f"{method_name}: the environments step together in Rust; there are no single ones"
        )

    def env_is_wrapped(self, wrapper_class: type[Any], indices: Any = None) -> list[bool]:
        """False for every environment: none is wrapped."""
        del wrapper_class
        return [False for _ in self._get_indices(indices)]


def _as_it_is(observations: Array) -> Array:
    return observations
