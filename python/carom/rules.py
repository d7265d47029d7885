"""Games with a referee: whose shot it is, what is a foul and by which rule, and who wins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

from carom import _core
from carom.arguments import instance, number, numbers, text, truth, whole
from carom.build import Physics, Strike, Table
from carom.shot import Shot
from carom.trace import Record, Trace


@dataclass(frozen=True)
class Call:
    """What a player announces before a shot.

    Build one with ``Call.pocket("3", "top-left")``, ``Call.on("blue")``, ``Call.safety()`` or
    ``Call.push_out()``; no call at all is ``None``.

    Attributes:
        kind: ``pocket``, ``on``, ``safety`` or ``push-out``.
        ball: The ball that is called or nominated.
        into: The pocket that is called.
    """

    kind: str
    ball: str | None = None
    into: str | None = None

    def __post_init__(self) -> None:
        text("call.kind", self.kind, '"pocket"')
        if self.ball is not None:
            text("call.ball", self.ball, "its id")
        if self.into is not None:
            text("call.pocket", self.into, "its name")

    @classmethod
    def pocket(cls, ball: str, pocket: str) -> Self:
        """This ball in that pocket."""
        return cls("pocket", ball, pocket)

    @classmethod
    def on(cls, ball: str) -> Self:
        """This ball is the ball on: a colour, or the free ball (snooker)."""
        return cls("on", ball)

    @classmethod
    def safety(cls) -> Self:
        """The other player shoots next, whatever falls."""
        return cls("safety")

    @classmethod
    def push_out(cls) -> Self:
        """A push-out, after a legal break of nine-ball or ten-ball."""
        return cls("push-out")


@dataclass(frozen=True)
class Ruling:
    """What the referee says after a shot or a choice.

    Attributes:
        legal: Whether there was no foul.
        fouls: Each with ``what`` (words) and ``rule`` (its number in the rule book, or empty).
        points: What each player's score changed by.
        spotted: Balls that were put on a spot.
        racked: Whether the balls were racked again.
        trace: What happened; None for a choice.
    """

    legal: bool
    fouls: tuple[Record, ...]
    points: tuple[int, int]
    spotted: tuple[str, ...]
    racked: bool
    trace: Trace | None = None

    @classmethod
    def _read(cls, node: Mapping[str, Any], trace: Trace | None = None) -> Self:
        one, other = node["points"]
        return cls(
            legal=node["legal"],
            fouls=tuple(Record(foul) for foul in node["fouls"]),
            points=(one, other),
            spotted=tuple(node["spotted"]),
            racked=node["racked"],
            trace=trace,
        )


class Frame:
    """One rack, frame or match between players 0 and 1.

    It asks (``request``), and a player answers with ``play`` or ``choose``, until it is over::

        frame = carom.Frame("nine-ball", seed=7)
        ruling = frame.play(carom.Strike(speed=8.0, azimuth=1.57), cue_ball=(0.635, 0.6))
        frame.request.kind, frame.request.player, ruling.legal

    Args:
        game: ``eight-ball``, ``nine-ball``, ``ten-ball``, ``straight-pool``, ``snooker``,
            ``three-cushion`` or ``practice``.
        table: As in a shot; the game's own table if None.
        physics: As in a shot; the table's own if None.
        seed: Which of the random racks.
        target: Points that win straight pool and three-cushion.
        miss: Whether a foul and a miss is called in snooker.
        patience: Shots in a row without progress that make a stalemate; so every frame ends.

    Raises:
        InputError: There is no such game, or table and physics do not make sense.
    """

    __slots__ = ("_core",)
    _core: _core.Frame

    def __init__(
        self,
        game: str,
        *,
        table: Table | str | Mapping[str, Any] | None = None,
        physics: Physics | str | Mapping[str, Any] | None = None,
        seed: int = 0,
        target: int = 40,
        miss: bool = True,
        patience: int = 100,
    ) -> None:
        if isinstance(table, Table):
            table = table.description
        if isinstance(physics, Physics):
            physics = physics.description
        self._core = _core.Frame(
            text("game", game, '"nine-ball"'),
            table,
            physics,
            whole("seed", seed),
            _options(target, miss, patience),
        )

    @classmethod
    def of_shot(
        cls, game: str, shot: Shot, *, target: int = 40, miss: bool = True, patience: int = 100
    ) -> Frame:
        """A frame that goes on with the balls of a shot, as if nothing else had happened.

        Balls that the shot does not have are down, and player 0 shoots from where the cue ball
        lies: nobody has a point, a group or a foul; in eight-ball the table is open. Table and
        physics are the shot's, its strike does not count.

        Args:
            game: As for a new frame, like ``target``, ``miss`` and ``patience``.
            shot: Whose balls.
            target: Points that win.
            miss: Whether a foul and a miss is called in snooker.
            patience: Shots in a row without progress that make a stalemate.

        Raises:
            InputError: The game has no such balls, or would be over with them.
        """
        frame = Frame.__new__(cls)
        frame._core = _core.Frame.of_shot(
            text("game", game, '"nine-ball"'),
            instance("shot", shot, Shot, "carom.Shot.from_dict(...)")._core,
            _options(target, miss, patience),
        )
        return frame

    def copy(self) -> Frame:
        """The same frame once more: to try a shot and go back."""
        twin = Frame.__new__(Frame)
        twin._core = self._core.copy()
        return twin

    # Without these the copy module would give a second name for the same game.
    __copy__ = copy

    def __deepcopy__(self, _: dict[int, Any]) -> Frame:
        return self.copy()

    def to_dict(self) -> dict[str, Any]:
        """Everything that the properties say, as plain values."""
        return self._core.to_object()

    @property
    def game(self) -> str:
        """The game's name."""
        return str(self.to_dict()["game"])

    @property
    def request(self) -> Record:
        """What is asked next.

        ``kind`` is ``shot`` (with ``player``, ``cue_ball``, ``in_hand``: None, ``anywhere``,
        ``behind-head-string`` or ``the-d``; ``on``: balls of which one must be hit first, none if
        any may be; ``calls``: the kinds that may be made), ``choice`` (with ``player``,
        ``choices``, ``why``) or ``over`` (with ``winner``, ``why``).
        """
        return Record(self.to_dict()["request"])

    @property
    def over(self) -> bool:
        """Whether the frame has ended."""
        return bool(self.request["kind"] == "over")

    @property
    def player(self) -> int | None:
        """Whose turn it is; None when the frame is over."""
        return self.request.get("player")

    @property
    def scores(self) -> tuple[int, int]:
        """Points of the two players; games without points count none."""
        one, other = self.to_dict()["scores"]
        return one, other

    @property
    def fouls_in_a_row(self) -> tuple[int, int]:
        """Fouls that each player has made in a row."""
        one, other = self.to_dict()["fouls_in_a_row"]
        return one, other

    @property
    def balls(self) -> dict[str, tuple[float, float]]:
        """Where the balls on the table lie, m."""
        return {ball: (x, y) for ball, (x, y) in self.to_dict()["balls"].items()}

    @property
    def state(self) -> Record:
        """What this game has and others have not.

        ``groups`` in eight-ball; ``on``, ``free_ball``, ``break`` and ``points_left`` (the most
        that the balls on the table are worth) in snooker; ``innings`` in three-cushion.
        """
        return Record(self.to_dict()["state"])

    def shot(
        self,
        strike: Strike,
        *,
        cue_ball: Sequence[float] | None = None,
        call: Call | None = None,
    ) -> Shot:
        """The shot that ``play`` would play.

        Raises:
            InputError: As for ``play``.
        """
        return Shot._wrap(self._core.shot(_arguments(strike, cue_ball, call)))

    def play(
        self,
        strike: Strike,
        *,
        cue_ball: Sequence[float] | None = None,
        call: Call | None = None,
    ) -> Ruling:
        """Play a shot: it is simulated and ruled on, and the frame asks anew.

        Args:
            strike: How the cue ball is struck; which ball that is, the frame knows.
            cue_ball: Where the cue ball is put first (x, y in m), if it is in hand.
            call: What is announced.

        Raises:
            InputError: No shot is asked, the call is missing or not to be made, the cue ball is put
                where it must not be, or the strike cannot be played. The frame is unchanged then.
            EventCapError: The simulation reached its cap of events.
        """
        ruling, trace = self._core.play(_arguments(strike, cue_ball, call))
        return Ruling._read(ruling, Trace._wrap(trace))

    def choose(self, choice: str) -> Ruling:
        """Answer a choice, with one of ``request.choices``.

        Raises:
            InputError: No choice is asked, or not this one.
        """
        return Ruling._read(self._core.choose(text("choice", choice, "one of request.choices")))

    def concede(self) -> Ruling:
        """The player whose turn it is gives up, and the other wins.

        Raises:
            InputError: The frame is over.
        """
        return Ruling._read(self._core.concede())

    def __repr__(self) -> str:
        request = self.request
        asked = ", ".join(f"{key}={value!r}" for key, value in request.items() if value)
        return f"<Frame of {self.game}, {self.scores[0]}:{self.scores[1]}, asks {asked}>"


