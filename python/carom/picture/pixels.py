"""A table with its balls as an array of pixels, for the environments."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

from carom.picture.balls import draw_ball
from carom.picture.canvas import draw_table
from carom.picture.colors import look
from carom.picture.style import own_style

if TYPE_CHECKING:
    from numpy.typing import NDArray


@own_style()
def table_pixels(
    geometry: dict[str, Any], balls: list[dict[str, Any]], long_side: int
) -> NDArray[np.uint8]:
    """Draw a table with its balls.

    Args:
        geometry: The table as ``Shot.geometry`` returns it.
        balls: The balls: ``id``, ``radius`` and ``position``, m.
        long_side: Pixels along the longer side.

    Returns:
        uint8 of shape (height, width, 3).
    """
    figure = draw_table(geometry)
    width, height = figure.get_size_inches()
    figure.set_dpi(long_side / max(width, height))
    ax = figure.axes[0]
    for index, ball in enumerate(balls):
        x, y = ball["position"]
        draw_ball(ax, (x, y), ball["radius"], look(ball["id"], index))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # type: ignore[no-untyped-call]
    pixels = np.asarray(canvas.buffer_rgba())  # type: ignore[no-untyped-call]
    return np.ascontiguousarray(pixels[..., :3])
