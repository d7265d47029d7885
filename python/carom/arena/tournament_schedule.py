"""Who meets whom in a tournament."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import TYPE_CHECKING
from urllib.parse import quote

if TYPE_CHECKING:
    from carom.arena.tournament_file import Condition, Event


@dataclass(frozen=True, slots=True)
class Encounter:
    """Two players who meet in an event under a condition.

    Attributes:
        event: The event.
        condition: The condition.
        players: Their names; the first one is player 0 of the records.
        round: The round of a Swiss tournament, from 1; else 0.
    """

    event: Event
    condition: Condition
    players: tuple[str, str]
    round: int = 0

    @property
    def path(self) -> PurePosixPath:
        """The folder of the encounter in that of the tournament.

        It depends neither on the other players nor on the order of the players in the file.
        """
        path = event_path(self.event, self.condition)
        if self.round:
            path /= f"round-{self.round:02}"
        return path / "+".join(quote(name, safe="") for name in self.players)


def event_path(event: Event, condition: Condition) -> PurePosixPath:
    """The folder of an event under a condition. A test with other hypotheses is another one."""
    path = PurePosixPath(event.name, condition.key)
    if event.shares is not None:
        low, high = event.shares
        return path / f"{low:.6g}-{high:.6g}-{event.pairs}"
    if event.nelo is not None:
        low, high = event.nelo
        return path / f"nelo_{low:.6g}_{high:.6g}_{event.pairs}"
    return path


def encounters(event: Event, condition: Condition) -> Iterator[Encounter]:
    """All encounters of an event whose encounters do not depend on results."""
    pairs: Iterable[tuple[str, str]] = itertools.combinations(event.players, 2)
    if event.kind == "gauntlet":
        pairs = itertools.product(event.players, event.against)
    for one, other in pairs:
        # The order is that of the names, so that the order in the file may change. Of a test the
        # changed player is the first one.
        names = (one, other) if event.kind == "test" or one < other else (other, one)
        yield Encounter(event, condition, names)


@dataclass(frozen=True, slots=True)
class Round:
    """A round of a Swiss tournament.

    Attributes:
        pairs: Who meets whom.
        bye: The player without an opponent, who gets the points of a won match; None if the number
            of players is even.
    """

    pairs: tuple[tuple[str, str], ...]
    bye: str | None


def swiss_round(
    players: Sequence[str], points: Mapping[str, tuple[float, float]], rounds: Sequence[Round]
) -> Round:
    """The next round: players with equal points meet, and two players meet only once.

    Args:
        players: The names in the order of the file, which decides between equals.
        points: The points of matches and of frames of each player so far.
        rounds: The rounds so far.
    """
    order = sorted(players, key=lambda name: (-points[name][0], -points[name][1]))
    met = {frozenset(pair) for each in rounds for pair in each.pairs}
    bye = None
    if len(order) % 2:
        had = {each.bye for each in rounds}
        # The last one without a bye; each player has one before anybody has two.
        bye = next((name for name in reversed(order) if name not in had), order[-1])
        order.remove(bye)
    pairs = _paired(order, met) or tuple(zip(order[::2], order[1::2], strict=True))
    return Round(tuple((min(pair), max(pair)) for pair in pairs), bye)


def _paired(order: Sequence[str], met: set[frozenset[str]]) -> tuple[tuple[str, str], ...] | None:
    """Pairs of players who have not met: the first player with the next possible one, and so on.

    None if there are no such pairs.
    """
    if not order:
        return ()
    one, *others = order
    for i, other in enumerate(others):
        if frozenset((one, other)) in met:
            continue
        rest = _paired(others[:i] + others[i + 1 :], met)
        if rest is not None:
            return ((one, other), *rest)
    return None
