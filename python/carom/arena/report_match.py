"""The matches of a report, read from their records."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from carom.arena.fresh_errors import frame_luck
from carom.arena.report_condition import condition_of
from carom.arena.sequential import SequentialTest
from carom.arena.tournament_folder import MANIFEST, PLAYED, RECORD, TournamentFolder
from carom.errors import InputError
from carom.files import shown

_FORMAT = "carom-match/1"


@dataclass(frozen=True, slots=True)
class ReportFrame:
    """A frame of a match.

    Attributes:
        number: Its number in the match, from 0.
        players: The names of the players at seat 0 and at seat 1.
        winner: The name of the winner; None without one.
        points: The points of the match's first player; None if the frame does not count.
        reason: The reason of its end, one word.
        why: The same in words.
        shots: Number of executed shots.
        luck: The luck of the match's first player, in points; None if it was not measured.
        line: Its line in the record.
    """

    number: int
    players: tuple[str, str]
    winner: str | None
    points: float | None
    reason: str
    why: str
    shots: int
    luck: float | None
    line: str


@dataclass(slots=True)
class Costs:
    """What the answers of a player took, and how many of them were refused.

    Attributes:
        decisions: Number of answers.
        simulations: Simulated shots.
        seconds: Seconds, where the clock counts them.
        refused: Number of refused answers.
    """

    decisions: int = 0
    simulations: int = 0
    seconds: float = 0.0
    refused: int = 0

    def add(self, move: dict[str, Any]) -> None:
        """Count a move of a record."""
        cost = move.get("cost")
        if cost is None:
            return
        self.decisions += 1
        self.simulations += cost.get("simulations", 0)
        self.seconds += cost.get("seconds", 0.0)
        self.refused += "refused" in move

    def join(self, other: Costs) -> None:
        """Count those of another match, too."""
        self.decisions += other.decisions
        self.simulations += other.simulations
        self.seconds += other.seconds
        self.refused += other.refused


@dataclass(frozen=True, slots=True)
class ReportMatch:
    """A match of a report.

    Attributes:
        folder: Its folder, from that of the report.
        players: The names of its players, which differ.
        condition: What was played, in words: game, table, noise and clock. A match of a tournament
            has the condition of its tournament.
        test: Its sequential test; None without one.
        finished: Whether the match has ended.
        header: The first line of its record.
        frames: Its frames, by number.
        costs: What the answers of the two players took.
    """

    folder: str
    players: tuple[str, str]
    condition: str
    test: SequentialTest | None
    finished: bool
    header: str
    frames: tuple[ReportFrame, ...]
    costs: tuple[Costs, Costs]

    def pairs(self) -> Iterator[tuple[ReportFrame, ReportFrame]]:
        """The pairs of frames that are complete and count."""
        by_number = {frame.number: frame for frame in self.frames}
        for number_, first in by_number.items():
            second = by_number.get(number_ + 1)
            if number_ % 2 == 0 and second and None not in (first.points, second.points):
                yield first, second


def read_matches(root: Path) -> tuple[ReportMatch, ...]:
    """All matches below a folder that have a header.

    Raises:
        InputError: A record is damaged; the message has its line.
        OSError: A file cannot be read.
    """
    # A finished match may have both files for a moment.
    paths = {path.parent: path for path in root.rglob(PLAYED)}
    paths |= {path.parent: path for path in root.rglob(RECORD)}
    conditions = _Conditions()
    found = (_read(root, paths[folder], conditions) for folder in sorted(paths))
    return tuple(match for match in found if match)


class _Conditions:
    """The players and the conditions of matches that belong to tournaments."""

    def __init__(self) -> None:
        self._titles: dict[Path, dict[str, str]] = {}

    def of(self, block: Path) -> tuple[tuple[str, str], str] | None:
        """The names of the players in the tournament, and the condition; None without a tournament.

        Args:
            block: The folder of a block, EVENT/CONDITION/A+B/0001 in that of the tournament, in a
                Swiss round or a test EVENT/CONDITION/ROUND/A+B/0001.
        """
        folders = block.absolute().parents
        for depth in (3, 4):
            if depth >= len(folders) or not (folders[depth] / MANIFEST).exists():
                continue
            titles = self._titles_of(folders[depth])
            names = [unquote(name) for name in folders[0].name.split("+")]
            title = titles.get(folders[depth - 2].name)
            if len(names) == 2 and title is not None:
                return (names[0], names[1]), title
        return None

    def _titles_of(self, root: Path) -> dict[str, str]:
        """The titles of the conditions of a tournament by their keys."""
        if root not in self._titles:
            events = TournamentFolder.read(root).events
            self._titles[root] = {
                condition.key: condition.title for event in events for condition in event.conditions
            }
        return self._titles[root]


def _read(root: Path, path: Path, conditions: _Conditions) -> ReportMatch | None:
    """A match; None if its header is being written."""
    lines = path.read_text(encoding="utf-8").split("\n")
    # What follows the last line feed is being written.
    *complete, _ = lines
    if not complete:
        return None
    header = _line(path, 1, complete[0])
    if header.get("format") != _FORMAT:
        raise InputError(
            "format",
            f"{shown(path)}, line 1, format",
            "it is not a record of a match",
            f'give records with the format "{_FORMAT}"',
        )
    with _damaged(path, 1):
        names, condition = conditions.of(path.parent) or (_names(header), condition_of(header))
        written = header["test"]
        test = None if written is None else SequentialTest.of_record(written)
    costs = (Costs(), Costs())
    frames: dict[int, ReportFrame] = {}
    finished = False
    for n, line in enumerate(complete[1:], 2):
        node = _line(path, n, line)
        if "secret" in node:
            finished = True
            continue
        with _damaged(path, n):
            frame = _frame(node, line, names, costs)
            frames[frame.number] = frame
    return ReportMatch(
        folder=path.parent.relative_to(root).as_posix(),
        players=names,
        condition=condition,
        test=test,
        finished=finished,
        header=complete[0],
        frames=tuple(frames[k] for k in sorted(frames)),
        costs=costs,
    )


class _damaged:  # noqa: N801 -- used as a function
    """Names the line of a record whose values are not those of a record."""

    def __init__(self, path: Path, line: int) -> None:
        self.place = f"{shown(path)}, line {line}"

    def __enter__(self) -> None: ...

    def __exit__(self, kind: type[BaseException] | None, error: object, _: object) -> None:
        if isinstance(error, KeyError | TypeError | ValueError | IndexError | AttributeError):
            what = f"a value is missing or wrong ({type(error).__name__}: {error})"
            remedy = "give the record as it was written"
            raise InputError("format", self.place, what, remedy) from error


def _line(path: Path, number_: int, text: str) -> dict[str, Any]:
    try:
        node = json.loads(text)
    except ValueError:
        node = None
    if isinstance(node, dict):
        return node
    raise InputError(
        "syntax",
        f"{shown(path)}, line {number_}",
        "it is not a JSON object",
        "give the record as it was written",
    )


def _names(header: dict[str, Any]) -> tuple[str, str]:
    one, other = (str(player["name"]) for player in header["players"])
    return (f"{one} (A)", f"{other} (B)") if one == other else (one, other)


def _frame(
    node: dict[str, Any], line: str, names: tuple[str, str], costs: tuple[Costs, Costs]
) -> ReportFrame:
    seats, end = node["seats"], node["end"]
    for move in node["moves"]:
        costs[seats[move["seat"]]].add(move)
    points, winner = end["points"], end["winner"]
    return ReportFrame(
        number=node["frame"],
        players=(names[seats[0]], names[seats[1]]),
        winner=None if winner is None else names[winner],
        points=None if points is None else float(points[0]),
        reason=str(end["reason"]),
        why=str(end["why"]),
        shots=sum("executed" in move for move in node["moves"]),
        luck=frame_luck(node),
        line=line,
    )
