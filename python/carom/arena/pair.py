"""Pairs of a match that are played one by one, in this process or elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Self

from carom import _core
from carom.arena.contestants import Asking
from carom.arena.plan import MatchPlan
from carom.arena.result import MatchResult
from carom.arguments import instance, whole
from carom.errors import InputError
from carom.files import checked_path

if TYPE_CHECKING:
    import os

#: The file beside a record with the tracebacks of the players' exceptions.
LOG = "errors.log"


@dataclass(frozen=True, slots=True)
class PlayedPair:
    """A pair of frames that was played.

    Attributes:
        number: Its number in the match, from 0.
        lines: The lines of its two frames in the record, without line feeds.
        log: The tracebacks of the players' exceptions; empty without any.
    """

    number: int
    lines: tuple[str, str]
    log: str = ""


def play_pair(plan: MatchPlan, number: int) -> PlayedPair:
    """Play one pair of a match on the calling thread.

    If no clock counts seconds, the result depends only on the arguments: every process and every
    machine plays the same pair, to the bit.

    Args:
        plan: The match, with its secret (``OpenMatch.plan`` has it).
        number: The number of the pair, from 0.

    Raises:
        InputError: The plan has no secret, or a value in it is out of range.
        Exception: What a player raised, if the plan is strict.
        KeyboardInterrupt: Ctrl-C ended the pair.
    """
    plan = instance("plan", plan, MatchPlan, "OpenMatch.plan")
    if plan.secret is None:
        raise InputError("missing", "plan.secret", "the plan has none", "give OpenMatch.plan")
    log: list[str] = []
    asking = Asking(log.append, plan.strict)
    with asking.watching():
        one, other = _core.play_pair(
            plan.entrants(asking),
            plan.agreed,
            plan.secret,
            whole("number", number),
            lambda *_: None,
            asking.interrupt,
        )
    return PlayedPair(number, (one, other), "".join(log))


class OpenMatch:
    """A match in its folder, whose pairs are played elsewhere.

    ::

        plan = carom.arena.MatchPlan("greedy:9", "carom:50", pairs=2)
        with carom.arena.OpenMatch(plan, "match") as match:
            while (number := match.next_pair()) is not None:
                match.add(carom.arena.play_pair(match.plan, number))
            print(match.close())

    The pairs may come back in any order, and from anywhere: the record is the same. The folder is
    locked until the match is closed, which the end of the ``with`` does too.

    Args:
        plan: The match.
        folder: Its folder, in which it is begun or continued.

    Attributes:
        plan: The match with its secret.
        folder: Its folder.

    Raises:
        InputError: The plan is out of range, or the folder has another match or is in use.
        OSError: A file cannot be read or written.
    """

    def __init__(self, plan: MatchPlan, folder: str | os.PathLike[str]) -> None:
        self.folder = checked_path("folder", folder, "match")
        plan = plan.in_folder(self.folder)
        entrants = plan.entrants(Asking(log_to(self.folder), plan.strict))
        core = _core.OpenMatch(entrants, plan.agreed, plan.secret, self.folder)
        self._core: _core.OpenMatch | None = core
        self.plan = plan.with_secret(core.secret)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        # The match in Rust unlocks the folder when nothing refers to it any more.
        self._core = None

    def _open(self) -> _core.OpenMatch:
        if self._core is None:
            raise InputError("wrong-state", "match", "it is closed", "open it again")
        return self._core

    @property
    def played(self) -> int:
        """Number of pairs that were played."""
        return self._open().played

    def next_pair(self) -> int | None:
        """The number of the next pair to play; None if no more are needed.

        Every number is given out once. Open the match again to play a pair that was lost.
        """
        return self._open().next_pair()

    def add(self, pair: PlayedPair) -> None:
        """Write a pair that was played to the folder.

        Raises:
            InputError: Its lines are not those of a pair with its number.
            OSError: The file cannot be written.
        """
        if pair.log:
            log_to(self.folder)(pair.log)
        self._open().add(pair.number, pair.lines)

    def close(self, level: float = 0.95) -> MatchResult:
        """What the match has come to; its record is written if no more pairs are needed.

        Args:
            level: Confidence level of the intervals, in (0, 1).
        """
        plan = self.plan
        fields = self._open().close(level)
        self._core = None
        return MatchResult._read(fields, plan.game, plan.names, level, plan.test)


def log_to(folder: Path) -> Callable[[str], object]:
    """A function that adds a text to the log of the match in ``folder``."""

    def write(text: str) -> None:
        with (folder / LOG).open("a", encoding="utf-8") as log:
            log.write(text)

    return write
