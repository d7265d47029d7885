"""Write LICENSE-THIRD-PARTY: the licenses of the packages that the wheel and the page contain.

    python scripts/write_licenses.py [--check]

These packages are the crates that the extension module and the WebAssembly link, and those under
`dependencies` in web/package.json. Packages with the same terms share one text.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
OUT = ROOT / "LICENSE-THIRD-PARTY"
WEB = ROOT / "web"
# Each crate that is built, and its platform.
BUILT = (
    ("carom-py", "x86_64-unknown-linux-gnu"),
    ("carom-wasm", "wasm32-unknown-unknown"),
)
HEAD = """\
Built into the wheel's extension module, the page's WebAssembly or the page are these packages,
under these terms. Where a package offers a choice, the MIT license is chosen. The standard library
of Rust, Copyright (c) The Rust Project Contributors, is used under the MIT license too.
"""
RULE = "-" * 80
# The first pattern that matches: where a package offers a choice, one license is enough.
CHOICE = ("LICENSE-MIT*", "LICENSE*", "COPYING*")
# A license that applies in addition to the chosen one.
ALSO = "LICENSE-UNICODE*"
COPYRIGHT = re.compile(r"^\s*(Copyright (?:\(c\)|©|\d).*\S)\s*$")
TITLE = re.compile(r"^\s*(?:The )?MIT License(?: \(MIT\))?\s*$", re.IGNORECASE)


def cargo(*arguments: str) -> str:
    """The output of a cargo command."""
    return subprocess.run(
        ["cargo", *arguments], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout


def crates() -> dict[str, Path]:
    """The folder of every linked crate of a third party, by "name version"."""
    found: dict[str, Path] = {}
    for crate, target in BUILT:
        tree = cargo(
            *("tree", "--package", crate, "--target", target, "--prefix", "none"),
            *("--edges", "normal,no-proc-macro", "--format", "{p}"),
        )
        linked = {" ".join(line.split()[:2]).replace(" v", " ") for line in tree.splitlines()}
        meta = json.loads(cargo("metadata", "--format-version", "1", "--filter-platform", target))
        for package in meta["packages"]:
            name = f"{package['name']} {package['version']}"
            if package["source"] is not None and name in linked:
                found[name] = Path(package["manifest_path"]).parent
    return found


def modules() -> dict[str, Path]:
    """The folder of every JavaScript package in the page, by "name version"."""
    found = {}
    for name in json.loads((WEB / "package.json").read_text())["dependencies"]:
        folder = WEB / "node_modules" / name
        found[f"{name} {json.loads((folder / 'package.json').read_text())['version']}"] = folder
    return found


def license_of(folder: Path) -> str:
    """The text of a package's licenses.

    Raises:
        SystemExit: Its folder has no license.
    """
    chosen = next((found for pattern in CHOICE if (found := sorted(folder.glob(pattern)))), None)
    if chosen is None:
        raise SystemExit(
            f"carom: {folder} has no license file; find out its terms before you use it."
        )
    paths = sorted({chosen[0], *folder.glob(ALSO)})
    return "\n".join(path.read_text(encoding="utf-8").strip() for path in paths)


def parted(license_: str) -> tuple[list[str], str]:
    """The copyright lines of a license, and its other text."""
    lines = license_.splitlines()
    rights = [match[1] for line in lines if (match := COPYRIGHT.match(line))]
    terms = [line for line in lines if not COPYRIGHT.match(line) and not TITLE.match(line)]
    return rights, "\n".join(terms).strip()


def text() -> str:
    """The whole file."""
    licenses = {name: license_of(folder) for name, folder in {**crates(), **modules()}.items()}
    shared: dict[str, list[str]] = {}
    for name in sorted(licenses):
        # Terms that differ only in their line breaks are the same.
        shared.setdefault(" ".join(parted(licenses[name])[1].split()), []).append(name)
    parts = [HEAD]
    for names in sorted(shared.values(), key=lambda names: (-len(names), names)):
        body = licenses[names[0]]
        lines = names
        if len(names) > 1:
            body = parted(body)[1]
            rights = ["; ".join(parted(licenses[name])[0]) for name in names]
            lines = [f"{n}: {r}" if r else n for n, r in zip(names, rights, strict=True)]
        parts.append(f"{RULE}\n" + "\n".join(lines) + f"\n\n{body}\n")
    return "\n".join(parts)


def main() -> None:
    """Write the file; with ``--check`` only compare it, and fail if it is out of date."""
    if "--check" not in sys.argv[1:]:
        OUT.write_text(text(), encoding="utf-8")
    elif OUT.read_text(encoding="utf-8") != text():
        raise SystemExit(f"carom: {OUT.name} is out of date: run `make licenses`.")


if __name__ == "__main__":
    main()
