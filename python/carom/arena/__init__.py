"""Matches between players."""

from __future__ import annotations

from carom.arena.match import play_match
from carom.arena.pair import OpenMatch, PlayedPair, play_pair
from carom.arena.plan import MatchPlan
from carom.arena.replay import MatchReplay, replay_match
from carom.arena.result import MatchResult, TestResult

__all__ = [
    "MatchPlan",
    "MatchReplay",
    "MatchResult",
    "OpenMatch",
    "PlayedPair",
    "TestResult",
    "play_match",
    "play_pair",
    "replay_match",
]
