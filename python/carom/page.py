"""The page: one HTML file with the engine, the viewer and a shot or a trace in it.

``make page`` builds it from ``web/`` into ``carom/web/index.html``. It needs no server and no
network: what it shows is inside it.
"""

from __future__ import annotations

import json
import sys
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from carom.errors import PageError

if TYPE_CHECKING:
    from carom.shot import Shot
    from carom.trace import Trace

# Where the page looks for what it shall show, and its title.
MARKER = '<script type="application/json" id="carom-document">'
TITLE = "<title>carom</title>"

# Height of the viewer in a notebook, CSS pixels: table, timeline and a word below them.
HEIGHT = 560


def path() -> Path:
    """Where the built page is, if it has been built."""
    return Path(__file__).parent / "web" / "index.html"


def is_built() -> bool:
    """Whether this installation has the page."""
    return path().exists()


def html(document: Shot | Trace | None = None, *, title: str | None = None) -> str:
    """The page showing ``document``, complete: it works from disk, offline.

    Args:
        document: The shot to aim, or the trace to replay; None for the page's own first shot.
        title: Of the browser's window.

    Raises:
        PageError: The page is not built into this installation.
    """
    try:
        page = path().read_text(encoding="utf-8")
    except FileNotFoundError:
        raise PageError(
            "the page is not built into this installation; run `make page` in carom's checkout "
            "(it needs Node 20.19 or newer) and, unless make installed carom there, "
            "`pip install .` again"
        ) from None
    if title is not None:
        page = page.replace(TITLE, f"<title>{escape(title)} · carom</title>", 1)
    if document is not None:
        # JSON has < in its strings only. Escaped, nothing in them ends the script element.
        text = json.dumps(document.to_dict(), separators=(",", ":")).replace("<", "\\u003c")
        before, marker, after = page.partition(MARKER)
        if not marker:
            raise PageError(f"{path()} is no page of this carom; run `make page` again")
        page = before + marker + text + after
    return page


def frame(document: Shot | Trace, *, height: int = HEIGHT) -> str:
    """The page as an element of another one, for notebooks.

    It runs in a sandbox: it can neither see nor change what is around it.

    Args:
        document: The shot to aim, or the trace to replay.
        height: CSS pixels.

    Raises:
        PageError: The page is not built into this installation.
    """
    # All that must be escaped inside double quotes; more would only make it longer.
    page = html(document).replace("&", "&amp;").replace('"', "&quot;")
    return (
        f'<iframe srcdoc="{page}" sandbox="allow-scripts allow-downloads" '
        'allow="fullscreen; clipboard-write" title="carom" '
        f'style="width: 100%; height: {height}px; border: 0"></iframe>'
    )


def show(document: Shot | Trace, *, height: int = HEIGHT) -> None:
    """Show ``document`` in the notebook, or else in the browser until Ctrl-C.

    Raises:
        PageError: The page is not built into this installation.
    """
    if _in_notebook():
        from IPython.display import HTML, display

        display(HTML(frame(document, height=height)))
        return
    from carom.serve import serve

    serve(html(document))


def _in_notebook() -> bool:
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    return hasattr(shell, "kernel")
