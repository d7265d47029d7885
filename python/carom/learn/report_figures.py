"""The figures of a report: curves of the table, errors against time, the posterior, and shots."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn.posterior import UNKNOWN, LearnedNumbers
from carom.learn.report_chart import Chart, figure, number, polyline, span, svg
from carom.learn.report_curves import THROW_SPEED, Curve, curves
from carom.learn.report_data import FitReport, ShotFit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Most numbers of the corner plot, and width of one of its squares, px.
_MOST_CORNERS, _SQUARE = 6, 104
#: Room of the corner plot for its axes, px: left and below.
_CORNER_LEFT, _CORNER_BELOW = 92, 62
#: Radius of a normal ellipse that has 90 % of the draws, in standard deviations.
_ELLIPSE_90 = math.sqrt(-2.0 * math.log(0.1))
#: Width of an interval of time in the figure of errors, s, and the fewest samples in one.
_STEP, _FEWEST = 0.25, 10
#: Pixels for a metre of the table, and around it.
_SCALE, _MARGIN = 150.0, 12.0

STYLE = """
:root { --ball-0: #0b62c4; --ball-1: #a14a00; --ball-2: #0a6b42; --ball-3: #7a2fb0; }
@media (prefers-color-scheme: dark) { :root { --ball-0: #7ab7ff; --ball-1: #ffb066;
  --ball-2: #63d897; --ball-3: #d0a3ff; } }
.chart .ground { fill: var(--soft); stroke: var(--dim); }
.chart .hole { fill: var(--dim); opacity: .6; }
.chart .way { fill: none; stroke-width: 1.5; }
.chart .filmed { stroke-width: 4; opacity: .4; stroke-linejoin: round; }
.chart .away { stroke-dasharray: 4 3; }
.chart .b0 { stroke: var(--ball-0); } .chart .b1 { stroke: var(--ball-1); }
.chart .b2 { stroke: var(--ball-2); } .chart .b3 { stroke: var(--ball-3); }
.chart .rest { fill: var(--ground); stroke-width: 1.5; }
.chart .frame { fill: none; stroke: var(--line); } .chart .ring { fill: var(--accent);
  fill-opacity: .15; stroke: var(--accent); }
"""


def table_figures(report: FitReport) -> Iterable[str]:
    """e(V), μ(γ), rolling and throw, each with its interval."""
    found = curves(report.posterior, report.shots)
    learned = report.posterior.names
    yield _curve_figure(
        found["restitution"],
        Chart(
            "Restitution of the rails", "speed perpendicular to the rail, m/s", "e", (0, 4), (0, 1)
        ),
        "e(V) of the rails, the coefficient that the model of the cushion takes.",
        learned=any(name.startswith("cushion.restitution") for name in learned),
    )
    yield _curve_figure(
        _in_degrees(found["friction"], of_value=False),
        Chart("Friction of the rails", "angle of incidence, degrees", "μ", (0, 80), (0, 1)),
        "μ(γ) of the rails; 0° is straight into the rail.",
        learned=any(name.startswith("cushion.friction") for name in learned),
    )
    yield _curve_figure(
        found["rolling"],
        Chart("Rolling", "speed, m/s", "deceleration, m/s²", (0, 3), (0, 1)),
        "Deceleration of a rolling ball.",
        learned=any(name.startswith("rolling") for name in learned),
    )
    yield _curve_figure(
        _in_degrees(found["throw"], of_value=True),
        Chart("Throw", "cut angle, degrees", "throw, degrees", (0, 80), (0, 1)),
        f"Throw of the object ball by a ball that slides without spin at {THROW_SPEED:g} m/s.",
        learned=any(name.startswith("ball_ball") for name in learned),
    )


def _curve_figure(curve: Curve, chart: Chart, caption: str, *, learned: bool) -> str:
    rows = (curve.learned, curve.low, curve.high, curve.preset)
    chart.y = span(*rows, floor=0.0 if np.min(rows) >= 0.0 else None)
    chart.band(curve.x, curve.low, curve.high)
    chart.seen(curve.seen)
    chart.curve(curve.x, curve.preset, "second", "at the start of the fit")
    chart.curve(curve.x, curve.learned, "", "learned, with its interval of 90 %")
    marks = "Marks at the foot: where these shots have data."
    kept = "" if learned else "These numbers were not learned. "
    return figure(chart.svg(), f"{caption} {kept}{marks}")


def _in_degrees(curve: Curve, *, of_value: bool) -> Curve:
    """The curve over degrees; ``of_value``: the values are angles, too."""
    unit = 180.0 / math.pi if of_value else 1.0
    learned, low, high, preset = (
        unit * row for row in (curve.learned, curve.low, curve.high, curve.preset)
    )
    return Curve(np.degrees(curve.x), learned, low, high, preset, np.degrees(curve.seen))


def error_figures(shots: Sequence[ShotFit]) -> Iterable[str]:
    """Error against time: its size, and its part along the way with the sign."""
    found = [shot.errors() for shot in shots]
    errors = np.concatenate(found) if found else np.empty((0, 3))
    rows = []
    for bin_of in range(int(errors[:, 0].max(initial=0.0) / _STEP) + 1):
        own = errors[(errors[:, 0] // _STEP).astype(int) == bin_of, 1:]
        if len(own) >= _FEWEST:
            low, middle, high = np.percentile(own[:, 0], (25, 50, 75))
            rows.append(
                ((bin_of + 0.5) * _STEP, *np.sqrt(np.mean(own**2, axis=0)), low, middle, high)
            )
    if len(rows) < 2:
        yield '<p class="dim">There are too few samples of moving balls.</p>'
        return
    time, along, across, low, middle, high = np.array(rows).T
    axis = (0.0, float(time[-1] + _STEP / 2))
    label = "time since the strike, s"
    size = Chart("Size of the error against time", label, "cm", axis, (0, 1))
    size.y = span(100 * along, 100 * across, floor=0.0)
    size.curve(time, 100 * along, "", "along the path")
    size.curve(time, 100 * across, "second", "across the path")
    yield figure(
        size.svg(),
        "Root mean square of model minus track of the moving balls, while the model is within "
        "8 cm of the track.",
    )
    lead = Chart("Error along the path against time", label, "cm ahead", axis, (0, 1))
    lead.y = span(100 * low, 100 * high, (0.0,))
    lead.band(time, 100 * low, 100 * high)
    lead.curve(axis, (0.0, 0.0), "third", "no error")
    lead.curve(time, 100 * middle, "", "median, with the quartiles")
    yield figure(lead.svg(), "Error along the path: above 0 the model is ahead of the ball.")


def told(posterior: LearnedNumbers) -> list[int]:
    """Indices of the numbers of the corner plot: those that the tracks tell best."""
    share = posterior.share_of_prior
    known = [k for k in np.argsort(share, kind="stable").tolist() if share[k] <= UNKNOWN]
    return sorted(known[:_MOST_CORNERS])


def corner_figure(posterior: LearnedNumbers) -> str:
    """The joint posterior of two numbers each, and of each number alone; empty if it has one."""
    chosen = told(posterior)
    if len(chosen) < 2:
        return ""
    names = [posterior.names[k] for k in chosen]
    sigma = posterior.sigma[chosen]
    correlation = posterior.covariance[np.ix_(chosen, chosen)] / np.outer(sigma, sigma)
    count = len(chosen)
    parts = []
    for row in range(count):
        for column in range(row + 1):
            x, y = _CORNER_LEFT + column * _SQUARE, row * _SQUARE + 4
            own = _density() if row == column else _ellipse(float(correlation[row, column]))
            size = _SQUARE - 6
            parts.append(
                f'<g transform="translate({x} {y})"><rect class="frame" width="{size}" '
                f'height="{size}"/>{own}</g>'
            )
        parts += _corner_labels(row, count, names[row], *posterior.interval(names[row]))
    width, height = _CORNER_LEFT + count * _SQUARE, count * _SQUARE + _CORNER_BELOW
    title = "Joint posterior of " + ", ".join(names)
    caption = (
        "The numbers that these shots tell best. Each square is four standard deviations wide on "
        "both sides of the mean. An ellipse has 90 % of the draws; a thin, slanted one is "
        "of two numbers that trade off."
    )
    return figure(svg(title, width, height, parts), caption)


def _corner_labels(row: int, count: int, name: str, low: float, high: float) -> list[str]:
    """The name of a number left of its row and below its column, with its interval of 90 %."""
    interval = f"{number(low)} … {number(high)}"
    first, _, last = name.rpartition(".")
    y = row * _SQUARE + _SQUARE / 2
    middle = _CORNER_LEFT + row * _SQUARE + (_SQUARE - 6) / 2
    below = count * _SQUARE + 14
    lines = [*([first] if first else []), last]
    left = [
        f'<text x="{_CORNER_LEFT - 8}" y="{y + 14 * k:.1f}" text-anchor="end" '
        f'textLength="{min(80, 6.2 * len(line)):.0f}" lengthAdjust="spacingAndGlyphs">'
        f"{escape(line)}</text>"
        for k, line in enumerate(lines)
    ]
    under = [
        f'<text x="{middle:.1f}" y="{below + 14 * k}" text-anchor="middle" '
        f'textLength="{min(94, 6.2 * len(line)):.0f}" lengthAdjust="spacingAndGlyphs">'
        f"{escape(line)}</text>"
        for k, line in enumerate([*lines, interval])
    ]
    return left + under


def _density() -> str:
    """The density of a normal distribution over four standard deviations on both sides."""
    size = _SQUARE - 6
    z = np.linspace(-4.0, 4.0, 65)
    x, y = (z + 4.0) / 8.0 * size, size - 0.85 * size * np.exp(-z * z / 2.0)
    return f'<path class="curve" d="{polyline(list(zip(x.tolist(), y.tolist(), strict=True)))}"/>'


def _ellipse(correlation: float) -> str:
    """The ellipse of 90 % of two standard normal numbers."""
    size = _SQUARE - 6
    angle = np.linspace(0.0, 2.0 * np.pi, 73)
    one = _ELLIPSE_90 * np.cos(angle)
    other = _ELLIPSE_90 * np.sin(angle)
    other = correlation * one + math.sqrt(max(0.0, 1.0 - correlation**2)) * other
    x, y = (one + 4.0) / 8.0 * size, size - (other + 4.0) / 8.0 * size
    return f'<path class="ring" d="{polyline(list(zip(x.tolist(), y.tolist(), strict=True)))}Z"/>'


def shot_figure(shot: ShotFit) -> str:
    """Track and simulation of a shot on its table, x to the right along the length."""
    geometry = shot.strike.shot.geometry()
    width, length = geometry["size"]
    parts = [
        f'<rect class="ground" x="{_MARGIN}" y="{_MARGIN}" width="{_SCALE * length:.1f}" '
        f'height="{_SCALE * width:.1f}"/>'
    ]
    for pocket in geometry["pockets"]:
        (x, y), radius = pocket["center"][:2], pocket["radius"]
        cx, cy = _place(x, y)
        parts.append(
            f'<circle class="hole" cx="{cx:.1f}" cy="{cy:.1f}" r="{_SCALE * radius:.1f}"/>'
        )
    radius = _SCALE * float(shot.strike.shot.radius[0])
    for index, ball in enumerate(shot.strike.shot.ids):
        colour = f"b{index % 4}"
        if ball in shot.track:
            track = [_place(*place) for place in shot.track[ball].tolist()]
            parts.append(f'<path class="way filmed {colour}" d="{polyline(track)}"/>')
        way = shot.trace.polyline(ball, 1e-3)
        way = way[way[:, 3] <= shot.time[-1]]
        on, off = way[way[:, 3] <= shot.end], way[way[:, 3] >= shot.end]
        for part, kind in ((on, ""), (off, "away")):
            points = [_place(x, y) for x, y in part[:, :2].tolist()]
            parts.append(f'<path class="way {kind} {colour}" d="{polyline(points)}"/>')
        x, y = _place(*way[0, :2].tolist())
        parts.append(f'<circle class="rest {colour}" cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}"/>')
    picture = svg(
        f"Shot {shot.name}: track and simulation",
        _SCALE * length + 2 * _MARGIN,
        _SCALE * width + 2 * _MARGIN,
        parts,
    )
    left = (
        "the model stays on the track"
        if shot.left_at is None
        else f"the model leaves the track after {shot.left_at:.1f} s, from where it is dashed"
    )
    return figure(picture, f"Shot {shot.name}: {100 * shot.strike.rmse:.1f} cm; {left}.")


def _place(x: float, y: float) -> tuple[float, float]:
    """A place of the table in a drawing whose long side lies across: y to the right, x down."""
    return _MARGIN + _SCALE * y, _MARGIN + _SCALE * x
