"""A row of the validation: reference numbers, and a function that returns carom's numbers.

The kind of a row says where its reference numbers come from and who computes the other side. Only
the first two kinds are published results that the engine reproduces.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from types import ModuleType


class Kind(Enum):
    """Where a row's reference numbers come from, and who computes the other side."""

    PUBLISHED = "printed in the source; computed by the engine"
    FORMULA = "worked out from the source's formula or equations; computed by the engine"
    READ_BACK = "given to the engine, as a fit or a start, and read back"
    FORMULA_ONLY = "formula on both sides; the engine takes no part"
    DERIVED = "derived or required by us; computed by the engine"
    RANGE = "an inequality or a wide range, not a number"
    STORED = "read from a stored file, not computed now"
    MEASURED = "measured, or estimated from experience"
    FITTED = "measured, and parameters were fitted to it or taken from it"
    UNKNOWN_RULE = "published, but the rule behind it is not"

    @property
    def is_published_and_computed(self) -> bool:
        """Whether the row counts as a published result that the engine reproduces."""
        return self in {Kind.PUBLISHED, Kind.FORMULA}

    @property
    def is_from_a_source(self) -> bool:
        """Whether a source gives the reference numbers, and the parameters were not fitted to
        them.
        """
        return self in {Kind.PUBLISHED, Kind.FORMULA, Kind.MEASURED}

    @property
    def must_agree(self) -> bool:
        """Whether a number outside its tolerance is a failure.

        No model agrees with all measurements, and a number whose rule is unknown cannot be
        reproduced. These are shown, and the page lists those that the default parameters miss.
        """
        return self not in {Kind.MEASURED, Kind.FITTED, Kind.UNKNOWN_RULE}


@dataclass(frozen=True)
class Range:
    """A published interval, ends included."""

    low: float
    high: float

    def __str__(self) -> str:
        if math.isinf(self.high):
            return f"≥ {self.low:g}"
        if math.isinf(self.low):
            return f"≤ {self.high:g}"
        return f"{self.low:g} … {self.high:g}"


Reference = float | Range


@dataclass(frozen=True)
class Tolerance:
    """The largest difference from the reference number that still counts as agreement."""

    size: float
    is_relative: bool = False

    def allowed(self, reference: Reference) -> float:
        """The largest difference allowed, in the row's unit."""
        if isinstance(reference, Range):
            return 0.0
        return self.size * abs(reference) if self.is_relative else self.size

    def __str__(self) -> str:
        if not self.is_relative:
            return f"{self.size:g}"
        return f"{100 * self.size:g} %" if self.size >= 1e-6 else f"{self.size:g} of it"


def absolute(size: float) -> Tolerance:
    """A tolerance in the row's own unit."""
    return Tolerance(size)


def relative(size: float) -> Tolerance:
    """A tolerance as a fraction of the reference number."""
    return Tolerance(size, is_relative=True)


@dataclass(frozen=True)
class Comparison:
    """One reference number of a row beside carom's."""

    label: str
    reference: Reference
    ours: float
    tolerance: Tolerance

    @property
    def printed_reference(self) -> str:
        """The reference number with at most eight digits, or the range."""
        if isinstance(self.reference, Range):
            return str(self.reference)
        return f"{self.reference:.8g}"

    @property
    def difference(self) -> float:
        """Ours − reference. For a range: from its nearer end, and 0 inside it."""
        if isinstance(self.reference, Range):
            return self.ours - min(max(self.ours, self.reference.low), self.reference.high)
        return self.ours - self.reference

    @property
    def agrees(self) -> bool:
        """Whether the difference is within the tolerance (never for NaN)."""
        return abs(self.difference) <= self.tolerance.allowed(self.reference)


@dataclass(frozen=True)
class Row:
    """Reference numbers of one source that belong together.

    `reference` maps a label for each number to the number, in `unit`. `compute` returns carom's
    numbers in the same order, through the engine's public API except where `kind` says otherwise.
    A tuple of tolerances is repeated over the numbers: throw, cut, throw, cut …
    `misses` names the labels at which the default parameters are known to be outside the
    tolerance of a row that is only shown; `note` explains it. `shown_only` marks a row that need
    not agree although rows of its kind must, `held` a row that must agree although rows of its kind
    need not. `uses_preset` marks a row that simulates whole shots or contacts with an unmodified
    preset of the physics; a test compares it with the shots that the row simulates.
    """

    id: str
    title: str
    unit: str
    source: str
    kind: Kind
    reference: Mapping[str, Reference]
    tolerance: Tolerance | tuple[Tolerance, ...]
    compute: Callable[[], Sequence[float]]
    shown_only: bool = False
    held: bool = False
    uses_preset: bool = False
    misses: tuple[str, ...] = ()
    note: str = ""

    @property
    def must_agree(self) -> bool:
        """Whether a number outside its tolerance is a failure."""
        return self.held or (self.kind.must_agree and not self.shown_only)

    def compare(self) -> list[Comparison]:
        """Computes carom's numbers and puts them beside the reference numbers.

        Raises:
            ValueError: `compute` returned another number of values than `reference` has.
        """
        ours = self.compute()
        if len(ours) != len(self.reference):
            raise ValueError(
                f"{self.id}: {len(self.reference)} reference numbers, but {len(ours)} of ours"
            )
        tolerances = self.tolerance if isinstance(self.tolerance, tuple) else (self.tolerance,)
        return [
            Comparison(label, reference, float(our), tolerances[i % len(tolerances)])
            for i, ((label, reference), our) in enumerate(
                zip(self.reference.items(), ours, strict=True)
            )
        ]

    def __str__(self) -> str:
        return f"{self.id}: {self.title}"


def row(
    id: str,  # noqa: A002 -- the word used in the lists of rows
    title: str,
    *,
    unit: str,
    source: str,
    kind: Kind,
    reference: Mapping[str, Reference],
    tolerance: Tolerance | tuple[Tolerance, ...] = Tolerance(0.0),
    shown_only: bool = False,
    held: bool = False,
    uses_preset: bool = False,
    misses: tuple[str, ...] = (),
    note: str = "",
) -> Callable[[Callable[[], Sequence[float]]], Row]:
    """A decorator that turns the function that computes carom's numbers into a `Row`."""

    def declare(compute: Callable[[], Sequence[float]]) -> Row:
        return Row(
            id=id,
            title=title,
            unit=unit,
            source=source,
            kind=kind,
            reference=reference,
            tolerance=tolerance,
            compute=compute,
            shown_only=shown_only,
            held=held,
            uses_preset=uses_preset,
            misses=misses,
            note=note,
        )

    return declare


def rows_of(module: ModuleType) -> list[Row]:
    """The rows that a module declares, in order."""
    return [value for value in vars(module).values() if isinstance(value, Row)]


def check(a_row: Row) -> None:
    """Raises `AssertionError` if a row is not as declared.

    A row that must agree agrees everywhere. A row that is only shown disagrees exactly at the
    labels in its `misses`. So a change of a default parameter that moves a number in or out of its
    tolerance is found.
    """
    comparisons = a_row.compare()
    outside = tuple(c.label for c in comparisons if not c.agrees)
    expected = () if a_row.must_agree else a_row.misses
    lines = [f"{c.label}: reference {c.reference}, ours {c.ours:.10g}" for c in comparisons]
    assert outside == expected, "\n".join(
        [f"{a_row} ({a_row.source}): outside {outside}, expected outside {expected}", *lines]
    )
