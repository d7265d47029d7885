"""The side view of a ball that flies: its height against the distance along its path.

Both axes have the same scale, so that balls are round. Flights appear as their true parabolas: a
flight is straight seen from above, and its length there grows linearly with time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Circle, PathPatch, Rectangle
from matplotlib.patheffects import Normal, Stroke

from carom.flights import runs
from carom.picture import colors
from carom.picture.balls import curve, draw_ball, draw_cue, draw_mark, mark
from carom.picture.colors import look
from carom.picture.paths import SEEN
from carom.picture.table import Ground

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes

    from carom.picture.paths import Leg, Route

# A ball that rises less than this, m, has no side view.
LEAST_RISE = 5e-3
# Most side views; the balls that rise highest have one.
MOST_VIEWS = 3
# Flights that are separated by less than this on the slate, m, are shown together.
SAME_FLIGHT = 0.1
# Length of path shown before the first and after the last flight, m.
MARGIN = 0.13
# Largest scale, points per metre.
LARGEST_SCALE = 560.0
# Drawn thickness of the slate, and free space above the highest point, m.
SLATE = 0.022
AIR = 0.022
# A rise of less than this, m, is written above the ball, without an arrow.
LEAST_ARROW = 0.02
# Step along a path for the kind of ground under it, m: half a point in print.
GROUND_STEP = 1e-3
# Number of instants of a flight at which other balls are searched under it.
LOOKS = 64


@dataclass(frozen=True, slots=True)
class View:
    """The shown part of one ball's path; lengths in m, along the path from its start."""

    index: int
    route: Route
    starts: tuple[float, ...]
    """Distance along the path where each leg starts."""
    left: float
    right: float
    top: float
    highest: Leg

    @property
    def height(self) -> float:
        """Height of the drawing, m."""
        return SLATE + self.top

    def along(self, leg: Leg, time: float) -> float:
        """Distance along the path at a time (s) of a leg in the air, or at the leg's ends."""
        start = self.starts[self.route.legs.index(leg)]
        return start + leg.length * (time - leg.start_time) / (leg.end_time - leg.start_time)

    def legs(self) -> Iterator[tuple[float, Leg]]:
        """The legs that are shown, each with the distance where it starts."""
        for start, leg in zip(self.starts, self.route.legs, strict=True):
            if start <= self.right and start + leg.length >= self.left:
                yield start, leg


def views(routes: list[Route], width: float, cushion_height: float) -> list[View]:
    """The side views of a shot.

    Args:
        routes: Every ball's path.
        width: Width of the paper, points.
        cushion_height: Height of the nose, m.
    """
    flyers = [
        (index, route)
        for index, route in enumerate(routes)
        if max(map(route.rise, route.legs), default=0.0) >= LEAST_RISE
    ]
    flyers.sort(key=lambda item: -max(map(item[1].rise, item[1].legs)))
    return [_view(index, route, width, cushion_height) for index, route in flyers[:MOST_VIEWS]]


def _view(index: int, route: Route, width: float, cushion_height: float) -> View:
    legs = route.legs
    starts = [0.0]
    for leg in legs:
        starts.append(starts[-1] + leg.length)
    peak = max(range(len(legs)), key=lambda i: route.rise(legs[i]))
    first = last = peak
    for step in (-1, 1):
        gap, i = 0.0, peak + step
        while 0 <= i < len(legs) and gap < SAME_FLIGHT:
            if legs[i].flies or legs[i].top - route.radius >= SEEN:
                gap, first, last = 0.0, min(first, i), max(last, i)
            else:
                gap += legs[i].length
            i += step
    left, right = starts[first] - MARGIN, starts[last + 1] + MARGIN
    missing = max(0.0, width / LARGEST_SCALE - (right - left))
    height = max(leg.top for leg in legs[first : last + 1])
    top = AIR + max(height, cushion_height, 2 * route.radius) + route.radius
    return View(index, route, tuple(starts[:-1]), left, right + missing, top, legs[peak])


