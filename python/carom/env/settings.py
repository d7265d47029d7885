"""The settings of an environment: their types, their meaning, and the checks before Rust."""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Literal, TypedDict

from carom.arguments import instance, number, numbers, text, thread_count, truth, whole
from carom.build import Physics, Table
from carom.deprecated import renamed_keys
from carom.env.opponents import kind_of, program_of, seated
from carom.errors import InputError
from carom.noise import Noise
from carom.player import Player
from carom.player.situation import Chooser
from carom.player.thinking import seconds

if TYPE_CHECKING:
    from gymnasium.vector import AutoresetMode

#: A check of a setting, from its name and value to the value for Rust.
Check = Callable[[str, Any], Any]

# The largest count that Rust accepts.
_LARGEST = 2**31 - 1

#: Settings that were renamed: old names and new ones.
_RENAMED = {"target": "points"}


@dataclass(frozen=True, slots=True)
class Rewards:
    """The reward of a shot, from the view of the player who shoots.

    Attributes:
        win: For winning the frame; its negative for losing it.
        pot: For each ball potted by a legal shot, if the shooter was allowed to pot it.
        foul: For a foul.
        point: For each point by which the shot improves the shooter's lead.
        failure: For a shot that cannot be simulated, or whose simulation reaches its event cap.

    Raises:
        InputError: A number is missing or not finite.
    """

    win: float = 0.0
    pot: float = 0.0
    foul: float = 0.0
    point: float = 0.0
    failure: float = -1.0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = number(f"rewards.{field.name}", getattr(self, field.name))
            if not math.isfinite(value):
                raise InputError(
                    "out-of-range",
                    f"rewards.{field.name}",
                    f"{value!r} is not finite",
                    "write a number",
                )
            object.__setattr__(self, field.name, value)


_Table = Table | str | Mapping[str, Any]
_Physics = Physics | str | Mapping[str, Any]


class MatchSettings(TypedDict, total=False):
    """Settings of all environments. Each is a keyword of its own and may be left out.

    Rust has the defaults (``Config::of`` in carom-env).
    """

    noise: Noise | None
    """Execution noise of every strike, the opponent's too, unless it is a level of strength. None
    means no noise."""
    aim: Literal["absolute", "relative"]
    """With ``absolute`` the first action is the cue's direction, −1 to 1 for −π to π. With
    ``relative`` it is the point where the cue ball meets the nearest ball on, from that ball's
    right edge (−1) to its left edge (1). The default is ``"absolute"``."""
    speed: tuple[float, float]
    """Least and largest speed of the cue, m/s. The default is ``(0.2, 8.0)``."""
    max_elevation: float
    """Largest elevation of the cue, rad. The default elevation of a strike is the least, also where
    it is larger than this. The default is ``0.5``."""
    balls: int | tuple[int, int] | None
    """Number of object balls that are placed at random at the start, or the least and the most. In
    potting None is 1. In the games None is a rack; otherwise the game begins in the middle, with
    equal scores. In snooker these are the reds, and the colours are on their spots; carom games
    have all of theirs; sum-to-three always begins in the same way."""
    target_ball: Literal["any", "lowest"]
    """In potting, the ball to pot. The default is ``"any"``."""
    table: _Table | Sequence[_Table | None] | None
    """As in a shot. A list gives every environment of a vector its own. None means the task's
    own."""
    physics: _Physics | Sequence[_Physics | None] | None
    """As in a shot. A list gives every environment of a vector its own. None means the table's
    own."""
    randomize: Mapping[str, Any] | None
    """Numbers that every episode draws from its seed. The keys are those of the physics, such as
    ``cloth.rolling_friction``, or of the table, such as ``table.cushion_height``; each has a law.
    ``(low, high)`` is uniform; ``{"log_uniform": (low, high)}``, ``{"normal": (mean, deviation)}``
    and ``{"choice": numbers}`` are the others. A draw with which no table or physics can exist is
    repeated. ``info["randomized"]`` reports them. None: nothing is drawn."""
    points: int | None
    """Points that win. None means the game's ``usual_points`` (``carom.game_facts()``), in
    sum-to-three 10."""
    patience: int
    """Number of shots without progress after which the frame is a stalemate. The default is
    ``100``."""
    rewards: Rewards | None
    """The rewards of a shot. None means the task's own."""
    max_episode_steps: int | None
    """Steps after which an episode is truncated. None means no limit."""
    traces: bool
    """Whether ``info["traces"]`` has the traces of a step's shots. They are simulated for it once
    more. The default is ``False``."""
    threads: int | None
    """Number of threads. Results do not depend on it. None means one per core; a single environment
    has one by default."""


