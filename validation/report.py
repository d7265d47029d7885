"""`carom validate`: finds the papers, compares every row and prints the result."""

from __future__ import annotations

import importlib
import pkgutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TextIO

from carom.validation.row import Comparison, Kind, Row, rows_of

if TYPE_CHECKING:
    from collections.abc import Iterable


class Count(NamedTuple):
    """How many numbers there are, how many of them are outside their tolerance, and how many are
    computed with an unmodified preset.
    """

    numbers: int = 0
    outside: int = 0
    preset: int = 0


#: Counts by whether the numbers must agree, and by kind.
Tally = dict[tuple[bool, Kind], Count]


def papers() -> list[str]:
    """The names of the papers, which are the names of their folders."""
    here = Path(__file__).parent
    return sorted(m.name for m in pkgutil.iter_modules([str(here)]) if m.ispkg)


def rows(paper: str) -> list[Row]:
    """The rows of one paper.

    Raises:
        ValueError: there is no such paper.
    """
    known = papers()
    if paper not in known:
        raise ValueError(f"there is no paper {paper!r}; there are: {', '.join(known)}")
    return rows_of(importlib.import_module(f"carom.validation.{paper}.rows"))


def verdict(row: Row, comparison: Comparison) -> str:
    """The result of one comparison in a word or two."""
    if row.must_agree:
        return "pass" if comparison.agrees else "FAIL"
    return "shown, within" if comparison.agrees else "shown, outside"


def add(tally: Tally, row: Row, outside: int) -> None:
    """Counts the numbers of a row, `outside` of which are outside their tolerance."""
    key = (row.must_agree, row.kind)
    before = tally.get(key, Count())
    numbers = len(row.reference)
    tally[key] = Count(
        before.numbers + numbers,
        before.outside + outside,
        before.preset + numbers * row.uses_preset,
    )


def declared(names: Iterable[str]) -> Tally:
    """The counts that the rows of some papers declare, without computing anything.

    The test of each row checks that the row is as declared.
    """
    tally: Tally = {}
    for paper in names:
        for row in rows(paper):
            add(tally, row, 0 if row.must_agree else len(row.misses))
    return tally


def summary(tally: Tally) -> str:
    """The counts by kind, and their sums.

    A number that is compared in several cases (speeds, frictions) counts once for each.
    """
    lines = []
    for must_agree, heading in ((True, "Must agree:"), (False, "Shown only:")):
        found = [(kind, tally[must_agree, kind]) for kind in Kind if (must_agree, kind) in tally]
        if not found:
            continue
        lines.append(heading)
        lines += [
            f"{count.numbers:>6}  {kind.value}"
            + (f" ({count.outside} outside the tolerance)" if count.outside else "")
            for kind, count in found
        ]
    return "\n".join([*lines, "", *_totals(tally)])


def _totals(tally: Tally) -> list[str]:
    """The sums over all kinds."""
    published = sum(c.numbers for (_, k), c in tally.items() if k.is_published_and_computed)
    checked = [count for (must_agree, _), count in tally.items() if must_agree]
    sourced = [c for (must_agree, k), c in tally.items() if must_agree and k.is_from_a_source]
    shown = [count for (must_agree, _), count in tally.items() if not must_agree]
    lines = [
        f"{published} numbers are published and computed by the engine",
        f"{sum(c.numbers for c in checked)} numbers must agree, "
        f"{sum(c.outside for c in checked)} failed",
        f"{sum(c.preset for c in sourced)} of the {sum(c.numbers for c in sourced)} numbers from a "
        "source that must agree are computed with an unmodified preset",
    ]
    if shown:
        lines.append(
            f"{sum(c.numbers for c in shown)} numbers are shown only, "
            f"{sum(c.outside for c in shown)} outside their tolerance"
        )
    return lines


def run(name: str | None = None, out: TextIO | None = None) -> int:
    """Prints every row of one paper or of all: reference, ours, difference and tolerance.

    Args:
        name: a paper's folder name; None for every paper.
        out: where to print; standard output by default.

    Returns:
        The exit code: 0 if every number that must agree does, 1 otherwise.

    Raises:
        ValueError: there is no such paper.
    """
    out = sys.stdout if out is None else out
    tally: Tally = {}
    for paper in papers() if name is None else [name]:
        print(f"\n{paper}", file=out)
        for row in rows(paper):
            comparisons = row.compare()
            add(tally, row, sum(not c.agrees for c in comparisons))
            print(f"\n  {row.id}  {row.title}  [{row.unit}]  ({row.source})", file=out)
            print(f"    {row.kind.value}", file=out)
            for c in comparisons:
                print(
                    f"    {c.label:<34} {c.printed_reference:>12}  {c.ours:>14.8g}"
                    f"  {c.difference:>+11.2e}  ± {c.tolerance!s:<8}  {verdict(row, c)}",
                    file=out,
                )
            if row.note:
                print(f"    {row.note}", file=out)
    print(f"\n{summary(tally)}", file=out)
    return int(any(count.outside for (must_agree, _), count in tally.items() if must_agree))
