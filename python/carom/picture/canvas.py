"""The picture of a trace."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from carom.arguments import instance, text
from carom.errors import InputError
from carom.picture import colors, table
from carom.picture.balls import draw_balls, draw_cue, draw_marks, draw_paths
from carom.picture.legend import Panel, draw_panel
from carom.picture.output import DOTS_PER_INCH, as_written, to_png, to_svg
from carom.picture.paths import routes, starts
from carom.picture.side import draw_side, views
from carom.picture.style import own_style
from carom.trace import Trace

# Length of the table's longer side on paper, inches; a picture of 9 inches fills the width of a
# printed page and, at 150 dots per inch, the height of a laptop's screen.
LONG_SIDE_INCHES = 8.4
# The same for a picture of a table without a shot.
TABLE_INCHES = 5.0
# Width of the panel beside the table, points.
PANEL_POINTS = 232.0
# Least height of a picture, points, so that the panel fits.
LEAST_HEIGHT_POINTS = 560.0
MARGIN_POINTS = 14.0
# Least radius of a drawn ball, points.
SMALLEST_BALL_POINTS = 2.6


@own_style()
def draw(trace: Trace, *, title: str | None = None) -> Figure:
    """Draw a shot.

    Args:
        trace: The trace to draw.
        title: Heading of the panel; None writes the table's name.

    Returns:
        A matplotlib figure, not attached to any window.

    Raises:
        InputError: ``trace`` is not a trace, or ``title`` not a string.
    """
    instance("trace", trace, Trace, "Shot.simulate()")
    if title is not None:
        text("title", title)
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


@own_style()
def compose(
    geometry: dict[str, Any],
    balls: list[dict[str, Any]],
    trace: dict[str, Any],
    title: str,
    *,
    azimuth: float | None = None,
    elevation: float | None = None,
) -> Figure:
    """Draw a shot from plain data: from above, and from the side for every ball that flies.

    Args:
        geometry: The table as ``Shot.geometry`` returns it.
        balls: The balls at time 0: ``id``, ``radius`` (m), ``position`` (m), ``velocity`` (m/s).
        trace: A ``carom-trace/1``.
        title: Heading of the panel.
        azimuth: Direction of the cue, rad, if there is a strike.
        elevation: Elevation of the cue, rad.
    """
    paths = routes(trace, balls)
    region = table.bounds(geometry, paths)
    left, bottom, right, top = region
    point = max(right - left, top - bottom) / (72 * LONG_SIDE_INCHES)
    margin = MARGIN_POINTS * point
    height = max(top - bottom, LEAST_HEIGHT_POINTS * point)
    width = right - left + 3 * margin + PANEL_POINTS * point - margin
    # On paper, points; the side views are below the view from above.
    paper, above = (width + margin) / point, (height + 2 * margin) / point
    strip = paper - 2 * MARGIN_POINTS
    sides = views(paths, strip, geometry["cushion_height"])
    heights = [view.height * strip / (view.right - view.left) for view in sides]
    below = sum(heights) + MARGIN_POINTS * len(sides)
    figure = Figure(figsize=(paper / 72, (above + below) / 72), facecolor=colors.PAPER)
    ax = figure.add_axes((0, below / (above + below), 1, above / (above + below)))
    ax.set_axis_off()
    ax.set_xlim(left - margin, left + width)
    ax.set_ylim(top - height - margin, top + margin)
    table.draw_table(ax, geometry, region)
    flew = draw_paths(ax, paths)
    seen = draw_marks(ax, trace["events"], paths)
    smallest = SMALLEST_BALL_POINTS * point
    struck = trace["events"][0]["balls"][0] if azimuth is not None else None
    if azimuth is not None:
        route = next(route for route in paths if route.id == struck)
        draw_cue(ax, route.start, azimuth, max(route.radius, smallest))
    draw_balls(ax, paths, smallest)
    draw_panel(Panel(ax, right + 1.6 * margin, top, point), title, trace, paths, seen, flew=flew)
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
        draw_side(side, view, paths, trace["events"], geometry, raised)
    return as_written(figure)


@own_style()
def draw_table(geometry: dict[str, Any]) -> Figure:
    """Draw a table without balls.

    Args:
        geometry: The table as ``carom.tables`` lists it.

    Raises:
        InputError: ``geometry`` is not a table's geometry, or the cloth has no edges.
    """
    if not isinstance(geometry, dict) or not geometry.get("size"):
        raise InputError(
            "wrong-type",
            "geometry",
            "not the geometry of a table with edges",
            "give one of carom.tables()",
        )
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


def png(trace: Trace, *, title: str | None = None, dots_per_inch: int = DOTS_PER_INCH) -> bytes:
    """The picture as the content of a PNG file."""
    return to_png(draw(trace, title=title), dots_per_inch=dots_per_inch)
