"""Matches between players."""

from __future__ import annotations

from carom.arena.match import play_match
from carom.arena.replay import MatchReplay, replay_match
from carom.arena.result import MatchResult, TestResult

__all__ = ["MatchReplay", "MatchResult", "TestResult", "play_match", "replay_match"]
