"""Writes the validation gallery: an index, and for each paper a page with its figure.

    python scripts/validation_gallery.py docs/gallery            # pages, for the documentation
    python scripts/validation_gallery.py --figures [PAPER …]     # redraw validation/*/figure.png
    python scripts/validation_gallery.py --counts                # update docs/validation.md

A paper's page is its README followed by a table of its rows, computed when the page is written.
`--counts` writes the counts by kind into docs/validation.md, as `carom validate` prints them.
"""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

from carom.validation import papers, plot
from carom.validation.report import Tally, add, declared, rows, summary, verdict
from carom.validation.row import Kind

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ROOT / "validation"
#: The page that shows the counts, and the block of it that holds them.
COUNTS_PAGE = ROOT / "docs" / "validation.md"
COUNTS_BLOCK = re.compile(r"(?<=<!-- counts -->\n```text\n).*?(?=\n```\n)", re.DOTALL)


def table(paper: str) -> tuple[list[str], Tally]:
    """The rows of a paper as a Markdown table, and their counts by kind."""
    lines = ["| Row | Reference | Ours | Difference | Tolerance | |", "|---|---|---|---|---|---|"]
    tally: Tally = {}
    for row in rows(paper):
        comparisons = row.compare()
        add(tally, row, sum(not c.agrees for c in comparisons))
        lines.append(f"| **{row.id}** | *{row.title}* [{row.unit}] ({row.source}) | | | | |")
        lines.append(f"| | *{row.kind.value}* | | | | |")
        lines += [
            f"| {c.label} | {c.printed_reference} | {c.ours:.6g} | {c.difference:+.1e} "
            f"| {c.tolerance} | {verdict(row, c)} |"
            for c in comparisons
        ]
        if row.note:
            lines.append(f"| | {row.note} | | | | |")
    return lines, tally


def page(paper: str, target: Path) -> Tally:
    """Writes one paper's page and figure; returns the counts of its rows."""
    readme = (FOLDERS / paper / "README.md").read_text(encoding="utf-8")
    lines, tally = table(paper)
    plot.draw(paper, target / f"{paper}.png")
    text = readme.replace("figure.png", f"{paper}.png").rstrip()
    (target / f"{paper}.md").write_text(
        f"{text}\n\n## Reference numbers and ours\n\n" + "\n".join(lines) + "\n",
        encoding="utf-8",
    )
    return tally


def index(tallies: dict[str, Tally], target: Path) -> None:
    """Writes the gallery's front page."""
    total: Tally = declared(tallies)
    found = [kind for kind in Kind if any(key[1] is kind for key in total)]
    lines = [
        "# Validation gallery",
        "",
        "Reference numbers and ours, by paper. The columns count the numbers of each kind:",
        "",
        *(f"{place}. {kind.value}" for place, kind in enumerate(found, start=1)),
        "",
        "Kinds 1 and 2 are published results that the engine reproduces. "
        "[Validation](../validation.md) explains the kinds.",
        "",
        f"| Paper | {' | '.join(str(place) for place in range(1, len(found) + 1))} "
        "| failed | shown, outside |",
        "|---" * (len(found) + 3) + "|",
    ]
    for paper, tally in tallies.items():
        readme = (FOLDERS / paper / "README.md").read_text(encoding="utf-8")
        cells = [
            str(sum(count.numbers for (_, k), count in tally.items() if k is kind) or "")
            for kind in found
        ]
        for must_agree in (True, False):
            off = sum(count.outside for (held, _), count in tally.items() if held is must_agree)
            cells.append(str(off))
        title = readme.splitlines()[0].lstrip("# ")
        lines.append(f"| [{title}]({paper}.md) | {' | '.join(cells)} |")
    contents = ["", "```{toctree}", ":hidden:", "", *tallies, "```", ""]
    (target / "index.md").write_text("\n".join(lines + contents), encoding="utf-8")


def build(target: Path) -> None:
    """Writes the whole gallery into a folder."""
    target.mkdir(parents=True, exist_ok=True)
    tallies = {}
    for paper in papers():
        print(f"gallery: {paper}", file=sys.stderr)
        tallies[paper] = page(paper, target)
    index(tallies, target)


def write_counts() -> None:
    """Replaces the counts in docs/validation.md.

    Raises:
        SystemExit: the page has no block for them.
    """
    text = COUNTS_PAGE.read_text(encoding="utf-8")
    if not COUNTS_BLOCK.search(text):
        raise SystemExit(f"{COUNTS_PAGE} has no ```text block after <!-- counts -->")
    printed = summary(declared(papers()))
    COUNTS_PAGE.write_text(COUNTS_BLOCK.sub(lambda _: printed, text), encoding="utf-8")


def main() -> None:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--figures", action="store_true", help="redraw validation/*/figure.png")
    parser.add_argument("--counts", action="store_true", help="update docs/validation.md")
    parser.add_argument("names", nargs="*", help="the target folder, or the papers to redraw")
    arguments = parser.parse_args()
    if arguments.counts:
        write_counts()
    elif arguments.figures:
        for paper in arguments.names or papers():
            print(f"figure: {paper}", file=sys.stderr)
            plot.draw(paper, FOLDERS / paper / "figure.png")
    else:
        build(Path(arguments.names[0]) if arguments.names else ROOT / "docs" / "gallery")


if __name__ == "__main__":
    main()
