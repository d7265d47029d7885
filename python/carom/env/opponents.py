"""Opponents in Python: policies, and players of one's own; and external programs."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arena.contestants import is_program, program
from carom.arena.named_players import named_player
from carom.env.arrays import floats
from carom.errors import InputError
from carom.noise import Noise
from carom.player import Situation
from carom.player.situation import answer_arguments, chosen
from carom.rules import Frame

if TYPE_CHECKING:
    from carom.call import PlayArguments


#: What Rust calls when an opponent in Python has to answer.
Ask = Callable[[Any], Any]


def seated(opponent: Any) -> Any:
    """The opponent that plays: of ``FILE.py:NAME``, and of a class, an object that is made here.

    Raises:
        InputError: The file has no such player.
    """
    if isinstance(opponent, str) and not is_program(opponent):
        found = named_player("opponent", opponent)
        if found is opponent:
            return opponent
        # In a file a function without arguments makes a player, as for matches.
        opponent = found if callable(getattr(found, "choose", None)) else found()
    if isinstance(opponent, type):
        opponent = opponent()
    return opponent


def program_of(opponent: Any) -> tuple[Any, ...] | None:
    """An external program in the form that Rust reads; None for another opponent.

    Raises:
        InputError: It cannot be started.
    """
    if not (isinstance(opponent, str) and is_program(opponent)):
        return None
    return program("opponent", opponent).program_arguments(None, (), strict=False)


def kind_of(opponent: Any) -> str | None:
    """``player`` for an object with ``choose``, ``policy`` for a function, None for a name.

    Raises:
        InputError: It is none of these.
    """
    if isinstance(opponent, str):
        return None
    if callable(getattr(opponent, "choose", None)):
        return "player"
    if callable(opponent):
        return "policy"
    raise InputError(
        "wrong-type",
        "opponent",
        f"found a {type(opponent).__name__}",
        'write a name, such as "none", or give a function from observations to actions, or an '
        "object with choose(situation)",
    )


def asking(opponent: Any, noise: Noise, width: int) -> Ask | None:
    """The function with which Rust asks ``opponent``; None for a name.

    Args:
        opponent: The setting.
        noise: Errors of the strikes of both players.
        width: Size of an action.
    """
    kind = kind_of(opponent)
    if kind is None:
        return None
    return (
        policy_actions("opponent", opponent, width)
        if kind == "policy"
        else _player(opponent, noise)
    )


def policy_actions(argument: str, policy: Callable[[Any], Any], width: int) -> Ask:
    """A policy whose actions are checked.

    Args:
        argument: The name of the argument that has the policy, for the error message.
        policy: A function from observations to actions.
        width: Size of an action.
    """

    def actions(rows: Any) -> Any:
        found = floats(argument, policy(rows))
        if found.shape != (len(rows), width):
            raise InputError(
                "wrong-count",
                argument,
                f"it returned actions of the shape {found.shape} for {len(rows)} observations",
                f"return {(len(rows), width)}",
            )
        return found

    return actions


def _player(player: Any, noise: Noise) -> Ask:
    def answers(asked: list[tuple[int, int, _core.Frame]]) -> list[PlayArguments | str]:
        found = []
        for index, seat, core in asked:
            try:
                situation = Situation(Frame._seen(core), noise, noise, seat)
                found.append(_arguments(chosen(player, situation)))
            except Exception as error:
                error.add_note(
                    f"The opponent of environment {index} was to answer as player {seat}."
                )
                raise
        return found

    return answers


def _arguments(answer: Any) -> PlayArguments | str:
    """The answer in the form that Rust reads; an error of its form names the opponent."""
    try:
        return answer_arguments(answer)
    except InputError as error:
        inside = error.place.removeprefix("answer").removeprefix(".")
        raise error.at(f"opponent.{inside}" if inside else "opponent") from None
