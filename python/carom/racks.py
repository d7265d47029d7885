"""Racks and the shots that open them."""

from __future__ import annotations

from carom.build import opening
from carom.shot import Shot


def break_shot(
    game: str = "nine-ball",
    *,
    table: str | None = None,
    speed: float | None = None,
    seed: int = 0,
    gap: float | None = None,
) -> Shot:
    """The opening shot of a game, from its rack.

    Args:
        game: ``eight-ball``, ``nine-ball``, ``ten-ball``, ``straight-pool``, ``snooker`` or
            ``three-cushion``.
        table: A preset's name; the game's own table if None.
        speed: The cue's speed, m/s; the game's usual one if None.
        seed: Seed of the rack; the same seed gives the same rack on every platform.
        gap: Mean gap between the balls, m; 0 is frozen, None is the usual 0.1 mm.

    Raises:
        InputError: There is no such game or table, or a value is out of range.
    """
    return Shot._wrap(opening(game, table=table, speed=speed, seed=seed, gap=gap))
