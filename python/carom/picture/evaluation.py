"""The picture of an evaluation: paths of the cue ball, and where it comes to rest."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.patches import Ellipse, PathPatch

from carom.arguments import instance
from carom.batch import own_strike
from carom.errors import InputError
from carom.picture import colors
from carom.picture.balls import curve, draw_ball, draw_cue
from carom.picture.output import as_written, to_png, to_svg
from carom.picture.paths import routes, starts
from carom.picture.sheet import MARGIN_INCHES, sheet
from carom.picture.style import own_style
from carom.plan import Evaluation

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from carom.shot import Shot

# Number of variants whose paths are drawn: enough to show the spread, few enough to stay legible.
FAN = 40
# Cells of the heat map along the table's longer side.
CELLS = 160
# Width of the panel beside the table, inches.
PANEL_INCHES = 4.2
# Half axes of the ellipse, standard deviations.
DEVIATIONS = 2.0


@own_style()
def draw(evaluation: Evaluation, *, title: str | None = None) -> Figure:
    """Draw the paths of some variants and the density of the cue ball's final positions.

    Args:
        evaluation: The evaluation to draw.
        title: Heading of the panel; None writes the table's name.

    Returns:
        A matplotlib figure, not attached to any window.

    Raises:
        InputError: The cloth has no edges, so there is no table to draw.
    """
    instance("evaluation", evaluation, Evaluation, "Shot.evaluate(noise)")
    shot = evaluation.shot
    geometry = shot.geometry()
    figure, ax = sheet(shot, PANEL_INCHES)
    _draw_heat(ax, evaluation, geometry["size"])
    _draw_fan(ax, evaluation)
    _draw_ellipse(ax, evaluation)
    _draw_start(ax, shot)
    figure.text(
        1 - PANEL_INCHES / figure.get_figwidth(),
        1 - 1.5 * MARGIN_INCHES / figure.get_figheight(),
        f"{title or geometry['name'] or 'shot'}\n\n{evaluation}\n\n"
        f"{_errors(evaluation)}\n\n"
        f"white: paths of the cue ball, {min(FAN, evaluation.n)} variants\n"
        "glow: where it comes to rest\n"
        f"ellipse: {DEVIATIONS:g} standard deviations",
        va="top",
        family="monospace",
        fontsize=7.2,
        color=colors.INK,
    )
    return as_written(figure)


def svg(evaluation: Evaluation, *, title: str | None = None) -> str:
    """The picture as SVG text; the same text for the same evaluation."""
    return to_svg(draw(evaluation, title=title))


def png(evaluation: Evaluation, *, title: str | None = None) -> bytes:
    """The picture as the content of a PNG file."""
    return to_png(draw(evaluation, title=title))


def variants(evaluation: Evaluation, count: int) -> list[Shot]:
    """The valid ones among the first ``count`` variants."""
    shot, seed = evaluation.shot, evaluation.seed
    played = []
    for index in range(count):
        try:
            variant = evaluation.noise.variant(shot, index, seed=seed)
            played.append(evaluation.perception.see(variant, index, seed=seed))
        except InputError:
            # A miscue has no path to draw.
            continue
    return played


def _errors(evaluation: Evaluation) -> str:
    """The player's noise, in words."""
    noise = evaluation.noise
    played = own_strike(evaluation.shot._core)
    said = "σ of the strike: " + _five(noise.deviations(played[0]))
    if any(noise.mean()):
        said += "\nmean error: " + _five(noise.mean())
    if noise.cling_probability:
        said += (
            f"\ncling: {noise.cling_probability:.2g} of the contacts, "
            f"friction {noise.cling_friction:.2g}"
        )
    x, y = evaluation.perception.sigma
    if x or y:
        said += f"\nσ of the balls' perceived positions: {1e3 * x:.3g} mm"
        said += "" if x == y else f" across and {1e3 * y:.3g} mm along the table"
    if evaluation.perception.balls:
        said += f"\nσ of its own: {', '.join(evaluation.perception.balls)}"
    return said


def _five(errors: Sequence[float]) -> str:
    """Errors of the five parameters of a strike, in words."""
    speed, azimuth, elevation, side, height = errors
    return (
        f"{speed:.3g} m/s, direction {math.degrees(azimuth):.3g}°,\n"
        f"  elevation {math.degrees(elevation):.3g}°, "
        f"tip {1e3 * side:.3g} and {1e3 * height:.3g} mm"
    )


def _draw_fan(ax: Axes, evaluation: Evaluation) -> None:
    for index, variant in enumerate(variants(evaluation, min(FAN, evaluation.n))):
        trace = variant.simulate()
        for number, route in enumerate(routes(trace.to_dict(), starts(trace))):
            if not route.legs:
                continue
            own = number == evaluation.cue_ball
            ax.add_patch(
                PathPatch(
                    curve([(leg.start, leg.control, leg.end) for leg in route.legs]),
                    facecolor="none",
                    edgecolor="white" if own else colors.look(route.id, number).path,
                    alpha=0.28,
                    linewidth=0.7,
                    zorder=3,
                    gid=f"fan-{index}-{route.id}",
                )
            )


def _draw_heat(ax: Axes, evaluation: Evaluation, size: tuple[float, float]) -> None:
    ends = evaluation.cue_ball_ends
    ends = ends[~np.isnan(ends[:, 0])]
    if not len(ends):
        return
    width, length = size
    cell = max(size) / CELLS
    counts, _, _ = np.histogram2d(
        ends[:, 0],
        ends[:, 1],
        bins=(max(1, round(width / cell)), max(1, round(length / cell))),
        range=((0, width), (0, length)),
    )
    glow = LinearSegmentedColormap.from_list("glow", ["#ffb00000", "#ffb000c0", "#fff3c8ff"])
    # The square root makes rare positions visible beside frequent ones.
    ax.imshow(
        np.sqrt(counts.T),
        origin="lower",
        extent=(0, width, 0, length),
        cmap=glow,
        interpolation="bilinear",
        zorder=2.4,
        gid="heat",
    )


def _draw_ellipse(ax: Axes, evaluation: Evaluation) -> None:
    if evaluation.at_rest[evaluation.cue_ball] < 2:
        return
    spread, axes = np.linalg.eigh(evaluation.end_covariance[evaluation.cue_ball])
    # Rounding may make a variance of zero slightly negative.
    long, short = (2 * DEVIATIONS * math.sqrt(max(0.0, s)) for s in spread[::-1])
    ax.add_patch(
        Ellipse(
            tuple(evaluation.end_mean[evaluation.cue_ball]),
            long,
            short,
            angle=math.degrees(math.atan2(axes[1, 1], axes[0, 1])),
            facecolor="none",
            edgecolor="white",
            linewidth=0.9,
            linestyle="--",
            zorder=5,
            gid="ellipse",
        )
    )


def _draw_start(ax: Axes, shot: Shot) -> None:
    start = shot.simulate().at(0.0).position
    struck = shot.to_dict()["strike"].get("ball", "cue")
    for index, (name, radius) in enumerate(zip(shot.ids, shot.radius.tolist(), strict=True)):
        place = (float(start[index, 0]), float(start[index, 1]))
        draw_ball(ax, place, radius, colors.look(name, index))
        if name == struck and shot.azimuth is not None:
            draw_cue(ax, place, shot.azimuth, radius)
