"""Probabilities estimated by counting."""

from __future__ import annotations

import math
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
        low: Lower end of the Wilson interval.
        high: Upper end of the Wilson interval.
    """

    count: int
    trials: int
    low: float
    high: float

    @property
    def probability(self) -> float:
        """The share of the trials in which it happened; NaN without trials."""
        return self.count / self.trials if self.trials else float("nan")

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return (self.high - self.low) / 2

    def __float__(self) -> float:
        return self.probability

    def __str__(self) -> str:
        return f"{100 * self.probability:.1f} % ({100 * self.low:.1f} to {100 * self.high:.1f})"

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


def chances_to_dict(chances: dict[str, Chance]) -> dict[str, dict[str, float]]:
    """Chances as plain values, for JSON."""
    return {
        what: {"probability": float(c), "low": c.low, "high": c.high} for what, c in chances.items()
    }


def or_null(value: Any) -> Any:
    """The same value with None in place of NaN, which JSON does not have."""
    if isinstance(value, list):
        return [or_null(item) for item in value]
    return None if isinstance(value, float) and math.isnan(value) else value
