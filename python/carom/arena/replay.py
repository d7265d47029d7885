"""Records of matches, played again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from carom import _core
from carom.arena.result import Score
from carom.arguments import number, text, thread_count
from carom.progress import stage_bars


@dataclass(frozen=True, slots=True)
class MatchReplay:
    """What the replay of a match's record has found.

    Attributes:
        header: The first line of the record: settings and players (docs/arena.md).
        frames: Number of frames.
        score: The score of the record.
        difference: The first value that the replay does not reproduce: ``line``, ``key``,
            ``recorded``, ``replayed``. None if the record has replayed to the bit.
        other_engine: Whether another version of the engine wrote the record.
    """

    header: dict[str, Any]
    frames: int
    score: Score
    difference: dict[str, Any] | None
    other_engine: bool


def replay_match(
    record: str, *, level: float = 0.95, threads: int | None = None, progress: bool = False
) -> MatchReplay:
    """Play the record of a match again, and compare every value.

    With the recorded answers, every rack, error, strike, ruling, trace and result is computed
    again from the secret of the match.

    Args:
        record: The text of the record (``match.jsonl``).
        level: Confidence level of the score's intervals, in (0, 1).
        threads: Number of threads; None is one per core.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The record is damaged or not complete; the message has the line and the key.
    """
    written = text("record", record, "the content of match.jsonl")
    confidence = number("level", level)
    with stage_bars(["frames"], show=progress) as report:
        fields = _core.replay_match(written, confidence, thread_count(threads), report)
    one, other = (player["name"] for player in fields["header"]["players"])
    score = Score._read(fields.pop("score"), (one, other), confidence)
    return MatchReplay(**fields, score=score)
