"""``carom drill`` and ``carom puzzle``."""

from __future__ import annotations

import json as js
import random
from typing import TYPE_CHECKING, Annotated

import typer

from carom import Drill, puzzle, puzzles
from carom.cli.options import Json
from carom.cli.output import emit, file_name, read
from carom.drills import Puzzle
from carom.errors import InputError
from carom.files import write_whole
from carom.lazy import LazyModule
from carom.player import words

if TYPE_CHECKING:
    from carom.picture import diagram as picture
    from carom.picture import drill_sheet
else:
    # Matplotlib takes half a second to load.
    picture = LazyModule("carom.picture.diagram")
    drill_sheet = LazyModule("carom.picture.drill_sheet")


def drill(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A drill file; - is stdin.")],
    out: Annotated[
        str | None,
        typer.Option(
            "-o", "--out", metavar="OUT", help="Write a sheet with every step: .pdf, .svg or .png."
        ),
    ] = None,
    paper: Annotated[str, typer.Option(help="a4 or letter.")] = "a4",
) -> None:
    """Print the steps of a drill and their goals, or write its sheet."""
    found = Drill._read(read(file), file_name(file))
    if out is not None:
        drill_sheet.save(found, out, paper=paper)  # type: ignore[arg-type] # checked there
        return
    lines = [f"{found.name}: {found.attempts} attempts, order {found.order}"]
    if found.misses is not None:
        lines.append(f"It ends after {found.misses} misses.")
    if found.text:
        lines.append(found.text)
    lines += [f"{k}. {step.words()}" for k, step in enumerate(found.steps, 1)]
    emit("\n".join(lines))


def puzzle_command(
    name: Annotated[
        str | None,
        typer.Argument(metavar="[ID]", help="Such as cut-17; default: the seed chooses."),
    ] = None,
    theme: Annotated[
        str | None, typer.Option(help="Choose one of this theme, such as three-cushion.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Which one is chosen.")] = 0,
    list_: Annotated[
        bool, typer.Option("--list", help="Print the ids and ratings of all puzzles instead.")
    ] = False,
    solution: Annotated[
        bool, typer.Option("--solution", help="Print the ways that solve it, with their chances.")
    ] = False,
    out: Annotated[
        str | None,
        typer.Option(
            "-o",
            "--out",
            metavar="OUT",
            help="Write the position: .json for a shot file; .svg, .png or .pdf for a diagram; "
            "with --solution the shot that solves it.",
        ),
    ] = None,
    json: Json = False,
) -> None:
    """Print a puzzle: its position, its goal and its difficulty."""
    known = puzzles(theme)
    if list_:
        emit(js.dumps(known, indent=1) if json else "\n".join(f"{k} {v}" for k, v in known.items()))
        return
    if name is None:
        name = random.Random(seed).choice(list(known))
    elif theme is not None:
        what = "an id has its theme already"
        raise InputError("conflict", "theme", what, "give one of the two")
    found = puzzle(name)
    if out is not None:
        _write(found, out, solution)
    elif json:
        emit(js.dumps(found.to_dict(), indent=1))
    else:
        emit("\n".join(_lines(found, solution)))


def _write(found: Puzzle, out: str, solution: bool) -> None:
    shot = found.solution() if solution else found.shot
    if out.endswith(".json"):
        write_whole(out, shot.to_json() + "\n")
        return
    picture.save(shot if solution else found.layout(), out, title=found.words())


def _lines(found: Puzzle, solution: bool) -> list[str]:
    lines = [f"{found.id}: difficulty {found.rating:.0f}", found.words()]
    for ball in found.shot.to_dict()["balls"]:
        x, y = ball["position"]
        lines.append(f"  {ball['id']:<7} {x:.3f} {y:.3f} m")
    lines.append("  ".join(f"{level} {chance:.0%}" for level, chance in found.chances.items()))
    if solution:
        for k, way in enumerate(found.ways, 1):
            s = way.strike
            strike = words.strike(s["speed"], s["side"], s["height"], s["elevation"])
            azimuth = f"azimuth {s['azimuth'] * 57.29577951308232:.2f}°"
            lines.append(f"way {k}: {strike}, {azimuth}; club {way.chances['club']:.0%}")
    return lines
