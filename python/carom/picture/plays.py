"""The picture of an analysis: the best play on the table, and the list of all plays."""

from __future__ import annotations

import math
from textwrap import wrap
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Ellipse, Rectangle

from carom.arguments import instance
from carom.errors import InputError
from carom.picture import colors
from carom.picture.balls import draw_ball, draw_cue, draw_marks, draw_paths, draw_ring
from carom.picture.output import as_written, to_png, to_svg
from carom.picture.paths import routes, starts
from carom.picture.sheet import MARGIN_INCHES, sheet
from carom.picture.style import own_style
from carom.player import Analysis, Recommendation

if TYPE_CHECKING:
    from typing import Any

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from carom.picture.paths import Route

# Plays in the list; more do not fit beside the table.
SHOWN = 8
# Letters in a line of the panel.
LINE = 54
# Width of the panel beside the table, and height of one entry in it, inches.
PANEL_INCHES = 3.6
ENTRY_INCHES = 0.88
# Half axes of the ellipse where the cue ball comes to rest, standard deviations.
DEVIATIONS = 2.0


@own_style()
def draw(analysis: Analysis, *, title: str | None = None) -> Figure:
    """Draw the best play without errors, and list the plays beside it.

    The balls are drawn where they are before the play. A dashed circle is the ghost ball: the cue
    ball at its first contact. The ellipse shows where the cue ball comes to rest under the
    player's errors, as far as it lies on the table.

    Args:
        analysis: The analysis.
        title: Heading of the panel; None writes the game's name.

    Returns:
        A matplotlib figure, not attached to any window.

    Raises:
        InputError: The analysis has no play.
    """
    instance("analysis", analysis, Analysis, "player.explain(frame)")
    best = analysis.best
    if best is None:
        raise InputError(
            "no-play", "analysis", "it has no play to draw", "look at the places of the balls"
        )
    figure, ax = sheet(best.shot, PANEL_INCHES)
    _draw_play(ax, best)
    _draw_list(figure, analysis, title or analysis.frame.game)
    return as_written(figure)


def svg(analysis: Analysis, *, title: str | None = None) -> str:
    """The picture as SVG text; the same text for the same analysis."""
    return to_svg(draw(analysis, title=title))


def png(analysis: Analysis, *, title: str | None = None) -> bytes:
    """The picture as the content of a PNG file."""
    return to_png(draw(analysis, title=title))


def _draw_play(ax: Axes, best: Recommendation) -> None:
    shot = best.shot
    trace = shot.simulate()
    written = trace.to_dict()
    paths = routes(written, starts(trace))
    struck = written["events"][0]["balls"][0]
    draw_paths(ax, paths)
    draw_marks(ax, written["events"], paths)
    _draw_leave(ax, best)
    for index, route in enumerate(paths):
        look = colors.look(route.id, index)
        draw_ball(ax, route.start, route.radius, look, gid=f"ball-{route.id}")
        if route.id == struck:
            _draw_ghost(ax, route, written["events"])
            draw_cue(ax, route.start, best.play.strike.azimuth, route.radius)
            if route.fate not in {"pocketed", "off-table"}:
                draw_ring(ax, route.end, route.radius, "solid", gid="cue-ball-end")


def _draw_ghost(ax: Axes, route: Route, events: list[dict[str, Any]]) -> None:
    """Draw the cue ball at its first contact with a ball."""
    for event in events:
        if event["type"] == "ball-collision" and route.id in event["balls"]:
            x, y, _ = event["before"][event["balls"].index(route.id)]["position"]
            draw_ring(ax, (x, y), route.radius, (0, (2.5, 1.6)), gid="ghost-ball")
            return


def _draw_leave(ax: Axes, best: Recommendation) -> None:
    """Draw the ellipse in which the cue ball comes to rest."""
    if best.leave.count < 2:
        return
    variances, axes = np.linalg.eigh(np.array(best.leave.covariance))
    narrow, wide = (2 * DEVIATIONS * math.sqrt(max(0.0, v)) for v in variances)
    ellipse = Ellipse(
        best.leave.mean,
        wide,
        narrow,
        angle=math.degrees(math.atan2(axes[1, 1], axes[0, 1])),
        facecolor="#ffffff18",
        edgecolor="white",
        linewidth=0.8,
        linestyle=(0, (3, 2)),
        zorder=2.4,
        gid="leave",
    )
    ax.add_patch(ellipse)
    width, length = best.shot.geometry()["size"]
    ellipse.set_clip_path(Rectangle((0, 0), width, length, transform=ax.transData))


def _draw_list(figure: Figure, analysis: Analysis, title: str) -> None:
    wide, tall = figure.get_size_inches()
    panel = figure.add_axes((1 - PANEL_INCHES / wide, 0, PANEL_INCHES / wide, 1))
    panel.set_xlim(0, PANEL_INCHES)
    panel.set_ylim(0, tall)
    panel.set_axis_off()
    y = tall - MARGIN_INCHES
    panel.text(0.1, y, title, fontsize=12, fontweight="bold", color=colors.INK, va="top")
    said = [
        *wrap(analysis.title, LINE),
        "on the table: play 1 without errors",
        "dashed circle: ghost ball · ring: end of the cue ball",
        f"ellipse: its end under errors, {DEVIATIONS:g} standard deviations",
    ]
    panel.text(
        0.1, y - 0.3, "\n".join(said), fontsize=7, color=colors.FAINT_INK, va="top", linespacing=1.3
    )
    y -= 0.45 + 0.14 * len(said)
    for row, play in zip(analysis.rows()[:SHOWN], analysis.plays, strict=False):
        number, win, kept, foul, if_kept, if_missed, *_ = row
        panel.text(0.1, y, number, fontsize=9, va="top", weight="bold", color=colors.FAINT_INK)
        panel.text(0.34, y, f"wins {win}", fontsize=9, va="top", color=colors.INK, weight="bold")
        lines = (
            *wrap(str(play), LINE),
            f"turn kept {kept} · foul {foul} · wins {if_kept} if kept, {if_missed} if not",
            f"cue ball left at {play.leave}",
        )
        panel.text(
            0.34,
            y - 0.19,
            "\n".join(lines),
            fontsize=7,
            va="top",
            color=colors.INK,
            linespacing=1.35,
        )
        y -= ENTRY_INCHES
