"""Maps: one question asked over a grid, and statistics of breaks. Arrays out."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import flat, number, text, thread_count, whole
from carom.batch import Arrays, BatchResult, in_chunks
from carom.errors import InputError
from carom.noise import Noise, Perception, sigmas_of
from carom.plan import Chance, errs, so_far
from carom.solve import ball_index, pocket_index

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from carom.shot import Shot

# Most cells along one side of a map, and variants of one cell.
_MOST = 10**6
# Cells along the width, of less than a millimetre: more are no map but an empty memory.
_MOST_COLUMNS = 2048
# Racks between two looks at the precision.
_LOOK = 1024


@dataclass(frozen=True, slots=True, eq=False)
class PotMap:
    """The chance of a pot from every place of the cue ball; ``print`` it for a table.

    Attributes:
        shot: The shot whose cue ball is moved.
        ball: The ball that is to fall,
        pocket: and where.
        x: Centres of the cells along the width, m, shape (columns,).
        y: The same along the length, shape (rows,).
        chance: That the ball falls and the cue ball does not, shape (rows, columns); NaN where
            the cue ball cannot lie.
        low: Lower end of its confidence interval, same shape,
        high: and the upper end.
        n: Variants behind it, int64, same shape; 0 where the cue ball cannot lie.
        azimuth: Direction that is aimed at, rad, same shape.
    """

    shot: Shot
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
    """Where the cue ball ends with every speed and spin; ``print`` it for a table.

    Attributes:
        shot: The shot whose strike is changed.
        ball: The ball that is to fall,
        pocket: and where.
        speed: The cue's speeds, m/s, shape (n_speeds,).
        side: Contact points right of centre, ball radii, shape (n_spins,).
        height: Contact points above centre, ball radii, shape (n_spins,).
        falls: Whether the ball falls and the cue ball does not, bool, shape (n_speeds, n_spins).
        azimuth: Direction that does it, rad, same shape; NaN for strikes that cannot be played.
        end: Where the cue ball comes to rest, m, shape (n_speeds, n_spins, 2).
    """

    shot: Shot
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
    """What a pocket takes of the balls that roll at it; ``print`` it for a table.

    Attributes:
        pocket: Its name.
        speed: Speeds at the start, m/s, shape (n_speeds,).
        angle: Angles to the pocket's axis, rad, shape (n_angles,).
        offset: Offsets of the line from the mouth's middle, m, shape (n_offsets,).
        distance: From the start to the mouth's middle, m.
        accepted: 1 where the ball falls without going away first, 0 where it does not, −1 where it
            cannot start; int8 of shape (n_speeds, n_angles, n_offsets).
    """

    pocket: str
    speed: NDArray[np.float64]
    angle: NDArray[np.float64]
    offset: NDArray[np.float64]
    distance: float
    accepted: NDArray[np.int8]

    @property
    def width(self) -> NDArray[np.float64]:
        """How wide the pocket is: the offsets that are taken, m, shape (n_speeds, n_angles)."""
        import numpy as np

        step = np.ptp(self.offset) / (len(self.offset) - 1) if len(self.offset) > 1 else 0.0
        taken: NDArray[np.float64] = (self.accepted == 1).sum(axis=2) * step
        return taken

    def __str__(self) -> str:
        lines = [
            f"how wide {self.pocket} is, mm, by the angle to its axis in degrees and the speed",
            " angle" + "".join(f"{f'{speed:g} m/s':>10}" for speed in self.speed.tolist()),
        ]
        for angle, widths in zip(self.angle.tolist(), self.width.T.tolist(), strict=True):
            lines.append(
                f"{math.degrees(angle):6.1f}" + "".join(f"{1e3 * width:10.0f}" for width in widths)
            )
        return "\n".join(lines)


@dataclass(frozen=True, slots=True, eq=False)
class BreakStatistics:
    """What came of many breaks; ``print`` it for a table.

    Attributes:
        game: Which game.
        ids: The balls' ids, the cue ball first.
        pockets: The pockets' names.
        level: Confidence of all intervals.
        racks: Number of breaks.
        potted: How many object balls fell, int64 of shape (racks,).
        result: The ends of all of them, as ``simulate_batch`` has them.
    """

    game: str
    ids: tuple[str, ...]
    pockets: tuple[str, ...]
    level: float
    racks: int
    potted: NDArray[np.int64]
    result: BatchResult

    def chances(self) -> dict[str, Chance]:
        """What is asked of a break, in words."""
        pocket = self.result.pocket
        said = {
            "a ball falls": (self.potted > 0).sum(),
            "a ball falls, no scratch": ((self.potted > 0) & (pocket[:, 0] < 0)).sum(),
            "scratch": (pocket[:, 0] >= 0).sum(),
            "a ball off the table": (pocket == -2).any(axis=1).sum(),
        }
        # Numbered balls in the order of their numbers, whatever the rack's.
        for ball in sorted(self.ids[1:], key=lambda ball: (len(ball), ball)):
            said[f"{ball} falls"] = (pocket[:, self.ids.index(ball)] >= 0).sum()
        for column, name in enumerate(self.pockets):
            said[f"something into {name}"] = (pocket == column).any(axis=1).sum()
        return {what: Chance.of(int(count), self.racks, self.level) for what, count in said.items()}

    @property
    def half_width(self) -> float:
        """Half the width of the widest of all intervals."""
        return max(chance.half_width for chance in self.chances().values())

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        import numpy as np

        return {
            "game": self.game,
            "racks": self.racks,
            "level": self.level,
            "potted": np.bincount(self.potted).tolist(),
            "chances": {
                what: {"probability": float(c), "low": c.low, "high": c.high}
                for what, c in self.chances().items()
            },
        }

    def __str__(self) -> str:
        import numpy as np

        rows = [(what, str(chance)) for what, chance in self.chances().items()]
        width = max(len(what) for what, _ in rows)
        shares = np.bincount(self.potted) / max(1, self.racks)
        fell = ", ".join(f"{count}: {100 * s:.1f} %" for count, s in enumerate(shares))
        mean = self.potted.mean() if self.racks else float("nan")
        title = f"{self.racks} breaks of {self.game}; intervals hold {100 * self.level:g} %"
        lines = [title, f"  balls that fall: {mean:.2f} on average; {fell}"]
        return "\n".join([*lines, *(f"  {what:<{width}}  {value}" for what, value in rows)])


def pot_map(
    shot: Shot,
    ball: str,
    pocket: str,
    *,
    noise: Noise | None = None,
    perception: Perception | None = None,
    columns: int = 32,
    n: int = 200,
    precision: float | None = None,
    seed: int = 0,
    level: float = 0.95,
    threads: int | None = None,
    progress: bool = False,
) -> PotMap:
    """How likely a straight pot is with the cue ball anywhere on the table.

    Speed and spin are the shot's own. For every place the direction is refined until it pots
    exactly, throw and all, and turned to the middle of what pots; then ``n`` variants are played.

    Args:
        shot: Table, balls and strike.
        ball: The ball that is to fall.
        pocket: Where.
        noise: How far a strike strays; the Olympiad's if None.
        perception: How far from where they are seen the balls truly lie; see ``Shot.evaluate``.
        columns: Cells along the width; the cells are square.
        n: Variants of each cell, with the same errors in all, at most.
        precision: Stop counting in a cell when half its interval's width is at most this; looked at
            after every 128 variants. None plays all ``n``.
        seed: Which random numbers.
        level: Confidence of the intervals.
        threads: How many; None is one per core. Results do not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball or pocket, no strike, or a number is out of range.
    """
    import numpy as np

    where = (ball_index(shot, ball), pocket_index(shot, pocket))
    columns, n = _count("columns", columns, _MOST_COLUMNS), _count("n", n)
    sampling = errs(noise, perception, seed, n, precision, level)
    width, length = shot.geometry()["size"]
    rows = max(1, round(columns * length / width))
    with so_far(rows, show=progress, what="rows") as tell:
        chance, low, high, counted, azimuth = _core.pot_map(
            shot._core, where, (columns, rows), sampling, thread_count(threads), tell
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
    shot: Shot,
    ball: str,
    pocket: str,
    *,
    speed: ArrayLike,
    height: ArrayLike = 0.0,
    side: ArrayLike = 0.0,
    threads: int | None = None,
    progress: bool = False,
) -> PositionMap:
    """Where the cue ball ends when a ball is potted with every speed and spin, hit exactly.

    Args:
        shot: Table, balls, and which ball is struck.
        ball: The ball that is to fall.
        pocket: Where.
        speed: The cue's speeds, m/s.
        height: Contact points above centre, ball radii; broadcast against ``side``.
        side: Contact points right of centre, ball radii.
        threads: How many; None is one per core.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such ball or pocket, or the shapes do not broadcast.
    """
    import numpy as np

    where = (ball_index(shot, ball), pocket_index(shot, pocket))
    speeds = flat("speed", speed)
    try:
        sides, heights = np.broadcast_arrays(flat("side", side), flat("height", height))
    except ValueError:
        raise InputError("side, height: shapes do not broadcast; make them agree") from None
    spins = np.stack([sides, heights], axis=1).tolist()
    with so_far(len(speeds), show=progress, what="speeds") as tell:
        falls, azimuth, end = _core.position_map(
            shot._core, where, speeds.tolist(), spins, thread_count(threads), tell
        )
    return PositionMap(shot, ball, pocket, speeds, sides, heights, falls, azimuth, end)


def acceptance(
    shot: Shot,
    pocket: str,
    *,
    speed: ArrayLike = (0.5, 1.0, 2.0, 4.0),
    angle: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    distance: float = 0.3,
    threads: int | None = None,
    progress: bool = False,
) -> Acceptance:
    """Which balls that roll at a pocket it takes.

    Args:
        shot: Its table and physics count, its balls do not.
        pocket: Which.
        speed: Speeds at the start, m/s.
        angle: Angles to the pocket's axis, rad; None is −60° to 60° by degrees.
        offset: Offsets of the line from the mouth's middle, m, to the right seen along it; None is
            −80 to 80 mm by millimetres.
        distance: From the start to the mouth's middle, m.
        threads: How many; None is one per core.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such pocket, or the distance is not positive.
    """
    import numpy as np

    index = pocket_index(shot, pocket)
    speeds = flat("speed", speed, above=0.0)
    angles = flat("angle", np.radians(np.arange(-60, 61)) if angle is None else angle)
    offsets = flat("offset", np.arange(-80, 81) * 1e-3 if offset is None else offset)
    reach = number("distance", distance)
    with so_far(len(speeds), show=progress, what="speeds") as tell:
        accepted = _core.acceptance(
            shot._core,
            index,
            speeds.tolist(),
            angles.tolist(),
            offsets.tolist(),
            reach,
            thread_count(threads),
            tell,
        )
    return Acceptance(pocket, speeds, angles, offsets, reach, accepted)


def break_statistics(
    game: str = "nine-ball",
    racks: int = 1000,
    *,
    noise: Noise | None = None,
    table: str | None = None,
    speed: float | None = None,
    gap: float | None = None,
    precision: float | None = None,
    seed: int = 0,
    level: float = 0.95,
    threads: int | None = None,
    progress: bool = False,
) -> BreakStatistics:
    """Break many racks, each racked and struck a little otherwise.

    Args:
        game: As for ``break_shot``, like ``table``, ``speed`` and ``gap``.
        racks: How many, at most.
        noise: How far each strike strays; the Olympiad's if None.
        table: A preset's name; the game's own table if None.
        speed: The cue's speed, m/s; the game's usual one if None.
        gap: Mean gap between the balls, m; None is usual (0.1 mm).
        precision: Stop when half the width of every chance's interval is at most this; looked at
            after every 1024 racks. None breaks all ``racks``.
        seed: Of the first rack; the others count on from it.
        level: Confidence of the intervals.
        threads: How many; None is one per core.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such game or table, or a number is out of range.
    """
    import numpy as np

    from carom.racks import break_shot

    sigmas = sigmas_of(noise)
    game, racks, seed = text("game", game), _count("racks", racks), whole("seed", seed)
    speed = None if speed is None else number("speed", speed)
    gap = None if gap is None else number("gap", gap)
    one = break_shot(game, table=table, speed=speed, seed=seed, gap=gap)

    checked = number("level", level)
    Chance.of(0, 1, checked)
    pockets = tuple(p["name"] for p in one.geometry()["pockets"])
    wanted = None if precision is None else number("precision", precision)
    if wanted is not None and not 0 < wanted < 0.5:
        raise InputError(f"precision: {wanted!r} is no half-width; give a number such as 0.01")

    def run(start: int, end: int) -> Arrays:
        return _core.breaks(
            game, table, speed, gap, sigmas, seed, start, end - start, thread_count(threads)
        )

    def statistics(result: BatchResult) -> BreakStatistics:
        fell: NDArray[np.int64] = (result.pocket[:, 1:] >= 0).sum(axis=1, dtype=np.int64)
        return BreakStatistics(game, tuple(one.ids), pockets, checked, len(result), fell, result)

    parts: list[BatchResult] = []
    with so_far(racks, show=progress, what="racks") as tell:
        for start in range(0, racks, _LOOK):
            end = min(start + _LOOK, racks)
            parts.append(_part(run, start, end, len(one.ids)))
            tell(end)
            if wanted is not None and statistics(_joined(parts)).half_width <= wanted:
                break
    return statistics(_joined(parts))


def _part(run: Callable[[int, int], Arrays], start: int, end: int, balls: int) -> BatchResult:
    part = in_chunks(lambda a, b: run(start + a, start + b), end - start, balls, progress=False)
    errors = {start + row: text for row, text in part.errors.items()}
    return replace(part, errors=errors)


def _joined(parts: list[BatchResult]) -> BatchResult:
    import numpy as np

    return BatchResult(
        np.concatenate([part.final_position for part in parts]),
        np.concatenate([part.pocket for part in parts]),
        np.concatenate([part.events for part in parts]),
        {row: text for part in parts for row, text in part.errors.items()},
    )


def _count(name: str, value: int, most: int = _MOST) -> int:
    return whole(name, value, most + 1, low=1)
