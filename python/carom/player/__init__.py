"""Players: programs that choose a shot, and explain the choice."""

from __future__ import annotations

from carom.player.analysis import Analysis, Leave, Recommendation
from carom.player.decision import Decision, Play
from carom.player.drawn import PotPlay, Successor, pots, successors
from carom.player.player import Player, players
from carom.player.situation import Situation

__all__ = [
    "Analysis",
    "Decision",
    "Leave",
    "Play",
    "Player",
    "PotPlay",
    "Recommendation",
    "Situation",
    "Successor",
    "players",
    "pots",
    "successors",
]
