"""FastFiz's states of a game, noises and shots, and those of a frame of eight-ball on ``poolfiz``.

FastFiz has the head string at the top of the table and carom at the bottom, so the table is turned
by half a turn: a turn keeps right and left of the cue, and a mirror would not. The formats are
those of ``GameState::toString``, ``Noise::toString`` and ``submit_shot`` (FastFiz 0.2 and its
server).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from carom.build import Strike
from carom.call import Call
from carom.convert._fastfiz import strike_of
from carom.errors import InputError
from carom.noise import Noise
from carom.player import Play
from carom.request import Request
from carom.rules import Frame

#: The game and the table of FastFiz.
GAME, TABLE = "eight-ball", "poolfiz"

# FastFiz.h: length and width of the playing area, and radius of a ball, m.
_LENGTH, _WIDTH, _RADIUS = 2.236, 1.116, 0.028575
# The head string, after the half turn, m. FastFiz allows a cue ball on it, and carom only behind
# it: one within a micrometre is put so far behind.
_HEAD_STRING, _BEHIND = 0.559, 1e-6
# Pockets by their numbers in FastFiz, SW to SE, after the half turn.
_POCKETS = ("top-right", "right", "bottom-right", "bottom-left", "left", "top-left")
# Numbers that stand for no ball and for no pocket.
_NO_BALL, _NO_POCKET = 16, 6
# Values of Ball::State: on the table, and pocketed at SW. A frame does not have the pockets of the
# balls that are down, and no rule of eight-ball asks for them.
_STATIONARY, _POCKETED = 1, 5
_SOUTH_WEST = (0.0, 0.0)

# Values of TurnType.
_NORMAL, _IN_HAND, _BEHIND_LINE, _BREAK = 0, 1, 2, 4
_FOUL_ON_BREAK, _EIGHT_ON_BREAK = 6, 7
# Values of Decision, with the choices that each of them may mean; the first that is offered counts.
_CONCEDE = 4
_CHOICES = {
    1: ("play-on", "spot-eight", "play-from-hand"),
    2: ("rebreak",),
    3: ("rebreak-by-other",),
}


class GameShot(NamedTuple):
    """A shot of ``submit_shot``.

    Attributes:
        a: Horizontal offset of the tip, mm.
        b: Vertical offset of the tip, mm.
        theta: Elevation, degrees.
        phi: Azimuth on FastFiz's table, degrees.
        v: Speed of the cue, m/s.
        cue_x: Place of a cue ball in hand on FastFiz's table, m.
        cue_y: The same.
        ball: The called ball, or 16.
        pocket: The called pocket, or 6.
        decision: A value of ``Decision``.
    """

    a: float
    b: float
    theta: float
    phi: float
    v: float
    cue_x: float
    cue_y: float
    ball: int
    pocket: int
    decision: int


def game_state(frame: Frame, seat: int, clock: float | None) -> str:
    """The state of a frame as ``GameState::Factory`` reads it.

    Args:
        frame: A frame of eight-ball on ``poolfiz``.
        seat: The player who is asked.
        clock: Seconds that this player has left; None without a clock. FastFiz writes 0 for it, and
            so is the other player's time, which a player is not told.

    Raises:
        InputError: The frame is of another game.
    """
    if frame.game != GAME:
        raise InputError(
            "unsupported", "game", f"FastFiz does not have {frame.game}", f"play {GAME}"
        )
    request, places = frame.request, frame.balls
    balls = []
    for number in range(16):
        at = places.get("cue" if number == 0 else str(number))
        x, y = _SOUTH_WEST if at is None else turned(*at)
        balls.append(f"{_RADIUS} {_POCKETED if at is None else _STATIONARY} {number} {x!r} {y!r}")
    group = frame.state["groups"][seat]
    started = int(seat == 0)
    turn = f"1 {_turn_type(request)} {0.0 if clock is None else clock!r} 0 {started}"
    return f"{turn} {len(balls)} {' '.join(balls)} {int(group is None)} {int(group == 'solids')}"


def _turn_type(request: Request) -> int:
    if request.kind == "choice":
        return _EIGHT_ON_BREAK if "spot-eight" in request.choices else _FOUL_ON_BREAK
    if "pocket" not in request.calls:
        return _BREAK
    return {None: _NORMAL, "anywhere": _IN_HAND}.get(request.in_hand, _BEHIND_LINE)


def noise_text(noise: Noise) -> str:
    """A noise as ``Noise::Factory`` reads it: a, b (mm), theta, phi (degrees) and v (m/s).

    Errors that FastFiz does not have are left out.
    """
    values = (
        1e3 * noise.side_m,
        1e3 * noise.height_m,
        math.degrees(noise.elevation),
        math.degrees(noise.azimuth),
        noise.speed,
    )
    return "1" if not any(values) else " ".join(["2", *map(repr, values)])


def answer_of(shot: GameShot, request: Request) -> Play | str:
    """The answer to a request that a shot of FastFiz gives.

    Raises:
        InputError: The shot does not answer this request, or has no meaning.
    """
    if shot.decision == _CONCEDE:
        return "concede"
    if request.kind == "choice":
        meant = _CHOICES.get(shot.decision, ())
        for choice in meant:
            if choice in request.choices:
                return choice
        raise InputError(
            "not-a-move",
            "decision",
            f"{shot.decision} is none of the choices: {', '.join(request.choices)}",
            "write 1 to play on, 2 to break again, 3 to let the other player break again",
        )
    written = strike_of((shot.a, shot.b, shot.theta, shot.phi, shot.v), _RADIUS)
    return Play(
        Strike(
            speed=written["speed"],
            azimuth_deg=(written["azimuth_deg"] + 180.0) % 360.0,
            elevation_deg=written["elevation_deg"],
            side=written["side"],
            height=written["height"],
        ),
        cue_ball=_cue_ball(shot, request),
        call=_call(shot, request),
    )


def _cue_ball(shot: GameShot, request: Request) -> tuple[float, float] | None:
    if request.in_hand is None:
        return None
    x, y = turned(shot.cue_x, shot.cue_y)
    if request.in_hand == "behind-head-string" and abs(y - _HEAD_STRING) < _BEHIND:
        y = _HEAD_STRING - _BEHIND
    return x, y


def _call(shot: GameShot, request: Request) -> Call | None:
    if "pocket" not in request.calls:
        return None
    if (shot.ball, shot.pocket) == (_NO_BALL, _NO_POCKET):
        return Call.safety()
    if not (1 <= shot.ball < _NO_BALL and 0 <= shot.pocket < _NO_POCKET):
        raise InputError(
            "out-of-range",
            "ball",
            f"{shot.ball} into pocket {shot.pocket} is not a call",
            "call a ball from 1 to 15 and a pocket from 0 to 5, or 16 and 6 for neither",
        )
    return Call.pocket(str(shot.ball), _POCKETS[shot.pocket])


def turned(x: float, y: float) -> tuple[float, float]:
    """A place after half a turn of the table, m."""
    return _WIDTH - x, _LENGTH - y
