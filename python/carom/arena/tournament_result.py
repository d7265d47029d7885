"""What a tournament has come to."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any, Self

from carom import _core
from carom.arena.result import AdjustedShare, with_adjusted
from carom.arena.sequential import TestResult, rating
from carom.arena.tournament_folder import of_other, pair_results
from carom.columns import lines

if TYPE_CHECKING:
    from carom.arena.tournament_folder import FrameResult, PairResult, TournamentFolder
    from carom.arena.tournament_schedule import Encounter

# Confidence level of the shares corrected for luck.
_LEVEL = 0.95


@dataclass(frozen=True, slots=True)
class Standing:
    """A player under a condition.

    Attributes:
        player: Its name.
        frames: Number of its frames that count.
        points: Its points: 1 for a won frame, ½ for a drawn one.
        adjusted: Its share corrected for luck, at 95 % confidence; None if the luck was not
            measured in all its pairs.
    """

    player: str
    frames: int
    points: float
    adjusted: AdjustedShare | None = None

    @property
    def share(self) -> float:
        """Points for each frame; ½ without frames."""
        return self.points / self.frames if self.frames else 0.5


@dataclass(frozen=True, slots=True)
class Standings:
    """The players under a condition, the highest share of the points first.

    The shares depend on whom a player met; ratings do not (``carom.arena.ratings``).

    Attributes:
        condition: The condition in words.
        players: The players.
    """

    condition: str
    players: tuple[Standing, ...]


@dataclass(frozen=True, slots=True)
class TestOfChange:
    """A sequential test of a tournament.

    Attributes:
        event: The name of its event.
        condition: The condition in words.
        players: The changed player, and the baseline.
        pairs: Number of pairs in the test.
        share: The share of the points of the changed player.
        nelo: The difference of normalised Elo that belongs to it (``SequentialTest``).
        test: The state of the test.
    """

    event: str
    condition: str
    players: tuple[str, str]
    pairs: int
    share: float
    nelo: float
    test: TestResult

    # The name begins with Test, so pytest would collect the class.
    __test__ = False

    def __str__(self) -> str:
        one, other = self.players
        return (
            f"{self.event}, {self.condition}: {one} against {other}, "
            f"{100 * self.share:.1f} % of the points in {self.pairs} pairs, normalised Elo "
            f"{rating(self.nelo)}; {self.test}"
        )


@dataclass(frozen=True, slots=True)
class TournamentResult:
    """What a tournament has come to; ``print`` it for tables.

    Attributes:
        folder: Its folder.
        pairs: Number of pairs of frames that were played.
        pairs_now: Number of them that the last call played.
        finished: Whether nothing is missing.
        standings: The players under each condition. Sequential tests are not included, because
            a test ends when the share happens to be extreme.
        tests: The sequential tests.
    """

    folder: str
    pairs: int
    pairs_now: int
    finished: bool
    standings: tuple[Standings, ...]
    tests: tuple[TestOfChange, ...]

    @classmethod
    def read(cls, folder: TournamentFolder) -> Self:
        """The result of what the folder has now."""
        tables: dict[str, dict[str, list[float]]] = {}
        paired: dict[str, dict[str, list[PairResult]]] = {}
        titles: dict[str, str] = {}
        tests: list[TestOfChange] = []
        pairs, finished = 0, True
        for each in folder.encounters():
            blocks = folder.blocks(each)
            finished &= all(block.finished for block in blocks)
            frames = [frame for block in blocks for frame in block.frames()]
            pairs += len(frames) // 2
            if each.event.test is not None:
                tests.append(_test(each, frames))
                continue
            condition = each.condition
            titles[condition.key] = condition.title
            table = tables.setdefault(condition.key, {})
            for frame in frames:
                if frame.points is not None:
                    one, other = each.players
                    table.setdefault(one, []).append(frame.points)
                    table.setdefault(other, []).append(1 - frame.points)
            of_pairs = paired.setdefault(condition.key, defaultdict(list))
            for pair in pair_results(frames):
                of_pairs[each.players[0]].append(pair)
                of_pairs[each.players[1]].append(of_other(pair))
        standings = tuple(
            Standings(titles[key], _ranked(table, paired[key]))
            for key, table in tables.items()
            if table
        )
        finished &= all(
            len(folder.rounds(event, condition)) == event.rounds
            for event in folder.events
            for condition in event.conditions
        )
        return cls(str(folder.root), pairs, 0, finished, standings, tuple(tests))

    def played_now(self, before: int) -> Self:
        """The same result of a call before which there were this many pairs."""
        return replace(self, pairs_now=self.pairs - before)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return asdict(self)

    def __str__(self) -> str:
        state = "finished" if self.finished else "not finished"
        text = [f"{self.pairs} pairs of frames, {self.pairs_now} of them now; {state}"]
        for each in self.standings:
            rows: list[tuple[str, ...]] = [("player", "frames", "points", "share")]
            rows += [
                (row.player, f"{row.frames}", f"{row.points:g}", f"{100 * row.share:.1f} %")
                for row in each.players
            ]
            rows = with_adjusted(rows, [row.adjusted for row in each.players])
            text += ["", each.condition, *lines(rows, right_aligned={1, 2, 3, 4, 6})]
        if self.tests:
            text += ["", *map(str, self.tests)]
        return "\n".join(text)


def _ranked(
    table: dict[str, list[float]], paired: dict[str, list[PairResult]]
) -> tuple[Standing, ...]:
    found = [
        Standing(name, len(points), sum(points), AdjustedShare.of(paired[name], _LEVEL))
        for name, points in table.items()
    ]
    return tuple(sorted(found, key=lambda row: (-row.share, row.player)))


def _test(each: Encounter, frames: Sequence[FrameResult]) -> TestOfChange:
    assert each.event.test is not None
    counts = pair_counts(frames)
    pairs = sum(counts)
    points = sum(0.5 * half * count for half, count in enumerate(counts))
    share = points / (2 * pairs) if pairs else 0.5
    return TestOfChange(
        each.event.name,
        each.condition.title,
        each.players,
        pairs,
        share,
        _core.normalised_elo(counts, share),
        each.event.test.state(counts),
    )


def pair_counts(frames: Sequence[FrameResult]) -> list[int]:
    """Numbers of pairs in which player 0 has 0, ½, 1, 1½ and 2 points; only pairs that count."""
    counts = [0] * 5
    for points, _ in pair_results(frames):
        counts[int(2 * points)] += 1
    return counts
