"""Pictures of balls before they move: of a shot, and of a frame."""

from __future__ import annotations

import math
from textwrap import wrap
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure
from matplotlib.patches import Rectangle, Wedge

from carom.arguments import text
from carom.picture import colors, table
from carom.picture.balls import draw_ball, draw_cue, draw_ring
from carom.picture.canvas import (
    LEAST_HEIGHT_POINTS,
    LONG_SIDE_INCHES,
    MARGIN_POINTS,
    PANEL_POINTS,
    SMALLEST_BALL_POINTS,
)
from carom.picture.legend import Panel
from carom.picture.output import as_written
from carom.picture.paths import Route
from carom.player import words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from carom.picture.paths import Point
    from carom.rules import Frame
    from carom.shot import Shot

# Width of the panel's text, characters.
LINE = 46


def draw_shot(shot: Shot, *, title: str | None = None) -> Figure:
    """Draw a shot before the strike: the balls, the cue, and the line of aim.

    The line ends where the cue ball would meet a ball or a rail if it ran straight; there the ball
    is drawn as a dashed circle. The trace has the true path.

    Args:
        shot: The shot.
        title: Heading of the panel; None writes the table's name.
    """
    geometry, balls = shot.geometry(), _resting(shot)
    struck = None if shot.strike is None else shot.strike.ball
    ax, panel, smallest = _sheet(geometry, balls, title or geometry["name"] or "shot")
    for ball in balls:
        if ball.id == struck:
            _draw_aim(ax, geometry, ball, balls, shot.azimuth or 0.0)
            draw_cue(ax, ball.start, shot.azimuth or 0.0, max(ball.radius, smallest))
    _draw_all(ax, balls, smallest)
    _write(panel, _strike_lines(shot))
    return as_written(panel.ax.figure)  # type: ignore[arg-type] # no subfigure


def draw_frame(frame: Frame, *, title: str | None = None) -> Figure:
    """Draw the balls of a frame, with its score and its request.

    The balls on have a ring; where the cue ball in hand may be placed, the cloth is lighter.

    Args:
        frame: The frame.
        title: Heading of the panel; None writes the game.
    """
    geometry = frame.geometry()
    radius = frame._bare_shot().radius[0]
    places = {ball: (x, y, radius) for ball, (x, y) in frame.balls.items()}
    balls = [_route(ball, radius, place) for ball, place in places.items()]
    ax, panel, smallest = _sheet(geometry, balls, title or frame.game)
    request = frame.request
    _draw_hand(ax, frame)
    for ball in balls:
        if ball.id in request.on:
            draw_ring(
                ax, ball.start, 1.35 * max(ball.radius, smallest), "solid", gid=f"on-{ball.id}"
            )
    _draw_all(ax, balls, smallest)
    first, *lines = frame.describe().split("\n")
    kept = [line for line in lines if not line.startswith(("Table:", "Pockets:", "Balls:"))]
    _write(panel, [first.partition(". ")[2], *kept])
    return as_written(panel.ax.figure)  # type: ignore[arg-type] # no subfigure


def _sheet(geometry: dict[str, Any], balls: list[Route], title: str) -> tuple[Axes, Panel, float]:
    """The table's axes (m), the panel beside it, and the least radius of a ball, m."""
    if text("title", title) and geometry["size"] is None:
        title = f"{title}, without rails"
    left, bottom, right, top = table.bounds(geometry, balls)
    point = max(right - left, top - bottom) / (72 * LONG_SIDE_INCHES)
    margin = MARGIN_POINTS * point
    height = max(top - bottom, LEAST_HEIGHT_POINTS * point)
    width = right - left + 3 * margin + PANEL_POINTS * point
    paper = (width / point / 72, (height + 2 * margin) / point / 72)
    figure = Figure(figsize=paper, facecolor=colors.PAPER)
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set_axis_off()
    ax.set_xlim(left - margin, left - margin + width)
    ax.set_ylim(top - height - margin, top + margin)
    table.draw_table(ax, geometry, (left, bottom, right, top))
    panel = Panel(ax, right + 1.6 * margin, top, point)
    panel.write(title, 15, fontweight="bold")
    panel.skip(6)
    return ax, panel, SMALLEST_BALL_POINTS * point


