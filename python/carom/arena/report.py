"""Reports of matches: what a folder of records has come to."""

from __future__ import annotations

import json
import os
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from carom import _core
from carom.arena.fresh_errors import frame_luck
from carom.arena.result import AdjustedShare
from carom.arguments import number
from carom.errors import InputError
from carom.files import checked_path, shown
from carom.noise import Noise

# The record of a finished match, and that of a match that goes on.
_RECORD, _PLAYED = "match.jsonl", "played.jsonl"
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
        condition: What was played, in words: game, table, noise and clock.
        finished: Whether the match has ended.
        header: The first line of its record.
        frames: Its frames, by number.
        costs: What the answers of the two players took.
    """

    folder: str
    players: tuple[str, str]
    condition: str
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
    costs: Costs = field(default_factory=Costs)
    losses: Counter[str] = field(default_factory=Counter)


@dataclass(frozen=True, slots=True)
class ReportTable:
    """The players of a condition.

    Attributes:
        condition: The condition in words.
        rows: The players, the highest share first.
        cross: The share of the points that a player has against another one, by both names.
    """

    condition: str
    rows: tuple[ReportRow, ...]
    cross: dict[tuple[str, str], Share]


@dataclass(frozen=True, slots=True)
class Report:
    """What a folder of matches has come to.

    Attributes:
        folder: The folder.
        level: Confidence level of the intervals.
        matches: The matches.
        tables: The tables, one for each condition: shares under different conditions are not
            compared.
    """

    folder: str
    level: float
    matches: tuple[ReportMatch, ...]
    tables: tuple[ReportTable, ...]

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
                    "cross": cross_of(table),
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
    records = _records(root)
    matches = tuple(match for match in (_read(root, path) for path in records) if match)
    if not matches:
        raise InputError(
            "missing",
            shown(root),
            "there is no match in it",
            f"give a folder with a {_RECORD} or a {_PLAYED} in it or below it",
        )
    by_condition: dict[str, list[ReportMatch]] = defaultdict(list)
    for match in matches:
        by_condition[match.condition].append(match)
    tables = tuple(
        _table(condition, found, confidence) for condition, found in by_condition.items()
    )
    return Report(str(root), confidence, matches, tables)


def _records(root: Path) -> list[Path]:
    """The records below a folder; that of a finished match if there are both."""
    found = {path.parent: path for path in root.rglob(_PLAYED)}
    found |= {path.parent: path for path in root.rglob(_RECORD)}
    return [found[folder] for folder in sorted(found)]


def _read(root: Path, path: Path) -> ReportMatch | None:
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
        names = _names(header)
        condition = _condition(header)
    costs = (Costs(), Costs())
    frames: dict[int, ReportFrame] = {}
    finished = False
    for n, written in enumerate(complete[1:], 2):
        node = _line(path, n, written)
        if "secret" in node:
            finished = True
            continue
        with _damaged(path, n):
            frame = _frame(node, written, names, costs)
            frames[frame.number] = frame
    return ReportMatch(
        folder=path.parent.relative_to(root).as_posix(),
        players=names,
        condition=condition,
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


def _condition(header: dict[str, Any]) -> str:
    """Game, table, noise and clock in words."""
    table = header["table"]
    named = table if isinstance(table, str) else "a table of its own"
    noises = {_noise_name(noise) for noise in header["noise"]}
    clocks = {_clock_name(clock) for clock in header["clock"]}
    # Names of built-in players may bring a noise and a clock, which differ from match to match.
    noise = noises.pop() if len(noises) == 1 else "each player's own noise"
    clock = clocks.pop() if len(clocks) == 1 else "each player's own clock"
    return ", ".join((str(header["game"]), named, noise, clock))


def _noise_name(values: dict[str, Any]) -> str:
    noise = Noise.from_dict(values)
    if noise == Noise():
        return "no noise"
    for name, _ in _core.noise_presets():
        if Noise.preset(name) == noise:
            return f"noise {name}"
    for factor in (0.25, 0.5, 2.0, 4.0):
        if Noise.olympiad(factor) == noise:
            return f"noise olympiad:{factor:g}"
    azimuth, speed = 1e3 * noise.azimuth, noise.speed
    return f"noise of {azimuth:.2g} mrad and {speed:.2g} m/s"


def _clock_name(clock: dict[str, Any]) -> str:
    unit = "simulations" if "simulations" in clock else "seconds"
    amount = f"{clock[unit]:g}"
    return f"{amount} {unit} a {clock['per']}"


def _table(condition: str, matches: Sequence[ReportMatch], level: float) -> ReportTable:
    rows: dict[str, ReportRow] = {}
    pairs: dict[tuple[str, str], list[tuple[float, float | None]]] = defaultdict(list)
    for match in matches:
        one, other = match.players
        for name, costs in zip(match.players, match.costs, strict=True):
            rows.setdefault(name, ReportRow(name)).costs.join(costs)
        for frame in match.frames:
            _count(rows[one], rows[other], frame)
        for first, second in match.pairs():
            assert first.points is not None
            assert second.points is not None
            points = first.points + second.points
            luck = None
            if first.luck is not None and second.luck is not None:
                luck = first.luck + second.luck
            pairs[one, other].append((points, luck))
            pairs[other, one].append((2.0 - points, None if luck is None else -luck))
    for row in rows.values():
        own = [pair for (one, _), found in pairs.items() if one == row.name for pair in found]
        row.pairs, row.share = len(own), _share(own, level)
        row.adjusted = _adjusted(own, level)
    cross = {key: share for key, found in pairs.items() if (share := _share(found, level))}
    ranked = sorted(rows.values(), key=lambda row: (-(row.share or (-1.0,))[0], row.name))
    return ReportTable(condition, tuple(ranked), cross)


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


def _share(pairs: Sequence[tuple[float, float | None]], level: float) -> Share | None:
    """The share of the points of whole pairs, with its interval (docs/arena.md, Statistics)."""
    if not pairs:
        return None
    counts = [0] * 5
    for points, _ in pairs:
        counts[int(2 * points)] += 1
    low, high = _core.pair_interval(counts, level)
    return Share(sum(points for points, _ in pairs) / (2 * len(pairs)), low, high)


def _adjusted(pairs: Sequence[tuple[float, float | None]], level: float) -> Share | None:
    found = AdjustedShare.of(pairs, level)
    return None if found is None else Share(found.share, *found.share_interval)
