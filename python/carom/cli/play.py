"""``carom play``: the page in the browser, or as a file."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import carom
from carom import _core
from carom.cli.output import file_name, format_of, keep_sockets, read
from carom.errors import InputError
from carom.files import write_whole

if TYPE_CHECKING:
    from carom.page import Document


def play(
    file: Annotated[
        str | None,
        typer.Argument(
            metavar="FILE", help="A shot to aim, a trace to replay or a study to read; - is stdin."
        ),
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
    html: Annotated[
        Path | None,
        typer.Option(
            "--html",
            metavar="OUT",
            help="Write the page into a file that works offline; no server.",
        ),
    ] = None,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")
    ] = True,
) -> None:
    """Aim, shoot, replay and read studies in the browser; Ctrl-C ends the command."""
    if html is not None:
        write_whole(html, carom.page.html(None if file is None else _document(file)))
        return
    # A shell makes the commands that it starts in the background ignore SIGINT, which would
    # otherwise end this one.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    keep_sockets()
    document = None if file is None else _document(file)
    carom.serve.serve(
        carom.page.html(document),
        port=port,
        browser=browser,
        beside=carom.page.beside(),
        # Without a network a browser shows the page itself, not the last shot.
        kept=document is None,
    )


def _document(path: str) -> Document:
    name = file_name(path)
    text = read(path)
    kind = format_of(_core.read_json(text, name))
    if kind.startswith("carom-trace"):
        return carom.Trace._read(text, name)
    if kind.startswith("carom-study"):
        return carom.Study._read(text, name)
    if kind.startswith(("carom-drill", "carom-backup", "carom-progress")):
        raise InputError(
            "unsupported",
            "format",
            f"{name}: a file {kind} is opened by the page itself",
            "run `carom play` without a file, and drop the file on the page",
        )
    # The error for any other file describes a shot file.
    return carom.Shot._read(text, name)
