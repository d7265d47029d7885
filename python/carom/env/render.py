"""Tables as arrays of pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from carom.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

# Pixels along the longer side.
LONG_SIDE = 600


def check_mode(render_mode: str | None) -> str | None:
    """The mode itself.

    Raises:
        InputError: It is another than ``rgb_array`` or None.
    """
    if render_mode not in (None, "rgb_array"):
        raise InputError(
            f'render_mode: there is no "{render_mode}"; write "rgb_array", or leave it out'
        )
    return render_mode


def frame(picture: dict[str, Any]) -> NDArray[np.uint8]:
    """Draws a table with its balls.

    Args:
        picture: ``table`` as ``Shot.geometry`` gives it, ``balls`` with ``id``, ``radius`` and
            ``position`` (m).

    Returns:
        uint8 of shape (height, width, 3).
    """
    from carom.picture import _matplotlib

    _matplotlib.prepare()
    import numpy as np
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    from carom.picture.balls import draw_ball
    from carom.picture.canvas import draw_table
    from carom.picture.colors import look

    figure = draw_table(picture["table"])
    width, height = figure.get_size_inches()
    figure.set_dpi(LONG_SIDE / max(width, height))
    ax = figure.axes[0]
    for index, ball in enumerate(picture["balls"]):
        x, y = ball["position"]
        draw_ball(ax, (x, y), ball["radius"], look(ball["id"], index))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # type: ignore[no-untyped-call]
    pixels = np.asarray(canvas.buffer_rgba())  # type: ignore[no-untyped-call]
    return np.ascontiguousarray(pixels[..., :3])
