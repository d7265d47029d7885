"""The pairs of one match after another, for players elsewhere: processes, or other machines."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from types import TracebackType
from typing import Self

from carom.arena.pair import OpenMatch, PlayedPair


class PairQueue:
    """Gives out the pairs of matches, and writes those that come back, in any order.

    A match is opened when its first pair is given out, and ends when its last pair is back. The end
    of the ``with`` unlocks the folders of the matches that are still open.

    Args:
        matches: The matches; each one is taken, and so opened, when the ones before it have no more
            pairs to give out.
        ended: Called with a match that has ended.
    """

    def __init__(self, matches: Iterable[OpenMatch], ended: Callable[[OpenMatch], object]) -> None:
        self._left: Iterator[OpenMatch] = iter(matches)
        self._ended = ended
        # The match whose pairs are given out, and the pairs of each match that are played.
        self._now: OpenMatch | None = None
        self._played: dict[OpenMatch, int] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for match in self._played:
            match.__exit__(kind, error, trace)

    def next_pair(self) -> tuple[OpenMatch, int] | None:
        """The next pair to play: its match and its number in it; None if there is none."""
        while True:
            if self._now is None:
                self._now = next(self._left, None)
                if self._now is None:
                    return None
                self._played[self._now] = 0
            match, number = self._now, self._now.next_pair()
            if number is not None:
                self._played[match] += 1
                return match, number
            self._now = None
            self._end_if_last(match)

    def add(self, match: OpenMatch, pair: PlayedPair) -> None:
        """Write a pair that was played.

        Raises:
            InputError: As for ``OpenMatch.add``.
            OSError: The file cannot be written.
        """
        match.add(pair)
        self._played[match] -= 1
        self._end_if_last(match)

    def _end_if_last(self, match: OpenMatch) -> None:
        if match is not self._now and self._played[match] == 0:
            del self._played[match]
            self._ended(match)
