"""Ratings of the players of a tournament: Bradley-Terry with the breaker's advantage.

The player i who begins a frame against player j wins it with the probability

    1 / (1 + exp(−(θᵢ − θⱼ + β))),

where θ are the strengths and β is the advantage of the player who begins (Bradley & Terry 1952,
*Rank analysis of incomplete block designs*; Agresti 2002, *Categorical data analysis*, section
10.6, with an order effect). A drawn frame counts half a won and half a lost one. It is a logistic
regression, which statsmodels fits; the covariance is that of clusters, because the frames of a
pair have the same rack and the same errors (Liang & Zeger 1986, *Longitudinal data analysis using
generalized linear models*).

A weak prior keeps an unbeaten player's rating finite: each player has a won and a lost frame more,
against a player of strength 0, and so does the player who begins against an equal one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

from carom.arena.result import AdjustedShare, with_adjusted
from carom.arena.sequential import rating
from carom.arena.tournament_folder import FrameResult, PairResult, TournamentFolder
from carom.arguments import number
from carom.columns import lines
from carom.errors import InputError
from carom.files import checked_path
from carom.lazy import LazyModule, np

if TYPE_CHECKING:
    import os

    from numpy.typing import NDArray
    from statsmodels.genmod import families, generalized_linear_model
else:
    _MISSING = ("ratings need statsmodels", "install it: pip install 'carom[arena]'")
    families = LazyModule("statsmodels.genmod.families", _MISSING)
    generalized_linear_model = LazyModule("statsmodels.genmod.generalized_linear_model", _MISSING)

# Elo points of a unit of strength: a tenfold of the odds to win is 400 points (Elo 1978).
ELO = 400.0 / math.log(10.0)


@dataclass(frozen=True, slots=True)
class Game:
    """A frame between two players, for ratings.

    Attributes:
        breaker: The player who begins.
        other: The other player.
        points: The points of the breaker: 1, ½ or 0.
        pair: Anything that only the frames of the same pair have in common.
        luck: The luck of the breaker, in points; None if it was not measured.
    """

    breaker: str
    other: str
    points: float
    pair: Any
    luck: float | None = None


@dataclass(frozen=True, slots=True)
class Rating:
    """A player's rating.

    Attributes:
        player: Its name.
        elo: Its rating, Elo points above the mean of all players of the table.
        low: Lower end of its confidence interval.
        high: Upper end.
        frames: Number of its frames that count.
        share: Its share of their points.
        adjusted: The same, corrected for luck; None if the luck was not measured in all its pairs.
    """

    player: str
    elo: float
    low: float
    high: float
    frames: int
    share: float
    adjusted: AdjustedShare | None = None


@dataclass(frozen=True, slots=True)
class RatingTable:
    """The ratings under a condition; ``print`` it for a table.

    Attributes:
        condition: The condition in words: game, table, noise and clock.
        level: Confidence level of the intervals.
        players: The ratings, the highest first.
        breaker: The advantage of the player who begins a frame, Elo points, and the ends of its
            interval.
        pairs: Number of pairs of frames.
    """

    condition: str
    level: float
    players: tuple[Rating, ...]
    breaker: tuple[float, float, float]
    pairs: int
    _names: tuple[str, ...] = field(repr=False)
    _covariance: NDArray[Any] = field(repr=False, compare=False)

    def difference(self, one: str, other: str) -> tuple[float, float, float]:
        """How much higher the rating of a player is than that of another: Elo points, low, high.

        Raises:
            InputError: The table has no such player.
        """
        for name in (one, other):
            if name not in self._names:
                known = ", ".join(self._names)
                raise InputError(
                    "unknown-name",
                    "player",
                    f"the table has no {name!r}",
                    f"write one of {known}",
                )
        contrast = np.zeros(len(self._names))
        contrast[self._names.index(one)] += 1
        contrast[self._names.index(other)] -= 1
        elo = {row.player: row.elo for row in self.players}
        half = _half_width(contrast, self._covariance, self.level)
        found = elo[one] - elo[other]
        return found, found - half, found + half

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "condition": self.condition,
            "level": self.level,
            "pairs": self.pairs,
            "breaker": list(self.breaker),
            "players": [
                {
                    "player": row.player,
                    "elo": row.elo,
                    "interval": [row.low, row.high],
                    "frames": row.frames,
                    "share": row.share,
                    **({} if row.adjusted is None else {"adjusted": row.adjusted.to_dict()}),
                }
                for row in self.players
            ],
        }

    def __str__(self) -> str:
        rows: list[tuple[str, ...]] = [("player", "Elo", "interval", "frames", "share")]
        rows += [
            (
                row.player,
                rating(row.elo),
                f"{rating(row.low)} to {rating(row.high)}",
                f"{row.frames}",
                f"{100 * row.share:.1f} %",
            )
            for row in self.players
        ]
        rows = with_adjusted(rows, [row.adjusted for row in self.players])
        elo, low, high = map(rating, self.breaker)
        return "\n".join(
            [
                self.condition,
                *lines(rows, right_aligned={1, 2, 3, 4, 5, 7}),
                f"advantage of the breaker {elo} ({low} to {high}); "
                f"{self.pairs} pairs, intervals at {100 * self.level:g} % confidence",
            ]
        )


def ratings(folder: str | os.PathLike[str], *, level: float = 0.95) -> tuple[RatingTable, ...]:
    """The ratings of a tournament, a table for each condition, from what was played so far.

    Sequential tests are left out: a test ends when the share happens to be extreme.

    Args:
        folder: The folder of the tournament.
        level: Confidence level of the intervals, in (0, 1).

    Raises:
        InputError: The folder has no tournament, a record is damaged, or statsmodels is not
            installed (``pip install 'carom[arena]'``).
    """
    found = TournamentFolder.read(checked_path("folder", folder, "tournament"))
    games: dict[str, list[Game]] = {}
    titles: dict[str, str] = {}
    for each in found.encounters():
        if each.event.test is not None:
            continue
        titles[each.condition.key] = each.condition.title
        of_condition = games.setdefault(each.condition.key, [])
        for block in found.blocks(each):
            of_condition += _games(each.players, block.frames(), str(block.folder))
    return tuple(fit(played, titles[key], level) for key, played in games.items() if played)


def _games(players: tuple[str, str], frames: Sequence[FrameResult], block: str) -> list[Game]:
    found = []
    for frame in frames:
        if frame.points is not None:
            points = frame.points if frame.breaker == 0 else 1 - frame.points
            breaker, other = players[frame.breaker], players[1 - frame.breaker]
            luck = frame.luck
            if luck is not None and frame.breaker == 1:
                luck = -luck
            found.append(Game(breaker, other, points, (block, frame.number // 2), luck))
    return found


def fit(games: Sequence[Game], condition: str = "", level: float = 0.95) -> RatingTable:
    """The ratings of players from their frames.

    Args:
        games: The frames, at least one.
        condition: The condition in words.
        level: Confidence level of the intervals, in (0, 1).

    Raises:
        InputError: There is no frame, the level is out of range, or statsmodels is not installed.
    """
    if not 0 < number("level", level) < 1:
        raise InputError("out-of-range", "level", f"{level!r} is no level", "give such as 0.95")
    if not games:
        raise InputError("wrong-count", "games", "there is no frame", "play the tournament first")
    names = sorted({name for game in games for name in (game.breaker, game.other)})
    estimate, covariance = _regression(games, names)
    n = len(names)
    mean = np.full(n, 1 / n)
    table = []
    for i, name in enumerate(names):
        contrast = np.append(np.eye(n)[i] - mean, 0.0)
        elo, half = float(contrast @ estimate), _half_width(contrast, covariance, level)
        own = _own(games, name)
        share = sum(points for points, _, _ in own) / len(own)
        adjusted = AdjustedShare.of(_pairs(own), level)
        table.append(Rating(name, elo, elo - half, elo + half, len(own), share, adjusted))
    advantage = float(estimate[n])
    half = _half_width(np.eye(n + 1)[n], covariance, level)
    return RatingTable(
        condition,
        level,
        # Ratings that are equal but for rounding are in the order of the names.
        tuple(sorted(table, key=lambda row: (-round(row.elo, 6), row.player))),
        (advantage, advantage - half, advantage + half),
        len({game.pair for game in games}),
        tuple(names),
        covariance[:n, :n],
    )


def _own(games: Sequence[Game], name: str) -> list[tuple[float, float | None, Any]]:
    """The points of a player in its frames, its luck and the pair."""
    own = [(game.points, game.luck, game.pair) for game in games if game.breaker == name]
    own += [
        (1 - game.points, None if game.luck is None else -game.luck, game.pair)
        for game in games
        if game.other == name
    ]
    return own


def _pairs(own: Sequence[tuple[float, float | None, Any]]) -> list[PairResult]:
    """The points and the luck of a player in whole pairs, which have two frames."""
    of_pair: dict[Any, list[tuple[float, float | None]]] = {}
    for points, luck, pair in own:
        of_pair.setdefault(pair, []).append((points, luck))
    found: list[PairResult] = []
    for frames in of_pair.values():
        if len(frames) == 2:
            (one, luck), (other, more) = frames
            measured = luck is not None and more is not None
            found.append((one + other, (luck or 0.0) + (more or 0.0) if measured else None))
    return found


def _regression(
    games: Sequence[Game], names: Sequence[str]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Strengths in Elo points, with the breaker's advantage at the end, and their covariance."""
    n, index = len(names), {name: i for i, name in enumerate(names)}
    # The frames of the prior come last.
    design = np.zeros((len(games) + 2 * (n + 1), n + 1))
    for row, game in zip(design, games, strict=False):
        row[index[game.breaker]] = 1
        row[index[game.other]] = -1
        row[n] = 1
    design[len(games) :] = np.repeat(np.eye(n + 1), 2, axis=0)
    points = np.append([game.points for game in games], [1.0, 0.0] * (n + 1))
    clusters = {pair: i for i, pair in enumerate(dict.fromkeys(game.pair for game in games))}
    pairs = [clusters[game.pair] for game in games]
    groups = np.append(pairs, np.arange(len(clusters), len(clusters) + 2 * (n + 1)))
    model = generalized_linear_model.GLM(points, design, family=families.Binomial())
    found = model.fit(cov_type="cluster", cov_kwds={"groups": groups})
    return ELO * found.params, ELO * ELO * found.cov_params()


def _half_width(contrast: NDArray[Any], covariance: NDArray[Any], level: float) -> float:
    """Half the width of the interval of a sum with these weights, Elo points."""
    variance = float(contrast @ covariance @ contrast)
    return NormalDist().inv_cdf(0.5 + 0.5 * level) * math.sqrt(variance)
