"""A figure with a table on the left and free space on the right, for pictures of answers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from carom.errors import InputError
from carom.picture import colors, table
from carom.picture.canvas import LONG_SIDE_INCHES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.shot import Shot

MARGIN_INCHES = 0.2
# Height of the heading, inches.
HEADING_INCHES = 0.3


def sheet(shot: Shot, beside: float, *, heading: str | None = None) -> tuple[Figure, Axes]:
    """A figure with the shot's table on the left, without balls.

    Args:
        shot: A shot on the table.
        beside: Width of the free space on the right, inches.
        heading: A line above the table.

    Returns:
        The figure, and the table's axes, in m.

    Raises:
        InputError: The cloth has no edges, so there is no table to draw.
    """
    geometry = shot.geometry()
    if geometry["size"] is None:
        raise InputError(
            "unsupported",
            "table",
            "the cloth has no edges, and a picture needs them",
            "choose another table",
        )
    left, bottom, right, top = table.bounds(geometry, [])
    scale = LONG_SIDE_INCHES / max(top - bottom, right - left)
    wide, tall = scale * (right - left), scale * (top - bottom)
    above = HEADING_INCHES if heading else 0.0
    paper = (wide + beside + 2 * MARGIN_INCHES, tall + above + 2 * MARGIN_INCHES)
    figure = Figure(figsize=paper, facecolor=colors.PAPER)
    place = (MARGIN_INCHES / paper[0], MARGIN_INCHES / paper[1], wide / paper[0], tall / paper[1])
    ax = figure.add_axes(place)
    ax.set_axis_off()
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    table.draw_table(ax, geometry, (left, bottom, right, top))
    if heading:
        up = 1 - (MARGIN_INCHES + 0.5 * above) / paper[1]
        figure.text(
            MARGIN_INCHES / paper[0], up, heading, color=colors.INK, fontsize=11, va="center"
        )
    return figure, ax
