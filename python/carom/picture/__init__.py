"""Pictures: a shot with every ball's path exactly as computed, chances, solutions, maps.

matplotlib draws them and is imported when the first one is asked for.
"""

from __future__ import annotations

from carom.picture.canvas import draw, draw_table, png, svg, to_svg
from carom.picture.save import save

__all__ = ["draw", "draw_table", "png", "save", "svg", "to_svg"]
