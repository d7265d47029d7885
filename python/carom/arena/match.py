"""A match between two players."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arena.contestants import Asking
from carom.arena.pair import OpenMatch, log_to
from carom.arena.pair_queue import PairQueue
from carom.arena.plan import MatchPlan
from carom.arena.processes import check, play_in_processes
from carom.arena.result import MatchResult
from carom.arena.sequential import SequentialTest
from carom.arguments import number, thread_count
from carom.build import Physics, Table
from carom.errors import InputError
from carom.files import checked_path
from carom.noise import Noise, Perception
from carom.player import Play, Player
from carom.player.situation import Chooser
from carom.progress import stage_bars
from carom.reference import DEFAULT_OPTIONS

if TYPE_CHECKING:
    import os


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
    test: SequentialTest | tuple[float, float] | None = None,
    secret: str | None = None,
    points: int = DEFAULT_OPTIONS.points,
    miss: bool = DEFAULT_OPTIONS.miss,
    patience: int = DEFAULT_OPTIONS.patience,
    max_events: int = 100_000,
    level: float = 0.95,
    luck: bool | int = False,
    threads: int | None = None,
    processes: int | None = None,
    strict: bool = False,
    progress: bool | Callable[[int, int], object] = False,
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
            ``out``. An external program is ``exec:COMMAND``, such as ``exec:python3 mine.py``; it
            is started for every frame.
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
        test: Two expected shares of the points of the first player, such as ``(0.5, 0.55)``; or a
            ``carom.arena.SequentialTest``, such as ``SequentialTest(0, 30, "nelo")``. A sequential
            test ends the match when it accepts one of the two hypotheses; of shares each has an
            error probability of 0.05.
        secret: 64 hexadecimal digits that determine all racks and errors, to repeat a match; None
            for a secret of the operating system.
        points: As for ``Frame``.
        miss: Whether a foul and a miss is called in snooker.
        patience: Number of shots in a row without progress that make a stalemate.
        max_events: Largest number of events of a shot.
        level: Confidence level of the intervals, in (0, 1).
        luck: Whether the luck of every shot is measured, for the share of the points that is
            corrected for it (``result.score.adjusted``); or the number of fresh errors of each
            shot (True: 256). It changes nothing of what is played.
        threads: Number of threads; None is one per core, and one if a player is not a built-in
            one. Players in Python take turns with the interpreter's lock, and a clock of seconds
            counts the time for which they wait.
        processes: Number of processes that play pairs, in place of threads, so that players in
            Python compute on all cores; None is this process alone. The players must be picklable:
            their classes stand at the top of a module or of the program, and a program that is a
            file has its call under ``if __name__ == "__main__":``.
        strict: Whether an exception of a player of one's own stops the match, and is raised. Pairs
            that had ended are kept. With it no external program is started unless its network,
            processes and files can be closed off.
        progress: Show a progress bar on stderr; or a function that is called with the number of
            pairs played and of all pairs now and then. Its exception stops the match.

    Raises:
        InputError: There is no such player or game, a value has the wrong type or is out of
            range, the folder has another match, a player cannot be pickled, or a process has
            ended.
        OSError: A file cannot be read or written.
    """
    plan = MatchPlan(
        one,
        other,
        game=game,
        pairs=pairs,
        noise=noise,
        perception=perception,
        table=table,
        physics=physics,
        simulations=simulations,
        frame_simulations=frame_simulations,
        time=time,
        clock=clock,
        breaker=breaker,
        same_break=same_break,
        disclosure=disclosure,
        test=test,
        secret=secret,
        points=points,
        miss=miss,
        patience=patience,
        max_events=max_events,
        luck=luck,
        strict=strict,
    )
    folder = checked_path("out", out, "match")
    confidence = number("level", level)
    with _reporting(progress) as report:
        if processes is not None:
            if threads is not None:
                raise InputError(
                    "conflict", "threads", "processes is given too", "give one of them"
                )
            count = check(dict(zip(("one", "other"), plan.players, strict=True)), processes)
            with OpenMatch(plan, folder) as match:
                report(0, match.played, pairs)
                play_in_processes(
                    PairQueue([match], lambda _: None),
                    min(count, pairs),
                    lambda: report(0, match.played, pairs),
                )
                return match.close(confidence)
        if threads is None and plan.asks:
            threads = 1
        asking = Asking(log_to(folder), plan.strict)
        with asking.watching() if plan.asks else nullcontext():
            fields = _core.play_match(
                plan.in_folder(folder).entrants(asking),
                plan.agreed,
                plan.secret,
                folder,
                confidence,
                thread_count(threads),
                report,
                asking.interrupt,
            )
    return MatchResult._read(fields, plan.game, plan.names, confidence, plan.test)


def _reporting(
    progress: bool | Callable[[int, int], object],
) -> AbstractContextManager[Callable[[int, int, int], object]]:
    """What Rust calls with the stage, the pairs played and all pairs."""
    if isinstance(progress, bool):
        return stage_bars(["pairs"], show=progress)
    return nullcontext(lambda _, done, count: progress(done, count))
