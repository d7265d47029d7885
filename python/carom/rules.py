"""Games with a referee, which rules on turns, fouls and the winner."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, replace
from typing import Any, Self

from carom import _core, notebook
from carom.arguments import instance, number, numbers, text, truth, whole
from carom.batch import VARIABLES
from carom.build import Physics, Strike, Table
from carom.call import Call, PlayArguments, fields_of, read_call
from carom.deprecated import renamed_arguments
from carom.errors import InputError
from carom.installed import ENGINE
from carom.noise import Noise
from carom.reference import DEFAULT_OPTIONS, Options
from carom.request import CaromCount, Choice, Foul, GameState, Request
from carom.request import request as read_request
from carom.shot import Shot
from carom.trace import Trace

_FORMAT = "carom-frame/1"
# The first whole number that JavaScript does not tell from its neighbour.
_SAFE = 1 << 53

#: A frame in Rust that a player sees.
SeenFrame = _core.Frame

# Most places of a cue ball in hand: one for each square millimetre of a table would take a minute.
_MOST_PLACES = 10**5

# The fields of a strike that are policies, in the order of `PlayArguments.policy`.
_POLICIES = ("obstruction", "miscue")


@dataclass(frozen=True)
class Ruling:
    """The referee's ruling after a shot or a choice.

    Attributes:
        legal: Whether there was no foul.
        fouls: Each with ``what`` (in words) and ``rule`` (its number in the rule book, or empty).
        points: Change of each player's score.
        spotted: Ids of the balls that were spotted.
        racked: Whether the balls were racked again.
        trace: The shot; None for a choice.
        carom: Balls and cushions of the cue ball; None for a choice and in games with pockets.
    """

    legal: bool
    fouls: tuple[Foul, ...]
    points: tuple[int, int]
    spotted: tuple[str, ...]
    racked: bool
    trace: Trace | None = None
    carom: CaromCount | None = None

    @classmethod
    def _read(cls, node: Mapping[str, Any], trace: Trace | None = None) -> Self:
        one, other = node["points"]
        return cls(
            legal=node["legal"],
            fouls=tuple(Foul(foul) for foul in node["fouls"]),
            points=(one, other),
            spotted=tuple(node["spotted"]),
            racked=node["racked"],
            trace=trace,
            carom=CaromCount(node["carom"]) if "carom" in node else None,
        )


@dataclass(frozen=True, slots=True)
class LegalAnswers:
    """The answers that a frame's request allows.

    Attributes:
        choices: The names of ``request.choices``; empty for a shot.
        calls: The calls of a shot, of which a play has one; None stands for a play without a call.
            Empty for a choice.
        places: Places of a cue ball in hand (x, y in m); None if it is not in hand.
    """

    choices: tuple[Choice, ...]
    calls: tuple[Call | None, ...]
    places: list[tuple[float, float]] | None


class Frame:
    """One rack, frame or match between players 0 and 1.

    ``request`` names the player and what to do; the answer is ``play`` or ``choose``, until
    the frame is over::

        frame = carom.Frame("nine-ball", seed=7)
        ruling = frame.play(carom.Strike(speed=8.0, azimuth=1.57), cue_ball=(0.635, 0.6))
        frame.request.kind, frame.request.player, ruling.legal

    Args:
        game: One of ``carom.rule_sets()``, such as ``eight-ball``.
        table: As in a shot; the game's own table if None.
        physics: As in a shot; the table's own if None.
        seed: Seed of the racks, below 2^64; or its 16 hexadecimal digits, as records of matches
            have it.
        points: Points that win games whose ``scoring`` is ``target``
            (``carom.game_facts()``), such as straight pool.
        miss: Whether a foul and a miss is called in snooker.
        patience: Number of shots in a row without progress that make a stalemate. It makes
            every frame end.

    Raises:
        InputError: There is no such game, or table or physics are invalid.
    """

    __slots__ = ("_core", "_moves", "_setup")
    _core: _core.Frame
    _moves: list[dict[str, Any]]
    _setup: dict[str, Any]

    @renamed_arguments(target="points")
    def __init__(
        self,
        game: str,
        *,
        table: Table | str | Mapping[str, Any] | None = None,
        physics: Physics | str | Mapping[str, Any] | None = None,
        seed: int | str = 0,
        points: int = DEFAULT_OPTIONS.points,
        miss: bool = DEFAULT_OPTIONS.miss,
        patience: int = DEFAULT_OPTIONS.patience,
    ) -> None:
        if isinstance(table, Table):
            table = table.description
        if isinstance(physics, Physics):
            physics = physics.description
        number, options = _rack_seed(seed), _options(points, miss, patience)
        name = text("game", game, '"nine-ball"')
        self._core = _core.Frame(name, table, physics, number, options)
        self._moves = []
        self._setup = {
            "game": game,
            # Dated names of presets: the record replays when the presets have other values.
            **_core.Frame.recorded_setup(game, table, physics),
            # A number of JavaScript does not hold 64 bits.
            "seed": number if number < _SAFE else f"{number:016x}",
        } | options._asdict()

    @classmethod
    @renamed_arguments(target="points")
    def of_shot(
        cls,
        game: str,
        shot: Shot,
        *,
        points: int = DEFAULT_OPTIONS.points,
        miss: bool = DEFAULT_OPTIONS.miss,
        patience: int = DEFAULT_OPTIONS.patience,
        player: int | None = None,
    ) -> Frame:
        """A frame that continues from the balls of a shot.

        Balls that the shot does not have count as pocketed. The player shoots from where the cue
        ball is; no player has a point, a group or a foul; in eight-ball the table is open. Table
        and physics are the shot's; of its strike only the struck ball is used.

        Args:
            game: The game, as for a new frame.
            shot: Table, physics and balls.
            points: Points that win games whose ``scoring`` is ``target``
            (``carom.game_facts()``), such as straight pool.
            miss: Whether a foul and a miss is called in snooker.
            patience: Number of shots in a row without progress that make a stalemate.
            player: The player who shoots, 0 or 1. None is the player whose cue ball the shot
                strikes, in games in which each player has one; otherwise player 0.

        Raises:
            InputError: The game does not have such balls, or would be over with them.
        """
        options = _options(points, miss, patience)
        if player is not None:
            player = whole("player", player, 2)
        frame = Frame.__new__(cls)
        frame._core = _core.Frame.of_shot(
            text("game", game, '"nine-ball"'),
            instance("shot", shot, Shot, "carom.Shot.from_dict(...)")._core,
            options,
            player,
        )
        frame._moves = []
        start: dict[str, Any] = {"game": game, "shot": shot._core.to_object(dated="all")}
        frame._setup = start | options._asdict()
        if frame.request.get("player") == 1:
            frame._setup["player"] = 1
        return frame

    @classmethod
    def replay(cls, record: Mapping[str, Any]) -> Frame:
        """The frame of a record, with every move repeated.

        The same version of the engine gives the same frame, to the bit. With another version a
        shot may end differently, and a later move may then be refused.

        Args:
            record: The value of ``Frame.record``. A shot may have ``variations``, a text of the
                page's analysis; the frame does not keep it.

        Raises:
            InputError: It is not such a record, or a move is not allowed; the message has the
                move's index.
            EventCapError: As for ``play``.
        """
        _core.check_record(record)
        setup, moves = record["setup"], record["moves"]
        if "target" in setup:
            # The key of records before the rename; a record is a file, so it is read silently.
            setup = {("points" if key == "target" else key): setup[key] for key in setup}
        try:
            if "shot" in setup:
                shot = Shot.from_dict(setup["shot"])
                frame = cls.of_shot(**{"player": 0, **setup, "shot": shot})
            else:
                frame = cls(**setup)
        except TypeError as error:
            raise InputError(
                "unknown-key", "setup", str(error), "give the value of Frame.record"
            ) from None
        for index, move in enumerate(moves):
            if frame._is_applied(move, moves[index - 1] if index else None):
                continue
            try:
                frame._make(move)
            except InputError as error:
                place = error.inside(f"moves[{index}]").place
                raise error.at(place, error.remedy + _other_engine(record)) from None
        return frame

    def _is_applied(self, move: Any, previous: Any) -> bool:
        """Whether the frame has already applied this choice of an old record.

        After a scratch on the break of eight-ball, frames used to ask for a choice with this one
        option. Now they apply it, so the move is left out of the record of the new frame.
        """
        return (
            move == {"choice": "play-from-hand"}
            and isinstance(previous, Mapping)
            and "play" in previous
            and self.game == "eight-ball"
            and self.request.get("in_hand") == "behind-head-string"
        )

    def _make(self, move: Any) -> None:
        match move:
            case {"play": {"strike": dict() as strike, **rest}}:
                play: dict[str, Any] = {str(key): value for key, value in rest.items()}
                try:
                    if "call" in play:
                        play["call"] = Call(**play["call"])
                    cling = play.pop("cling", None)
                    call = play.get("call")
                    arguments = play_arguments(Strike._recorded(strike), **play)
                    arguments = replace(arguments, cling=cling)
                    self._play(arguments, call, None, 0)
                except TypeError as error:
                    raise InputError(
                        "unknown-key", "play", str(error), "give the value of Frame.record"
                    ) from None
            case {"choice": choice}:
                self.choose(choice)
            case {"concede": True}:
                self.concede()
            case _:
                raise InputError(
                    "not-a-move",
                    "",
                    "not a play, a choice or a concession",
                    "give the value of Frame.record",
                )

    @property
    def record(self) -> dict[str, Any]:
        """The start of the frame and all its moves, as plain values that JSON can hold.

        The keys are ``format``; ``engine``: the name and version that made the record; ``setup``:
        the arguments of ``Frame`` or ``Frame.of_shot``;
        ``moves``: each with ``play`` (``strike`` in SI units and radians, with ``obstruction`` and
        ``miscue`` where they are not the usual ones; ``cue_ball``, ``call``, ``cling``),
        ``choice`` or ``concede``. ``Frame.replay`` restores the frame; ``pickle`` uses both.

        Raises:
            InputError: The frame is a player's copy or an environment's, which has no record.
        """
        if not self._setup:
            raise InputError(
                "wrong-state",
                "record",
                "this frame is a copy for a player, without its seed and its moves",
                "use frame.copy() to try a shot, or keep frame.to_dict()",
            )
        return deepcopy(
            {
                "format": _FORMAT,
                "engine": ENGINE,
                "setup": self._setup,
                "moves": self._moves,
            }
        )

    @property
    def hash(self) -> str:
        """16 hex digits over everything that decides how the frame goes on.

        They cover the game and its options, table, physics and policies, the exact bits of the
        balls' places, the request, scores and fouls, all that the rules keep from shot to shot, and
        the seed of the racks to come. The same version of the engine gives the same value in Rust,
        Python and JavaScript on every platform, so two programs that play one game can compare it
        (docs/lockstep.md).
        """
        return self._core.hash

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        return Frame.replay, (self.record,)

    @classmethod
    def _seen(cls, core: SeenFrame) -> Frame:
        """A frame that a player sees: it has no seed and no record."""
        frame = Frame.__new__(cls)
        frame._core, frame._setup, frame._moves = core, {}, []
        return frame

    def copy(self) -> Frame:
        """A copy of the frame, for example to try a shot."""
        twin = Frame.__new__(Frame)
        twin._core = self._core.copy()
        # Setup and moves never change, so the copy may share them.
        twin._setup, twin._moves = self._setup, [*self._moves]
        return twin

    # Without these methods the copy module would let both frames share one game.
    __copy__ = copy

    def __deepcopy__(self, _: dict[int, Any]) -> Frame:
        return self.copy()

    def to_dict(self) -> dict[str, Any]:
        """The values of all properties, as plain values."""
        return self._core.to_object()

    @property
    def game(self) -> str:
        """The game's name."""
        return str(self._core.entry("game"))

    @property
    def request(self) -> Request:
        """The next request, a dict whose keys are also attributes.

        ``kind`` is ``shot`` (with ``player``, ``cue_ball``, ``in_hand``: None, ``anywhere``,
        ``behind-head-string`` or ``the-d``; ``on``: balls of which one must be hit first, empty if
        any may be; ``calls``: the kinds of ``Call`` that are allowed, where ``nothing`` is no
        call), ``choice`` (with ``player``, ``choices``, ``why``) or ``over`` (with ``winner``,
        ``why``). An attribute that the kind does not have is None or empty.
        """
        return read_request(self._core.entry("request"))

    @property
    def over(self) -> bool:
        """Whether the frame has ended."""
        return self.request.kind == "over"

    @property
    def player(self) -> int | None:
        """The player whose turn it is; None when the frame is over."""
        return self.request.player

    @property
    def winner(self) -> int | None:
        """The player who has won; None while the frame goes on, and if it ended undecided."""
        return self.request.winner

    @property
    def scores(self) -> tuple[int, int]:
        """Points of the two players; zero in games without points."""
        one, other = self._core.entry("scores")
        return one, other

    @property
    def fouls_in_a_row(self) -> tuple[int, int]:
        """Number of fouls in a row of each player."""
        one, other = self._core.entry("fouls_in_a_row")
        return one, other

    @property
    def balls(self) -> dict[str, tuple[float, float]]:
        """Positions of the balls on the table, m, by id."""
        return {ball: (x, y) for ball, (x, y) in self._core.entry("balls").items()}

    @property
    def hand_bounds(self) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """The box around the region in which the cue ball may be placed, m.

        Its lower left and upper right corners; for the D it is the box around the half disk. None
        unless the cue ball is in hand.
        """
        bounds = self._core.hand_bounds
        if bounds is None:
            return None
        (left, bottom), (right, top) = bounds
        return (left, bottom), (right, top)

    @property
    def table(self) -> Table:
        """The table."""
        return self._bare_shot().table

    @property
    def physics(self) -> Physics:
        """The physics."""
        return self._bare_shot().physics

    def geometry(self) -> dict[str, Any]:
        """The table's dimensions, cushions and pockets, m, origin at the bottom left corner."""
        return self._bare_shot().geometry()

    def _bare_shot(self) -> Shot:
        """A shot on the frame's table with its physics; its balls are not those of the frame."""
        return Shot._wrap(_core.Shot.from_object(self._core.base()))

    def describe(self) -> str:
        """The frame as text, from which a person or a language model can play.

        It has the game, the score, the table, the place of every ball (m), and what the request
        allows. ``answer_schema`` is the form of an answer.
        """
        return self._core.describe()

    def answer_schema(self) -> dict[str, Any]:
        """The JSON Schema of an answer to the present request, for ``answer``.

        It has only the choices, calls, balls and pockets that are allowed. A play that follows it
        may still be refused: if the cue ball is placed within ``hand_bounds`` but not in the region
        or on another ball, or if the strike is beyond the miscue limit.
        """
        return self._core.answer_schema()

    def legal_answers(self, places: int = 64, seed: int = 0) -> LegalAnswers:
        """The answers that the request allows; a strike is the player's own.

        Args:
            places: Largest number of places of a cue ball in hand. They are spread evenly over the
                region; fewer are found where hardly any place is free.
            seed: Moves all places.
        """
        calls = [
            None if kind == "nothing" else Call(kind, ball, pocket)
            for kind, ball, pocket in self._core.legal_calls()
        ]
        found = self._core.legal_places(whole("places", places, _MOST_PLACES), whole("seed", seed))
        request = self.request
        return LegalAnswers(
            choices=tuple(request.choices),
            calls=tuple(calls),
            places=None if request.in_hand is None else [(x, y) for x, y in found],
        )

    @property
    def state(self) -> GameState:
        """Values that only this game has.

        ``groups`` in eight-ball and Chinese eight-ball; ``on``, ``free_ball``, ``break`` and
        ``points_left`` (the most that the balls on the table are worth) in snooker, and ``misses``
        too in six-red; ``innings`` in carom games.
        """
        return GameState(self._core.entry("state"))

    def shot(
        self,
        strike: Strike | Mapping[str, Any],
        *,
        cue_ball: Sequence[float] | None = None,
        call: Call | Mapping[str, Any] | None = None,
    ) -> Shot:
        """The shot that ``play`` would simulate.

        Raises:
            InputError: As for ``play``.
        """
        return Shot._wrap(self._core.shot(play_arguments(strike, cue_ball, call)))

    def play(
        self,
        strike: Strike | Mapping[str, Any],
        *,
        cue_ball: Sequence[float] | None = None,
        call: Call | Mapping[str, Any] | None = None,
        noise: Noise | None = None,
        seed: int | Sequence[int] = 0,
    ) -> Ruling:
        """Play a shot: simulate it, rule on it, and update the request.

        With ``noise`` the player errs: the strike and the contacts that cling are those of variant
        k of ``seed`` (``Noise.variant``), where k is the number of shots played so far. A drawn
        strike for which the tip's efficiency is too low is moved back to the nearest one that can
        be played. ``record`` has the strike that was played and these contacts.

        A match (``play_match``) has a seed for each player, and k counts the player's own shots. So
        the errors of a player do not depend on what the other one does. Two seeds do the same
        here: with the ``errors`` of a match record's ``seeds`` the frame is that of the match, to
        the bit.

        Args:
            strike: The strike, or a dict in the form of a shot file's ``strike``. Its ``ball`` is
                not used: the frame determines the cue ball. Without an elevation it gets the
                default one, and ``record`` has the angle. Its ``obstruction`` and ``miscue`` hold
                for this shot.
            cue_ball: Where to place the cue ball first (x, y in m), if it is in hand.
            call: What the player announces, or a dict with the attributes of a ``Call``.
            noise: Errors of the player; None for the strike as it is given, without cling.
            seed: Seed of the errors; or two, of player 0 and of player 1.

        Raises:
            InputError: No shot is requested, the call is missing or not allowed, the cue ball must
                not be placed there, a number is out of range, or the strike cannot be played, as
                given or as drawn. The frame is unchanged then.
            EventCapError: The simulation reached its largest number of events.
        """
        if noise is not None:
            instance("noise", noise, Noise, 'carom.Noise.preset("club")')
        arguments = play_arguments(strike, cue_ball, call)
        return self._play(arguments, read_call(call), noise, _seeds(seed))

    def answer(
        self,
        answer: Mapping[str, Any],
        *,
        noise: Noise | None = None,
        seed: int | Sequence[int] = 0,
    ) -> Ruling:
        """Answer the request with plain values, such as those of a program that writes JSON.

        Args:
            answer: ``{"play": {"strike": {...}, "cue_ball": [x, y], "call": {...}}}``,
                ``{"choice": name}`` or ``{"concede": True}``: the form of a move in ``record``.
                ``answer_schema`` is its JSON Schema.
            noise: Errors of the player, as for ``play``.
            seed: Seed of the errors, as for ``play``.

        Raises:
            InputError: The answer has another form, or as for ``play``, ``choose`` and
                ``concede``. The frame is unchanged then.
            EventCapError: As for ``play``.
        """
        match plain_answer(answer):
            case {"choice": choice}:
                return self.choose(choice)
            case {"play": play}:
                return self.play(**play, noise=noise, seed=seed)
            case _:
                return self.concede()

    def _play(
        self,
        arguments: PlayArguments,
        call: Call | None,
        noise: Noise | None,
        seeds: int | tuple[int, int],
    ) -> Ruling:
        ruling, core, struck, cling = self._core.play(arguments, noise, seeds)
        trace = Trace._wrap(core)
        written: dict[str, Any] = dict(zip(VARIABLES, struck, strict=True))
        if arguments.strike[2] is None and noise is None:
            written["elevation"] = trace.shot.elevation
        policies = zip(_POLICIES, arguments.policy, strict=True)
        written |= {key: word for key, word in policies if word != getattr(Strike, key)}
        play = {
            "strike": written,
            "cue_ball": arguments.cue_ball and list(arguments.cue_ball),
            "call": call and call.to_dict(),
            "cling": cling,
        }
        self._moves.append({"play": {key: value for key, value in play.items() if value}})
        return Ruling._read(ruling, trace)

    def choose(self, choice: Choice | str) -> Ruling:
        """Answer a choice with one of ``request.choices``.

        Raises:
            InputError: No choice is requested, or this answer is not among the choices.
        """
        ruling = self._core.choose(text("choice", choice, "one of request.choices"))
        self._moves.append({"choice": choice})
        return Ruling._read(ruling)

    def concede(self) -> Ruling:
        """Concede: the player whose turn it is loses.

        Raises:
            InputError: The frame is over.
        """
        ruling = self._core.concede()
        self._moves.append({"concede": True})
        return Ruling._read(ruling)

    def _repr_html_(self) -> str:
        """The picture, for notebooks."""
        return notebook.image(self)

    def __str__(self) -> str:
        return self.describe()

    def __repr__(self) -> str:
        request = self.request
        asked = ", ".join(f"{key}={value!r}" for key, value in request.items() if value)
        return f"<Frame of {self.game}, {self.scores[0]}:{self.scores[1]}, asks {asked}>"


