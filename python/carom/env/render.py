"""Pictures of tables as arrays of pixels."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from carom.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

# Pixels along the longer side.
LONG_SIDE = 600


def check_mode(render_mode: str | None) -> str | None:
    """Return the mode unchanged if it is valid.

    Raises:
        InputError: The mode is neither ``rgb_array`` nor None.
    """
    if render_mode not in (None, "rgb_array"):
        raise InputError(
            "unknown-name",
            "render_mode",
            f"there is no mode {render_mode!r}",
            'write "rgb_array", or leave it out',
        )
    return render_mode


def frame(picture: dict[str, Any]) -> NDArray[np.uint8]:
    """Draw a table with its balls.

    Args:
        picture: ``table`` as ``Shot.geometry`` returns it, ``balls`` with ``id``, ``radius`` and
            ``position`` (m).

    Returns:
        uint8 of shape (height, width, 3).
    """
    # Matplotlib is loaded with the first picture.
    from carom.picture.pixels import table_pixels

    return table_pixels(picture["table"], picture["balls"], LONG_SIDE)
