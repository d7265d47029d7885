"""Games with a referee: whose shot it is, what is a foul and by which rule, and who wins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import deepcopy
from dataclasses import asdict, dataclass
from typing import Any, Self

from carom import _core
from carom.arguments import instance, number, numbers, text, truth, whole
from carom.batch import VARIABLES
from carom.build import Physics, Strike, Table
from carom.errors import InputError
from carom.shot import Shot
from carom.trace import Record, Trace

_FORMAT = "carom-frame/1"


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

    __slots__ = ("_core", "_moves", "_setup")
    _core: _core.Frame
    _moves: list[dict[str, Any]]
    _setup: dict[str, Any]

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
        seed, options = whole("seed", seed), _options(target, miss, patience)
        self._core = _core.Frame(text("game", game, '"nine-ball"'), table, physics, seed, options)
        self._moves = []
        self._setup = {
            "game": game,
            "table": _core.plain(table),
            "physics": _core.plain(physics),
            "seed": seed,
        } | _written(options)

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
        options = _options(target, miss, patience)
        frame = Frame.__new__(cls)
        frame._core = _core.Frame.of_shot(
            text("game", game, '"nine-ball"'),
            instance("shot", shot, Shot, "carom.Shot.from_dict(...)")._core,
            options,
        )
        frame._moves = []
        frame._setup = {"game": game, "shot": shot.to_dict()} | _written(options)
        return frame

    @classmethod
    def replay(cls, record: Mapping[str, Any]) -> Frame:
        """The frame of a record: begun anew, and every move of it made again.

        The same version of the engine gives the same frame, to the bit; with another one a shot may
        end otherwise, and a later move may then be refused.

        Args:
            record: What ``record`` gave.

        Raises:
            InputError: It is no such record, or a move is not allowed, with its index.
            EventCapError: As for ``play``.
        """
        if not isinstance(record, Mapping) or record.get("format") != _FORMAT:
            raise InputError(f'format: no record of a frame; its format would be "{_FORMAT}"')
        setup, moves = record.get("setup"), record.get("moves")
        if not isinstance(setup, Mapping) or not isinstance(moves, Sequence):
            raise InputError("record: setup or moves are missing; write what Frame.record gives")
        try:
            if "shot" in setup:
                shot = Shot.from_dict(setup["shot"])
                frame = cls.of_shot(**{**setup, "shot": shot})
            else:
                frame = cls(**setup)
        except TypeError as error:
            raise InputError(f"setup: {error}; write what Frame.record gives") from None
        for index, move in enumerate(moves):
            try:
                frame._make(move)
            except InputError as error:
                raise InputError(f"moves[{index}]: {error}") from None
        return frame

    def _make(self, move: Any) -> None:
        match move:
            case {"play": {"strike": dict() as strike, **rest}}:
                play: dict[str, Any] = {str(key): value for key, value in rest.items()}
                try:
                    if "call" in play:
                        play["call"] = Call(**play["call"])
                    self.play(Strike(**strike), **play)
                except TypeError as error:
                    raise InputError(f"play: {error}; write what Frame.record gives") from None
            case {"choice": choice}:
                self.choose(choice)
            case {"concede": True}:
                self.concede()
            case _:
                raise InputError("neither a play nor a choice; write what Frame.record gives")

    @property
    def record(self) -> dict[str, Any]:
        """How the frame began and every move of it, as plain values that JSON can hold.

        ``format``; ``setup``: what ``Frame`` or ``Frame.of_shot`` was given; ``moves``: each with
        ``play`` (``strike`` in SI units and radians, ``cue_ball``, ``call``), ``choice`` or
        ``concede``. ``Frame.replay`` makes the frame of it; so does ``pickle``.
        """
        return deepcopy({"format": _FORMAT, "setup": self._setup, "moves": self._moves})

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        return Frame.replay, (self.record,)

    def copy(self) -> Frame:
        """The same frame once more: to try a shot and go back."""
        twin = Frame.__new__(Frame)
        twin._core = self._core.copy()
        # Neither a setup nor a move that was made ever changes.
        twin._setup, twin._moves = self._setup, [*self._moves]
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
        arguments = _arguments(strike, cue_ball, call)
        ruling, trace = self._core.play(arguments)
        struck, place, _ = arguments
        play = {
            "strike": dict(zip(VARIABLES, struck, strict=True)),
            "cue_ball": place and list(place),
            "call": call and asdict(call),
        }
        self._moves.append({"play": {key: value for key, value in play.items() if value}})
        return Ruling._read(ruling, Trace._wrap(trace))

    def choose(self, choice: str) -> Ruling:
        """Answer a choice, with one of ``request.choices``.

        Raises:
            InputError: No choice is asked, or not this one.
        """
        ruling = self._core.choose(text("choice", choice, "one of request.choices"))
        self._moves.append({"choice": choice})
        return Ruling._read(ruling)

    def concede(self) -> Ruling:
        """The player whose turn it is gives up, and the other wins.

        Raises:
            InputError: The frame is over.
        """
        ruling = self._core.concede()
        self._moves.append({"concede": True})
        return Ruling._read(ruling)

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
        number(f"strike.{key}", getattr(strike, key)) for key in VARIABLES
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


def _written(options: tuple[int, bool, int]) -> dict[str, int | bool]:
    """The options as a record has them."""
    return dict(zip(("target", "miss", "patience"), options, strict=True))


def rule_sets() -> list[str]:
    """The names of the games that ``Frame`` knows."""
    return _core.rule_sets()
