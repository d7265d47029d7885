"""Balls and pockets of a shot by name."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import core, text
from carom.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence

    import carom


def core_of(shot: carom.Shot) -> _core.Shot:
    """The Rust object of a shot.

    Raises:
        InputError: It is not a ``carom.Shot``.
    """
    return core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")


def ball_and_pocket(name: str, value: Any) -> tuple[str, str | None]:
    """A ball's id, and a pocket's name if one is given.

    Raises:
        InputError: The value is neither a text nor a pair of texts; the message calls it ``name``.
    """
    if isinstance(value, tuple | list) and len(value) == 2:
        ball, pocket = value
        return text(f"{name}[0]", ball, "a ball's id"), text(
            f"{name}[1]", pocket, "a pocket's name"
        )
    return text(name, value, "a ball's id, or give (ball, pocket)"), None


def target(shot: carom.Shot, pot: str | tuple[str, str]) -> tuple[int, int | None]:
    """Ball and pocket by index; no pocket where any will do.

    Raises:
        InputError: There is no such ball or pocket.
    """
    ball, pocket = ball_and_pocket("pot", pot)
    return ball_index(shot, ball), None if pocket is None else pocket_index(shot, pocket)


def ball_index(shot: carom.Shot, ball: str) -> int:
    """The index of a ball in the shot.

    Raises:
        InputError: There is no such ball.
    """
    ids = core_of(shot).ids
    if text("ball", ball, "its id") not in ids:
        raise InputError(
            "unknown-ball", "ball", f"there is no {ball!r}", f"write one of {', '.join(ids)}"
        )
    return ids.index(ball)


def pocket_names(shot: carom.Shot) -> list[str]:
    """The names of the table's pockets, in the order of ``carom tables``."""
    return [pocket["name"] for pocket in core_of(shot).geometry()["pockets"]]


def pocket_index(shot: carom.Shot, pocket: str) -> int:
    """The index of a pocket in the table's list.

    Raises:
        InputError: There is no such pocket.
    """
    names = pocket_names(shot)
    if text("pocket", pocket, "its name") not in names:
        raise no_such_pocket(pocket, names)
    return names.index(pocket)


def no_such_pocket(pocket: str, names: Sequence[str]) -> InputError:
    """The error for an unknown pocket of a table with these pockets."""
    remedy = f"write one of {', '.join(names)}" if names else "choose a table with pockets"
    return InputError("unknown-name", "pocket", f"there is no {pocket!r}", remedy)
