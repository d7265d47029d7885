"""What an environment is asked to be, from Python's side to Rust's."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, fields
from typing import Any

from carom.arguments import instance, number, numbers, thread_count, whole
from carom.build import Physics, Table
from carom.errors import InputError
from carom.noise import Noise

# The largest count that Rust takes.
_LARGEST = 2**31 - 1


@dataclass(frozen=True, slots=True)
class Rewards:
    """What a shot earns, from the view of the player who shoots.

    Attributes:
        win: The frame won; lost, its negative.
        pot: Each ball potted by a legal shot that was the shooter's to pot.
        foul: A foul.
        point: Each point more than the other player gets by the shot.
        failure: A shot that cannot be played, or whose simulation reaches its cap on events.
    """

    win: float = 0.0
    pot: float = 0.0
    foul: float = 0.0
    point: float = 0.0
    failure: float = -1.0


def pack(
    *,
    noise: Noise | None = None,
    aim: str = "absolute",
    speed: tuple[float, float] = (0.2, 8.0),
    max_elevation: float = 0.5,
    opponent: str = "none",
    balls: int | tuple[int, int] | None = None,
    target_ball: str = "any",
    table: Table | str | Mapping[str, Any] | None = None,
    physics: Physics | str | Mapping[str, Any] | None = None,
    target: int | None = None,
    patience: int = 100,
    rewards: Rewards | None = None,
    max_episode_steps: int | None = None,
    autoreset_mode: str = "same-step",
    threads: int | None = None,
    **unknown: Any,
) -> dict[str, Any]:
    """The settings of an environment as Rust takes them.

    Args:
        noise: Errors of every strike, the opponent's too; none if None.
        aim: ``absolute``: the first action is the cue's direction, −1 to 1 for −π to π.
            ``relative``: where the nearest ball on is hit, from its right edge (−1) to its left
            edge (1).
        speed: The least and the largest speed of the cue, m/s.
        max_elevation: The largest elevation of the cue, rad; the action's lower half is level.
        opponent: ``none``, ``random`` or ``potter``: who plays player 1.
        balls: Object balls that lie at random at the start, a number, or least and most. In
            potting 1 if None; the games begin with a rack if None, else in the middle, nobody
            ahead. In snooker these are the reds, and the colours stand on their spots;
            three-cushion has 2; sum-to-three always begins in its own way.
        target_ball: In potting, ``any`` or ``lowest``.
        table: As in a shot; the task's own if None.
        physics: As in a shot; the table's own if None.
        target: Points that win straight pool (100 if None), three-cushion (40) and sum-to-three
            (10).
        patience: Shots without progress that make a stalemate.
        rewards: What a shot earns; the task's usual ones if None.
        max_episode_steps: Steps after which an episode is truncated; no limit if None.
        autoreset_mode: ``same-step``, ``next-step`` or ``disabled``; single environments never
            reset by themselves.
        threads: How many step; all cores if None. Results do not depend on it.
        unknown: Refused.

    Raises:
        InputError: There is no such setting, or a value has a wrong type. What is out of range,
            Rust refuses.
    """
    for name in unknown:
        raise InputError(_no_such(name))
    if isinstance(table, Table):
        table = table.description
    if isinstance(physics, Physics):
        physics = physics.description
    if noise is not None:
        instance("noise", noise, Noise, "carom.Noise.olympiad(1.0)")
    if rewards is not None and not isinstance(rewards, Rewards):
        raise InputError(
            f"rewards: found a {type(rewards).__name__}; give carom.env.Rewards(...), "
            "for example carom.env.Rewards(win=1.0)"
        )
    return {
        "noise": astuple(noise or Noise()),
        "aim": str(aim),
        "speed": numbers("speed", speed, 2),
        "elevation": number("max_elevation", max_elevation),
        "opponent": str(opponent),
        "balls": None if balls is None else _whole_pair("balls", balls),
        "target_ball": str(target_ball),
        "table": table,
        "physics": physics,
        "target": None if target is None else whole("target", target, _LARGEST + 1),
        "patience": whole("patience", patience, _LARGEST + 1),
        "rewards": None if rewards is None else _finite(rewards),
        "max_steps": (
            None
            if max_episode_steps is None
            else whole("max_episode_steps", max_episode_steps, _LARGEST + 1)
        ),
        "autoreset": str(autoreset_mode),
        "threads": thread_count(threads) or None,
    }


def _no_such(name: str) -> str:
    known = [*(pack.__kwdefaults__ or {}), "render_mode"]
    near = difflib.get_close_matches(name, known, 1)
    meant = f'did you mean "{near[0]}"? ' if near else ""
    return f"{name}: there is no such setting; {meant}(known: {', '.join(known)})"


def _whole_pair(name: str, value: int | Sequence[int]) -> tuple[int, int]:
    try:
        low, high = value  # type: ignore[misc]
    except TypeError:
        low = high = value
    except ValueError:
        raise InputError(
            f"{name}: {value!r} is not a count, nor two; write whole numbers"
        ) from None
    return whole(name, low, _LARGEST + 1), whole(name, high, _LARGEST + 1)


def _finite(rewards: Rewards) -> tuple[float, ...]:
    values = numbers("rewards", astuple(rewards), len(fields(rewards)))
    if not all(math.isfinite(value) for value in values):
        raise InputError(f"rewards: {values!r} are not all finite; write numbers")
    return values
