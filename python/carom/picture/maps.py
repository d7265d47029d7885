"""Pictures of maps: pot probabilities, positions, pocket acceptance, cushion shots, breaks."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure

from carom.errors import InputError
from carom.picture import colors
from carom.picture.balls import draw_ball
from carom.picture.output import as_written, to_png, to_svg
from carom.picture.sheet import sheet
from carom.picture.style import own_style
from carom.plan import Acceptance, BreakStatistics, CushionTable, PositionMap, PotMap

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.shot import Shot

    Drawn: TypeAlias = PotMap | PositionMap | Acceptance | BreakStatistics | CushionTable

# Width of the space beside the table for the scale, inches.
SCALE_INCHES = 1.3
# Size of a figure of curves and bars without a table, inches.
CHART_INCHES = (7.2, 4.6)
# Layer above the cloth and below the balls, so that the map has the colours of the scale.
MAP_LAYER = 1.15


@own_style()
def draw(found: Drawn, *, title: str | None = None) -> Figure:
    """Draw a map, a table of cushion shots or statistics of breaks.

    Args:
        found: The result of ``carom.pot_map`` or of a similar function.
        title: Heading; None writes a default one.

    Returns:
        A matplotlib figure, not attached to any window.
    """
    return as_written(_draw(found, title))


def _draw(found: Drawn, title: str | None) -> Figure:
    if isinstance(found, CushionTable):
        return _draw_cushions(found, title or f"{found.ball} off the cushions")
    if isinstance(found, PotMap):
        return _draw_pots(found, title or f"{found.ball} into {found.pocket}")
    if isinstance(found, PositionMap):
        return _draw_positions(found, title or f"after {found.ball} into {found.pocket}")
    if isinstance(found, Acceptance):
        return _draw_acceptance(found, title or f"acceptance of {found.pocket}")
    if isinstance(found, BreakStatistics):
        return _draw_breaks(found, title or f"{found.racks} breaks of {found.game}")
    raise InputError(
        "wrong-type",
        "found",
        f"found a {type(found).__name__}",
        "give a carom.Shot, a carom.Frame, a carom.Trace, or the answer to a question about a shot",
    )


def svg(found: Drawn, *, title: str | None = None) -> str:
    """The picture as SVG text; the same text for the same map."""
    return to_svg(draw(found, title=title))


def png(found: Drawn, *, title: str | None = None) -> bytes:
    """The picture as the content of a PNG file."""
    return to_png(draw(found, title=title))


def _draw_pots(found: PotMap, title: str) -> Figure:
    figure, ax = sheet(found.shot, SCALE_INCHES, heading=title)
    width, length = found.shot.geometry()["size"]
    image = ax.imshow(
        found.chance,
        origin="lower",
        extent=(0, width, 0, length),
        cmap="viridis",
        vmin=0,
        vmax=1,
        zorder=MAP_LAYER,
        gid="chance",
    )
    bar = _scale(figure, ax, image, "probability of the pot")
    bar.ax.yaxis.set_major_formatter(lambda x, _: f"{100 * x:.0f} %")
    _balls(ax, found.shot, without=_struck(found.shot))
    return figure


def _draw_positions(found: PositionMap, title: str) -> Figure:
    figure, ax = sheet(found.shot, SCALE_INCHES, heading=title)
    paint = _paint(found.speed)
    what, labels = _spins(found)
    for column, label in enumerate(labels):
        ends = found.end[:, column]
        good = found.falls[:, column]
        x, y = (_gapped(ends[:, axis], good) for axis in (0, 1))
        ax.plot(x, y, color="white", alpha=0.35, linewidth=0.8, zorder=5, gid=f"spin-{column}")
        ax.scatter(
            ends[good, 0],
            ends[good, 1],
            c=found.speed[good],
            cmap=paint.cmap,
            vmin=found.speed.min(),
            vmax=found.speed.max(),
            s=9,
            edgecolor="white",
            linewidth=0.3,
            zorder=5.5,
        )
        last = [(a, b) for (a, b), ok in zip(ends.tolist(), good, strict=True) if ok]
        if last and len(found.height) <= 12:
            ax.annotate(
                label,
                last[-1],
                xytext=(4, 2),
                textcoords="offset points",
                fontsize=6.5,
                color="white",
                bbox={"boxstyle": "round,pad=0.15", "facecolor": colors.CLOTH, "linewidth": 0},
                zorder=7,
            )
    _scale(figure, ax, paint, f"speed of the cue, m/s; labels: {what}, ball radii")
    _balls(ax, found.shot)
    return figure


def _spins(found: PositionMap) -> tuple[str, list[str]]:
    """The heading and the labels of the lines: side, height or both, whichever varies."""
    sides, heights = (
        [f"{value:+.2g}" if value else "0" for value in spin] for spin in (found.side, found.height)
    )
    if len(set(sides)) == 1:
        return "height of the tip", heights
    if len(set(heights)) == 1:
        return "side", sides
    both = zip(sides, heights, strict=True)
    return "side and height", [f"{side} {height}" for side, height in both]


def _draw_cushions(found: CushionTable, title: str) -> Figure:
    figure, ax = sheet(found.shot, SCALE_INCHES, heading=title)
    # The one colour bar shows the speed if there are several speeds, else the side.
    by_speed = len(found.speed) > 1 or len(found.side) == 1
    paint = _paint(found.speed if by_speed else found.side)
    file = next(ball for ball in found.shot.to_dict()["balls"] if ball["id"] == found.ball)
    start = file["position"][:2]
    for i in range(len(found.azimuth)):
        for j, speed in enumerate(found.speed.tolist()):
            for k, side in enumerate(found.side.tolist()):
                x, y = zip(start, *found.contact[i, j, k].tolist(), strict=True)
                ax.plot(
                    x,
                    y,
                    color=paint.to_rgba(speed if by_speed else side),
                    linestyle=_dashes(side) if by_speed else "solid",
                    marker="o",
                    markersize=1.6,
                    alpha=0.8,
                    linewidth=0.9,
                    zorder=3,
                    gid=f"way-{i}-{j}-{k}",
                )
    label = "contact point right of centre, ball radii"
    if by_speed:
        label = "speed, m/s"
        if len(found.side) > 1:
            label += "; dashed: left side, dotted: right side"
    _scale(figure, ax, paint, label)
    _balls(ax, found.shot, only=found.ball)
    return figure


def _dashes(side: float) -> Any:
    """Line style: solid without side, dashed for left side, dotted for right side."""
    return "solid" if side == 0 else (0, (5, 2)) if side < 0 else (0, (1, 1.2))


def _paint(values: NDArray[np.float64]) -> ScalarMappable:
    """A colour map from the least to the greatest value, visible on the cloth."""
    # The dark end of the colour map cannot be seen on the cloth.
    bright = ListedColormap(colormaps["plasma"](np.linspace(0.42, 1.0, 256)))
    return ScalarMappable(Normalize(float(values.min()), float(values.max())), bright)


def _gapped(values: Any, good: Any) -> list[float]:
    """NaN where the ball is not potted, which breaks the line."""
    return [float(v) if ok else math.nan for v, ok in zip(values, good, strict=True)]


def _draw_acceptance(found: Acceptance, title: str) -> Figure:
    figure = Figure(figsize=CHART_INCHES, facecolor=colors.PAPER, layout="constrained")
    ax = figure.add_subplot(facecolor=colors.PAPER)
    angles = np.degrees(found.angle)
    for row, speed in enumerate(found.speed):
        ax.plot(angles, 1e3 * found.width[row], label=f"{speed:g} m/s", gid=f"speed-{row}")
    ax.set_xlabel("angle to the pocket's axis, degrees")
    ax.set_ylabel("accepted offsets, mm")
    ax.set_ylim(bottom=0)
    ax.set_title(title)
    ax.legend(title="speed", frameon=False)
    ax.spines[["top", "right"]].set_visible(False)
    return figure


def _draw_breaks(found: BreakStatistics, title: str) -> Figure:
    figure = Figure(figsize=CHART_INCHES, facecolor=colors.PAPER, layout="constrained")
    fell, what = figure.subplots(1, 2, width_ratios=(1, 1.4))
    counts = np.bincount(found.potted)
    fell.bar(range(len(counts)), 100 * counts / found.racks, color=colors.CLOTH)
    fell.set_xlabel("balls potted")
    fell.set_ylabel("breaks, %")
    chances = found.chances()
    names = list(chances)[::-1]
    middle = [100 * float(chances[name]) for name in names]
    errors = [
        [m - 100 * chances[name].low for m, name in zip(middle, names, strict=True)],
        [100 * chances[name].high - m for m, name in zip(middle, names, strict=True)],
    ]
    what.errorbar(middle, names, xerr=errors, fmt="o", markersize=3, color=colors.CLOTH)
    what.set_xlabel(f"%, with confidence intervals of {100 * found.level:g} %")
    what.set_xlim(left=0)
    what.tick_params(axis="y", labelsize=7)
    for ax in (fell, what):
        ax.set_facecolor(colors.PAPER)
        ax.spines[["top", "right"]].set_visible(False)
    figure.suptitle(title)
    return figure


def _scale(figure: Figure, ax: Axes, image: Any, label: str) -> Any:
    box = ax.get_position()
    wide = figure.get_figwidth()
    beside = figure.add_axes((box.x1 + 0.2 / wide, box.y0 + 0.1, 0.16 / wide, box.height - 0.2))
    bar = figure.colorbar(image, cax=beside)
    bar.set_label(label, color=colors.INK)
    return bar


def _struck(shot: Shot) -> str | None:
    struck: str | None = shot.to_dict().get("strike", {}).get("ball")
    return struck


def _balls(ax: Axes, shot: Shot, *, without: str | None = None, only: str | None = None) -> None:
    for index, ball in enumerate(shot.to_dict()["balls"]):
        if ball["id"] == without or only not in {None, ball["id"]}:
            continue
        x, y, *_ = ball["position"]
        radius = float(shot.radius[index])
        draw_ball(ax, (x, y), radius, colors.look(ball["id"], index))
