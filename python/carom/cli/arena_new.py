"""``carom arena new``: the template of a program."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from carom.arena.new_program import TEMPLATES, new_program
from carom.cli.output import emit


def new(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="The new folder.")],
    language: Annotated[
        str, typer.Option(help=f"The language: {', '.join(TEMPLATES)}.")
    ] = "python",
) -> None:
    """Write a program that plays, ready to run, and a README."""
    files = new_program(folder, language)
    emit("\n".join(str(file) for file in files))
