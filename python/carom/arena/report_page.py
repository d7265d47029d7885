"""The page of a report: one HTML file with its tables, and with the games for carom's page."""

from __future__ import annotations

import base64
import gzip
from collections.abc import Callable, Iterable
from html import escape
from urllib.parse import unquote

from carom import page
from carom.arena.report import RatingInterval, Report, ReportTable, Share
from carom.arena.report_match import ReportMatch
from carom.arena.sequential import rating
from carom.errors import PageError
from carom.html_report import cell, document, grid, minus, row_head, scrolling, text_cell

# What the reasons of ends are called in the table of lost frames.
_REASONS = {"won": "by the rules"}

_STYLE = """
.bar { display: block; width: 9rem; height: .6rem; margin-top: .15rem; }
.bar rect { fill: var(--line); } .bar line { stroke: var(--accent); stroke-width: 3; }
.bar circle { fill: var(--accent); }
dialog { width: 100vw; height: 100vh; max-width: none; max-height: none; margin: 0; padding: 0;
  border: 0; background: var(--ground); color: var(--ink); }
dialog[open] { display: flex; flex-direction: column; }
dialog p { display: flex; gap: 1rem; align-items: center; margin: 0; padding: .35rem .75rem; }
dialog iframe { flex: 1; width: 100%; border: 0; }
button { font: inherit; padding: .2rem .8rem; }
@media print { .bar { width: 4rem; } }
"""

# Opens `#game-MATCH-FRAME`: unpacks the page, puts the header and the line of the frame into it,
# and shows it in a frame of its own. "Back" of the browser and the button close it.
_SCRIPT = """
(() => {
  const dialog = document.querySelector("dialog");
  const texts = new Map();
  const text = (id) => {
    if (!texts.has(id)) {
      const packed = Uint8Array.from(atob(document.getElementById(id).textContent.trim()),
        (c) => c.charCodeAt(0));
      const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
      texts.set(id, new Response(stream).text());
    }
    return texts.get(id);
  };
  const close = () => {
    dialog.querySelector("iframe")?.remove();
    if (dialog.open) dialog.close();
  };
  const show = async () => {
    const [, match, frame] = /^#game-(\\d+)-(\\d+)$/.exec(location.hash) ?? [];
    close();
    if (match === undefined) return;
    const [page, record] = await Promise.all([text("page"), text(`match-${match}`)]);
    const lines = record.split("\\n");
    const line = lines.slice(1).find((one) => JSON.parse(one).frame === Number(frame));
    if (line === undefined) return;
    const json = `${lines[0]}\\n${line}\\n`.replaceAll("<", "\\\\u003c");
    const [before, after] = page.split(dialog.dataset.marker);
    const inner = document.createElement("iframe");
    inner.title = "carom";
    inner.setAttribute("sandbox", "allow-scripts allow-downloads");
    inner.allow = "fullscreen; clipboard-write";
    inner.srcdoc = before + dialog.dataset.marker + json + after;
    dialog.append(inner);
    dialog.showModal();
  };
  dialog.querySelector("button").addEventListener("click", () => { location.hash = ""; });
  dialog.addEventListener("cancel", (event) => { event.preventDefault(); location.hash = ""; });
  addEventListener("hashchange", () => void show());
  void show();
})();
"""


def report_html(report: Report, *, title: str, games: bool = True) -> str:
    """The page of a report. It needs neither a server nor a network.

    Args:
        report: The report.
        title: Its heading.
        games: Whether the page has the games, which takes some kilobytes a frame.
    """
    viewer = _viewer() if games else None
    body = [
        f"<h1>{escape(title)}</h1>",
        f'<p class="dim">{_summary(report)}</p>',
        *([] if report.is_rated else [_NOT_RATED]),
        *(part for n, table in enumerate(report.tables) for part in _table_parts(n, table)),
        *_games(report, linked=viewer is not None),
    ]
    after = [] if viewer is None else _viewer_parts(report, viewer)
    return document(title, body, style=_STYLE, after=after)


_NOT_RATED = (
    '<p class="dim">Ratings need statsmodels, which is not installed: '
    "<code>pip install 'carom[arena]'</code>.</p>"
)


