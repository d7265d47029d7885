"""Options that several commands share, and what they stand for."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from carom import Noise, _core
from carom.errors import InputError
from carom.files import read_text, shown, write_whole
from carom.lazy import LazyModule

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.figure import Figure

    from carom.picture import output as picture_output
    from carom.plan import TablePosterior
else:
    # Matplotlib takes half a second to load.
    picture_output = LazyModule("carom.picture.output")

# The format of a learned player. carom.learn takes a while to load.
_PLAYER = "carom-player/1"
*_FIRST, _LAST = [name for name, _ in _core.noise_presets()]
NOISES = (
    f"{', '.join(_FIRST)} or {_LAST}; a multiplier may follow, as in olympiad:0.5; or a file "
    "NAME.json with the keys of a noise, or a learned player."
)
File = Annotated[str, typer.Argument(metavar="FILE", help="A shot file; - is stdin.")]
NoiseName = Annotated[
    str,
    typer.Option(
        "--noise",
        metavar="NAME",
        help=NOISES,
    ),
]
Cling = Annotated[
    float,
    typer.Option(
        "--cling",
        metavar="P",
        help="Probability with which a contact of two balls clings (kick, skid), 0 to 1.",
    ),
]
Sight = Annotated[
    float,
    typer.Option(
        "--perception",
        metavar="SIGMA",
        help="Standard deviation of true minus perceived positions, per coordinate, m.",
    ),
]
Precise = Annotated[
    float | None,
    typer.Option(
        "--precision",
        help="Stop counting a chance when half the width of its interval, 0 to 1, is at most this.",
    ),
]
LearnedTable = Annotated[
    Path | None,
    typer.Option(
        "--learned",
        metavar="FILE",
        help="What carom learn table found. The shot is planned on the learned table in place of "
        "its own, and its chances are counted on tables that may be the true one.",
    ),
]
Draws = Annotated[
    int, typer.Option("--draws", min=2, max=1000, help="Number of these tables, with --learned.")
]
Level = Annotated[float, typer.Option(help="Confidence level of the intervals.")]
Seed = Annotated[int, typer.Option(help="Seed of the random numbers.")]
Svg = Annotated[Path | None, typer.Option("--svg", metavar="OUT", help="Write a picture (SVG).")]
Png = Annotated[Path | None, typer.Option("--png", metavar="OUT", help="Write a picture (PNG).")]
Json = Annotated[bool, typer.Option("--json", help="Print the answer as JSON.")]


def draw(figure: Callable[[], Figure], *, svg: Path | None, png: Path | None) -> None:
    """Write the picture to the files that were asked for; without any it is not drawn."""
    if svg is not None:
        write_whole(svg, picture_output.to_svg(figure()))
    if png is not None:
        write_whole(png, picture_output.to_png(figure()))


def named_noise(name: str) -> Noise:
    """The preset of this name, or the noise of this file.

    A file has the keys of a noise, or is a learned player, whose noise is that at its speed.

    Raises:
        OSError: The file cannot be read.
        InputError: There is no such preset, or the file has no noise; the place is the file and
            the key.
    """
    if not name.endswith(".json"):
        return Noise.preset(name)
    file = _core.read_json(read_text(name), shown(name))
    try:
        return Noise.from_dict(_noise_in(file))
    except InputError as error:
        raise error.inside(shown(name), ": ") from None


def _noise_in(file: Any) -> Any:
    """The part of a file with the keys of a noise."""
    if not isinstance(file, dict) or "format" not in file:
        return file
    if (found := file["format"]) != _PLAYER:
        remedy = f"give a file that carom learn player wrote ({_PLAYER!r}), or the keys of a noise"
        raise InputError("format", "format", f"{found!r} has no noise", remedy)
    if "noise" not in file:
        remedy = "write the file with carom learn player"
        raise InputError("missing", "noise", "the key is missing", remedy)
    return file["noise"]


def noise_of(name: str, cling: float) -> Noise:
    """The noise of this name; a probability of a cling above 0 replaces its own."""
    noise = named_noise(name)
    return replace(noise, cling_probability=cling) if cling else noise


def learned_of(path: Path | None) -> TablePosterior | None:
    """What was learned about a table, from the file that ``carom learn table`` wrote.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not such a file.
    """
    if path is None:
        return None
    # The learning of tables takes a while to load.
    from carom.learn import Posterior

    try:
        return Posterior.load(path)
    except InputError as error:
        raise error.inside(shown(path), ": ") from None


def title_of(file: str) -> str:
    """The heading of a picture, from the name of the file."""
    return "shot" if file == "-" else Path(file).stem.replace("_", " ").replace("-", " ")
