"""The result of a match."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from carom import _core
from carom.arena.sequential import SequentialTest, TestResult, rating
from carom.columns import cells, left
from carom.plan.chance import Chance, or_null

_POINTS = ("0", "½", "1", "1½", "2")


def _pairs(count: int) -> str:
    return "1 pair" if count == 1 else f"{count} pairs"


@dataclass(frozen=True, slots=True)
class AdjustedShare:
    """The first player's share of the points, corrected for luck (docs/arena.md).

    Attributes:
        pairs: Number of pairs.
        share: The share. It may lie a little outside of 0 to 1.
        share_interval: Its confidence interval, computed from whole pairs.
        weight: The mean weight of the luck: about 1 if the value of positions is right.
        saved: The variance of a pair's share, divided by that of the corrected one. Without
            the correction this number of times more pairs would have the same interval. None if
            all are equal.
    """

    pairs: int
    share: float
    share_interval: tuple[float, float]
    weight: float
    saved: float | None

    @classmethod
    def of(cls, pairs: Sequence[tuple[float, float | None]], level: float) -> Self | None:
        """The share in pairs that were played in several matches.

        Args:
            pairs: The points of the player in each pair, 0 to 2, and its luck, in points.
            level: Confidence level of the interval, in (0, 1).

        Returns:
            None without pairs, or if the luck of a pair was not measured.
        """
        measured = [(points / 2, luck / 2) for points, luck in pairs if luck is not None]
        if not measured or len(measured) < len(pairs):
            return None
        found = _core.adjusted_share(measured, level)
        return None if found is None else cls(**found)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "pairs": self.pairs,
            "share": self.share,
            "share_interval": list(self.share_interval),
            "weight": self.weight,
            "saved": self.saved,
        }

    def __str__(self) -> str:
        low, high = (100 * end for end in self.share_interval)
        line = f"corrected for luck {100 * self.share:.1f} % ({low:.1f} to {high:.1f})"
        if self.saved is not None:
            line += f"; the variance of a pair is {self.saved:.2f} times smaller"
        return line


def with_adjusted(
    rows: Sequence[tuple[str, ...]], shares: Sequence[AdjustedShare | None]
) -> list[tuple[str, ...]]:
    """The rows of a table, the first its heads, with columns of the shares corrected for luck.

    Without any such share the rows stay as they are.
    """
    if not any(shares):
        return list(rows)
    cells = [("corrected for luck", "interval", "variance saved")]
    for share in shares:
        if share is None:
            cells.append(("", "", ""))
            continue
        low, high = (100 * end for end in share.share_interval)
        saved = "" if share.saved is None else f"{share.saved:.1f} ×"
        cells.append((f"{100 * share.share:.1f} %", f"{low:.1f} to {high:.1f}", saved))
    return [(*row, *more) for row, more in zip(rows, cells, strict=True)]


@dataclass(frozen=True, slots=True)
class Score:
    """The frames and pairs of a match, as counted for the first player.

    Attributes:
        players: The names of the two players.
        level: Confidence level of the intervals.
        losses: Number of frames that the first player lost.
        draws: Number of drawn frames, which count half a point.
        wins: Number of frames that the first player won.
        void: Number of frames that do not count.
        pair_counts: Number of pairs in which the first player had 0, ½, 1, 1½ and 2 points.
        share: The first player's share of the points of the pairs; ½ without pairs.
        share_interval: Its confidence interval, computed from whole pairs.
        win_share: The share of the decided frames that the first player won. Its interval takes
            the frames as independent.
        elo: The difference of Elo ratings that belongs to ``share``; infinite for 0 and 1.
        elo_interval: The same for ``share_interval``.
        nelo: The difference of normalised Elo (``SequentialTest``) that belongs to ``share``, with
            the standard deviation of the pairs played. To it are added ten pairs, as to
            that of the interval, so it is finite.
        nelo_interval: The same for ``share_interval``.
        pairing_ratio: The variance of a pair, divided by that of two independent frames; None if
            all frames ended the same.
        reasons: Number of frames by the reason of their end.
        adjusted: The share corrected for luck, if the luck was measured.
    """

    players: tuple[str, str]
    level: float
    losses: int
    draws: int
    wins: int
    void: int
    pair_counts: tuple[int, int, int, int, int]
    share: float
    share_interval: tuple[float, float]
    win_share: Chance
    elo: float
    elo_interval: tuple[float, float]
    nelo: float
    nelo_interval: tuple[float, float]
    pairing_ratio: float | None
    reasons: dict[str, int]
    adjusted: AdjustedShare | None

    @classmethod
    def _read(cls, fields: dict[str, Any], players: tuple[str, str], level: float) -> Self:
        """The score from its values in Rust."""
        losses, draws, wins = fields["frames"]
        adjusted = fields["adjusted"]
        return cls(
            players=players,
            level=level,
            losses=losses,
            draws=draws,
            wins=wins,
            void=fields["void"],
            pair_counts=tuple(fields["pairs"]),
            share=fields["share"],
            share_interval=fields["share_interval"],
            win_share=Chance(wins, wins + losses, *fields["wins_interval"]),
            elo=fields["elo"],
            elo_interval=fields["elo_interval"],
            nelo=fields["nelo"],
            nelo_interval=fields["nelo_interval"],
            pairing_ratio=fields["pairing_ratio"],
            reasons=fields["reasons"],
            adjusted=None if adjusted is None else AdjustedShare(**adjusted),
        )

    @property
    def pairs(self) -> int:
        """Number of pairs in which both frames counted."""
        return sum(self.pair_counts)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON; infinite ratings are null."""
        low, high = self.win_share.low, self.win_share.high
        return {
            "players": list(self.players),
            "level": self.level,
            "wins": self.wins,
            "draws": self.draws,
            "losses": self.losses,
            "void": self.void,
            "pair_counts": list(self.pair_counts),
            "share": self.share,
            "share_interval": list(self.share_interval),
            "win_share": or_null(float(self.win_share)),
            "win_share_interval": [low, high],
            "elo": _finite(self.elo),
            "elo_interval": [_finite(end) for end in self.elo_interval],
            "nelo": self.nelo,
            "nelo_interval": list(self.nelo_interval),
            "pairing_ratio": self.pairing_ratio,
            "reasons": self.reasons,
            **({} if self.adjusted is None else {"adjusted": self.adjusted.to_dict()}),
        }

    def lines(self) -> list[str]:
        """The score as lines of text."""
        one, other = self.players
        if one == other:
            one, other = f"{one} (A)", f"{other} (B)"
        name = max(map(cells, (one, other, "player")))
        frames = self.wins + self.draws + self.losses
        points = self.wins + 0.5 * self.draws

        def row(player: str, *numbers: str) -> str:
            return f"  {left(player, name)}" + "".join(f"{number:>8}" for number in numbers)

        low, high = (100 * end for end in self.share_interval)
        counts = ", ".join(
            f"{points}: {count}" for points, count in zip(_POINTS, self.pair_counts, strict=True)
        )
        ratio = self.pairing_ratio
        lines = [
            row("player", "points", "won", "drawn", "lost"),
            row(one, f"{points:g}", f"{self.wins}", f"{self.draws}", f"{self.losses}"),
            row(other, f"{frames - points:g}", f"{self.losses}", f"{self.draws}", f"{self.wins}"),
            f"{one} has {100 * self.share:.1f} % ({low:.1f} to {high:.1f}) of the points; "
            f"intervals at {100 * self.level:g} % confidence, from {_pairs(self.pairs)}",
            f"Elo difference {_ratings(self.elo, self.elo_interval)}, "
            f"normalised {_ratings(self.nelo, self.nelo_interval)}",
            f"pairs by points: {counts}",
        ]
        if self.win_share.trials:
            lines.insert(4, f"wins of decided frames {self.win_share}, as if independent")
        if self.adjusted is not None:
            lines.insert(4, f"{one} has, {self.adjusted}")
        if ratio is not None:
            lines.append(f"variance of a pair: {ratio:.2f} of that of two independent frames")
        ends = ", ".join(f"{reason} {count}" for reason, count in self.reasons.items())
        if ends:
            lines.append(f"frames by their end: {ends}")
        return lines


