"""``carom sweep``: a table of shots, to Parquet."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

import carom
from carom.cli.output import emit_answer, file_name, keep_sockets, read, say


def sweep(
    file: Annotated[str, typer.Argument(metavar="SPEC", help="A sweep's spec, JSON; - is stdin.")],
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="Folder for the files.")],
    threads: Annotated[
        int | None, typer.Option(min=1, help="Number of threads; default: one per core.")
    ] = None,
    part_rows: Annotated[
        int | None,
        typer.Option(
            min=1, help="Rows of a file; default: chosen from the number of rows of the sweep."
        ),
    ] = None,
    ray: Annotated[
        bool, typer.Option("--ray", help="Simulate on Ray, started on this machine.")
    ] = False,
    address: Annotated[
        str | None,
        typer.Option(
            "--address",
            metavar="ADDRESS",
            help="Simulate on this Ray cluster, whose machines must all have access to DIR; auto "
            "is the cluster of this machine.",
        ),
    ] = None,
    device: Annotated[str, typer.Option("--device", help="cpu, or a card: cuda, cuda:1.")] = "cpu",
    json: Annotated[bool, typer.Option("--json", help="Print the summary as JSON.")] = False,
) -> None:
    """Simulate a table of shots to Parquet.

    After a stop the same command continues.
    """
    if address or ray:
        keep_sockets()
    spec = carom.Sweep._read(read(file), file_name(file), Path(file).parent)
    try:
        report = spec.run(
            out,
            threads=threads,
            part_rows=part_rows,
            ray=address or ray,
            device=device,
            progress=sys.stderr.isatty(),
        )
    except KeyboardInterrupt:
        say("stopped; the same command continues from here")
        raise
    emit_answer(report, json=json)
