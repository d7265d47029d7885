"""``carom match``: frames between two players."""

from __future__ import annotations

import json as js
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, TypeVar

import typer

import carom
from carom import Perception
from carom.arena.contestants import is_of_player
from carom.arena.fresh_errors import DRAWS
from carom.arena.named_players import named_player
from carom.arena.same_break import preset_break
from carom.arena.sequential import SequentialTest
from carom.cli.options import NOISES, Json, Level, named_noise
from carom.cli.output import emit, emit_answer, read, say
from carom.errors import InputError
from carom.reference import DEFAULT_OPTIONS, points_help

T = TypeVar("T")


def match(
    one: Annotated[
        str | None,
        typer.Argument(
            metavar="[A]",
            help="The first player: a name, such as carom or carom:2000; a file and a class of "
            "your own in it, such as mine.py:Mine; or a program, such as 'exec:python3 mine.py'.",
        ),
    ] = None,
    other: Annotated[str | None, typer.Argument(metavar="[B]", help="The second player.")] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="Folder for the match.")
    ] = None,
    game: Annotated[str, typer.Option(help="The game.")] = "eight-ball",
    pairs: Annotated[
        int, typer.Option(min=1, help="Number of pairs of frames; with --test the largest number.")
    ] = 10,
    noise: Annotated[
        str | None,
        typer.Option(
            metavar="NAME[,NAME]",
            help=f"Noise of both players, or of each: {NOISES} Default: that of a level, else "
            "olympiad.",
        ),
    ] = None,
    perception: Annotated[
        str,
        typer.Option(
            metavar="SIGMA[,SIGMA]",
            help="Standard deviation of true minus perceived positions, per coordinate, m.",
        ),
    ] = "0",
    table: Annotated[
        str | None, typer.Option(help="A table's preset; default: the game's own.")
    ] = None,
    simulations: Annotated[
        str | None,
        typer.Option(
            metavar="N[,N]",
            help="Simulated shots of each decision; a number in a player's name replaces it.",
        ),
    ] = None,
    frame_simulations: Annotated[
        str | None, typer.Option(metavar="N[,N]", help="Simulated shots of a frame and player.")
    ] = None,
    time: Annotated[
        str | None, typer.Option(metavar="SECONDS[,SECONDS]", help="Time of each decision.")
    ] = None,
    clock: Annotated[
        str | None,
        typer.Option(
            metavar="SECONDS[,SECONDS]",
            help="Time of a frame and player; 600 if nothing else limits the players.",
        ),
    ] = None,
    breaker: Annotated[
        str, typer.Option(help="Who begins: alternate, or always A or B.")
    ] = "alternate",
    same_break: Annotated[
        str | None,
        typer.Option(
            metavar="PRESET",
            help="Both players break like this; carom break --presets lists the presets.",
        ),
    ] = None,
    test: Annotated[
        str | None,
        typer.Option(
            metavar="P0,P1",
            help="End the match when a sequential test accepts one of these shares of the points "
            "of player A, such as 0.5,0.55, or of these differences of normalised Elo, such as "
            "nelo:0,30.",
        ),
    ] = None,
    points: Annotated[int, typer.Option(min=1, help=points_help())] = DEFAULT_OPTIONS.points,
    secret: Annotated[
        str | None,
        typer.Option(
            metavar="DIGITS",
            help="64 hexadecimal digits that determine racks and errors, to repeat a match.",
        ),
    ] = None,
    luck: Annotated[
        bool,
        typer.Option(
            "--luck", help="Measure the luck of every shot, and correct the score for it."
        ),
    ] = False,
    luck_draws: Annotated[
        int, typer.Option(min=1, help="Number of fresh errors of each shot for --luck.")
    ] = DRAWS,
    level: Level = 0.95,
    threads: Annotated[
        int | None, typer.Option(min=1, help="Number of threads; default: one per core.")
    ] = None,
    processes: Annotated[
        int | None,
        typer.Option(
            min=1, help="Number of processes, in place of threads, for players in Python."
        ),
    ] = None,
    strict: Annotated[
        bool,
        typer.Option(
            "--strict",
            help="Stop at the first exception of a player of your own, and start no program that "
            "cannot be confined.",
        ),
    ] = False,
    replay: Annotated[
        str | None,
        typer.Option(
            metavar="RECORD", help="Play a record again and compare every bit; - is stdin."
        ),
    ] = None,
    json: Json = False,
) -> None:
    """Play a match between two players; print the score.

    Pairs of frames have the same rack and the same errors, with the seats exchanged. After a stop
    the same command continues.
    """
    measured = luck_draws if luck else False
    if replay is not None:
        _replay(replay, (one, other, out), measured, level, threads, json=json)
        return
    if one is None or other is None:
        raise InputError(
            "missing", "A", "two players are needed", "write their names: carom:200 carom:2000"
        )
    if out is None:
        raise InputError(
            "missing", "--out", "the match needs a folder", "give one, such as --out match"
        )
    try:
        result = carom.play_match(
            named_player("one", one),
            named_player("other", other),
            out=out,
            game=game,
            pairs=pairs,
            noise=None if noise is None else _each("noise", noise, named_noise),
            perception=_each("perception", perception, _perception),
            table=table,
            simulations=_numbers("simulations", simulations, int),
            frame_simulations=_numbers("frame-simulations", frame_simulations, int),
            time=_numbers("time", time, float),
            clock=_numbers("clock", clock, float),
            breaker=_breaker(breaker),
            same_break=None if same_break is None else preset_break(game, table, same_break),
            test=None if test is None else _test(test),
            points=points,
            secret=secret,
            level=level,
            luck=measured,
            threads=threads,
            processes=processes,
            strict=strict,
            progress=sys.stderr.isatty(),
        )
    except KeyboardInterrupt:
        say("stopped; the same command continues from here")
        raise
    except Exception as error:
        if not is_of_player(error):
            raise
        traceback.print_exception(error)
        say("a player raised this exception; the same command continues before this frame")
        raise typer.Exit(2) from None
    emit_answer(result, json=json)


