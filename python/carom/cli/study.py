"""``carom study``: checks studies."""

from __future__ import annotations

from typing import Annotated

import typer

from carom import Study
from carom.cli.options import Json
from carom.cli.output import emit_answer, file_name, read

study = typer.Typer(
    help="Studies: chapters of a position, a text, shots and a task.", no_args_is_help=True
)


@study.command("check")
def check(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A study; - is stdin.")],
    json: Json = False,
) -> None:
    """Simulate the shots of every chapter, and judge the solutions of its tasks.

    The exit code is 1 if a shot cannot be played or a solution does not meet its goal.
    """
    report = Study._read(read(file), file_name(file)).check()
    emit_answer(report, json=json)
    if not report.ok:
        raise typer.Exit(1)
