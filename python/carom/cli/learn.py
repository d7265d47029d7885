"""``carom learn``: a table and its strikes from tracks of balls that a camera saw."""

from __future__ import annotations

import json as js
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from carom import learn as tracks_of
from carom.cli.options import named_noise
from carom.cli.output import emit, emit_answer, read_shot, say
from carom.cli.values import numbers
from carom.errors import InputError
from carom.files import write_whole
from carom.learn import player_folder
from carom.learn.report_data import fit_report
from carom.learn.report_page import write_report
from carom.shot import Shot

learn = typer.Typer(
    no_args_is_help=True, help="Learn a table and its players from tracks of balls."
)


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


TracksFile = Annotated[
    Path,
    typer.Argument(
        metavar="TRACKS",
        help="Tracks; `carom learn check TRACKS --out FILE` makes them of other columns and units.",
    ),
]
TableName = Annotated[
    str | None,
    typer.Option(metavar="NAME", help="The table, such as carom-10ft; default: that of TRACKS."),
]
Radius = Annotated[float | None, typer.Option(help="Radius of the balls, m.")]
Starts = Annotated[int, typer.Option(min=4, help="Starts of each search for a strike.")]
Seed = Annotated[int, typer.Option(min=0, help="Seed of the starts.")]
Threads = Annotated[
    int | None, typer.Option(min=1, help="Number of threads; default: one per core.")
]

Intended = Annotated[
    Path | None,
    typer.Option(
        metavar="PATH",
        help="The intended strike, or the one that a robot's sensors measured: a shot file, if all "
        "shots are repetitions of it, or a folder with NAME.json for each shot that has one.",
    ),
]
AboutIntended = Annotated[
    str | None,
    typer.Option(
        "--noise",
        metavar="NAME",
        help="Errors of the played strikes about the intended ones: a preset or a file.",
    ),
]


@learn.command()
def table(
    file: TracksFile,
    out: Annotated[
        Path, typer.Option("-o", "--out", metavar="FILE", help="Where to write what was learned.")
    ] = Path("learned.json"),
    table: TableName = None,
    radius: Radius = None,
    physics: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="The physics to begin with, whose models stay; default: that of the table.",
        ),
    ] = None,
    free: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY",
            help="A number to learn, such as rolling.a; may be repeated. Default: all.",
        ),
    ] = None,
    intended: Intended = None,
    noise: AboutIntended = None,
    report: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.html", help="Write a page: numbers, figures, and every shot simulated."
        ),
    ] = None,
    compare: Annotated[
        bool,
        typer.Option(
            "--compare",
            help="Compare the models of rails and of two balls by shots that are held out "
            "(many times as long).",
        ),
    ] = False,
    keep: Annotated[
        Path | None,
        typer.Option(
            metavar="FOLDER",
            help="Keep every finished step here; the same command goes on from it.",
        ),
    ] = None,
    rounds: Annotated[
        int, typer.Option(min=1, help="How often the search for the strikes is repeated.")
    ] = 3,
    starts: Starts = 40,
    seed: Seed = 0,
    threads: Threads = None,
    json: Annotated[bool, typer.Option("--json", help="Print what was learned as JSON.")] = False,
) -> None:
    """Learn the physics of a table, its nose lines and the camera's offset from filmed shots."""
    tracks = tracks_of.read_tracks(file, table=table, radius=radius)
    if keep is not None:
        keep.mkdir(parents=True, exist_ok=True)
    how: dict[str, Any] = {
        "physics": physics,
        "free": free,
        "rounds": rounds,
        "starts": starts,
        "seed": seed,
        "threads": threads,
        "progress": sys.stderr.isatty(),
    }
    meant = _intended(intended, noise)
    learned = tracks_of.table(tracks, **how, **meant, keep=keep and keep / "table.json")
    learned.save(out)
    emit(learned.to_json() if json else learned.summary())
    say(f"wrote {out}")
    models: list[tracks_of.ModelScore] = []
    if compare:
        models = tracks_of.compare_models(
            tracks, **how, **meant, keep=keep and keep / "models.json"
        )
        if not json:
            emit("\n".join(["", "Models by held-out shots:", *map(_score, models)]))
    if report is not None:
        found = tracks_of.strikes(
            tracks,
            learned,
            **meant,
            begin=learned.strikes,
            starts=starts,
            seed=seed,
            threads=threads,
            progress=sys.stderr.isatty(),
        )
        title = f"Table learned from {file.name}"
        write_report(fit_report(tracks, learned, found, models), report, title=title)
        say(f"wrote {report}")


