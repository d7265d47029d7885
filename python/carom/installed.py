"""What is installed: the engine, the version of its results, the page and the extras."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from carom import _core, page

#: Name and version of the engine, as traces, records and learned tables have them.
ENGINE = f"carom {_core.__version__}"

# Each extra of pyproject.toml, and the modules that it needs.
EXTRAS = {
    "picture": ("matplotlib",),
    "env": ("gymnasium", "pettingzoo"),
    "train": ("stable_baselines3",),
    "import": ("msgpack",),
    "sweep": ("pyarrow",),
    "arena": ("statsmodels",),
    "learn": ("pyarrow",),
    "ray": ("pyarrow", "ray"),
}


def build_info() -> dict[str, Any]:
    """What is installed, to be kept beside results.

    Returns:
        ``engine``: name and version. ``results``: version of the results; two engines with the same
        one compute the same bits (docs/versions.md). ``features`` of the Rust crate. ``vectors``:
        the widest vector instructions that are used here. ``commit``: that of the build, or else
        that of the checkout; None if neither is known. ``page``: whether the page is included.
        ``extras``: those whose packages are installed.
    """
    info: dict[str, Any] = dict(_core.build())
    root = Path(__file__).resolve().parents[2]
    if info["commit"] is None and (root / ".git").exists():
        info["commit"] = commit_of(root)
    info["page"] = page.is_built()
    info["extras"] = [name for name, modules in EXTRAS.items() if all(map(find_spec, modules))]
    return info


def commit_of(checkout: Path, paths: Sequence[str] = (".",)) -> str | None:
    """Short name of a checkout's commit, with ``+`` if tracked files have changes.

    Args:
        checkout: The root of the checkout.
        paths: Git's patterns of the files whose changes count.

    Returns:
        None if this is not a checkout of git, or there is no git.
    """
    try:
        changes = _git(checkout, "status", "--porcelain", "--untracked-files=no", "--", *paths)
        return _git(checkout, "rev-parse", "--short", "HEAD") + ("+" if changes else "")
    except (OSError, subprocess.CalledProcessError):
        return None


def _git(root: Path, *arguments: str) -> str:
    command = ["git", "-C", str(root), *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
