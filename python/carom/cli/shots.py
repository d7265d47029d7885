"""``carom shot`` and ``carom break``: simulate one shot and show it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import carom
from carom.cli.output import emit, read, save
from carom.event_table import plain, rich_table
from carom.lazy import LazyModule

if TYPE_CHECKING:
    import rich.console as rich_console
else:
    rich_console = LazyModule("rich.console")

Json = Annotated[bool, typer.Option("--json", help="Print the trace (carom-trace/1).")]
Html = Annotated[
    Path | None,
    typer.Option("--html", metavar="OUT", help="Write a page that replays the shot."),
]
Svg = Annotated[Path | None, typer.Option("--svg", metavar="OUT", help="Write a picture (SVG).")]
Png = Annotated[Path | None, typer.Option("--png", metavar="OUT", help="Write a picture (PNG).")]


def shot(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A shot file; - is stdin.")],
    json: Json = False,
    html: Html = None,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Simulate a shot file; print its table of events."""
    trace = carom.Shot.from_json(read(file)).simulate()
    title = "shot" if file == "-" else Path(file).stem.replace("_", " ").replace("-", " ")
    _show(trace, title, json=json, html=html, svg=svg, png=png)


def break_(
    game: Annotated[
        str,
        typer.Option(
            help="nine-ball, eight-ball, ten-ball, straight-pool, snooker or three-cushion."
        ),
    ] = "nine-ball",
    speed: Annotated[
        float | None, typer.Option(help="The cue's speed, m/s; default: the game's usual one.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the random rack.")] = 0,
    table: Annotated[
        str | None, typer.Option(help="A table's preset; default: the game's own.")
    ] = None,
    gap: Annotated[
        float | None,
        typer.Option(help="Mean gap between the balls, m; 0 is frozen; default: 0.0001."),
    ] = None,
    shot_file: Annotated[
        bool, typer.Option("--shot", help="Print the shot file instead of simulating it.")
    ] = False,
    json: Json = False,
    html: Html = None,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Break a rack; print the table of events."""
    the_break = carom.break_shot(game, table=table, speed=speed, seed=seed, gap=gap)
    if shot_file:
        emit(the_break.to_json())
        return
    _show(the_break.simulate(), f"{game} break", json=json, html=html, svg=svg, png=png)


def _show(
    trace: carom.Trace,
    title: str,
    *,
    json: bool,
    html: Path | None,
    svg: Path | None,
    png: Path | None,
) -> None:
    if html is not None:
        save(html, carom.page.html(trace, title=title))
    if svg is not None:
        save(svg, carom.picture.svg(trace, title=title))
    if png is not None:
        save(png, carom.picture.png(trace, title=title))
    if json:
        emit(trace.to_json())
        return
    console = rich_console.Console()
    if console.is_terminal:
        console.print(rich_table(trace.to_dict()))
    else:
        emit(plain(trace.to_dict()))
