"""Matches between two players, and what their records say."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import carom
from carom import Noise, Play, Strike
from carom.batch import own_strike


@dataclass(frozen=True)
class Match:
    """A match; the arguments are those of ``carom.play_match``."""

    one: str
    other: str
    pairs: int
    #: The noise of both players, or of each, as a multiple of the Olympiad's; None for that of
    #: their levels.
    noise: float | tuple[float, float] | None = 1.0
    game: str = "eight-ball"
    table: str | None = None
    #: Simulated shots of a frame for each player; in place of those of a decision.
    frame_simulations: tuple[int, int] | None = None
    #: The break preset of both players; None if they break in their own way.
    same_break: str | None = None
    #: Two shares of the points between which a sequential test decides.
    test: tuple[float, float] | None = None
    #: Who begins: "alternate", or a player.
    breaker: str | int = "alternate"
    #: Whether the luck of the shots is measured.
    luck: bool = False

    def describe(self) -> str:
        """The match in words."""
        return f"{self.one} - {self.other}, {self.pairs} pairs of {self.game}"

    def play(self, name: str, folder: Path, threads: int) -> dict[str, Any]:
        """Plays or continues the match, and counts what happened."""
        result = carom.play_match(
            self.one,
            self.other,
            out=folder,
            game=self.game,
            pairs=self.pairs,
            noise=self._noise(),
            table=self.table,
            frame_simulations=self.frame_simulations,
            breaker=self.breaker,
            same_break=self._break(),
            test=self.test,
            luck=self.luck,
            # The racks and errors are those of the name.
            secret=hashlib.sha256(name.encode()).hexdigest(),
            threads=threads,
        )
        score = result.to_dict()
        del score["record"]
        assert result.record is not None
        return {"players": [self.one, self.other], **score, **counts(result.record)}

    def _noise(self) -> Noise | tuple[Noise, Noise] | None:
        if self.noise is None:
            return None
        if isinstance(self.noise, tuple):
            one, other = (Noise.preset(f"olympiad:{multiple}") for multiple in self.noise)
            return one, other
        return Noise.preset(f"olympiad:{self.noise}")

    def _break(self) -> Play | None:
        if self.same_break is None:
            return None
        shot = carom.break_shot(self.game, table=self.table, preset=self.same_break)
        (place,) = (b["position"] for b in shot.to_dict()["balls"] if b["id"] == "cue")
        return Play(Strike(*own_strike(shot._core)), cue_ball=(place[0], place[1]))


def counts(record: Path) -> dict[str, Any]:
    """What the frames of a record have in common, for each player as the one who breaks.

    ``breaks``, ``kept`` (breaks after which the breaker answers the next request, or has won),
    ``break_wins``, ``runs`` (break and run: the other player never came to the table), ``pots``
    (called pots after the break) and ``made`` (those that kept the turn), ``safeties``,
    ``decisions``, ``simulations`` and ``seconds``.
    """
    tally = [Counter[str](), Counter[str]()]
    lines = record.read_text(encoding="utf-8").splitlines()
    for frame in map(json.loads, lines[1:-1]):
        moves, seats = frame["moves"], frame["seats"]
        winner = frame["end"]["winner"]
        breaker = tally[seats[0]]
        breaker["breaks"] += 1
        breaker["kept"] += next_seat(frame, 0) == 0
        breaker["break_wins"] += winner == seats[0]
        breaker["runs"] += winner == seats[0] and all(move["seat"] == 0 for move in moves)
        for number, move in enumerate(moves):
            player = tally[seats[move["seat"]]]
            cost = move.get("cost", {})
            player["decisions"] += 1
            player["simulations"] += cost.get("simulations", 0)
            player["seconds"] += cost.get("seconds", 0.0)
            call = (move.get("play", {}).get("call") or {}).get("kind")
            player["safeties"] += call == "safety"
            if call == "pocket" and number > 0:
                player["pots"] += 1
                player["made"] += next_seat(frame, number) == move["seat"]
    names = ("breaks", "kept", "break_wins", "runs", "pots", "made", "safeties", "decisions")
    names += ("simulations", "seconds")
    return {"counts": [{name: player[name] for name in names} for player in tally]}


def next_seat(frame: dict[str, Any], number: int) -> int | None:
    """The seat that answers the request after this move; after the last one that of the winner."""
    moves, winner = frame["moves"], frame["end"]["winner"]
    if number + 1 < len(moves):
        return int(moves[number + 1]["seat"])
    return None if winner is None else int(frame["seats"].index(winner))
