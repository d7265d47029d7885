"""A player in scripted situations of every kind, for its author."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Any, Self

from carom import _core, columns
from carom.arena.contestants import Asking, contestant
from carom.noise import Perception, noise_or_default
from carom.player import Player
from carom.player.situation import Chooser
from carom.player.thinking import seconds
from carom.progress import stage_bars

# The player's clock in a situation, s.
CLOCK = 60.0

_MARKS = {True: "passed", False: "FAILED", None: "not asked"}


@dataclass(frozen=True, slots=True)
class CheckVerdict:
    """What a player did in a situation.

    Attributes:
        situation: The situation.
        game: The game.
        passed: Whether its answer is one that the referee takes; None if it was not asked.
        answer: Its answer, as a program writes it; None if it gave none.
        kind: The kind of the error if it failed, as in ``carom.InputError``; else None.
        place: Where the fault is, such as ``strike.speed``; None if there is none.
        fault: What is wrong; or why the player was not asked.
        remedy: What to do.
        seconds: The time of its answers, s.
    """

    situation: str
    game: str
    passed: bool | None
    answer: dict[str, Any] | None
    kind: str | None
    place: str | None
    fault: str | None
    remedy: str | None
    seconds: float

    @classmethod
    def _read(cls, fields: dict[str, Any]) -> Self:
        """The verdict from its values in Rust."""
        kind, place, fault, remedy = fields.pop("fault") or (None,) * 4
        if fields["passed"] is None:
            kind = place = remedy = None
        return cls(**fields, kind=kind, place=place, fault=fault, remedy=remedy)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {name: getattr(self, name) for name in self.__slots__}

    def _story(self) -> str:
        parts = [self.fault or "", self.remedy or ""]
        place = f"{self.place}: " if self.place else ""
        return place + "; ".join(filter(None, parts))


@dataclass(frozen=True, slots=True)
class CheckReport:
    """The verdicts on a player; ``print`` it for a table.

    Attributes:
        player: The player's name.
        verdicts: One for each situation.
        log: The tracebacks of the exceptions of a player in Python.
    """

    player: str
    verdicts: tuple[CheckVerdict, ...]
    log: str

    @property
    def passed(self) -> bool:
        """Whether the player failed in no situation."""
        return not any(self.failures())

    def failures(self) -> Iterator[CheckVerdict]:
        """The verdicts on the situations in which the player failed."""
        return (verdict for verdict in self.verdicts if verdict.passed is False)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "player": self.player,
            "passed": self.passed,
            "verdicts": [verdict.to_dict() for verdict in self.verdicts],
        }

    def __str__(self) -> str:
        rows = [
            (_MARKS[verdict.passed], verdict.situation, verdict.game, verdict._story())
            for verdict in self.verdicts
        ]
        asked = [verdict for verdict in self.verdicts if verdict.passed is not None]
        failed = sum(verdict.passed is False for verdict in asked)
        last = f"{self.player} passed {len(asked) - failed} of {len(asked)} situations."
        return "\n".join([*columns.lines(rows), last])


def check(
    player: str | Chooser | Callable[[], Chooser] | Player,
    *,
    clock: float = CLOCK,
    progress: bool = False,
) -> CheckReport:
    """Ask a player in situations of every kind, and judge its answers.

    The situations are the openings of all games, balls in hand, choices, calls, a free ball, a
    refusal, a short clock, a menu, and more. The player is made again for each of them. An answer
    passes if the referee takes it; whether it is strong does not matter.

    Args:
        player: The player, as for ``carom.play_match``.
        clock: Its clock in each situation, s. Built-in players count simulated shots instead.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such player, or the clock is out of range.
    """
    found = contestant("player", player)
    log: list[str] = []
    asking = Asking(log.append, strict=False)
    is_asked = found.make is not None
    noise = noise_or_default(None)
    entrant: Any = found.name
    if found.program is not None:
        entrant = asking.program(found, ())
    elif is_asked:
        entrant = (found.name, found.kind, asking.beginning(found, (noise, noise), Perception()))
    with (
        stage_bars(["situations"], show=progress) as report,
        asking.watching() if is_asked else nullcontext(),
    ):
        fields = _core.check_player(entrant, seconds("clock", clock), report)
    return CheckReport(found.name, tuple(map(CheckVerdict._read, fields)), "".join(log))
