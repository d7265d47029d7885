"""The style of the figures: carom's numbers are lines, published numbers are rings."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from carom.picture._matplotlib import prepare

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    #: One number per point; figures have no ranges.
    Numbers = list[Any] | tuple[Any, ...] | NDArray[Any]

#: Colours that differ for every kind of colour vision (Okabe & Ito 2008).
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
#: Size of one panel, inches, and dots per inch of the stored figure.
PANEL, DPI = (4.6, 3.5), 110


def panels(count: int = 1) -> tuple[Figure, list[Axes]]:
    """A figure with `count` panels side by side."""
    prepare()
    from matplotlib.figure import Figure

    figure = Figure(figsize=(PANEL[0] * count, PANEL[1]), layout="constrained")
    axes = figure.subplots(1, count, squeeze=False)[0]
    for ax in axes:
        ax.grid(visible=True, color="0.9", linewidth=0.6)
        ax.set_axisbelow(True)
        ax.spines[["top", "right"]].set_visible(False)
    return figure, list(axes)


def ours(ax: Axes, x: Numbers, y: Numbers, label: str = "", color: int = 0) -> None:
    """Draws carom's numbers as a line."""
    ax.plot(x, y, "-", color=COLORS[color % len(COLORS)], linewidth=1.6, label=label or "carom")


def published(ax: Axes, x: Numbers, y: Numbers, label: str = "", color: int = 0) -> None:
    """Draws published numbers as rings."""
    ax.plot(
        x, y, "o", color=COLORS[color % len(COLORS)], markerfacecolor="white",
        markersize=5.5, markeredgewidth=1.3, label=label,
    )  # fmt: skip


def name(ax: Axes, x: str, y: str, title: str = "") -> None:
    """Labels the axes, and shows the legend if anything has a label."""
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if title:
        ax.set_title(title, fontsize=10)
    if ax.get_legend_handles_labels()[1]:
        ax.legend(fontsize=8, frameon=False)


def draw(paper: str, path: Path) -> None:
    """Draws the figure of one paper into `path`, whose suffix gives the format."""
    prepare()
    from carom.picture.style import own_style

    with own_style():
        figure: Any = importlib.import_module(f"carom.validation.{paper}.figure").figure()
        metadata = {"Software": None} if path.suffix == ".png" else None
        figure.savefig(path, dpi=DPI, metadata=metadata)