@dataclass(frozen=True, slots=True)
class MatchResult:
    """What a match has come to; ``print`` it for a table.

    Attributes:
        game: The game.
        score: Frames, pairs and intervals. If the match is not finished, they are those of the
            first pairs that were played without a gap.
        test: The state of the sequential test, if there is one.
        record: The record of the match; None if it is not finished.
        played_pairs: Number of pairs in the score, with those that do not count.
        secret_sha256: SHA-256 of the secret of the match.
    """

    game: str
    score: Score
    test: TestResult | None
    record: Path | None
    played_pairs: int
    secret_sha256: str

    @classmethod
    def _read(
        cls,
        fields: dict[str, Any],
        game: str,
        names: tuple[str, str],
        level: float,
        test: SequentialTest | None,
    ) -> Self:
        """The result from its values in Rust."""
        state = fields["test"]
        return cls(
            game=game,
            score=Score._read(fields["score"], names, level),
            test=None if state is None or test is None else test.result(state),
            record=None if fields["record"] is None else Path(fields["record"]),
            played_pairs=fields["played_pairs"],
            secret_sha256=fields["secret_sha256"],
        )

    @property
    def finished(self) -> bool:
        """Whether all pairs are played that the number of pairs or the test asks for."""
        return self.record is not None

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "game": self.game,
            "finished": self.finished,
            "pairs": self.played_pairs,
            **self.score.to_dict(),
            "test": None if self.test is None else self.test.to_dict(),
            "record": None if self.record is None else str(self.record),
            "secret_sha256": self.secret_sha256,
        }

    def __str__(self) -> str:
        state = "finished" if self.finished else "not finished"
        lines = [
            f"{self.game}: {_pairs(self.played_pairs)} of frames, {state}",
            *self.score.lines(),
        ]
        if self.test is not None:
            lines.append(str(self.test))
        lines.append(f"secret: SHA-256 {self.secret_sha256}")
        if self.record is not None:
            lines.append(f"record: {self.record}")
        return "\n".join(lines)


def _ratings(elo: float, interval: tuple[float, float]) -> str:
    low, high = interval
    return f"{rating(elo)} ({rating(low)} to {rating(high)})"


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
