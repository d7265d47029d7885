"""Frames against the planner of the tutorial "Two robots at eight-ball"."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import carom
from carom import Noise, _core
from processes import each
from rows import add_rows, read_rows
from seeds import seed_of

PAGE = Path(__file__).resolve().parents[2] / "docs" / "tutorials" / "two_robots.md"


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
        pairs = [points[2 * k] + points[2 * k + 1] for k in range(self.pairs)]
        counts = [pairs.count(half / 2) for half in range(5)]
        return {
            "players": [self.player, "the tutorial's planner"],
            "noise": self.noise,
            "pairs": self.pairs,
            "share": sum(pairs) / 2 / self.pairs,
            "share_interval": _core.pair_interval(counts, level=0.95),
        }

    def frame(self, name: str, number: int) -> dict[str, Any]:
        """One frame; the player begins those of even numbers."""
        seed = seed_of(name, number // 2)
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