class Settings(MatchSettings, total=False):
    """Settings of environments with one agent: those of :class:`MatchSettings`, and these."""

    opponent: str | Callable[[Any], Any] | type | Chooser | Player
    """The second player. It is ``none``, ``random``, ``potter``, or in a game a built-in player
    (``carom.players()`` lists them), such as ``level-2``. Settings and a number of simulated shots
    for each decision may follow, as in ``carom[shift=false]:500``; a player that is not a level has
    200 without a number. A level strikes with its own noise. Or an opponent of one's own: a
    function from observations, shape (k, size), to actions, shape (k, action size), or an object
    with ``choose(situation)`` (``carom.Situation``), or a class that makes one. It returns a
    ``carom.Play``, a ``carom.Decision``, the name of a choice, ``"concede"``, or plain values that
    follow ``frame.answer_schema()``. ``FILE.py:CLASS`` names such a class, and ``exec:COMMAND`` an
    external program, as for ``carom.play_match``. The default is ``"none"``."""
    clock: float | None
    """Seconds that an external program has in an episode. If it uses them up, it loses. Other
    opponents have no clock. None means 600 s."""
    seat: int | Literal["random", "alternate"]
    """The agent's seat, if it has an opponent. It is 0 (it begins), 1, ``random`` (drawn for every
    episode) or ``alternate`` (0 in the first episode of a seed, then 1, and so on).
    The default is ``0``."""


class VectorSettings(Settings, total=False):
    """Settings of vectors: those of :class:`Settings`, and this one."""

    autoreset_mode: Literal["same-step", "next-step", "disabled"] | AutoresetMode
    """When the next episode begins. It is ``same-step``, ``next-step`` or ``disabled`` (then
    ``reset(options={"reset_mask": ...})`` begins it), or Gymnasium's ``AutoresetMode``.
    The default is ``"same-step"``."""


def known(given: Mapping[str, Any]) -> dict[str, Any]:
    """The settings under their present names. ``target`` is the old name of ``points``.

    An opponent that a file or a class has becomes an object.

    Raises:
        InputError: There is no such setting, or no such opponent.
    """
    own = renamed_keys("settings", given, _RENAMED)
    for name in own:
        if name not in _CHECKS:
            raise _no_such(name)
    if "opponent" in own:
        own["opponent"] = seated(own["opponent"])
    return own


def checked(own: Mapping[str, Any]) -> dict[str, Any]:
    """The settings as Rust reads them. Those that are not given are missing: Rust has the defaults.

    ``table`` and ``physics`` become ``setups``, a list of pairs; an opponent in Python becomes
    ``outside``, its kind; an external program becomes ``program``.

    Raises:
        InputError: A setting has a wrong type. Rust checks the ranges.
    """
    found = {name: _CHECKS[name](name, value) for name, value in own.items()}
    found["setups"] = _setups(found.pop("table", None), found.pop("physics", None))
    opponent = found.get("opponent")
    if (program := program_of(opponent)) is not None:
        del found["opponent"]
        found["program"] = program
    elif found.get("clock") is not None:
        raise InputError(
            "conflict", "clock", "it is that of a program", 'leave it out, or give "exec:COMMAND"'
        )
    elif "opponent" in found and (kind := kind_of(opponent)) is not None:
        del found["opponent"]
        found["outside"] = kind
    return {name: value for name, value in found.items() if value is not None}


