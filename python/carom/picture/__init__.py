"""Pictures of a shot: the table, every ball's path exactly as computed, and what happened where.

matplotlib draws them and is imported when the first one is asked for.
"""

from __future__ import annotations

from carom.picture.canvas import draw, html, png, svg

__all__ = ["draw", "html", "png", "svg"]
