"""Reports of matches: what a folder of records has come to."""

from __future__ import annotations

import os
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from typing import Any, NamedTuple

from carom import _core
from carom.arena.bradley_terry import Game, RatingTable, fit
from carom.arena.report_match import Costs, ReportFrame, ReportMatch, read_matches
from carom.arena.result import AdjustedShare
from carom.arena.sequential import SequentialTest, TestResult
from carom.arena.tournament_folder import PLAYED, RECORD, PairResult, of_other
from carom.arguments import number
from carom.errors import InputError
from carom.files import checked_path, shown


class Share(NamedTuple):
    """A share of the points with its interval.

    Attributes:
        value: The share.
        low: The lower end of its interval.
        high: The upper end.
    """

    value: float
    low: float
    high: float


class RatingInterval(NamedTuple):
    """A rating with its interval, Elo points above the mean of the table (``RatingTable``).

    Attributes:
        elo: The rating.
        low: The lower end of its interval.
        high: The upper end.
    """

    elo: float
    low: float
    high: float


@dataclass(slots=True)
class ReportRow:
    """A player under a condition.

    Attributes:
        name: Its name.
        won: Number of frames that it won.
        drawn: Number of drawn frames.
        lost: Number of frames that it lost.
        void: Number of frames that do not count.
        pairs: Number of pairs that count.
        share: Its share of the points of the pairs; None without pairs.
        adjusted: The same, corrected for luck; None if luck was not measured everywhere.
        rating: Its rating; None without ratings.
        costs: What its answers took.
        losses: Number of lost frames by the reason of their end.
    """

    name: str
    won: int = 0
    drawn: int = 0
    lost: int = 0
    void: int = 0
    pairs: int = 0
    share: Share | None = None
    adjusted: Share | None = None
    rating: RatingInterval | None = None
    costs: Costs = field(default_factory=Costs)
    losses: Counter[str] = field(default_factory=Counter)


@dataclass(frozen=True, slots=True)
class ReportTest:
    """A match with a sequential test.

    Attributes:
        players: Its players.
        pairs: Number of pairs in the test.
        share: The share of the points of the first player. It is biased when the test has ended,
            because it ends when the share happens to be extreme.
        nelo: The difference of normalised Elo that belongs to the share (``SequentialTest``).
        test: The state of the test.
    """

    players: tuple[str, str]
    pairs: int
    share: float
    nelo: float
    test: TestResult


@dataclass(frozen=True, slots=True)
class ReportTable:
    """The players of a condition.

    Attributes:
        condition: The condition in words. Matches with sequential tests have tables of their own.
        rows: The players, the highest rating first; without ratings the highest share first.
        cross: The share of the points that a player has against another one, by both names.
        breaker: The advantage of the player who begins a frame, Elo points; None without ratings.
        tests: The sequential tests, in a table of such matches.
    """

    condition: str
    rows: tuple[ReportRow, ...]
    cross: dict[tuple[str, str], Share]
    breaker: RatingInterval | None
    tests: tuple[ReportTest, ...]


@dataclass(frozen=True, slots=True)
class Report:
    """What a folder of matches has come to.

    Attributes:
        folder: The folder.
        level: Confidence level of the intervals.
        matches: The matches.
        tables: The tables, one for each condition: shares under different conditions are not
            compared.
        is_rated: Whether there are ratings: statsmodels is installed.
    """

    folder: str
    level: float
    matches: tuple[ReportMatch, ...]
    tables: tuple[ReportTable, ...]
    is_rated: bool

    @property
    def finished(self) -> bool:
        """Whether all matches have ended."""
        return all(match.finished for match in self.matches)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "folder": self.folder,
            "level": self.level,
            "finished": self.finished,
            "tables": [
                {
                    "condition": table.condition,
                    "players": players_of(table),
                    "breaker": breaker_of(table),
                    "cross": cross_of(table),
                    "tests": tests_of(table),
                }
                for table in self.tables
            ],
            "games": games_of(self),
        }

    def __str__(self) -> str:
        frames = sum(len(match.frames) for match in self.matches)
        return f"{len(self.matches)} matches, {frames} frames"


