"""Studies: chapters of a position, a text, shots with their variations, and a task."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, Self

from carom import _core, arguments
from carom._core import Study as CoreStudy
from carom.errors import InputError
from carom.files import read_text, shown, write_whole
from carom.record import Record
from carom.shot import Shot

if TYPE_CHECKING:
    import os

    from carom.trace import Trace


class TaskVerdict(Record):
    """How a shot stands to the goal of a task.

    Attributes:
        met: Whether it meets every condition.
        fault: None if it does; ``cue-ball-lost``; or ``condition``.
        condition: Index of the first condition that it does not meet, or None.
        distance: How far outside its area the ball stopped, m, or None.
    """

    __slots__ = ()

    met: bool
    fault: Literal["cue-ball-lost", "condition"] | None
    condition: int | None
    distance: float | None


def judge(trace: Trace, goal: Sequence[Mapping[str, Any]]) -> TaskVerdict:
    """How a simulated shot stands to a goal.

    Args:
        trace: The trace of the shot.
        goal: Conditions as the file of a study has them; the shot must also keep the cue ball.

    Raises:
        InputError: A condition is unknown, or names no ball or pocket of the shot.
    """
    return TaskVerdict(_core.judge(trace._core, goal))


@dataclass(frozen=True)
class Chapter:
    """A chapter of a study.

    Attributes:
        title: Its title, a line.
        shot: The position, with what is drawn on the table; with a strike if the chapter shows one.
        text: What it says.
        tree: Shots from the position and those that follow them, as the file has them: each has
            ``strike``, and may have ``after``, the index of the earlier shot that it follows, and
            ``comment``.
        task: None, or what the reader shall do, as the file has it: ``goal``, a list of conditions,
            and ``solution``, a strike.
    """

    title: str
    shot: Shot
    text: str = ""
    tree: Sequence[Mapping[str, Any]] = ()
    task: Mapping[str, Any] | None = None

    @cached_property
    def solution(self) -> Shot | None:
        """The shot that solves the task; None if the chapter has none.

        Raises:
            InputError: The strike cannot be played.
        """
        strike = (self.task or {}).get("solution")
        if strike is None:
            return None
        return Shot.from_dict(self.shot._source() | {"strike": strike})

    def judge(self, trace: Trace) -> TaskVerdict:
        """How a shot from the chapter's position stands to the goal of its task.

        Raises:
            InputError: The chapter has no task, or its goal is invalid.
        """
        if self.task is None:
            raise InputError("missing", "task", "the chapter has no task", "choose one that has")
        return judge(trace, self.task["goal"])

    def _to_dict(self) -> dict[str, Any]:
        file: dict[str, Any] = {"title": self.title, "shot": self.shot._source()}
        if self.text:
            file["text"] = self.text
        if self.tree:
            file["tree"] = list(self.tree)
        if self.task is not None:
            file["task"] = self.task
        return file


class ChapterReport(Record):
    """What the simulation of a chapter found.

    Attributes:
        title: Title of the chapter.
        shots: How many shots were simulated.
        solution: How the solution of its task stands to the goal; None without a solution.
        faults: Shots that cannot be played, and a solution that does not meet its goal.
    """

    __slots__ = ()

    title: str
    shots: int
    solution: TaskVerdict | None
    faults: list[str]


@dataclass(frozen=True)
class StudyReport:
    """What the simulation of a study found. ``print`` it for a line for each chapter.

    Attributes:
        chapters: The reports of its chapters.
    """

    chapters: tuple[ChapterReport, ...]

    @property
    def ok(self) -> bool:
        """Whether nothing is at fault."""
        return not any(chapter.faults for chapter in self.chapters)

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {"ok": self.ok, "chapters": [dict(chapter) for chapter in self.chapters]}

    def __str__(self) -> str:
        width = len(str(len(self.chapters)))
        lines = []
        for number, chapter in enumerate(self.chapters, 1):
            shots = f"{chapter.shots} shot{'' if chapter.shots == 1 else 's'}"
            solved = ", solved" if chapter.solution and chapter.solution.met else ""
            lines.append(f"{number:>{width}}  {chapter.title}: {shots}{solved}")
            lines += [f"{'':>{width}}  {fault}" for fault in chapter.faults]
        return "\n".join(lines)


class Study:
    """A study (``carom-study/1``); immutable.

    Args:
        title: Its title, a line.
        chapters: One or more.
        author: Who made it.
        language: The language of its texts, a tag such as ``en``.

    Raises:
        InputError: Something is invalid; the message names the chapter and the place in it.
    """

    __slots__ = ("_chapters", "_core")
    _core: CoreStudy
    _chapters: tuple[Chapter, ...] | None

    def __init__(
        self,
        title: str,
        chapters: Sequence[Chapter],
        *,
        author: str | None = None,
        language: str | None = None,
    ) -> None:
        file: dict[str, Any] = {"format": "carom-study/1", "title": title}
        if author is not None:
            file["author"] = author
        if language is not None:
            file["language"] = language
        file["chapters"] = [chapter._to_dict() for chapter in chapters]
        self._core = CoreStudy.from_object(file)
        self._chapters = None

    @classmethod
    def _wrap(cls, core: CoreStudy) -> Self:
        study = cls.__new__(cls)
        study._core = core
        study._chapters = None
        return study

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read the file of a study.

        Raises:
            OSError: The file cannot be read.
            InputError: It is not a valid study.
        """
        return cls._read(read_text(path), shown(path))

    @classmethod
    def from_json(cls, text: str) -> Self:
        """Read a study from JSON text.

        Raises:
            InputError: It is not a valid study.
        """
        return cls._read(arguments.text("text", text), None)

    @classmethod
    def _read(cls, text: str, file: str | None) -> Self:
        """Read a study from JSON text; the error of a syntax fault names the file of the text."""
        return cls._wrap(CoreStudy.from_json(text, file))

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """Read a study from a dict in the form of its file.

        Raises:
            InputError: It is not a valid study.
        """
        return cls._wrap(CoreStudy.from_object(file))

    def to_dict(self) -> dict[str, Any]:
        """The file; ``from_dict`` of it gives this study again."""
        return self._core.to_object()

    def to_json(self) -> str:
        """The file as text."""
        return self._core.to_json()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the file.

        Raises:
            OSError: It cannot be written.
        """
        write_whole(path, self.to_json() + "\n")

    @property
    def title(self) -> str:
        """Its title."""
        title: str = self.to_dict()["title"]
        return title

    @property
    def author(self) -> str | None:
        """Who made it; None if it does not say."""
        return self.to_dict().get("author")

    @property
    def language(self) -> str | None:
        """The language of its texts; None if it does not say."""
        return self.to_dict().get("language")

    @property
    def chapters(self) -> tuple[Chapter, ...]:
        """Its chapters."""
        if self._chapters is None:
            files = self.to_dict()["chapters"]
            shots = self._core.shots()
            self._chapters = tuple(
                Chapter(
                    file["title"],
                    Shot._wrap(shot),
                    file.get("text") or "",
                    file.get("tree") or (),
                    file.get("task"),
                )
                for file, (shot, _) in zip(files, shots, strict=True)
            )
        return self._chapters

    def check(self) -> StudyReport:
        """Simulate the shots of every chapter, and judge the solutions of its tasks."""
        found = self._core.check()
        return StudyReport(tuple(_report(chapter) for chapter in found))

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self).from_dict, (self.to_dict(),))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Study) and self.to_dict() == other.to_dict()

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __repr__(self) -> str:
        return f"Study({self.title!r}, {len(self.chapters)} chapters)"


def _report(found: dict[str, Any]) -> ChapterReport:
    solution = found["solution"]
    return ChapterReport(found | {"solution": solution and TaskVerdict(solution)})
