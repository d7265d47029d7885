"""What `make wheel`, `make release` and a build from the sdist do besides building."""

from __future__ import annotations

import importlib
import json
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
SCRIPTS = str(ROOT / "scripts")


@pytest.fixture(scope="module", autouse=True)
def scripts() -> Iterator[None]:
    sys.path.insert(0, SCRIPTS)
    yield
    sys.path.remove(SCRIPTS)


def module(name: str) -> ModuleType:
    return importlib.import_module(name)


def test_the_notes_are_the_section_of_the_version_in_the_changelog() -> None:
    papers = module("release.papers")
    log = (
        "# Changelog\n\n## 0.2.0\n\n- New.\n### Names\n- a is b.\n\n## 0.1.0 (2026-12)\n\n- Old.\n"
    )
    assert papers.notes(log, "0.2.0") == "- New.\n### Names\n- a is b.\n"
    assert papers.notes(log, "0.1.0") == "- Old.\n"
    for version in ("0.1", "0.3.0", "0.1.00"):
        with pytest.raises(module("release.shell").CheckError, match=version):
            papers.notes(log, version)


def test_the_changelog_has_notes_for_the_version() -> None:
    cargo = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))
    version = cargo["workspace"]["package"]["version"]
    log = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert len(module("release.papers").notes(log, version)) > 1000


def test_checksums_are_those_that_sha256sum_reads(tmp_path: Path) -> None:
    (tmp_path / "a.whl").write_bytes(b"abc")
    module("release.papers").write_sums(tmp_path)
    known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    assert (tmp_path / "SHA256SUMS").read_text() == f"{known}  a.whl\n"


def test_two_builds_that_differ_are_named(tmp_path: Path) -> None:
    one, two = tmp_path / "one", tmp_path / "two"
    for folder in (one, two):
        folder.mkdir()
        (folder / "same").write_text("a")
        (folder / "other").write_text(folder.name)
    (one / "alone").write_text("a")
    assert module("release.build").differences(one, two) == ["alone", "other"]


def test_a_report_fails_with_a_failed_check_and_not_with_one_that_could_not_run(
    capsys: pytest.CaptureFixture[str],
) -> None:
    report, shell = module("release.report"), module("release.shell")

    def raises(error: Exception) -> Any:
        def find() -> str:
            raise error

        return find

    good = report.Check("good", lambda: "found")
    absent = report.Check("absent", raises(shell.NotRunError("x is missing")))
    bad = report.Check("bad", raises(shell.CheckError("y is wrong")))
    assert report.report([good, absent]) == 0
    assert report.report([bad, good]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[1:] for line in lines] == [
        ["ok", "found"],
        ["NOT", "RUN", "x", "is", "missing"],
        ["FAILED", "y", "is", "wrong"],
        ["ok", "found"],
    ]


def test_published_crates_depend_on_published_crates_alone_and_with_a_version() -> None:
    meta = json.loads(
        subprocess.run(
            ["cargo", "metadata", "--no-deps", "--format-version", "1"],
            cwd=ROOT,
            check=True,
            capture_output=True,
            text=True,
        ).stdout
    )
    packages = {package["name"]: package for package in meta["packages"]}
    published = {name for name, package in packages.items() if package["publish"] is None}
    assert {"carom-roots", "carom", "carom-rules"} <= published
    for name in published:
        package = packages[name]
        folder = Path(package["manifest_path"]).parent
        assert all(package[key] for key in ("description", "license", "keywords")), name
        assert (folder / package["readme"]).is_file(), name
        assert {"LICENSE-MIT", "LICENSE-APACHE"} <= {file.name for file in folder.iterdir()}, name
        for needed in package["dependencies"]:
            # A dependency of the tests alone is left out of the package.
            if needed.get("path") and needed["kind"] != "dev":
                assert needed["name"] in published, (name, needed["name"])
                assert needed["req"] != "*", (name, needed["name"])


def test_a_build_without_cargo_is_refused_with_the_remedy(tmp_path: Path) -> None:
    program = (
        f"import sys; sys.path.insert(0, {SCRIPTS!r}); import build_backend; "
        "build_backend.get_requires_for_build_wheel()"
    )
    ended = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=False,
        env={"PATH": str(tmp_path)},
    )
    assert ended.returncode == 1
    assert "cargo (Rust 1." in ended.stderr
    assert "https://rustup.rs" in ended.stderr


def test_a_build_with_an_old_rust_is_refused_with_the_remedy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, said in (("cargo", "cargo 1.70.0"), ("rustc", "rustc 1.70.0 (2023)")):
        (tmp_path / name).write_text(f"#!/bin/sh\necho '{said}'\n")
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    (sentence,) = module("build_backend").missing()
    assert sentence.endswith("this is 1.70.0: run rustup update stable")


def test_goldens_with_other_results_need_another_version(monkeypatch: pytest.MonkeyPatch) -> None:
    goldens = module("write_goldens")
    stored = {
        name: (ROOT / "goldens" / f"{name}.json").read_text(encoding="utf-8")
        for name in ("shots", "noise", "games")
    }
    assert goldens.changed(stored) == []
    shots = json.loads(stored["shots"])
    more = {**shots, "a_new_shot": {"events": 1, "hash": "0"}}
    assert goldens.changed({"shots": json.dumps(more)}) == []
    other = {**shots, "draw_shot": {"events": 1, "hash": "0"}}
    assert goldens.changed({"shots": json.dumps(other)}) == ["shots: draw_shot"]
