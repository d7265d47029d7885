"""Error and cost of the fixed-step simulator against Δt, and impossible shots by root finder."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from carom.validation import plot
from carom.validation.leckie_greenspan_2006.rows import (
    by_steps,
    end_error,
    event_operations,
    exact,
    impossible,
    integration_operations,
    shot,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEPS = (1.6e-2, 8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 1e-4)

APPROACHING = "at which they approach"
READING = {"carom": "first contact"}
LABELS = {
    "promised": "> 1e-12 m, or 1e-14 m at contacts",
    "micrometre": "> 1 µm",
    "millimetre": "> 1 mm",
}


def figure() -> Figure:
    fig, (left, middle, right) = plot.panels(3)
    steps = np.array(STEPS)
    left.loglog(steps, [end_error(dt) for dt in steps], "o-", color=plot.COLORS[1],
                markersize=4, label="final positions, m")  # fmt: skip
    left.loglog(steps, [end_error(dt, order=2) for dt in steps], "^-", color=plot.COLORS[3],
                markersize=4, label="the same, steps with ½aΔt²")  # fmt: skip
    first = exact().first("ball-collision").time
    late = [abs(by_steps(dt).contacts[0] - first) for dt in steps]
    left.loglog(steps, late, "s-", color=plot.COLORS[2], markersize=4, label="first collision, s")
    left.loglog(steps, 0.05 * steps / steps[0], ":", color="0.5", label="∝ Δt")
    left.axhline(1e-15, color=plot.COLORS[0], label="by events: rounding")
    plot.name(left, "Δt, s", "error", "One shot by steps: error")

    n = len(shot())
    by_step = [integration_operations(n, by_steps(dt).steps, n) for dt in steps]
    events = len(exact().events) * event_operations(n, n)
    middle.loglog(steps, by_step, "o-", color=plot.COLORS[1], markersize=4, label="by steps")
    middle.axhline(events, color=plot.COLORS[0], label=f"by events ({len(exact().events)} of them)")
    plot.name(middle, "Δt, s", "operations (section 3)", "One shot: operations")

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
    plot.name(
        right, "", "impossible shots of 100 000", "Random shots by root finder (commit 4430a05)"
    )
    return fig
