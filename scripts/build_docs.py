"""Builds the documentation into a folder: galleries of papers and shots, pages, and Rust pages.

    python scripts/build_docs.py FOLDER

`make docs` runs rustdoc into FOLDER/rust before this script.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
from carom import (
    Noise,
    Shot,
    Strike,
    acceptance,
    bank_table,
    break_shot,
    break_statistics,
    kick_table,
    position_map,
    pot_map,
)
from carom.page import html
from carom.picture import png, save

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
# The same pattern as in the tests of the snippets.
SNIPPET = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
SHOTS = ("jump_shot", "rail_top_landing", "off_the_table", "masse", "spit_out")


def main(folder: Path) -> int:
    """Builds everything; a warning is an error."""
    gallery = DOCS / "gallery"
    shutil.rmtree(gallery, ignore_errors=True)
    gallery.mkdir()
    write_live_table(gallery / "live")
    subprocess.run(
        [sys.executable, ROOT / "scripts" / "validation_gallery.py", gallery], check=True
    )
    draw_shots(gallery / "shots")
    run_snippets(DOCS / "guide-coach.md", gallery / "coach")
    run_snippets(DOCS / "think.md", gallery / "think")
    pages = folder / "html"
    command = [sys.executable, "-m", "sphinx", "--quiet", "--fail-on-warning", "--keep-going"]
    command += ["--builder", "html", "--doctree-dir", folder / "doctrees", DOCS, pages]
    done = subprocess.run(command, check=False)
    if done.returncode == 0:
        shutil.copytree(folder / "rust" / "doc", pages / "rust", dirs_exist_ok=True)
        print(f"The documentation: {pages / 'index.html'}")
    return done.returncode


def write_live_table(folder: Path) -> None:
    """Writes the live table of the first page: the page of `carom play` with a break to replay.

    Sphinx copies the folder next to its own pages (`html_extra_path`).
    """
    folder.mkdir()
    # The break of the README: the 6 and the 9 fall.
    trace = break_shot("nine-ball", seed=20).simulate()
    element = 'id="carom-document"'
    # With this attribute the page starts the trace without a click; then the visitor can aim.
    page = html(trace, title="nine-ball break").replace(element, f"{element} data-play", 1)
    (folder / "live.html").write_text(page, encoding="utf-8")


def draw_shots(folder: Path) -> None:
    """Draws the shots that the pages show."""
    folder.mkdir()
    for name in SHOTS:
        trace = Shot.load(ROOT / "shots" / f"{name}.json").simulate()
        picture = png(trace, title=name.replace("_", " "), dots_per_inch=100)
        (folder / f"{name}.png").write_bytes(picture)
    cut = Shot.load(ROOT / "shots" / "side_pocket_cut.json")
    club = Noise.preset("club")
    save(cut.evaluate(club), folder / "chances.png", title="side pocket cut")
    balls = {"cue": (0.5, 0.5), "8": (0.5, 0.8), "1": (0.5, 1.2)}
    hidden = Shot("wpa-9ft", balls, Strike(speed=2.0, azimuth=np.pi / 2))
    raised = hidden.solve(first="1", noise=club, elevation=1.2, wanted=60, per_route=1)
    speeds, heights = np.linspace(0.8, 4.0, 65), np.linspace(-0.4, 0.4, 5)
    for name, found in (
        ("solutions", cut.solve(pot=("1", "right"), noise=club, per_route=2)),
        ("raised", [way for way in raised if "jump" in way.kind or "massé" in way.kind]),
        ("pot_map", pot_map(cut, "1", "right", noise=club)),
        ("position_map", position_map(cut, "1", "right", speed=speeds, height=heights)),
        ("acceptance", acceptance(cut, "top-left")),
        ("kicks", kick_table(cut, azimuth=np.radians([60, 100, 140, 180]), speed=[2.0, 4.0])),
        ("banks", bank_table(cut, "1", azimuth=np.radians(np.arange(5, 360, 30)))),
        ("breaks", break_statistics("nine-ball")),
    ):
        save(found, folder / f"{name}.png")


def run_snippets(page: Path, folder: Path) -> None:
    """Runs the Python of a page in a folder, so that the page can show the pictures it saves."""
    folder.mkdir()
    program = "\n".join(SNIPPET.findall(page.read_text(encoding="utf-8")))
    subprocess.run(
        [sys.executable, "-c", program], check=True, cwd=folder, stdout=subprocess.DEVNULL
    )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve()))