def _write(panel: Panel, lines: list[str]) -> None:
    for line in filter(None, lines):
        for part in wrap(line, LINE):
            panel.write(part, 8.5)
        panel.skip(5)


def _resting(shot: Shot) -> list[Route]:
    return [
        _route(ball.id, radius, (*ball.position, radius)[:3])
        for ball, radius in zip(shot.balls, shot.radius.tolist(), strict=True)
    ]


def _route(ball: str, radius: float, place: tuple[float, ...]) -> Route:
    x, y, z = place
    return Route(ball, radius, (x, y), (x, y), (), "stationary", (z, z))


def _draw_all(ax: Axes, balls: list[Route], smallest: float) -> None:
    for index, ball in enumerate(balls):
        style = colors.look(ball.id, index)
        draw_ball(ax, ball.start, max(ball.radius, smallest), style, gid=f"ball-{ball.id}")


def _strike_lines(shot: Shot) -> list[str]:
    strike = shot.strike
    if strike is None:
        moving = [ball.id for ball in shot.balls if any(ball.get("velocity", ()))]
        return [f"moving at the start: {', '.join(moving)}" if moving else "no strike"]
    elevation = shot.elevation or 0.0
    return [
        f"{strike.ball}: {words.strike(strike.speed, strike.side, strike.height, elevation)}",
        f"azimuth {strike.azimuth_deg:.2f}°, elevation {math.degrees(elevation):.1f}°",
    ]


def _draw_aim(
    ax: Axes, geometry: dict[str, Any], cue: Route, balls: list[Route], azimuth: float
) -> None:
    (x, y), (along_x, along_y) = cue.start, (math.cos(azimuth), math.sin(azimuth))
    free = _to_rail(geometry, cue, (along_x, along_y))
    met = None
    for ball in balls:
        dx, dy = ball.start[0] - x, ball.start[1] - y
        ahead, aside = dx * along_x + dy * along_y, dx * along_y - dy * along_x
        reach = cue.radius + ball.radius
        if ball is cue or ahead <= 0 or abs(aside) >= reach:
            continue
        distance = ahead - math.sqrt(reach**2 - aside**2)
        if distance < free:
            free, met = max(distance, 0.0), ball
    end = (x + free * along_x, y + free * along_y)
    ax.plot(
        [x, end[0]],
        [y, end[1]],
        color="white",
        linewidth=0.9,
        linestyle=(0, (5, 3)),
        alpha=0.85,
        zorder=3,
        gid="aim",
    )
    if met is not None or geometry["size"] is not None:
        draw_ring(ax, end, cue.radius, (0, (2.5, 1.6)), gid="ghost-ball")


def _to_rail(geometry: dict[str, Any], cue: Route, along: Point) -> float:
    """How far the ball's centre can run to a rail's nose, or across the picture, m."""
    if geometry["size"] is None:
        return 2.0
    ways = [
        ((size - cue.radius if step > 0 else cue.radius) - place) / step
        for place, step, size in zip(cue.start, along, geometry["size"], strict=True)
        if abs(step) > 1e-12
    ]
    return max(min(ways), 0.0)


def _draw_hand(ax: Axes, frame: Frame) -> None:
    bounds = frame.hand_bounds
    if bounds is None:
        return
    (left, bottom), (right, top) = bounds
    style: dict[str, Any] = {"facecolor": "#ffffff1c", "edgecolor": "#ffffff90", "zorder": 1.5}
    style |= {"linewidth": 0.8, "linestyle": (0, (4, 3)), "gid": "hand"}
    if frame.request.in_hand == "the-d":
        ax.add_patch(Wedge((0.5 * (left + right), top), 0.5 * (right - left), 180, 360, **style))
    else:
        ax.add_patch(Rectangle((left, bottom), right - left, top - bottom, **style))
