"""``carom play``: the page in the browser."""

from __future__ import annotations

import json
import signal
from typing import TYPE_CHECKING, Annotated

import typer

from carom.cli.output import keep_sockets, read

if TYPE_CHECKING:
    from carom.shot import Shot
    from carom.trace import Trace


def play(
    file: Annotated[
        str | None,
        typer.Argument(metavar="FILE", help="A shot to aim or a trace to replay; - is stdin."),
    ] = None,
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="Port on this machine; 0 is a free one.")
    ] = 0,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")
    ] = True,
) -> None:
    """Aim, shoot and replay in the browser; Ctrl-C ends."""
    from carom.page import html
    from carom.serve import serve

    # A shell that starts it in the background has it ignore the interrupt that ends it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    keep_sockets()
    document = None if file is None else _document(read(file))
    serve(html(document), port=port, browser=browser)


def _document(text: str) -> Shot | Trace:
    from carom import Shot, Trace

    try:
        file = json.loads(text)
    except (ValueError, RecursionError):
        file = None
    if isinstance(file, dict) and str(file.get("format", "")).startswith("carom-trace"):
        return Trace.from_json(text)
    # What is neither is told what a shot file would be.
    return Shot.from_json(text)
