"""``carom shot`` and ``carom break``: simulate one shot and show it."""

from __future__ import annotations

import json as js
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

import carom
from carom.cli.output import emit, read_shot
from carom.event_table import plain, rich_table
from carom.files import write_whole
from carom.lazy import LazyModule
from carom.reference import rule_sets

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
    until: Annotated[
        float | None,
        typer.Option(
            "--until",
            metavar="S",
            help="End the shot at this time, s, also if balls still move; default: as in the file.",
        ),
    ] = None,
    json: Json = False,
    html: Html = None,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Simulate a shot file; print its table of events."""
    asked = read_shot(file)
    if until is not None:
        asked = asked.with_until(until)
    trace = asked.simulate()
    title = "shot" if file == "-" else Path(file).stem.replace("_", " ").replace("-", " ")
    _show(trace, title, json=json, html=html, svg=svg, png=png)


def break_(
    game: Annotated[
        str,
        typer.Option(help=f"{', '.join(rule_sets())}."),
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
    preset: Annotated[
        str | None,
        typer.Option(help="How players open the game; --presets lists them."),
    ] = None,
    presets: Annotated[
        bool, typer.Option("--presets", help="List the break presets with their sources.")
    ] = False,
    shot_file: Annotated[
        bool, typer.Option("--shot", help="Print the shot file instead of simulating it.")
    ] = False,
    json: Json = False,
    html: Html = None,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Break a rack; print the table of events."""
    if presets:
        known = carom.break_presets()
        emit(js.dumps(known, indent=2) if json else "\n\n".join(map(_preset, known)))
        return
    the_break = carom.break_shot(game, table=table, speed=speed, seed=seed, gap=gap, preset=preset)
    if shot_file:
        emit(the_break.to_json())
        return
    _show(the_break.simulate(), f"{game} break", json=json, html=html, svg=svg, png=png)


def _preset(preset: dict[str, Any]) -> str:
    place = preset["place"]
    words = place if isinstance(place, str) else ", ".join(f"{k}: {v} m" for k, v in place.items())
    values = {
        "place": words,
        "speed": f"{preset['speed']:g} m/s",
        "aim": f"ball {preset['aim_ball']}, {preset['aim_offset']:.3g} radii to the right",
        "side": f"{preset['side']:g} radii",
        "height": f"{preset['height']:g} radii",
        "elevation": "least clear",
        "gap": f"{1000 * preset['gap']:g} mm",
        "rack": "middle ball on the foot spot" if preset["middle_on_spot"] else "usual",
    }
    lines = (
        f"  {s['key']:<10}{values[s['key']]:<46}  {s['evidence']:<9}  {s['source']}"
        for s in preset["sources"]
    )
    return "\n".join([f"{preset['game']} {preset['name']}", *lines])


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
        write_whole(html, carom.page.html(trace, title=title))
    if svg is not None:
        write_whole(svg, carom.picture.svg(trace, title=title))
    if png is not None:
        write_whole(png, carom.picture.png(trace, title=title))
    if json:
        emit(trace.to_json())
        return
    console = rich_console.Console()
    if console.is_terminal:
        console.print(rich_table(trace.to_dict()))
    else:
        emit(plain(trace.to_dict()))
