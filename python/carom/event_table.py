"""A trace as a table of events: plain for ``print``, coloured for a terminal.

Made to fit 80 columns; the exact numbers are in the trace.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import RenderableType

HEADINGS = ("", "time s", "event", "balls", "where", "speed m/s")
_RIGHT = {0, 1}


def rows(trace: dict[str, Any]) -> list[tuple[str, ...]]:
    """One row of text per event, under ``HEADINGS``."""
    return [
        (
            str(number),
            f"{event['time']:.4f}",
            event["type"],
            " ".join(event["balls"]),
            _where(event),
            _speeds(event),
        )
        for number, event in enumerate(trace["events"], start=1)
    ]


def _where(event: dict[str, Any]) -> str:
    match event["type"]:
        case "rail-collision":
            return f"{event['rail']} {event['part']}"
        case "pocket-collision":
            return str(event["pocket"])
        case "motion-transition":
            return f"{event['from']}→{event['to']}"
        case _:
            x, y, *_ = event["before"][0]["position"]
            return f"{x:.3f}, {y:.3f}"


def _speeds(event: dict[str, Any]) -> str:
    def speed(ball: dict[str, Any]) -> str:
        return f"{math.hypot(*ball['velocity']):.2f}"

    before = [speed(ball) for ball in event["before"]]
    after = [speed(ball) for ball in event["after"]]
    if before == after:
        return " ".join(after)
    return f"{' '.join(before)} → {' '.join(after)}"


def summary(trace: dict[str, Any]) -> list[str]:
    """The end of the shot in a few lines."""
    count = len(trace["events"])
    outcome = trace["outcome"]
    lines = [
        f"{count} event{'s' * (count != 1)} in {trace['duration']:.4f} s, hash {trace['hash']}"
    ]
    if outcome.get("first_contact") is not None:
        lines.append(f"first contact: {outcome['first_contact']}")
    pocketed = outcome.get("pocketed") or []
    if pocketed:
        lines.append(f"pocketed: {_in_pockets(pocketed)}")
    if off_table := outcome.get("off_table"):
        lines.append(f"off the table: {', '.join(off_table)}")
    if hanging := outcome.get("hanging"):
        lines.append(f"hanging: {_in_pockets(hanging)}")
    if jumped := outcome.get("jumped"):
        lines.append("jumped: " + ", ".join(f"{ball} over {other}" for ball, other in jumped))
    if outcome.get("cue_obstructed"):
        lines.append(f"the cue would pass through: {outcome['cue_obstructed']}{_remedy(outcome)}")
    return lines


def _in_pockets(pairs: list[tuple[str, str]]) -> str:
    return ", ".join(f"{ball} ({pocket})" for ball, pocket in pairs)


def _remedy(outcome: dict[str, Any]) -> str:
    least = outcome.get("least_elevation_deg")
    return "" if least is None else f"; at {math.ceil(10 * least) / 10:.1f}° it would not"


def plain(trace: dict[str, Any]) -> str:
    """The table as text, without colour, as wide as it needs."""
    body = rows(trace)
    widths = [max(len(row[i]) for row in [HEADINGS, *body]) for i in range(len(HEADINGS))]

    def line(row: tuple[str, ...]) -> str:
        cells = [
            cell.rjust(width) if i in _RIGHT else cell.ljust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        return "  ".join(cells).rstrip()

    return "\n".join([line(HEADINGS), *map(line, body), "", *summary(trace)])


_STYLES = {
    "cue-strike": "bold",
    "ball-collision": "yellow",
    "rail-collision": "cyan",
    "motion-transition": "dim",
    "pocket-collision": "bold green",
    "slate-collision": "magenta",
    "off-table": "bold red",
}


def rich_table(trace: dict[str, Any]) -> RenderableType:
    """The table for a terminal."""
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="bold")
    for index, heading in enumerate(HEADINGS):
        table.add_column(heading, justify="right" if index in _RIGHT else "left", no_wrap=index < 3)
    for row, event in zip(rows(trace), trace["events"], strict=True):
        # Text, not markup: a ball may be called "[red]".
        table.add_row(*(Text(cell) for cell in row), style=_STYLES.get(event["type"], ""))
    return Group(table, *(Text(line) for line in summary(trace)))
