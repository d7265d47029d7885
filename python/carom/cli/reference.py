"""``carom tables``, ``carom physics`` and ``carom schema``: presets and file formats."""

from __future__ import annotations

import json as js
from typing import Annotated, Any

import typer

import carom
from carom.cli.output import emit
from carom.cli.values import numbers


def tables(
    json: Annotated[bool, typer.Option("--json", help="Print every dimension as JSON.")] = False,
) -> None:
    """Print the tables' presets with their dimensions."""
    known = carom.tables()
    if json:
        emit(js.dumps(known, indent=2))
        return
    emit("\n\n".join(_describe(table) for table in known))


def physics(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="A preset, with or without a date.")
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="Print every value as JSON.")] = False,
    rolling_bands: Annotated[
        str | None,
        typer.Option(
            metavar="A,B",
            help="Print the speed bands of a measured deceleration of rolling balls, A + B·v "
            "(m/s², 1/s), as a value of cloth.rolling_friction.",
        ),
    ] = None,
    fastest: Annotated[
        float | None,
        typer.Option(help="Highest speed at which the bands follow the law, m/s; default: 3."),
    ] = None,
    share: Annotated[
        float | None,
        typer.Option(
            help="Largest error of the bands, as a share of a roll's length; default: 0.005."
        ),
    ] = None,
    least: Annotated[
        float | None,
        typer.Option(help="Error of the bands that is always allowed, m; default: 0.005."),
    ] = None,
    gravity: Annotated[
        float | None, typer.Option(help="Gravity for the bands, m/s²; default: 9.80665.")
    ] = None,
) -> None:
    """Print the physics presets: every value with its unit, its evidence and its source.

    With --rolling-bands, print speed bands of rolling friction instead.
    """
    options = {"fastest": fastest, "share": share, "least": least, "gravity": gravity}
    given = {key: value for key, value in options.items() if value is not None}
    if rolling_bands is not None:
        if name is not None:
            raise carom.InputError(
                "conflict", "NAME", "--rolling-bands needs no preset", "leave the name out"
            )
        a, b = numbers("rolling-bands", rolling_bands, ",", "A,B", 2)
        emit(js.dumps(carom.rolling_bands(a, b, **given)))
        return
    if given:
        option = next(iter(given))
        raise carom.InputError(
            "conflict", f"--{option}", "it belongs to speed bands", "give --rolling-bands too"
        )
    known = carom.physics()
    if name is not None:
        names = [known_name for p in known for known_name in (p["name"], p["dated_name"])]
        known = [p for p in known if name in (p["name"], p["dated_name"])]
        if not known:
            listed = ", ".join(dict.fromkeys(names))
            raise carom.InputError(
                "unknown-name",
                "name",
                f'there is no physics preset "{name}"',
                f"write one of {listed}",
            )
    if json:
        emit(js.dumps(known, indent=2))
        return
    emit("\n\n".join(_values(preset) for preset in known))


def schema(
    kind: Annotated[
        str,
        typer.Argument(
            metavar="[shot|trace|play|sweep|tournament|arena|tracks|study|drill|player]",
            help="The kind of file; arena is that of the messages of programs, tracks that of the "
            "header of tracks, player that of a learned player.",
        ),
    ] = "shot",
) -> None:
    """Print the JSON Schema of a shot, a trace, a play, or another kind of file."""
    emit(js.dumps(carom.schema(kind), indent=2))  # type: ignore[arg-type] # checked there


def _values(preset: dict[str, Any]) -> str:
    lines = [f"{preset['name']} ({preset['dated_name']})"]
    for p in preset["parameters"]:
        value = _written(p["value"])
        unit = f" {p['unit']}" if p["unit"] else ""
        lines.append(f"  {p['key']:<27}{value + unit:>16}  {p['evidence']:<9}  {p['source']}")
    return "\n".join(lines)


def _describe(table: dict[str, Any]) -> str:
    lines = [f"{table['name']} ({table['dated_name']})"]
    for dimension in table["dimensions"]:
        value = _with_unit(dimension["value"], dimension["unit"])
        lines.append(f"  {dimension['key']:<28}{value:>11}  {dimension['source'] or ''}".rstrip())
    for index, pocket in enumerate(table["pockets"]):
        x, y = pocket["center"]
        lines.append(f"  pocket {index}: {pocket['name']}, hole at ({x:.4f}, {y:.4f}) m")
    if not table["pockets"]:
        lines.append("  no pockets")
    return "\n".join(lines)


def _with_unit(value: float, unit: str) -> str:
    if unit == "m" and value < 1.0:
        return f"{1000 * value:.2f} mm"
    return f"{value:.4f} m" if unit == "m" else f"{value:.2f} {unit}"


def _written(value: str | float | list[dict[str, float]]) -> str:
    """A value of the physics; the range of the friction for a list of speed bands."""
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        frictions = [band["friction"] for band in value]
        return f"{min(frictions):.3g}–{max(frictions):.3g}"
    return f"{value:.6g}"
