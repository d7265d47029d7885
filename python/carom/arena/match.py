"""A match between two players."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from carom import _core
from carom.arena.contestants import Asking, Contestant, contestant
from carom.arena.result import MatchResult, Score, TestResult
from carom.arguments import number, numbers, text, thread_count, truth, whole
from carom.build import Physics, Table
from carom.errors import InputError
from carom.files import checked_path
from carom.noise import Noise, Perception, noise_or_default, perception_or_none
from carom.player import Play, Player
from carom.player.situation import Chooser
from carom.player.thinking import seconds
from carom.progress import stage_bars
from carom.reference import DEFAULT_OPTIONS
from carom.rules import Frame

if TYPE_CHECKING:
    import os

    T = TypeVar("T")

# Thinking time of a frame and player, s: that of the Computational Olympiad.
_OLYMPIAD = 600.0
# Error probabilities of a sequential test.
_ERROR_RATE = 0.05


def play_match(
    one: str | Chooser | Callable[[], Chooser] | Player,
    other: str | Chooser | Callable[[], Chooser] | Player,
    *,
    out: str | os.PathLike[str],
    game: str = "eight-ball",
    pairs: int = 10,
    noise: Noise | tuple[Noise, Noise] | None = None,
    perception: Perception | tuple[Perception, Perception] | None = None,
    table: Table | str | Mapping[str, Any] | None = None,
    physics: Physics | str | Mapping[str, Any] | None = None,
    simulations: int | tuple[int, int] | None = None,
    frame_simulations: int | tuple[int, int] | None = None,
    time: float | tuple[float, float] | None = None,
    clock: float | tuple[float, float] | None = None,
    breaker: str | int = "alternate",
    same_break: Play | None = None,
    disclosure: str = "both",
    test: tuple[float, float] | None = None,
    secret: str | None = None,
    points: int = DEFAULT_OPTIONS.points,
    miss: bool = DEFAULT_OPTIONS.miss,
    patience: int = DEFAULT_OPTIONS.patience,
    max_events: int = 100_000,
    level: float = 0.95,
    threads: int | None = None,
    strict: bool = False,
    progress: bool = False,
) -> MatchResult:
    """Play a match between two players, or continue it.

    The match consists of pairs of frames with the same rack and the same errors, in which the
    players exchange their seats. Every pair is written to ``out`` when it ends. If the call is
    interrupted, the same call continues the match. With simulated shots the match is the same for
    any number of threads and on every machine, if its secret is the same.

    Args:
        one: The first player. A built-in one is a name (``carom.players()`` lists them), which a
            number of simulated shots for each decision may follow, as in ``carom:2000``. A player
            of one's own is an object with a method ``choose(situation)`` (``carom.Situation``), of
            which every frame gets a copy by ``copy.deepcopy``; or a class or function without
            arguments, which is called for every frame. Its name is its attribute ``name``, or that
            of its class. An exception loses the frame; its traceback is in ``errors.log`` in
            ``out``.
        other: The second player, likewise.
        out: The folder of the match.
        game: The game, as for ``Frame``.
        pairs: Number of pairs of frames; with ``test`` the largest number.
        noise: Errors of the strikes, of both players or of each. None is those of a player that is
            a level, and the Olympiad's for another.
        perception: Errors of the positions that the players see; none if None.
        table: As in a shot; the game's own table if None.
        physics: As in a shot; the table's own if None.
        simulations: Simulated shots of each decision, of both players or of each.
        frame_simulations: Simulated shots of a frame and player, who plans with them; a player who
            has used them up loses the frame.
        time: Wall-clock time of each decision, s.
        clock: Wall-clock time of a frame and player, s; a player who has used it up loses the
            frame. Of ``simulations``, ``frame_simulations``, ``time`` and ``clock`` one may be
            given; without them a frame has 600 s. A number in a player's name replaces them.
        breaker: ``"alternate"``, or the player who begins every frame: 0 or 1.
        same_break: The intended break of both players; None if they choose it.
        disclosure: The players whose errors a player knows: ``"both"``, ``"own"`` or
            ``"nothing"``.
        test: Two expected shares of the points of the first player, such as ``(0.5, 0.55)``. A
            sequential test ends the match when it accepts one of them, each with an error
            probability of 0.05.
        secret: 64 hexadecimal digits that determine all racks and errors, to repeat a match; None
            for a secret of the operating system.
        points: As for ``Frame``.
        miss: Whether a foul and a miss is called in snooker.
        patience: Number of shots in a row without progress that make a stalemate.
        max_events: Largest number of events of a shot.
        level: Confidence level of the intervals, in (0, 1).
        threads: Number of threads; None is one per core, and one if a player is not a built-in
            one. Players in Python take turns with the interpreter's lock, and a clock of seconds
            counts the time for which they wait.
        strict: Whether an exception of a player of one's own stops the match, and is raised. Pairs
            that had ended are kept.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such player or game, a value has the wrong type or is out of
            range, or the folder has another match.
        OSError: A file cannot be read or written.
    """
    players = (contestant("one", one), contestant("other", other))
    folder = checked_path("out", out, "match")
    budgets: dict[str, Any] = {
        "simulations": simulations,
        "frame_simulations": frame_simulations,
        "time": time,
        "clock": clock,
    }
    clocks = _clocks(players, budgets)
    noises = _noises(players, noise)
    sights = tuple(perception_or_none(each) for each in _each("perception", perception))
    shares = None if test is None else _test(test)
    agreed = {
        "game": text("game", game, '"eight-ball"'),
        "options": {
            "points": whole("points", points, 1 << 31, low=1),
            "miss": truth("miss", miss),
            "patience": whole("patience", patience, 1 << 32, low=1),
        },
        "table": table.description if isinstance(table, Table) else table,
        "physics": physics.description if isinstance(physics, Physics) else physics,
        "max_events": whole("max_events", max_events, 1 << 32, low=1),
        "noise": [each.to_dict() for each in noises],
        "perception": [each.to_dict() for each in sights],
        "clock": clocks,
        "breaker": breaker,
        "same_break": None if same_break is None else _break(same_break, game, table, physics),
        "disclosure": text("disclosure", disclosure, '"both"'),
        "test": shares,
        "pairs": whole("pairs", pairs, low=1),
    }
    given = None if secret is None else text("secret", secret, "64 hexadecimal digits")
    confidence = number("level", level)
    asking = Asking(folder, truth("strict", strict))
    entrants = [
        player.name
        if player.make is None
        else (
            player.name,
            player.kind,
            asking.beginning(player, *_told(index, disclosure, noises, sights)),
        )
        for index, player in enumerate(players)
    ]
    are_asked = any(player.make is not None for player in players)
    if threads is None and are_asked:
        threads = 1
    watching = asking.watching() if are_asked else nullcontext()
    with stage_bars(["pairs"], show=progress) as report, watching:
        fields = _core.play_match(
            entrants,
            agreed,
            given,
            folder,
            confidence,
            thread_count(threads),
            report,
            asking.interrupt,
        )
    return _result(game, (players[0].name, players[1].name), fields, confidence, shares)


def _told(
    player: int,
    disclosure: str,
    noises: Sequence[Noise],
    sights: Sequence[Perception],
) -> tuple[tuple[Noise, Noise], Perception]:
    """The errors that a player knows: of its strikes and the other's, and of its perception."""
    nothing = Noise()
    own = nothing if disclosure == "nothing" else noises[player]
    other = noises[1 - player] if disclosure == "both" else nothing
    return (own, other), Perception() if disclosure == "nothing" else sights[player]


