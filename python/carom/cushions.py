"""Kick and bank tables: where a ball meets one cushion after the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom import _core
from carom.arguments import flat, number, thread_count, whole
from carom.plan import so_far
from carom.solve import a_shot, ball_index

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
    threads: int | None = None,
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
        threads: How many; None is one per core. Results do not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The shot has no strike, or one of these cannot be played.
    """
    turns, speeds, sides = _turns(azimuth), flat("speed", speed), flat("side", side)
    cushions = whole("cushions", cushions, _MOST_CUSHIONS + 1, low=1)
    with so_far(len(turns), show=progress, what="directions") as tell:
        found = _core.kick_table(
            a_shot(shot)._core,
            turns.tolist(),
            speeds.tolist(),
            sides.tolist(),
            number("height", height),
            cushions,
            thread_count(threads),
            tell,
        )
    struck = shot.to_dict()["strike"]["ball"]
    return _table(shot, struck, (turns, speeds, sides), cushions, found)


def bank_table(
    shot: Shot,
    ball: str,
    *,
    azimuth: ArrayLike | None = None,
    speed: ArrayLike = (1.0, 2.0, 4.0),
    cushions: int = 2,
    threads: int | None = None,
    progress: bool = False,
) -> CushionTable:
    """Where a ball that is sent off without spin meets the cushions, alone on the table.

    Args:
        shot: Its table, physics and ball.
        ball: Which ball.
        azimuth: Directions in which it starts, rad; None is every 5°.
        speed: Its speeds at the start, m/s; it slides first, as a ball that was hit does.
        cushions: How many are listed.
        threads: How many; None is one per core. Results do not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball, or a number is out of range.
    """
    index = ball_index(shot, ball)
    turns, speeds = _turns(azimuth), flat("speed", speed, above=0.0)
    cushions = whole("cushions", cushions, _MOST_CUSHIONS + 1, low=1)
    with so_far(len(turns), show=progress, what="directions") as tell:
        found = _core.bank_table(
            shot._core,
            index,
            turns.tolist(),
            speeds.tolist(),
            cushions,
            thread_count(threads),
            tell,
        )
    return _table(shot, ball, (turns, speeds, flat("side", 0.0)), cushions, found)


def _turns(azimuth: ArrayLike | None) -> NDArray[np.float64]:
    import numpy as np

    return flat("azimuth", np.radians(np.arange(0, 360, 5)) if azimuth is None else azimuth)


def _table(
    shot: Shot,
    ball: str,
    axes: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
    cushions: int,
    found: tuple[list[str], NDArray[np.float64]],
) -> CushionTable:
    import numpy as np

    rails, contact = found
    shape = (*map(len, axes), cushions)
    names = np.array(rails, dtype="U16").reshape(shape)
    turns, speeds, sides = axes
    places = contact.reshape((*shape, 2))
    return CushionTable(shot, ball, turns, speeds, sides, places, names)