def draw_side(
    ax: Axes,
    view: View,
    routes: list[Route],
    events: list[dict[str, Any]],
    geometry: dict[str, Any],
    elevation: float | None,
) -> None:
    """Fill the axes with one view.

    Args:
        ax: The axes, with their limits and scale set.
        view: The view to draw.
        routes: Every ball's path.
        events: The events of the trace.
        geometry: The table as ``Shot.geometry`` returns it.
        elevation: Elevation of the cue, rad, if it struck this ball.
    """
    ax.add_patch(
        Rectangle((view.left, -SLATE), view.right - view.left, view.height, facecolor=colors.WALL)
    )
    _draw_ground(ax, view, geometry)
    for start, leg in view.legs():
        others = [r for r in enumerate(routes) if r[0] != view.index]
        _draw_passed(ax, view, leg, others)
        middle = start + leg.length / 2
        _draw_leg(ax, view, [(start, leg.heights[0]), (middle, leg.heights[1])], start, leg)
    _draw_flyer(ax, view)
    _draw_marks(ax, view, events, routes)
    if elevation is not None and view.left < 0:
        draw_cue(ax, (0.0, view.route.rest_heights[0]), -elevation, view.route.radius)
    _write(ax, view, geometry)


def _draw_leg(
    ax: Axes, view: View, begin: list[tuple[float, float]], start: float, leg: Leg
) -> None:
    style = look(view.route.id, view.index)
    patch = PathPatch(
        curve([(*begin, (start + leg.length, leg.heights[2]))]),
        facecolor="none",
        edgecolor=style.path,
        linewidth=1.4,
        linestyle=(0, (5, 1.6)) if style.striped else "solid",
        capstyle="round",
        zorder=5,
        gid=f"side-{view.route.id}",
    )
    patch.set_path_effects([Stroke(linewidth=2.4, foreground="#00000050"), Normal()])
    ax.add_patch(patch)


def _draw_ground(ax: Axes, view: View, geometry: dict[str, Any]) -> None:
    """Draw the slate with the holes under the path, and the wood of the rails."""
    ground = Ground(geometry)
    steps = math.ceil((view.right - view.left) / GROUND_STEP)
    places = [view.left + i * (view.right - view.left) / steps for i in range(steps + 1)]
    kinds = [ground.under(_point(view, place)) for place in places]
    changes = [0, *(i + 1 for i, (a, b) in enumerate(pairwise(kinds)) if a != b), steps]
    for begin, end in pairwise(changes):
        left, length = places[begin], places[end] - places[begin]
        kind = kinds[begin]
        if kind == "floor":
            continue
        if kind == "hole":
            ax.add_patch(Rectangle((left, -SLATE), length, SLATE, facecolor=colors.HOLE, zorder=1))
            continue
        height = geometry["cushion_height"] if kind == "rail" else 0.0
        stuff = colors.RAIL if kind == "rail" else colors.SLATE
        ax.add_patch(
            Rectangle((left, -SLATE), length, SLATE + height, facecolor=stuff, zorder=1, gid=kind)
        )
        if kind == "bed":
            ax.plot([left, left + length], [0, 0], color=colors.CUSHION_EDGE, lw=1.6, zorder=1.5)


def _point(view: View, place: float) -> tuple[float, float]:
    """The point of the table at a distance along the path; beyond its ends, straight on."""
    legs = view.route.legs
    for start, leg in zip(view.starts, legs, strict=True):
        if start <= place <= start + leg.length and leg.length > 0:
            share = (place - start) / leg.length
            x, y, _ = leg.at(leg.start_time + share * (leg.end_time - leg.start_time))
            return (x, y)
    leg, beyond = (legs[0], place) if place < 0 else (legs[-1], place - view.starts[-1])
    length = math.dist(leg.start, leg.end) or 1.0
    share = beyond / length
    return (
        leg.start[0] + share * (leg.end[0] - leg.start[0]),
        leg.start[1] + share * (leg.end[1] - leg.start[1]),
    )


def _draw_passed(ax: Axes, view: View, leg: Leg, others: list[tuple[int, Route]]) -> None:
    """Draw the balls that a flight passes over or ends at, where it is nearest to them.

    The ball from which the flight starts is left out: the flight before shows it.
    """
    if view.route.rise(leg) < SEEN:
        return
    times = [leg.start_time + i * (leg.end_time - leg.start_time) / LOOKS for i in range(LOOKS + 1)]
    for index, other in others:
        nearest = min(times, key=lambda t: math.dist(leg.at(t)[:2], other.at(t)[:2]))
        if nearest == leg.start_time:
            continue
        x, y, z = other.at(nearest)
        if z + other.radius > view.top:
            continue
        # A contact at the end of the flight counts, although rounding may leave a gap.
        if math.dist(leg.at(nearest)[:2], (x, y)) > 1.001 * (view.route.radius + other.radius):
            continue
        ahead = _ahead(leg, (x, y))
        draw_ball(
            ax, (view.along(leg, leg.start_time) + ahead, z), other.radius, look(other.id, index)
        )


