"""Diagrams for paper: a light table with thin lines, the balls with their numbers, and their paths.

The table lies, with its head string on the left. Everything can be read without colours.
"""

from __future__ import annotations

import io
import math
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
from carom.picture.balls import curve, points_per_metre
from carom.picture.colors import LIGHT, look
from carom.picture.output import as_written, to_png, to_svg
from carom.picture.paths import Route, routes, starts
from carom.picture.style import own_style
from carom.player import words
from carom.rules import Frame
from carom.shot import Shot
from carom.trace import Trace

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes

    from carom.picture.paths import Leg, Point

Paper = Literal["a4", "letter"]
Drawn = Trace | Shot | Frame

# Width and height of the papers, mm.
PAPERS = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
# Columns and rows of the diagrams on a page; a page with one or with four of them lies.
GRIDS = {1: (1, 1), 2: (1, 2), 4: (2, 2)}
# Empty edge of a page and space between its diagrams, mm: printers leave 5 mm or more white.
MARGIN = 10.0
GAP = 6.0
# Height of the line above a diagram and of the line below it, mm.
LINE = 6.0
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
# Distance of the points of a path that numbers keep clear of, m: less than half a number's height.
SPACING = 0.02
# Directions in which a free place for a number is searched.
DIRECTIONS = 24


@own_style()
def draw(
    found: Drawn | Sequence[Drawn],
    *,
    title: str | None = None,
    paper: Paper | None = None,
    per_page: int = 1,
) -> list[Figure]:
    """Draw diagrams of shots or positions.

    Args:
        found: A trace, whose paths are drawn; a shot, which is simulated for its paths if it has
            one; a frame, whose balls are drawn; or several of these.
        title: Heading of each diagram; several are numbered.
        paper: ``a4`` or ``letter``; None draws each diagram for itself.
        per_page: Diagrams on a page: 1, 2 or 4.

    Returns:
        The pages, Matplotlib figures.

    Raises:
        InputError: An argument is of a wrong type or value, or there is nothing to draw.
        EventCapError: A shot reached its largest number of events.
    """
    diagrams = _diagrams(found)
    if title is not None:
        text("title", title)
    if per_page not in GRIDS:
        raise InputError("out-of-range", "per_page", f"found {per_page!r}", "write 1, 2 or 4")
    if paper is not None and paper not in PAPERS:
        known = " or ".join(get_args(Paper))
        raise InputError("unknown-name", "paper", f"found {paper!r}", f"write {known}")
    if paper is None and per_page != 1:
        raise InputError(
            "conflict", "per_page", "without a paper every diagram is alone", "name a paper"
        )
    each = 1 if paper is None else per_page
    pages = [diagrams[k : k + each] for k in range(0, len(diagrams), each)]
    headings = [_heading(title, k, len(diagrams)) for k in range(len(diagrams))]
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
) -> None:
    """Write diagrams to a file; the same file for the same shots.

    Args:
        found: As for ``draw``.
        path: The file. Its ending chooses the format: ``.svg``, ``.png``, or ``.pdf``, which may
            have several pages.
        title: Heading of each diagram.
        paper: ``a4`` or ``letter``; None gives the file the size of the diagram.
        per_page: Diagrams on a page: 1, 2 or 4.

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
    pages = draw(found, title=title, paper=paper, per_page=per_page)
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


def _diagrams(found: Drawn | Sequence[Drawn]) -> list[Drawn]:
    many = list(found) if isinstance(found, list | tuple) else [found]
    drawn: list[Drawn] = []
    for one in many:
        if not isinstance(one, Trace | Shot | Frame):
            raise InputError(
                "wrong-type",
                "found",
                f"{type(one).__name__} is not a shot, a trace or a frame",
                "give one of these, or a list of them",
            )
        drawn.append(one)
    if not drawn:
        raise InputError("missing", "found", "there is nothing to draw", "give a shot")
    return drawn


def _heading(title: str | None, index: int, count: int) -> str:
    if count == 1:
        return title or ""
    return f"{title} {index + 1}" if title else str(index + 1)


def _page(
    diagrams: Sequence[Drawn], headings: Sequence[str], paper: Paper | None, per_page: int
) -> Figure:
    parts = [_parts(one) for one in diagrams]
    if paper is None:
        left, bottom, right, top = table.bounds(parts[0][0], parts[0][1])
        tall = ALONE * (right - left) / (top - bottom) + 2 * LINE
        page, edge = (ALONE + 2 * RIM, tall + 2 * RIM), RIM
    else:
        width, height = PAPERS[paper]
        page, edge = ((width, height) if per_page == 2 else (height, width)), MARGIN
    figure = Figure(figsize=(page[0] / INCH, page[1] / INCH), facecolor="white")
    columns, rows = GRIDS[per_page]
    wide = (page[0] - 2 * edge - (columns - 1) * GAP) / columns
    tall = (page[1] - 2 * edge - (rows - 1) * GAP) / rows
    for k, (part, heading) in enumerate(zip(parts, headings, strict=True)):
        x = edge + (k % columns) * (wide + GAP)
        y = page[1] - edge - (k // columns) * (tall + GAP)
        size = SMALL if per_page == 4 else LARGE
        _diagram(figure, page, (x, y, wide, tall), part, (heading, size))
    return as_written(figure)


# Geometry, balls with their paths, what is drawn on the table, and a line of text.
_Parts = tuple[dict[str, Any], list[Route], list[dict[str, Any]], str]


def _parts(one: Drawn) -> _Parts:
    if isinstance(one, Frame):
        radius = one._bare_shot().radius[0]
        balls = [_resting(ball, radius, place) for ball, place in one.balls.items()]
        return one.geometry(), balls, [], ""
    trace = one.simulate() if isinstance(one, Shot) else one
    shot = trace.shot
    return shot.geometry(), routes(trace.to_dict(), starts(trace)), shot.marks, _caption(shot)


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
    scale = min(wide / (top - bottom), (tall - 2 * LINE) / (right - left))
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
    x = begin / page[0]
    figure.text(x, (y - 0.3 * LINE) / page[1], title, fontweight="bold", **style)
    figure.text(x, (y - 1.7 * LINE - down) / page[1], caption, **style)


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
        taken += [(point, 0.0) for leg in ball.legs for point in _points(leg)]
    names = _names([ball.id for ball in balls])
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
            at = _free_place(ball, half * (0.55 + 0.35 * len(name)), taken, geometry)
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


def _points(leg: Leg) -> list[Point]:
    """Points on a leg of a path, about a ball's radius apart."""
    count = max(1, math.ceil(leg.length / SPACING))
    span = leg.end_time - leg.start_time
    return [leg.at(leg.start_time + span * k / count)[:2] for k in range(count + 1)]


