"""A picture of whatever can be drawn, into a file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from carom.picture.canvas import to_png, to_svg

if TYPE_CHECKING:
    import os
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from carom.picture.maps import Drawn
    from carom.plan import Evaluation
    from carom.solve import Solution
    from carom.trace import Trace


def save(
    found: Trace | Evaluation | Sequence[Solution] | Drawn,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    leave: tuple[Sequence[float], float] | None = None,
) -> None:
    """Write the picture of an answer; the same file for the same answer.

    Args:
        found: A trace, what ``Shot.evaluate`` or ``Shot.solve`` gave, a map, a table of cushions,
            or statistics of breaks.
        path: Where; its ending says what: ``.svg`` or ``.png``.
        title: Heading; a usual one without it.
        leave: With solutions: the disc that ``solve`` was asked for, to be drawn.

    Raises:
        InputError: Another ending, or nothing to draw.
    """
    from carom.errors import InputError

    path = Path(path)
    if path.suffix not in {".svg", ".png"}:
        raise InputError(f"path: {path.name!r} ends neither in .svg nor in .png; let it")
    figure = _draw(found, title, leave)
    if path.suffix == ".svg":
        path.write_text(to_svg(figure), encoding="utf-8")
        return
    path.write_bytes(to_png(figure))


def _draw(
    found: Trace | Evaluation | Sequence[Solution] | Drawn,
    title: str | None,
    leave: tuple[Sequence[float], float] | None,
) -> Figure:
    from carom.errors import InputError
    from carom.picture import canvas, evaluation, maps, solutions
    from carom.plan import Evaluation
    from carom.trace import Trace

    if isinstance(found, Trace):
        return canvas.draw(found, title=title)
    if isinstance(found, Evaluation):
        return evaluation.draw(found, title=title)
    if isinstance(found, list | tuple):
        if not found:
            raise InputError("found: no solutions, so nothing to draw; see picture.solutions.draw")
        return solutions.draw(found[0].shot, found, leave=leave, title=title)
    return maps.draw(found, title=title)  # type: ignore[arg-type] # all that is left
