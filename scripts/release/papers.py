"""What goes beside the released files: bill of materials, notes and checksums."""

from __future__ import annotations

import hashlib
import json
import re
import zipfile
from pathlib import Path

from release.shell import ROOT, CheckError, run

NOTES = "NOTES.md"
SUMS = "SHA256SUMS"


def write_bills(out: Path, version: str) -> None:
    """Write the bills of materials, CycloneDX: of the wheel's crates, and of the page's packages.

    maturin writes the first one into every wheel; npm knows the second.
    """
    wheel = next(out.glob("*x86_64.whl"))
    with zipfile.ZipFile(wheel) as packed:
        (name,) = (n for n in packed.namelist() if n.endswith(".cyclonedx.json"))
        (out / f"carom-{version}-crates.cdx.json").write_bytes(packed.read(name))
    bill = run("npm", "sbom", "--omit", "dev", "--sbom-format", "cyclonedx", at=ROOT / "web")
    found = json.loads(bill)
    # A random number and the time of the call are of no use.
    found.pop("serialNumber", None)
    found["metadata"].pop("timestamp", None)
    page = out / f"carom-{version}-page.cdx.json"
    page.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


def notes(changelog: str, version: str) -> str:
    """The section of a version in CHANGELOG.

    Raises:
        CheckError: There is no such section, or it is empty.
    """
    head = rf"^## {re.escape(version)}(?: .*)?\n((?:(?!## ).*\n?)*)"
    found = re.search(head, changelog, re.MULTILINE)
    text = found[1].strip() if found else ""
    if not text:
        raise CheckError(f"CHANGELOG.md has no section ## {version} with text: write it")
    return text + "\n"


def write_notes(out: Path, version: str) -> None:
    """Write the release notes, from CHANGELOG."""
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    (out / NOTES).write_text(notes(changelog, version), encoding="utf-8")


def write_sums(out: Path) -> None:
    """Write the SHA-256 of every file, as ``sha256sum --check`` reads it."""
    files = sorted(file for file in out.iterdir() if file.name != SUMS)
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}" for file in files]
    (out / SUMS).write_text("\n".join(lines) + "\n", encoding="utf-8")
