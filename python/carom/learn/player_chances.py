"""Chances of a shot for a player whose errors are known by draws."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import columns
from carom.arguments import whole
from carom.errors import InputError
from carom.lazy import np
from carom.noise import Noise
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.rules import Frame

    Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ChanceOfDraws:
    """A probability that is itself uncertain.

    Attributes:
        draws: The probability under each draw, shape (n,).
    """

    draws: Floats

    @property
    def mean(self) -> float:
        """The probability that it happens, all draws together."""
        return float(self.draws.mean())

    @property
    def interval(self) -> tuple[float, float]:
        """The interval of 90 % of the probability."""
        low, high = np.quantile(self.draws, (0.05, 0.95))
        return float(low), float(high)

    def __float__(self) -> float:
        return self.mean

    def __str__(self) -> str:
        low, high = self.interval
        return f"{100 * self.mean:.1f} % ({100 * low:.1f} to {100 * high:.1f})"


@dataclass(frozen=True, slots=True, eq=False)
class PlayerChances:
    """The chances of a shot's results; ``print`` it for a table.

    Attributes:
        n: Number of variants for each draw.
        chances: The chance of each result that occurred, with the names of ``Evaluation.chances``.
    """

    n: int
    chances: dict[str, ChanceOfDraws]

    def __getitem__(self, name: str) -> ChanceOfDraws:
        """The chance of a result; 0 if it occurred under no draw."""
        if name in self.chances:
            return self.chances[name]
        count = len(next(iter(self.chances.values())).draws) if self.chances else 1
        return ChanceOfDraws(np.zeros(count))

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "n": self.n,
            "chances": {
                name: {"mean": c.mean, "low": c.interval[0], "high": c.interval[1]}
                for name, c in self.chances.items()
            },
        }

    def __str__(self) -> str:
        rows = [(name, str(chance)) for name, chance in self.chances.items()]
        title = f"{self.n} variants a draw; intervals of 90 % for what is not known of the player"
        return "\n".join([title, *(f"  {line}" for line in columns.lines(rows))])


def chances_of(
    draw: Callable[[float], list[Noise]],
    shot: Shot | Sequence[Shot],
    n: int,
    draws: int,
    seed: int,
    frame: Frame | None,
    threads: int | None,
) -> PlayerChances:
    """As ``PlayerPosterior.evaluate``; ``draw`` gives the drawn noises at an intended speed."""
    shots = [shot] if isinstance(shot, Shot) else list(shot)
    if not shots:
        raise InputError("wrong-count", "shot", "there is none", "give at least one")
    count = whole("draws", draws, low=1)
    found: dict[str, Floats] = {}
    noises: dict[float, list[Noise]] = {}
    for index in range(count):
        one = shots[index % len(shots)]
        speed = one.speed
        if speed is None:
            raise InputError("no-strike", "strike", "the shot has no strike", "give it one")
        if speed not in noises:
            noises[speed] = draw(speed)
        result = one.evaluate(noises[speed][index], n, seed, frame=frame, threads=threads)
        for name, chance in result.chances().items():
            found.setdefault(name, np.zeros(count))[index] = chance.probability
    return PlayerChances(n, {name: ChanceOfDraws(values) for name, values in found.items()})
