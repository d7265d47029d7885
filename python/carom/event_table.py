"""A trace as a table of events: plain for ``print``, coloured for a terminal.

The table fits 80 columns, so its numbers are rounded.
"""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import columns
from carom.flights import Heights, highest, runs
from carom.lazy import LazyModule

if TYPE_CHECKING:
    import rich.console as rich_console
    import rich.table as tables
    import rich.text as rich_text
else:
    rich_console = LazyModule("rich.console")
    tables = LazyModule("rich.table")
    rich_text = LazyModule("rich.text")

HEADINGS = ("", "time s", "event", "balls", "where", "speed m/s")
_RIGHT = {0, 1}
# Lower hops, m, are not shown: they are invisible in play.
SEEN = 1e-3


def printable(text: str) -> str:
    """The text with control characters escaped; ids and file names may contain some."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def rows(trace: dict[str, Any]) -> list[tuple[str, ...]]:
    """Rows of text under ``HEADINGS``: one per event, or per run of hops over an edge."""
    return [row for _, row in _lines(trace)]


def _lines(trace: dict[str, Any]) -> list[tuple[str, tuple[str, ...]]]:
    """Each row with the type of its event."""
    events = trace["events"]
    flights = _flights(trace)
    rises: defaultdict[int, float] = defaultdict(float)
    for flight in flights:
        rises[flight.start] = max(rises[flight.start], flight.rise)
    landings = {flight.end for flight in flights if flight.seen}
    lines: list[tuple[str, tuple[str, ...]]] = []
    for run in runs(events):
        first, last = events[run[0]], events[run[-1]]
        if len(run) > 1:
            where = _over_edge(first, len(run))
        else:
            where = _where(first, aloft=run[0] in landings)
        rise = rises[run[-1]]
        if faults := _faults(first):
            where += f" {faults}"
        # Three coordinates include the height already.
        if rise >= SEEN and where.count(",") < 2:
            where += f" ↑ {1000 * rise:.0f} mm"
        row = (
            str(run[0] + 1),
            f"{first['time']:.4f}",
            first["type"],
            " ".join(map(printable, first["balls"])),
            where,
            _speeds(first["before"], last["after"]),
        )
        lines.append((first["type"], row))
    return lines


@dataclass(frozen=True, slots=True)
class _Flight:
    """A ball's flight between two of its events."""

    start: int
    end: int
    heights: Heights

    @property
    def rise(self) -> float:
        """Greatest height above the start, m."""
        return highest(self.heights) - self.heights[0]

    @property
    def seen(self) -> bool:
        """Whether the flight is high enough to be mentioned."""
        return highest(self.heights) - min(self.heights) >= SEEN


def _flights(trace: dict[str, Any]) -> list[_Flight]:
    flights = []
    aloft: dict[str, tuple[int, float, dict[str, Any]]] = {}
    for index, event in enumerate(trace["events"]):
        for ball, before, after in zip(
            event["balls"], event["before"], event["after"], strict=True
        ):
            if ball in aloft:
                start, since, state = aloft.pop(ball)
                z, v = state["position"][2], state["velocity"][2]
                control = z + 0.5 * v * (event["time"] - since)
                flights.append(_Flight(start, index, (z, control, before["position"][2])))
            if after["motion"] == "airborne":
                aloft[ball] = (index, event["time"], after)
    return flights


def _over_edge(event: dict[str, Any], count: int) -> str:
    if event["type"] == "slate-collision":
        return f"{count} hops on the lip"
    return f"{event['rail']} {event['part']}, {count} hops"


def _where(event: dict[str, Any], *, aloft: bool) -> str:
    match event["type"]:
        case "rail-collision":
            return f"{event['rail']} {event['part']}"
        case "pocket-collision":
            return str(event["pocket"])
        case "motion-transition":
            return f"{event['from']}→{event['to']}"
        case _:
            # The height is given only for balls in the air.
            coordinates = 3 if aloft and event["type"] != "slate-collision" else 2
            return ", ".join(f"{x:.3f}" for x in event["before"][0]["position"][:coordinates])


def _faults(event: dict[str, Any]) -> str:
    """What is unusual about a strike: a double hit, or a push; of both the double hit."""
    if event.get("tip_contacts", 1) > 1:
        return "double hit"
    return "push" if event.get("pushed") else ""


def _speeds(states_before: list[dict[str, Any]], states_after: list[dict[str, Any]]) -> str:
    def speed(ball: dict[str, Any]) -> str:
        return f"{math.hypot(*ball['velocity']):.2f}"

    before = [speed(ball) for ball in states_before]
    after = [speed(ball) for ball in states_after]
    if before == after:
        return " ".join(after)
    return f"{' '.join(before)} → {' '.join(after)}"


def summary(trace: dict[str, Any]) -> list[str]:
    """A summary of the shot in a few lines."""
    count = len(trace["events"])
    outcome = trace["outcome"]
    lines = [
        f"{count} event{'s' * (count != 1)} in {trace['duration']:.4f} s, hash {trace['hash']}"
    ]
    if (ended := trace.get("end")) in _CUT_OFF:
        moving = [ball["id"] for ball in trace["final"] if ball["motion"] not in _AT_REST]
        lines.append(f"{_CUT_OFF[ended]}; still moving: {', '.join(moving)}")
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
    return list(map(printable, lines))


# Ends at which balls may still move, in words.
_CUT_OFF = {"until": "ends at its end time", "cap": "stopped at its cap of events"}
_AT_REST = ("stationary", "pocketed", "off-table")


def _in_pockets(pairs: list[tuple[str, str]]) -> str:
    return ", ".join(f"{ball} ({pocket})" for ball, pocket in pairs)


def _remedy(outcome: dict[str, Any]) -> str:
    least = outcome.get("least_elevation_deg")
    return "" if least is None else f"; at {math.ceil(10 * least) / 10:.1f}° it would not"


def plain(trace: dict[str, Any]) -> str:
    """The table as text without colours."""
    table = columns.lines([HEADINGS, *rows(trace)], right_aligned=_RIGHT)
    return "\n".join([*table, "", *summary(trace)])


_STYLES = {
    "cue-strike": "bold",
    "ball-collision": "yellow",
    "rail-collision": "cyan",
    "motion-transition": "dim",
    "pocket-collision": "bold green",
    "slate-collision": "magenta",
    "off-table": "bold red",
}


def rich_table(trace: dict[str, Any]) -> rich_console.RenderableType:
    """The table for a terminal."""
    table = tables.Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="bold")
    for index, heading in enumerate(HEADINGS):
        table.add_column(heading, justify="right" if index in _RIGHT else "left", no_wrap=index < 3)
    for kind, row in _lines(trace):
        # Text, not markup, because a ball's id may be "[red]".
        table.add_row(*(rich_text.Text(cell) for cell in row), style=_STYLES.get(kind, ""))
    return rich_console.Group(table, *(rich_text.Text(line) for line in summary(trace)))
