"""A match as it is agreed: the players and the settings, without a folder."""

from __future__ import annotations

import pickle
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Self, TypeVar

from carom import _core
from carom.arena.contestants import Asking, Contestant, contestant
from carom.arena.fresh_errors import luck_settings
from carom.arena.player_files import FILES, load_file
from carom.arena.same_break import recorded_break
from carom.arena.sequential import SequentialTest
from carom.arguments import text, truth, whole
from carom.build import Physics, Table
from carom.errors import InputError
from carom.noise import Noise, Perception, noise_or_default, perception_or_none
from carom.player import Play, Player
from carom.player.situation import Chooser
from carom.player.thinking import seconds
from carom.reference import DEFAULT_OPTIONS

T = TypeVar("T")

# Thinking time of a frame and player, s: that of the Computational Olympiad.
_OLYMPIAD = 600.0


class MatchPlan:
    """A match to play: its players and its settings.

    A plan can be pickled if its players can. So its pairs may be played in other processes and on
    other machines: ``carom.arena.OpenMatch`` gives out their numbers, and
    ``carom.arena.play_pair`` plays one.

    Args:
        one: The first player, as for ``carom.play_match``.
        other: The second player.
        game: The game. This and all other arguments are those of ``carom.play_match``.

    Attributes:
        game: The game.
        players: The two players.
        agreed: The header of the record, without what Rust adds.
        secret: The secret; None if the operating system is to draw it.
        test: The sequential test that ends the match; None without one.
        strict: Whether an exception of a player stops the match.

    Raises:
        InputError: As for ``carom.play_match``.
    """

    def __init__(
        self,
        one: str | Chooser | Callable[[], Chooser] | Player,
        other: str | Chooser | Callable[[], Chooser] | Player,
        *,
        game: str = "eight-ball",
        pairs: int = 10,
        noise: Noise | tuple[Noise, Noise] | None = None,
        perception: Perception | tuple[Perception, Perception] | None = None,
        table: Table | str | Mapping[str, Any] | None = None,
        physics: Physics | str | Mapping[str, Any] | None = None,
        simulations: int | tuple[int, int] | None = None,
        frame_simulations: int | tuple[int, int] | None = None,
        time: float | tuple[float, float] | None = None,
        clock: float | tuple[float, float] | None = None,
        breaker: str | int = "alternate",
        same_break: Play | None = None,
        disclosure: str = "both",
        test: SequentialTest | tuple[float, float] | None = None,
        secret: str | None = None,
        points: int = DEFAULT_OPTIONS.points,
        miss: bool = DEFAULT_OPTIONS.miss,
        patience: int = DEFAULT_OPTIONS.patience,
        max_events: int = 100_000,
        luck: bool | int = False,
        strict: bool = False,
    ) -> None:
        self.players = (contestant("one", one), contestant("other", other))
        budgets: dict[str, Any] = {
            "simulations": simulations,
            "frame_simulations": frame_simulations,
            "time": time,
            "clock": clock,
        }
        clocks = _clocks(self.players, budgets)
        noises = _noises(self.players, noise)
        sights = tuple(perception_or_none(each) for each in _each("perception", perception))
        self.test = SequentialTest.read(test)
        self.game = text("game", game, '"eight-ball"')
        self.agreed: dict[str, Any] = {
            "game": self.game,
            "options": {
                "points": whole("points", points, 1 << 31, low=1),
                "miss": truth("miss", miss),
                "patience": whole("patience", patience, 1 << 32, low=1),
            },
            "table": table.description if isinstance(table, Table) else table,
            "physics": physics.description if isinstance(physics, Physics) else physics,
            "max_events": whole("max_events", max_events, _core.MOST_EVENTS + 1, low=1),
            "noise": [each.to_dict() for each in noises],
            "perception": [each.to_dict() for each in sights],
            "clock": clocks,
            "breaker": breaker,
            "same_break": None
            if same_break is None
            else recorded_break(same_break, game, table, physics),
            "disclosure": text("disclosure", disclosure, '"both"'),
            "luck": luck_settings(luck),
            "test": None if self.test is None else self.test.to_dict(),
            "pairs": whole("pairs", pairs, low=1),
        }
        self.secret = None if secret is None else text("secret", secret, "64 hexadecimal digits")
        self.strict = truth("strict", strict)
        #: Files that external programs must not read.
        self.hidden: tuple[Path, ...] = ()
        self._told = [_told(player, disclosure, noises, sights) for player in (0, 1)]

    @property
    def names(self) -> tuple[str, str]:
        """The names of the players."""
        one, other = self.players
        return one.name, other.name

    @property
    def asks(self) -> bool:
        """Whether a player is one of the user's own."""
        return any(player.make is not None for player in self.players)

    def with_secret(self, secret: str) -> Self:
        """The same plan with this secret."""
        return self._with(secret=secret)

    def in_folder(self, folder: Path) -> Self:
        """The same plan, whose external programs must not read the secret in this folder."""
        return self._with(hidden=(folder.resolve() / "secret",))

    def _with(self, **changed: Any) -> Self:
        plan = object.__new__(type(self))
        plan.__dict__.update(self.__dict__, **changed)
        return plan

    def __reduce__(self) -> tuple[Any, ...]:
        # Other processes load the files of the players before the players themselves.
        return _restored, (dict(FILES), pickle.dumps(self.__dict__))

    def entrants(self, asking: Asking) -> list[Any]:
        """The players in the form that Rust reads."""

        def entrant(player: Contestant, told: tuple[Any, Any]) -> Any:
            if player.program is not None:
                return asking.program(player, self.hidden)
            if player.make is None:
                return player.name
            return player.name, player.kind, asking.beginning(player, *told)

        return list(map(entrant, self.players, self._told))


