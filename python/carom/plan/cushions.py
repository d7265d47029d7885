"""Kick and bank tables: where a ball meets one cushion after the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom import _core
from carom.arguments import angles, flat, number, thread_count, warn_of_degrees, whole
from carom.lazy import np
from carom.plan.lookup import ball_index, core_of
from carom.progress import stage_bars

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    import carom

# Most cushions of one ball. Balls come to rest earlier. Every cushion of a cell takes 80 bytes.
_MOST_CUSHIONS = 12


@dataclass(frozen=True, slots=True, eq=False)
class CushionTable:
    """Where a ball, alone on the table, meets one cushion after the other.

    Attributes:
        shot: Table, physics and the ball's starting place.
        ball: The ball's id.
        azimuth: Directions, rad, shape (n_azimuths,).
        speed: Of the cue (kicks) or the ball (banks), m/s, shape (n_speeds,).
        side: Contact points right of centre, ball radii, shape (n_sides,); a single 0 for banks.
        contact: The ball's centre at each cushion, m, shape (n_azimuths, n_speeds, n_sides,
            n_cushions, 2); NaN where the ball stops, falls or meets a jaw
            earlier.
        rail: The rails' names, strings of shape (n_azimuths, n_speeds, n_sides, n_cushions);
            empty where ``contact`` is NaN.
    """

    shot: carom.Shot
    ball: str
    azimuth: NDArray[np.float64]
    speed: NDArray[np.float64]
    side: NDArray[np.float64]
    contact: NDArray[np.float64]
    rail: NDArray[np.str_]


def kick_table(
    shot: carom.Shot,
    *,
    azimuth: ArrayLike | None = None,
    azimuth_deg: ArrayLike | None = None,
    speed: ArrayLike = (1.5, 3.0, 5.0),
    side: ArrayLike = (-0.4, 0.0, 0.4),
    height: float = 0.0,
    cushions: int = 3,
    threads: int | None = None,
    progress: bool = False,
) -> CushionTable:
    """Where the struck ball of a shot meets the cushions, alone on the table.

    Args:
        shot: Table, physics and struck ball. The elevation is that of its strike;
            if it is omitted, it is the default of each cell, without the other balls.
        azimuth: Directions of the cue, rad; None is every 5°.
        azimuth_deg: The same in degrees, in place of ``azimuth``.
        speed: Speeds of the cue, m/s.
        side: Contact points right of centre, ball radii.
        height: Contact point above centre, ball radii.
        cushions: Largest number of cushions listed per ball, at most 12.
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The shot has no strike, the cloth has no cushions, a strike cannot be played,
            or there are more than ten million contacts.
    """
    turns, speeds, sides = _turns(azimuth, azimuth_deg), flat("speed", speed), flat("side", side)
    cushions = whole("cushions", cushions, _MOST_CUSHIONS + 1, low=1)
    with stage_bars(["balls"], show=progress) as report:
        found = _core.kick_table(
            core_of(shot),
            turns.tolist(),
            speeds.tolist(),
            sides.tolist(),
            number("height", height),
            cushions,
            thread_count(threads),
            report,
        )
    struck = shot.to_dict()["strike"]["ball"]
    return _table(shot, struck, (turns, speeds, sides), cushions, found)


def bank_table(
    shot: carom.Shot,
    ball: str,
    *,
    azimuth: ArrayLike | None = None,
    azimuth_deg: ArrayLike | None = None,
    speed: ArrayLike = (1.0, 2.0, 4.0),
    cushions: int = 2,
    threads: int | None = None,
    progress: bool = False,
) -> CushionTable:
    """Where a ball that starts without spin meets the cushions, alone on the table.

    Args:
        shot: Table, physics and ball.
        ball: The ball's id.
        azimuth: Directions in which it starts, rad; None is every 5°.
        azimuth_deg: The same in degrees, in place of ``azimuth``.
        speed: Its speeds at the start, m/s, in (0, 100]; it slides first, as after a collision.
        cushions: Largest number of cushions listed per ball, at most 12.
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball, the cloth has no cushions, a number is out of range, or
            there are more than ten million contacts.
    """
    index = ball_index(shot, ball)
    turns, speeds = _turns(azimuth, azimuth_deg), flat("speed", speed)
    cushions = whole("cushions", cushions, _MOST_CUSHIONS + 1, low=1)
    with stage_bars(["balls"], show=progress) as report:
        found = _core.bank_table(
            core_of(shot),
            index,
            turns.tolist(),
            speeds.tolist(),
            cushions,
            thread_count(threads),
            report,
        )
    return _table(shot, ball, (turns, speeds, flat("side", 0.0)), cushions, found)


def _turns(azimuth: ArrayLike | None, azimuth_deg: ArrayLike | None) -> NDArray[np.float64]:
    if azimuth is None and azimuth_deg is None:
        azimuth_deg = np.arange(0, 360, 5)
    turns = flat("azimuth", angles("azimuth", azimuth, azimuth_deg))
    if azimuth_deg is None:
        warn_of_degrees("azimuth", turns)
    return turns


def _table(
    shot: carom.Shot,
    ball: str,
    axes: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
    cushions: int,
    found: tuple[list[str], NDArray[np.float64]],
) -> CushionTable:
    rails, contact = found
    shape = (*map(len, axes), cushions)
    names = np.array(rails, dtype="U16").reshape(shape)
    turns, speeds, sides = axes
    places = contact.reshape((*shape, 2))
    return CushionTable(shot, ball, turns, speeds, sides, places, names)