def _viewer() -> str | None:
    """Carom's page; None if this installation does not have it."""
    try:
        return page.html()
    except PageError:
        return None


def _summary(report: Report) -> str:
    matches, frames = len(report.matches), sum(len(match.frames) for match in report.matches)
    state = "All matches have ended." if report.finished else "Some matches go on."
    shown = f"{matches} {'match' if matches == 1 else 'matches'}"
    return (
        f"{shown}, {frames} frames. {state} Intervals have {100 * report.level:g} % confidence and "
        "are computed from whole pairs."
    )


def _table_parts(number: int, table: ReportTable) -> Iterable[str]:
    of = f"condition-{number}"
    yield f'<h2 id="{of}">{escape(table.condition)}</h2>'
    yield _players(of, table)
    if table.breaker is not None:
        yield _ratings_note(table.breaker)
    if table.tests:
        yield _tests(of, table)
    if len(table.rows) > 2:
        yield _cross(of, table)
    yield _costs(of, table)
    yield _losses(of, table)


def _players(of: str, table: ReportTable) -> str:
    is_rated = table.breaker is not None
    is_adjusted = any(row.adjusted for row in table.rows)
    heads = ["player", "rating, Elo"] if is_rated else ["player"]
    heads += ["share of points", ""]
    if is_adjusted:
        heads.append("corrected for luck")
    heads += ["frames", "won", "drawn", "lost"]
    rows = []
    for row in table.rows:
        frames = row.won + row.drawn + row.lost
        cells = [row_head(row.name)]
        if is_rated:
            cells.append(_with_interval(row.rating, _signed))
        cells += [_with_interval(row.share, _percent), f"<td>{_bar(row.share)}</td>"]
        if is_adjusted:
            cells.append(_with_interval(row.adjusted, _percent))
        cells += map(cell, (frames, row.won, row.drawn, row.lost))
        rows.append("".join(cells))
    return grid(of, "Players, with intervals", heads, rows)


def _ratings_note(breaker: RatingInterval) -> str:
    elo, low, high = map(_signed, breaker)
    return (
        '<p class="dim">Ratings are Elo points above the mean of the table (Bradley &amp; Terry). '
        f"The player who begins a frame has an advantage of {elo} ({low} to {high}).</p>"
    )


def _with_interval(found: tuple[float, float, float] | None, shown: Callable[[float], str]) -> str:
    """A value and its interval in one cell."""
    if found is None:
        return cell("–")
    value, low, high = map(shown, found)
    return f"<td>{value} <small>{low.removesuffix(' %')} to {high.removesuffix(' %')}</small></td>"


def _tests(of: str, table: ReportTable) -> str:
    heads = ["player", "against", "pairs", "share of points", "normalised Elo", "hypotheses"]
    heads += ["log-likelihood ratio", "result"]
    rows = []
    for each in table.tests:
        test = each.test
        cells = [row_head(each.players[0]), text_cell(each.players[1]), cell(each.pairs)]
        cells += [cell(_percent(each.share)), cell(_signed(each.nelo))]
        cells += [text_cell(minus(test.hypotheses))]
        ends = minus(f"{test.lower:.2f} or {test.upper:.2f}")
        cells.append(f"<td>{minus(f'{test.llr:.2f}')} <small>ends at {ends}</small></td>")
        rows.append("".join([*cells, text_cell(minus(test.state))]))
    title = "Sequential tests. The share of a test that has ended is biased"
    return grid(of, title, heads, rows, texts=(1, 5, 7))


def _bar(share: Share | None) -> str:
    """A picture of a share and its interval; the numbers stand beside it."""
    if share is None:
        return ""
    low, value, high = (100 * min(max(end, 0.0), 1.0) for end in (share.low, share[0], share.high))
    return (
        '<svg class="bar" viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true">'
        '<rect x="0" y="4.5" width="100" height="1"/><rect x="49.5" y="0" width="1" height="10"/>'
        f'<line x1="{low:.1f}" x2="{high:.1f}" y1="5" y2="5"/>'
        f'<circle cx="{value:.1f}" cy="5" r="3"/></svg>'
    )


