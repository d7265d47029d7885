"""Final slip against initial slip."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.stronge.rows import RATIOS, cu_11, final_slip

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def figure() -> Figure:
    fig, (ax,) = plot.panels()
    ratios = np.linspace(0.0, 2.0, 120)
    plot.ours(ax, ratios, [final_slip(r) for r in ratios])
    plot.published(ax, RATIOS, list(cu_11.reference.values()), "springs integrated")
    ax.axhline(0.0, color="0.6", linewidth=0.8)
    plot.name(ax, "slip before, v_n (in the negative sense)", "slip after, v_n",
              "Stick, slip–stick–slip, gross slip")  # fmt: skip
    return fig
