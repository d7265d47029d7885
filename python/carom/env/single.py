"""A single environment for Gymnasium."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import gymnasium
from gymnasium.error import ResetNeeded

from carom import _core
from carom.arguments import text, whole
from carom.env.render import check_mode, frame
from carom.env.settings import settings as checked
from carom.env.vector import floats, spaces

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]


class CaromEnv(gymnasium.Env[Any, Any]):
    """A single environment, with the same bits as one environment of a ``CaromVectorEnv``.

    ``info`` has ``player`` (who shoots next; −1 at the end of an episode), ``legal`` (whether the
    agent's shot was legal) and ``potted`` (number of balls that it potted and was allowed to pot).
    ``copy.deepcopy`` returns an independent environment in the same state.

    Args:
        task: ``potting``, ``eight-ball``, ``nine-ball``, ``ten-ball``, ``straight-pool``,
            ``snooker``, ``three-cushion`` or ``sum-to-three``.
        render_mode: ``rgb_array`` or None.
        settings: See :func:`carom.env.settings.settings`.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 1}  # noqa: RUF012

    def __init__(self, task: str, *, render_mode: str | None = None, **settings: Any) -> None:
        given = {"threads": 1} | settings | {"autoreset_mode": "disabled"}
        self._core = _core.VectorEnv(text("task", task), 1, checked(**given))
        self.render_mode = check_mode(render_mode)
        self.observation_space, self.action_space = spaces(self._core)
        self._seeded = False

    @property
    def presets(self) -> dict[str, Any]:
        """The settings ``table`` and ``physics`` with dated names, for records.

        A name without a date will have other values one day. ``physics`` is missing if the table's
        name implies it.
        """
        return self._core.presets()

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Begin the first episode of ``seed``; without a seed, the next episode."""
        seed = None if seed is None else whole("seed", seed)
        super().reset(seed=seed, options=options)
        if seed is None and not self._seeded:
            seed = int(self.np_random.integers(2**62))
        self._seeded = True
        observations = self._core.reset(None if seed is None else [seed], None)
        return observations[0], {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Play a shot. Numbers of ``action`` outside [−1, 1] are clipped."""
        if not self._seeded:
            raise ResetNeeded("call reset before step")
        out = self._core.step(floats("action", action).reshape(1, -1))
        info = {key: out[key][0].item() for key in ("player", "legal", "potted")}
        return (
            out["observations"][0],
            float(out["rewards"][0]),
            bool(out["terminated"][0]),
            bool(out["truncated"][0]),
            info,
        )

    def render(self) -> Any:
        """A picture of the table, uint8 of shape (height, width, 3); None without a render mode."""
        return None if self.render_mode is None else frame(self._core.picture(0))