def _result(
    game: str,
    names: tuple[str, str],
    fields: dict[str, Any],
    level: float,
    test: dict[str, float] | None,
) -> MatchResult:
    state = fields["test"]
    return MatchResult(
        game=game,
        score=Score._read(fields["score"], names, level),
        test=None if state is None or test is None else TestResult(test["p0"], test["p1"], **state),
        record=None if fields["record"] is None else Path(fields["record"]),
        played_pairs=fields["played_pairs"],
        secret_sha256=fields["secret_sha256"],
    )


def _each(name: str, value: T | tuple[T, T]) -> tuple[T, T]:
    """The value of each player."""
    if not isinstance(value, tuple | list):
        return value, value
    if len(value) != 2:
        raise InputError(
            "wrong-count", name, f"{len(value)} values", "give one, or one for each of two players"
        )
    return value[0], value[1]


def _noises(players: tuple[Contestant, Contestant], noise: Any) -> list[Noise]:
    """The errors of both players."""
    if noise is None:
        return [noise_or_default(player.noise) for player in players]
    return [noise_or_default(each) for each in _each("noise", noise)]


def _clocks(
    players: tuple[Contestant, Contestant], given: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """The players' clocks in the form of a record."""
    written = [name for name, value in given.items() if value is not None]
    if len(written) > 1:
        raise InputError("duplicate", written[1], f"{written[0]} is given too", "give one of them")
    name = written[0] if written else "clock"
    amounts = _each(name, given[name] if written else _OLYMPIAD)
    clocks: list[dict[str, Any]] = []
    for player, amount in zip(players, amounts, strict=True):
        if player.simulations is not None:
            clocks.append({"simulations": player.simulations, "per": "decision"})
            continue
        per = "decision" if name in ("simulations", "time") else "frame"
        if name.endswith("simulations"):
            clocks.append({"simulations": whole(name, amount, 1 << 32, low=1), "per": per})
        else:
            clocks.append({"seconds": seconds(name, amount), "per": per})
    return clocks


def _break(
    play: Play,
    game: str,
    table: Table | str | Mapping[str, Any] | None,
    physics: Physics | str | Mapping[str, Any] | None,
) -> dict[str, Any]:
    """A break in the form of a record of a match; with the default elevation if it has none."""
    if not isinstance(play, Play):
        raise InputError(
            "wrong-type", "same_break", f"found a {type(play).__name__}", "give carom.Play(...)"
        )
    if play.strike.elevation is None:
        try:
            shot = play.shot(Frame(game, table=table, physics=physics))
        except InputError as error:
            raise error.inside("same_break") from None
        play = replace(play, strike=replace(play.strike, elevation=shot.elevation))
    written = play.to_dict()
    if play.call is not None:
        call = {"kind": play.call.kind, "ball": play.call.ball, "pocket": play.call.into}
        written["call"] = {key: value for key, value in call.items() if value is not None}
    return written


def _test(shares: Sequence[float]) -> dict[str, float]:
    p0, p1 = numbers("test", shares, 2)
    return {"p0": p0, "p1": p1, "alpha": _ERROR_RATE, "beta": _ERROR_RATE}
