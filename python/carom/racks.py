"""Racks and the shots that open them."""

from __future__ import annotations

from typing import Any

from carom import _core
from carom.build import opening
from carom.shot import Shot


def break_shot(
    game: str = "nine-ball",
    *,
    table: str | None = None,
    speed: float | None = None,
    seed: int = 0,
    gap: float | None = None,
    preset: str | None = None,
) -> Shot:
    """The opening shot of a game, from its rack.

    Args:
        game: One of ``carom.rule_sets()``, such as ``nine-ball``.
        table: A preset's name; the game's own table if None.
        speed: The cue's speed, m/s; the game's usual one if None.
        seed: Seed of the rack; the same seed gives the same rack on every platform.
        gap: Mean gap between the balls, m; 0 is frozen. None is the preset's, or the usual 0.1 mm.
        preset: How players open the game: one of ``break_presets()``, such as ``rail`` in
            nine-ball. None strikes the cue ball in the middle, from where the rack has it.

    Raises:
        InputError: There is no such game, preset or table, or a value is out of range.
    """
    shot = opening(game, table=table, speed=speed, seed=seed, gap=gap, preset=preset)
    return Shot._wrap(shot)


def break_presets() -> list[dict[str, Any]]:
    """How players open each game: the presets of ``break_shot`` with the source of each value.

    Each has ``game``, ``name``; ``place`` of the cue ball (``as-racked``, or ``left_of_middle`` or
    ``from_left_rail``, m); ``speed`` of the cue, m/s; ``aim_ball``, the number of the ball aimed at
    in the rack, and ``aim_offset`` to the right of its centre, ball radii; ``side`` and ``height``,
    ball radii; ``gap``, m; ``middle_on_spot``, whether the rack's middle ball is on the foot spot;
    and ``sources`` (``key``, ``evidence``, ``source``). The elevation is the default one.
    """
    return _core.break_presets()
