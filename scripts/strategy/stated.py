"""Stated chances beside what happens with other errors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import carom
from carom import Noise
from rows import add_rows, read_rows, write_rows
from seeds import seed_of

#: Errors that are drawn for each decision, besides those of the frame itself.
DRAWS = 100


@dataclass(frozen=True)
class Stated:
    """Decisions of a player against itself, each with the chances that it states."""

    player: str
    decisions: int
    game: str = "eight-ball"
    #: Multiple of the Olympiad's noise.
    noise: float = 1.0

    def describe(self) -> str:
        """The decisions in words."""
        return f"{self.player}, {self.decisions} decisions of {self.game}, noise × {self.noise}"

    def play(self, name: str, folder: Path, threads: int) -> dict[str, Any]:
        """Plays or continues the frames, and compares the chances with what happened."""
        del threads
        path = folder / "decisions.jsonl"
        done = read_rows(path)
        # A frame that was stopped in the middle is played again.
        frame = max((row["frame"] for row in done), default=0)
        done = [row for row in done if row["frame"] < frame]
        write_rows(path, done)
        while len(done) < self.decisions:
            rows = list(self._frame(name, frame))
            add_rows(path, rows)
            done += rows
            frame += 1
        rows = done[: self.decisions]
        return {
            "player": self.player,
            "noise": self.noise,
            "draws": DRAWS,
            "kept": compare(rows, "kept"),
            "foul": compare(rows, "foul"),
        }

    def _frame(self, name: str, number: int) -> Iterator[dict[str, Any]]:
        """The decisions of one frame."""
        seed = seed_of(name, number)
        noise = Noise.preset(f"olympiad:{self.noise}")
        players = [
            carom.Player(self.player, noise=noise, seed=seed + seat, threads=1) for seat in (0, 1)
        ]
        frame = carom.Frame(self.game, seed=seed)
        shots = 0
        while not frame.over:
            player = players[frame.player or 0]
            if frame.request["kind"] == "shot":
                best = player.explain(frame, 1).plays[0]
                kept, foul = self._happened(frame, best.play, noise, seed ^ (1 << 50) + shots)
                yield {
                    "frame": number,
                    "kept": [float(best.kept), kept],
                    "foul": [float(best.foul), foul],
                }
                carom.Decision(best.play).apply(frame, noise=noise, seed=seed)
                shots += 1
            else:
                player.choose(frame).apply(frame)

    def _happened(
        self, frame: carom.Frame, play: carom.Play, noise: Noise, seed: int
    ) -> tuple[float, float]:
        """The shares of draws in which the turn is kept or the frame won, and of fouls."""
        kept = fouls = 0
        shot, seat = play.shot(frame), frame.player
        for draw in range(DRAWS):
            after = frame.copy()
            ruling = after.play(
                noise.draw(shot, draw, seed=seed), cue_ball=play.cue_ball, call=play.call
            )
            fouls += bool(ruling.fouls)
            kept += after.request["winner"] == seat if after.over else after.player == seat
        return kept / DRAWS, fouls / DRAWS


def compare(rows: list[dict[str, Any]], key: str) -> dict[str, Any]:
    """Stated and counted shares: their means, and those of each tenth of the stated ones."""
    pairs = [row[key] for row in rows]
    stated, counted = (sum(pair[k] for pair in pairs) / len(pairs) for k in (0, 1))
    tenths = []
    for tenth in range(10):
        found = [pair for pair in pairs if min(int(10 * pair[0]), 9) == tenth]
        if found:
            means = [round(sum(pair[k] for pair in found) / len(found), 4) for k in (0, 1)]
            tenths.append({"stated": means[0], "counted": means[1], "decisions": len(found)})
    return {"stated": round(stated, 4), "counted": round(counted, 4), "tenths": tenths}
