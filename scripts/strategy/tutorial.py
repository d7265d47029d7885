"""Frames against the planner of the tutorial "Two robots at eight-ball"."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import carom
from carom import Noise
from processes import each
from rows import add_rows, read_rows

PAGE = Path(__file__).resolve().parents[2] / "docs" / "tutorials" / "two_robots.md"
#: Pairs of even, independent frames that an interval adds, and the variance of such a pair's share
#: (docs/arena.md, Intervals).
PRIOR_PAIRS, PRIOR_VARIANCE = 10, 1 / 8


@dataclass(frozen=True)
class AgainstPlanner:
    """Pairs of frames of eight-ball against the tutorial's planner, with exchanged seats.

    Both players break as the planner does, with the same errors.
    """

    player: str
    pairs: int
    #: Multiple of the Olympiad's noise.
    noise: float = 1.0

    def describe(self) -> str:
        """The frames in words."""
        return f"{self.player} - the tutorial's planner, {self.pairs} pairs, noise × {self.noise}"

    def play(self, name: str, folder: Path, threads: int) -> dict[str, Any]:
        """Plays or continues the frames, and counts what the player wins."""
        path = folder / "frames.jsonl"
        done = read_rows(path)
        known = {row["frame"] for row in done}
        left = [number for number in range(2 * self.pairs) if number not in known]
        for row in each(partial(self.frame, name), left, threads):
            add_rows(path, [row])
            done.append(row)
        points = {row["frame"]: row["points"] for row in done}
        shares = [(points[2 * k] + points[2 * k + 1]) / 2 for k in range(self.pairs)]
        return {
            "players": [self.player, "the tutorial's planner"],
            "noise": self.noise,
            "pairs": self.pairs,
            "share": sum(shares) / self.pairs,
            "share_interval": list(interval(shares)),
        }

    def frame(self, name: str, number: int) -> dict[str, Any]:
        """One frame; the player begins those of even numbers."""
        seed = int.from_bytes(hashlib.sha256(f"{name} {number // 2}".encode()).digest()[:6])
        noise = Noise.preset(f"olympiad:{self.noise}")
        robots = tutorial_robots(noise)
        player = carom.Player(self.player, noise=noise, seed=seed, threads=1)
        own_seat = number % 2
        frame = carom.Frame("eight-ball", seed=seed)
        while not frame.over:
            is_break = frame.request.kind == "shot" and "safety" not in frame.request.calls
            if frame.player == own_seat and not is_break:
                decision = player.choose(frame)
                if decision.play is None:
                    decision.apply(frame)
                    continue
                play = decision.play
                answer = play.strike, {"cue_ball": play.cue_ball, "call": play.call}
            elif frame.request.kind == "choice":
                frame.choose(frame.request.choices[0])
                continue
            else:
                answer = robots["planner"](frame)
            strike, announced = answer
            frame.play(strike, noise=noise, seed=seed, **announced)
        winner = frame.request.winner
        points = 0.5 if winner is None else float(winner == own_seat)
        return {"frame": number, "points": points}


def tutorial_robots(noise: Noise) -> dict[str, Any]:
    """The functions of the page; they plan with this noise."""
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)
    robots: dict[str, Any] = {}
    for block in blocks:
        if "def winner" in block:
            break
        exec(compile(block, str(PAGE), "exec"), robots)
    robots["noise"] = noise
    return robots


def interval(shares: list[float]) -> tuple[float, float]:
    """The ends of the interval of pairs at 95 % (docs/arena.md, Intervals)."""
    pairs = len(shares)
    mean = sum(shares) / pairs
    squares = sum((share - mean) ** 2 for share in shares) + PRIOR_PAIRS * PRIOR_VARIANCE
    half = 1.96 * (squares / (pairs + PRIOR_PAIRS) / pairs) ** 0.5
    return max(mean - half, 0.0), min(mean + half, 1.0)
