"""From a trace to a figure, and from the figure to SVG, PNG and HTML."""

from __future__ import annotations

import io
import warnings
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from carom.picture import _matplotlib, colors
from carom.picture._matplotlib import as_written

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.figure import Figure

    from carom.trace import Trace

# The table's longer side on paper, inches; a picture of 9 inches fills a printed page's width
# and, at 150 dots per inch, a laptop's screen height.
LONG_SIDE_INCHES = 8.4
# The same for a table alone.
TABLE_INCHES = 5.0
# Width of the panel beside the table, points.
PANEL_POINTS = 232.0
# The least height of a picture, points: the panel has to fit.
LEAST_HEIGHT_POINTS = 560.0
MARGIN_POINTS = 14.0
DOTS_PER_INCH = 150
# A ball is never drawn smaller than this, points.
SMALLEST_BALL_POINTS = 2.6


def draw(trace: Trace, *, title: str | None = None) -> Figure:
    """Draw a shot.

    Args:
        trace: What to draw.
        title: Heading of the panel; the table's name without it.

    Returns:
        A matplotlib figure, not attached to any window.
    """
    from carom.picture.paths import starts

    shot = trace.shot
    geometry = shot.geometry()
    return compose(
        geometry,
        starts(trace),
        trace.to_dict(),
        title or geometry["name"] or "shot",
        azimuth=shot.azimuth,
        elevation=shot.elevation,
    )


def compose(
    geometry: dict[str, Any],
    balls: list[dict[str, Any]],
    trace: dict[str, Any],
    title: str,
    *,
    azimuth: float | None = None,
    elevation: float | None = None,
) -> Figure:
    """Draw a shot from plain data: from above, and from the side for balls that fly.

    Args:
        geometry: The table as ``Shot.geometry`` gives it.
        balls: The balls at time 0: ``id``, ``radius`` (m), ``position`` (m), ``velocity`` (m/s).
        trace: A ``carom-trace/1``.
        title: Heading of the panel.
        azimuth: Direction of the cue, rad, if there is a strike.
        elevation: How far its butt is raised, rad.
    """
    _matplotlib.prepare()
    from matplotlib.figure import Figure

    from carom.picture.balls import draw_balls, draw_cue, draw_marks, draw_paths
    from carom.picture.legend import Panel, draw_panel
    from carom.picture.paths import routes
    from carom.picture.side import draw_side, views
    from carom.picture.table import bounds, draw_table

    ways = routes(trace, balls)
    region = bounds(geometry, ways)
    left, bottom, right, top = region
    point = max(right - left, top - bottom) / (72 * LONG_SIDE_INCHES)
    margin = MARGIN_POINTS * point
    height = max(top - bottom, LEAST_HEIGHT_POINTS * point)
    width = right - left + 3 * margin + PANEL_POINTS * point - margin
    # On paper, points: the picture, and below the view from above those from the side.
    paper, above = (width + margin) / point, (height + 2 * margin) / point
    strip = paper - 2 * MARGIN_POINTS
    sides = views(ways, strip, geometry["cushion_height"])
    heights = [view.height * strip / (view.right - view.left) for view in sides]
    below = sum(heights) + MARGIN_POINTS * len(sides)
    figure = Figure(figsize=(paper / 72, (above + below) / 72), facecolor=colors.PAPER)
    ax = figure.add_axes((0, below / (above + below), 1, above / (above + below)))
    ax.set_axis_off()
    ax.set_xlim(left - margin, left + width)
    ax.set_ylim(top - height - margin, top + margin)
    draw_table(ax, geometry, region)
    flew = draw_paths(ax, ways)
    seen = draw_marks(ax, trace["events"], ways)
    smallest = SMALLEST_BALL_POINTS * point
    struck = trace["events"][0]["balls"][0] if azimuth is not None else None
    if azimuth is not None:
        way = next(way for way in ways if way.id == struck)
        draw_cue(ax, way.start, azimuth, max(way.radius, smallest))
    draw_balls(ax, ways, smallest)
    draw_panel(Panel(ax, right + 1.6 * margin, top, point), title, trace, ways, seen, flew=flew)
    floor = below
    for view, tall in zip(sides, heights, strict=True):
        floor -= tall
        side = figure.add_axes(
            (
                MARGIN_POINTS / paper,
                floor / (above + below),
                strip / paper,
                tall / (above + below),
            )
        )
        floor -= MARGIN_POINTS
        side.set_axis_off()
        side.set_xlim(view.left, view.right)
        side.set_ylim(view.top - view.height, view.top)
        raised = elevation if view.route.id == struck else None
        draw_side(side, view, ways, trace["events"], geometry, raised)
    return as_written(figure)


def draw_table(geometry: dict[str, Any]) -> Figure:
    """Draw a table alone.

    Args:
        geometry: The table as ``carom.tables`` lists it.
    """
    _matplotlib.prepare()
    from matplotlib.figure import Figure

    from carom.picture import table

    left, bottom, right, top = table.bounds(geometry, [])
    scale = TABLE_INCHES / (top - bottom)
    figure = Figure(
        figsize=(scale * (right - left), scale * (top - bottom)), facecolor=colors.PAPER
    )
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set_axis_off()
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    table.draw_table(ax, geometry, (left, bottom, right, top))
    return figure


def svg(trace: Trace, *, title: str | None = None) -> str:
    """The picture as SVG text; the same text for the same trace."""
    return to_svg(draw(trace, title=title))


def to_svg(figure: Figure) -> str:
    """A figure as SVG text; the same text for the same figure."""
    from matplotlib import rc_context

    out = io.StringIO()
    # Without a fixed salt and date the same picture would be a different file each time.
    with rc_context({"svg.hashsalt": "carom", "svg.fonttype": "path"}), _any_glyph():
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    return out.getvalue()


def png(trace: Trace, *, title: str | None = None, dots_per_inch: int = DOTS_PER_INCH) -> bytes:
    """The picture as a PNG file's content."""
    return to_png(draw(trace, title=title), dots_per_inch=dots_per_inch)


def to_png(figure: Figure, *, dots_per_inch: int = DOTS_PER_INCH) -> bytes:
    """A figure as a PNG file's content."""
    out = io.BytesIO()
    with _any_glyph():
        figure.savefig(out, format="png", dpi=dots_per_inch, metadata={"Software": None})
    return out.getvalue()


@contextmanager
def _any_glyph() -> Iterator[None]:
    """A letter that the font lacks becomes a box, of which nobody needs to be told."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        yield
