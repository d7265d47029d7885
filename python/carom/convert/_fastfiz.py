"""FastFiz table states, as ``TableState::toString`` writes them, ``ShotParams``, and its logs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from carom.arguments import numbers, whole
from carom.arguments import text as checked
from carom.convert._made import TOLERANCE, Converted, made
from carom.errors import InputError

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


# Words of a log line before its table state: none, or the game's type, the type of the turn, both
# times, and whether the player began.
_STATE_LINES = {"TSTATE": 0, "STATE": 5}
# The shot of a log line is its first five numbers. Those of a SHOT are the executed ones.
_SHOT_LINES = ("TSHOT", "SHOT")
_OTHER_LINES = ("COMMENT", "GTYPE")
LOG_WORDS = (*_STATE_LINES, *_SHOT_LINES, *_OTHER_LINES)


def fastfiz(
    text: str,
    strike: Sequence[float] | None = None,
    *,
    index: int = 0,
    tolerance: float = TOLERANCE,
) -> Converted:
    """Convert a FastFiz table state, or a state of its log, to a shot on the table ``poolfiz``.

    Args:
        text: The output of ``TableState::toString``: the number of balls, then for each ball its
            radius (m), state, type and position x, y (m, from the south-west corner). Or a log of
            ``LogWriter``: lines that begin with TSTATE or STATE, each followed by its TSHOT or
            SHOT.
        strike: FastFiz's ``ShotParams`` a, b (mm), theta, phi (degrees), v (m/s), for a state
            without a shot; None gives a shot without a strike.
        index: Which state of a log, from 0.
        tolerance: Largest overlap of balls and cushions that is removed (``Layout.repaired``), m;
            ``left_out`` lists the balls that moved.

    Raises:
        InputError: The text is not a table state or a log, or the engine rejects the shot.
    """
    lines = checked("text", text)
    notes: list[str] = []
    words, logged = lines.split(), None
    if lines.split(maxsplit=1)[:1] and lines.split(maxsplit=1)[0] in LOG_WORDS:
        words, logged = _of_log(lines, whole("index", index), notes)
    elif index:
        raise InputError(
            "out-of-range", "index", f"{index} is out of range", "a table state has only 0"
        )
    if logged is not None and strike is not None:
        raise InputError("conflict", "strike", "the log has a shot for this state", "leave it out")
    strike = logged if strike is None else strike
    balls, more = _balls(words)
    file: dict[str, Any] = {"format": "carom-shot/1", "table": "poolfiz", "balls": balls}
    notes += more
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
            raise InputError(
                "conflict", "strike", "the table state has no cue ball in play", "leave it out"
            )
        file["strike"] = _strike(strike, radius)
    return made(file, notes, tolerance)


def _of_log(text: str, index: int, notes: list[str]) -> tuple[list[str], list[float] | None]:
    """The table state and the shot of a log, in words and numbers.

    Raises:
        InputError: A line is not FastFiz's, or there is no such state.
    """
    states: list[list[str]] = []
    shots: dict[int, list[float]] = {}
    noisy: set[int] = set()
    for n, line in enumerate(text.splitlines(), 1):
        kind, _, rest = line.strip().partition(" ")
        words = rest.split()
        if kind in _STATE_LINES:
            before = _STATE_LINES[kind]
            count = _number(words, before, f"line {n}: the number of balls")
            # After the table state a game has words of its own.
            states.append(words[before : before + 1 + _FIELDS * max(0, int(count))])
        elif kind in _SHOT_LINES and states:
            place = f"line {n}: the shot"
            shots[len(states) - 1] = [_number(words, k, place) for k in range(_FIELDS)]
            if kind == "SHOT":
                noisy.add(len(states) - 1)
        elif kind and kind not in LOG_WORDS:
            raise InputError(
                "syntax",
                f"line {n}",
                f"a line of a FastFiz log begins with one of {', '.join(LOG_WORDS)}, and "
                f"this one with {kind!r}",
                "remove it",
            )
    if index >= len(states):
        raise InputError(
            "out-of-range", "index", f"{index} is out of range", f"the log has {len(states)} states"
        )
    if len(states) > 1:
        notes.append(f"The log has {len(states)} states; this is number {index}, counted from 0.")
    if index in noisy:
        notes.append("The strike is the executed one, with FastFiz's noise, not the intended one.")
    return states[index], shots.get(index)


def _balls(words: list[str]) -> tuple[list[dict[str, Any]], list[str]]:
    count = _number(words, 0, "the number of balls")
    if count < 1 or not count.is_integer() or len(words) != 1 + _FIELDS * count:
        raise InputError(
            "wrong-count",
            "",
            f"the table state begins with {count:g} balls, but {len(words) - 1} numbers follow",
            f"write {_FIELDS} numbers for each ball: radius, state, type, x and y",
        )
    balls, notes, pocketed, moving, absent = [], [], [], [], []
    for i in range(int(count)):
        at = 1 + _FIELDS * i
        radius, state, kind, x, y = (_number(words, at + j, f"ball {i}") for j in range(_FIELDS))
        if kind not in range(_TYPES) or state not in range(_STATES):
            raise InputError(
                "out-of-range",
                f"ball {i}",
                f"state {state:g} and type {kind:g} do not exist in FastFiz",
                "write a state from 0 to 10 and a type from 0 to 15",
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
        raise InputError("ball-count", "", "the table state has no ball in play", "add one")
    return balls, notes


def _strike(params: Sequence[float], radius: float) -> dict[str, Any]:
    """The shot file's strike. FastFiz measures b vertically, carom perpendicular to the cue."""
    params = numbers("strike", params, _FIELDS)
    if not all(math.isfinite(p) for p in params):
        raise InputError(
            "out-of-range",
            "strike",
            "a number is not finite",
            "write a, b (mm), theta, phi (degrees), v (m/s)",
        )
    a, b, theta, phi, speed = params
    a, b = 1e-3 * a / radius, 1e-3 * b / radius
    if a * a + b * b > 1.0:
        raise InputError(
            "out-of-range",
            "strike",
            f"a and b are {math.hypot(a, b):.3g} ball radii off centre",
            "give less than 1",
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
            "wrong-type", what, f"{found!r} is not a number", "write numbers separated by blanks"
        ) from None
    if not math.isfinite(value):
        raise InputError(
            "out-of-range", what, f"{words[index]} is not finite", "write a finite number"
        )
    return value
