"""Every Python snippet of the README and of the documentation runs as it stands."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
# What `make docs` writes is made of these pages, and not looked at again.
BUILT = {"_build", "gallery"}
PAGES = [
    ROOT / "README.md",
    *(p for p in sorted((ROOT / "docs").rglob("*.md")) if BUILT.isdisjoint(p.parts)),
]
SNIPPETS = [
    pytest.param(match[1], id=f"{page.name}-{number}")
    for page in PAGES
    if page.exists()
    for number, match in enumerate(
        re.finditer(r"^```python\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE), 1
    )
]


def test_the_readme_has_snippets() -> None:
    assert any(param.id and param.id.startswith("README") for param in SNIPPETS)


@pytest.mark.parametrize("snippet", SNIPPETS)
def test_snippet_runs_from_the_root_of_the_checkout(snippet: str) -> None:
    subprocess.run([sys.executable, "-W", "error", "-c", snippet], cwd=ROOT, check=True)
