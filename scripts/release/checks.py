"""Checks of the built files."""

from __future__ import annotations

import tarfile
import tomllib
import zipfile
from collections.abc import Callable
from pathlib import Path

from release.build import published_crates
from release.report import Check
from release.shell import ROOT, CheckError, NotRunError, need, run

GROUP = "pip install --group release"
# What a wheel must have besides the code.
INSIDE = ("carom/web/index.html", "carom/py.typed", "/licenses/LICENSE-MIT", "/sboms/")


def most_bytes() -> float:
    """The largest size of a wheel, bytes."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    return float(project["tool"]["carom"]["wheel-megabytes"]) * 1e6


def checks(out: Path) -> tuple[Check, ...]:
    """The checks of the files in a folder."""

    def of(name: str, find: Callable[[Path], str]) -> Check:
        return Check(name, lambda: find(out))

    return (
        of("sizes", sizes),
        of("contents of the wheels", contents),
        of("stable ABI", stable_abi),
        of("metadata (twine)", twine),
        of("npm package (publint)", publint),
        of("crates build from their packages", crates_build),
        of("interfaces of the crates", interfaces),
        of("workflows", workflows),
    )


def sizes(out: Path) -> str:
    """Every wheel is smaller than its limit."""
    found = {file.name: file.stat().st_size for file in sorted(out.iterdir())}
    most = most_bytes()
    if large := [n for n, size in found.items() if n.endswith(".whl") and size >= most]:
        raise CheckError(f"larger than {most / 1e6:g} MB: {', '.join(large)}")
    return ", ".join(f"{name} {size / 1e6:.2f} MB" for name, size in found.items())


def contents(out: Path) -> str:
    """Every wheel has the page, the types, the licences and its bill of materials, and no tests."""
    for wheel in out.glob("*.whl"):
        names = zipfile.ZipFile(wheel).namelist()
        if lacks := [part for part in INSIDE if not any(part in name for name in names)]:
            raise CheckError(f"{wheel.name} lacks {', '.join(lacks)}")
        if tests := [name for name in names if "/test_" in name]:
            raise CheckError(f"{wheel.name} has {', '.join(tests)}")
    need("check-wheel-contents", GROUP)
    run("check-wheel-contents", "--ignore", "W002", *map(str, out.glob("*.whl")))
    (sdist,) = out.glob("*.tar.gz")
    with tarfile.open(sdist) as packed:
        if not any(name.endswith("python/carom/web/index.html") for name in packed.getnames()):
            raise CheckError(f"{sdist.name} lacks the page")
    return "page, types, licences and bill of materials in each"


def stable_abi(out: Path) -> str:
    """The abi3 wheels use only the stable ABI of CPython 3.11."""
    need("abi3audit", GROUP)
    wheels = [str(wheel) for wheel in out.glob("*-abi3-*.whl")]
    run("abi3audit", "--strict", "--assume-minimum-abi3", "3.11", *wheels)
    return f"{len(wheels)} wheels"


def twine(out: Path) -> str:
    """The metadata that a registry of Python reads."""
    need("twine", GROUP)
    run("twine", "check", "--strict", *map(str, [*out.glob("*.whl"), *out.glob("*.tar.gz")]))
    return "passed"


def publint(out: Path) -> str:
    """The entry points and types of the npm package."""
    (packed,) = out.glob("*.tgz")
    run("npx", "--no-install", "publint", "run", str(packed), "--strict", at=ROOT / "web")
    return "passed"


def crates_build(out: Path) -> str:
    """Every published crate builds from its package alone, as ``cargo publish --dry-run`` does."""
    names = published_crates()
    selected = [part for name in names for part in ("--package", name)]
    run("cargo", "publish", "--dry-run", "--locked", *selected)
    return ", ".join(sorted(file.name for file in out.glob("*.crate")))


def interfaces(_out: Path) -> str:
    """The interfaces of the crates suit the version, compared with the last release."""
    need("cargo-semver-checks", "cargo install --locked cargo-semver-checks")
    tags = run("git", "tag", "--list", "v*", "--sort=-version:refname", "--merged", "HEAD").split()
    if not tags:
        raise NotRunError("there is no earlier release: no tag v*")
    selected = [part for name in published_crates() for part in ("--package", name)]
    run("cargo", "semver-checks", "--baseline-rev", tags[0], *selected)
    return f"compared with {tags[0]}"


def workflows(_out: Path) -> str:
    """The workflows of the hosted CI, by actionlint and zizmor."""
    need("zizmor", GROUP)
    run("zizmor", "--offline", "--min-severity", "medium", ".github/workflows")
    need("actionlint", "go install github.com/rhysd/actionlint/cmd/actionlint@v1.7.12")
    run("actionlint")
    return "passed"
