"""Endings, beside a search of nearly all plays."""

from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
#: Positions that one run of the program plays, so that a stopped run loses few.
CHUNK = 10


@dataclass(frozen=True)
class Ending:
    """Positions of an ending; the program is the example ``endings`` of carom-mind."""

    ending: str
    count: int
    simulations: int

    def describe(self) -> str:
        """The ending in words."""
        return f"carom:{self.simulations}, {self.count} positions of {self.ending}"

    def play(self, name: str, folder: Path, threads: int) -> dict[str, Any]:
        """Plays or continues the positions."""
        del name, threads
        folder.mkdir(parents=True, exist_ok=True)
        program = ["cargo", "run", "--release", "--quiet", "-p", "carom-mind"]
        program += ["--example", "endings"]
        losses: list[float] = []
        for first in range(0, self.count, CHUNK):
            path = folder / f"{first}.jsonl"
            if not path.exists():
                count = min(CHUNK, self.count - first)
                words = [self.ending, str(first), str(count), str(self.simulations)]
                found = subprocess.run(
                    [*program, "--", *words], cwd=ROOT, check=True, capture_output=True, text=True
                )
                path.write_text(found.stdout, encoding="utf-8")
            for line in path.read_text("utf-8").splitlines():
                position = json.loads(line)
                losses.append(round(position["best"] - position["chosen"], 4))
        return {"simulations": self.simulations, "losses": losses}