def _ahead(leg: Leg, point: tuple[float, float]) -> float:
    """Distance of a point from a flight's start, along the flight, m."""
    dx, dy = leg.end[0] - leg.start[0], leg.end[1] - leg.start[1]
    length = math.hypot(dx, dy) or 1.0
    return ((point[0] - leg.start[0]) * dx + (point[1] - leg.start[1]) * dy) / length


def _draw_flyer(ax: Axes, view: View) -> None:
    """Draw the ball where it takes off, where it is highest, and where its last flight ends."""
    style = look(view.route.id, view.index)
    shown = [(start, leg) for start, leg in view.legs() if view.route.rise(leg) >= SEEN]
    start, leg = shown[0]
    ghosts = [(start, leg.heights[0])]
    place, rise = _peak(view), view.route.rise(view.highest)
    ghosts.append((place, view.highest.top))
    for ghost in ghosts:
        ax.add_patch(
            Circle(
                ghost,
                view.route.radius,
                facecolor="#ffffff1c",
                edgecolor=style.path,
                linewidth=0.9,
                zorder=4,
            )
        )
    start, leg = shown[-1]
    draw_ball(ax, (start + leg.length, leg.heights[2]), view.route.radius, style)
    beside = rise >= LEAST_ARROW
    if beside:
        ax.annotate(
            "",
            (place, 0.0),
            xytext=(place, rise),
            arrowprops={
                "arrowstyle": "<->",
                "color": "white",
                "lw": 0.7,
                "shrinkA": 0,
                "shrinkB": 0,
            },
            zorder=6,
        )
    ax.annotate(
        f"{1000 * rise:.0f} mm",
        (place, rise / 2 if beside else view.highest.top + view.route.radius),
        xytext=(4, 0) if beside else (0, 3),
        textcoords="offset points",
        ha="left" if beside else "center",
        va="center" if beside else "bottom",
        color="white",
        fontsize=7.5,
        zorder=6,
    )


def _peak(view: View) -> float:
    """Distance along the path where the highest flight peaks."""
    leg = view.highest
    z0, control, z1 = leg.heights
    share = min(1.0, max(0.0, (z0 - control) / (z0 - 2 * control + z1)))
    return view.starts[view.route.legs.index(leg)] + share * leg.length


def _draw_marks(ax: Axes, view: View, events: list[dict[str, Any]], routes: list[Route]) -> None:
    by_id = {route.id: route for route in routes}
    style = look(view.route.id, view.index)
    for event in (events[run[0]] for run in runs(events)):
        if view.route.id not in event["balls"]:
            continue
        kind = mark(event, {ball: by_id[ball] for ball in event["balls"]})
        if kind is None or kind == "motion-transition":
            continue
        for start, leg in view.legs():
            if leg.end_time == event["time"]:
                color = colors.IVORY if kind == "ball-collision" else style.path
                draw_mark(ax, (start + leg.length, leg.heights[2]), kind, color)


def _write(ax: Axes, view: View, geometry: dict[str, Any]) -> None:
    if geometry["size"] is not None:
        nose = geometry["cushion_height"]
        ax.plot([view.left, view.right], [nose, nose], color="white", alpha=0.35, lw=0.7, ls=":")
        ax.annotate(
            "nose",
            (view.right, nose),
            xytext=(-4, 2),
            textcoords="offset points",
            ha="right",
            color="white",
            alpha=0.55,
            fontsize=6.5,
        )
    ax.annotate(
        f"{view.route.id} from the side",
        (view.right, view.top),
        xytext=(-6, -6),
        textcoords="offset points",
        ha="right",
        va="top",
        color="white",
        alpha=0.8,
        fontsize=7.5,
    )
    right, low = view.right - 0.02, -0.6 * SLATE
    ax.plot(
        [right - 0.1, right], [low, low], color="white", lw=1.4, solid_capstyle="butt", zorder=7
    )
    ax.annotate(
        "0.1 m",
        (right - 0.1, low),
        xytext=(-4, 0),
        textcoords="offset points",
        ha="right",
        va="center",
        color="white",
        fontsize=6.5,
        zorder=7,
    )
