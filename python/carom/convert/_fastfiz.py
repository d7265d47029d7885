"""FastFiz table states, as ``TableState::toString`` writes them, ``ShotParams``, and its logs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from carom.arguments import numbers, whole
from carom.arguments import text as checked
from carom.convert._fastfiz_log import BALL_FIELDS, LoggedState, is_log, number, states_of
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
# Radius of FastFiz's balls, m.
_RADIUS = 0.028575


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
    given = checked("text", text)
    notes: list[str] = []
    state = LoggedState(given.split())
    if is_log(given):
        state = _of_log(given, whole("index", index), notes)
    elif index:
        raise InputError(
            "out-of-range", "index", f"{index} is out of range", "a table state has only 0"
        )
    if strike is not None:
        if state.strike is not None:
            raise InputError(
                "conflict", "strike", "the log has a shot for this state", "leave it out"
            )
        state = state._replace(strike=[*numbers("strike", strike, 5)])
    return _converted(state, notes, tolerance)


def fastfiz_log(text: str, *, tolerance: float = TOLERANCE) -> list[Converted]:
    """Convert all states of a FastFiz log, each with the shot that follows it.

    Args:
        text: As for ``fastfiz``, a log.
        tolerance: As for ``fastfiz``.

    Returns:
        A shot for each state, in order. The last one may have no strike, and so has a state that
        asks for a decision in place of a shot.

    Raises:
        InputError: The text is not a log, or the engine rejects a shot; the place has the number of
            the state.
    """
    log = checked("text", text)
    if not is_log(log):
        raise InputError(
            "format",
            "text",
            "it is not a log of FastFiz",
            "give one state to carom.convert.fastfiz",
        )
    made_of = []
    for index, state in enumerate(states_of(log)):
        try:
            made_of.append(_converted(state, [], tolerance))
        except InputError as error:
            raise error.inside(f"state {index}", ": ") from None
    return made_of


def _of_log(text: str, index: int, notes: list[str]) -> LoggedState:
    """A state of a log.

    Raises:
        InputError: A line is not FastFiz's, or there is no such state.
    """
    states = states_of(text)
    if index >= len(states):
        raise InputError(
            "out-of-range", "index", f"{index} is out of range", f"the log has {len(states)} states"
        )
    if len(states) > 1:
        notes.append(f"The log has {len(states)} states; this is number {index}, counted from 0.")
    return states[index]


def _converted(state: LoggedState, notes: list[str], tolerance: float) -> Converted:
    """The shot of a state."""
    balls, more = _balls(state.words)
    file: dict[str, Any] = {"format": "carom-shot/1", "table": "poolfiz", "balls": balls}
    notes += more
    notes.append("A table state does not name its table; FastFiz's default table was assumed.")
    notes.append(
        "Positions are FastFiz's, which has the head string at the top; the table poolfiz has it "
        "at the bottom."
    )
    if state.is_executed:
        notes.append("The strike is the executed one, with FastFiz's noise, not the intended one.")
    if state.is_decision:
        notes.append("The state asks for a decision in place of a shot: the shot has no strike.")
    elif state.strike is None:
        notes.append("A table state has no strike, and none was given: the shot has none.")
    else:
        _add_strike(file, state)
    return made(file, notes, tolerance)


def _add_strike(file: dict[str, Any], state: LoggedState) -> None:
    balls = file["balls"]
    cue = next((ball for ball in balls if ball["id"] == "cue"), None)
    if state.cue_ball is not None:
        if cue is None:
            cue = {"id": "cue", "position": [], "radius": _RADIUS}
            balls.insert(0, cue)
        cue["position"] = [*state.cue_ball]
    if cue is None:
        raise InputError(
            "conflict", "strike", "the table state has no cue ball in play", "leave it out"
        )
    assert state.strike is not None
    file["strike"] = strike_of(state.strike, cue["radius"])


def _balls(words: list[str]) -> tuple[list[dict[str, Any]], list[str]]:
    count = number(words, 0, "the number of balls")
    if count < 1 or not count.is_integer() or len(words) != 1 + BALL_FIELDS * count:
        raise InputError(
            "wrong-count",
            "",
            f"the table state begins with {count:g} balls, but {len(words) - 1} numbers follow",
            f"write {BALL_FIELDS} numbers for each ball: radius, state, type, x and y",
        )
    balls, notes, pocketed, moving, absent = [], [], [], [], []
    for i in range(int(count)):
        at = 1 + BALL_FIELDS * i
        radius, state, kind, x, y = (number(words, at + j, f"ball {i}") for j in range(BALL_FIELDS))
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


def strike_of(params: Sequence[float], radius: float) -> dict[str, Any]:
    """The shot file's strike. FastFiz measures b vertically, carom perpendicular to the cue."""
    params = numbers("strike", params, 5)
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
