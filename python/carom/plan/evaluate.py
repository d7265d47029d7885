"""The probabilities of a shot's results, given the player's errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core, columns
from carom.arguments import core, text, thread_count
from carom.call import fields_of
from carom.device import opened
from carom.errors import InputError
from carom.noise import Noise, Perception, noise_or_default, perception_or_none
from carom.plan.chance import Chance, chances_to_dict, or_null
from carom.plan.drawn_tables import on_drawn_tables
from carom.plan.lookup import ball_and_pocket, core_of, no_such_pocket, pocket_names
from carom.plan.options import Sampling
from carom.progress import stage_bars

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    import carom
    from carom.call import Call
    from carom.plan.drawn_tables import TablePosterior


@dataclass(frozen=True, slots=True, eq=False)
class ResultCounts:
    """How often variants had each result.

    Attributes:
        n: Number of variants.
        failed: Number of variants that could not be played. No ball falls in them.
        legal: Number of legal variants; None without a frame.
        turn_kept: Number of variants after which the player has the turn again or has won; None
            without a frame.
        potted: Number of variants in which each ball fell into each pocket, int64 of shape
            (n_balls, n_pockets).
        off_table: Number of variants in which each ball left the table, int64 of shape
            (n_balls,).
    """

    n: int
    failed: int
    legal: int | None
    turn_kept: int | None
    potted: NDArray[np.int64]
    off_table: NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Evaluation:
    """The results of a shot's variants; ``print`` it for a table.

    Attributes:
        shot: The intended shot; with a posterior, on the learned table.
        noise: Errors of the strike.
        perception: Errors of the perceived positions.
        seed: Seed of the random numbers.
        n: Number of variants.
        level: Confidence level of the intervals.
        pockets: The pockets' names; columns of ``potted``.
        potted: Number of variants in which each ball fell into each pocket, int64 of shape
            (n_balls, n_pockets).
        off_table: Number of variants in which each ball left the table, int64 of shape
            (n_balls,).
        failed: Number of variants that could not be played. No ball falls in
            them.
        first_failure: The error of the first of them; None if there is none.
        legal_count: Number of legal variants; None without a frame.
        turn_kept_count: Number of variants after which the player has the turn again or has won;
            None without a frame.
        at_rest: Number of variants in which each ball was on the table at the end, int64 of shape
            (n_balls,).
        end_mean: Mean place of rest in these variants, m, shape (n_balls, 2); NaN without any.
        end_covariance: Covariance of the place of rest, m², shape (n_balls, 2, 2); NaN with fewer
            than two such variants.
        by_table: The counts on each drawn table; empty without a posterior, or if it leaves nothing
            about the table unknown. Every chance has its share on each.
        cue_ball: Index of the cue ball.
        cue_ball_ends: Where the cue ball came to rest in each variant, m, shape (n, 2); NaN where
            it fell, left the table, or the variant failed.
    """

    shot: carom.Shot
    noise: Noise
    perception: Perception
    seed: int
    n: int
    level: float
    pockets: tuple[str, ...]
    potted: NDArray[np.int64]
    off_table: NDArray[np.int64]
    failed: int
    first_failure: str | None
    legal_count: int | None
    turn_kept_count: int | None
    at_rest: NDArray[np.int64]
    end_mean: NDArray[np.float64]
    end_covariance: NDArray[np.float64]
    by_table: tuple[ResultCounts, ...]
    cue_ball: int
    cue_ball_ends: NDArray[np.float64]

    @property
    def counts(self) -> ResultCounts:
        """The counts of all variants."""
        return ResultCounts(
            self.n,
            self.failed,
            self.legal_count,
            self.turn_kept_count,
            self.potted,
            self.off_table,
        )

    def chance(self, count: int | Callable[[ResultCounts], int]) -> Chance:
        """The chance of a result.

        Args:
            count: The number of variants in which it occurred, as a function of the counts; without
                drawn tables also the number itself.

        Raises:
            InputError: It is a number, and there are drawn tables.
        """
        if not self.by_table:
            met = count(self.counts) if callable(count) else count
            return Chance.of(int(met), self.n, self.level)
        if not callable(count):
            raise InputError(
                "wrong-type",
                "count",
                "the interval needs the number on each drawn table",
                "give a function of the counts, such as lambda counts: counts.failed",
            )
        return Chance.over_tables(
            ((int(count(counts)), counts.n) for counts in self.by_table), self.level
        )

    def pot(self, ball: str) -> Chance:
        """The chance that a ball falls into any pocket.

        Raises:
            InputError: There is no such ball.
        """
        return self._falls(self._ball(ball))

    def pocket(self, ball: str, pocket: str) -> Chance:
        """The chance that a ball falls into the given pocket.

        Raises:
            InputError: There is no such ball or pocket.
        """
        if text("pocket", pocket, "its name") not in self.pockets:
            raise no_such_pocket(pocket, self.pockets)
        return self._falls_into(self._ball(ball), self.pockets.index(pocket))

    def leaves_table(self, ball: str) -> Chance:
        """The chance that a ball leaves the table.

        Raises:
            InputError: There is no such ball.
        """
        row = self._ball(ball)
        return self.chance(lambda counts: int(counts.off_table[row]))

    @property
    def scratch(self) -> Chance:
        """The chance that the cue ball falls."""
        return self._falls(self.cue_ball)

    @property
    def failure(self) -> Chance:
        """The chance that the strike cannot be played, as with an obstructed cue."""
        return self.chance(lambda counts: counts.failed)

    @property
    def legal(self) -> Chance | None:
        """The chance that the shot is legal; None without a frame."""
        return None if self.legal_count is None else self.chance(lambda c: c.legal or 0)

    @property
    def turn_kept(self) -> Chance | None:
        """The chance that the player has the turn again or has won; None without a frame."""
        return None if self.turn_kept_count is None else self.chance(lambda c: c.turn_kept or 0)

    def _falls(self, row: int) -> Chance:
        return self.chance(lambda counts: int(counts.potted[row].sum()))

    def _falls_into(self, row: int, column: int) -> Chance:
        return self.chance(lambda counts: int(counts.potted[row, column]))

    def chances(self) -> dict[str, Chance]:
        """The chances of all results that occurred, by name; ``scratch`` in any case."""
        ids = self.shot.ids
        named: dict[str, Chance] = {}
        for row, ball in enumerate(ids):
            if row == self.cue_ball:
                continue
            if self.potted[row].any():
                named[f"{ball} falls"] = self._falls(row)
            for column, pocket in enumerate(self.pockets):
                if self.potted[row, column]:
                    named[f"{ball} into {pocket}"] = self._falls_into(row, column)
        if self.pockets:
            named["scratch"] = self.scratch
        for row, ball in enumerate(ids):
            if self.off_table[row]:
                named[f"{ball} off the table"] = self.leaves_table(ball)
        if self.legal is not None and self.turn_kept is not None:
            named |= {"legal": self.legal, "turn kept": self.turn_kept}
        if self.failed:
            named["not to be played"] = self.failure
        return named

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON; without ``cue_ball_ends``."""
        return {
            "n": self.n,
            "tables": max(len(self.by_table), 1),
            "seed": self.seed,
            "level": self.level,
            "noise": self.noise.to_dict(),
            "perception": self.perception.to_dict(),
            "balls": self.shot.ids,
            "pockets": list(self.pockets),
            "potted": self.potted.tolist(),
            "off_table": self.off_table.tolist(),
            "failed": self.failed,
            "first_failure": self.first_failure,
            "legal": self.legal_count,
            "turn_kept": self.turn_kept_count,
            "at_rest": self.at_rest.tolist(),
            "end_mean": or_null(self.end_mean.tolist()),
            "end_covariance": or_null(self.end_covariance.tolist()),
            "chances": chances_to_dict(self.chances()),
        }

    def __str__(self) -> str:
        rows = [(what, str(chance)) for what, chance in self.chances().items()]
        x, y = self.end_mean[self.cue_ball]
        if self.at_rest[self.cue_ball] > 1:
            spread = [float(v) ** 0.5 for v in self.end_covariance[self.cue_ball].diagonal()]
            place = f"{x:.3f} ± {spread[0]:.3f}, {y:.3f} ± {spread[1]:.3f} m"
            rows.append((f"{self.shot.ids[self.cue_ball]} ends at", place))
        tables = f" on {len(self.by_table)} drawn tables" if self.by_table else ""
        title = f"{self.n} variants{tables}; intervals at {100 * self.level:g} % confidence"
        return "\n".join([title, *(f"  {line}" for line in columns.lines(rows))])

    def __repr__(self) -> str:
        return f"<carom.Evaluation: {self.n} variants of {self.shot!r}>"

    def _ball(self, ball: str) -> int:
        ids = self.shot.ids
        if text("ball", ball, "its id") not in ids:
            raise InputError(
                "unknown-ball", "ball", f"there is no {ball!r}", f"write one of {', '.join(ids)}"
            )
        return ids.index(ball)


