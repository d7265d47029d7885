"""How the luck of a match's shots is measured."""

from __future__ import annotations

from typing import Any

from carom.arguments import whole

#: Usual number of fresh errors of a shot.
DRAWS = 256
# One more than the largest number.
_END = (1 << 18) + 1


def luck_draws(value: bool | int) -> int | None:
    """The number of fresh errors of each shot; None if the luck is not measured.

    Args:
        value: True for the usual number, False for none, or a number.
    """
    if isinstance(value, bool):
        return DRAWS if value else None
    return whole("luck", value, _END, low=1)


def luck_settings(value: bool | int) -> dict[str, Any] | None:
    """The key ``luck`` of a record's header; None if the luck is not measured."""
    draws = luck_draws(value)
    return None if draws is None else {"draws": draws, "value": "logistic"}
