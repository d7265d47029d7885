"""Requests of a frame, and the parts of its state, with their types.

Each is a dict, as ``Frame.to_dict`` has it, whose keys are also attributes. The keys are those of
the request's own kind. An attribute that belongs to another kind of request is None or empty, so
that ``frame.request.winner`` can be read at any time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, Literal, TypeAlias

from carom.record import Record

Region: TypeAlias = Literal["anywhere", "behind-head-string", "the-d"]
CallKind: TypeAlias = Literal["nothing", "pocket", "safety", "push-out", "on"]
Choice: TypeAlias = Literal[
    "play-on",
    "play-from-hand",
    "pass-back",
    "rebreak",
    "rebreak-by-other",
    "spot-eight",
    "replace",
    "spot-frozen",
    "spot-nearest",
    "play-from-anywhere",
]
Group: TypeAlias = Literal["solids", "stripes"]

_NOTHING: Mapping[str, Any] = {
    **dict.fromkeys(("player", "cue_ball", "in_hand", "why", "winner")),
    **dict.fromkeys(("on", "calls", "choices"), ()),
}


class _Request(Record):
    """What can be read of every request.

    Attributes:
        player: Who has to answer; None when the frame is over.
        cue_ball: Id of the cue ball.
        in_hand: The region in which the cue ball may be placed; None if it is played where it
            lies.
        on: Balls of which one must be hit first; empty if any may be.
        calls: The kinds of ``Call`` that are allowed. ``nothing`` is no call at all; where it is
            missing, one of the others is required.
        choices: What the player chooses from.
        why: The reason of a choice or of the end, in words.
        winner: Who has won; None while the frame goes on, and if it ended undecided.
    """

    __slots__ = ()
    _DEFAULTS: ClassVar = _NOTHING

    player: Any
    cue_ball: str | None
    in_hand: Region | None
    on: Sequence[str]
    calls: Sequence[CallKind]
    choices: Sequence[Choice]
    why: str | None
    winner: Literal[0, 1] | None


class ShotRequest(_Request):
    """The frame asks for a shot."""

    __slots__ = ()

    kind: Literal["shot"]
    player: Literal[0, 1]
    cue_ball: str


class ChoiceRequest(_Request):
    """The frame asks for a choice."""

    __slots__ = ()

    kind: Literal["choice"]
    player: Literal[0, 1]
    why: str


class OverRequest(_Request):
    """The frame is over."""

    __slots__ = ()

    kind: Literal["over"]
    player: None
    why: str


Request: TypeAlias = ShotRequest | ChoiceRequest | OverRequest

_REQUESTS: dict[str, type[Request]] = {
    "shot": ShotRequest,
    "choice": ChoiceRequest,
    "over": OverRequest,
}


def request(entry: Mapping[str, Any]) -> Request:
    """The request of a frame's ``to_dict``."""
    return _REQUESTS[entry["kind"]](entry)


class GameState(Record):
    """Values that only one game has; the keys are those of the frame's game.

    Attributes:
        groups: Eight-ball, Chinese eight-ball: each player's group; None while the table is open.
        on: Snooker: what is on: ``red``, ``color``, or ``sequence``, the colours in order.
        free_ball: Snooker: whether there is a free ball.
        break_: Snooker: points of the present break; the key is ``break``.
        points_left: Snooker: the most that the balls on the table are worth.
        misses: Six-red snooker: fouls and misses in a row of the same player.
        innings: Carom games: number of innings that each player has begun.
    """

    __slots__ = ()

    groups: list[Group | None]
    on: Literal["red", "color", "sequence"]
    free_ball: bool
    break_: int
    points_left: int
    misses: int
    innings: list[int]


class CaromCount(Record):
    """What a referee counts in a game without pockets.

    Attributes:
        balls: Object balls that the cue ball touched: 2 for two and more.
        cushions: Cushions that it touched before the second of them, or in the whole shot if it
            touched fewer than two.
        needed: Cushions that the shot needs.
        stayed: Whether the balls stayed in a corner's zone, so that the carom does not count.
    """

    __slots__ = ()

    balls: int
    cushions: int
    needed: int
    stayed: bool


class Foul(Record):
    """A foul.

    Attributes:
        what: The foul in words.
        rule: Its number in the rule book, or empty.
    """

    __slots__ = ()

    what: str
    rule: str
