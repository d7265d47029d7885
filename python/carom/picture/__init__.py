"""Pictures of shots with every ball's exact path, of evaluations, solutions and maps.

Matplotlib draws them; it is the extra ``picture``: ``pip install 'carom[picture]'``. It takes half
a second to load, so modules outside this package import ``carom.picture`` inside the function that
draws.
"""

from __future__ import annotations

# First, because it prepares Matplotlib for all the others.
from carom.picture import _matplotlib  # noqa: F401
from carom.picture.canvas import draw, draw_table, png, svg
from carom.picture.output import to_svg
from carom.picture.save import save

__all__ = ["draw", "draw_table", "png", "save", "svg", "to_svg"]
