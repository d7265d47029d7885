"""Builds the documentation into a folder: galleries of papers and shots, pages, and Rust pages.

    python scripts/build_docs.py FOLDER

`make docs` has put rustdoc's output into FOLDER/rust before.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
from carom import Noise, Shot, acceptance, break_statistics, position_map, pot_map
from carom.picture import evaluation, maps, png

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
    cut = Shot.load(ROOT / "shots" / "side_pocket_cut.json")
    club = Noise.preset("club")
    chances = evaluation.png(cut.evaluate(club), title="side pocket cut")
    (folder / "chances.png").write_bytes(chances)
    speeds, heights = np.linspace(0.8, 4.0, 65), np.linspace(-0.4, 0.4, 5)
    for name, found in (
        ("pot_map", pot_map(cut, "1", "right", noise=club)),
        ("position_map", position_map(cut, "1", "right", speed=speeds, height=heights)),
        ("acceptance", acceptance(cut, "top-left")),
        ("breaks", break_statistics("nine-ball")),
    ):
        (folder / f"{name}.png").write_bytes(maps.png(found))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
