"""The players that carom has built in."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Self

from carom import _core
from carom.arguments import instance, text, thread_count, whole
from carom.errors import InputError
from carom.noise import Noise, Perception
from carom.plan import TablePosterior
from carom.plan.drawn_tables import on_learned_table
from carom.player.analysis import Analysis
from carom.player.decision import Decision
from carom.player.on_tables import CANDIDATES, check_tables, ranked_on_tables
from carom.player.thinking import MOST_SIMULATIONS, USUAL_SIMULATIONS, Thinking
from carom.rules import Frame
from carom.shot import Shot

# Most plays of an analysis: more than a search has candidates.
_MOST_PLAYS = 1000


class Player:
    """A player that chooses shots and explains them.

    ::

        frame = carom.Frame("eight-ball", seed=7)
        player = carom.Player(noise=carom.Noise.preset("club"))
        while not frame.over:
            player.choose(frame).apply(frame)

    A decision depends only on the frame, the errors of both players, the seed and the budget: it
    has the same bits for any number of threads, on every platform. The search works in rounds,
    each with 1.6 times as many simulated shots as the one before. It ends when the budget is
    spent. A clock ends it between two rounds, so a decision with ``time=`` depends on the machine;
    ``rounds=`` with the number of rounds of such a decision repeats it.

    Ctrl-C ends the search after its present round, and the best play so far is returned, with
    ``interrupted`` set. A second Ctrl-C raises KeyboardInterrupt.

    Args:
        level: The name of a built-in player (``carom.players()`` lists them), such as ``level-3``.
            Settings and a number of simulated shots may follow, as in ``carom[shift=false]:2000``.
            None is ``carom``.
        noise: Errors of the player's strikes. None is those of the level, and the Olympiad's for a
            player that is not a level.
        perception: Errors of the positions that the player sees; none if None.
        simulations: Largest number of simulated shots of a decision. None is the number in
            ``level``, else 20 000, or no limit if ``time`` or ``rounds`` is given.
        time: Wall-clock time of a decision, s. No round begins that would probably end later, but
            every decision has at least one round.
        rounds: Largest number of rounds of a decision.
        seed: Seed of the random numbers of each decision.
        threads: Number of threads; None is one per core. Decisions do not depend on it.

    Raises:
        InputError: There is no such player, or a value has the wrong type or is out of range.
    """

    def __init__(
        self,
        level: str | None = None,
        *,
        noise: Noise | None = None,
        perception: Perception | None = None,
        simulations: int | None = None,
        time: float | None = None,
        rounds: int | None = None,
        seed: int = 0,
        threads: int | None = None,
    ) -> None:
        name = "carom" if level is None else text("level", level, '"carom"')
        self._level = name
        self._core = _core.Player(name)
        unlimited = time is not None or rounds is not None
        named = self._core.simulations
        if simulations is None:
            simulations = named or (MOST_SIMULATIONS if unlimited else USUAL_SIMULATIONS)
        elif ":" in name:
            raise InputError(
                "duplicate",
                "simulations",
                f"the name {name!r} has a number of them too",
                "write only one",
            )
        self._thinking = Thinking(
            noise=self._usual_noise() if noise is None else noise,
            perception=perception,
            seed=seed,
            simulations=simulations,
            rounds=rounds,
            time=time,
        )
        thread_count(threads)
        self._threads = threads

    @property
    def name(self) -> str:
        """The name of the built-in player."""
        return self._core.name

    @property
    def noise(self) -> Noise:
        """The errors of the player's strikes."""
        noise = self._thinking.noise
        assert noise is not None
        return noise

    def _usual_noise(self) -> Noise | None:
        """The errors of a level; None for a player that is not one."""
        fields = self._core.noise
        return None if fields is None else Noise(*fields)

    def choose(
        self,
        frame: Frame | Shot,
        *,
        game: str | None = None,
        noise: Noise | None = None,
        opponent_noise: Noise | None = None,
        posterior: TablePosterior | None = None,
        draws: int = 32,
    ) -> Decision:
        """Answer the request of a frame. The frame is not changed.

        Args:
            frame: The frame; or a shot, of which table, physics and balls are used.
            game: The game, for a shot.
            noise: Errors of the player's strikes in this decision; None is the player's.
            opponent_noise: Errors of the opponent's strikes; None is those of the player.
            posterior: What is known about the table, as for ``explain``, whose best play is
                returned. A choice is made on the learned table alone.
            draws: Number of tables that may be the true one, from 2 to 1000.

        Raises:
            InputError: The frame is over, a value has the wrong type, the balls of the shot do
                not fit the game, or the table of the frame is not the learned one.
            EventCapError: A simulated shot reached its largest number of events.
        """
        position = _frame_of(frame, game, posterior)
        thinking = self._options(noise, opponent_noise)
        if posterior is not None and position.request.kind == "shot":
            found = self._explained(position, 1, thinking, posterior, draws)
            if found.best is not None:
                return Decision(
                    found.best.play,
                    win_chance=found.best.win_chance,
                    simulations=found.simulations,
                    rounds=found.rounds,
                    interrupted=found.interrupted,
                )
        fields = self._core.choose(position._core, thinking, thread_count(self._threads))
        return Decision._read(fields)

    def explain(
        self,
        frame: Frame | Shot,
        count: int = 5,
        *,
        game: str | None = None,
        noise: Noise | None = None,
        opponent_noise: Noise | None = None,
        posterior: TablePosterior | None = None,
        draws: int = 32,
    ) -> Analysis:
        """The best plays of a position with their chances. The frame is not changed.

        The chances of every play are counted with errors of their own, after the search.

        Args:
            frame: The frame, which requests a shot; or a shot, of which table, physics and balls
                are used.
            count: Largest number of plays.
            game: The game, for a shot.
            noise: Errors of the player's strikes in this search; None is the player's.
            opponent_noise: Errors of the opponent's strikes; None is those of the player.
            posterior: What is known about the table, such as a ``carom.learn.Posterior``. A shot is
                put on the learned table; a frame must have it. The search is one on the learned
                table. Its best plays, at least eight, are then ranked by their chances over drawn
                tables: how often the turn is kept, fouls and the leave are counted there, while a
                kept and a missed turn are worth what they are on the learned table.
            draws: Number of tables that may be the true one, from 2 to 1000.

        Raises:
            InputError: The frame is over or requests a choice, a value has the wrong type, the
                balls of the shot do not fit the game, or the table of the frame is not the learned
                one.
            EventCapError: A simulated shot reached its largest number of events.
        """
        position = _frame_of(frame, game, posterior)
        most = whole("count", count, _MOST_PLAYS + 1, low=1)
        return self._explained(
            position, most, self._options(noise, opponent_noise), posterior, draws
        )

    def _explained(
        self,
        frame: Frame,
        count: int,
        thinking: Thinking,
        posterior: TablePosterior | None,
        draws: int,
    ) -> Analysis:
        position, most = frame.copy(), count
        if posterior is not None:
            check_tables(position, posterior, draws)
            most = max(count, CANDIDATES)
        fields = self._core.explain(position._core, thinking, most, thread_count(self._threads))
        found = Analysis._read(fields, position, thinking)
        if posterior is None:
            return found
        return ranked_on_tables(found, posterior, draws, count, self._threads)

    def stop(self) -> None:
        """End the decisions in progress, from another thread.

        Each returns the best play so far when its present round ends.
        """
        self._core.stop()

    def _options(self, noise: Noise | None, opponent_noise: Noise | None) -> Thinking:
        if noise is None and opponent_noise is None:
            return self._thinking
        noise = self.noise if noise is None else noise
        return replace(self._thinking, noise=noise, opponent_noise=opponent_noise)

    @classmethod
    def _restored(cls, level: str, thinking: Thinking, threads: int | None) -> Self:
        player = cls.__new__(cls)
        player._level, player._thinking, player._threads = level, thinking, threads
        player._core = _core.Player(level)
        return player

    def __reduce__(self) -> tuple[Any, tuple[str, Thinking, int | None]]:
        # A player has only settings: a copy decides the same, and `stop` of one leaves the other.
        return type(self)._restored, (self._level, self._thinking, self._threads)

    def __repr__(self) -> str:
        own = self._thinking
        limits = {"simulations": own.simulations, "rounds": own.rounds, "time": own.time}
        given = ", ".join(f"{key}={value}" for key, value in limits.items() if value is not None)
        return f"<carom.Player {self.name!r}: {given}, seed={own.seed}>"


def players() -> list[str]:
    """The names of the built-in players, for ``carom.Player`` and ``carom match``."""
    return _core.players()


def _frame_of(
    frame: Frame | Shot, game: str | None, posterior: TablePosterior | None = None
) -> Frame:
    """The frame; that of a shot is on the learned table, if there is one."""
    if isinstance(frame, Shot):
        if game is None:
            raise InputError(
                "missing", "game", "a shot has no game", 'give one, such as game="eight-ball"'
            )
        return Frame.of_shot(
            game, frame if posterior is None else on_learned_table(frame, posterior)
        )
    instance("frame", frame, Frame, 'carom.Frame("nine-ball")')
    if game is not None:
        raise InputError("conflict", "game", "the frame has a game", "leave it out")
    return frame
