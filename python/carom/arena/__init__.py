"""Matches between players, and tournaments."""

from __future__ import annotations

from carom.arena.bradley_terry import Rating, RatingTable, ratings
from carom.arena.bridge import Bridge
from carom.arena.match import play_match
from carom.arena.pair import OpenMatch, PlayedPair, play_pair
from carom.arena.plan import MatchPlan
from carom.arena.player_check import CheckReport, CheckVerdict, check
from carom.arena.replay import MatchReplay, luck, replay_match
from carom.arena.result import AdjustedShare, MatchResult, Score
from carom.arena.sequential import SequentialTest, TestResult
from carom.arena.tournament import Tournament
from carom.arena.tournament_result import Standing, Standings, TestOfChange, TournamentResult

__all__ = [
    "AdjustedShare",
    "Bridge",
    "CheckReport",
    "CheckVerdict",
    "MatchPlan",
    "MatchReplay",
    "MatchResult",
    "OpenMatch",
    "PlayedPair",
    "Rating",
    "RatingTable",
    "Score",
    "SequentialTest",
    "Standing",
    "Standings",
    "TestOfChange",
    "TestResult",
    "Tournament",
    "TournamentResult",
    "check",
    "luck",
    "play_match",
    "play_pair",
    "ratings",
    "replay_match",
]
