"""What a reader or a check found in tracks: a place, a fault, and what was done or is to do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Level = Literal["note", "repair", "warning"]


@dataclass(frozen=True, slots=True)
class Finding:
    """A sentence about tracks.

    Attributes:
        level: ``"note"``: something that was assumed; ``"repair"``: something that was mended or
            left out; ``"warning"``: a fault that stayed, with its remedy.
        kind: A word for the fault that stays from version to version, such as ``"duplicate-row"``.
        place: Where: a file with its lines, or a shot and a ball.
        fault: What was found.
        remedy: What was done about it, or what to do.
        count: How many samples it concerns; 0 if it does not concern samples.
    """

    level: Level
    kind: str
    place: str
    fault: str
    remedy: str
    count: int = 0

    def __str__(self) -> str:
        return f"{self.place}: {self.fault}; {self.remedy}"


def listed(numbers: list[int], most: int = 5) -> str:
    """Line numbers as words: the first few, and how many more there are."""
    shown = ", ".join(map(str, numbers[:most]))
    word = "line" if len(numbers) == 1 else "lines"
    more = len(numbers) - most
    return f"{word} {shown}" + (f" and {more} more" if more > 0 else "")
