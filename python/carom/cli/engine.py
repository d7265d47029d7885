"""``carom replay``, ``carom validate`` and ``carom bench``: checks of the engine."""

from __future__ import annotations

import json as js
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

import carom
from carom.cli.output import emit, file_name, read
from carom.errors import InputError
from carom.lazy import LazyModule

if TYPE_CHECKING:
    from carom import validation
else:
    validation = LazyModule("carom.validation")


def replay(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A saved trace; - is stdin.")],
    check: Annotated[
        bool, typer.Option("--check", help="Compare every bit with the saved trace.")
    ] = False,
) -> None:
    """Simulate the shot of a saved trace again; print the trace."""
    text = read(file)
    saved = carom.Trace._read(text, file_name(file))
    again = _simulated(saved.shot)
    if not check:
        emit(again.to_json())
        return
    # From the file's own text, because reading a trace derives its outcome from the events.
    written, ours = js.loads(text.removeprefix("\ufeff")), again.to_dict()
    difference = saved.difference(again) or _other_outcome(written, ours)
    if difference is not None:
        engine = ""
        if written["engine"] != ours["engine"]:
            engine = f"; it was saved by {written['engine']}, and this is {ours['engine']}"
        raise InputError("changed", file, f"not reproduced: {difference}{engine}")
    emit(f"reproduced bit by bit: {len(again)} events, hash {again.hash}")


def _simulated(shot: carom.Shot) -> carom.Trace:
    """The trace of a shot, also if it ends at its cap of events."""
    try:
        return shot.simulate()
    except carom.EventCapError as error:
        return error.trace


def _other_outcome(written: dict[str, Any], ours: dict[str, Any]) -> str | None:
    """The first difference of the saved outcome, in the keys that this engine has."""
    outcome = written.get("outcome")
    if not isinstance(outcome, dict):
        return "outcome: the key is missing"
    for key, value in ours["outcome"].items():
        if outcome.get(key, value) != value:
            return f"outcome.{key}: {js.dumps(outcome[key])} against {js.dumps(value)}"
    return None


def validate(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="The paper; default: all papers.")
    ] = None,
) -> None:
    """Compare published numbers with the engine's.

    Prints each pair of numbers with its tolerance, and the counts by kind.
    """
    if name is not None and name not in validation.papers():
        known = ", ".join(validation.papers())
        raise InputError(
            "unknown-name", "NAME", f"there is no paper {name!r}", f"write one of {known}"
        )
    raise typer.Exit(validation.run(name))


def bench(
    json: Annotated[bool, typer.Option("--json", help="Print the measurements as JSON.")] = False,
    store: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Write the JSON into this folder; in a checkout, benches/results."
        ),
    ] = None,
) -> None:
    """Measure the speed of the engine on this machine.

    If pooltool is installed, it is measured too.
    """
    raise typer.Exit(carom.bench.run(json=json, store=store))