def _or_none(check: Check) -> Check:
    return lambda name, value: None if value is None else check(name, value)


def _count(name: str, value: Any) -> int:
    return whole(name, value, _LARGEST + 1)


def _as_given(_name: str, value: Any) -> Any:
    return value


def _rewards(name: str, value: Any) -> Rewards:
    if not isinstance(value, Rewards):
        raise InputError(
            "wrong-type",
            name,
            f"found a {type(value).__name__}",
            "give carom.env.Rewards(...), for example carom.env.Rewards(win=1.0)",
        )
    return value


def _seat(name: str, value: Any) -> str:
    return value if isinstance(value, str) else str(whole(name, value, 2))


def _counts(name: str, value: int | Sequence[int]) -> tuple[int, int]:
    try:
        low, high = value  # type: ignore[misc]
    except TypeError:
        low = high = value
    except ValueError:
        raise InputError(
            "wrong-count",
            name,
            f"{value!r} is not one number or two",
            "write a whole number or (least, most)",
        ) from None
    return _count(name, low), _count(name, high)


def _laws(name: str, value: Any) -> dict[str, Any]:
    if not isinstance(value, Mapping):
        raise InputError(
            "wrong-type",
            name,
            f"found a {type(value).__name__}",
            "give keys of the physics with laws, such as "
            '{"cloth.rolling_friction": (0.008, 0.012)}',
        )
    return dict(value)


#: The check of every setting, which returns the value for Rust.
_CHECKS: dict[str, Check] = {
    "noise": _or_none(
        lambda name, value: instance(name, value, Noise, "carom.Noise.olympiad(1.0)")
    ),
    "aim": lambda name, value: text(name, value, '"absolute"'),
    "speed": lambda name, value: numbers(name, value, 2),
    "max_elevation": number,
    "balls": _or_none(_counts),
    "target_ball": lambda name, value: text(name, value, '"any"'),
    "table": _as_given,
    "physics": _as_given,
    "randomize": _or_none(_laws),
    "points": _or_none(_count),
    "patience": _count,
    "rewards": _or_none(_rewards),
    "max_episode_steps": _or_none(_count),
    "traces": truth,
    "threads": lambda _, value: thread_count(value) or None,
    "opponent": _as_given,
    "clock": _or_none(seconds),
    "seat": _seat,
    "autoreset_mode": lambda name, value: text(name, value, '"same-step"'),
}


def _setups(table: Any, physics: Any) -> list[tuple[Any, Any]]:
    """Pairs of a table and its physics: one, or one for each environment."""
    tables, all_physics = _each(table, Table), _each(physics, Physics)
    count = max(len(tables), len(all_physics))
    if 1 < min(len(tables), len(all_physics)) < count:
        raise InputError(
            "wrong-count",
            "physics",
            f"there are {len(all_physics)} for {len(tables)} tables",
            "give one for each",
        )
    return [
        (tables[index % len(tables)], all_physics[index % len(all_physics)])
        for index in range(count)
    ]


def _each(value: Any, kind: type[Table] | type[Physics]) -> list[Any]:
    """The values of a setting that may have one for each environment, as plain descriptions."""
    values = list(value) if isinstance(value, list | tuple) else [value]
    return [one.description if isinstance(one, kind) else one for one in values] or [None]


def _no_such(name: str) -> InputError:
    names = [*_CHECKS, "render_mode"]
    near = difflib.get_close_matches(name, names, 1)
    meant = f'did you mean "{near[0]}"? ' if near else ""
    remedy = f"{meant}(known: {', '.join(names)})"
    return InputError("unknown-name", name, "there is no such setting", remedy, {"name": name})