def _rack_seed(seed: int | str) -> int:
    """The seed as a number."""
    if not isinstance(seed, str):
        return whole("seed", seed)
    if len(seed) != 16 or not set(seed) <= set("0123456789abcdef"):
        raise InputError(
            "syntax", "seed", f"found {seed!r}", "give 16 hexadecimal digits or a whole number"
        )
    return int(seed, 16)


def _seeds(seed: int | Sequence[int]) -> int | tuple[int, int]:
    if isinstance(seed, Sequence) and not isinstance(seed, str | bytes):
        if len(seed) != 2:
            raise InputError(
                "wrong-count",
                "seed",
                f"found {len(seed)} seeds",
                "give one, or one for each player",
            )
        return whole("seed[0]", seed[0]), whole("seed[1]", seed[1])
    return whole("seed", seed)


def _other_engine(record: Mapping[str, Any]) -> str:
    """The end of an error's sentence: the engine that made a record, if it is another one."""
    made = record.get("engine")
    if not isinstance(made, str) or made == ENGINE:
        return ""
    return f" (the record was made by {made}, and this is {ENGINE})"


def plain_answer(answer: Mapping[str, Any]) -> dict[str, Any]:
    """An answer of plain values, as ``Frame.answer`` takes it, with its form checked.

    Returns:
        ``play`` (a dict with ``strike``), ``choice`` or ``concede``, one of them.

    Raises:
        InputError: It has another form.
    """
    if not isinstance(answer, Mapping):
        _core.wrong_type(answer, "answer", '{"play": {...}}, {"choice": ...} or {"concede": true}')
    _core.check_keys(answer, "answer", ["play", "choice", "concede"])
    if len(answer) != 1:
        raise InputError(
            "not-a-move",
            "answer",
            f"found {len(answer)} keys",
            "write one of play, choice and concede",
        )
    if "concede" in answer and answer["concede"] is not True:
        raise InputError(
            "wrong-type", "answer.concede", "is not true", "write true, or leave it out"
        )
    if "play" in answer:
        play = answer["play"]
        if not isinstance(play, Mapping):
            _core.wrong_type(play, "answer.play", 'an object with "strike"')
        _core.check_keys(play, "answer.play", ["strike", "cue_ball", "call"])
        if "strike" not in play:
            raise InputError(
                "missing",
                "answer.play.strike",
                "is missing",
                'write {"speed": 2, "azimuth_deg": 90}',
            )
    return dict(answer)


