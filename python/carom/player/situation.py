"""What a player of one's own is asked, and its answer in the form that Rust reads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from carom.arguments import text
from carom.call import PlayArguments
from carom.errors import InputError
from carom.noise import Noise, Perception
from carom.player.decision import Decision, Play
from carom.player.drawn import PotPlay, Successor, pots, successors
from carom.player.player import Player
from carom.rules import Frame, plain_answer, play_arguments

_EXACT = Perception()


# Not frozen: that takes 2.5 times as long to make, and the object belongs to the player.
@dataclass(slots=True)
class Situation:
    """What a player knows when the frame asks it.

    Attributes:
        frame: A copy of the frame. It does not have the seed of the racks to come, and no record.
            With errors of perception its balls are a little off their true places.
        noise: Errors of the player's own strikes. Errors that a match does not disclose are those
            of ``carom.Noise()``: none.
        opponent_noise: Errors of the other player's strikes.
        player: The player's seat, 0 or 1.
        clock: Seconds that the player may still use, in the frame or for this decision; None if
            no clock counts seconds.
        simulations: Simulated shots that the player may still use; None if no clock counts them.
            What a player uses is the ``simulations`` of its ``carom.Decision``.
        budget: The part of ``clock`` or ``simulations`` that a built-in player would use now; None
            without a clock.
        perception: Errors with which the player sees the balls.
        seed: Seed of the random numbers of this decision. A player that draws numbers from it
            plays the same match again if the secret is the same.
        refused: Why the last answer to this request was refused, with ``place``, ``fault`` and
            ``remedy``; None for a new request.
    """

    frame: Frame
    noise: Noise
    opponent_noise: Noise
    player: int
    clock: float | None = None
    simulations: int | None = None
    budget: float | None = None
    perception: Perception = _EXACT
    seed: int = 0
    refused: InputError | None = None

    def pots(
        self,
        n: int = 200,
        *,
        cue_ball: Sequence[float] | None = None,
        each: int = 1,
        threads: int | None = None,
    ) -> list[PotPlay]:
        """``carom.pots`` of the frame under the player's own errors."""
        return pots(
            self.frame,
            self.noise,
            n,
            self.seed,
            cue_ball=cue_ball,
            each=each,
            perception=self.perception,
            threads=threads,
        )

    def successors(
        self, play: Play, n: int = 100, *, first: int = 0, threads: int | None = None
    ) -> list[Successor]:
        """``carom.successors`` of a play under the player's own errors."""
        return successors(
            self.frame,
            play,
            self.noise,
            n,
            self.seed,
            first=first,
            perception=self.perception,
            threads=threads,
        )


class Chooser(Protocol):
    """A player of one's own: any object with this method."""

    def choose(
        self, situation: Situation, /
    ) -> Play | Decision | Mapping[str, Any] | str | InputError:
        """Answer the request of ``situation.frame``.

        Returns:
            A ``carom.Play``, a ``carom.Decision``, the name of one of ``request.choices``,
            ``"concede"``, or plain values that follow ``situation.frame.answer_schema()``. A player
            that passes on the answers of another program may return a ``carom.InputError``: the
            answer is then refused as that error says.
        """
        ...


def chosen(player: Any, situation: Situation) -> Any:
    """The answer of a player of one's own, or of a ``carom.Player``."""
    if isinstance(player, Player):
        frame, other = situation.frame, situation.opponent_noise
        return player.choose(frame, noise=situation.noise, opponent_noise=other)
    return player.choose(situation)


def answer_arguments(answer: Any) -> PlayArguments | str:
    """The answer of a player in the form that Rust reads.

    Raises:
        InputError: It is not an answer.
    """
    if isinstance(answer, InputError):
        raise answer
    if isinstance(answer, Decision):
        if answer.play is None:
            return "concede" if answer.choice is None else text("choice", answer.choice)
        answer = answer.play
    if isinstance(answer, Play):
        return play_arguments(answer.strike, answer.cue_ball, answer.call)
    if isinstance(answer, str):
        return text("choice", answer)
    if isinstance(answer, Mapping):
        plain = plain_answer(answer)
        if "play" in plain:
            return play_arguments(**plain["play"])
        return text("choice", plain["choice"]) if "choice" in plain else "concede"
    raise InputError(
        "wrong-type",
        "answer",
        f"choose returned a {type(answer).__name__}",
        'return a carom.Play, a carom.Decision, the name of a choice, "concede", or plain values '
        "that follow frame.answer_schema()",
    )
