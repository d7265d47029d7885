"""Pictures of all kinds of answers, written to a file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.errors import InputError
from carom.files import checked_path, write_whole
from carom.picture import canvas, evaluation, maps, plays, solutions, still
from carom.picture.output import to_png, to_svg
from carom.plan import Evaluation, Solution
from carom.player import Analysis
from carom.rules import Frame
from carom.shot import Shot
from carom.trace import Trace

if TYPE_CHECKING:
    import os
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from carom.picture.maps import Drawn


def save(
    found: Trace | Shot | Frame | Evaluation | Analysis | Sequence[Solution] | Drawn,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    leave: tuple[Sequence[float], float] | None = None,
) -> None:
    """Write the picture of an answer to a file; the same file for the same answer.

    Args:
        found: A trace; a shot or a frame, whose balls are drawn before they move; the result of
            ``Shot.evaluate``, ``Shot.solve`` or ``Player.explain``; a map, a table of cushion
            shots, or statistics of breaks.
        path: The file. Its ending chooses the format: ``.svg`` or ``.png``.
        title: Heading; None writes a default one.
        leave: For solutions, the disc that was passed to ``solve``, to be drawn as well.

    Raises:
        InputError: The ending is another one, or ``found`` cannot be drawn.
        OSError: The file cannot be written; a file that was there before is unchanged.
    """
    file = checked_path("path", path, "shot.svg")
    if file.suffix not in {".svg", ".png"}:
        raise InputError(
            "unknown-name",
            "path",
            f"{file.name!r} ends neither in .svg nor in .png",
            "end it in one",
        )
    figure = _draw(found, title, leave)
    if file.suffix == ".svg":
        write_whole(file, to_svg(figure))
        return
    write_whole(file, to_png(figure))


def png_of(found: Trace | Shot | Frame, dots_per_inch: int) -> bytes:
    """The content of a PNG file with a trace, a shot or a frame."""
    return to_png(_draw(found, None, None), dots_per_inch=dots_per_inch)


def _draw(
    found: Trace | Shot | Frame | Evaluation | Analysis | Sequence[Solution] | Drawn,
    title: str | None,
    leave: tuple[Sequence[float], float] | None,
) -> Figure:
    if isinstance(found, Trace):
        return canvas.draw(found, title=title)
    if isinstance(found, Shot):
        return still.draw_shot(found, title=title)
    if isinstance(found, Frame):
        return still.draw_frame(found, title=title)
    if isinstance(found, Evaluation):
        return evaluation.draw(found, title=title)
    if isinstance(found, Analysis):
        return plays.draw(found, title=title)
    if isinstance(found, list | tuple):
        if not all(isinstance(item, Solution) for item in found):
            raise InputError(
                "wrong-type", "found", "not a list of solutions", "give what Shot.solve returned"
            )
        if not found:
            raise InputError(
                "missing",
                "found",
                "there are no solutions",
                "picture.solutions.draw draws the table without any",
            )
        return solutions.draw(found[0].shot, found, leave=leave, title=title)
    return maps.draw(found, title=title)  # type: ignore[arg-type] # all that is left
