"""The summary of a run of a sweep."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Report:
    """The summary of a run.

    Attributes:
        folder: The folder of the files.
        sha256: Hash of the spec.
        rows: Rows of the whole table; all of them are in the folder now.
        failed: Rows that could not be simulated; their column ``error`` has the reason.
        parts: Files of the whole table.
        parts_before: Files that existed before this run.
        bytes: Size of all files.
        seconds: Duration of this run, without Ray's start.
        ray_start_seconds: Duration of Ray's start; None without Ray.
        workers: Number of processes that wrote parts.
        parts_unchecked: Files without a checksum, which older versions of carom wrote.
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
    parts_unchecked: int = 0

    def to_dict(self) -> dict[str, Any]:
        """The summary as a dict of plain values."""
        return asdict(self)

    def __str__(self) -> str:
        lines = [f"{self.rows:,} rows in {self.parts:,} parts, {self.bytes / 1e6:,.1f} MB"]
        if self.parts_before:
            lines.append(f"{self.parts_before:,} of the parts existed before")
        if self.parts_unchecked:
            lines.append(
                f"{self.parts_unchecked:,} parts have no checksum, so they were not checked for "
                "damage; delete them, and the next run writes them again with a checksum"
            )
        if self.failed:
            lines.append(f"{self.failed:,} rows could not be simulated; see their column `error`")
        if self.ray_start_seconds is not None:
            lines.append(f"Ray started in {self.ray_start_seconds:.1f} s")
        return "\n".join([*lines, f"took {self.seconds:.1f} s; the spec is {self.sha256[:12]}"])
