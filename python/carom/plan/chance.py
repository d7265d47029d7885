"""Probabilities estimated by counting."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from carom import _core
from carom.arguments import number, whole


@dataclass(frozen=True, slots=True)
class Chance:
    """A probability estimated by counting, with its confidence interval.

    Attributes:
        count: Number of trials in which it happened.
        trials: Number of trials.
        low: Lower end of the Wilson interval. With drawn tables it is that of the probability over
            all tables that may be the true one (docs/evaluate.md).
        high: Upper end.
        by_table: Count and trials on each drawn table; empty without drawn tables.
    """

    count: int
    trials: int
    low: float
    high: float
    by_table: tuple[tuple[int, int], ...] = ()

    @property
    def probability(self) -> float:
        """The share of the trials in which it happened; NaN without trials."""
        return self.count / self.trials if self.trials else float("nan")

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return (self.high - self.low) / 2

    @property
    def shares(self) -> tuple[float, ...]:
        """The probability on each drawn table; NaN for one without trials."""
        return tuple(count / n if n else math.nan for count, n in self.by_table)

    @property
    def spread(self) -> float:
        """Standard deviation of the probability from one possible table to another.

        The variance of counting is taken off. NaN for fewer than two tables, or fewer than two
        trials on each.
        """
        return _core.spread(self.by_table)

    def __float__(self) -> float:
        return self.probability

    def __str__(self) -> str:
        text = f"{100 * self.probability:.1f} % ({100 * self.low:.1f} to {100 * self.high:.1f})"
        return text if math.isnan(self.spread) else f"{text}, tables ± {100 * self.spread:.1f}"

    @classmethod
    def of(cls, count: int, trials: int, level: float) -> Chance:
        """The chance of a result that occurred in ``count`` of ``trials`` trials.

        Args:
            count: Number of trials in which it occurred.
            trials: Number of trials.
            level: Confidence level of the interval, in (0, 1).

        Raises:
            InputError: A number is out of range, or ``count`` exceeds ``trials``.
        """
        trials = whole("trials", trials)
        count = whole("count", count, trials + 1)
        return cls(count, trials, *_core.wilson(count, trials, number("level", level)))

    @classmethod
    def over_tables(cls, by_table: Iterable[tuple[int, int]], level: float) -> Chance:
        """The chance of a result on drawn tables.

        Args:
            by_table: In how many trials it occurred, and the number of trials, for each table.
            level: Confidence level of the interval, in (0, 1).

        Raises:
            InputError: The level is out of range.
        """
        tables = tuple(by_table)
        low, high = _core.clustered(tables, number("level", level))
        return cls(sum(c for c, _ in tables), sum(n for _, n in tables), low, high, tables)

    def to_dict(self) -> dict[str, float]:
        """Plain values, for JSON; ``spread`` with drawn tables."""
        values = {"probability": self.probability, "low": self.low, "high": self.high}
        return values if math.isnan(self.spread) else values | {"spread": self.spread}


def chances_to_dict(chances: dict[str, Chance]) -> dict[str, dict[str, float]]:
    """Chances as plain values, for JSON."""
    return {what: chance.to_dict() for what, chance in chances.items()}


def or_null(value: Any) -> Any:
    """The same value with None in place of NaN, which JSON does not have."""
    if isinstance(value, list):
        return [or_null(item) for item in value]
    return None if isinstance(value, float) and math.isnan(value) else value
