"""Kick and bank tables: where a ball meets one cushion after the other."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom.batch import progress_bar
from carom.errors import InputError
from carom.maps import flat
from carom.noise import whole
from carom.solve import ball_index

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from carom.shot import Shot

# Cushions that a table can list; balls die before.
_MOST_CUSHIONS = 12


@dataclass(frozen=True, slots=True, eq=False)
class CushionTable:
    """Where a ball, alone on the table, meets one cushion after the other.

    Attributes:
        shot: Its table, its physics and where the ball starts.
        ball: Which ball.
        azimuth: Directions, rad, shape (n_azimuths,).
        speed: Of the cue (kicks) or the ball (banks), m/s, shape (n_speeds,).
        side: Contact points right of centre, ball radii, shape (n_sides,); a 0 for banks.
        contact: The ball's centre at each cushion, m, shape (n_azimuths, n_speeds, n_sides,
            n_cushions, 2); NaN where it stops, falls or meets a jaw before.
        rail: The rails' names, strings of shape (n_azimuths, n_speeds, n_sides, n_cushions);
            empty where ``contact`` is NaN.
    """

    shot: Shot
    ball: str
    azimuth: NDArray[np.float64]
    speed: NDArray[np.float64]
    side: NDArray[np.float64]
    contact: NDArray[np.float64]
    rail: NDArray[np.str_]


def kick_table(
    shot: Shot,
    *,
    azimuth: ArrayLike | None = None,
    speed: ArrayLike = (1.5, 3.0, 5.0),
    side: ArrayLike = (-0.4, 0.0, 0.4),
    height: float = 0.0,
    cushions: int = 3,
    progress: bool = False,
) -> CushionTable:
    """Where the struck ball of a shot meets the cushions, with nothing else on the table.

    Args:
        shot: Its table, physics and struck ball; the elevation is its strike's.
        azimuth: Directions of the cue, rad; None is every 5°.
        speed: Speeds of the cue, m/s.
        side: Contact points right of centre, ball radii.
        height: Contact point above centre, ball radii.
        cushions: How many are listed.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The shot has no strike, or one of these cannot be played.
    """
    file = shot.to_dict()
    if "strike" not in file:
        raise InputError("strike: the shot has none; it says which ball is struck")
    struck = file["strike"]["ball"]
    file["balls"] = [ball for ball in file["balls"] if ball["id"] == struck]

    def make(turn: float, fast: float, aside: float) -> dict[str, Any]:
        strike = {
            "azimuth_deg": math.degrees(turn),
            "speed": fast,
            "side": aside,
            "height": height,
        }
        return file | {"strike": file["strike"] | strike}

    return _table(shot, struck, make, azimuth, speed, side, cushions, progress=progress)


def bank_table(
    shot: Shot,
    ball: str,
    *,
    azimuth: ArrayLike | None = None,
    speed: ArrayLike = (1.0, 2.0, 4.0),
    cushions: int = 2,
    progress: bool = False,
) -> CushionTable:
    """Where a ball that is sent off without spin meets the cushions, alone on the table.

    Args:
        shot: Its table, physics and ball.
        ball: Which ball.
        azimuth: Directions in which it starts, rad; None is every 5°.
        speed: Its speeds at the start, m/s; it slides first, as a ball that was hit does.
        cushions: How many are listed.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball, or a number is out of range.
    """
    file = shot.to_dict()
    file.pop("strike", None)
    own = file["balls"][ball_index(shot, ball)]

    def make(turn: float, fast: float, _: float) -> dict[str, Any]:
        velocity = [fast * math.cos(turn), fast * math.sin(turn), 0.0]
        return file | {"balls": [own | {"velocity": velocity}]}

    return _table(shot, ball, make, azimuth, speed, 0.0, cushions, progress=progress)


def _table(
    shot: Shot,
    ball: str,
    make: Callable[[float, float, float], dict[str, Any]],
    azimuth: ArrayLike | None,
    speed: ArrayLike,
    side: ArrayLike,
    cushions: int,
    *,
    progress: bool,
) -> CushionTable:
    import numpy as np

    from carom.shot import Shot

    whole("cushions", cushions, _MOST_CUSHIONS + 1)
    turns = flat("azimuth", np.radians(np.arange(0, 360, 5)) if azimuth is None else azimuth)
    speeds, sides = flat("speed", speed), flat("side", side)
    shape = (len(turns), len(speeds), len(sides), cushions)
    contact = np.full((*shape, 2), np.nan)
    rails = np.full(shape, "", dtype="U16")
    with progress_bar(len(turns), show=progress, what="directions") as advance:
        for i, turn in enumerate(turns.tolist()):
            for j, fast in enumerate(speeds.tolist()):
                for k, aside in enumerate(sides.tolist()):
                    trace = Shot.from_dict(make(turn, fast, aside)).simulate()
                    for n, (rail, place) in enumerate(_noses(trace.events, cushions)):
                        rails[i, j, k, n] = rail
                        contact[i, j, k, n] = place
            advance(1)
    return CushionTable(shot, ball, turns, speeds, sides, contact, rails)


def _noses(events: list[Any], most: int) -> list[tuple[str, list[float]]]:
    """Rail and centre at the first ``most`` noses, up to the first jaw."""
    found: list[tuple[str, list[float]]] = []
    for event in events:
        if event["type"] != "rail-collision" or len(found) == most:
            continue
        if event["part"] != "nose":
            break
        found.append((event["rail"], event["before"][0]["position"][:2]))
    return found
