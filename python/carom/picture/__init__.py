"""Pictures of a shot: the table, every ball's path exactly as computed, and what happened where.

matplotlib draws them and is imported when the first one is asked for.
"""

from __future__ import annotations

from carom.picture.canvas import draw, draw_table, png, svg, to_svg

__all__ = ["draw", "draw_table", "png", "svg", "to_svg"]
