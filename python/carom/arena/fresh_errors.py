"""How the luck of a match's shots is measured, and where a record has it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from carom.arguments import whole

#: Usual number of fresh errors of a shot.
DRAWS = 256
# One more than the largest number.
_END = (1 << 18) + 1


def luck_draws(value: bool | int, place: str = "luck") -> int | None:
    """The number of fresh errors of each shot; None if the luck is not measured.

    Args:
        value: True for the usual number, False for none, or a number.
        place: Where the value stands, for the error message.
    """
    if isinstance(value, bool):
        return DRAWS if value else None
    return whole(place, value, _END, low=1)


def luck_settings(value: bool | int) -> dict[str, Any] | None:
    """The key ``luck`` of a record's header; None if the luck is not measured."""
    draws = luck_draws(value)
    return None if draws is None else {"draws": draws, "value": "logistic"}


def frame_luck(line: Mapping[str, Any]) -> float | None:
    """The luck of the match's first player in a frame, in points.

    Args:
        line: The frame's line of a record.

    Returns:
        The sum over all shots; None if the luck was not measured.
    """
    if "luck" not in line["seeds"]:
        return None
    luck = 0.0
    for move in line["moves"]:
        if "luck" in move:
            found = move["luck"]["after"] - move["luck"]["expected"]
            luck += found if line["seats"][move["seat"]] == 0 else -found
    return luck
