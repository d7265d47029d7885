"""Frames between identical players: the points are even, raw and corrected for luck."""

from __future__ import annotations

import json
import statistics
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from carom import _core

ROOT = Path(__file__).resolve().parents[2]
#: Frames that one run of the program plays, so that a stopped run loses few.
CHUNK = 250
#: The values of positions by which the luck is measured; the second one means nothing.
VALUES = ("logistic", "noise")


@dataclass(frozen=True)
class Identical:
    """Frames of one player against itself; the program is an example of carom-arena."""

    player: str
    frames: int
    game: str = "eight-ball"
    #: Fresh errors of each shot.
    draws: int = 8

    def describe(self) -> str:
        """The frames in words."""
        return f"{self.player} - itself, {self.frames} frames of {self.game}"

    def play(self, name: str, folder: Path, threads: int) -> dict[str, Any]:
        """Plays or continues the frames."""
        del name, threads
        folder.mkdir(parents=True, exist_ok=True)
        program = ["cargo", "run", "--release", "--quiet", "-p", "carom-arena"]
        program += ["--example", "identical_agents"]
        rows: list[dict[str, Any]] = []
        for first in range(0, self.frames, CHUNK):
            path = folder / f"{first}.jsonl"
            if not path.exists():
                count = min(CHUNK, self.frames - first)
                words = [self.player, self.game, str(self.draws), str(first), str(count)]
                found = subprocess.run(
                    [*program, "--", *words], cwd=ROOT, check=True, capture_output=True, text=True
                )
                path.write_text(found.stdout, encoding="utf-8")
            rows += map(json.loads, path.read_text("utf-8").splitlines())
        return {
            "player": self.player,
            "game": self.game,
            "draws": self.draws,
            "frames": len(rows),
            **shares(rows),
        }


def shares(rows: Iterable[dict[str, Any]]) -> dict[str, Any]:
    """The share of the points, raw and corrected by each value: mean and standard error.

    The corrected share is once that of the arena, and once the mean of points minus luck.
    """
    counted = [row for row in rows if row["points"] is not None]
    points = [row["points"] for row in counted]
    result: dict[str, Any] = {"raw": _mean(points)}
    for value in VALUES:
        lucks = [row[value] for row in counted]
        adjusted = _core.adjusted_share(list(zip(points, lucks, strict=True)), 0.95)
        plain = [point - luck for point, luck in zip(points, lucks, strict=True)]
        low, high = adjusted.pop("share_interval")
        result[value] = {
            **adjusted,
            "error": (high - low) / 3.92,
            "luck": _mean(lucks),
            "plain": _mean(plain),
        }
    return result


def _mean(values: list[float]) -> dict[str, float]:
    return {
        "mean": statistics.fmean(values),
        "error": statistics.stdev(values) / len(values) ** 0.5,
    }