@learn.command()
def strikes(
    file: TracksFile,
    learned: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="What `carom learn table` wrote; default: the preset's physics."
        ),
    ] = None,
    out: Annotated[
        Path, typer.Option("-o", "--out", metavar="DIR", help="Folder for the shot files.")
    ] = Path("strikes"),
    table: TableName = None,
    radius: Radius = None,
    rest: Annotated[
        float | None,
        typer.Option(
            metavar="M",
            help="Find the places where the balls lay too, whose errors are about so large, m.",
        ),
    ] = None,
    intended: Intended = None,
    noise: AboutIntended = None,
    starts: Starts = 40,
    seed: Seed = 0,
    threads: Threads = None,
    json: Annotated[bool, typer.Option("--json", help="Print the strikes as JSON.")] = False,
) -> None:
    """Find the strike of every filmed shot; write shot files that replay what was filmed."""
    found = tracks_of.strikes(
        tracks_of.read_tracks(file, table=table, radius=radius),
        None if learned is None else tracks_of.Posterior.load(learned),
        rest=rest,
        **_intended(intended, noise),
        starts=starts,
        seed=seed,
        threads=threads,
        progress=sys.stderr.isatty(),
    )
    out.mkdir(parents=True, exist_ok=True)
    files = [f"{index:04}.json" for index in range(1, len(found) + 1)]
    for strike, name in zip(found, files, strict=True):
        strike.shot.save(out / name)
    write_whole(out / player_folder.INDEX, js.dumps(player_folder.index_of(found, files)) + "\n")
    if json:
        emit(js.dumps([strike.to_dict() for strike in found]))
    else:
        emit(
            "\n".join(
                [
                    "file  shot      error (mm)  first 3 s",
                    *map(_row, range(1, len(found) + 1), found),
                ]
            )
        )
    say(f"wrote {len(found)} shots to {out}")


@learn.command()
def player(
    folder: Annotated[
        Path,
        typer.Argument(metavar="STRIKES", help="A folder that `carom learn strikes` wrote."),
    ],
    intention: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="A shot file with the intended strike, for a drill of one repeated shot. "
            "Default: the strikes near the played one that score.",
        ),
    ] = None,
    players: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="The player of each shot: CSV with the columns shot and player, or JSON.",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="Where to write the player; with --players a folder. Default: player.json, "
            "players.",
        ),
    ] = None,
    exact: Annotated[
        bool, typer.Option("--exact", help="STRIKES has shot files that are known exactly.")
    ] = False,
    draws: Annotated[int, typer.Option(min=20, help="Draws from the posterior.")] = 1000,
    seed: Seed = 0,
    json: Annotated[bool, typer.Option("--json", help="Print the players as JSON.")] = False,
) -> None:
    """Learn a player's errors, as a noise, from strikes as they were played."""
    played = tracks_of.read_strikes(folder, exact=exact)
    intended = None if intention is None else read_shot(intention)
    shared: dict[str, Any] = {"draws": draws, "seed": seed, "progress": sys.stderr.isatty()}
    if players is None:
        found = [tracks_of.player(played, intended, **shared)]
        target = Path("player.json") if out is None else out
        files = [target]
    else:
        by_shot = tracks_of.read_players(players)
        found = list(tracks_of.players(played, intended, by_shot, **shared).values())
        target = Path("players") if out is None else out
        target.mkdir(parents=True, exist_ok=True)
        files = [target / f"{index:04}.json" for index in range(1, len(found) + 1)]
    for one, file in zip(found, files, strict=True):
        one.save(file)
    if json:
        emit(js.dumps([one.to_dict() for one in found]))
    else:
        emit("\n\n".join(one.summary() for one in found))
    for one, file in zip(found, files, strict=True):
        say(f"wrote {one.name} to {file}")


def _intended(path: Path | None, noise: str | None) -> dict[str, Any]:
    """The intended strikes and their errors, as `carom.learn` takes them."""
    if path is None or not path.is_dir():
        shots: Shot | dict[str, Shot] | None = None if path is None else read_shot(str(path))
    else:
        shots = {file.stem: read_shot(str(file)) for file in sorted(path.glob("*.json"))}
    return {"intended": shots, "noise": None if noise is None else named_noise(noise)}


def _row(index: int, strike: tracks_of.FilmedStrike) -> str:
    errors = f"{1000.0 * strike.rmse:10.1f}  {1000.0 * strike.rmse_3s:9.1f}"
    return f"{index:04}  {strike.name:8}  {errors}"


def _score(model: tracks_of.ModelScore) -> str:
    return f"{model.model:32}  {model.score:7.3f} ± {model.standard_error:.3f}"


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
