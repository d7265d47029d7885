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
from carom.env.settings import pack
from carom.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]

_MODES = {
    "same-step": AutoresetMode.SAME_STEP,
    "next-step": AutoresetMode.NEXT_STEP,
    "disabled": AutoresetMode.DISABLED,
}


# More than fit into any memory, at some kilobytes each.
_MOST = 10**7


def spaces(core: _core.VectorEnv) -> tuple[Box, Box]:
    """The spaces of one environment's observations and actions."""
    low, high = core.observation_bounds
    action = Box(-1.0, 1.0, (core.action_size,), np.float32)
    return Box(low, high, dtype=np.float32), action


def floats(name: str, values: Any) -> NDArray[np.float32]:
    """Numbers as Rust takes them.

    Raises:
        InputError: They are none.
    """
    try:
        return np.ascontiguousarray(values, dtype=np.float32)
    except (TypeError, ValueError):
        raise InputError(f"{name}: not an array of numbers; give one") from None


class CaromVectorEnv(VectorEnv[Any, Any, Any]):
    """A row of environments of one task.

    Environment ``i`` of a vector that is reset with seed ``s`` is the single environment reset with
    ``s + i``, to the bit, for any number of threads.

    ``info`` has arrays of one entry an environment: ``player`` (who shoots next; −1 at the end of
    an episode), ``legal`` (whether the agent's shot was), ``potted`` (balls that it potted and
    that were the shooter's to pot). In the mode ``same-step``, the steps that end episodes have
    besides what Gymnasium has there: ``final_obs``, the old episode's last rows, shape
    (num_envs, observation size), 0 where none has ended; ``final_info``, its last ``player``,
    ``legal`` and ``potted``; and the masks ``_final_obs`` and ``_final_info``. ``player`` itself is
    then the new episode's. ``copy.deepcopy`` gives a vector that goes on by itself from the same
    place.

    Args:
        task: ``potting``, ``eight-ball``, ``nine-ball``, ``ten-ball``, ``straight-pool``,
            ``snooker``, ``three-cushion`` or ``sum-to-three``.
        num_envs: How many.
        render_mode: ``rgb_array`` or None.
        autoreset_mode: When the next episode begins: ``same-step``, ``next-step`` or
            ``disabled`` (then ``reset(options={"reset_mask": ...})`` does it), or Gymnasium's
            ``AutoresetMode``.
        settings: As for the single environment.
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
            text("task", task), num_envs, pack(autoreset_mode=autoreset_mode, **settings)
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

    def reset(
        self,
        *,
        seed: int | Sequence[int] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Array, dict[str, Any]]:
        """Begins an episode in every environment.

        Args:
            seed: Of environment 0 (environment i has ``seed + i``), or one for each; None goes on
                with the seeds of before.
            options: ``reset_mask``: an array that says which environments are reset; all if it
                is not given.
        """
        mask = (options or {}).get("reset_mask")
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
        """Plays a shot in every environment.

        Args:
            actions: Shape (num_envs, action size); numbers beyond [−1, 1] are brought into it.

        Raises:
            InputError: The actions have another shape.
            ResetNeeded: The vector was never reset.
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
        """A picture of every environment's table, if the render mode is ``rgb_array``."""
        if self.render_mode is None:
            return None
        return tuple(frame(self._core.picture(index)) for index in range(self.num_envs))

    def _seeds(self, seed: int | Sequence[int]) -> list[int]:
        if isinstance(seed, Sequence | np.ndarray):
            return [whole("seed", one) for one in seed]
        first = whole("seed", seed)
        return [one % WORD for one in range(first, first + self.num_envs)]
