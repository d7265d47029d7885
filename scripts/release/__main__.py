"""Build every file of a release twice, check it, and write what goes beside it, into ``dist/``.

    make release

Nothing is published. The report is printed and kept in ``dist/REPORT.txt``.
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from release import audit, checks, install
from release.build import build, clone, differences
from release.papers import write_bills, write_notes, write_sums
from release.report import Check, report
from release.shell import ROOT, CheckError, run

OUT = ROOT / "dist"
WORK = ROOT / "target" / "release-clones"


def main() -> int:
    """Build and check; gives the exit status."""
    if changes := run("git", "status", "--porcelain", "--untracked-files=no"):
        print(f"carom: commit these changes first; a release is a commit:\n{changes}", end="")
        return 2
    version = run("cargo", "pkgid", "-p", "carom").strip().rsplit("#", 1)[1].split("@")[-1]
    failed = report([Check("build", lambda: _built(OUT, WORK / "first"))])
    if failed:
        return failed
    again = Check("reproducible", _reproducible)
    every = (again, *checks.checks(OUT), *audit.CHECKS, *install.checks(OUT))
    with (WORK / "REPORT.txt").open("w", encoding="utf-8") as kept:
        failed = report(every, kept)
    # After the checks, which take the files of the build alone.
    write_bills(OUT, version)
    write_notes(OUT, version)
    shutil.copy(WORK / "REPORT.txt", OUT)
    write_sums(OUT)
    return failed


def _built(out: Path, root: Path) -> str:
    """Build into ``out`` from a clone in ``root``."""
    clone(root)
    build(root, out)
    return f"{len(list(out.iterdir()))} files in {out.name}"


def _reproducible() -> str:
    """A second build in another folder gives the same bytes."""
    again = WORK / "again"
    _built(again, WORK / "second")
    if others := differences(OUT, again):
        raise CheckError(f"two builds differ in {', '.join(others)}")
    return "two builds in two folders give the same bytes"


if __name__ == "__main__":
    sys.exit(main())
