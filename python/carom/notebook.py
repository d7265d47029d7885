"""Cells of a Jupyter notebook: each has a picture and its shot, and one of them has the page.

The page weighs megabytes, so a notebook has it once, compressed, in the output of the first cell
that shows something. A script in every cell replaces the picture by the page as soon as the page
is there, in whichever order cells run or a saved notebook is drawn. Without scripts (a notebook
that is not trusted, a preview) or without the page the picture stays.
"""

from __future__ import annotations

import base64
import functools
import gzip
import hashlib
import json
import sys
from collections.abc import Callable
from html import escape
from typing import Any

from carom import page
from carom.errors import InputError

# Resolutions of the picture, from the best one, dots per inch, and the largest picture, bytes. With
# its shot or trace a cell then has less than 300 kB.
_DOTS_PER_INCH = (80, 60, 40, 25)
_LARGEST_PICTURE = 150_000

# What runs in every cell. `cells` are this cell and all others that wait for the page.
_SCRIPT = """
(() => {
  const inflate = async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).text();
  };
  const pages = (window.caromPages ??= {});
  const open = async (cell) => {
    const page = await inflate(pages[cell.dataset.caromPage]);
    const shown = await inflate(cell.dataset.caromDocument);
    const marker = MARKER;
    const at = page.indexOf(marker) + marker.length;
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts allow-downloads");
    frame.setAttribute("allow", "fullscreen; clipboard-write");
    frame.title = "carom";
    frame.style.cssText = `width: 100%; height: ${cell.dataset.caromHeight}px; border: 0`;
    frame.srcdoc = page.slice(0, at) + shown + page.slice(at);
    cell.replaceChildren(frame);
  };
  window.caromOpen = () => {
    for (const cell of document.querySelectorAll("[data-carom-document]")) {
      if (cell.dataset.caromPage in pages && !("caromOpened" in cell.dataset)) {
        cell.dataset.caromOpened = "";
        open(cell);
      }
    }
  };
  PAGE
  // Once more after the notebook has put the output into the document.
  window.caromOpen();
  setTimeout(window.caromOpen, 0);
})();
"""

# Draws a shot, a trace or a frame: a PNG file of that resolution. carom/__init__.py registers it,
# because this module must not import the layers above it.
_drawn: dict[str, Callable[[Any, int], bytes]] = {}

# The cell whose output has the page, and the number of its run; None before there is one.
_carrier: tuple[object, object] | None = None


def image(found: Any) -> str:
    """The picture of a shot, a trace or a frame as an element that needs no script.

    Without the extra ``picture`` it is the sentence that names it.
    """
    for dots in _DOTS_PER_INCH:
        try:
            drawn = _drawn["png"](found, dots)
        except InputError as error:
            if error.kind != "unsupported":
                raise
            return f"<p>{escape(str(error))}</p>"
        if len(drawn) <= _LARGEST_PICTURE:
            break
    data = base64.b64encode(drawn).decode()
    return (
        f'<img src="data:image/png;base64,{data}" alt="carom" '
        'style="max-width: 100%; background: none">'
    )


def cell(document: page.Document, *, height: int = page.HEIGHT) -> str:
    """The output of a cell for a shot or a trace.

    In a Jupyter kernel it is the picture with its shot, and the page if this notebook does not have
    it yet. Elsewhere, and where every cell is a document of its own (Colab), it is the whole page.

    Raises:
        InputError: ``document`` is neither a shot nor a trace, or the height is out of range.
        PageError: The page is not built into this installation.
    """
    run = _run()
    if run is None:
        return page.iframe(document, height=height)
    height = page.checked_height(height)
    key, packed = _page(page.html())
    shown = _pack(page.json_of(document))
    carried = f'pages["{key}"] = "{packed}";' if _carries(run) else ""
    script = _SCRIPT.replace("MARKER", json.dumps(page.MARKER).replace("</", "<\\/"))
    # A script ends at the first "</script", also within a text.
    script = script.replace("<script", "\\x3cscript").replace("PAGE", carried)
    return (
        f'<div data-carom-page="{key}" data-carom-height="{height}" data-carom-document="{shown}">'
        f"{image(document)}</div><script>{script}</script>"
    )


def show(document: page.Document, *, height: int = page.HEIGHT) -> None:
    """Show a shot or a trace in the notebook; outside a notebook, in the browser until Ctrl-C.

    Raises:
        InputError: As from :func:`cell`.
        PageError: The page is not built into this installation.
    """
    if hasattr(_shell(), "kernel"):
        # IPython is there only in a notebook.
        from IPython.display import HTML, display

        display(HTML(cell(document, height=height)))
        return
    # A server's modules take as long to load as half of carom.
    from carom.serve import serve

    serve(page.html(document), beside=page.beside())


def _shell() -> Any:
    ipython = sys.modules.get("IPython")
    return ipython.get_ipython() if ipython else None


def _run() -> tuple[object, object] | None:
    """The cell that runs and the number of its run; None outside Jupyter's notebooks."""
    shell = _shell()
    if not hasattr(shell, "kernel") or "google.colab" in sys.modules:
        return None
    parent = shell.get_parent() if hasattr(shell, "get_parent") else {}
    return parent.get("metadata", {}).get("cellId"), getattr(shell, "execution_count", None)


def _carries(run: tuple[object, object]) -> bool:
    """Whether the output of this run has the page: the first, and that of its cell run again."""
    global _carrier  # noqa: PLW0603 # one notebook per kernel
    if _carrier is not None and (run[0] is None or run[0] != _carrier[0] or run == _carrier):
        return False
    _carrier = run
    return True


@functools.cache
def _page(text: str) -> tuple[str, str]:
    """A short name of a page, and the page compressed."""
    return hashlib.sha256(text.encode()).hexdigest()[:12], _pack(text)


def _pack(text: str) -> str:
    return base64.b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode()
