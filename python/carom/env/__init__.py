"""Environments for reinforcement learning: Gymnasium, vectors that step in Rust, PettingZoo.

    import gymnasium
    import carom.env                                   # registers the environments

    env = gymnasium.make("carom/Potting-v3", balls=3)
    envs = gymnasium.make_vec("carom/EightBall-v6", num_envs=4096)
    match = carom.env.aec("eight-ball")                # PettingZoo, two players

Needs the extra: ``pip install carom[env]``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Unpack

try:
    import gymnasium  # noqa: F401
except ImportError as error:
    raise ImportError("carom.env needs Gymnasium; install it: pip install 'carom[env]'") from error

from carom import _core
from carom.env.episodes import EpisodeWriter
from carom.env.players import PolicyPlayer, as_player
from carom.env.registry import ENVIRONMENTS, register
from carom.env.settings import MatchSettings, Rewards, Settings, VectorSettings
from carom.env.single import CaromEnv
from carom.env.vector import CaromVectorEnv

if TYPE_CHECKING:
    from carom.env.match import CaromMatch

__all__ = [
    "ACTIONS",
    "BALL_FEATURES",
    "ENVIRONMENTS",
    "FEATURES",
    "CaromEnv",
    "CaromVectorEnv",
    "EpisodeWriter",
    "MatchSettings",
    "PolicyPlayer",
    "Rewards",
    "Settings",
    "VectorSettings",
    "aec",
    "as_player",
]

#: Names of the numbers of an action, of each ball's features, and of the features after the balls.
ACTIONS, BALL_FEATURES, FEATURES = (tuple(names) for names in _core.meanings())

register()


def aec(game: str = "eight-ball", **settings: Unpack[MatchSettings]) -> CaromMatch:
    """Create a match between two agents, for PettingZoo.

    Args:
        game: A game of ``carom.rule_sets()`` for two players, or ``sum-to-three``.
        settings: See :class:`carom.env.MatchSettings`.

    Returns:
        A ``pettingzoo.AECEnv`` with the agents ``player_0`` and ``player_1``.

    Raises:
        ImportError: PettingZoo is not installed (``pip install 'carom[env]'``).
    """
    try:
        # PettingZoo is loaded with the first match.
        from carom.env.match import CaromMatch
    except ModuleNotFoundError as error:
        raise ImportError(
            "carom.env.aec needs PettingZoo; install it: pip install 'carom[env]'"
        ) from error

    return CaromMatch(game, **settings)
