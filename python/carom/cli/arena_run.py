"""``carom arena run``: a tournament."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

import carom
from carom.cli.options import Json
from carom.cli.output import emit_answer, keep_sockets, say


def run(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="The file of a tournament, TOML or JSON.")
    ],
    out: Annotated[
        Path | None,
        typer.Option(
            "--out", metavar="DIR", help="Folder for the matches; default: that of FILE's name."
        ),
    ] = None,
    threads: Annotated[
        int | None, typer.Option(min=1, help="Matches at once; default: one per core.")
    ] = None,
    processes: Annotated[
        int | None,
        typer.Option(
            min=1, help="Number of processes, in place of threads, for players in Python."
        ),
    ] = None,
    ray: Annotated[
        bool, typer.Option("--ray", help="Play on Ray, started on this machine.")
    ] = False,
    address: Annotated[
        str | None,
        typer.Option(
            "--address",
            metavar="ADDRESS",
            help="Play on this Ray cluster; auto is the cluster of this machine.",
        ),
    ] = None,
    json: Json = False,
) -> None:
    """Play the matches of a tournament that its folder does not have yet.

    After a stop the same command continues. After a change of FILE, such as a further player, it
    plays what is missing.
    """
    if address or ray:
        keep_sockets()
    tournament = carom.arena.Tournament.load(file)
    try:
        result = tournament.run(
            file.with_suffix("") if out is None else out,
            threads=threads,
            processes=processes,
            ray=address or ray,
            progress=sys.stderr.isatty(),
        )
    except KeyboardInterrupt:
        say("stopped; the same command continues from here")
        raise
    emit_answer(result, json=json)
