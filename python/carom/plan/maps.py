"""Maps: a result for every cell of a grid, as arrays."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom import _core
from carom.arguments import flat, number, thread_count, whole
from carom.errors import InputError
from carom.lazy import np
from carom.noise import Noise, Perception
from carom.plan.drawn_tables import on_drawn_tables
from carom.plan.lookup import ball_index, core_of, pocket_index
from carom.plan.options import Sampling
from carom.progress import stage_bars

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    import carom
    from carom.plan.drawn_tables import TablePosterior

# Most cells along the width. The cells of a 9-foot table are then 0.6 mm wide; smaller ones show
# nothing more and would take hours.
_MOST_COLUMNS = 2048


@dataclass(frozen=True, slots=True, eq=False)
class PotMap:
    """The chance of a pot for each place of the cue ball; ``print`` it for a table.

    Attributes:
        shot: The shot whose cue ball is moved.
        ball: The object ball.
        pocket: The pocket.
        x: Centres of the cells along the width, m, shape (columns,).
        y: Centres of the cells along the length, m, shape (rows,).
        chance: The probability that the ball falls and the cue ball does not, shape (rows,
            columns); NaN where the cue ball has no room.
        low: Lower end of its confidence interval, same shape.
        high: Upper end of its confidence interval, same shape.
        n: Number of variants, int64, same shape; 0 where the cue ball has no room.
        azimuth: Direction of the aim, rad, same shape; NaN where the cue ball has no room.
    """

    shot: carom.Shot
    ball: str
    pocket: str
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    chance: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    n: NDArray[np.int64]
    azimuth: NDArray[np.float64]

    def __str__(self) -> str:
        lines = [f"{self.ball} into {self.pocket}, %, from x (bottom line) and y (left) in cm"]
        for y, row in zip(self.y[::-1].tolist(), self.chance[::-1].tolist(), strict=True):
            cells = ("  -" if math.isnan(chance) else f"{100 * chance:3.0f}" for chance in row)
            lines.append(f"{100 * y:4.0f}  " + " ".join(cells))
        lines.append("      " + " ".join(f"{100 * x:3.0f}" for x in self.x.tolist()))
        return "\n".join(lines)


@dataclass(frozen=True, slots=True, eq=False)
class PositionMap:
    """Where the cue ball ends for each speed and spin; ``print`` it for a table.

    Attributes:
        shot: The shot whose strike is changed.
        ball: The object ball.
        pocket: The pocket.
        speed: The cue's speeds, m/s, shape (n_speeds,).
        side: Contact points right of centre, ball radii, shape (n_spins,).
        height: Contact points above centre, ball radii, shape (n_spins,).
        falls: Whether the ball falls and the cue ball does not, bool, shape (n_speeds, n_spins).
        azimuth: Direction of the aim, rad, same shape; NaN for strikes past the miscue limit.
        end: Where the cue ball comes to rest, m, shape (n_speeds, n_spins, 2); NaN likewise.
    """

    shot: carom.Shot
    ball: str
    pocket: str
    speed: NDArray[np.float64]
    side: NDArray[np.float64]
    height: NDArray[np.float64]
    falls: NDArray[np.bool_]
    azimuth: NDArray[np.float64]
    end: NDArray[np.float64]

    def __str__(self) -> str:
        lines = ["speed   side height azimuth_deg falls  cue ball ends at x, y in m"]
        for k, (side, height) in enumerate(
            zip(self.side.tolist(), self.height.tolist(), strict=True)
        ):
            for j, speed in enumerate(self.speed.tolist()):
                turn = math.degrees(self.azimuth[j, k]) % 360
                if math.isnan(turn):
                    found = f"{'-':>11} -"
                else:
                    x, y = self.end[j, k].tolist()
                    found = f"{turn:11.2f} {'yes' if self.falls[j, k] else 'no':5}  {x:.3f} {y:.3f}"
                lines.append(f"{speed:5.2f} {side:+6.2f} {height:+6.2f} {found}")
        return "\n".join(lines)


@dataclass(frozen=True, slots=True, eq=False)
class Acceptance:
    """Which rolling balls a pocket accepts; ``print`` it for a table.

    Attributes:
        pocket: The pocket's name.
        speed: Speeds at the start, m/s, shape (n_speeds,).
        angle: Angles to the pocket's axis, rad, shape (n_angles,).
        offset: Offsets of the line from the mouth's centre, m, shape (n_offsets,).
        distance: Distance from the start to the mouth's centre, m.
        accepted: 1 where the ball falls without leaving the pocket first, 0 where it does not, −1
            where there is no room for it at the start; int8 of shape (n_speeds, n_angles,
            n_offsets).
    """

    pocket: str
    speed: NDArray[np.float64]
    angle: NDArray[np.float64]
    offset: NDArray[np.float64]
    distance: float
    accepted: NDArray[np.int8]

    @property
    def width(self) -> NDArray[np.float64]:
        """Width of the accepted offsets, m, shape (n_speeds, n_angles)."""
        step = np.ptp(self.offset) / (len(self.offset) - 1) if len(self.offset) > 1 else 0.0
        width: NDArray[np.float64] = (self.accepted == 1).sum(axis=2) * step
        return width

    def __str__(self) -> str:
        lines = [
            f"accepted width of {self.pocket}, mm, by angle to its axis (degrees) and speed",
            " angle" + "".join(f"{f'{speed:g} m/s':>10}" for speed in self.speed.tolist()),
        ]
        for angle, widths in zip(self.angle.tolist(), self.width.T.tolist(), strict=True):
            lines.append(
                f"{math.degrees(angle):6.1f}" + "".join(f"{1e3 * width:10.0f}" for width in widths)
            )
        return "\n".join(lines)


def pot_map(
    shot: carom.Shot,
    ball: str,
    pocket: str,
    *,
    noise: Noise | None = None,
    perception: Perception | None = None,
    columns: int = 32,
    n: int = 200,
    precision: float | None = None,
    posterior: TablePosterior | None = None,
    draws: int = 32,
    seed: int = 0,
    level: float = 0.95,
    threads: int | None = None,
    progress: bool = False,
) -> PotMap:
    """The chance of a straight pot with the cue ball anywhere on the table.

    Speed and spin are those of the shot's strike, and so is the elevation; if the shot omits it, it
    is the default at every place. For every place of the cue ball the direction is refined until it
    pots exactly, including throw and squirt, and turned to the middle of the directions that pot.
    Then ``n`` variants are played.

    Args:
        shot: Table, balls and strike.
        ball: The object ball.
        pocket: The pocket.
        noise: Errors of the strike; the Olympiad's if None.
        perception: Errors of the perceived positions, as in ``Shot.evaluate``.
        columns: Number of cells along the width, at most 2048; the cells are square.
        n: Largest number of variants of each cell, with the same errors in all cells.
        precision: Stop counting in a cell when half the width of its interval is at most this;
            checked after every 128 variants. None plays all ``n``.
        posterior: What is known about the table, as in ``Shot.evaluate``. The aim is
            refined on the learned table in place of the shot's; the variants are played on the
            drawn tables. A place without room on one of them has no chance.
        draws: Number of tables that may be the true one, from 2 to 1000.
        seed: Seed of the random numbers.
        level: Confidence level of the intervals, in (0, 1).
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball or pocket, no strike, a number is out of range, or balls
            other than the cue ball have no room on most drawn tables.
    """
    where = (ball_index(shot, ball), pocket_index(shot, pocket))
    columns = whole("columns", columns, _MOST_COLUMNS + 1, low=1)
    sampling = Sampling(noise, perception, seed, whole("n", n, low=1), precision, level)
    shot, tables = on_drawn_tables(shot, posterior, draws, sampling.n, sampling.seed)
    width, length = core_of(shot).geometry()["size"]
    if width is None or length is None:
        raise InputError(
            "unsupported", "table", "the cloth has no cushions", "choose a table with cushions"
        )
    rows = max(1, round(columns * length / width))
    with stage_bars(["cells"], show=progress) as report:
        chance, low, high, counted, azimuth = _core.pot_map(
            core_of(shot), where, (columns, rows), sampling, tables, thread_count(threads), report
        )
    return PotMap(
        shot=shot,
        ball=ball,
        pocket=pocket,
        x=(np.arange(columns) + 0.5) * width / columns,
        y=(np.arange(rows) + 0.5) * length / rows,
        chance=chance,
        low=low,
        high=high,
        n=counted,
        azimuth=azimuth,
    )


def position_map(
    shot: carom.Shot,
    ball: str,
    pocket: str,
    *,
    speed: ArrayLike,
    height: ArrayLike = 0.0,
    side: ArrayLike = 0.0,
    threads: int | None = None,
    progress: bool = False,
) -> PositionMap:
    """Where the cue ball ends for each speed and spin that pots a ball, without noise.

    Args:
        shot: Table, balls and the struck ball.
        ball: The object ball.
        pocket: The pocket.
        speed: The cue's speeds, m/s, in (0, 50]; shape (n_speeds,).
        height: Contact points above centre, ball radii; broadcast against ``side``. Strikes past
            the miscue limit are NaN in the result; contact points off the ball are refused.
        side: Contact points right of centre, ball radii.
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball or pocket, a number is out of range, the shapes do not
            broadcast, or there are more than ten million cells.
    """
    where = (ball_index(shot, ball), pocket_index(shot, pocket))
    speeds = flat("speed", speed)
    try:
        sides, heights = np.broadcast_arrays(flat("side", side), flat("height", height))
    except ValueError:
        raise InputError(
            "wrong-count", "side, height", "shapes do not broadcast", "make them agree"
        ) from None
    spins = np.stack([sides, heights], axis=1).tolist()
    with stage_bars(["strikes"], show=progress) as report:
        falls, azimuth, end = _core.position_map(
            core_of(shot), where, speeds.tolist(), spins, thread_count(threads), report
        )
    return PositionMap(shot, ball, pocket, speeds, sides, heights, falls, azimuth, end)


def acceptance(
    shot: carom.Shot,
    pocket: str,
    *,
    speed: ArrayLike = (0.5, 1.0, 2.0, 4.0),
    angle: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    distance: float = 0.3,
    threads: int | None = None,
    progress: bool = False,
) -> Acceptance:
    """Which rolling balls a pocket accepts.

    Args:
        shot: Table and physics; its balls are not used.
        pocket: The pocket.
        speed: Speeds at the start, m/s, in (0, 100].
        angle: Angles to the pocket's axis, rad, from −π to π; None is −60° to 60° in steps of 1°.
        offset: Offsets of the line from the mouth's centre, m, positive to the right along the
            line; None is −80 to 80 mm in steps of 1 mm.
        distance: Distance from the start to the mouth's centre, m, at most the table's diagonal.
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such pocket, a number is out of range, or there are more than ten
            million cells.
    """
    index = pocket_index(shot, pocket)
    speeds = flat("speed", speed)
    angles = flat("angle", np.radians(np.arange(-60, 61)) if angle is None else angle)
    offsets = flat("offset", np.arange(-80, 81) * 1e-3 if offset is None else offset)
    reach = number("distance", distance)
    with stage_bars(["balls"], show=progress) as report:
        accepted = _core.acceptance(
            core_of(shot),
            index,
            speeds.tolist(),
            angles.tolist(),
            offsets.tolist(),
            reach,
            thread_count(threads),
            report,
        )
    return Acceptance(pocket, speeds, angles, offsets, reach, accepted)
