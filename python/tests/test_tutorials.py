"""Every tutorial's Python, taken together, is a program that runs."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

TUTORIALS = sorted((Path(__file__).parents[2] / "docs" / "tutorials").glob("*.md"))


def snippets(page: Path) -> list[str]:
    found = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)
    return [str(snippet) for snippet in found]


def test_there_are_tutorials_with_python() -> None:
    assert sum(map(len, map(snippets, TUTORIALS))) > 5


@pytest.mark.parametrize("page", TUTORIALS, ids=lambda page: page.stem)
def test_a_tutorial_runs_from_top_to_bottom(page: Path, tmp_path: Path) -> None:
    program = "\n".join(snippets(page))
    subprocess.run([sys.executable, "-W", "error", "-c", program], cwd=tmp_path, check=True)
