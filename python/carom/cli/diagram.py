"""``carom diagram``: diagrams of shots and positions for paper."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from carom import Frame, Shot, Study, Trace, _core
from carom.cli.options import title_of
from carom.cli.output import file_name, format_of, read
from carom.errors import InputError
from carom.lazy import LazyModule

if TYPE_CHECKING:
    from carom.picture import diagram as picture
else:
    # Matplotlib takes half a second to load.
    picture = LazyModule("carom.picture.diagram")


def diagram(
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...",
            help="Shot files, traces, studies, or records of frames (Frame.record); - is stdin.",
        ),
    ],
    out: Annotated[
        str,
        typer.Option("-o", "--out", metavar="OUT", help="The file to write: .svg, .png or .pdf."),
    ],
    paper: Annotated[
        str | None,
        typer.Option(help="a4 or letter; without it the file has the size of the diagram."),
    ] = None,
    per_page: Annotated[int, typer.Option(help="Diagrams on a page: 1, 2, 4 or 6.")] = 1,
    title: Annotated[
        str | None,
        typer.Option(help="Heading of the diagrams; default: the name of a single file."),
    ] = None,
    solutions: Annotated[
        bool, typer.Option("--solutions", help="Show how the tasks of a study are solved.")
    ] = False,
) -> None:
    """Draw shots or positions for paper: light, with thin lines, readable without colours.

    A shot is simulated, and the paths of its balls are drawn. Those of a frame lie still. Of a
    study all chapters are drawn, each with its title and text.
    """
    drawn = [_read(file) for file in files]
    # Chapters have titles of their own.
    is_study = any(isinstance(one, Study) for one in drawn)
    if title is None and len(files) == 1 and files[0] != "-" and not is_study:
        title = title_of(files[0])
    picture.save(
        drawn,
        out,
        title=title,
        paper=paper,  # type: ignore[arg-type]
        per_page=per_page,
        solutions=solutions,
    )


def _read(path: str) -> Shot | Trace | Frame | Study:
    name = file_name(path)
    file = _core.read_json(read(path), name)
    kind = format_of(file)
    if kind.startswith("carom-frame"):
        return Frame.replay(file)
    if kind.startswith("carom-trace"):
        return Trace.from_dict(file)
    if kind.startswith("carom-study"):
        return Study.from_dict(file)
    if kind.startswith("carom-shot"):
        return Shot.from_dict(file)
    if kind.startswith("carom-drill"):
        raise InputError(
            "format",
            f"{name}: format",
            "found a drill",
            f"draw its sheet: carom drill {name} -o FILE",
        )
    raise InputError(
        "format",
        f"{name}: format",
        f"found {kind!r}",
        "give a shot (carom-shot/1), a trace (carom-trace/1), a study (carom-study/1) or a "
        "record (carom-frame/1)",
    )
