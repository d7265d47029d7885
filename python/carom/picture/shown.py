"""What diagrams show of shots, traces, frames and studies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from carom.errors import InputError
from carom.rules import Frame
from carom.shot import Shot
from carom.study import Chapter, Study
from carom.trace import Trace


@dataclass(frozen=True)
class Shown:
    """What a diagram shows: a shot or a frame, and what a chapter or a drill adds."""

    drawn: Trace | Shot | Frame
    heading: str | None = None
    marks: tuple[dict[str, Any], ...] = ()
    text: str = ""


Drawn = Trace | Shot | Frame | Chapter | Study | Shown


def shown_of(found: Drawn | Sequence[Drawn], solutions: bool) -> list[Shown]:
    """What the diagrams show, one for each shot, trace, frame and chapter.

    Args:
        found: One or several of them; a study has its chapters.
        solutions: Whether a chapter with a task shows its solution.

    Raises:
        InputError: It is nothing that can be drawn.
    """
    many = list(found) if isinstance(found, list | tuple) else [found]
    shown: list[Shown] = []
    for one in many:
        if isinstance(one, Study):
            shown += [_chapter(chapter, solutions) for chapter in one.chapters]
        elif isinstance(one, Chapter):
            shown.append(_chapter(one, solutions))
        elif isinstance(one, Shown):
            shown.append(one)
        elif isinstance(one, Trace | Shot | Frame):
            shown.append(Shown(one))
        else:
            raise InputError(
                "wrong-type",
                "found",
                f"{type(one).__name__} is not a shot, a trace, a frame, a chapter or a study",
                "give one of these, or a list of them",
            )
    if not shown:
        raise InputError("missing", "found", "there is nothing to draw", "give a shot")
    return shown


def _chapter(chapter: Chapter, solutions: bool) -> Shown:
    solution = chapter.solution if solutions else None
    goal = (chapter.task or {}).get("goal", ())
    areas = tuple(_area(one["area"]) for one in goal if one["kind"] == "stop")
    return Shown(solution or chapter.shot, chapter.title, areas, chapter.text)


def _area(area: Mapping[str, Any]) -> dict[str, Any]:
    """The area of a goal as a mark."""
    return {"kind": "area" if "outline" in area else "circle", "color": "blue", **area}


def heading_of(shown: Shown, title: str | None, index: int, count: int) -> str:
    """The heading of a diagram; ``index`` is its place among ``count`` of them."""
    heading = shown.heading
    if count == 1:
        return title or heading or ""
    if heading is not None:
        return f"{index + 1}  {heading}"
    return f"{title} {index + 1}" if title else str(index + 1)
