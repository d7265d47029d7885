"""``carom learn check``: tracks of balls that a camera saw."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from carom import learn as tracks_of
from carom.cli.output import emit_answer, say
from carom.cli.values import numbers
from carom.errors import InputError

learn = typer.Typer(
    no_args_is_help=True, help="Learn a table and its players from tracks of balls."
)


@learn.callback()
def _group() -> None:
    """Keep ``check`` a command of its own while it is the only one."""


@learn.command()
def check(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="TRACKS",
            help="CSV or Parquet, a simulated system of pooltool, or shots of tailuge/billiards.",
        ),
    ],
    columns: Annotated[
        str | None,
        typer.Option(
            metavar="KEY=NAME,...",
            help="Names of columns: shot, ball, t, x, y, sigma, visible, as in t=time,x=px.",
        ),
    ] = None,
    table: Annotated[
        str | None, typer.Option(metavar="NAME", help="The table, such as carom-10ft.")
    ] = None,
    radius: Annotated[float | None, typer.Option(help="Radius of the balls, m.")] = None,
    unit: Annotated[
        str | None,
        typer.Option(help="Unit of x and y: m, dm, cm, mm, in, ft, or the metres in it."),
    ] = None,
    origin: Annotated[
        str | None,
        typer.Option(
            metavar="corner|centre|X,Y",
            help="Origin of x and y, or where the table's centre is in them.",
        ),
    ] = None,
    x: Annotated[
        str | None,
        typer.Option("--x", metavar="width|length", help="Side of the table along which x runs."),
    ] = None,
    mirrored: Annotated[
        bool | None,
        typer.Option(
            "--mirrored/--not-mirrored", help="Whether y points to the right of x, seen from above."
        ),
    ] = None,
    time_unit: Annotated[
        str | None, typer.Option(metavar="s|ms|us|frame", help="Unit of the times.")
    ] = None,
    rate: Annotated[float | None, typer.Option(help="Pictures per second, Hz.")] = None,
    sigma: Annotated[
        float | None, typer.Option(help="Standard deviation of a coordinate, m.")
    ] = None,
    least_move: Annotated[
        float | None,
        typer.Option(help="Distance that a ball moves before a sample of it is stored, m."),
    ] = None,
    cut: Annotated[
        bool, typer.Option("--cut", help="Cut recordings into shots where all balls rest.")
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="OUT",
            help="Write the tracks as carom-tracks/1: .csv, .csv.gz or .parquet, and its header.",
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print the report as JSON.")] = False,
) -> None:
    """Read tracks; print what was repaired, the noise and the quality of each shot."""
    given: dict[str, Any] = {
        "columns": None if columns is None else _columns(columns),
        "table": table,
        "radius": radius,
        "unit": None if unit is None else _unit(unit),
        "origin": None if origin is None else _origin(origin),
        "x": x,
        "mirrored": mirrored,
        "time_unit": time_unit,
        "rate": rate,
        "sigma": sigma,
        "least_move": least_move,
    }
    tracks = tracks_of.read_tracks(file, **given)
    if cut:
        tracks = tracks_of.cut_into_shots(tracks)
    if out is not None:
        header = tracks.header.in_table_frame()
        tracks_of.write_tracks(tracks_of.Tracks(header, tracks.shots), out)
        say(f"wrote {out} and {out}.json")
    emit_answer(tracks_of.check(tracks), json=json)


def _columns(text: str) -> dict[str, str]:
    found = {}
    for part in text.split(","):
        key, sign, name = part.partition("=")
        if not sign or not key.strip() or not name.strip():
            raise InputError(
                "syntax", "--columns", f"{part!r} is not KEY=NAME", "write such as t=time,x=px"
            )
        found[key.strip()] = name.strip()
    return found


def _unit(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def _origin(text: str) -> str | tuple[float, float]:
    if "," not in text:
        return text
    x, y = numbers("origin", text, ",", "X,Y", 2)
    return x, y
