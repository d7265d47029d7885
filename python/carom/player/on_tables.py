"""The plays of an analysis, ranked again on the tables that may be the true one."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from carom.arguments import WORD
from carom.plan import Chance, Evaluation, TablePosterior, evaluate
from carom.plan.drawn_tables import on_drawn_tables
from carom.player.analysis import Leave

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.player.analysis import Analysis, Recommendation
    from carom.rules import Frame

#: Plays of a search on the learned table that are ranked again: more than are close to the best.
CANDIDATES = 8
# Variants of a play in either count, if there are not more tables: standard errors of 1.5 points.
_VARIANTS = 1024
# The counts by which the plays are ranked and those that are stated have the seed of the search
# plus these numbers, so that neither the search nor the ranking has seen the stated ones.
_RANKING, _STATED = 0x5241_4E4B, 0x5354_4154
# Width of half a 95 % interval in standard errors.
_HALF_WIDTH = 1.959964


def check_tables(frame: Frame, posterior: TablePosterior, draws: int) -> None:
    """Reject what ``ranked_on_tables`` would reject, before a search is spent.

    Raises:
        InputError: The posterior is none, ``draws`` is out of range, or the table of the frame is
            not the learned one.
    """
    on_drawn_tables(frame._bare_shot(), posterior, draws, _VARIANTS, 0, frame)


def ranked_on_tables(
    analysis: Analysis, posterior: TablePosterior, draws: int, count: int, threads: int | None
) -> Analysis:
    """The best plays of an analysis over ``draws`` tables, the best first.

    How often the turn is kept, fouls and where the cue ball ends are counted on drawn tables. What
    a kept and a missed turn are worth stays as on the learned table. One count ranks the plays, and
    another, on other tables, is stated.

    Args:
        analysis: The plays, on the learned table.
        posterior: What is known about the table.
        draws: Number of drawn tables.
        count: Largest number of plays.
        threads: Number of threads; None is one per core.
    """
    n = max(_VARIANTS, draws)

    def counted(play: Recommendation, own: int) -> Evaluation:
        thinking = analysis.thinking
        assert thinking.noise is not None
        return evaluate(
            play.shot,
            thinking.noise,
            n,
            (thinking.seed + own) % WORD,
            perception=thinking.perception,
            frame=analysis.frame,
            call=play.play.call,
            posterior=posterior,
            draws=draws,
            threads=threads,
        )

    listed = [_with_both_values(play, analysis.plays) for play in analysis.plays]
    ranked = [(_win(play, _kept(counted(play, _RANKING))), play) for play in listed]
    ranked.sort(key=lambda pair: pair[0], reverse=True)
    plays = tuple(_stated(play, counted(play, _STATED)) for _, play in ranked[:count])
    played = n * (len(ranked) + len(plays))
    return replace(analysis, plays=plays, simulations=analysis.simulations + played)


def _kept(found: Evaluation) -> Chance:
    kept = found.turn_kept
    assert kept is not None
    return kept


def _with_both_values(play: Recommendation, plays: Sequence[Recommendation]) -> Recommendation:
    """The play with a value of a kept and of a missed turn, also where no sample had one.

    A play that always keeps the turn on the learned table may miss on another. The missing value is
    the mean of those of the other plays; if none has one, the other player is taken to have what
    this one has.
    """
    kept, missed = play.win_if_kept, play.win_if_missed
    if missed is None:
        missed = _mean([p.win_if_missed for p in plays], 1 - play.win_chance)
    if kept is None:
        kept = _mean([p.win_if_kept for p in plays], 1 - play.win_chance)
    return replace(play, win_if_kept=kept, win_if_missed=missed)


def _mean(values: Sequence[float | None], default: float) -> float:
    known = [value for value in values if value is not None]
    total = 0.0
    # In this order, without the compensation of newer Pythons: JavaScript has the same bits.
    for value in known:
        total += value
    return total / len(known) if known else default


def _win(play: Recommendation, kept: Chance) -> float:
    share = float(kept)
    return share * (play.win_if_kept or 0.0) + (1 - share) * (play.win_if_missed or 0.0)


def _stated(play: Recommendation, found: Evaluation) -> Recommendation:
    """The play with the chances that were counted on drawn tables."""
    kept = _kept(found)
    gain = (play.win_if_kept or 0.0) - (play.win_if_missed or 0.0)
    of_tables = abs(gain) * kept.half_width / _HALF_WIDTH
    return replace(
        play,
        win_chance=_win(play, kept),
        error=math.sqrt(play.error * play.error + of_tables * of_tables),
        kept=kept,
        foul=found.chance(lambda counts: counts.n - (counts.legal or 0)),
        leave=Leave.of(found),
    )
