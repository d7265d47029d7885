"""Draws the figure of docs/guide-camera.md into docs/images.

    python scripts/learned_table_figure.py

The table is learned from tracks/three_cushion_film.csv.gz, whose true numbers are those of
scripts/film_shots.py.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from carom import learn
from carom.learn.report_curves import Curve, coefficients, curves, rail_restitution
from carom.validation import plot
from film_shots import PATH as FILM
from film_shots import ROLLING_B, TRUTH
from matplotlib.axes import Axes

PATH = Path(__file__).resolve().parents[1] / "docs" / "images" / "learned_table.png"
#: Width of an interval of time, s.
STEP = 0.5


def main() -> int:
    """Learns the table and draws the figure."""
    tracks = learn.read_tracks(FILM)
    learned = learn.table(tracks, free=[*TRUTH])
    print(learned.summary(), file=sys.stderr)
    report = learn.fit_report(tracks, learned)
    found = curves(learned, report.shots)
    figure, (rolling, rails, errors) = plot.panels(3)
    curve = found["rolling"]
    true = TRUTH["rolling.a"] + ROLLING_B * curve.x
    draw_curve(rolling, curve, true, "deceleration, m/s²", "Rolling")
    curve = found["restitution"]
    preset = coefficients({"base": "carom"})
    true = rail_restitution(
        preset | {"cushion.restitution.a": TRUTH["cushion.restitution.a"]}, curve.x
    )
    draw_curve(rails, curve, true, "e", "Restitution of the rails")
    draw_errors(errors, np.concatenate([shot.errors() for shot in report.shots]))
    figure.savefig(PATH, dpi=plot.DPI, metadata={"Software": None})
    print(PATH, file=sys.stderr)
    return 0


def draw_curve(ax: Axes, curve: Curve, true: np.ndarray, y: str, title: str) -> None:
    """A learned curve beside the true one and that of the preset."""
    ax.fill_between(curve.x, curve.low, curve.high, color=plot.COLORS[0], alpha=0.25, linewidth=0)
    plot.ours(ax, curve.x, curve.learned, "learned, with its interval of 90 %")
    ax.plot(curve.x, true, "--", color="black", linewidth=1.0, label="true")
    ax.plot(curve.x, curve.preset, ":", color=plot.COLORS[1], label="preset carom")
    ax.set_ylim(bottom=0.0)
    plot.name(ax, "speed, m/s" if title == "Rolling" else "speed into the rail, m/s", y, title)


def draw_errors(ax: Axes, errors: np.ndarray) -> None:
    """Root mean square of model minus track against time."""
    step = (errors[:, 0] // STEP).astype(int)
    steps = [k for k in range(step.max() + 1) if (step == k).sum() >= 10]
    size = np.array([np.sqrt(np.mean(errors[step == k, 1:] ** 2, axis=0)) for k in steps])
    time = (np.array(steps) + 0.5) * STEP
    plot.ours(ax, time, 1000.0 * size[:, 0], "along the path")
    plot.ours(ax, time, 1000.0 * size[:, 1], "across the path", color=1)
    ax.set_ylim(bottom=0.0)
    plot.name(ax, "time since the strike, s", "mm", "Model minus track")


if __name__ == "__main__":
    sys.exit(main())
