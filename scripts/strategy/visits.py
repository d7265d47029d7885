"""Visits to the table: how often does a player run out, and how many points does it score?"""

from __future__ import annotations

import statistics
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom import Noise
from processes import each
from rows import add_rows, read_rows
from seeds import seed_of

#: The table of random layouts, its size and the radius of its balls, m.
TABLE = "wpa-9ft"
SIZE = (1.27, 2.54)
RADIUS = 0.028575
#: Room around a ball that is placed at random, m.
ROOM = 0.005


@dataclass(frozen=True)
class Visits:
    """Visits of one player, each until the turn passes or the frame ends."""

    player: str
    count: int
    game: str = "eight-ball"
    #: Multiple of the Olympiad's noise.
    noise: float = 1.0
    table: str | None = None
    #: Where a visit begins: in straight pool with a break shot, otherwise with the break, or
    #: (eight-ball) with the cue ball in hand, this number of own balls, the eight and as many balls
    #: of the other player at random places.
    balls: int | None = None
    #: Points that end a frame of straight pool.
    points: int = 40

    def describe(self) -> str:
        """The visits in words."""
        start = "the break" if self.balls is None else f"ball in hand, {self.balls} own balls"
        if self.game == "straight-pool":
            start = "a break shot"
        return f"{self.player}, {self.count} × {self.game} from {start}, noise × {self.noise}"

    def play(self, name: str, folder: Path, threads: int) -> dict[str, Any]:
        """Plays or continues the visits, and counts what happened."""
        path = folder / "visits.jsonl"
        done = read_rows(path)
        known = {visit["number"] for visit in done}
        left = [number for number in range(self.count) if number not in known]
        for visit in each(partial(self.visit, name), left, threads):
            add_rows(path, [visit])
            done.append(visit)
        visits = [visit for visit in done if visit["number"] < self.count]
        runs = sorted(visit["points"] for visit in visits)
        return {
            "player": self.player,
            "noise": self.noise,
            "visits": len(visits),
            "won": sum(visit["won"] for visit in visits),
            "golden_breaks": sum(visit["won"] and visit["shots"] == 1 for visit in visits),
            "kept": sum(visit["won"] or visit["shots"] > 1 for visit in visits),
            "shots": sum(visit["shots"] for visit in visits),
            "points": {
                "mean": statistics.mean(runs),
                "median": runs[len(runs) // 2],
                "most": runs[-1],
            },
        }

    def visit(self, name: str, number: int) -> dict[str, Any]:
        """One visit."""
        seed = seed_of(name, number)
        noise = Noise.preset(f"olympiad:{self.noise}")
        player = carom.Player(self.player, noise=noise, seed=seed, threads=1)
        frame = self._frame(seed)
        seat, shots = frame.player, 0
        while not frame.over and frame.player == seat:
            decision = player.choose(frame)
            decision.apply(frame, noise=noise, seed=seed)
            shots += decision.play is not None
        won = frame.over and frame.request.get("winner") == seat
        return {
            "number": number,
            "won": won,
            "shots": shots,
            "points": frame.scores[seat] if seat is not None else 0,
        }

    def _frame(self, seed: int) -> carom.Frame:
        if self.balls is not None:
            return with_ball_in_hand(self.balls, seed)
        if self.game == "straight-pool":
            return with_break_shot(seed, self.points)
        return carom.Frame(self.game, table=self.table, seed=seed)


def with_break_shot(seed: int, points: int) -> carom.Frame:
    """A frame of straight pool in which player 0 has a break shot, as after fourteen balls.

    The rack has no ball at its apex. The fifteenth ball, to the right of the rack, can be cut into
    the top right pocket from below, and the cue ball then goes into the rack. Both are up to 3 cm
    from the places that are written here.
    """
    rng = np.random.default_rng(seed)
    racked = carom.Frame("straight-pool", table=TABLE, seed=seed).balls
    _, (apex, _) = sorted(racked.items(), key=lambda ball: ball[1][1])[:2]
    for ball, place in (("cue", (0.74, 1.5)), (apex, (0.78, 1.93))):
        x, y = place + rng.uniform(-0.03, 0.03, 2)
        racked[ball] = (float(x), float(y))
    return carom.Frame.of_shot("straight-pool", carom.Shot(TABLE, racked), points=points)


def with_ball_in_hand(own: int, seed: int) -> carom.Frame:
    """A frame of eight-ball in which player 1 has the cue ball in hand and the table is open.

    Each group has ``own`` balls. They and the eight are at random places, at least half a
    centimetre from each other and from the cushions. Player 0 has played a foul, in which no other
    ball moved.
    """
    rng = np.random.default_rng(seed)
    ids = ["cue", "8", *map(str, range(1, own + 1)), *map(str, range(9, 9 + own))]
    while True:
        started = carom.Frame.of_shot("eight-ball", carom.Shot(TABLE, random_layout(rng, ids)))
        before = started.balls
        foul = carom.Strike(speed=0.02, azimuth=float(rng.uniform(0.0, 2.0 * np.pi)))
        started.play(foul, call=carom.Call("safety"))
        still = all(started.balls[ball] == before[ball] for ball in ids[1:])
        if still and started.player == 1 and started.request["in_hand"] == "anywhere":
            return started


def random_layout(rng: np.random.Generator, ids: list[str]) -> dict[str, tuple[float, float]]:
    """Places of the balls on the table, independent and uniform where there is room."""
    near, far = RADIUS + ROOM, np.array(SIZE) - (RADIUS + ROOM)
    places: list[np.ndarray] = []
    while len(places) < len(ids):
        place = rng.uniform(near, far)
        if all(np.hypot(*(place - other)) > 2 * RADIUS + ROOM for other in places):
            places.append(place)
    return {ball: (float(x), float(y)) for ball, (x, y) in zip(ids, places, strict=True)}