def _replay(
    record: str,
    others: tuple[object, ...],
    luck: bool | int,
    level: float,
    threads: int | None,
    *,
    json: bool,
) -> None:
    if any(other is not None for other in others):
        raise InputError(
            "conflict", "--replay", "a record has its players", "leave A, B and --out out"
        )
    found = carom.replay_match(
        read(record), luck=luck, level=level, threads=threads, progress=sys.stderr.isatty()
    )
    if found.difference is not None:
        engine = ""
        if found.other_engine:
            engine = f"; it was written by {found.header['engine']}"
        where = f"line {found.difference['line']}, {found.difference['key']}"
        values = f"{found.difference['recorded']} against {found.difference['replayed']}"
        raise InputError("changed", record, f"not reproduced: {where}: {values}{engine}")
    if json:
        emit(js.dumps({"frames": found.frames, "reproduced": True, **found.score.to_dict()}))
        return
    emit("\n".join([f"reproduced bit by bit: {found.frames} frames", *found.score.lines()]))


def _each(name: str, words: str, make: Callable[[str], T]) -> tuple[T, T]:
    """The value of each player; one is for both."""
    items = [make(word) for word in words.split(",")]
    if len(items) > 2:
        raise InputError(
            "wrong-count", f"--{name}", f"{len(items)} values", "give one, or one for each player"
        )
    return items[0], items[-1]


def _numbers(name: str, words: str | None, kind: Callable[[str], T]) -> tuple[T, T] | None:
    if words is None:
        return None
    try:
        return _each(name, words, kind)
    except ValueError as error:
        if isinstance(error, InputError):
            raise
        kinds = "whole numbers" if kind is int else "numbers"
        raise InputError(
            "wrong-type", f"--{name}", f"{words!r} are not {kinds}", "write one or two"
        ) from None


def _perception(word: str) -> Perception:
    try:
        return Perception(float(word))
    except InputError:
        raise
    except ValueError:
        raise InputError(
            "wrong-type", "--perception", f"{word!r} is not a number", "write metres"
        ) from None


def _test(words: str) -> SequentialTest:
    unit, separator, bounds = words.rpartition(":")
    try:
        p0, p1 = map(float, bounds.split(","))
    except ValueError:
        raise InputError(
            "wrong-type",
            "--test",
            f"{words!r} is not P0,P1",
            "write two shares, such as 0.5,0.55, or two differences of normalised Elo, such as "
            "nelo:0,30",
        ) from None
    return SequentialTest(p0, p1, unit if separator else "shares")


def _breaker(word: str) -> str | int:
    if word == "alternate":
        return word
    if word not in ("A", "B"):
        raise InputError(
            "wrong-type", "--breaker", f"{word!r} is not a player", "write alternate, A or B"
        )
    return "AB".index(word)
