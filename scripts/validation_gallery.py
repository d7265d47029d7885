"""Writes the validation gallery: a page and a figure per paper, and an index.

    python scripts/validation_gallery.py docs/gallery            # pages, for the documentation
    python scripts/validation_gallery.py --figures [PAPER …]     # redraw validation/*/figure.png

A page is the paper's README with the table of its rows as they stand at this moment.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from carom.validation import papers, plot
from carom.validation.report import rows, verdict
from carom.validation.row import STATUS_MEANING, Row

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ROOT / "validation"


def table(paper: str) -> tuple[list[str], dict[str, int]]:
    """The rows of a paper as a Markdown table, and how often each verdict occurs."""
    lines = ["| Row | Published | Ours | Difference | Tolerance | |", "|---|---|---|---|---|---|"]
    tally: dict[str, int] = {}
    for row in rows(paper):
        lines.append(f"| **{row.id}** | *{row.title}* [{row.unit}] ({source(row)}) | | | | |")
        for c in row.compare():
            word = verdict(row, c)
            tally[word] = tally.get(word, 0) + 1
            lines.append(
                f"| {c.label} | {c.published} | {c.ours:.6g} | {c.difference:+.1e} "
                f"| {c.tolerance} | {word} |"
            )
        if row.formula_only:
            lines.append("| | *formula only: the engine has no such model* | | | | |")
        if row.note:
            lines.append(f"| | {row.note} | | | | |")
    return lines, tally


def source(row: Row) -> str:
    """Where the numbers are from, with their status."""
    return f"{row.source}; {row.status}"


def page(paper: str, target: Path) -> dict[str, int]:
    """Writes one paper's page and figure."""
    readme = (FOLDERS / paper / "README.md").read_text()
    lines, tally = table(paper)
    plot.draw(paper, target / f"{paper}.png")
    text = readme.replace("figure.png", f"{paper}.png").rstrip()
    (target / f"{paper}.md").write_text(
        f"{text}\n\n## Published and ours\n\n" + "\n".join(lines) + "\n"
    )
    return tally


def index(tallies: dict[str, dict[str, int]], target: Path) -> None:
    """Writes the gallery's front page."""
    head = ["pass", "FAIL", "shown, within", "shown, outside"]
    lines = [
        "# Validation gallery",
        "",
        "Published numbers and ours, by paper. Numbers of status "
        + ", ".join(f"**{k}** ({v})" for k, v in STATUS_MEANING.items())
        + "; measurements (M, F) are shown beside the defaults, the others are held.",
        "",
        "| Paper | held, pass | held, FAIL | shown, within | shown, outside |",
        "|---|---|---|---|---|",
    ]
    for paper, tally in tallies.items():
        title = (FOLDERS / paper / "README.md").read_text().splitlines()[0].lstrip("# ")
        counts = " | ".join(str(tally.get(word, 0)) for word in head)
        lines.append(f"| [{title}]({paper}.md) | {counts} |")
    contents = ["", "```{toctree}", ":hidden:", "", *tallies, "```", ""]
    (target / "index.md").write_text("\n".join(lines + contents))


def build(target: Path) -> None:
    """Writes the whole gallery into a folder."""
    target.mkdir(parents=True, exist_ok=True)
    tallies = {}
    for paper in papers():
        print(f"gallery: {paper}", file=sys.stderr)
        tallies[paper] = page(paper, target)
    index(tallies, target)


def main() -> None:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--figures", action="store_true", help="redraw validation/*/figure.png")
    parser.add_argument("names", nargs="*", help="the target folder, or the papers to redraw")
    arguments = parser.parse_args()
    if not arguments.figures:
        build(Path(arguments.names[0]) if arguments.names else ROOT / "docs" / "gallery")
        return
    for paper in arguments.names or papers():
        print(f"figure: {paper}", file=sys.stderr)
        plot.draw(paper, FOLDERS / paper / "figure.png")


if __name__ == "__main__":
    main()
