"""Error and cost of the fixed-step simulator against Δt, and impossible shots by root finder."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.leckie_greenspan_2006.rows import (
    event_operations,
    impossible,
    integration_operations,
    stepped,
    stored,
)
from carom.validation.leckie_greenspan_2006.tables import quantile

if TYPE_CHECKING:
    from carom.validation.lab import JSON
    from matplotlib.figure import Figure

#: The forms of the step by their names in the stored result.
FORMS = {"v dt": "v Δt", "v dt + a dt^2 / 2": "v Δt + ½aΔt²"}

APPROACHING = "at which they approach"
READING = {"carom": "first contact"}
LABELS = {
    "promised": "> 1e-12 m, or 1e-14 m at contacts",
    "micrometre": "> 1 µm",
    "millimetre": "> 1 mm",
}


def figure() -> Figure:
    fig, (left, middle, right) = plot.panels(3)
    result = stored("fixed_step.json")
    steps = np.array(result["steps"])
    for (form, label), color in zip(FORMS.items(), (1, 3), strict=True):
        for share, style in ((0.5, "o-"), (0.9, "o:")):
            errors = [quantile(stepped(form, dt), share) for dt in steps]
            left.loglog(steps, errors, style, color=plot.COLORS[color], markersize=4,
                        label=f"{label}, {'median' if share == 0.5 else '90 %'}")  # fmt: skip
    left.axhline(1e-15, color=plot.COLORS[0], label="by events: rounding")
    plot.name(left, "Δt, s", "error of the ends, m", f"{len(result['shots'])} shots by steps")

    def operations(shot: JSON, k: int) -> int:
        n = shot["balls"]
        return integration_operations(n, shot["by_steps"]["v dt"][k]["steps"], n)

    shots = result["shots"]
    by_step = [np.mean([operations(s, k) for s in shots]) for k in range(len(steps))]
    events = np.mean([s["events"] * event_operations(s["balls"], s["balls"]) for s in shots])
    middle.loglog(steps, by_step, "o-", color=plot.COLORS[1], markersize=4, label="by steps")
    middle.axhline(events, color=plot.COLORS[0], label="by events")
    plot.name(middle, "Δt, s", "operations (section 3)", "Mean operations of a shot")

    methods = ("textbook closed form", "companion matrix", "Algorithm 1010", "carom")
    for k, limit in enumerate(("promised", "micrometre", "millimetre")):
        counts = [impossible(m, READING.get(m, APPROACHING))[limit] for m in methods]
        bars = right.bar(
            np.arange(4) + 0.27 * (k - 1), counts, 0.25, color=plot.COLORS[k], label=LABELS[limit]
        )
        right.bar_label(bars, fontsize=6)
    right.set_yscale("symlog", linthresh=1)
    right.set_ylim(0, 1e6)
    right.set_xticks(range(4), [m.replace(" ", "\n", 1) for m in methods], fontsize=7)
    plot.name(right, "", "impossible shots of 100 000", "Random shots by root finder")
    return fig
