"""A row: one published result, and the function that asks the engine for it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from types import ModuleType

Status = Literal["R", "P", "r", "D", "M", "F"]

#: What each status means, in the order of how hard it binds.
STATUS_MEANING: Mapping[Status, str] = {
    "R": "published number, read and recomputed",
    "P": "published formula, number computed from it",
    "r": "published number, read only",
    "D": "derived from the model",
    "M": "measured in the real world",
    "F": "read off a figure",
}

#: Measurements are shown, not held: no model hits them all, and the page says which it misses.
SHOWN: frozenset[str] = frozenset({"M", "F"})


@dataclass(frozen=True)
class Range:
    """A published interval, ends included."""

    low: float
    high: float

    def __str__(self) -> str:
        if math.isinf(self.high):
            return f"≥ {self.low:g}"
        return f"{self.low:g} … {self.high:g}"


Published = float | Range


@dataclass(frozen=True)
class Tolerance:
    """How far from the published number is still the published number."""

    size: float
    is_relative: bool = False

    def allowed(self, published: Published) -> float:
        """The largest difference allowed, in the row's unit."""
        if isinstance(published, Range):
            return 0.0
        return self.size * abs(published) if self.is_relative else self.size

    def __str__(self) -> str:
        if not self.is_relative:
            return f"{self.size:g}"
        return f"{100 * self.size:g} %" if self.size >= 1e-6 else f"{self.size:g} of it"


def absolute(size: float) -> Tolerance:
    """A tolerance in the row's own unit."""
    return Tolerance(size)


def relative(size: float) -> Tolerance:
    """A tolerance as a fraction of the published number."""
    return Tolerance(size, is_relative=True)


@dataclass(frozen=True)
class Comparison:
    """One number of a row beside ours."""

    label: str
    published: Published
    ours: float
    tolerance: Tolerance

    @property
    def difference(self) -> float:
        """Ours − published; from the nearer end of a range, 0 inside it."""
        if isinstance(self.published, Range):
            return self.ours - min(max(self.ours, self.published.low), self.published.high)
        return self.ours - self.published

    @property
    def agrees(self) -> bool:
        """Whether the difference is within the tolerance (never for NaN)."""
        return abs(self.difference) <= self.tolerance.allowed(self.published)


@dataclass(frozen=True)
class Row:
    """One published result.

    `tolerance` may be a tuple, which is then repeated over the numbers: throw, cut, throw, cut …
    `published` maps a label for each number to the number, in `unit`. `compute` returns ours in
    the same order; it goes through the public API of the engine, except where `formula_only`
    says that the row belongs to a model that the engine does not have. `rule_unknown` says that
    the number rests on a rule that was not published with it: it is shown as a measurement is.
    `misses` names the labels at which the default parameters are known to miss what is shown;
    `note` says why.
    """

    id: str
    title: str
    unit: str
    source: str
    status: Status
    published: Mapping[str, Published]
    tolerance: Tolerance | tuple[Tolerance, ...]
    compute: Callable[[], Sequence[float]]
    formula_only: bool = False
    rule_unknown: bool = False
    misses: tuple[str, ...] = ()
    note: str = ""

    @property
    def held(self) -> bool:
        """Whether the engine must match; measurements are only shown."""
        return self.status not in SHOWN and not self.rule_unknown

    def compare(self) -> list[Comparison]:
        """Asks the engine, and puts its numbers beside the published ones."""
        ours = self.compute()
        if len(ours) != len(self.published):
            raise ValueError(
                f"{self.id}: {len(self.published)} published numbers, {len(ours)} of ours"
            )
        tolerances = self.tolerance if isinstance(self.tolerance, tuple) else (self.tolerance,)
        return [
            Comparison(label, published, float(our), tolerances[i % len(tolerances)])
            for i, ((label, published), our) in enumerate(
                zip(self.published.items(), ours, strict=True)
            )
        ]

    def __str__(self) -> str:
        return f"{self.id}: {self.title}"


def row(
    id: str,  # noqa: A002 -- the table's own word
    title: str,
    *,
    unit: str,
    source: str,
    status: Status,
    published: Mapping[str, Published],
    tolerance: Tolerance | tuple[Tolerance, ...] = Tolerance(0.0),
    formula_only: bool = False,
    rule_unknown: bool = False,
    misses: tuple[str, ...] = (),
    note: str = "",
) -> Callable[[Callable[[], Sequence[float]]], Row]:
    """Makes a `Row` of the function that computes our numbers."""

    def declare(compute: Callable[[], Sequence[float]]) -> Row:
        return Row(
            id=id,
            title=title,
            unit=unit,
            source=source,
            status=status,
            published=published,
            tolerance=tolerance,
            compute=compute,
            formula_only=formula_only,
            rule_unknown=rule_unknown,
            misses=misses,
            note=note,
        )

    return declare


def rows_of(module: ModuleType) -> list[Row]:
    """The rows that a module declares, in order."""
    return [value for value in vars(module).values() if isinstance(value, Row)]


def check(a_row: Row) -> None:
    """The test of a row: raises `AssertionError` where it does not hold.

    A held row agrees everywhere. A measurement disagrees exactly where its `misses` says so, so
    that the page stays true when a default changes.
    """
    comparisons = a_row.compare()
    outside = tuple(c.label for c in comparisons if not c.agrees)
    expected = () if a_row.held else a_row.misses
    lines = [f"{c.label}: published {c.published}, ours {c.ours:.10g}" for c in comparisons]
    assert outside == expected, "\n".join(
        [f"{a_row} ({a_row.source}): outside {outside}, expected outside {expected}", *lines]
    )