def play_arguments(
    strike: Strike | Mapping[str, Any],
    cue_ball: Sequence[float] | None = None,
    call: Call | Mapping[str, Any] | None = None,
) -> PlayArguments:
    """A play in the form that Rust reads.

    Raises:
        InputError: A value has the wrong type.
    """
    # A strike is checked first: to ask whether it is a mapping takes longer than all the rest.
    if not isinstance(strike, Strike) and isinstance(strike, Mapping):
        strike = Strike.from_dict(strike)
    instance("strike", strike, Strike, "carom.Strike(speed=2.0, azimuth=1.57)")
    elevation = strike.elevation
    return PlayArguments(
        strike=(
            number("strike.speed", strike.speed),
            number("strike.azimuth", strike.azimuth),
            None if elevation is None else number("strike.elevation", elevation),
            number("strike.side", strike.side),
            number("strike.height", strike.height),
        ),
        policy=(
            text("strike.obstruction", strike.obstruction, '"report"'),
            text("strike.miscue", strike.miscue, '"report"'),
        ),
        cue_ball=None if cue_ball is None else numbers("cue_ball", cue_ball, 2),
        call=fields_of(call),
    )


def _options(points: int, miss: bool, patience: int) -> Options:
    # Rust holds them in 32 bits, `points` with a sign.
    return Options(
        whole("options.points", points, 1 << 31),
        truth("options.miss", miss),
        whole("options.patience", patience, 1 << 32),
    )
