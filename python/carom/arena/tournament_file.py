"""The file of a tournament, ``carom-tournament/1``, read and checked."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from carom import _core
from carom.arena.fresh_errors import luck_draws
from carom.arena.same_break import read_break, recorded_break
from carom.arena.sequential import SequentialTest
from carom.errors import InputError
from carom.files import read_text, shown
from carom.noise import Noise, Perception
from carom.rules import Frame

FORMAT = "carom-tournament/1"
#: The kinds of events.
KINDS = ("match", "round-robin", "gauntlet", "swiss", "test")

#: The settings of which a list gives several conditions, in the order in which they vary.
_VARIED = (
    "game",
    "table",
    "physics",
    "noise",
    "perception",
    "simulations",
    "frame_simulations",
    "time",
    "clock",
    "same_break",
)
_CLOCKS = ("simulations", "frame_simulations", "time", "clock")
_FIXED = ("disclosure", "points", "miss", "patience", "max_events", "luck")
_SETTINGS = (*_VARIED, *_FIXED)
#: The ways to write the hypotheses of a test.
_HYPOTHESES = ("shares", "elo", "nelo")
#: The attributes of an event that have the hypotheses of a test.
BOUNDS = ("shares", "nelo")
_EVENT_KEYS = (
    "name",
    "type",
    "players",
    "against",
    "rounds",
    *_HYPOTHESES,
    "pairs",
    "block",
    *_SETTINGS,
)
# Keys that only some kinds of events have.
_KEYS_OF_KIND = {
    "against": ("gauntlet",),
    "rounds": ("swiss",),
    **dict.fromkeys(_HYPOTHESES, ("test",)),
}
# Pairs of frames of a match, unless the file has another number.
_PAIRS = 10
# Largest number of pairs of a test, unless the file has another number.
_PAIRS_OF_TEST = 1000
# Pairs of a block, unless the file has another number: some minutes of one core.
_BLOCK = 10
_MOST_PAIRS = 1_000_000
# Longest name of a player. Two of them are the name of a folder.
_LONGEST_NAME = 60


@dataclass(frozen=True, slots=True)
class TournamentPlayer:
    """A player of a tournament.

    Attributes:
        name: Its name in the tournament, which is unique.
        player: What ``play_match`` takes: a name, or an object or class of one's own.
    """

    name: str
    player: Any


@dataclass(frozen=True, slots=True)
class Condition:
    """What all matches of a table of ratings have in common.

    Attributes:
        settings: The settings that the file has, by the names of the arguments of ``play_match``.
        title: The condition in a few words.
        key: The condition as part of a path: the game, and a hash of all settings.
    """

    settings: dict[str, Any]
    title: str
    key: str

    @classmethod
    def of(cls, settings: Mapping[str, Any]) -> Condition:
        """The condition with these settings.

        Raises:
            InputError: A setting is invalid; the place is its key.
        """
        kept = {key: settings[key] for key in _SETTINGS if settings.get(key) is not None}
        kept = {"game": "eight-ball"} | kept
        resolved = kept | {key: _plain(value) for key, value in _resolved(kept).items()}
        text = json.dumps(resolved, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
        digest = hashlib.sha256(text.encode()).hexdigest()
        return cls(kept, _title(kept), f"{kept['game']}-{digest[:8]}")

    def arguments(self) -> dict[str, Any]:
        """The arguments of ``play_match``."""
        return self.settings | _resolved(self.settings)


@dataclass(frozen=True, slots=True)
class Event:
    """A part of a tournament.

    Attributes:
        name: Its name, which is unique.
        kind: ``match``, ``round-robin``, ``gauntlet``, ``swiss`` or ``test``.
        players: The names of its players. In a gauntlet they are the challengers; in a test the
            first one is the changed player, and the second one the baseline.
        against: The players that the challengers of a gauntlet meet.
        conditions: The conditions under which the event is played.
        pairs: Number of pairs of frames of a match; of a test the largest number.
        block: Number of pairs that are played as one record.
        rounds: Number of rounds of a Swiss tournament; else 0.
        shares: The shares of the points between which a test decides; else None.
        nelo: The differences of normalised Elo between which a test decides; else None.
    """

    name: str
    kind: str
    players: tuple[str, ...]
    against: tuple[str, ...]
    conditions: tuple[Condition, ...]
    pairs: int
    block: int
    rounds: int
    shares: tuple[float, float] | None
    nelo: tuple[float, float] | None

    @property
    def test(self) -> SequentialTest | None:
        """The sequential test, if the event is one."""
        if self.shares is not None:
            return SequentialTest(*self.shares)
        return None if self.nelo is None else SequentialTest(*self.nelo, "nelo")


@dataclass(frozen=True, slots=True)
class TournamentFile:
    """The content of a tournament's file.

    Attributes:
        players: The players.
        events: The events.
        secret: The secret of the whole tournament, 64 hexadecimal digits; None if every match has
            one from the operating system.
    """

    players: tuple[TournamentPlayer, ...]
    events: tuple[Event, ...]
    secret: str | None


def load(path: str | Path) -> dict[str, Any]:
    """The content of a TOML or JSON file.

    Raises:
        InputError: It is neither TOML nor JSON.
        OSError: It cannot be read.
    """
    text = read_text(path)
    if Path(path).suffix == ".toml":
        try:
            return tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            raise InputError(
                "syntax", shown(path), f"it is not TOML ({error})", "correct it there"
            ) from None
    found: dict[str, Any] = _core.read_json(text, shown(path))
    return found


def read(file: Mapping[str, Any]) -> TournamentFile:
    """Read and check a tournament.

    Raises:
        InputError: A value is missing, unknown or invalid; the message names its place.
    """
    if not isinstance(file, Mapping):
        _core.wrong_type(file, "the tournament", "an object {...}")
    if file.get("format") != FORMAT:
        _core.wrong_type(file.get("format"), "format", f'"{FORMAT}"')
    _core.check_keys(dict.fromkeys(file), "", ("format", "secret", "players", "events"))
    players = _players(file.get("players"))
    names = tuple(player.name for player in players)
    written = file.get("events")
    if not isinstance(written, Sequence) or isinstance(written, str) or not written:
        _core.wrong_type(written, "events", "a list of events")
    events = tuple(_event(f"events[{i}]", event, names) for i, event in enumerate(written))
    _check_unique([(f"events[{i}].name", event.name) for i, event in enumerate(events)])
    return TournamentFile(players, events, _secret(file.get("secret")))


def _secret(value: Any) -> str | None:
    if value is not None and not (
        isinstance(value, str) and re.fullmatch(r"[0-9a-fA-F]{64}", value)
    ):
        raise InputError(
            "syntax",
            "secret",
            "it does not have 64 hexadecimal digits",
            "correct it, or leave it out for secrets of the operating system",
        )
    return value


def _players(written: Any) -> tuple[TournamentPlayer, ...]:
    if not isinstance(written, Sequence) or isinstance(written, str):
        _core.wrong_type(written, "players", "a list of players")
    if len(written) < 2:
        raise InputError("wrong-count", "players", "there are fewer than two", "write two or more")
    players = tuple(_player(f"players[{i}]", value) for i, value in enumerate(written))
    _check_unique([(f"players[{i}]", player.name) for i, player in enumerate(players)])
    return players


def _player(place: str, value: Any) -> TournamentPlayer:
    name, player = value, value
    if isinstance(value, Mapping):
        _core.check_keys(dict.fromkeys(value), place, ("name", "player"))
        player = value.get("player")
        name = value.get("name", player)
        if player is None:
            raise InputError("missing", f"{place}.player", "it is missing", _PLAYER)
    if not isinstance(name, str):
        name = getattr(player, "name", None)
        name = name if isinstance(name, str) else getattr(player, "__name__", type(player).__name__)
    if not 0 < len(name) <= _LONGEST_NAME or not name.isprintable():
        raise InputError(
            "syntax",
            f"{place}.name",
            f"{name!r} is not a name of a player",
            f"write a name of 1 to {_LONGEST_NAME} printable characters",
        )
    return TournamentPlayer(name, player)


_PLAYER = 'write a player, such as "carom:200" or "mine.py:Mine"'


def _check_unique(named: Sequence[tuple[str, str]]) -> None:
    seen: set[str] = set()
    for place, name in named:
        if name in seen:
            raise InputError("duplicate", place, f"{name!r} occurs twice", "give it another name")
        seen.add(name)


def _event(place: str, written: Any, names: tuple[str, ...]) -> Event:
    _core.check_keys(written, place, _EVENT_KEYS)
    name = written.get("name")
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]{0,39}", name):
        _core.wrong_type(
            name, f"{place}.name", "up to 40 letters, digits and . _ - (it names a folder)"
        )
    kind = written.get("type")
    if kind not in KINDS:
        if not isinstance(kind, str):
            _core.wrong_type(kind, f"{place}.type", "a text")
        _core.unknown_word(kind, f"{place}.type", "type of event", KINDS)
    for key, kinds in _KEYS_OF_KIND.items():
        if key in written and kind not in kinds:
            raise InputError(
                "conflict", f"{place}.{key}", f"a {kind} has none", f"it belongs to a {kinds[0]}"
            )
    players = _named(f"{place}.players", written.get("players"), names)
    against: tuple[str, ...] = ()
    if kind == "gauntlet":
        against = _opponents(place, written, players, names)
    else:
        players = players or names
    _check_count(place, kind, players)
    usual = _PAIRS_OF_TEST if kind == "test" else _PAIRS
    pairs = _core.read_whole(written.get("pairs", usual), f"{place}.pairs", 1, _MOST_PAIRS)
    block = _core.read_whole(written.get("block", _BLOCK), f"{place}.block", 1, _MOST_PAIRS)
    rounds = 0
    if kind == "swiss":
        usual = math.ceil(math.log2(len(players)))
        rounds = _core.read_whole(
            written.get("rounds", usual), f"{place}.rounds", 1, len(players) - 1
        )
    bounds = _bounds(place, written) if kind == "test" else {}
    return Event(
        name,
        kind,
        players,
        against,
        _conditions(place, written),
        pairs,
        block,
        rounds,
        bounds.get("shares"),
        bounds.get("nelo"),
    )


def _named(place: str, written: Any, names: tuple[str, ...]) -> tuple[str, ...]:
    """The names of players in a list; none if there is no list."""
    if written is None:
        return ()
    if not isinstance(written, Sequence) or isinstance(written, str):
        _core.wrong_type(written, place, "a list of names of players")
    for i, name in enumerate(written):
        if not isinstance(name, str):
            _core.wrong_type(name, f"{place}[{i}]", "the name of a player")
        if name not in names:
            _core.unknown_word(name, f"{place}[{i}]", "player of the tournament", names)
    _check_unique([(f"{place}[{i}]", name) for i, name in enumerate(written)])
    return tuple(written)


def _opponents(
    place: str, written: Mapping[str, Any], players: tuple[str, ...], names: tuple[str, ...]
) -> tuple[str, ...]:
    """Whom the challengers of a gauntlet meet."""
    if not players:
        raise InputError(
            "missing", f"{place}.players", "a gauntlet has challengers", "write their names"
        )
    others = tuple(name for name in names if name not in players)
    against = _named(f"{place}.against", written.get("against"), names) or others
    for name in against:
        if name in players:
            raise InputError(
                "conflict",
                f"{place}.against",
                f"{name!r} is a challenger",
                "remove it from one of the lists",
            )
    if not against:
        raise InputError(
            "wrong-count", f"{place}.players", "no opponent is left", "leave out a challenger"
        )
    return against


def _check_count(place: str, kind: str, players: tuple[str, ...]) -> None:
    if kind in ("match", "test") and len(players) != 2:
        raise InputError(
            "wrong-count",
            f"{place}.players",
            f"a {kind} has two players, and here are {len(players)}",
            "write two names",
        )
    if kind in ("round-robin", "swiss") and len(players) < 2:
        raise InputError(
            "wrong-count", f"{place}.players", "there are fewer than two", "write two or more"
        )


def _bounds(place: str, written: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    """The two hypotheses of a test, as shares of the points or as normalised Elo."""
    given = [key for key in _HYPOTHESES if key in written]
    if len(given) != 1:
        raise InputError(
            "missing" if not given else "conflict",
            f"{place}.shares",
            "a test has two hypotheses, written in one way",
            f"write one of {', '.join(_HYPOTHESES)}, such as shares = [0.5, 0.55]",
        )
    key = given[0]
    value = written[key]
    if not isinstance(value, Sequence) or isinstance(value, str) or len(value) != 2:
        _core.wrong_type(value, f"{place}.{key}", "a list of two numbers")
    low, high = (_core.read_number(x, f"{place}.{key}[{i}]") for i, x in enumerate(value))
    try:
        test = SequentialTest.of_elo(low, high) if key == "elo" else SequentialTest(low, high, key)
    except InputError:
        raise InputError(
            "out-of-range",
            f"{place}.{key}",
            f"{value[0]!r} and {value[1]!r} are not two hypotheses, the smaller first",
            "write such as shares = [0.5, 0.55], elo = [0, 20] or nelo = [0, 30]",
        ) from None
    return {test.unit: (test.p0, test.p1)}


def _conditions(place: str, written: Mapping[str, Any]) -> tuple[Condition, ...]:
    """The product of all lists of settings."""
    given = {key: written[key] for key in _SETTINGS if written.get(key) is not None}
    clocks = [key for key in _CLOCKS if key in given]
    if len(clocks) > 1:
        raise InputError(
            "duplicate", f"{place}.{clocks[1]}", f"{clocks[0]} is given too", "keep one of them"
        )
    lists: list[list[tuple[str, Any]]] = []
    for key, value in given.items():
        several = key in _VARIED and isinstance(value, Sequence) and not isinstance(value, str)
        if several and not value:
            raise InputError(
                "wrong-count", f"{place}.{key}", "the list is empty", "write at least one value"
            )
        items = value if several else [value]
        where = (
            [f"{place}.{key}[{i}]" for i in range(len(items))] if several else [f"{place}.{key}"]
        )
        for at, item in zip(where, items, strict=True):
            _check_setting(at, key, item)
        lists.append([(key, item) for item in items])
    found: dict[str, Condition] = {}
    for settings in itertools.product(*lists):
        try:
            condition = Condition.of(dict(settings))
        except InputError as error:
            raise error.inside(place) from None
        found[condition.key] = condition
    return tuple(found.values())


def _check_setting(place: str, key: str, value: Any) -> None:
    """Reject a setting of a wrong type or out of range, at its place."""
    if key in ("simulations", "frame_simulations", "points", "patience", "max_events"):
        _core.read_whole(value, place, 1, (1 << 31) - 1)
    elif key in ("time", "clock"):
        if _core.read_number(value, place) <= 0:
            raise InputError("out-of-range", place, f"{value!r} is not a time", "write seconds > 0")
    elif key == "perception":
        _core.read_number(value, place)
    elif key == "luck":
        luck_draws(value, place)
    elif key == "miss":
        if not isinstance(value, bool):
            _core.wrong_type(value, place, "true or false")
    elif key == "disclosure":
        known = ("both", "own", "nothing")
        if value not in known:
            _core.unknown_word(str(value), place, "disclosure", known)
    elif key == "same_break":
        if not isinstance(value, str | Mapping):
            _core.wrong_type(value, place, "the name of a break preset, or a play")
    elif key == "game" and not isinstance(value, str):
        _core.wrong_type(value, place, "the name of a game")


def _resolved(settings: Mapping[str, Any]) -> dict[str, Any]:
    """The settings that are objects of carom.

    Raises:
        InputError: A setting is invalid; the place is its key.
    """
    found: dict[str, Any] = {}
    rules = {key: settings[key] for key in ("points", "miss", "patience") if key in settings}
    setup = {key: settings[key] for key in ("table", "physics") if key in settings}
    # A frame checks what belongs to the game.
    Frame(settings["game"], **setup, **rules)
    noise = settings.get("noise")
    if noise is not None:
        found["noise"] = Noise.preset(noise) if isinstance(noise, str) else Noise.from_dict(noise)
    if "same_break" in settings:
        game, table = settings["game"], settings.get("table")
        found["same_break"] = read_break(settings["same_break"], game, table)
        recorded_break(found["same_break"], game, table, settings.get("physics"))
    if "perception" in settings:
        found["perception"] = Perception(settings["perception"])
    return found


def _plain(value: Any) -> Any:
    """An object of carom as plain values."""
    return value.to_dict()


def _title(settings: Mapping[str, Any]) -> str:
    """The condition in a few words: the game first, then what differs from the defaults."""
    units = {
        "simulations": "simulations a decision",
        "frame_simulations": "simulations a frame",
        "time": "s a decision",
        "clock": "s a frame",
    }
    words = [str(settings["game"])]
    for key, value in settings.items():
        if key == "game":
            continue
        if key in units:
            words.append(f"{value:g} {units[key]}")
        elif key == "same_break" and isinstance(value, str):
            words.append(f"break {value}")
        elif key == "noise" and isinstance(value, str):
            words.append(f"noise {value}")
        elif isinstance(value, Mapping):
            digest = hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()
            words.append(f"{key} {digest[:8]}")
        else:
            words.append(f"{key} {value}")
    return ", ".join(words)
