"""Statistics of many breaks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core, columns
from carom.arguments import number, text, thread_count, whole
from carom.batch import BatchResult
from carom.build import opening
from carom.lazy import np
from carom.noise import Noise
from carom.plan.chance import Chance, chances_to_dict
from carom.plan.options import Sampling
from carom.progress import stage_bars

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Most racks of one call. A million snooker racks hold about 600 MB.
_MOST_RACKS = 10**6


@dataclass(frozen=True, slots=True, eq=False)
class BreakStatistics:
    """The results of many breaks; ``print`` it for a table.

    Attributes:
        game: The game's name.
        ids: The balls' ids, the cue ball first.
        pockets: The pockets' names.
        level: Confidence level of the intervals.
        racks: Number of breaks.
        potted: Number of object balls that fell in each break, int64 of shape (racks,).
        result: The end of every break, as ``simulate_batch`` returns it.
        counts: Number of breaks with each result, by the names of ``chances``.
    """

    game: str
    ids: tuple[str, ...]
    pockets: tuple[str, ...]
    level: float
    racks: int
    potted: NDArray[np.int64]
    result: BatchResult
    counts: dict[str, int]

    def chances(self) -> dict[str, Chance]:
        """The chance of every result, by name."""
        return {
            what: Chance.of(count, self.racks, self.level) for what, count in self.counts.items()
        }

    @property
    def half_width(self) -> float:
        """Half the width of the widest interval."""
        return max(chance.half_width for chance in self.chances().values())

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "game": self.game,
            "racks": self.racks,
            "level": self.level,
            "potted": np.bincount(self.potted).tolist(),
            "chances": chances_to_dict(self.chances()),
        }

    def __str__(self) -> str:
        rows = [(what, str(chance)) for what, chance in self.chances().items()]
        shares = np.bincount(self.potted) / max(1, self.racks)
        fell = ", ".join(f"{count}: {100 * s:.1f} %" for count, s in enumerate(shares))
        mean = self.potted.mean() if self.racks else float("nan")
        title = (
            f"{self.racks} breaks of {self.game}; intervals at {100 * self.level:g} % confidence"
        )
        lines = [title, f"  balls that fall: {mean:.2f} on average; {fell}"]
        return "\n".join([*lines, *(f"  {line}" for line in columns.lines(rows))])


def break_statistics(
    game: str = "nine-ball",
    racks: int = 1000,
    *,
    noise: Noise | None = None,
    table: str | None = None,
    speed: float | None = None,
    gap: float | None = None,
    preset: str | None = None,
    precision: float | None = None,
    seed: int = 0,
    level: float = 0.95,
    threads: int | None = None,
    progress: bool = False,
) -> BreakStatistics:
    """Break many racks, each racked and struck a little differently.

    Args:
        game: The game, as for ``break_shot``.
        racks: Largest number of breaks.
        noise: Errors of the strikes; the Olympiad's if None.
        table: A preset's name; the game's own table if None. A game with pockets needs a table
            with pockets.
        speed: The cue's speed, m/s; the game's usual one if None.
        gap: Mean gap between the balls, m; None is the preset's, or the usual 0.1 mm.
        preset: How players open the game, as for ``break_shot``.
        precision: Stop when half the width of every interval is at most this; checked after every
            1024 racks. None breaks all ``racks``.
        seed: Seed of the first rack; the others have the following seeds.
        level: Confidence level of the intervals, in (0, 1).
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: There is no such game or table, they do not fit together, or a number is out
            of range.
    """
    racks = whole("racks", racks, _MOST_RACKS + 1, low=1)
    sampling = Sampling(noise, None, seed, racks, precision, level)
    first = opening(game, table=table, speed=speed, seed=seed, gap=gap, preset=preset)
    ids = tuple(first.ids)
    pockets = tuple(pocket["name"] for pocket in first.geometry()["pockets"])
    with stage_bars(["racks"], show=progress) as report:
        arrays, counts = _core.break_statistics(
            text("game", game),
            preset,
            table,
            None if speed is None else number("speed", speed),
            None if gap is None else number("gap", gap),
            sampling,
            thread_count(threads),
            report,
        )
    result = BatchResult(*arrays)
    potted: NDArray[np.int64] = (result.pocket[:, 1:] >= 0).sum(axis=1, dtype=np.int64)
    named = dict(_named(counts, ids, pockets))
    return BreakStatistics(game, ids, pockets, sampling.level, len(result), potted, result, named)


def _named(
    counts: dict[str, Any], ids: tuple[str, ...], pockets: tuple[str, ...]
) -> Iterator[tuple[str, int]]:
    """The counts from Rust with the names of ``BreakStatistics.chances``."""
    yield "a ball falls", counts["any_potted"]
    yield "a ball falls, no scratch", counts["any_potted_without_scratch"]
    yield "scratch", counts["scratched"]
    yield "a ball off the table", counts["any_off_table"]
    potted = dict(zip(ids, counts["ball_potted"], strict=True))
    # Sorted by the balls' numbers: the rack's order is another one.
    for ball in sorted(ids[1:], key=lambda ball: (len(ball), ball)):
        yield f"{ball} falls", potted[ball]
    for name, count in zip(pockets, counts["pocket_used"], strict=True):
        yield f"something into {name}", count
