"""Many environments at once, stepped in Rust on all cores."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Box
from gymnasium.utils.seeding import np_random
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from carom import _core
from carom.arguments import WORD, text, whole
from carom.env.render import check_mode, frame
from carom.env.settings import settings as checked
from carom.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]

_MODES = {
    "same-step": AutoresetMode.SAME_STEP,
    "next-step": AutoresetMode.NEXT_STEP,
    "disabled": AutoresetMode.DISABLED,
}
# Most environments of a vector. Snooker takes 5 kB for each, so these need 5 GB. Without a limit a
# typing error would end the process when memory runs out.
_MOST = 10**6


def spaces(core: _core.VectorEnv) -> tuple[Box, Box]:
    """The spaces of one environment's observations and actions."""
    low, high = core.observation_bounds
    action = Box(-1.0, 1.0, (core.action_size,), np.float32)
    return Box(low, high, dtype=np.float32), action


def floats(name: str, values: Any) -> NDArray[np.float32]:
    """Numbers in the form that Rust accepts.

    Raises:
        InputError: ``values`` is not an array of numbers.
    """
    try:
        return np.ascontiguousarray(values, dtype=np.float32)
    except (TypeError, ValueError):
        raise InputError(f"{name}: not numbers; give an array of numbers") from None


def reset_mask(options: Any) -> Any:
    """The mask in the options of a reset; None if there is none.

    Raises:
        InputError: The options are not a dict.
    """
    if options is None:
        return None
    if not isinstance(options, dict):
        found = type(options).__name__
        raise InputError(f'options: found a {found}; give {{"reset_mask": ...}}')
    return options.get("reset_mask")


class CaromVectorEnv(VectorEnv[Any, Any, Any]):
    """Environments of one task that step together.

    Environment ``i`` of a vector that is reset with seed ``s`` equals the single environment that
    is reset with ``s + i``, to the bit, for any number of threads.

    ``info`` has arrays with one entry per environment: ``player`` (who shoots next; −1 at the end
    of an episode), ``legal`` (whether the agent's shot was legal), ``potted`` (number of balls that
    it potted and was allowed to pot). In the mode ``same-step``, a step that ends episodes also has
    Gymnasium's keys: ``final_obs``, the last observations of the episodes that ended, shape
    (num_envs, observation size), 0 for the others; ``final_info``, their last ``player``,
    ``legal`` and ``potted``; and the masks ``_final_obs`` and ``_final_info``. ``player`` itself
    then belongs to the new episode. ``copy.deepcopy`` returns an independent vector in the same
    state.

    Args:
        task: ``potting``, ``eight-ball``, ``nine-ball``, ``ten-ball``, ``straight-pool``,
            ``snooker``, ``three-cushion`` or ``sum-to-three``.
        num_envs: Number of environments.
        render_mode: ``rgb_array`` or None.
        autoreset_mode: When the next episode begins: ``same-step``, ``next-step`` or
            ``disabled`` (then ``reset(options={"reset_mask": ...})`` begins it), or Gymnasium's
            ``AutoresetMode``.
        settings: See :func:`carom.env.settings.settings`.
    """

    def __init__(
        self,
        task: str,
        num_envs: int = 1,
        *,
        render_mode: str | None = None,
        autoreset_mode: str | AutoresetMode = "same-step",
        **settings: Any,
    ) -> None:
        if isinstance(autoreset_mode, AutoresetMode):
            names = {mode: name for name, mode in _MODES.items()}
            autoreset_mode = names[autoreset_mode]
        num_envs = whole("num_envs", num_envs, _MOST + 1, low=1)
        self._core = _core.VectorEnv(
            text("task", task), num_envs, checked(autoreset_mode=autoreset_mode, **settings)
        )
        self.metadata = {
            "render_modes": ["rgb_array"],
            "render_fps": 1,
            "autoreset_mode": _MODES[autoreset_mode],
        }
        self.num_envs = num_envs
        self.render_mode = check_mode(render_mode)
        self.single_observation_space, self.single_action_space = spaces(self._core)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._seeded = False

    @property
    def presets(self) -> dict[str, Any]:
        """The settings ``table`` and ``physics`` with dated names, for records.

        A name without a date will have other values one day. ``physics`` is missing if the table's
        name implies it.
        """
        return self._core.presets()

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

        Raises:
            InputError: A seed is invalid, or the mask has a wrong type or shape.
        """
        mask = reset_mask(options)
        seeds: list[int] | None = None
        if seed is None and not self._seeded:
            seed = int(np_random(None)[0].integers(2**62))
        if seed is not None:
            seeds = self._seeds(seed)
            self._seeded = True
        if mask is not None:
            mask = np.asarray(mask)
            if mask.dtype != np.bool_ or mask.shape != (self.num_envs,):
                raise InputError(
                    f"reset_mask: found {mask.dtype} of shape {mask.shape}; "
                    f"give booleans of shape ({self.num_envs},)"
                )
        observations = self._core.reset(seeds, mask)
        return observations, {}

    def step(self, actions: Array) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Play a shot in every environment.

        Args:
            actions: Shape (num_envs, action size); numbers outside [−1, 1] are clipped.

        Raises:
            InputError: The actions have another shape.
            ResetNeeded: The vector has not been reset yet.
        """
        if not self._seeded:
            raise ResetNeeded("call reset before step")
        actions = floats("actions", actions)
        if actions.shape != self.action_space.shape:
            wanted = self.action_space.shape
            raise InputError(f"actions: found the shape {actions.shape}; give {wanted}")
        info = self._core.step(actions)
        observations, rewards = info.pop("observations"), info.pop("rewards")
        terminated, truncated = info.pop("terminated"), info.pop("truncated")
        if "final_obs" in info:
            ended = terminated | truncated
            last: dict[str, Array] = {"player": np.where(ended, np.int8(-1), np.int8(0))}
            last |= {key: info[key] * ended for key in ("legal", "potted")}
            info["final_info"] = last | {f"_{key}": ended for key in last}
            info["_final_obs"] = info["_final_info"] = ended
        return observations, rewards, terminated, truncated, info

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
