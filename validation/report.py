"""`carom validate`: finds the papers, compares every row, prints the table."""

from __future__ import annotations

import importlib
import pkgutil
import sys
from pathlib import Path
from typing import TextIO

from carom.validation.row import Comparison, Row, rows_of


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
        raise ValueError(f"no paper is called {paper!r}; there are: {', '.join(known)}")
    return rows_of(importlib.import_module(f"carom.validation.{paper}.rows"))


def verdict(row: Row, comparison: Comparison) -> str:
    """One word for one number."""
    if row.held:
        return "pass" if comparison.agrees else "FAIL"
    return "shown, within" if comparison.agrees else "shown, outside"


def run(name: str | None = None, out: TextIO | None = None) -> int:
    """Prints published, ours, difference and tolerance of every row of one paper or of all.

    Args:
        name: a paper's folder name; None for every paper.
        out: where to print; standard output by default.

    Returns:
        The exit code: 0 if every held row agrees, 1 if one does not.

    Raises:
        ValueError: there is no such paper.
    """
    out = sys.stdout if out is None else out
    held = failed = shown = outside = 0
    for paper in papers() if name is None else [name]:
        print(f"\n{paper}", file=out)
        for row in rows(paper):
            print(
                f"\n  {row.id}  {row.title}  [{row.unit}]  ({row.source}; {row.status})", file=out
            )
            for c in row.compare():
                word = verdict(row, c)
                print(
                    f"    {c.label:<34} {c.published!s:>12}  {c.ours:>14.8g}"
                    f"  {c.difference:>+11.2e}  ± {c.tolerance!s:<8}  {word}",
                    file=out,
                )
                if row.held:
                    held += 1
                    failed += not c.agrees
                else:
                    shown += 1
                    outside += not c.agrees
            if row.formula_only:
                print("    (formula only: the engine has no such model)", file=out)
            if row.note:
                print(f"    {row.note}", file=out)
    print(
        f"\n{held} numbers held, {failed} failed; "
        f"{shown} measurements shown, {outside} outside their tolerance",
        file=out,
    )
    return 1 if failed else 0
