"""``carom replay``, ``carom validate``, ``carom bench``: is the engine what it says it is?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from carom.cli.output import emit, read
from carom.errors import InputError


def replay(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A saved trace; - is stdin.")],
    check: Annotated[
        bool, typer.Option("--check", help="Compare every bit with the saved trace.")
    ] = False,
) -> None:
    """Simulate the shot of a saved trace again."""
    from carom import Trace

    saved = Trace.from_json(read(file))
    again = saved.shot.simulate()
    if not check:
        emit(again.to_json())
        return
    difference = saved.difference(again)
    if difference is not None:
        raise InputError(f"{file}: not reproduced: {difference}")
    emit(f"reproduced bit by bit: {len(again)} events, hash {again.hash}")


def validate(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="One paper; all without it.")
    ] = None,
) -> None:
    """Print published numbers, ours, their difference and the tolerance."""
    from carom import validation

    if name is not None and name not in validation.papers():
        known = ", ".join(validation.papers())
        raise InputError(f"there is no paper {name!r}; there are: {known}")
    raise typer.Exit(validation.run(name))


def bench(
    json: Annotated[bool, typer.Option("--json", help="Print the measurements as JSON.")] = False,
    store: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write the JSON there; in a checkout, benches/results."),
    ] = None,
) -> None:
    """Measure how fast the engine is here, beside pooltool where that is installed."""
    from carom import bench as benchmark

    raise typer.Exit(benchmark.run(json=json, store=store))
