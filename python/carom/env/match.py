"""Two agents at one table, for PettingZoo."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Unpack

import numpy as np
from gymnasium.error import ResetNeeded
from pettingzoo import AECEnv

from carom.arguments import text, whole
from carom.env.arrays import floats
from carom.env.base import Environments
from carom.env.infos import fouls_of, traces
from carom.env.render import check_mode, frame
from carom.env.settings import MatchSettings
from carom.env.starts import STARTS, read_options, read_starts
from carom.env.vector import spaces
from carom.errors import InputError

if TYPE_CHECKING:
    from gymnasium.spaces import Box
    from numpy.typing import NDArray

    Array = NDArray[Any]


# The options that PettingZoo's `api_test` gives every environment; they mean nothing.
_PROBE = {"options": 1}


class CaromMatch(Environments, AECEnv[str, Any, Any]):  # type: ignore[misc]
    """A frame between ``player_0``, who begins, and ``player_1``.

    The shooter continues until the rules give the turn to the other player, so the same agent is
    often selected several times in a row. The shooter gets the shot's reward and the other agent
    gets its negative: a zero-sum game.

    Args:
        game: The name of a task, except potting, which has one player.
        render_mode: ``rgb_array`` or None.
        settings: See :class:`carom.env.MatchSettings`.
    """

    metadata: ClassVar[dict[str, Any]] = {
        "render_modes": ["rgb_array"],
        "name": "carom_v0",
        "is_parallelizable": False,
        "render_fps": 1,
    }

    def __init__(
        self,
        game: str = "eight-ball",
        *,
        render_mode: str | None = None,
        **settings: Unpack[MatchSettings],
    ) -> None:
        super().__init__()
        if game == "potting":
            raise InputError(
                "unsupported", "game", "potting has one player", "choose a game, such as eight-ball"
            )
        for key in ("opponent", "clock", "seat"):
            if key in settings:
                raise InputError(
                    "conflict", key, "both players are agents in a match", "leave it out"
                )
        given = {"threads": 1, **settings, "autoreset_mode": "disabled"}
        self._make(text("game", game), 1, given)
        self.render_mode = check_mode(render_mode)
        self.possible_agents = ["player_0", "player_1"]
        self.agents: list[str] = []
        seen, act = spaces(self._core)
        self.observation_spaces = dict.fromkeys(self.possible_agents, seen)
        self.action_spaces = dict.fromkeys(self.possible_agents, act)

    def observation_space(self, agent: str) -> Box:
        """The space of observations, the same for both agents."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Box:
        """The space of actions, the same for both agents."""
        return self.action_spaces[agent]

    def reset(self, seed: int | None = None, options: dict[str, Any] | None = None) -> None:
        """Begin the first frame of ``seed``; without a seed, the next frame.

        ``infos`` then has, for both agents, ``player`` (the index of the one who shoots next).

        Args:
            seed: A whole number from 0 to 2⁶⁴ − 1.
            options: ``shot`` or ``frame``: where the frame starts, as for a single environment.

        Raises:
            InputError: A seed is invalid, an option is unknown, or the game cannot start there.
        """
        if options == _PROBE:
            options = None
        starts = read_starts(read_options(options, STARTS), 1)
        if seed is None and not self._seeded:
            seed = int(np.random.default_rng().integers(2**62))
        seed = None if seed is None else whole("seed", seed)
        self._core.reset(None if seed is None else [seed], None, starts, None)
        self._seeded = True
        self.agents = list(self.possible_agents)
        self.rewards = dict.fromkeys(self.agents, 0.0)
        self._cumulative_rewards = dict.fromkeys(self.agents, 0.0)
        self.terminations = dict.fromkeys(self.agents, False)
        self.truncations = dict.fromkeys(self.agents, False)
        self.infos: dict[str, dict[str, Any]] = {agent: self._info() for agent in self.agents}
        self.agent_selection = self._next()

    def observe(self, agent: str) -> Array:
        """The observation of ``agent``, whether or not it shoots next."""
        if agent not in self.possible_agents:
            raise InputError(
                "unknown-name", "agent", f"there is no {agent!r}", "write player_0 or player_1"
            )
        return self._core.observe(0, self.possible_agents.index(agent))

    def step(self, action: Array | None) -> None:
        """Play a shot of the selected agent."""
        if not self._seeded:
            raise ResetNeeded("call reset before step")
        shooter = self.agent_selection
        if self.terminations[shooter] or self.truncations[shooter]:
            self._was_dead_step(action)
            return
        self._cumulative_rewards[shooter] = 0.0
        row = floats("action", action).reshape(-1)
        _, reward, terminated, truncated, _, legal, potted, fouls, strike, winner, why = (
            self._core.step_one(row, None)
        )
        self.rewards = {agent: reward if agent == shooter else -reward for agent in self.agents}
        self.terminations = dict.fromkeys(self.agents, terminated)
        self.truncations = dict.fromkeys(self.agents, truncated)
        self.infos = {agent: self._info() for agent in self.agents}
        self.infos[shooter] |= {
            "legal": legal,
            "potted": potted,
            "fouls": fouls_of(fouls),
            "strike": strike,
        }
        if self._has_traces:
            self.infos[shooter]["traces"] = traces(self._core, 0)
        if why is not None:
            for info in self.infos.values():
                info["winner"], info["why"] = winner, why
        self._accumulate_rewards()
        self.agent_selection = self._next()

    def render(self) -> Any:
        """A picture of the table, uint8 of shape (height, width, 3); None without a render mode."""
        return None if self.render_mode is None else frame(self._core.picture(0))

    def close(self) -> None:
        """Do nothing: a match holds no resources."""

    def _info(self) -> dict[str, Any]:
        """What ``infos`` has for both agents."""
        info: dict[str, Any] = {"player": int(self._core.players()[0])}
        for key, values in self._about_episodes(self._core).items():
            info[key] = {name: float(drawn[0]) for name, drawn in values.items()}
        return info

    def _next(self) -> str:
        player = self._core.player(0)
        return self.agent_selection if player is None else self.possible_agents[player]
