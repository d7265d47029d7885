"""Drills: files with layouts and goals, judged by the engine; and puzzles made from a seed.

Goals are plain values, as docs/drills.md describes them.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Self

from carom import _core
from carom.arguments import text
from carom.errors import InputError
from carom.files import read_text, shown, write_whole
from carom.record import Record
from carom.shot import Shot
from carom.trace import Trace

if TYPE_CHECKING:
    import os


class DrillVerdict(Record):
    """How a shot of a drill or puzzle went.

    Attributes:
        points: Points of the attempt so far.
        fault: None if the shot was good; else its ``kind`` (``scratch``, ``need``, ``zone``,
            ``wrong-first``, ``no-pot``, ``wrong-ball``) and, where it has them, the ``index`` of
            the condition, the ``distance`` outside an area, m, and the ``ball``.
        left: Balls that a run still has to pot.
    """

    __slots__ = ()

    points: int
    fault: dict[str, Any] | None
    left: list[str]


class PuzzleWay(Record):
    """A strike that solves a puzzle.

    Attributes:
        strike: Its ``speed`` (m/s), ``azimuth``, ``elevation`` (rad), ``side`` and ``height`` (ball
            radii).
        chances: The chance of each level of play to solve the puzzle with it.
    """

    __slots__ = ()

    strike: dict[str, float]
    chances: dict[str, float]


class DrillStep:
    """A layout with its goal.

    Attributes:
        shot: The layout, with a strike at the first object ball.
        goal: What an attempt must do.
        hand: Where the cue ball may be placed before the first shot; None: it stays where it is.
    """

    def __init__(self, shot: Shot, goal: Mapping[str, Any], hand: Mapping[str, Any] | None) -> None:
        self.shot = shot
        self.goal = dict(goal)
        self.hand = None if hand is None else dict(hand)

    def judge(self, played: Shot | Trace, left: Sequence[str] | None = None) -> DrillVerdict:
        """Judge a shot of this step.

        Args:
            played: The shot, or its trace.
            left: The balls that a run still has to pot; default: all of the goal.

        Raises:
            InputError: The shot lacks a strike or a ball of the goal.
        """
        return judged(played, self.goal, left)

    def words(self) -> str:
        """The goal in English."""
        return goal_words(self.goal)


class Drill:
    """A drill, `carom-drill/1`: steps with layouts and goals, and how they score."""

    def __init__(self, file: Mapping[str, Any]) -> None:
        self._file = dict(file)

    @classmethod
    def from_json(cls, source: str) -> Self:
        """The drill of a text.

        Raises:
            InputError: It names the place of what is wrong; or the text is larger than 256 kB.
        """
        return cls._read(text("source", source), None)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a drill file.

        Raises:
            InputError: As for ``from_json``, with the name of the file.
            OSError: The file cannot be read.
        """
        return cls._read(read_text(path), shown(path))

    @classmethod
    def _read(cls, source: str, name: str | None) -> Self:
        return cls(_core.read_drill(source, name))

    def to_dict(self) -> dict[str, Any]:
        """The plain values of the file."""
        return dict(self._file)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the file.

        Raises:
            OSError: It cannot be written; a file that was there before is unchanged.
        """
        write_whole(path, json.dumps(self._file, indent=1) + "\n")

    @property
    def name(self) -> str:
        """Its name."""
        return str(self._file["name"])

    @property
    def text(self) -> str:
        """What to do, for players; may be empty."""
        return str(self._file.get("text", ""))

    @property
    def attempts(self) -> int:
        """Number of attempts."""
        return int(self._file["attempts"])

    @property
    def misses(self) -> int | None:
        """After this number of misses the drill ends early; None: it does not."""
        return self._file.get("misses")

    @property
    def order(self) -> Literal["same", "ladder", "turns"]:
        """Which step comes next: always the first, up and down a ladder, or one after another."""
        order: Literal["same", "ladder", "turns"] = self._file["order"]
        return order

    @property
    def steps(self) -> list[DrillStep]:
        """The steps."""
        table, cue = self._file["table"], self._file["cue"]
        return [_step(table, cue, step) for step in self._file["steps"]]

    def __repr__(self) -> str:
        return f"Drill({self.name!r}, {len(self._file['steps'])} steps, {self.attempts} attempts)"


class Puzzle:
    """A puzzle: a position, a goal and its solution, from a theme and a number alone.

    Attributes:
        id: Theme and number, such as ``cut-17``.
        theme: What it is about.
        rating: Its difficulty; the levels of play from beginner to professional have 1000, 1300,
            1600, 1900 and 2200.
        shot: The layout, with a strike at the first object ball.
        goal: What a shot must do.
        chances: By level of play, the chance to solve it with the best way of that level.
        ways: Different strikes that solve it, each with ``strike`` (SI and radians) and
            ``chances``; the first one is the best for a club player.
    """

    def __init__(self, data: Mapping[str, Any]) -> None:
        self._data = dict(data)
        self.id: str = data["id"]
        self.theme: str = data["theme"]
        self.rating: float = data["rating"]
        self.shot = Shot.from_dict(data["shot"])
        self.goal: dict[str, Any] = data["goal"]
        self.chances: dict[str, float] = data["chances"]
        self.ways = [PuzzleWay(way) for way in data["ways"]]

    def solution(self, way: int = 0) -> Shot:
        """The shot with one of the ways."""
        return self.shot.with_strike(**self.ways[way].strike)

    def judge(self, played: Shot | Trace) -> DrillVerdict:
        """Judge a shot at it.

        Raises:
            InputError: The shot lacks a strike or a ball of the goal.
        """
        return judged(played, self.goal)

    def words(self) -> str:
        """The goal in English."""
        return goal_words(self.goal)

    def layout(self) -> Shot:
        """The balls at rest, without a strike."""
        file = self.shot.to_dict()
        del file["strike"]
        return Shot.from_dict(file)

    def to_dict(self) -> dict[str, Any]:
        """The plain values."""
        return dict(self._data)

    def __repr__(self) -> str:
        return f"Puzzle({self.id!r}, rating {self.rating:.0f})"


def puzzle(name: str) -> Puzzle:
    """The puzzle with an id, such as ``cut-17``: the same on every machine.

    Raises:
        InputError: There is no such puzzle.
    """
    return Puzzle(_core.read_puzzle(text("name", name)))


def puzzles(theme: str | None = None) -> dict[str, int]:
    """The puzzles that were found good: their ids and ratings (rounded to ten).

    Args:
        theme: One of the themes, such as ``three-cushion``; None lists all.

    Raises:
        InputError: There is no such theme.
    """
    known = _core.puzzle_themes()
    if theme is not None and theme not in known:
        listed = ", ".join(known)
        what = f"there is no theme {theme!r}"
        raise InputError("unknown-name", "theme", what, f"write one of {listed}")
    listed_puzzles = _core.accepted_puzzles()
    return {f"{name}-{k}": rating for name, k, rating in listed_puzzles if theme in (None, name)}


def judged(
    played: Shot | Trace, goal: Mapping[str, Any], left: Sequence[str] | None = None
) -> DrillVerdict:
    """Judge a shot by a goal: see ``DrillStep.judge``."""
    shot = played.shot if isinstance(played, Trace) else played
    if left is None:
        left = goal["balls"] if goal.get("kind") == "run" else []
    return DrillVerdict(_core.judge_shot(shot._core, dict(goal), list(left)))


def _step(table: str, cue: str, step: Mapping[str, Any]) -> DrillStep:
    balls = step["balls"]
    shot = Shot.from_dict(
        {
            "format": "carom-shot/1",
            "table": table,
            "balls": balls,
            "strike": {"ball": cue, "speed": step.get("speed", 1.6), "azimuth_deg": 90.0},
        }
    )
    return DrillStep(shot, step["goal"], step.get("hand"))


def goal_words(goal: Mapping[str, Any]) -> str:
    """A goal in English sentences."""
    if goal["kind"] == "run":
        balls = ", ".join(goal["balls"])
        return {
            "eight": f"Pot {balls} without a miss, the last one at the end.",
            "rotation": f"Hit the first ball that is left, and pot {balls} without a miss.",
            "sequence": f"Pot {balls} in this order, without a miss.",
        }[goal["order"]]
    sentences = [_need_words(need) for need in goal["needs"]]
    zones = goal.get("zones", [])
    if zones:
        points = ", ".join(str(zone["points"]) for zone in zones)
        sentences.append(f"The zone in which the cue ball stops gives {points} points.")
    return " ".join(sentences)


def _need_words(need: Mapping[str, Any]) -> str:
    ball, balls = need.get("ball", ""), " and ".join(need.get("balls", []))
    count = need.get("cushions", 0)
    cushions = "a cushion" if count == 1 else f"{count} cushions"
    distance = f"{100 * need.get('distance', 0.0):.0f} cm"
    into = f" in the {need['pocket']} pocket" if "pocket" in need else ""
    after = f", the second one after {cushions}" if count else ""
    return {
        "pot": f"Pot {ball}{into}.",
        "pot-any": "Pot a ball.",
        "first": f"Hit {ball} first.",
        "kick": f"The cue ball meets {cushions} before any ball.",
        "cushions": f"{ball} meets {cushions}.",
        "carom": f"Hit both other balls{after}.",
        "touch": f"Hit {balls} with the cue ball.",
        "avoid": f"Do not hit {ball}.",
        "stop": f"Leave {ball or 'the cue ball'} {_area_words(need.get('area', {}))}.",
        "hidden": f"At the end no straight line leads from the cue ball to {ball}.",
        "next": f"Leave a direct pot of {ball} with a cut of at most 50°.",
        "apart": f"Drive {balls} at least {distance} apart.",
        "gather": f"All balls stop within {distance} of the cue ball.",
    }[need["kind"]]


def _area_words(area: Mapping[str, Any]) -> str:
    if "center" in area:
        x, y = area["center"]
        return f"within {100 * area['radius']:.0f} cm of ({x:.2f}, {y:.2f})"
    if "from" in area:
        (left, low), (right, high) = area["from"], area["to"]
        return f"between ({left:.2f}, {low:.2f}) and ({right:.2f}, {high:.2f})"
    return "in the outlined area" if "outline" in area else "in the D"


def areas_of(step: DrillStep) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """The areas that a diagram of a step shows: ``hand``, ``stop`` or the points of a zone."""
    if step.hand is not None:
        yield "hand", step.hand
    for need in step.goal.get("needs", []):
        if need["kind"] == "stop":
            yield "stop", need["area"]
    for zone in step.goal.get("zones", []):
        yield str(zone["points"]), zone["area"]
