"""Build every released file from a clone of one commit."""

from __future__ import annotations

import json
import shutil
from itertools import product
from pathlib import Path

from release.shell import ROOT, run

# The platforms of the wheels that are built here. The hosted CI builds those of macOS and Windows.
TARGETS = ("x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu")
# The oldest glibc that Rust supports.
MANYLINUX = "manylinux2014"
# The stable ABI, for every CPython from 3.11 on; and the free-threaded CPython, which has none.
INTERPRETERS = ((), ("--interpreter", "python3.14t"))


def published_crates() -> list[str]:
    """The names of the crates that are published."""
    meta = json.loads(run("cargo", "metadata", "--no-deps", "--format-version", "1"))
    return sorted(p["name"] for p in meta["packages"] if p["publish"] is None)


def clone(to: Path) -> None:
    """A clone of this checkout's commit, without what git ignores."""
    shutil.rmtree(to, ignore_errors=True)
    run("git", "clone", "--quiet", "--no-local", str(ROOT), str(to))
    run("git", "checkout", "--quiet", run("git", "rev-parse", "HEAD").strip(), at=to)


def build(root: Path, out: Path) -> None:
    """Build every file of the clone ``root`` into the folder ``out``.

    Raises:
        CheckError: A build failed.
    """
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    web = root / "web"
    run("npm", "ci", "--no-audit", "--no-fund", "--loglevel=error", at=web)
    run("npm", "run", "--silent", "build", "--", "--logLevel", "warn", at=web)
    shutil.copytree(web / "dist", root / "python" / "carom" / "web")
    for target, interpreter in product(TARGETS, INTERPRETERS):
        options = ("--target", target, "--zig", "--compatibility", MANYLINUX, *interpreter)
        run("bash", "scripts/wheel.sh", str(out), *options, at=root)
    epoch = run("git", "log", "-1", "--format=%ct", at=root).strip()
    run("maturin", "sdist", "--out", str(out), at=root, SOURCE_DATE_EPOCH=epoch)
    run("npm", "pack", "--silent", "--pack-destination", str(out), at=web / "src" / "engine")
    selected = [part for name in published_crates() for part in ("--package", name)]
    run("cargo", "package", "--quiet", "--no-verify", "--locked", *selected, at=root)
    for crate in sorted((root / "target" / "package").glob("*.crate")):
        shutil.copy(crate, out)


def differences(one: Path, two: Path) -> list[str]:
    """The files of two folders that are not the same."""
    names = sorted({file.name for folder in (one, two) for file in folder.iterdir()})
    return [name for name in names if not _same(one / name, two / name)]


def _same(one: Path, two: Path) -> bool:
    return one.is_file() and two.is_file() and one.read_bytes() == two.read_bytes()
