"""FastFiz table states, as ``TableState::toString`` writes them, and ``ShotParams``."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from carom.arguments import numbers
from carom.arguments import text as checked
from carom.convert._made import Converted
from carom.errors import InputError
from carom.shot import Shot

# Values of Ball::State in FastFiz.h.
_NOT_IN_PLAY, _STATIONARY = 0, 1
_POCKETS = {
    5: "bottom-left",
    6: "left",
    7: "top-left",
    8: "top-right",
    9: "right",
    10: "bottom-right",
}
_STATES, _TYPES = 11, 16
_FIELDS = 5


def fastfiz(text: str, strike: Sequence[float] | None = None) -> Converted:
    """Convert a FastFiz table state to a shot on the table ``poolfiz``.

    Args:
        text: The output of ``TableState::toString``: the number of balls, then for each ball its
            radius (m), state, type and position x, y (m, from the south-west corner).
        strike: FastFiz's ``ShotParams`` a, b (mm), theta, phi (degrees), v (m/s), which are not in
            the state; None gives a shot without a strike.

    Raises:
        InputError: The text is not a table state, or the engine rejects the shot.
    """
    balls, notes = _balls(checked("text", text).split())
    file: dict[str, Any] = {"format": "carom-shot/1", "table": "poolfiz", "balls": balls}
    notes.append("A table state does not name its table; FastFiz's default table was assumed.")
    notes.append(
        "Positions are FastFiz's, which has the head string at the top; the table poolfiz has it "
        "at the bottom."
    )
    if strike is None:
        notes.append("A table state has no strike, and none was given: the shot has none.")
    else:
        radius = next((b["radius"] for b in balls if b["id"] == "cue"), None)
        if radius is None:
            raise InputError("strike: the table state has no cue ball in play; leave it out")
        file["strike"] = _strike(strike, radius)
    return Converted(Shot.from_dict(file), notes)


def _balls(words: list[str]) -> tuple[list[dict[str, Any]], list[str]]:
    count = _number(words, 0, "the number of balls")
    if count < 1 or not count.is_integer() or len(words) != 1 + _FIELDS * count:
        raise InputError(
            f"the table state begins with {count:g} balls, but {len(words) - 1} numbers follow; "
            f"write {_FIELDS} numbers for each ball: radius, state, type, x and y"
        )
    balls, notes, pocketed, moving, absent = [], [], [], [], []
    for i in range(int(count)):
        at = 1 + _FIELDS * i
        radius, state, kind, x, y = (_number(words, at + j, f"ball {i}") for j in range(_FIELDS))
        if kind not in range(_TYPES) or state not in range(_STATES):
            raise InputError(
                f"ball {i}: state {state:g} and type {kind:g} do not exist in FastFiz; "
                "write a state from 0 to 10 and a type from 0 to 15"
            )
        name = "cue" if kind == 0 else str(int(kind))
        if state in _POCKETS:
            pocketed.append(f"{name} ({_POCKETS[int(state)]})")
        elif state == _NOT_IN_PLAY:
            absent.append(name)
        else:
            if state != _STATIONARY:
                moving.append(name)
            balls.append({"id": name, "position": [x, y], "radius": radius})
    for names, what in (
        (pocketed, "Pocketed balls were left out: {}."),
        (absent, "Balls that are not in play were left out: {}."),
        (moving, "A table state has no velocities, so moving balls are at rest: {}."),
    ):
        if names:
            notes.append(what.format(", ".join(names)))
    if not balls:
        raise InputError("the table state has no ball in play; add one")
    return balls, notes


def _strike(params: Sequence[float], radius: float) -> dict[str, Any]:
    """The shot file's strike. FastFiz measures b vertically, carom perpendicular to the cue."""
    params = numbers("strike", params, _FIELDS)
    if not all(math.isfinite(p) for p in params):
        raise InputError(
            "strike: a number is not finite; write a, b (mm), theta, phi (degrees), v (m/s)"
        )
    a, b, theta, phi, speed = params
    a, b = 1e-3 * a / radius, 1e-3 * b / radius
    if a * a + b * b > 1.0:
        raise InputError(
            f"strike: a and b are {math.hypot(a, b):.3g} ball radii off centre; give less than 1"
        )
    towards_cue = math.sqrt(1.0 - a * a - b * b)
    sin, cos = math.sin(math.radians(theta)), math.cos(math.radians(theta))
    return {
        "ball": "cue",
        "speed": speed,
        "azimuth_deg": phi,
        "elevation_deg": theta,
        "side": a,
        "height": b * cos - towards_cue * sin,
        # FastFiz has no miscues.
        "miscue": "report",
    }


def _number(words: list[str], index: int, what: str) -> float:
    try:
        value = float(words[index])
    except (IndexError, ValueError):
        found = words[index] if index < len(words) else "nothing"
        raise InputError(
            f"{what}: {found!r} is not a number; write numbers separated by blanks"
        ) from None
    if not math.isfinite(value):
        raise InputError(f"{what}: {words[index]} is not finite; write a finite number")
    return value
