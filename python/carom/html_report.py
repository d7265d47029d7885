"""Reports as one HTML file: their style, and their tables."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

STYLE = """
:root { color-scheme: light dark; --line: #d4d8dd; --soft: #f3f5f7; --ink: #1b1f24; --dim: #5a636d;
  --accent: #0b62c4; --ground: #fff; }
@media (prefers-color-scheme: dark) { :root { --line: #3a424b; --soft: #20262d; --ink: #e8ebee;
  --dim: #a2abb5; --accent: #7ab7ff; --ground: #14181c; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1rem; background: var(--ground);
  color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: .5rem 0; } h2 { font-size: 1.25rem; margin: 2rem 0 .25rem; }
h1, h2 { overflow-wrap: anywhere; }
h3 { font-size: 1rem; font-weight: 400; color: var(--dim); margin: 1.25rem 0 .25rem; }
p { margin: .25rem 0 .5rem; } .dim { color: var(--dim); }
a { color: var(--accent); }
.wide { overflow-x: auto; } .wide:focus-visible { outline: 2px solid var(--accent); }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); text-align: end;
  white-space: nowrap; }
small { color: var(--dim); margin-inline-start: .35rem; }
th { font-weight: 600; } th[scope="row"], .text { text-align: start; }
th[scope="row"] { position: sticky; left: 0; background: var(--ground); min-width: 6rem;
  max-width: 16rem; white-space: normal; overflow-wrap: break-word; }
thead th, thead td { border-bottom-width: 2px; vertical-align: bottom; }
thead th { white-space: normal; }
tbody tr:hover, tbody tr:hover th { background: var(--soft); }
td.text.why { white-space: normal; min-width: 12rem; }
details > summary { cursor: pointer; padding: .35rem 0; overflow-wrap: anywhere; }
@media (max-width: 40rem) { th[scope="row"] { max-width: 8rem; }
  th, td { padding: .25rem .4rem; } }
@media print { body { max-width: none; padding: 0; font-size: .7rem; } .wide { overflow: visible; }
  :root { --line: #bbb; --soft: #fff; --ink: #000; --dim: #444; --accent: #000; --ground: #fff; }
  th, td { padding: .15rem .3rem; } th, td.text { white-space: normal; }
  h1 { font-size: 1.2rem; } h2 { font-size: 1rem; } h3 { font-size: .8rem; }
  h2, h3 { break-after: avoid; } tr { break-inside: avoid; }
  a { color: inherit; text-decoration: none; } details:not([open]) { display: none; } }
"""


def document(title: str, body: Iterable[str], *, style: str = "", after: Iterable[str] = ()) -> str:
    """A page that needs neither a server nor a network.

    Args:
        title: The title of the window.
        body: Elements of the page's main part.
        style: CSS beside that of all reports.
        after: Elements behind the main part.
    """
    return "\n".join(
        [
            "<!doctype html>",
            '<html lang="en">',
            '<meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{escape(title)} · carom</title>",
            f"<style>{STYLE}{style}</style>",
            "<body>",
            "<main>",
            *body,
            "</main>",
            *after,
            "</body></html>\n",
        ]
    )


def grid(
    of: str, title: str, heads: Sequence[str], rows: Sequence[str], texts: Sequence[int] = ()
) -> str:
    """A table that scrolls on a narrow screen, with its title above it.

    Args:
        of: The identifier of the heading above the title.
        title: The title.
        heads: The heads of the columns.
        rows: The cells of each row.
        texts: The columns with texts, apart from the first one.
    """
    name = f"{of}-{re.sub('[^a-z]+', '-', title.lower())}"
    heading = f'<h3 id="{name}">{escape(title)}</h3>'
    return heading + scrolling(f'aria-labelledby="{of} {name}"', heads, rows, texts)


def scrolling(label: str, heads: Sequence[str], rows: Sequence[str], texts: Sequence[int]) -> str:
    """A table that scrolls on a narrow screen; ``label`` is its attribute with the name."""
    columns = "".join(_head(head, is_text=k == 0 or k in texts) for k, head in enumerate(heads))
    body = "".join(f"<tr>{row}</tr>" for row in rows)
    return (
        f'<div class="wide" role="region" {label} tabindex="0"><table>'
        f"<thead><tr>{columns}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def _head(text: str, *, is_text: bool) -> str:
    kind = ' class="text"' if is_text else ""
    return f'<th scope="col"{kind}>{escape(text)}</th>' if text else "<td></td>"


def row_head(name: str) -> str:
    """The head of a row."""
    return f'<th scope="row">{escape(name)}</th>'


def cell(value: Any) -> str:
    """A cell with a number."""
    return f"<td>{escape(str(value))}</td>"


def text_cell(value: str) -> str:
    """A cell with a text."""
    return f'<td class="text">{escape(value)}</td>'


def minus(text: str) -> str:
    """A text whose negative numbers have a minus sign, not a hyphen."""
    return re.sub(r"(?<!\w)-(?=\d)", "−", text)
