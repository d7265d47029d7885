"""Many environments at once, stepped in Rust on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np
from gymnasium.spaces import Box
from gymnasium.utils.seeding import np_random
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from carom import _core
from carom.arguments import WORD, text, whole
from carom.env.arrays import floats
from carom.env.base import Environments
from carom.env.render import check_mode, frame
from carom.env.settings import VectorSettings
from carom.env.starts import STARTS, read_options, read_starts
from carom.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]

_MODES = {
    "same-step": AutoresetMode.SAME_STEP,
    "next-step": AutoresetMode.NEXT_STEP,
    "disabled": AutoresetMode.DISABLED,
}
_NAMES = {mode: name for name, mode in _MODES.items()}
# Most environments of a vector. Snooker takes 5 kB for each, so these need 5 GB. Without a limit a
# typing error would end the process when memory runs out.
_MOST = 10**6


def spaces(core: _core.VectorEnv) -> tuple[Box, Box]:
    """The spaces of one environment's observations and actions."""
    low, high = core.observation_bounds
    action = Box(-1.0, 1.0, (core.action_size,), np.float32)
    return Box(low, high, dtype=np.float32), action


class CaromVectorEnv(Environments, VectorEnv[Any, Any, Any]):
    """Environments of one task that step together.

    Environment ``i`` of a vector that is reset with seed ``s`` equals the single environment that
    is reset with ``s + i``, to the bit, for any number of threads.

    ``info`` has the keys of a single environment, with arrays of one entry for each environment:
    ``player``, ``legal``, ``potted``, ``fouls`` (tuples of words) and ``strike``, shape (num_envs,
    5), NaN where none was played; where episodes end, ``winner`` and ``why``, with the masks
    ``_winner`` and ``_why``.

    In the mode ``same-step``, a step that ends episodes has Gymnasium's keys instead:
    ``final_obs``, the last observations of the episodes that ended, shape (num_envs, observation
    size), 0 for the others; ``final_info``, all that ``info`` says of these last steps; and the
    masks ``_final_obs`` and ``_final_info``. ``player``, ``seat`` and ``randomized`` then belong to
    the new episode.

    ``copy``, ``copy.deepcopy`` and ``pickle`` give an independent vector in the same state. A
    vector is used by one thread at a time; another one that comes meanwhile gets a CaromError.

    Args:
        task: A game of ``carom.rule_sets()`` for two players, ``potting`` or ``sum-to-three``.
        num_envs: Number of environments.
        render_mode: ``rgb_array`` or None.
        settings: See :class:`carom.env.VectorSettings`.
    """

    def __init__(
        self,
        task: str,
        num_envs: int = 1,
        *,
        render_mode: str | None = None,
        **settings: Unpack[VectorSettings],
    ) -> None:
        num_envs = whole("num_envs", num_envs, _MOST + 1, low=1)
        given: dict[str, Any] = {**settings}
        if isinstance(mode := given.get("autoreset_mode"), AutoresetMode):
            given["autoreset_mode"] = _NAMES[mode]
        self._make(text("task", task), num_envs, given)
        self.metadata = {
            "render_modes": ["rgb_array"],
            "render_fps": 1,
            "autoreset_mode": _MODES[self._core.autoreset_mode],
        }
        self.num_envs = num_envs
        self.render_mode = check_mode(render_mode)
        self.single_observation_space, self.single_action_space = spaces(self._core)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)

    def reset(
        self,
        *,
        seed: int | Sequence[int] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Array, dict[str, Any]]:
        """Begin an episode in every environment.

        Args:
            seed: The seed of environment 0 (environment i has ``seed + i``), or one seed for each.
                None continues with the next episodes of the earlier seeds.
            options: ``reset_mask``: a boolean array of the environments to reset; without it, all.
                ``shot`` or ``frame``: where the episodes start, as for a single environment; one
                for all, or a list with one for each (None for its usual start).

        Raises:
            InputError: A seed is invalid, the mask has a wrong type or shape, an option is
                unknown, or the task cannot start there.
        """
        given = read_options(options, ("reset_mask", *STARTS))
        mask, starts = given.get("reset_mask"), read_starts(given, self.num_envs)
        seeds: list[int] | None = None
        if seed is None and not self._seeded:
            seed = int(np_random(None)[0].integers(2**62))
        if seed is not None:
            seeds = self._seeds(seed)
        if mask is not None:
            mask = np.asarray(mask)
            if mask.dtype != np.bool_ or mask.shape != (self.num_envs,):
                raise InputError(
                    "wrong-type",
                    "reset_mask",
                    f"found {mask.dtype} of shape {mask.shape}",
                    f"give booleans of shape ({self.num_envs},)",
                )
        observations = self._core.reset(seeds, mask, starts, self._ask)
        self._seeded = True
        return observations, {"player": self._core.players(), **self._about_episodes(self._core)}

    def step(self, actions: Array) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Play a shot in every environment.

        Args:
            actions: Shape (num_envs, action size); numbers outside [−1, 1] are clipped.

        Raises:
            InputError: The actions have another shape.
            ResetNeeded: The vector has not been reset yet.
        """
        self._check_seeded("step")
        actions = floats("actions", actions)
        if actions.shape != self.action_space.shape:
            wanted = self.action_space.shape
            raise InputError(
                "wrong-count", "actions", f"found the shape {actions.shape}", f"give {wanted}"
            )
        return self._results(self._core, actions)

    def close_extras(self, **_: Any) -> None:
        """End the processes of an opponent that is a program; ``close`` calls it."""
        self._core.close()

    def render(self) -> tuple[Array, ...] | None:
        """A picture of every environment's table; None without a render mode."""
        if self.render_mode is None:
            return None
        return tuple(frame(self._core.picture(index)) for index in range(self.num_envs))

    def _seeds(self, seed: int | Sequence[int]) -> list[int]:
        if isinstance(seed, Sequence | np.ndarray):
            return [whole("seed", one) for one in seed]
        first = whole("seed", seed)
        return [one % WORD for one in range(first, first + self.num_envs)]
