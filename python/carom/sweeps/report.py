"""What a run of a sweep has done."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Report:
    """What a run has done.

    Attributes:
        folder: Where the files are.
        sha256: Of the spec.
        rows: Rows of the whole table, all of which lie in the folder now.
        failed: Of these, how many could not be played: their column ``error`` says why.
        parts: Files of the whole table.
        parts_before: Of these, how many were there already.
        bytes: Size of all files.
        seconds: What this run took, Ray's start not included.
        ray_start_seconds: What that took; None without Ray.
        workers: How many processes have written parts.
    """

    folder: str
    sha256: str
    rows: int
    failed: int
    parts: int
    parts_before: int
    bytes: int
    seconds: float
    ray_start_seconds: float | None = None
    workers: int = 1

    def to_dict(self) -> dict[str, Any]:
        """As plain values."""
        return asdict(self)

    def __str__(self) -> str:
        lines = [f"{self.rows:,} rows in {self.parts:,} parts, {self.bytes / 1e6:,.1f} MB"]
        if self.parts_before:
            lines.append(f"{self.parts_before:,} of the parts were there already")
        if self.failed:
            lines.append(f"{self.failed:,} rows could not be played: see their column `error`")
        if self.ray_start_seconds is not None:
            lines.append(f"Ray started in {self.ray_start_seconds:.1f} s")
        return "\n".join([*lines, f"took {self.seconds:.1f} s; the spec is {self.sha256[:12]}"])
