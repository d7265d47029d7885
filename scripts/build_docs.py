"""Builds the documentation into a folder: galleries of papers and shots, pages, and Rust pages.

    python scripts/build_docs.py FOLDER

`make docs` has put rustdoc's output into FOLDER/rust before.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from carom import Noise, Shot
from carom.picture import evaluation, png

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
SHOTS = ("jump_shot", "rail_top_landing", "off_the_table", "masse", "spit_out")


def main(folder: Path) -> int:
    """Builds everything; a warning is an error."""
    gallery = DOCS / "gallery"
    shutil.rmtree(gallery, ignore_errors=True)
    gallery.mkdir()
    subprocess.run(
        [sys.executable, ROOT / "scripts" / "validation_gallery.py", gallery], check=True
    )
    draw_shots(gallery / "shots")
    pages = folder / "html"
    command = [sys.executable, "-m", "sphinx", "--quiet", "--fail-on-warning", "--keep-going"]
    command += ["--builder", "html", "--doctree-dir", folder / "doctrees", DOCS, pages]
    done = subprocess.run(command, check=False)
    if done.returncode == 0:
        shutil.copytree(folder / "rust" / "doc", pages / "rust", dirs_exist_ok=True)
        print(f"The documentation: {pages / 'index.html'}")
    return done.returncode


def draw_shots(folder: Path) -> None:
    """Draws the shots that the pages show."""
    folder.mkdir()
    for name in SHOTS:
        trace = Shot.load(ROOT / "shots" / f"{name}.json").simulate()
        picture = png(trace, title=name.replace("_", " "), dots_per_inch=100)
        (folder / f"{name}.png").write_bytes(picture)
    chances = Shot.load(ROOT / "shots" / "side_pocket_cut.json").evaluate(Noise.preset("club"))
    (folder / "chances.png").write_bytes(evaluation.png(chances, title="side pocket cut"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