def _names(balls: Sequence[str]) -> dict[str, str]:
    """What is written beside each ball: its number, or the first letters of its colour.

    The cue ball has no name, and neither have several balls of one colour.
    """
    stems = {ball: ball.rstrip("0123456789").rstrip("-_ ") for ball in balls}
    names = {}
    for ball, stem in stems.items():
        others = [other for one, other in stems.items() if one != ball]
        if not stem:
            names[ball] = ball
        elif ball == "cue" or stem in others:
            names[ball] = ""
        else:
            lengths = range(1, len(stem) + 1)
            own = (n for n in lengths if not any(o.startswith(stem[:n]) for o in others))
            names[ball] = stem[: next(own, len(stem))].capitalize()
    return names


def _free_place(
    ball: Route, half: float, taken: Sequence[tuple[Point, float]], geometry: dict[str, Any]
) -> Point:
    """The place beside a ball with the most space around it; the nearest of those with enough."""

    def space(at: Point) -> float:
        others = min(math.dist(at, middle) - radius for middle, radius in taken)
        if geometry["size"] is None:
            return others
        width, length = map(float, geometry["size"])
        return min(others, at[0], width - at[0], at[1], length - at[1])

    places = [
        (
            ball.start[0] + away * math.cos(math.tau * k / DIRECTIONS),
            ball.start[1] + away * math.sin(math.tau * k / DIRECTIONS),
        )
        for away in (ball.radius + half * step for step in (1.6, 2.1, 2.8))
        for k in range(DIRECTIONS)
    ]
    return next((at for at in places if space(at) >= 1.4 * half), max(places, key=space))