def _restored(files: Mapping[str, Path], state: bytes) -> MatchPlan:
    for name, path in files.items():
        if name not in sys.modules:
            load_file(name, path)
    plan = MatchPlan.__new__(MatchPlan)
    plan.__dict__.update(pickle.loads(state))
    return plan


def _told(
    player: int,
    disclosure: str,
    noises: Sequence[Noise],
    sights: Sequence[Perception],
) -> tuple[tuple[Noise, Noise], Perception]:
    """The errors that a player knows: of its strikes and the other's, and of its perception."""
    nothing = Noise()
    own = nothing if disclosure == "nothing" else noises[player]
    other = noises[1 - player] if disclosure == "both" else nothing
    return (own, other), Perception() if disclosure == "nothing" else sights[player]


def _each(name: str, value: T | tuple[T, T]) -> tuple[T, T]:
    """The value of each player."""
    if not isinstance(value, tuple | list):
        return value, value
    if len(value) != 2:
        raise InputError(
            "wrong-count", name, f"{len(value)} values", "give one, or one for each of two players"
        )
    return value[0], value[1]


def _noises(players: tuple[Contestant, Contestant], noise: Any) -> list[Noise]:
    """The errors of both players."""
    if noise is None:
        return [noise_or_default(player.noise) for player in players]
    return [noise_or_default(each) for each in _each("noise", noise)]


def _clocks(
    players: tuple[Contestant, Contestant], given: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """The players' clocks in the form of a record."""
    written = [name for name, value in given.items() if value is not None]
    if len(written) > 1:
        raise InputError("duplicate", written[1], f"{written[0]} is given too", "give one of them")
    name = written[0] if written else "clock"
    amounts = _each(name, given[name] if written else _OLYMPIAD)
    clocks: list[dict[str, Any]] = []
    for player, amount in zip(players, amounts, strict=True):
        if player.simulations is not None:
            clocks.append({"simulations": player.simulations, "per": "decision"})
            continue
        per = "decision" if name in ("simulations", "time") else "frame"
        if name.endswith("simulations"):
            clocks.append({"simulations": whole(name, amount, 1 << 32, low=1), "per": per})
        else:
            clocks.append({"seconds": seconds(name, amount), "per": per})
    return clocks