def players_of(table: ReportTable) -> list[dict[str, Any]]:
    """The rows of a table as plain values."""
    found = []
    for row in table.rows:
        costs = row.costs
        found.append(
            {
                "player": row.name,
                "won": row.won,
                "drawn": row.drawn,
                "lost": row.lost,
                "void": row.void,
                "pairs": row.pairs,
                **_share_keys("share", row.share),
                **_share_keys("adjusted_share", row.adjusted),
                **_rating_keys(row.rating),
                "decisions": costs.decisions,
                "simulations": costs.simulations,
                "seconds": costs.seconds,
                "refused": costs.refused,
                "losses": dict(sorted(row.losses.items())),
            }
        )
    return found


def cross_of(table: ReportTable) -> list[dict[str, Any]]:
    """The cross table of a condition as plain values."""
    return [
        {"player": one, "against": other, **_share_keys("share", share)}
        for (one, other), share in table.cross.items()
    ]


def breaker_of(table: ReportTable) -> dict[str, float | None]:
    """The advantage of the player who begins as plain values, Elo points."""
    return _rating_keys(table.breaker)


def tests_of(table: ReportTable) -> list[dict[str, Any]]:
    """The sequential tests of a condition as plain values."""
    return [
        {
            "player": each.players[0],
            "against": each.players[1],
            "pairs": each.pairs,
            "share": each.share,
            "nelo": each.nelo,
            **each.test.to_dict(),
        }
        for each in table.tests
    ]


def games_of(report: Report) -> list[dict[str, Any]]:
    """The frames of a report as plain values."""
    return [
        {
            "match": match.folder,
            "frame": frame.number,
            "condition": match.condition,
            "first": frame.players[0],
            "second": frame.players[1],
            "winner": frame.winner,
            "reason": frame.reason,
            "why": frame.why,
            "shots": frame.shots,
            "luck": frame.luck,
        }
        for match in report.matches
        for frame in match.frames
    ]


def _share_keys(name: str, share: Share | None) -> dict[str, float | None]:
    value, low, high = share or (None, None, None)
    return {name: value, f"{name}_low": low, f"{name}_high": high}


def _rating_keys(rating: RatingInterval | None) -> dict[str, float | None]:
    elo, low, high = rating or (None, None, None)
    return {"elo": elo, "elo_low": low, "elo_high": high}


def read_report(folder: str | os.PathLike[str], *, level: float = 0.95) -> Report:
    """Read the records of all matches in a folder, whether they have ended or go on.

    Args:
        folder: The folder of a match, of a tournament, or any other with matches in it.
        level: Confidence level of the intervals, in (0, 1).

    Raises:
        InputError: There is no match, or a record is damaged; the message has its line.
        OSError: A file cannot be read.
    """
    root = checked_path("folder", folder, "matches")
    confidence = number("level", level)
    if not 0.0 < confidence < 1.0:
        raise InputError("out-of-range", "level", f"{level} is out of range", "give one in (0, 1)")
    matches = read_matches(root)
    if not matches:
        raise InputError(
            "missing",
            shown(root),
            "there is no match in it",
            f"give a folder with a {RECORD} or a {PLAYED} in it or below it",
        )
    is_rated = find_spec("statsmodels") is not None
    by_condition: dict[tuple[str, bool], list[ReportMatch]] = defaultdict(list)
    for match in matches:
        by_condition[match.condition, match.test is not None].append(match)
    tables = tuple(
        _table(f"{condition}, sequential tests" if is_test else condition, found, confidence)
        if is_test or not is_rated
        else _with_ratings(_table(condition, found, confidence), _fitted(found, confidence))
        for (condition, is_test), found in by_condition.items()
    )
    return Report(str(root), confidence, matches, tables, is_rated)