def evaluate(
    shot: carom.Shot,
    noise: Noise,
    n: int = 10_000,
    seed: int = 0,
    *,
    perception: Perception | None = None,
    precision: float | None = None,
    watch: str | tuple[str, str] | None = None,
    frame: carom.Frame | None = None,
    call: Call | None = None,
    posterior: TablePosterior | None = None,
    draws: int = 32,
    level: float = 0.95,
    threads: int | None = None,
    device: str = "cpu",
    progress: bool = False,
) -> Evaluation:
    """The probability of each result, if a player who errs intends the shot's strike.

    The variants are those of ``Shot.vary`` with the same noise, perception and seed.

    Args:
        shot: The shot as the player sees and plans it.
        noise: Errors of the strike.
        n: Largest number of variants.
        seed: Seed of the random numbers, a whole number from 0 to 2⁶⁴ − 1.
        perception: Errors of the perceived positions. Every variant has a layout of its own
            around the shot's, as ``Perception.see`` draws it. The tip meets the cue ball at its
            true position.
        precision: Stop as soon as half the width of the watched interval is at most this; checked
            after every 1024 variants. None plays all ``n``.
        watch: The watched chance: a ball's id, ``(ball, pocket)``, ``"scratch"`` or ``"legal"``;
            None watches all that are counted.
        frame: The game in which the shot is played; its rules decide what is legal. The shot must
            be the one that the frame requests, as ``frame.shot(...)`` returns it.
        call: What the player announces to the frame.
        posterior: What is known about the table, such as a ``carom.learn.Posterior``. The shot is
            then planned on the learned table in place of its own, and variant k is played on table
            k modulo ``draws`` of those that may be the true one. The strikes are the same on all
            tables. A frame must have the learned table.
        draws: Number of these tables, from 2 to 1000. Those on which balls overlap by more than
            5 mm are left out.
        level: Confidence level of the intervals, in (0, 1).
        threads: Number of threads; None is one per core. The result does not depend on it.
        device: ``"cpu"``, ``"cuda"`` or ``"cuda:1"``; see ``carom.device``.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The shot has no strike, a number is out of range, there is no such ball or
            pocket to watch, the frame requests another shot, balls have no room on most drawn
            tables (they overlap there by more than 5 mm), ``device`` cannot be used, or it is given
            with a frame.
    """
    sampling = Sampling(noise, perception, seed, n, precision, level)
    shot, tables = on_drawn_tables(shot, posterior, draws, sampling.n, sampling.seed, frame)
    watched = None
    if watch is not None:
        if precision is None:
            raise InputError(
                "conflict", "watch", "it has no effect without precision", "give precision too"
            )
        watched = ball_and_pocket("watch", watch)
    card = opened(device)
    with stage_bars(["shots"], show=progress) as report:
        found = _core.evaluate(
            core_of(shot),
            sampling,
            watched,
            _referee(frame, call),
            tables,
            thread_count(threads),
            card,
            report,
        )
    counts = found.pop("counts")
    by_table = tuple(ResultCounts(**table) for table in found.pop("by_table"))
    return Evaluation(
        shot=shot,
        noise=noise_or_default(noise),
        perception=perception_or_none(perception),
        seed=sampling.seed,
        level=sampling.level,
        pockets=tuple(pocket_names(shot)),
        legal_count=counts.pop("legal"),
        turn_kept_count=counts.pop("turn_kept"),
        by_table=by_table,
        **counts,
        **found,
    )


def _referee(
    frame: carom.Frame | None, call: Call | None
) -> tuple[_core.Frame, tuple[str, str | None, str | None]] | None:
    """The frame that rules and the call, in the form that Rust accepts."""
    if frame is None:
        if call is not None:
            raise InputError("missing", "call", "a call needs a game", "give frame too")
        return None
    return core("frame", frame, _core.Frame, "carom.Frame.of_shot(...)"), fields_of(call)
