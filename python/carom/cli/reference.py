"""``carom tables`` and ``carom schema``: what the engine knows by itself."""

from __future__ import annotations

import json as js
from typing import Annotated, Any

import typer

from carom.cli.output import emit


def tables(
    json: Annotated[bool, typer.Option("--json", help="Print every dimension as JSON.")] = False,
) -> None:
    """Print the tables' presets with their dimensions."""
    from carom import tables as presets

    known = presets()
    if json:
        emit(js.dumps(known, indent=2))
        return
    emit("\n\n".join(_describe(table) for table in known))


def schema(
    kind: Annotated[str, typer.Argument(metavar="[shot|trace]", help="Which file.")] = "shot",
) -> None:
    """Print the JSON Schema of the shot file or of the trace."""
    from carom import schema as schema_of

    emit(js.dumps(schema_of(kind), indent=2))  # type: ignore[arg-type] # checked there


def _describe(table: dict[str, Any]) -> str:
    width, length = table["size"]
    lines = [
        f"{table['name']}",
        f"  playing area    {width:.4f} x {length:.4f} m",
        f"  cushion height  {1000 * table['cushion_height']:.1f} mm",
    ]
    for index, pocket in enumerate(table["pockets"]):
        x, y = pocket["center"]
        lines.append(
            f"  pocket {index}        {pocket['name']:<12}  hole at ({x:.4f}, {y:.4f}) m, "
            f"radius {1000 * pocket['radius']:.1f} mm"
        )
    if not table["pockets"]:
        lines.append("  no pockets")
    return "\n".join(lines)
