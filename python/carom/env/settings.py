"""The settings of an environment, checked and ready for Rust."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

from carom.arguments import instance, number, numbers, text, thread_count, truth, whole
from carom.build import Physics, Table
from carom.deprecated import renamed_keys
from carom.env.opponents import kind_of
from carom.errors import InputError
from carom.noise import Noise

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


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """The settings as Rust reads them, by attribute; see :func:`settings` for their meaning.

    Attributes:
        noise: Noise of every strike but those of a level; all zeros mean no noise.
        aim: As given.
        speed: Least and largest speed of the cue, m/s.
        max_elevation: rad.
        opponent: The name; ``none`` for an opponent in Python.
        outside: ``policy`` or ``player`` for an opponent in Python, else None.
        opponent_given: As given.
        seat: As given, as a text.
        balls: Least and most object balls, or None.
        target_ball: As given.
        setups: Tables with their physics, plain descriptions, names or None: one, or one for each
            environment.
        randomize: As given.
        points: As given.
        patience: As given.
        rewards: As given.
        max_episode_steps: As given.
        autoreset_mode: As given.
        traces: As given.
        threads: Number of threads; None means one per core.
    """

    noise: Noise
    aim: str
    speed: tuple[float, ...]
    max_elevation: float
    opponent: str
    outside: str | None
    opponent_given: Any
    seat: str
    balls: tuple[int, int] | None
    target_ball: str
    setups: list[tuple[Any, Any]]
    randomize: dict[str, Any] | None
    points: int | None
    patience: int
    rewards: Rewards | None
    max_episode_steps: int | None
    autoreset_mode: str
    traces: bool
    threads: int | None

    @property
    def has_opponent(self) -> bool:
        """Whether the agent has one seat, and not both."""
        return self.outside is not None or self.opponent != "none"


def settings(**given: Any) -> Settings:
    """Check the settings of an environment.

    Args:
        given: The settings below, by name. ``target`` is the old name of ``points``.

    The settings:

    - ``noise``: Execution noise of every strike, the opponent's too, unless it is a level of
      strength; None means no noise.
    - ``aim``: ``absolute``: the first action is the cue's direction, −1 to 1 for −π to π.
      ``relative``: the first action is the point where the cue ball meets the nearest ball on,
      from that ball's right edge (−1) to its left edge (1).
    - ``speed``: Least and largest speed of the cue, m/s.
    - ``max_elevation``: Largest elevation of the cue, rad. The default elevation of a strike is
      the least, also where it is larger than this.
    - ``opponent``: The second player: ``none``, ``random``, ``potter``, or in a game a built-in
      player (``carom.players()`` lists them), such as ``level-2``. Settings and a number of
      simulated shots for each decision may follow, as in ``carom[shift=false]:500``; a player that
      is not a level has 200 without a number. A level strikes with its own noise. Or an opponent
      of one's own: a function from observations, shape (k, size), to actions, shape (k, action
      size), or an object with ``choose(situation)`` (``carom.Situation``), which returns a
      ``carom.Play``, a ``carom.Decision``, the name of a choice, or ``"concede"``.
    - ``seat``: The agent's seat, if it has an opponent: 0 (it begins), 1, ``random`` (drawn for
      every episode) or ``alternate`` (0 in the first episode of a seed, then 1, and so on).
    - ``balls``: Number of object balls that are placed at random at the start, or the least and
      the most. In potting None means 1. In the games None means a rack; otherwise the game begins
      in the middle, with equal scores. In snooker these are the reds, and the colours are on their
      spots; carom games have all of theirs; sum-to-three ignores it.
    - ``target_ball``: In potting, the ball to pot: ``any`` or ``lowest``.
    - ``table``: As in a shot; None means the task's own. A list gives every environment of a
      vector its own.
    - ``physics``: As in a shot; None means the table's own. Likewise.
    - ``randomize``: Numbers that every episode draws from its seed: keys of the physics, such as
      ``cloth.rolling_friction``, or of the table, such as ``table.cushion_height``, with a law.
      ``(low, high)`` is uniform; ``{"log_uniform": (low, high)}``, ``{"normal": (mean,
      deviation)}`` and ``{"choice": numbers}`` are the others. A draw with which no table or
      physics can exist is repeated. ``info["randomized"]`` reports them.
    - ``points``: Points that win; None means the game's ``usual_points``
      (``carom.game_facts()``), in sum-to-three 10.
    - ``patience``: Number of shots without progress after which the frame is a stalemate.
    - ``rewards``: The rewards of a shot; None means the task's own.
    - ``max_episode_steps``: Steps after which an episode is truncated; None means no limit.
    - ``autoreset_mode``: ``same-step``, ``next-step`` or ``disabled``. Single environments never
      reset by themselves.
    - ``traces``: Whether ``info["traces"]`` has the traces of a step's shots. They are simulated
      for it once more.
    - ``threads``: Number of threads; None means one per core. Results do not depend on it.

    Raises:
        InputError: A setting is unknown or has a wrong type. Rust checks the ranges.
    """
    return _checked(**renamed_keys("settings", given, _RENAMED))


def _checked(
    *,
    noise: Noise | None = None,
    aim: str = "absolute",
    speed: tuple[float, float] = (0.2, 8.0),
    max_elevation: float = 0.5,
    opponent: Any = "none",
    seat: int | str = 0,
    balls: int | tuple[int, int] | None = None,
    target_ball: str = "any",
    table: Any = None,
    physics: Any = None,
    randomize: Mapping[str, Any] | None = None,
    points: int | None = None,
    patience: int = 100,
    rewards: Rewards | None = None,
    max_episode_steps: int | None = None,
    autoreset_mode: str = "same-step",
    traces: bool = False,
    threads: int | None = None,
    **unknown: Any,
) -> Settings:
    for name in unknown:
        raise _no_such(name)
    if noise is not None:
        instance("noise", noise, Noise, "carom.Noise.olympiad(1.0)")
    if rewards is not None and not isinstance(rewards, Rewards):
        raise InputError(
            "wrong-type",
            "rewards",
            f"found a {type(rewards).__name__}",
            "give carom.env.Rewards(...), for example carom.env.Rewards(win=1.0)",
        )
    outside = kind_of(opponent)
    return Settings(
        noise=noise or Noise(),
        aim=text("aim", aim, '"absolute"'),
        speed=numbers("speed", speed, 2),
        max_elevation=number("max_elevation", max_elevation),
        opponent=opponent if outside is None else "none",
        outside=outside,
        opponent_given=opponent,
        seat=seat if isinstance(seat, str) else str(whole("seat", seat, 2)),
        balls=None if balls is None else _whole_pair("balls", balls),
        target_ball=text("target_ball", target_ball, '"any"'),
        setups=_setups(table, physics),
        randomize=None if randomize is None else _laws(randomize),
        points=None if points is None else whole("points", points, _LARGEST + 1),
        patience=whole("patience", patience, _LARGEST + 1),
        rewards=rewards,
        max_episode_steps=(
            None
            if max_episode_steps is None
            else whole("max_episode_steps", max_episode_steps, _LARGEST + 1)
        ),
        autoreset_mode=text("autoreset_mode", autoreset_mode, '"same-step"'),
        traces=truth("traces", traces),
        threads=thread_count(threads) or None,
    )


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


def _laws(randomize: Mapping[str, Any]) -> dict[str, Any]:
    if not isinstance(randomize, Mapping):
        raise InputError(
            "wrong-type",
            "randomize",
            f"found a {type(randomize).__name__}",
            "give keys of the physics with laws, such as "
            '{"cloth.rolling_friction": (0.008, 0.012)}',
        )
    return dict(randomize)


def _no_such(name: str) -> InputError:
    known = [*(_checked.__kwdefaults__ or {}), "render_mode"]
    near = difflib.get_close_matches(name, known, 1)
    meant = f'did you mean "{near[0]}"? ' if near else ""
    remedy = f"{meant}(known: {', '.join(known)})"
    return InputError("unknown-name", name, "there is no such setting", remedy, {"name": name})


def _whole_pair(name: str, value: int | Sequence[int]) -> tuple[int, int]:
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
    return whole(name, low, _LARGEST + 1), whole(name, high, _LARGEST + 1)
