"""``carom arena ladder``: the standing table of the built-in players."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from carom.arena.tournament import LADDER
from carom.cli import arena_run
from carom.cli.options import Json


def ladder(
    out: Annotated[
        Path, typer.Option("--out", metavar="DIR", help="Folder for the matches.")
    ] = Path("ladder"),
    threads: Annotated[
        int | None, typer.Option(min=1, help="Matches at once; default: one per core.")
    ] = None,
    json: Json = False,
) -> None:
    """Play the tournament of the built-in players.

    All players play eight-ball, and three players each other game, at three noises. After a stop
    the same command continues.
    """
    arena_run.run(LADDER, out, threads, json=json)
