"""An item of docs/realism.md: measured points, the engine's numbers at them, and a figure."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
from carom.validation import plot

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

JSON = dict[str, Any]
#: Physics as a shot file has it: the name of a preset, or an object with changes.
Physics = str | JSON

MEASURED: JSON = json.loads((resources.files("carom.validation") / "measured.json").read_text())


@dataclass(frozen=True)
class Point:
    """A measured number, how far the engine may be from it, and the engine's number.

    A measurement that is a range has the middle as its number and half its width as tolerance.
    """

    label: str
    measured: float
    tolerance: float
    ours: float

    @property
    def difference(self) -> float:
        """Ours − measured."""
        return self.ours - self.measured

    @property
    def agrees(self) -> bool:
        """Whether the difference is within the tolerance (never for NaN)."""
        # Numbers like 0.3 − 0.1 must not be outside 0.2 by rounding.
        return abs(self.difference) <= self.tolerance * (1.0 + 1e-9)


@dataclass(frozen=True)
class Item:
    """A subject with measured numbers."""

    name: str
    title: str
    unit: str
    #: Keys of the measured data.
    data: tuple[str, ...]
    #: The presets that belong to the table of the measurement, as the page lists them, and the
    #: numbers with a choice of physics.
    preset: str
    points: Callable[[Choice], list[Point]]
    #: Draws the item with the choice of physics `after`, and `before` unless it is None.
    figure: Callable[[Choice | None, Choice], Figure]


@dataclass(frozen=True)
class Choice:
    """Which physics to draw: for each preset that the items need, one that stands for it.

    `text` is "default" (each preset itself), a date such as "2026-11" (the dated preset of the same
    name, or of its game if the name is newer), the path of a JSON file with changes of each preset,
    or the name of one preset, which then stands for all.
    """

    text: str
    label: str

    def physics(self, preset: str) -> Physics:
        """The physics that stands for a preset."""
        if self.text == "default":
            return preset
        if re.fullmatch(r"\d{4}-\d{2}", self.text):
            known = {entry["dated_name"] for entry in carom.physics()}
            dated = f"{preset}-{self.text}"
            return dated if dated in known else f"{preset.split('-', 1)[0]}-{self.text}"
        if self.text.endswith(".json"):
            changes: JSON = json.loads(Path(self.text).read_text(encoding="utf-8"))
            return {"base": preset, **changes}
        return self.text


def lines(
    ax: Axes,
    x: Any,
    curve: Callable[[Physics], Any],
    preset: str,
    choices: tuple[Choice | None, Choice],
    label: str = "",
    color: int = 0,
) -> None:
    """Draws a curve with the present physics as a solid line, and dashed with the one before."""
    before, after = choices
    words = f"{label}, {after.label}" if label else after.label
    plot.ours(ax, x, curve(after.physics(preset)), words, color)
    if before is not None:
        ax.plot(
            x, curve(before.physics(preset)), "--", color=plot.COLORS[color], linewidth=1.6,
            label=f"{label}, {before.label}" if label else before.label,
        )  # fmt: skip


def rings(ax: Axes, x: Any, y: Any, tolerance: float, label: str, color: int = 6) -> None:
    """Draws measured numbers as rings with bars of their tolerance."""
    ax.errorbar(
        np.asarray(x), np.asarray(y), yerr=tolerance, fmt="none", ecolor=plot.COLORS[color],
        elinewidth=0.8, capsize=2,
    )  # fmt: skip
    plot.published(ax, x, y, label, color)
