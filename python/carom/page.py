"""The page: one HTML file with the engine, the viewer, and a shot, a trace or a study.

``make page`` builds it from ``web/`` into ``carom/web/index.html``. It needs no server and no
network, because everything that it shows is inside the file.
"""

from __future__ import annotations

import json
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any, Protocol

from carom.arguments import text as checked_text
from carom.arguments import whole
from carom.deprecated import warn
from carom.errors import InputError, PageError

# The element of the page that holds the document, and the page's title.
MARKER = '<script type="application/json" id="carom-document">'
TITLE = "<title>carom</title>"

# Height of the viewer in a notebook, CSS pixels: table, timeline and one line of text below them.
HEIGHT = 560
# Largest height, CSS pixels: browsers cannot lay out longer elements.
MOST_HEIGHT = 10**6


class Document(Protocol):
    """What the page can show: a shot, a trace or a study."""

    def to_dict(self) -> dict[str, Any]:
        """The ``carom-shot/1``, ``carom-trace/1`` or ``carom-study/1``."""
        ...


def path() -> Path:
    """Path of the built page, whether or not it has been built."""
    return Path(__file__).parent / "web" / "index.html"


def beside() -> dict[str, bytes]:
    """The files beside the built page, by name. They make a served page installable."""
    files = path().parent.glob("*")
    return {file.name: file.read_bytes() for file in files if file.name != path().name}


def is_built() -> bool:
    """Whether this installation has the page."""
    return path().exists()


def html(document: Document | None = None, *, title: str | None = None) -> str:
    """The complete page with a shot, a trace or a study; it works from disk, without a network.

    Args:
        document: The shot to aim, the trace to replay or the study to read; None shows the page's
            own first shot.
        title: Title of the browser's window.

    Raises:
        InputError: ``document`` is no shot, trace or study, or ``title`` not a string.
        PageError: The page is not built into this installation.
    """
    if document is not None and not hasattr(document, "to_dict"):
        found = type(document).__name__
        raise InputError(
            "wrong-type",
            "document",
            f"found a {found}",
            "give a carom.Shot, carom.Trace or carom.Study",
        )
    if title is not None:
        checked_text("title", title)
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
        before, marker, after = page.partition(MARKER)
        if not marker:
            raise PageError(
                f"{path()} is not a page of this version of carom; run `make page` again"
            )
        page = before + marker + json_of(document) + after
    return page


def json_of(document: Document) -> str:
    """A shot, a trace or a study as JSON that may stand in a script element.

    Raises:
        InputError: It is none of them.
    """
    if not hasattr(document, "to_dict"):
        found = type(document).__name__
        raise InputError(
            "wrong-type",
            "document",
            f"found a {found}",
            "give a carom.Shot, carom.Trace or carom.Study",
        )
    # In JSON, < occurs only within strings. Escaped, no string can end the script element.
    return json.dumps(document.to_dict(), separators=(",", ":")).replace("<", "\\u003c")


def checked_height(height: int) -> int:
    """A height of an element, CSS pixels.

    Raises:
        InputError: It is out of range.
    """
    return whole("height", height, MOST_HEIGHT + 1, low=1)


def iframe(document: Document, *, height: int = HEIGHT) -> str:
    """The page as an element of another page; it needs nothing else.

    It runs in a sandbox, so that it can neither read nor change the page around it.

    Args:
        document: The shot to aim, the trace to replay or the study to read.
        height: Height of the element, CSS pixels.

    Raises:
        InputError: ``document`` is no shot, trace or study, or the height is out of range.
        PageError: The page is not built into this installation.
    """
    height = checked_height(height)
    # Inside double quotes only these two characters need to be escaped.
    page = html(document).replace("&", "&amp;").replace('"', "&quot;")
    return (
        f'<iframe srcdoc="{page}" sandbox="allow-scripts allow-downloads" '
        'allow="fullscreen; clipboard-write" title="carom" '
        f'style="width: 100%; height: {height}px; border: 0"></iframe>'
    )


def __getattr__(name: str) -> object:
    if name == "show":
        warn("carom.page.show()", "carom.notebook.show()")
        return import_module("carom.notebook").show
    if name == "frame":
        warn("carom.page.frame()", "carom.page.iframe()")
        return iframe
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
