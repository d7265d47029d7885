"""Published shares of breaks with their intervals, and ours."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.validation import plot
from carom.validation.breaks_on_video.rows import br_8, br_eight, br_nine
from carom.validation.row import Range

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    found = [c for row in (br_eight, br_8, br_nine) for c in row.compare()]
    for k, c in enumerate(found):
        assert isinstance(c.reference, Range)
        label = "published, 95 %" if k == 0 else None
        ax.plot([k, k], [c.reference.low, c.reference.high], "-", color=plot.COLORS[4],
                linewidth=7, alpha=0.6, label=label,
                solid_capstyle="butt")  # fmt: skip
    ax.plot(range(len(found)), [c.ours for c in found], "_", color=plot.COLORS[0], markersize=16,
            markeredgewidth=2, label="carom")  # fmt: skip
    names = (
        "8-ball, bar", "8-ball, showood", "the 8, bar", "the 8, showood", "9-ball, rail, legal",
        "9-ball, rail", "9-ball, box, legal", "9-ball, box",
    )  # fmt: skip
    ax.set_xticks(range(len(found)), names, rotation=40, ha="right", fontsize=7)
    ax.set_ylim(0.0, 110.0)
    plot.name(ax, "", "share of the breaks, %", "Breaks of professionals")
    return fig
