"""Build the documentation: pages from Markdown, the gallery of papers, and both API references.

    python scripts/build_docs.py OUT

Run it through `make docs`.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import carom
from carom import picture
from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[1]

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · carom</title>
<style>
body {{ margin: 0 auto; max-width: 60rem; padding: 1rem 1.25rem 4rem; background: #fbfaf6;
  color: #23272b; font: 1rem/1.55 system-ui, sans-serif; }}
nav {{ padding-bottom: .75rem; border-bottom: 1px solid #ddd8ca; }}
nav a {{ margin-right: 1rem; }}
a {{ color: #17594a; }}
pre {{ overflow-x: auto; padding: .75rem; background: #f1eee4; font-size: .85rem; }}
code {{ background: #f1eee4; font-size: .9em; }}
pre code {{ background: none; }}
table {{ border-collapse: collapse; font-size: .9rem; }}
th, td {{ padding: .25rem .6rem; border-bottom: 1px solid #ddd8ca; text-align: left;
  vertical-align: top; }}
img, svg {{ max-width: 100%; height: auto; }}
</style>
</head>
<body>
<nav><a href="{up}index.html">carom</a><a href="{up}gallery/index.html">papers</a>\
<a href="{up}tables.html">tables</a><a href="{up}python/carom.html">Python</a>\
<a href="{up}rust/carom/index.html">Rust</a></nav>
{body}
</body>
</html>
"""


def main(out: Path) -> None:
    """Build everything into ``out``; what an earlier run left there is replaced."""
    for part in ("gallery", "python"):
        shutil.rmtree(out / part, ignore_errors=True)
    out.mkdir(parents=True, exist_ok=True)
    write(out / "index.html", "carom", (ROOT / "README.md").read_text(encoding="utf-8"))
    pages = [*ROOT.glob("docs/*.md"), *ROOT.glob("[A-Z]*.md")]
    for page in pages:
        if page.name != "README.md":
            target = out / page.relative_to(ROOT).with_suffix(".html")
            write(target, page.stem, page.read_text(encoding="utf-8"))
    for pictures in ("docs/images", "docs/figures"):
        if (ROOT / pictures).is_dir():
            shutil.copytree(ROOT / pictures, out / pictures, dirs_exist_ok=True)
    tables(out)
    gallery(out / "gallery")
    subprocess.run(
        [sys.executable, "-m", "pdoc", "--docformat", "google", "-o", out / "python", "carom"],
        check=True,
    )
    print(f"Documentation: {out / 'index.html'}")


def write(path: Path, title: str, markdown: str) -> None:
    """One page; links to other Markdown pages become links to their HTML."""
    markdown = re.sub(r"\]\((?!https?:)([^)#]+)\.md(#[^)]*)?\)", r"](\1.html\2)", markdown)
    body = MarkdownIt("commonmark", {"html": True}).enable("table").render(markdown)
    depth = len(path.relative_to(OUT).parts) - 1
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(PAGE.format(title=title, up="../" * depth, body=body), encoding="utf-8")


def tables(out: Path) -> None:
    """Every preset, drawn, with each dimension and where it was read."""
    parts = ["# Tables", "Every preset with its dimensions and where each of them was read."]
    for table in carom.tables():
        parts.append(f"## {table['name']}")
        parts.append(_inline(picture.to_svg(picture.draw_table(table))))
        rows = [
            f"| {d['key']} | {d['value']:.6g} {d['unit']} | {d['source'] or 'derived'} |"
            for d in table["dimensions"]
        ]
        parts.append("\n".join(["| dimension | value | source |", "|---|---|---|", *rows]))
    write(out / "tables.html", "Tables", "\n\n".join(parts))


def gallery(out: Path) -> None:
    """A page per paper, and their list: `validation_gallery.py` writes them as Markdown."""
    subprocess.run(
        [sys.executable, ROOT / "scripts" / "validation_gallery.py", out], check=True, cwd=ROOT
    )
    for page in sorted(out.glob("*.md")):
        text = page.read_text(encoding="utf-8")
        write(page.with_suffix(".html"), page.stem, text)
        page.unlink()


def _inline(svg: str) -> str:
    # A blank line would end the block of HTML inside Markdown.
    return re.sub(r"\n\s*\n", "\n", svg[svg.index("<svg") :])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python scripts/build_docs.py OUT")
    OUT = Path(sys.argv[1]).resolve()
    main(OUT)