def _table(condition: str, matches: Sequence[ReportMatch], level: float) -> ReportTable:
    """The table of a condition, without ratings."""
    rows: dict[str, ReportRow] = {}
    pairs: dict[tuple[str, str], list[PairResult]] = defaultdict(list)
    tests = []
    for match in matches:
        one, other = match.players
        for name, costs in zip(match.players, match.costs, strict=True):
            rows.setdefault(name, ReportRow(name)).costs.join(costs)
        for frame in match.frames:
            _count(rows[one], rows[other], frame)
        found = list(_pair_results(match))
        pairs[one, other] += found
        pairs[other, one] += map(of_other, found)
        if match.test is not None:
            tests.append(_test(match, match.test, found))
    for row in rows.values():
        own = [pair for (one, _), played in pairs.items() if one == row.name for pair in played]
        row.pairs, row.share = len(own), _share(own, level)
        row.adjusted = _adjusted(own, level)
    cross = {key: share for key, found in pairs.items() if (share := _share(found, level))}
    ranked = sorted(rows.values(), key=lambda row: (-(row.share or (-1.0,))[0], row.name))
    return ReportTable(condition, tuple(ranked), cross, None, tuple(tests))


def _pair_results(match: ReportMatch) -> Iterator[PairResult]:
    """The points and the luck of the first player in the pairs that count."""
    for first, second in match.pairs():
        assert first.points is not None
        assert second.points is not None
        luck = None
        if first.luck is not None and second.luck is not None:
            luck = first.luck + second.luck
        yield first.points + second.points, luck


def _test(match: ReportMatch, test: SequentialTest, pairs: Sequence[PairResult]) -> ReportTest:
    counts = _counts(pairs)
    share = sum(points for points, _ in pairs) / (2 * len(pairs)) if pairs else 0.5
    nelo = _core.normalised_elo(counts, share)
    return ReportTest(match.players, len(pairs), share, nelo, test.state(counts))


def _fitted(matches: Sequence[ReportMatch], level: float) -> RatingTable | None:
    """The ratings of a condition; None without a frame that counts."""
    games = []
    for match in matches:
        first = match.players[0]
        numbers = {frame.number for frame in match.frames}
        for frame in match.frames:
            if frame.points is None or frame.number ^ 1 not in numbers:
                continue
            breaker, other = frame.players
            points = frame.points if breaker == first else 1 - frame.points
            games.append(Game(breaker, other, points, (match.folder, frame.number // 2)))
    return fit(games, level=level) if games else None


def _with_ratings(table: ReportTable, found: RatingTable | None) -> ReportTable:
    """The table with the ratings of its players, the highest first."""
    if found is None:
        return table
    rows = {row.name: row for row in table.rows}
    for each in found.players:
        rows[each.player].rating = RatingInterval(each.elo, each.low, each.high)
    # Players without a frame that counts come last.
    names = [each.player for each in found.players]
    ranked = [rows.pop(name) for name in names] + list(rows.values())
    return replace(table, rows=tuple(ranked), breaker=RatingInterval(*found.breaker))


def _count(one: ReportRow, other: ReportRow, frame: ReportFrame) -> None:
    if frame.points is None:
        one.void += 1
        other.void += 1
    elif frame.winner is None:
        one.drawn += 1
        other.drawn += 1
    else:
        winner, loser = (one, other) if frame.winner == one.name else (other, one)
        winner.won += 1
        loser.lost += 1
        loser.losses[frame.reason] += 1


def _counts(pairs: Sequence[PairResult]) -> list[int]:
    """Number of pairs with 0, ½, 1, 1½ and 2 points."""
    counts = [0] * 5
    for points, _ in pairs:
        counts[int(2 * points)] += 1
    return counts


def _share(pairs: Sequence[PairResult], level: float) -> Share | None:
    """The share of the points of whole pairs, with its interval (docs/arena.md, Statistics)."""
    if not pairs:
        return None
    low, high = _core.pair_interval(_counts(pairs), level)
    return Share(sum(points for points, _ in pairs) / (2 * len(pairs)), low, high)


def _adjusted(pairs: Sequence[PairResult], level: float) -> Share | None:
    found = AdjustedShare.of(pairs, level)
    return None if found is None else Share(found.share, *found.share_interval)
