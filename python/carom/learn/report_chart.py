"""Charts of a report as inline SVG, in the colours of the page."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from typing import TYPE_CHECKING

from carom.html_report import minus
from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]

WIDTH, HEIGHT = 440, 290
#: Room for the axes, px: left, right, top, bottom.
_LEFT, _RIGHT, _TOP, _BOTTOM = 56, 12, 14, 46
#: About the number of ticks of an axis.
_TICKS = 5

STYLE = """
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(22rem, 100%), 1fr));
  gap: 1rem 1.5rem; }
figure { margin: 0; } figcaption { color: var(--dim); font-size: .875rem; }
.chart { display: block; width: 100%; height: auto; max-width: 40rem; }
.chart text { fill: var(--ink); font: 12px system-ui, sans-serif; }
.chart .axis { stroke: var(--dim); fill: none; } .chart .tick { stroke: var(--line); }
.chart .band { fill: var(--accent); opacity: .2; } .chart .seen { stroke: var(--dim); opacity: .5; }
.chart .curve { fill: none; stroke: var(--accent); stroke-width: 2; }
.chart .second { stroke: var(--ink); stroke-dasharray: 6 4; stroke-width: 1.6; }
.chart .third { stroke: var(--dim); stroke-dasharray: 1.5 3.5; stroke-linecap: round; }
"""


def ticks(low: float, high: float, count: int = _TICKS) -> list[float]:
    """Round numbers from ``low`` to ``high``: steps of 1, 2 or 5 times a power of ten."""
    if not high > low:
        return [low]
    raw = (high - low) / count
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(s * power for s in (1.0, 2.0, 5.0, 10.0) if s * power >= raw * (1.0 - 1e-9))
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def number(value: float) -> str:
    """A number of an axis."""
    return minus(f"{value:.10g}" if abs(value) < 1e-12 else f"{value:.4g}")


@dataclass(slots=True)
class Chart:
    """Curves and bands over one axis.

    Attributes:
        name: What it shows, for readers who do not see it.
        x_label: The axis and its unit.
        y_label: The same.
        x: Ends of the axis.
        y: The same; values outside are cut off.
    """

    name: str
    x_label: str
    y_label: str
    x: tuple[float, float]
    y: tuple[float, float]
    _parts: list[str] = field(default_factory=list)
    _legend: list[tuple[str, str]] = field(default_factory=list)

    def curve(self, x: ArrayLike, y: ArrayLike, kind: str, label: str) -> None:
        """Adds a line; ``kind`` is a class of the style, such as ``second``."""
        self._parts.append(f'<path class="curve {kind}" d="{self._way(x, y)}"/>')
        self._legend.append((kind, label))

    def band(self, x: Floats, low: Floats, high: Floats) -> None:
        """Adds an area between two lines."""
        around = np.concatenate((x, x[::-1])), np.concatenate((low, high[::-1]))
        self._parts.append(f'<path class="band" d="{self._way(*around)}Z"/>')

    def seen(self, values: Floats) -> None:
        """Adds marks at the foot of the chart, where there are data; at most one a pixel."""
        places = sorted({round(self._at_x(value)) for value in values.tolist()})
        foot = HEIGHT - _BOTTOM
        way = "".join(f"M{place} {foot}v-7" for place in places)
        if way:
            self._parts.append(f'<path class="seen" d="{way}"/>')

    def svg(self) -> str:
        """The chart."""
        clip = "clip-" + re.sub("[^a-z]+", "-", self.name.lower())
        return svg(
            self.name,
            WIDTH,
            HEIGHT,
            [
                f'<clipPath id="{clip}"><rect x="{_LEFT}" y="{_TOP}" '
                f'width="{WIDTH - _LEFT - _RIGHT}" height="{HEIGHT - _TOP - _BOTTOM}"/></clipPath>',
                *self._axes(),
                f'<g clip-path="url(#{clip})">{"".join(self._parts)}</g>',
                *self._keys(),
            ],
        )

    def _axes(self) -> list[str]:
        foot, end = HEIGHT - _BOTTOM, WIDTH - _RIGHT
        parts = []
        for value in ticks(*self.x):
            x = self._at_x(value)
            parts.append(f'<path class="tick" d="M{x:.1f} {_TOP}V{foot}"/>')
            label = number(value)
            parts.append(f'<text x="{x:.1f}" y="{foot + 16}" text-anchor="middle">{label}</text>')
        for value in ticks(*self.y):
            y = self._at_y(value)
            parts.append(f'<path class="tick" d="M{_LEFT} {y:.1f}H{end}"/>')
            label = number(value)
            parts.append(f'<text x="{_LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
        middle = (_LEFT + end) / 2
        return [
            *parts,
            f'<path class="axis" d="M{_LEFT} {_TOP}V{foot}H{end}"/>',
            f'<text x="{middle}" y="{HEIGHT - 10}" text-anchor="middle">'
            f"{escape(self.x_label)}</text>",
            f'<text transform="translate(14 {(_TOP + foot) / 2}) rotate(-90)" '
            f'text-anchor="middle">{escape(self.y_label)}</text>',
        ]

    def _keys(self) -> list[str]:
        """The legend, at the top right."""
        parts = []
        for row, (kind, label) in enumerate(self._legend):
            y = _TOP + 12 + 16 * row
            x = WIDTH - _RIGHT - 8
            parts.append(f'<path class="curve {kind}" d="M{x - 26} {y - 4}h26"/>')
            parts.append(f'<text x="{x - 32}" y="{y}" text-anchor="end">{escape(label)}</text>')
        return parts

    def _way(self, x: ArrayLike, y: ArrayLike) -> str:
        xs, ys = np.asarray(x, dtype=float).tolist(), np.asarray(y, dtype=float).tolist()
        points = zip(xs, ys, strict=True)
        return polyline([(self._at_x(a), self._at_y(b)) for a, b in points])

    def _at_x(self, value: float) -> float:
        low, high = self.x
        return _LEFT + (value - low) / (high - low) * (WIDTH - _LEFT - _RIGHT)

    def _at_y(self, value: float) -> float:
        low, high = self.y
        share = min(max((value - low) / (high - low), -1.0), 2.0)
        return HEIGHT - _BOTTOM - share * (HEIGHT - _TOP - _BOTTOM)


def svg(name: str, width: float, height: float, parts: Sequence[str]) -> str:
    """A picture that fills the width of its place."""
    return (
        f'<svg class="chart" viewBox="0 0 {width:g} {height:g}" role="img" '
        f'aria-label="{escape(name)}">{"".join(parts)}</svg>'
    )


def figure(picture: str, caption: str) -> str:
    """A picture with a sentence below it."""
    return f"<figure>{picture}<figcaption>{escape(caption)}</figcaption></figure>"


def polyline(points: Sequence[tuple[float, float]]) -> str:
    """Data of an SVG path; a point that is not a number interrupts it."""
    parts, begins = [], True
    for x, y in points:
        if not (math.isfinite(x) and math.isfinite(y)):
            begins = True
            continue
        parts.append(f"{'M' if begins else 'L'}{x:.1f} {y:.1f}")
        begins = False
    return "".join(parts)


def span(*rows: ArrayLike, floor: float | None = None) -> tuple[float, float]:
    """The ends of an axis that shows all values, with room for the legend."""
    values = np.concatenate([np.ravel(np.asarray(row, dtype=float)) for row in rows])
    values = values[np.isfinite(values)]
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 1.0)
    low = low if floor is None else min(floor, low)
    size = (high - low) or abs(high) or 1.0
    return (low - 0.06 * size if floor is None else low), high + 0.2 * size
