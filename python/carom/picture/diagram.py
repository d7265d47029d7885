"""Diagrams for paper: a light table with thin lines, the balls with their numbers, and their paths.

The table lies, with its head string on the left. Everything can be read without colours.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, get_args

from matplotlib import rc_context
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyArrowPatch, PathPatch, Polygon
from matplotlib.patheffects import withStroke
from matplotlib.transforms import Affine2D

from carom.arguments import text
from carom.errors import InputError
from carom.files import checked_path, write_whole
from carom.picture import colors, table
from carom.picture.ball_names import ball_names, free_place, points_on
from carom.picture.balls import curve, points_per_metre
from carom.picture.colors import LIGHT, look
from carom.picture.output import as_written, to_png, to_svg
from carom.picture.paths import Route, routes, starts
from carom.picture.shown import Drawn, Shown, heading_of, shown_of
from carom.picture.style import own_style
from carom.picture.wrapped_text import fitting, leading, wrapped
from carom.player import words
from carom.rules import Frame
from carom.shot import Shot

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes

    from carom.picture.paths import Point

Paper = Literal["a4", "letter"]

# Width and height of the papers, mm.
PAPERS = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
# Columns and rows of the diagrams on a page; a page with one or with four of them lies.
GRIDS = {1: (1, 1), 2: (1, 2), 4: (2, 2), 6: (2, 3)}
# Numbers of diagrams for which the page stands.
UPRIGHT = (2, 6)
# Empty edge of a page and space between its diagrams, mm: printers leave 5 mm or more white.
MARGIN = 10.0
GAP = 6.0
# Height of the line above a diagram and of the line below it, mm.
LINE = 6.0
# The most of a diagram's height that a text below it may take.
TEXT_SHARE = 0.4
# Width of a diagram that is not on a page, and the empty edge around it, mm.
ALONE, RIM = 200.0, 2.0
INCH = 25.4
# Dash patterns of the paths, in line widths, by which they differ without colours; the cue ball's
# is a whole line.
DASHES: tuple[Any, ...] = ((0, (7, 2.5)), (0, (2.5, 2)), (0, (8, 2, 1.5, 2)), (0, (1, 1.6)))
# Colours of marks, dark enough for lines on white; white would not be seen.
MARK_INKS = {"white": "#000000", "yellow": "#7a6000", "red": "#b3261e", "blue": "#1c5a9e"}
# Size of the numbers, points, in a diagram of full width and on a page of four.
LARGE, SMALL = 9.0, 7.0
# Greatest share of light in a path's colour: yellow would not be seen on white.
LIGHTEST = 0.45


@own_style()
def draw(
    found: Drawn | Sequence[Drawn],
    *,
    title: str | None = None,
    paper: Paper | None = None,
    per_page: int = 1,
    solutions: bool = False,
) -> list[Figure]:
    """Draw diagrams of shots or positions.

    Args:
        found: A trace, whose paths are drawn; a shot, which is simulated for its paths if it has
            one; a frame, whose balls are drawn; a chapter of a study, with its text; a study, all
            of whose chapters are drawn; or several of these.
        title: Heading of each diagram; several are numbered. Chapters have headings of their own.
        paper: ``a4`` or ``letter``; None draws each diagram for itself.
        per_page: Diagrams on a page: 1, 2, 4 or 6.
        solutions: Whether a chapter with a task shows the paths of its solution.

    Returns:
        The pages, Matplotlib figures.

    Raises:
        InputError: An argument is of a wrong type or value, or there is nothing to draw.
        EventCapError: A shot reached its largest number of events.
    """
    diagrams = shown_of(found, solutions)
    if title is not None:
        text("title", title)
    if per_page not in GRIDS:
        raise InputError("out-of-range", "per_page", f"found {per_page!r}", "write 1, 2, 4 or 6")
    if paper is not None and paper not in PAPERS:
        known = " or ".join(get_args(Paper))
        raise InputError("unknown-name", "paper", f"found {paper!r}", f"write {known}")
    if paper is None and per_page != 1:
        raise InputError(
            "conflict", "per_page", "without a paper every diagram is alone", "name a paper"
        )
    each = 1 if paper is None else per_page
    pages = [diagrams[k : k + each] for k in range(0, len(diagrams), each)]
    headings = [heading_of(one, title, k, len(diagrams)) for k, one in enumerate(diagrams)]
    return [
        _page(page, headings[each * k : each * (k + 1)], paper, per_page)
        for k, page in enumerate(pages)
    ]


def save(
    found: Drawn | Sequence[Drawn],
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    paper: Paper | None = None,
    per_page: int = 1,
    solutions: bool = False,
) -> None:
    """Write diagrams to a file; the same file for the same shots.

    Args:
        found: As for ``draw``.
        path: The file. Its ending chooses the format: ``.svg``, ``.png``, or ``.pdf``, which may
            have several pages.
        title: Heading of each diagram.
        paper: ``a4`` or ``letter``; None gives the file the size of the diagram.
        per_page: Diagrams on a page: 1, 2, 4 or 6.
        solutions: As for ``draw``.

    Raises:
        InputError: As for ``draw``; or the ending is another one, or only a PDF has enough pages.
        OSError: The file cannot be written; a file that was there before is unchanged.
    """
    file = checked_path("path", path, "diagram.pdf")
    if file.suffix not in {".svg", ".png", ".pdf"}:
        raise InputError(
            "unknown-name",
            "path",
            f"{file.name!r} ends neither in .svg nor in .png nor in .pdf",
            "end it in one",
        )
    pages = draw(found, title=title, paper=paper, per_page=per_page, solutions=solutions)
    if file.suffix == ".pdf":
        write_whole(file, to_pdf(pages))
        return
    if len(pages) > 1:
        raise InputError(
            "unsupported",
            "path",
            f"a file {file.suffix} has one page, and there are {len(pages)}",
            "write a .pdf, or put more diagrams on a page",
        )
    write_whole(file, to_svg(pages[0]) if file.suffix == ".svg" else to_png(pages[0]))


@own_style()
def to_pdf(pages: Sequence[Figure]) -> bytes:
    """Figures as the pages of a PDF file; the same bytes for the same figures."""
    out = io.BytesIO()
    nobody = {"Creator": None, "Producer": None, "CreationDate": None}
    # Type 42 keeps the letters as text, which a reader can search.
    with rc_context({"pdf.fonttype": 42}), PdfPages(out, metadata=nobody) as file:
        for page in pages:
            file.savefig(page)
    return out.getvalue()


# Geometry, balls with their paths, what is drawn on the table, and the text below it.
_Parts = tuple[dict[str, Any], list[Route], list[dict[str, Any]], str]


def _page(
    diagrams: Sequence[Shown], headings: Sequence[str], paper: Paper | None, per_page: int
) -> Figure:
    parts = [_parts(one) for one in diagrams]
    if paper is None:
        left, bottom, right, top = table.bounds(parts[0][0], parts[0][1])
        text = leading(LARGE) * len(wrapped(parts[0][3], ALONE, LARGE)[1:])
        tall = ALONE * (right - left) / (top - bottom) + 2 * LINE + text
        page, edge = (ALONE + 2 * RIM, tall + 2 * RIM), RIM
    else:
        width, height = PAPERS[paper]
        page, edge = ((width, height) if per_page in UPRIGHT else (height, width)), MARGIN
    figure = Figure(figsize=(page[0] / INCH, page[1] / INCH), facecolor="white")
    columns, rows = GRIDS[per_page]
    wide = (page[0] - 2 * edge - (columns - 1) * GAP) / columns
    tall = (page[1] - 2 * edge - (rows - 1) * GAP) / rows
    for k, (part, heading) in enumerate(zip(parts, headings, strict=True)):
        x = edge + (k % columns) * (wide + GAP)
        y = page[1] - edge - (k // columns) * (tall + GAP)
        size = SMALL if per_page >= 4 else LARGE
        _diagram(figure, page, (x, y, wide, tall), part, (heading, size))
    return as_written(figure)


def _parts(shown: Shown) -> _Parts:
    one = shown.drawn
    if isinstance(one, Frame):
        radius = one._bare_shot().radius[0]
        balls = [_resting(ball, radius, place) for ball, place in one.balls.items()]
        return one.geometry(), balls, [], shown.text
    trace = one.simulate() if isinstance(one, Shot) else one
    shot = trace.shot
    marks = [*(mark for mark in shown.marks if mark not in shot.marks), *shot.marks]
    text = "\n".join(filter(None, (_caption(shot), shown.text)))
    return shot.geometry(), routes(trace.to_dict(), starts(trace)), marks, text


def _resting(ball: str, radius: float, place: tuple[float, float]) -> Route:
    return Route(ball, radius, place, place, (), "stationary", (radius, radius))


def _caption(shot: Shot) -> str:
    strike = shot.strike
    if strike is None:
        return ""
    return words.strike(strike.speed, strike.side, strike.height, shot.elevation or 0.0)


def _diagram(
    figure: Figure,
    page: tuple[float, float],
    slot: tuple[float, float, float, float],
    parts: _Parts,
    heading: tuple[str, float],
) -> None:
    """Draw one diagram into a part of the page: left, top, width and height, mm."""
    geometry, balls, marks, caption = parts
    left, bottom, right, top = table.bounds(geometry, balls)
    x, y, wide, tall = slot
    title, size = heading
    lines = fitting(wrapped(caption, wide, size), TEXT_SHARE * tall / leading(size))
    room = tall - 2 * LINE - leading(size) * len(lines[1:])
    scale = min(wide / (top - bottom), room / (right - left))
    across, down = scale * (top - bottom), scale * (right - left)
    begin = x + 0.5 * (wide - across)
    place = (begin / page[0], (y - LINE - down) / page[1], across / page[0], down / page[1])
    ax = figure.add_axes(place)
    ax.set_axis_off()
    # A quarter turn clockwise: the head of the table is on the left.
    ax.set_xlim(bottom, top)
    ax.set_ylim(-right, -left)
    ax.transData = Affine2D().rotate_deg(-90) + ax.transData
    table.draw_table(ax, geometry, (left, bottom, right, top), LIGHT)
    _paths(ax, balls)
    _balls(ax, geometry, balls, size)
    _marks(ax, marks, size)
    style: dict[str, Any] = {"fontsize": size, "va": "center", "color": "black"}
    # A dollar sign is one of the text.
    style["parse_math"] = False
    figure.text(begin / page[0], (y - 0.3 * LINE) / page[1], title, fontweight="bold", **style)
    # A text has the whole width; a single line is under its table.
    x = begin if len(lines) < 2 else x
    for k, line in enumerate(lines):
        below = 1.7 * LINE + down + k * leading(size)
        figure.text(x / page[0], (y - below) / page[1], line, **style)


def _ink(color: str) -> str | tuple[float, float, float]:
    """A colour that is dark enough for a line on white."""
    red, green, blue = to_rgb(color)
    light = 0.299 * red + 0.587 * green + 0.114 * blue
    share = min(1.0, LIGHTEST / light) if light else 1.0
    return (share * red, share * green, share * blue)


def _paths(ax: Axes, balls: Sequence[Route]) -> None:
    moving = [(index, ball) for index, ball in enumerate(balls) if ball.legs]
    for k, (index, ball) in enumerate(moving):
        color = "black" if k == 0 else _ink(look(ball.id, index).body)
        ax.add_patch(
            PathPatch(
                curve([(leg.start, leg.control, leg.end) for leg in ball.legs]),
                facecolor="none",
                edgecolor=color,
                linewidth=0.8,
                linestyle="solid" if k == 0 else DASHES[(k - 1) % len(DASHES)],
                joinstyle="round",
                zorder=3,
                gid=f"path-{ball.id}",
            )
        )
        if ball.fate not in {"pocketed", "off-table"}:
            ring = Circle(ball.end, ball.radius, facecolor="white", edgecolor=color, zorder=3.5)
            ring.set(linewidth=0.6, linestyle=(0, (2, 1.5)), gid=f"end-{ball.id}")
            ax.add_patch(ring)


def _balls(ax: Axes, geometry: dict[str, Any], balls: Sequence[Route], size: float) -> None:
    taken: list[tuple[Point, float]] = []
    for ball in balls:
        taken += [(ball.start, ball.radius), (ball.end, ball.radius)]
        taken += [(point, 0.0) for leg in ball.legs for point in points_on(leg)]
    names = ball_names([ball.id for ball in balls])
    half = 0.5 * size / points_per_metre(ax)
    for index, ball in enumerate(balls):
        style = look(ball.id, index)
        ax.add_patch(
            Circle(
                ball.start,
                ball.radius,
                facecolor=colors.IVORY if style.striped else style.body,
                edgecolor="black",
                linewidth=0.7,
                zorder=6,
                gid=f"ball-{ball.id}",
            )
        )
        if style.striped:
            ax.add_patch(Circle(ball.start, 0.55 * ball.radius, facecolor=style.body, zorder=6.1))
        name = names[ball.id]
        if name:
            at = free_place(ball, half * (0.55 + 0.35 * len(name)), taken, geometry)
            taken.append((at, half))
            ax.text(
                *at,
                name,
                fontsize=size,
                ha="center",
                va="center",
                color="black",
                zorder=7,
                gid=f"number-{ball.id}",
            )


def _marks(ax: Axes, marks: Sequence[dict[str, Any]], size: float) -> None:
    """Draw the marks of a shot file over everything else."""
    for index, mark in enumerate(marks):
        ink = MARK_INKS[mark["color"]]
        line: dict[str, Any] = {"edgecolor": ink, "linewidth": 1.1, "zorder": 8}
        line["gid"] = f"mark-{index}"
        kind = mark["kind"]
        if kind in {"line", "arrow"}:
            style = "-" if kind == "line" else "->,head_length=4,head_width=2"
            ends = {"posA": mark["from"], "posB": mark["to"], "shrinkA": 0, "shrinkB": 0}
            ax.add_patch(FancyArrowPatch(**ends, arrowstyle=style, **line))
        elif kind == "circle":
            ax.add_patch(Circle(mark["center"], mark["radius"], facecolor="none", **line))
        elif kind == "area":
            ax.add_patch(Polygon(mark["outline"], facecolor=(*to_rgb(ink), 0.12), **line))
        else:
            halo = [withStroke(linewidth=3, foreground="white")]
            place: dict[str, Any] = {"ha": "center", "va": "center", "zorder": 9}
            x, y = mark["at"]
            # A dollar sign is one of the text.
            found = ax.text(x, y, mark["text"], fontsize=size, color=ink, parse_math=False, **place)
            found.set(gid=f"mark-{index}", path_effects=halo, fontweight="bold")
