"""The build of the wheel and of the sdist: maturin, after a check of what this machine lacks.

maturin alone would download a Rust toolchain where there is none, and would report a missing
linker by its error.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import maturin
from maturin import (
    build_sdist,
    prepare_metadata_for_build_editable,
    prepare_metadata_for_build_wheel,
)

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
    "prepare_metadata_for_build_wheel",
]

ROOT = Path(__file__).parents[1]
LINKERS = ("cc", "gcc", "clang", "zig", "link")

Settings = Mapping[str, Any] | None


def missing() -> list[str]:
    """What this machine lacks for a build, each with its remedy."""
    manifest = (ROOT / "Cargo.toml").read_text(encoding="utf-8")
    oldest = re.search(r'^rust-version = "(.*)"', manifest, re.MULTILINE)[1]
    found = []
    if shutil.which("cargo") is None:
        found.append(
            f"cargo (Rust {oldest} or newer), which compiles the engine: install Rust from "
            "https://rustup.rs and open a new shell"
        )
    elif _numbers(version := _rust_version()) < _numbers(oldest):
        found.append(f"Rust {oldest} or newer; this is {version}: run rustup update stable")
    if sys.platform != "win32" and not any(map(shutil.which, LINKERS)):
        found.append(
            "a C compiler, with which Rust links: install one (Debian, Ubuntu: apt install "
            "build-essential; macOS: xcode-select --install)"
        )
    return found


def _rust_version() -> str:
    asked = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=False)
    return match[1] if (match := re.search(r"(\d+\.\d+\.\d+)", asked.stdout)) else "none"


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, re.findall(r"\d+", version)))


def check() -> None:
    """Refuse a build on a machine that lacks something; say that a wheel will have no page.

    Raises:
        SystemExit: With one sentence for each missing thing.
    """
    if lacks := missing():
        raise SystemExit("carom: to build it from source this machine lacks " + "; ".join(lacks))
    if not (ROOT / "python" / "carom" / "web" / "index.html").is_file():
        print(
            "carom: the wheel will have no page (carom play, --html): run `make page` first; it "
            "needs Node 20.19 or newer",
            file=sys.stderr,
        )


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    """No further package."""
    check()
    return maturin.get_requires_for_build_wheel(config_settings)


get_requires_for_build_editable = get_requires_for_build_wheel


def get_requires_for_build_sdist(config_settings: Settings = None) -> list[str]:
    """No further package. An sdist needs cargo, which lists the crates, and no linker."""
    return get_requires_for_build_wheel(config_settings)


def build_wheel(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None
) -> str:
    """Build the wheel; gives the name of its file."""
    check()
    return str(maturin.build_wheel(wheel_directory, config_settings, metadata_directory))


def build_editable(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None
) -> str:
    """Build the wheel of an editable installation; gives the name of its file."""
    check()
    return str(maturin.build_editable(wheel_directory, config_settings, metadata_directory))
