"""The Python snippets of the README and of the documentation run unchanged, page by page."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
# `make docs` writes these folders from the same pages.
BUILT = {"_build", "gallery"}
PAGES = [
    ROOT / "README.md",
    *(p for p in sorted((ROOT / "docs").rglob("*.md")) if BUILT.isdisjoint(p.parts)),
]
SNIPPET = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
# The snippets of a page build on each other, so they run as one program.
PROGRAMS = {
    str(page.relative_to(ROOT)): "\n".join(SNIPPET.findall(page.read_text(encoding="utf-8")))
    for page in PAGES
    if page.exists() and SNIPPET.search(page.read_text(encoding="utf-8"))
}


def test_the_readme_and_the_tutorials_have_snippets() -> None:
    assert "README.md" in PROGRAMS
    assert sum(page.startswith("docs/tutorials/") for page in PROGRAMS) >= 3


@pytest.mark.parametrize("page", PROGRAMS)
def test_the_snippets_of_a_page_run_in_order(page: str, tmp_path: Path) -> None:
    # Snippets read files of the checkout and may write files of their own.
    for folder in ("shots", "tracks", "studies"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", PROGRAMS[page]],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
