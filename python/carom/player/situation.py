"""What a player of one's own is asked, and its answer in the form that Rust reads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from carom.call import PlayArguments
from carom.errors import InputError
from carom.noise import Noise
from carom.player.decision import Decision, Play
from carom.rules import Frame, play_arguments


@dataclass(frozen=True, slots=True)
class Situation:
    """What a player knows when the frame asks it.

    Attributes:
        frame: A copy of the frame. It does not have the seed of the racks to come, and no record.
        noise: Errors of the player's own strikes.
        opponent_noise: Errors of the other player's strikes.
        player: The player's seat, 0 or 1.
        clock: Seconds that the player may still use; None without a clock.
    """

    frame: Frame
    noise: Noise
    opponent_noise: Noise
    player: int
    clock: float | None = None


class Chooser(Protocol):
    """A player of one's own: any object with this method."""

    def choose(self, situation: Situation) -> Play | Decision | str:
        """Answer the request of ``situation.frame``.

        Returns:
            A ``carom.Play``, a ``carom.Decision``, the name of one of ``request.choices``, or
            ``"concede"``.
        """
        ...


def answer_arguments(answer: Any) -> PlayArguments | str:
    """The answer of a player in the form that Rust reads.

    Raises:
        InputError: It is not an answer.
    """
    if isinstance(answer, Decision):
        if answer.play is None:
            return "concede" if answer.choice is None else answer.choice
        answer = answer.play
    if isinstance(answer, Play):
        return play_arguments(answer.strike, answer.cue_ball, answer.call)
    if isinstance(answer, str):
        return answer
    raise InputError(
        "wrong-type",
        "opponent",
        f"choose returned a {type(answer).__name__}",
        'return a carom.Play, a carom.Decision, the name of a choice, or "concede"',
    )
