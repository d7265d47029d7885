"""``carom evaluate``: the chances of a shot."""

from __future__ import annotations

import json as js
import sys
from pathlib import Path
from typing import Annotated

import typer

from carom.cli.output import emit, read, save

NoiseName = Annotated[
    str,
    typer.Option(
        "--noise",
        metavar="NAME",
        help="beginner, casual, club, advanced, professional or olympiad; "
        "a multiplier may follow, olympiad:0.5.",
    ),
]
Seed = Annotated[int, typer.Option(help="Which random numbers.")]
Svg = Annotated[Path | None, typer.Option("--svg", metavar="OUT", help="Write a picture (SVG).")]
Png = Annotated[Path | None, typer.Option("--png", metavar="OUT", help="Write a picture (PNG).")]
Json = Annotated[bool, typer.Option("--json", help="Print the answer as JSON.")]


def evaluate(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A shot file; - is stdin.")],
    noise: NoiseName = "olympiad",
    n: Annotated[int, typer.Option("-n", min=1, help="How many variants, at most.")] = 10_000,
    seed: Seed = 0,
    precision: Annotated[
        float | None,
        typer.Option(help="Stop when half the watched interval's width is at most this."),
    ] = None,
    watch: Annotated[
        str | None,
        typer.Option(metavar="WHAT", help="A ball, BALL:POCKET or scratch; else everything."),
    ] = None,
    level: Annotated[float, typer.Option(help="Confidence of the intervals.")] = 0.95,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print the chances of a shot when its player means it but does not hit it exactly."""
    from carom import Noise, Shot
    from carom.picture import evaluation as picture

    shot = Shot.from_json(read(file))
    ball, colon, pocket = (watch or "").partition(":")
    answer = shot.evaluate(
        Noise.preset(noise),
        n,
        seed=seed,
        precision=precision,
        watch=(ball, pocket) if colon else watch,
        level=level,
        progress=sys.stderr.isatty(),
    )
    title = "shot" if file == "-" else Path(file).stem.replace("_", " ").replace("-", " ")
    if svg is not None:
        save(svg, picture.svg(answer, title=title))
    if png is not None:
        save(png, picture.png(answer, title=title))
    emit(js.dumps(answer.to_dict()) if json else str(answer))
