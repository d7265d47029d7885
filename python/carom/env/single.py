"""A single environment for Gymnasium."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Unpack

import gymnasium
from gymnasium.error import ResetNeeded

from carom.arguments import text, whole
from carom.env.arrays import floats
from carom.env.base import Environments
from carom.env.infos import fouls_of, traces
from carom.env.render import check_mode, frame
from carom.env.settings import Settings
from carom.env.starts import STARTS, read_options, read_starts
from carom.env.vector import spaces

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]


class CaromEnv(Environments, gymnasium.Env[Any, Any]):
    """A single environment, with the same bits as one environment of a ``CaromVectorEnv``.

    ``info`` has ``player`` (who shoots next; −1 at the end of an episode), also after ``reset``;
    after a step ``legal`` (whether the agent's shot was legal), ``potted`` (number of balls that it
    potted and was allowed to pot), ``fouls`` (in words), ``strike`` (the agent's strike as it was
    played: speed in m/s, azimuth and elevation in rad, side, height; None if none was); at the end
    of an episode ``winner`` (0, 1, or −1 without one) and ``why`` (in words). With the settings
    that ask for them there are ``seat`` (the agent's), ``randomized`` (the numbers drawn for the
    episode, by key) and ``traces`` (the agent's shot, then the opponent's).

    ``copy``, ``copy.deepcopy`` and ``pickle`` give an independent environment in the same state.

    Args:
        task: A game of ``carom.rule_sets()`` for two players, ``potting`` or ``sum-to-three``.
        render_mode: ``rgb_array`` or None.
        settings: See :class:`carom.env.Settings`.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 1}  # noqa: RUF012

    def __init__(
        self, task: str, *, render_mode: str | None = None, **settings: Unpack[Settings]
    ) -> None:
        given = {"threads": 1, **settings, "autoreset_mode": "disabled"}
        self._make(text("task", task), 1, given)
        self.render_mode = check_mode(render_mode)
        self.observation_space, self.action_space = spaces(self._core)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Begin the first episode of ``seed``; without a seed, the next episode.

        Args:
            seed: A whole number from 0 to 2⁶⁴ − 1.
            options: ``shot`` or ``frame``: where the episode starts, in place of its own start.
                That is a ``carom.Shot`` or its dict (balls that it lacks are off the table, and
                player 0 shoots), or a ``carom.Frame`` or its record, on the table and with the
                physics of the environment.

        Raises:
            InputError: A seed is invalid, an option is unknown, or the task cannot start there.
        """
        seed = None if seed is None else whole("seed", seed)
        starts = read_starts(read_options(options, STARTS), 1)
        super().reset(seed=seed)
        if seed is None and not self._seeded:
            seed = int(self.np_random.integers(2**62))
        observations = self._core.reset(None if seed is None else [seed], None, starts, self._ask)
        self._seeded = True
        return observations[0], {"player": int(self._core.players()[0]), **self._about_episode()}

    def _about_episode(self) -> dict[str, Any]:
        """As ``_about_episodes``, with numbers in place of arrays."""
        about = self._about_episodes(self._core)
        if "seat" in about:
            about["seat"] = int(about["seat"][0])
        if "randomized" in about:
            about["randomized"] = {key: float(x[0]) for key, x in about["randomized"].items()}
        return about

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Play a shot. Numbers of ``action`` outside [−1, 1] are clipped."""
        if not self._seeded:
            raise ResetNeeded("call reset before step")
        row = floats("action", action).reshape(-1)
        seen, reward, terminated, truncated, player, legal, potted, fouls, strike, winner, why = (
            self._core.step_one(row, self._ask)
        )
        info: dict[str, Any] = {
            "player": player,
            "legal": legal,
            "potted": potted,
            "fouls": fouls_of(fouls),
            "strike": strike,
        }
        if why is not None:
            info["winner"], info["why"] = winner, why
        if self._reports_more:
            if self._has_traces:
                info["traces"] = traces(self._core, 0)
            info |= self._about_episode()
        return seen, reward, terminated, truncated, info

    def close(self) -> None:
        """End the processes of an opponent that is a program. Another step starts them again."""
        self._core.close()

    def render(self) -> Any:
        """A picture of the table, uint8 of shape (height, width, 3); None without a render mode."""
        return None if self.render_mode is None else frame(self._core.picture(0))
