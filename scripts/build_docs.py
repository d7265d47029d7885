"""Builds the documentation into a folder: the gallery of papers, the pages, and the Rust pages.

    python scripts/build_docs.py FOLDER

`make docs` has put rustdoc's output into FOLDER/rust before.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"


def main(folder: Path) -> int:
    """Builds everything; a warning is an error."""
    gallery = DOCS / "gallery"
    shutil.rmtree(gallery, ignore_errors=True)
    gallery.mkdir()
    subprocess.run(
        [sys.executable, ROOT / "scripts" / "validation_gallery.py", gallery], check=True
    )
    pages = folder / "html"
    command = [sys.executable, "-m", "sphinx", "--quiet", "--fail-on-warning", "--keep-going"]
    command += ["--builder", "html", "--doctree-dir", folder / "doctrees", DOCS, pages]
    done = subprocess.run(command, check=False)
    if done.returncode == 0:
        shutil.copytree(folder / "rust" / "doc", pages / "rust", dirs_exist_ok=True)
        print(f"The documentation: {pages / 'index.html'}")
    return done.returncode


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
