"""``carom sweep``: a table of shots, to Parquet."""

from __future__ import annotations

import json as js
import sys
from pathlib import Path
from typing import Annotated

import typer

from carom.cli.output import emit, keep_sockets, read, say


def sweep(
    file: Annotated[str, typer.Argument(metavar="SPEC", help="A spec, JSON; - is stdin.")],
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="Where the files go.")],
    threads: Annotated[
        int | None, typer.Option(min=1, help="How many; one per core if left out.")
    ] = None,
    part_rows: Annotated[
        int | None, typer.Option(min=1, help="Rows of a file; else as the sweep's size wants it.")
    ] = None,
    ray: Annotated[bool, typer.Option("--ray", help="Play on Ray, started here.")] = False,
    address: Annotated[
        str | None,
        typer.Option(
            "--address",
            metavar="ADDRESS",
            help="Play on this Ray cluster, whose machines all see DIR; auto is the one of here.",
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print the summary as JSON.")] = False,
) -> None:
    """Play a table of shots to Parquet; after a kill, go on."""
    from carom import Sweep

    if address or ray:
        keep_sockets()
    spec = Sweep.from_json(read(file)) if file == "-" else Sweep.load(file)
    try:
        report = spec.run(
            out,
            threads=threads,
            part_rows=part_rows,
            ray=address or ray,
            progress=sys.stderr.isatty(),
        )
    except KeyboardInterrupt:
        say("stopped; the same command goes on from here")
        raise
    emit(js.dumps(report.to_dict()) if json else str(report))
