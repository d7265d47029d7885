"""``carom evaluate``, ``carom solve``, ``carom map`` and ``carom stats``: questions about shots."""

from __future__ import annotations

import json as js
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

import carom
from carom import Call, CushionTable, Frame, Perception, Shot
from carom.batch import own_strike
from carom.build import like
from carom.cli import renamed
from carom.cli.options import (
    Cling,
    Draws,
    File,
    Json,
    LearnedTable,
    Level,
    NoiseName,
    Png,
    Precise,
    Seed,
    Sight,
    Svg,
    draw,
    learned_of,
    noise_of,
    title_of,
)
from carom.cli.output import emit, emit_answer, read_shot
from carom.cli.values import numbers
from carom.errors import InputError
from carom.lazy import LazyModule
from carom.plan.chance import or_null
from carom.plan.drawn_tables import on_learned_table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from carom.picture import evaluation as evaluation_picture
    from carom.picture import maps as maps_picture
    from carom.picture import solutions as solutions_picture
    from carom.picture.maps import Drawn
else:
    # Matplotlib takes half a second to load.
    evaluation_picture = LazyModule("carom.picture.evaluation")
    maps_picture = LazyModule("carom.picture.maps")
    solutions_picture = LazyModule("carom.picture.solutions")


def evaluate(
    file: File,
    noise: NoiseName = "olympiad",
    cling: Cling = 0.0,
    perception: Sight = 0.0,
    n: Annotated[int, typer.Option("-n", min=1, help="Largest number of variants.")] = 10_000,
    seed: Seed = 0,
    precision: Annotated[
        float | None,
        typer.Option(
            help="Stop when half the width of the watched interval, 0 to 1, is at most this."
        ),
    ] = None,
    watch: Annotated[
        str | None,
        typer.Option(
            metavar="WHAT",
            help="The chance that --precision watches: a ball, BALL:POCKET, scratch or legal; "
            "default: every chance.",
        ),
    ] = None,
    game: Annotated[
        str | None,
        typer.Option(
            help="The game whose rules decide what is legal; a frame starts with this shot's balls."
        ),
    ] = None,
    call: Annotated[
        str | None,
        typer.Option(
            metavar="WHAT",
            help="The call in the game: BALL:POCKET, the nominated ball of snooker, or safety.",
        ),
    ] = None,
    learned: LearnedTable = None,
    draws: Draws = 32,
    level: Level = 0.95,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print the probability of each result.

    Variants of the strike, with errors of the player, are simulated and counted.
    """
    if call is not None and game is None:
        raise InputError("missing", "--call", "a call needs a game", "give --game too")
    shot = read_shot(file)
    announced = None if call is None else _call(call)
    posterior = learned_of(learned)
    if posterior is not None:
        shot = on_learned_table(shot, posterior)
    shot, frame = (shot, None) if game is None else _in_game(shot, game, announced)
    answer = shot.evaluate(
        noise_of(noise, cling),
        n,
        perception=Perception(perception),
        seed=seed,
        precision=precision,
        watch=None if watch is None else _ball_and_pocket(watch),
        frame=frame,
        call=announced,
        posterior=posterior,
        draws=draws,
        level=level,
        progress=sys.stderr.isatty(),
    )
    emit_answer(answer, json=json)
    draw(lambda: evaluation_picture.draw(answer, title=title_of(file)), svg=svg, png=png)


def solve(
    file: File,
    pot: Annotated[
        str | None, typer.Option(metavar="BALL[:POCKET]", help="The ball to pot.")
    ] = None,
    leave: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y,R",
            help="Centre and radius of the disc in which the cue ball comes to rest, m.",
        ),
    ] = None,
    first: Annotated[
        str | None, typer.Option(metavar="BALL", help="The ball to hit before any other.")
    ] = None,
    noise: NoiseName = "olympiad",
    cling: Cling = 0.0,
    perception: Sight = 0.0,
    wanted: Annotated[int, typer.Option(min=1, help="Largest number of strikes printed.")] = 10,
    per_route: Annotated[
        int,
        typer.Option(min=1, help="Largest number of strikes over the same cushions and balls."),
    ] = 3,
    n: Annotated[
        int, typer.Option("-n", min=1, help="Largest number of variants behind each chance.")
    ] = 1000,
    precision: Precise = None,
    speed: Annotated[
        str, typer.Option(metavar="LEAST:MOST", help="Least and greatest speed of the cue, m/s.")
    ] = "0.5:7",
    elevation_deg: Annotated[
        str | None,
        typer.Option(
            metavar="[LEAST:]MOST",
            help="Largest elevation of the cue for jumps and massés, degrees; default: none are "
            "tried. With the least elevation, both are limits of every strike.",
        ),
    ] = None,
    azimuth_deg: Annotated[
        str | None,
        typer.Option(
            metavar="FIRST:LAST",
            help="Azimuths to which the cue can turn, counter-clockwise, degrees: 350:10 is a "
            "range of 20.",
        ),
    ] = None,
    butt: Annotated[
        str | None,
        typer.Option(
            metavar="X,Y,X,Y",
            help="Two corners of the rectangle in which the end of the butt must be, m.",
        ),
    ] = None,
    samples: Annotated[
        int, typer.Option(min=1, help="Strikes tried in addition to those that geometry proposes.")
    ] = 4096,
    learned: LearnedTable = None,
    draws: Draws = 32,
    seed: Seed = 0,
    level: Level = 0.95,
    best: Annotated[
        Path | None,
        typer.Option(metavar="OUT", help="Write the most probable strike as a shot file."),
    ] = None,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print the strikes that reach a goal, the most probable first."""
    shot = read_shot(file)
    area = None if leave is None else _disc(leave)
    least, most = numbers("speed", speed, ":", "LEAST:MOST", 2)
    found = shot.solve(
        pot=None if pot is None else _ball_and_pocket(pot),
        leave=area,
        first=first,
        noise=noise_of(noise, cling),
        perception=Perception(perception),
        wanted=wanted,
        per_route=per_route,
        n=n,
        precision=precision,
        speed=(least, most),
        elevation=None if elevation_deg is None else _elevation(elevation_deg),
        azimuth=None if azimuth_deg is None else _azimuth(azimuth_deg),
        butt=None if butt is None else _corners(butt),
        samples=samples,
        posterior=learned_of(learned),
        draws=draws,
        seed=seed,
        level=level,
        progress=sys.stderr.isatty(),
    )
    draw(
        lambda: solutions_picture.draw(shot, found, leave=area, title=title_of(file)),
        svg=svg,
        png=png,
    )
    if best is not None and found:
        found[0].shot.save(best)
    if json:
        emit(js.dumps([solution.to_dict() for solution in found]))
    else:
        emit("\n".join(map(str, found)) or "no strike was found")


def _elevation(text: str) -> float | tuple[float, float]:
    if ":" not in text:
        (most,) = numbers("elevation-deg", text, ":", "[LEAST:]MOST", 1)
        return math.radians(most)
    least, most = numbers("elevation-deg", text, ":", "[LEAST:]MOST", 2)
    return math.radians(least), math.radians(most)


def _azimuth(text: str) -> tuple[float, float]:
    first, last = numbers("azimuth-deg", text, ":", "FIRST:LAST", 2)
    return math.radians(first), math.radians(last)


def _corners(text: str) -> tuple[tuple[float, float], tuple[float, float]]:
    a, b, c, d = numbers("butt", text, ",", "X,Y,X,Y", 4)
    return (a, b), (c, d)


maps = typer.Typer(
    cls=renamed.group(pocket="acceptance"),
    help="Maps: a result for every cell of a grid.",
    no_args_is_help=True,
)
stats = typer.Typer(help="Statistics of many shots.", no_args_is_help=True)


@maps.command("pot")
def map_pot(
    file: File,
    ball: Annotated[str, typer.Option(help="The ball to pot.")],
    pocket: Annotated[str, typer.Option(help="The pocket; carom tables prints the names.")],
    noise: NoiseName = "olympiad",
    cling: Cling = 0.0,
    perception: Sight = 0.0,
    columns: Annotated[int, typer.Option(min=1, help="Number of cells along the width.")] = 32,
    n: Annotated[
        int, typer.Option("-n", min=1, help="Largest number of variants of each cell.")
    ] = 200,
    precision: Precise = None,
    learned: LearnedTable = None,
    draws: Draws = 32,
    seed: Seed = 0,
    level: Level = 0.95,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print the chance of a pot for each place of the cue ball."""
    shot = read_shot(file)
    found = shot.pot_map(
        ball,
        pocket,
        noise=noise_of(noise, cling),
        perception=Perception(perception),
        columns=columns,
        n=n,
        precision=precision,
        posterior=learned_of(learned),
        draws=draws,
        seed=seed,
        level=level,
        progress=sys.stderr.isatty(),
    )
    names = ("x", "y", "chance", "azimuth", "low", "high", "n")
    rows = {name: getattr(found, name) for name in names} | _degrees("azimuth", found.azimuth)
    _show(found, rows, json=json, svg=svg, png=png)


@maps.command("position")
def map_position(
    file: File,
    ball: Annotated[str, typer.Option(help="The ball to pot.")],
    pocket: Annotated[str, typer.Option(help="The pocket; carom tables prints the names.")],
    speed: Annotated[str, typer.Option(help="Speeds of the cue, m/s: FROM:TO:COUNT.")] = "0.8:4:65",
    height: Annotated[
        str, typer.Option(help="Contact heights, ball radii: FROM:TO:COUNT.")
    ] = "-0.4:0.4:5",
    side: Annotated[float, typer.Option(help="Contact point right of centre, ball radii.")] = 0.0,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print where the cue ball stops, for each speed and spin."""
    found = read_shot(file).position_map(
        ball,
        pocket,
        speed=_steps("speed", speed),
        height=_steps("height", height),
        side=side,
        progress=sys.stderr.isatty(),
    )
    rows = {
        "speed": found.speed,
        "side": found.side,
        "height": found.height,
        "falls": found.falls,
        "azimuth": found.azimuth,
        "end": found.end,
    } | _degrees("azimuth", found.azimuth)
    _show(found, rows, json=json, svg=svg, png=png)


@maps.command("acceptance")
def map_acceptance(
    file: File,
    pocket: Annotated[str, typer.Option(help="The pocket; carom tables prints the names.")],
    distance: Annotated[
        float, typer.Option(help="Distance from the start to the mouth's centre, m.")
    ] = 0.3,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print which rolling balls a pocket accepts.

    The balls differ in speed, angle to the pocket's axis, and offset.
    """
    shot = read_shot(file)
    found = shot.acceptance(pocket, distance=distance, progress=sys.stderr.isatty())
    rows = {
        "speed": found.speed,
        "angle": found.angle,
        "offset": found.offset,
        "width": found.width,
        "accepted": found.accepted,
    } | _degrees("angle", found.angle)
    _show(found, rows, json=json, svg=svg, png=png)


@maps.command("kick", cls=renamed.command(azimuth="azimuth-deg"))
def map_kick(
    file: File,
    speed: Annotated[str, typer.Option(help="Speeds of the cue, m/s: FROM:TO:COUNT.")] = "1.5:5:3",
    side: Annotated[
        str, typer.Option(help="Contact points right of centre, ball radii: FROM:TO:COUNT.")
    ] = "-0.4:0.4:3",
    azimuth_deg: Annotated[
        str, typer.Option(help="Directions, degrees: FROM:TO:COUNT.")
    ] = "0:355:72",
    cushions: Annotated[int, typer.Option(min=1, help="Largest number of cushions listed.")] = 3,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print where kicks meet the cushions.

    The struck ball is alone on the table.
    """
    found = read_shot(file).kick_table(
        azimuth=[math.radians(turn) for turn in _steps("azimuth-deg", azimuth_deg)],
        speed=_steps("speed", speed),
        side=_steps("side", side),
        cushions=cushions,
        progress=sys.stderr.isatty(),
    )
    _show_cushions(found, json=json, svg=svg, png=png)


@maps.command("bank", cls=renamed.command(azimuth="azimuth-deg"))
def map_bank(
    file: File,
    ball: Annotated[str, typer.Option(help="The ball's id.")],
    speed: Annotated[str, typer.Option(help="Speeds of the ball, m/s: FROM:TO:COUNT.")] = "1:4:3",
    azimuth_deg: Annotated[
        str, typer.Option(help="Directions, degrees: FROM:TO:COUNT.")
    ] = "0:355:72",
    cushions: Annotated[int, typer.Option(min=1, help="Largest number of cushions listed.")] = 2,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print where banks meet the cushions.

    The ball starts without spin and is alone on the table.
    """
    found = read_shot(file).bank_table(
        ball,
        azimuth=[math.radians(turn) for turn in _steps("azimuth-deg", azimuth_deg)],
        speed=_steps("speed", speed),
        cushions=cushions,
        progress=sys.stderr.isatty(),
    )
    _show_cushions(found, json=json, svg=svg, png=png)


def _show_cushions(found: CushionTable, *, json: bool, svg: Path | None, png: Path | None) -> None:
    if json:
        rows = {
            "azimuth": found.azimuth,
            "speed": found.speed,
            "side": found.side,
            "contact": found.contact,
            "rail": found.rail,
        } | _degrees("azimuth", found.azimuth)
        emit(js.dumps({name: or_null(values.tolist()) for name, values in rows.items()}))
    else:
        emit("azimuth_deg speed side  cushions: rail (x, y) m")
        for i, turn in enumerate(found.azimuth.tolist()):
            for j, speed in enumerate(found.speed.tolist()):
                for k, side in enumerate(found.side.tolist()):
                    met = zip(found.rail[i, j, k], found.contact[i, j, k].tolist(), strict=True)
                    words = ", ".join(f"{rail} ({x:.3f}, {y:.3f})" for rail, (x, y) in met if rail)
                    emit(f"{math.degrees(turn):11.2f} {speed:5.2f} {side:+.2f}  {words or '-'}")
    draw(lambda: maps_picture.draw(found), svg=svg, png=png)


@stats.command("break")
def stats_break(
    game: Annotated[str, typer.Option(help="The game, as for carom break.")] = "nine-ball",
    racks: Annotated[int, typer.Option("-n", min=1, help="Largest number of racks.")] = 1000,
    noise: NoiseName = "olympiad",
    cling: Cling = 0.0,
    speed: Annotated[
        float | None, typer.Option(help="The cue's speed, m/s; default: the game's usual one.")
    ] = None,
    table: Annotated[
        str | None, typer.Option(help="A table's preset; default: the game's own.")
    ] = None,
    gap: Annotated[
        float | None,
        typer.Option(help="Mean gap between the balls, m; default: the preset's, or 0.0001."),
    ] = None,
    preset: Annotated[
        str | None, typer.Option(help="How players open the game, as for carom break.")
    ] = None,
    precision: Precise = None,
    seed: Seed = 0,
    level: Level = 0.95,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Break many racks; print the chance of each result."""
    found = carom.break_statistics(
        game,
        racks,
        noise=noise_of(noise, cling),
        table=table,
        speed=speed,
        gap=gap,
        preset=preset,
        precision=precision,
        seed=seed,
        level=level,
        progress=sys.stderr.isatty(),
    )
    emit_answer(found, json=json)
    draw(lambda: maps_picture.draw(found), svg=svg, png=png)


def _show(
    found: Drawn, rows: dict[str, Any], *, json: bool, svg: Path | None, png: Path | None
) -> None:
    """Print the rows as JSON or a table of text, and write pictures to files."""
    if json:
        emit(js.dumps({name: or_null(values.tolist()) for name, values in rows.items()}))
    else:
        emit(str(found))
    draw(lambda: maps_picture.draw(found), svg=svg, png=png)


def _degrees(name: str, radians: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """The column ``NAME_deg`` of a column in radians."""
    return {f"{name}_deg": radians * (180.0 / math.pi)}


def _ball_and_pocket(text: str) -> str | tuple[str, str]:
    ball, colon, pocket = text.partition(":")
    return (ball, pocket) if colon else ball


def _call(text: str) -> Call:
    ball, colon, pocket = text.partition(":")
    if colon:
        return Call.pocket(ball, pocket)
    return Call.safety() if text == "safety" else Call.on(text)


def _in_game(shot: Shot, game: str, call: Call | None) -> tuple[Shot, Frame]:
    """The shot as the frame requests it, with the frame's order of balls, and the frame."""
    frame = Frame.of_shot(game, shot)
    own = own_strike(shot._core)
    file = shot.to_dict()
    asked = frame.shot(like(own, file["strike"]), call=call).to_dict()
    # A frame plays every shot without cling and with the usual cap of events.
    asked |= {key: file[key] for key in ("cling", "max_events") if key in file}
    return Shot.from_dict(asked), frame


def _disc(text: str) -> tuple[tuple[float, float], float]:
    x, y, radius = numbers("leave", text, ",", "X,Y,R")
    return (x, y), radius


def _steps(name: str, text: str) -> list[float]:
    start, end, count = numbers(name, text, ":", "FROM:TO:COUNT")
    if not (count.is_integer() and 1 <= count <= 10_000):
        raise InputError(
            "out-of-range", f"--{name}", f"{count:g} is not a number of steps", "write 1 to 10000"
        )
    steps = max(1, int(count) - 1)
    return [start + (end - start) * k / steps for k in range(int(count))]
