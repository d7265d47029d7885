"""``carom play``: the page in the browser."""

from __future__ import annotations

import json
import signal
from typing import Annotated

import typer

import carom
from carom.cli.output import file_name, keep_sockets, read


def play(
    file: Annotated[
        str | None,
        typer.Argument(metavar="FILE", help="A shot to aim or a trace to replay; - is stdin."),
    ] = None,
    port: Annotated[
        int | None,
        typer.Option(
            min=0,
            max=65535,
            help="Port on this machine; 0 chooses a free one. Without this option the port is "
            "the same at every start, unless it is in use.",
        ),
    ] = None,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")
    ] = True,
) -> None:
    """Aim, shoot and replay in the browser; Ctrl-C ends the command."""
    # A shell makes the commands that it starts in the background ignore SIGINT, which would
    # otherwise end this one.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    keep_sockets()
    document = None if file is None else _document(read(file), file_name(file))
    carom.serve.serve(
        carom.page.html(document),
        port=port,
        browser=browser,
        beside=carom.page.beside(),
        # Without a network a browser shows the page itself, not the last shot.
        kept=document is None,
    )


def _document(text: str, name: str) -> carom.Shot | carom.Trace:
    try:
        file = json.loads(text)
    except (ValueError, RecursionError):
        file = None
    if isinstance(file, dict) and str(file.get("format", "")).startswith("carom-trace"):
        return carom.Trace._read(text, name)
    # The error for any other text describes a shot file.
    return carom.Shot._read(text, name)
