"""The demo and the documentation of `examples/godot` call methods that the extension has."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "examples" / "godot"
CALL = re.compile(r"\b(?:CaromTrace|trace)\.(\w+)\(")


def methods() -> set[str]:
    source = (FOLDER / "src" / "lib.rs").read_text(encoding="utf-8")
    return set(re.findall(r"#\[func\]\n    fn (\w+)", source))


@pytest.mark.parametrize("name", ["demo", "docs"])
def test_every_method_that_gdscript_calls_exists(name: str) -> None:
    if name == "demo":
        text = (FOLDER / "demo" / "main.gd").read_text(encoding="utf-8")
    else:
        page = (ROOT / "docs" / "game.md").read_text(encoding="utf-8")
        text = "".join(re.findall(r"```gdscript\n(.*?)```", page, re.DOTALL))
    called = set(CALL.findall(text))
    assert "transforms" in called
    assert called <= methods()


def test_the_documentation_names_every_method() -> None:
    page = (ROOT / "docs" / "game.md").read_text(encoding="utf-8")
    section = page.split("## Godot\n")[1].split("\n## ")[0]
    assert {name for name in methods() if f"{name}(" in section} == methods()
