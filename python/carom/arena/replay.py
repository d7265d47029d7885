"""Records of matches, played again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from carom import _core
from carom.arena.fresh_errors import DRAWS, luck_draws
from carom.arena.result import Score
from carom.arguments import number, text, thread_count
from carom.errors import InputError
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
        with_luck: The record with the luck of every shot, if ``replay_match`` was asked for it.
    """

    header: dict[str, Any]
    frames: int
    score: Score
    difference: dict[str, Any] | None
    other_engine: bool
    with_luck: str | None


def replay_match(
    record: str,
    *,
    luck: bool | int = False,
    level: float = 0.95,
    threads: int | None = None,
    progress: bool = False,
) -> MatchReplay:
    """Play the record of a match again, and compare every value.

    With the recorded answers, every rack, error, strike, ruling, trace and result is computed
    again from the secret of the match.

    Args:
        record: The text of the record (``match.jsonl``).
        luck: Whether to measure the luck of every shot, as ``play_match`` does: the score is then
            corrected for it. A luck that the record has is replaced.
        level: Confidence level of the score's intervals, in (0, 1).
        threads: Number of threads; None is one per core.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The record is damaged or not complete; the message has the line and the key.
    """
    written = text("record", record, "the content of match.jsonl")
    draws = luck_draws(luck)
    confidence = number("level", level)
    with stage_bars(["frames"], show=progress) as report:
        fields = _core.replay_match(written, draws, confidence, thread_count(threads), report)
    one, other = (player["name"] for player in fields["header"]["players"])
    score = Score._read(fields.pop("score"), (one, other), confidence)
    return MatchReplay(**fields, score=score)


def luck(
    record: str, *, draws: int = DRAWS, threads: int | None = None, progress: bool = False
) -> str:
    """The record of a match with the luck of every shot, as a match with ``luck`` writes it.

    The frames are played again with the recorded answers. The score that is corrected for luck is
    ``replay_match(record, luck=True).score.adjusted``.

    Args:
        record: The text of the record (``match.jsonl``). A luck that it has is replaced.
        draws: Number of fresh errors of each shot.
        threads: Number of threads; None is one per core.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The record is damaged or not complete, or does not replay to the bit.
    """
    found = replay_match(record, luck=draws, threads=threads, progress=progress)
    if found.difference is not None:
        where = f"line {found.difference['line']}, {found.difference['key']}"
        raise InputError(
            "changed",
            where,
            f"not reproduced: {found.difference['recorded']} against "
            f"{found.difference['replayed']}",
            "give the record as it was written, to the engine that wrote it",
        )
    assert found.with_luck is not None
    return found.with_luck
