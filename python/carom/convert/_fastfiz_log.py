"""FastFiz's logs of games, as ``LogWriter`` and the tournament's server write them."""

from __future__ import annotations

import math
from typing import NamedTuple

from carom.errors import InputError

# Numbers of a ball in a table state.
BALL_FIELDS = 5
# Words of a log line before its table state: none, or the game's type, the type of the turn, both
# times, and whether the player began.
_STATE_LINES = {"TSTATE": 0, "STATE": 5}
# The shot of a log line is its first five numbers. Those of a SHOT are the executed ones.
_SHOT_LINES = ("TSHOT", "SHOT")
_OTHER_LINES = ("COMMENT", "GTYPE")
LOG_WORDS = (*_STATE_LINES, *_SHOT_LINES, *_OTHER_LINES)

_STRIKE = 5
# Where the line of a SHOT has the place of a cue ball in hand.
_CUE_PLACE = 13
# Values of TurnType: the cue ball is in hand, and the player decides in place of a shot.
_IN_HAND, _DECISIONS = (1, 2, 4), (6, 7, 9)


class LoggedState(NamedTuple):
    """A state of a log with the shot that follows it.

    Attributes:
        words: The table state.
        strike: FastFiz's ``ShotParams``; None if no shot follows.
        cue_ball: Where the shot puts a cue ball in hand, m; None if it stays where it is.
        is_executed: Whether the strike has FastFiz's noise.
        is_decision: Whether the state asks for a decision in place of a shot.
    """

    words: list[str]
    strike: list[float] | None = None
    cue_ball: tuple[float, float] | None = None
    is_executed: bool = False
    is_decision: bool = False


def is_log(text: str) -> bool:
    """Whether a text begins as a log does."""
    return text.split(maxsplit=1)[:1] != [] and text.split(maxsplit=1)[0] in LOG_WORDS


def states_of(text: str) -> list[LoggedState]:
    """The states of a log, in order.

    Raises:
        InputError: A line is not FastFiz's.
    """
    states: list[LoggedState] = []
    turn = 0
    for n, line in enumerate(text.splitlines(), 1):
        kind, _, rest = line.strip().partition(" ")
        words = rest.split()
        if kind in _STATE_LINES:
            before = _STATE_LINES[kind]
            count = number(words, before, f"line {n}: the number of balls")
            turn = int(number(words, 1, f"line {n}: the type of the turn")) if before else 0
            # After the table state a game has words of its own.
            balls = words[before : before + 1 + BALL_FIELDS * max(0, int(count))]
            states.append(LoggedState(balls, is_decision=turn in _DECISIONS))
        elif kind in _SHOT_LINES and states:
            states[-1] = _with_shot(states[-1], kind, words, turn, f"line {n}: the shot")
        elif kind and kind not in LOG_WORDS:
            raise InputError(
                "syntax",
                f"line {n}",
                f"a line of a FastFiz log begins with one of {', '.join(LOG_WORDS)}, and "
                f"this one with {kind!r}",
                "remove it",
            )
    return states


def _with_shot(
    state: LoggedState, kind: str, words: list[str], turn: int, place: str
) -> LoggedState:
    strike = [number(words, k, place) for k in range(_STRIKE)]
    if state.is_decision:
        return state
    cue_ball = None
    if kind == "SHOT" and turn in _IN_HAND:
        cue_ball = (number(words, _CUE_PLACE, place), number(words, _CUE_PLACE + 1, place))
    return state._replace(strike=strike, cue_ball=cue_ball, is_executed=kind == "SHOT")


def number(words: list[str], index: int, what: str) -> float:
    """The number at an index of the words.

    Raises:
        InputError: There is none, or it is not finite; the place is ``what``.
    """
    try:
        value = float(words[index])
    except (IndexError, ValueError):
        found = words[index] if index < len(words) else "nothing"
        raise InputError(
            "wrong-type", what, f"{found!r} is not a number", "write numbers separated by blanks"
        ) from None
    if not math.isfinite(value):
        raise InputError(
            "out-of-range", what, f"{words[index]} is not finite", "write a finite number"
        )
    return value
