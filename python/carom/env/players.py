"""Policies of the environments as players of matches."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from carom.arguments import text
from carom.env.opponents import policy_actions
from carom.env.registry import ENVIRONMENTS
from carom.env.single import CaromEnv
from carom.errors import InputError
from carom.player import Play, Situation

# Tasks that `carom.play_match` does not play.
_WITHOUT_FRAMES = ("potting", "sum-to-three")
# Settings that the frames of a match have themselves.
_OF_FRAME = ("table", "physics")


class PolicyPlayer:
    """A policy of an environment as a player; ``as_player`` makes one.

    All copies share the policy, so that the frames of a match do not copy a network.
    """

    def __init__(
        self, policy: Callable[[Any], Any], task: str, name: str, settings: dict[str, Any]
    ) -> None:
        self.policy, self.task, self.name, self.settings = policy, task, name, settings
        self._env: CaromEnv | None = None

    def choose(self, situation: Situation) -> Play | str:
        """Answer as the environment does for its agent, with the action of the policy."""
        frame = situation.frame
        if self._env is None:
            own = {key: getattr(frame, key) for key in _OF_FRAME}
            self._env = CaromEnv(self.task, **{**self.settings, **own})
        observation, _ = self._env.reset(seed=0, options={"frame": frame})
        if frame.request.kind == "choice":
            return self._choice(situation)
        actions = policy_actions("policy", self.policy, self._env._width)
        return self._env.play_of(actions(observation[None])[0])

    def _choice(self, situation: Situation) -> str:
        """The choice that the environment has made, since it asks its agent only for shots."""
        assert self._env is not None
        chosen = self._env.frame
        assert chosen is not None
        choices = situation.frame.request.choices
        for choice in choices:
            after = situation.frame.copy()
            after.choose(choice)
            if after.hash == chosen.hash:
                return choice
        return choices[0]

    def __deepcopy__(self, _: dict[int, Any]) -> PolicyPlayer:
        return PolicyPlayer(self.policy, self.task, self.name, self.settings)

    def __reduce__(self) -> tuple[Any, ...]:
        return PolicyPlayer, (self.policy, self.task, self.name, self.settings)


def as_player(
    policy: Callable[[Any], Any], task: str, *, name: str = "policy", **settings: Any
) -> PolicyPlayer:
    """A policy of an environment as a player of matches.

    The player observes a frame and plays its action as the agent of the environment does: calls and
    choices are made for it. So the same policy is an agent, an opponent (``opponent=policy``) and a
    player (``carom.play_match``).

    Args:
        policy: A function from observations, shape (k, size), to actions, shape (k, action size).
            It must not change while a match goes on.
        task: The game, such as ``eight-ball``; or the environment, such as
            ``carom/EightBall-v6`` or ``EightBall-v6``.
        name: The player's name in tables and records.
        settings: The settings of the environment with which the policy was trained, such as
            ``aim`` and ``speed``. Table and physics are those of the match.

    Raises:
        InputError: The policy is not a function, there is no such game, or a setting is invalid.
    """
    if not callable(policy):
        raise InputError(
            "wrong-type",
            "policy",
            f"found a {type(policy).__name__}",
            "give a function from observations to actions",
        )
    word = text("task", task, '"eight-ball"')
    known = {key.removeprefix("carom/"): game for key, game in ENVIRONMENTS.items()}
    game = known.get(word.removeprefix("carom/"), word)
    for key in (*_OF_FRAME, "opponent", "clock", "seat"):
        if key in settings:
            raise InputError("conflict", key, "the match decides it", "leave it out")
    if game in _WITHOUT_FRAMES:
        raise InputError(
            "unsupported", "task", f"{game} has no frames", 'choose a game, such as "nine-ball"'
        )
    # The settings are checked before the first frame.
    CaromEnv(game, **settings)
    return PolicyPlayer(policy, game, text("name", name, '"policy"'), settings)
