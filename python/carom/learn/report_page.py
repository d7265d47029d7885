"""The page of a learned table: its numbers, what is not known, figures, and every shot."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from html import escape

from carom.files import write_whole
from carom.html_report import cell, document, grid, minus, row_head, text_cell
from carom.lazy import np
from carom.learn import report_chart, report_figures
from carom.learn.posterior import UNKNOWN, LearnedNumbers
from carom.learn.report_data import FitReport, ShotFit
from carom.learn.strike_search import APART

#: Number of shots that are drawn: those with the largest errors.
WORST = 6

_STYLE = """
.sentences { padding-inline-start: 1.2rem; } .note { max-width: 44rem; }
td.bad { color: var(--ball-1); font-weight: 600; }
@media print { .charts { grid-template-columns: 1fr 1fr; } figure { break-inside: avoid; } }
"""


def report_html(report: FitReport, *, title: str) -> str:
    """The page of a learned table. It needs neither a server nor a network.

    Args:
        report: The table and its shots.
        title: Its heading.
    """
    shots = report.shots
    body = [
        f"<h1>{escape(title)}</h1>",
        f'<p class="dim">{_summary(report)}</p>',
        '<h2 id="numbers">What was learned</h2>',
        _numbers(report.posterior),
        '<h2 id="unknown">What these shots do not tell</h2>',
        _unknown(report.posterior),
        *_models(report),
        '<h2 id="curves">Curves of the table</h2>',
        f'<div class="charts">{"".join(report_figures.table_figures(report))}</div>',
        *_corner(report.posterior),
        '<h2 id="errors">Error against time</h2>',
        f'<div class="charts">{"".join(report_figures.error_figures(shots))}</div>',
        *_worst(shots),
        '<h2 id="shots">Shots</h2>',
        _shots(report),
    ]
    style = report_chart.STYLE + report_figures.STYLE + _STYLE
    return document(title, body, style=style)


def write_report(report: FitReport, path: str | os.PathLike[str], *, title: str) -> None:
    """Write the page of a learned table.

    Raises:
        OSError: The file cannot be written.
    """
    write_whole(path, report_html(report, title=title))


def _summary(report: FitReport) -> str:
    shots = report.shots
    used = report.posterior.shots
    if not shots:
        return f"Learned from {used} shots. No strike was found."
    errors = [shot.strike.rmse for shot in shots]
    early = [shot.strike.rmse_3s for shot in shots]
    whole = sum(shot.left_at is None for shot in shots)
    count = len(shots) + len(report.missing)
    return (
        f"Learned from {used} of {count} shots. The median root mean square distance of model and "
        f"track is {100 * np.median(errors):.1f} cm over the whole time of a shot and "
        f"{100 * np.median(early):.1f} cm in its first 3 s; in {whole} of {len(shots)} shots the "
        f"model stays within {100 * APART:g} cm of the track. These are the shots from which the "
        "table was learned: on others the errors are larger. Intervals have 90 % probability."
    )


def _numbers(posterior: LearnedNumbers) -> str:
    heads = ["number", "learned", "interval of 90 %", "at the start", "unit", "what it is", ""]
    share = posterior.share_of_prior
    rows = []
    for index, parameter in enumerate(posterior.model.free):
        low, high = posterior.interval(parameter.name)
        value, start = float(posterior.mean[index]), float(posterior.model.start[index])
        digits = _digits(high - low)
        shown = [minus(f"{number:.{digits}f}") for number in (value, low, high)]
        verdict = "" if low <= start <= high else "differs from the start"
        if share[index] > UNKNOWN:
            verdict = "not told by these shots"
        rows.append(
            row_head(parameter.name)
            + cell(shown[0])
            + cell(f"{shown[1]} to {shown[2]}")
            + cell(minus(f"{start:.{digits}f}"))
            + text_cell(parameter.unit)
            + text_cell(parameter.about)
            + text_cell(verdict)
        )
    title = "Numbers, beside those from which the fit began"
    return grid("numbers", title, heads, rows, texts=(4, 5, 6))


def _digits(width: float) -> int:
    """Digits after the point that show an interval of this width with two figures."""
    return int(np.clip(1 - np.floor(np.log10(width)), 0, 8)) if width > 0.0 else 5


def _unknown(posterior: LearnedNumbers) -> str:
    sentences = posterior.unknown()
    if not sentences:
        return "<p>These shots determine every number, and no two numbers trade off.</p>"
    items = "".join(f"<li>{escape(minus(sentence))}</li>" for sentence in sentences)
    return f'<ul class="sentences note">{items}</ul>'


def _models(report: FitReport) -> Iterable[str]:
    if not report.models:
        return
    yield '<h2 id="models">Models compared</h2>'
    best = max(report.models, key=lambda model: model.score)
    rows = [
        row_head(model.model)
        + cell(minus(f"{model.score:.3f}"))
        + cell(minus(f"{model.score - best.score:.3f}"))
        + cell(f"{model.standard_error:.3f}")
        for model in sorted(report.models, key=lambda model: -model.score)
    ]
    heads = ["model", "log score", "less than the best", "± standard error"]
    yield grid(
        "models", "Mean log density of held-out coordinates, nats; higher is better", heads, rows
    )


def _corner(posterior: LearnedNumbers) -> Iterable[str]:
    if picture := report_figures.corner_figure(posterior):
        yield '<h2 id="posterior">How the numbers depend on each other</h2>'
        yield picture


def _worst(shots: Sequence[ShotFit]) -> Iterable[str]:
    worst = sorted(shots, key=lambda shot: -shot.strike.rmse)[:WORST]
    if not worst:
        return
    yield '<h2 id="worst">The shots with the largest errors</h2>'
    yield (
        '<p class="dim note">Broad lines are the tracks, thin ones the simulation; rings are the '
        "balls before the strike. The long side of the table lies across.</p>"
    )
    yield f'<div class="charts">{"".join(map(report_figures.shot_figure, worst))}</div>'


def _shots(report: FitReport) -> str:
    heads = ["shot", "struck", "error, cm", "first 3 s, cm", "leaves the track, s", "filmed, s"]
    heads += ["contacts", "quality", "why"]
    rows = []
    for shot in report.shots:
        quality = shot.quality
        left = "–" if shot.left_at is None else f"{shot.left_at:.1f}"
        grade = ' class="text bad"' if quality.grade == "bad" else ' class="text"'
        rows.append(
            row_head(shot.name)
            + text_cell(quality.struck or "–")
            + cell(f"{100 * shot.strike.rmse:.1f}")
            + cell(f"{100 * shot.strike.rmse_3s:.1f}")
            + cell(left)
            + cell(f"{quality.duration:.1f}")
            + cell(quality.contacts)
            + f"<td{grade}>{escape(quality.grade)}</td>"
            + f'<td class="text why">{escape("; ".join(quality.reasons))}</td>'
        )
    gone = "<td></td>" * 7 + '<td class="text why">no strike explains it</td>'
    rows += [row_head(name) + gone for name in report.missing]
    title = "Every filmed shot beside its simulation"
    return grid("shots", title, heads, rows, texts=(1, 7, 8))
