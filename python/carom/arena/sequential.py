"""Sequential tests of which of two players is stronger."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Self

from carom import _core
from carom.arguments import numbers, text
from carom.errors import InputError

# Usual probability of a wrong decision, for each hypothesis.
_ERROR_RATE = 0.05
# Elo points for a tenfold of the odds to win (Elo 1978).
_ELO_DECADE = 400.0
#: The units of hypotheses, and what they are called in a text.
UNITS = {"shares": "", "nelo": " normalised Elo"}


@dataclass(frozen=True, slots=True)
class TestResult:
    """The state of a sequential test after the pairs so far.

    Attributes:
        p0: The null hypothesis, in ``unit``.
        p1: The alternative.
        llr: The log-likelihood ratio.
        lower: At or below this ratio the test accepts ``p0``.
        upper: At or above this ratio the test accepts ``p1``.
        accepted: ``"p0"`` or ``"p1"``; None if play has to go on.
        unit: What ``p0`` and ``p1`` are: ``"shares"``, expected shares of the points of the first
            player; or ``"nelo"``, differences of normalised Elo.
    """

    p0: float
    p1: float
    llr: float
    lower: float
    upper: float
    accepted: str | None
    unit: str = "shares"

    # The name begins with Test, so pytest would collect the class.
    __test__ = False

    @property
    def hypotheses(self) -> str:
        """The two hypotheses in words."""
        return f"{self.p0:g} against {self.p1:g}{UNITS[self.unit]}"

    @property
    def state(self) -> str:
        """Whether the test is decided, in words."""
        if self.accepted is None:
            return "undecided"
        return f"accepts {getattr(self, self.accepted):g}"

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        names = ("p0", "p1", "unit", "llr", "lower", "upper", "accepted")
        return {name: getattr(self, name) for name in names}

    def __str__(self) -> str:
        return (
            f"test of {self.hypotheses}: {self.state}, "
            f"log-likelihood ratio {self.llr:.2f} in {self.lower:.2f} to {self.upper:.2f}"
        )


@dataclass(frozen=True, slots=True)
class SequentialTest:
    """A test of two hypotheses on how strong the first player of a match is.

    Play goes on until the log-likelihood ratio of the pairs of frames decides. It is the
    generalized sequential probability ratio test of chess engines (docs/arena.md, Statistics).

    Normalised Elo is (800/ln 10)·(s − ½)/(√2·σ), where s is the expected share of the points and σ
    the standard deviation of a pair's share. √2·σ is that of a frame, if the frames of a pair are
    independent. The definition and the scale are those of fishtest (M. Van den Bergh, *Normalized
    Elo in practice*; ``server/fishtest/stats/LLRcalc.py``, ``LLR_normalized_alt``). For small
    differences between players who never draw it equals Elo; its advantage is that a test of given
    bounds takes about the same number of pairs for every game, noise and advantage of the breaker.

    Args:
        p0: The null hypothesis, in ``unit``.
        p1: The alternative, which is larger.
        unit: ``"shares"``: expected shares of the points, in (0, 1). ``"nelo"``: differences of
            normalised Elo, in (-2000, 2000).
        alpha: Probability of accepting ``p1`` if ``p0`` is true, in (0, ½).
        beta: Probability of accepting ``p0`` if ``p1`` is true, in (0, ½).

    Raises:
        InputError: A value is out of range, or the unit is unknown.
    """

    p0: float
    p1: float
    unit: str = "shares"
    alpha: float = _ERROR_RATE
    beta: float = _ERROR_RATE

    def __post_init__(self) -> None:
        numbers("test", (self.p0, self.p1, self.alpha, self.beta), 4)
        text("test.unit", self.unit, '"shares" or "nelo"')
        self.state([0] * 5)

    @classmethod
    def of_elo(cls, elo0: float, elo1: float) -> Self:
        """A test of two differences of Elo ratings, as one of the shares that they belong to."""
        low, high = numbers("test", (elo0, elo1), 2)
        p0, p1 = (1 / (1 + 10 ** (-elo / _ELO_DECADE)) for elo in (low, high))
        return cls(p0, p1)

    @classmethod
    def read(cls, test: SequentialTest | Sequence[float] | None) -> SequentialTest | None:
        """The argument ``test`` of a match: a test, two shares of the points, or None."""
        if test is None or isinstance(test, SequentialTest):
            return test
        p0, p1 = numbers("test", test, 2)
        return cls(p0, p1)

    @classmethod
    def of_record(cls, written: dict[str, Any]) -> Self:
        """The test in the header of a record."""
        return cls(**written)

    def to_dict(self) -> dict[str, Any]:
        """The test as the header of a record has it. A test of shares has no unit there."""
        unit = {} if self.unit == "shares" else {"unit": self.unit}
        return {"p0": self.p0, "p1": self.p1, "alpha": self.alpha, "beta": self.beta, **unit}

    def state(self, pair_counts: Sequence[int]) -> TestResult:
        """The state of the test after these pairs.

        Args:
            pair_counts: Number of pairs in which the first player has 0, ½, 1, 1½ and 2 points.

        Raises:
            InputError: There are not five counts.
        """
        if len(pair_counts) != 5:
            raise InputError(
                "wrong-count",
                "pair_counts",
                f"{len(pair_counts)} values",
                "give the number of pairs with 0, ½, 1, 1½ and 2 points",
            )
        fields = _core.test_state(
            list(pair_counts), self.p0, self.p1, self.alpha, self.beta, self.unit
        )
        return self.result(fields)

    def result(self, fields: dict[str, Any]) -> TestResult:
        """The state from its values in Rust."""
        return TestResult(self.p0, self.p1, **fields, unit=self.unit)


def rating(elo: float) -> str:
    """A difference of ratings with its sign."""
    if math.isinf(elo):
        return "+∞" if elo > 0 else "−∞"
    # The whole number has no −0.
    return f"{round(elo):+d}"