def _arguments(
    strike: Strike, cue_ball: Sequence[float] | None, call: Call | None
) -> tuple[
    tuple[float, float, float, float, float],
    tuple[float, ...] | None,
    tuple[str, str | None, str | None],
]:
    instance("strike", strike, Strike, "carom.Strike(speed=2.0, azimuth=1.57)")
    speed, azimuth, elevation, side, height = (
        number(f"strike.{key}", getattr(strike, key))
        for key in ("speed", "azimuth", "elevation", "side", "height")
    )
    place = None if cue_ball is None else numbers("cue_ball", cue_ball, 2)
    return (speed, azimuth, elevation, side, height), place, said(call)


def said(call: Call | None) -> tuple[str, str | None, str | None]:
    """What is announced, as Rust takes it."""
    if call is None:
        return "nothing", None, None
    instance("call", call, Call, 'carom.Call.pocket("1", "left")')
    return call.kind, call.ball, call.into


def _options(target: int, miss: bool, patience: int) -> tuple[int, bool, int]:
    # As Rust has them: 32 bits, one of them for a sign.
    return (
        whole("options.target", target, 1 << 31),
        truth("options.miss", miss),
        whole("options.patience", patience, 1 << 32),
    )


def rule_sets() -> list[str]:
    """The names of the games that ``Frame`` knows."""
    return _core.rule_sets()