def _cross(of: str, table: ReportTable) -> str:
    names = [row.name for row in table.rows]
    rows = []
    for one in names:
        cells = [row_head(one)]
        for other in names:
            share = table.cross.get((one, other))
            cells.append(cell("" if share is None else _percent(share.value)))
        rows.append("".join(cells))
    title = "Share of the points of each player (row) against each other one"
    return grid(of, title, ["", *names], rows)


def _costs(of: str, table: ReportTable) -> str:
    heads = ["player", "answers", "simulated shots an answer", "seconds an answer", "refused"]
    rows = []
    for row in table.rows:
        costs = row.costs
        answers = max(costs.decisions, 1)
        seconds = f"{costs.seconds / answers:.3g}" if costs.seconds else "–"
        simulations = f"{costs.simulations / answers:.0f}" if costs.simulations else "–"
        rows.append(
            row_head(row.name)
            + "".join(map(cell, (costs.decisions, simulations, seconds, costs.refused)))
        )
    return grid(of, "Costs, and refused answers", heads, rows)


def _losses(of: str, table: ReportTable) -> str:
    reasons = sorted({reason for row in table.rows for reason in row.losses})
    if not reasons:
        return ""
    heads = ["player", *(_REASONS.get(reason, reason) for reason in reasons), "not counted"]
    rows = []
    for row in table.rows:
        counts = [*(row.losses[reason] for reason in reasons), row.void]
        rows.append(row_head(row.name) + "".join(cell(count or "") for count in counts))
    return grid(of, "Lost frames by the reason of their end", heads, rows)


def _games(report: Report, *, linked: bool) -> Iterable[str]:
    yield "<h2>Games</h2>"
    if linked:
        yield (
            '<p class="dim">A frame opens in carom’s page: every shot as it was intended and '
            "as it was executed, and the chances to win.</p>"
        )
    is_open = len(report.matches) == 1
    for number, match in enumerate(report.matches):
        yield _match(number, match, linked=linked, is_open=is_open)


def _match(number: int, match: ReportMatch, *, linked: bool, is_open: bool) -> str:
    heads = ["frame", "first", "second", "winner", "shots", "end"]
    rows = []
    for frame in match.frames:
        label = f"frame {frame.number + 1}"
        first = f'<a href="#game-{number}-{frame.number}">{label}</a>' if linked else label
        names = (*frame.players, frame.winner or "–")
        rows.append(
            f'<th scope="row">{first}</th>'
            + "".join(f'<td class="text">{escape(name)}</td>' for name in names)
            + cell(frame.shots)
            + f'<td class="text why">{escape(frame.why)}</td>'
        )
    one, other = match.players
    where = "" if match.folder == "." else f" · {unquote(match.folder)}"
    goes_on = "" if match.finished else ", goes on"
    title = f"{one} – {other}, {len(match.frames)} frames{goes_on}{where}"
    attribute = " open" if is_open else ""
    name = f"match-{number}-title"
    frames = scrolling(f'aria-labelledby="{name}"', heads, rows, texts=(1, 2, 3, 5))
    summary = f'<summary id="{name}">{escape(title)}</summary>'
    return f"<details{attribute}>{summary}{frames}</details>"


def _viewer_parts(report: Report, viewer: str) -> Iterable[str]:
    yield (
        f'<dialog aria-label="Game" data-marker="{escape(page.MARKER)}">'
        '<p><button type="button">Back to the report</button></p></dialog>'
    )
    yield _packed("page", viewer)
    for number, match in enumerate(report.matches):
        lines = [match.header, *(frame.line for frame in match.frames)]
        yield _packed(f"match-{number}", "\n".join(lines))
    yield f"<script>{_SCRIPT}</script>"


def _packed(name: str, text: str) -> str:
    """A text as an element without effect: gzip, in Base64. Its bytes depend on the text alone."""
    data = base64.b64encode(gzip.compress(text.encode(), mtime=0)).decode()
    return f'<script type="text/plain" id="{name}">{data}</script>'


def _percent(share: float) -> str:
    return minus(f"{100 * share:.1f} %")


def _signed(elo: float) -> str:
    return minus(rating(elo))
