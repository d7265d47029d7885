"""The tables of the documentation that are made from stored results.

    python benches/tables.py                 # print them
    python benches/tables.py --write         # write them into the pages
    python benches/tables.py --write 2026-11-28-f56307ea.json    # with another run of `carom bench`

In a page a table is below a comment `<!-- table: NAME FILE -->`, where FILE is the stored result in
``benches/results`` or in the folder of the paper's experiments. A test compares the pages with the
tables.
"""

from __future__ import annotations

import argparse
import json
import re
import statistics
from collections.abc import Callable
from pathlib import Path
from typing import Any

import ladder
import strategy
from carom.bench.states import CLASSES
from carom.plan.chance import Chance
from carom.validation.leckie_greenspan_2006 import tables as paper

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benches" / "results"
#: The folder of the paper's experiments, which has stored results and a page of its own.
PAPER = ROOT / "validation" / "leckie_greenspan_2006"
PAGES = (
    ROOT / "README.md",
    PAPER / "README.md",
    *(
        ROOT / "docs" / f"{name}.md"
        for name in (
            "benchmarks",
            "breaks",
            "contact",
            "guarantees",
            "ladder",
            "many-balls",
            "photo",
            "realism",
            "strategy",
            "tables",
        )
    ),
)
#: The comment above a table, and the table.
PLACE = re.compile(r"<!-- table: (\S+) (\S+) -->\n\n((?:\|.*\n)*)")

JSON = dict[str, Any]


#: The classes of all stored results; those of earlier commits had one pot.
NAMES = CLASSES | {"pot_shot": "pot shot, 2 balls", "random_pot": "random pots, 2 balls"}


def main() -> None:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="write the tables into the pages")
    parser.add_argument("bench", nargs="?", help="a stored result of `carom bench`")
    arguments = parser.parse_args()
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        written = filled(text, arguments.bench)
        if arguments.write:
            page.write_text(written, encoding="utf-8")
        else:
            for name, file, table in PLACE.findall(written):
                print(f"{page.name}: {name}, from {file}\n\n{table}")


def filled(text: str, bench: str | None = None) -> str:
    """A page with its tables made from the stored results."""

    def replace(place: re.Match[str]) -> str:
        name, file = place[1], place[2]
        if bench is not None and name in {"summary", "times", "events"}:
            file = bench
        result = json.loads(path_of(file).read_text(encoding="utf-8"))
        return f"<!-- table: {name} {file} -->\n\n{TABLES[name](result)}\n"

    return PLACE.sub(replace, text)


def path_of(file: str) -> Path:
    """The path of a stored result."""
    return next(path for path in (PAPER / file, RESULTS / file) if path.is_file())


def markdown(head: list[str], lines: list[list[str]]) -> str:
    """A Markdown table."""
    return "\n".join(f"| {' | '.join(cells)} |" for cells in (head, ["---"] * len(head), *lines))


def head_and_lines(rows: list[list[str]]) -> tuple[list[str], list[list[str]]]:
    """The first row and the others."""
    return rows[0], rows[1:]


def digits(value: float, count: int = 3) -> str:
    """A number rounded to some digits, without an exponent."""
    rounded = float(f"{value:.{count}g}")
    return f"{rounded:.0f}" if rounded >= 10 ** (count - 1) else f"{rounded:#.{count}g}"


def times(result: JSON) -> str:
    """Means over shots in turn beside medians of repeated shots."""
    head = ["", "carom, in turn, mean", f"{result['peer']}, mean", "ratio"]
    head += ["carom, repeated, median", f"{result['peer']}, median", "ratio"]
    return markdown(head, [[NAMES[n], *costs(row)] for n, row in result["classes"].items()])


def summary(result: JSON) -> str:
    """The README's table: means over shots in turn, then medians of repeated shots."""
    head = ["", "carom, mean", "pooltool, mean", "ratio"]
    head += ["carom, median, repeated", "pooltool, median", "ratio"]
    return markdown(
        head,
        [
            [NAMES[name].removeprefix("random "), *costs(row, count=2)]
            for name, row in result["classes"].items()
        ],
    )


def costs(row: JSON, count: int = 3) -> list[str]:
    """The cells of a class: means in turn and their ratio, medians and theirs."""
    peer = row["peer"]
    return [
        f"{digits(row['mixed_mean_us'], count)} µs",
        f"{digits(peer['mixed_mean_us'] / 1000, count)} ms",
        digits(row["ratio_of_mixed_means"]),
        f"{digits(row['median_us'], count)} µs",
        f"{digits(peer['median_us'] / 1000, count)} ms",
        digits(row["ratio_of_medians"]),
    ]


def events(result: JSON) -> str:
    """Numbers and costs of events, the cost of a trace, and the agreement of the engines."""
    head = ["", "events", "ns per event", "pooltool's events", "ratio per event", "with a trace"]
    lines = [
        [
            NAMES[name],
            f"{row['events_mean']:.1f}",
            f"{row['ns_per_event']:.0f}",
            f"{row['peer']['events_mean']:.1f}",
            f"{row['ratio_per_event']:.0f}",
            f"× {row['trace_ratio']:.2f}",
            f"{row['same_balls_pocketed']:.0%}".replace("%", " %"),
        ]
        for name, row in result["classes"].items()
    ]
    return markdown([*head, "same balls pocketed"], lines)


def amplification(result: JSON) -> str:
    """The growth of a tiny shift."""
    head = [
        "",
        f"growth of a shift of {result['shift_m']:.0e} m, median",
        f"a shift of {1e6 * result['nudge_m']:.0f} µm moves a ball by more than 1 mm",
    ]
    lines = [
        [
            CLASSES[name],
            f"{row['median_growth']:,.0f}".replace(",", " "),
            f"{100 * row['nudge_seen']:.0f} % of the shots",
        ]
        for name, row in result["classes"].items()
    ]
    return markdown(head, lines)


def pushes(result: JSON) -> str:
    """Events of shots in which a spinning ball pushes others."""
    spins = [f"{spin:,.0f} rad/s".replace(",", " ") for spin in result["spins_rad_s"]]
    lines = [
        [name, *(f"{events:,}".replace(",", " ") for events in row)]
        for name, row in result["events"].items()
    ]
    return markdown(["Balls in the row", *spins], lines)


def rows_of_balls(result: JSON) -> str:
    """Speeds of balls in a row after the impact."""
    names = {"1 moving": "one moves", "2 moving": "two move"}
    lines = [
        [names[name], ", ".join(f"{speed:.3f}".replace("-", "−") for speed in speeds)]
        for name, speeds in result["speeds_after_m_s"].items()
    ]
    return markdown(["Five equal balls, 1 m/s, no losses", "speeds after, m/s"], lines)


def breaks(result: JSON) -> str:
    """Eight-ball breaks by the gap in the rack."""
    head = ["Mean gap in the rack", "rebound", "object balls that reach a rail", "balls pocketed"]
    lines = []
    for row in result["breaks"]:
        low, high = row["rebound_range"]
        lines.append(
            [
                f"{row['gap_mm']:g} mm" if row["gap_mm"] else "none",
                f"{row['rebound_median']:.2f} ({low:.2f} to {high:.2f})",
                f"{row['balls_to_a_rail']:.1f}",
                f"{row['pocketed']:.1f}",
            ]
        )
    return markdown(head, lines)


def frozen_cue_ball(result: JSON) -> str:
    """The angles at which a frozen cue ball leaves."""
    rows = result["frozen"]
    lines = [
        [name, *(f"{row[key]:g}°" for row in rows)]
        for name, key in (
            ("measured (TP A.15)", "measured_deg"),
            ("`network`", "network_deg"),
            ("`sequential`", "sequential_deg"),
        )
    ]
    return markdown(["φ", *(f"{row['aim_deg']:g}°" for row in rows)], lines)


def slate_times(result: JSON) -> str:
    """Contact times of the slate that meet the bars of a massé and of a jump."""

    def span(times: list[float] | None) -> str:
        return f"{times[0]:.2f} to {times[1]:.2f}" if times else "none"

    bars = ["hop_at_most_15_mm", "direction_within_1_deg", "45_deg_jumps_a_ball", "all"]
    head = ["Restitution of the slate", "hop ≤ 15 mm", "direction within 1°"]
    head += ["45° jumps a ball", "all, ms"]
    lines = [
        [f"{row['restitution']:g}", *(span(row[bar]) for bar in bars)]
        for row in result["slate_times"]
    ]
    return markdown(head, lines)


def friction_of_blow(result: JSON) -> str:
    """The part of the slide's friction that a blow uses up."""
    head = ["Elevation", "network", "sequential, with its bounce"]
    lines = [
        [
            f"{row['elevation_deg']:g}°",
            f"{row['network_percent']:.0f} %",
            f"{row['sequential_percent']:.0f} %",
        ]
        for row in result["friction_of_the_blow"]
    ]
    return markdown(head, lines)


def realism_summary(result: JSON) -> str:
    """How many measured numbers each item of the realism page has, and how far the engine is."""
    choices = ["before", "after"] if result["before"] else ["after"]
    head = ["", "preset", "numbers"]
    for choice in choices:
        name = {"before": f"{result['before']}: ", "after": ""}[choice]
        head += [f"{name}within the tolerance", f"{name}median distance", f"{name}largest"]
    lines = []
    for item in result["items"].values():
        cells = [item["title"], f"`{item['preset']}`", str(len(item["points"]))]
        for choice in choices:
            cells += deviation(item, choice)
        lines.append(cells)
    return markdown(head, lines)


def deviation(item: JSON, choice: str) -> list[str]:
    """Numbers within the tolerance, and the median and largest |ours − measured|."""
    found = [p for p in item["points"] if p[choice] is not None]
    off = [abs(p[choice] - p["measured"]) for p in found]
    near = sum(d <= p["tolerance"] * (1 + 1e-6) for d, p in zip(off, found, strict=True))
    if not off:
        return ["0", "–", "–"]
    median = statistics.median(off)
    unit = "" if item["unit"] == "–" else f" {item['unit']}"
    return [str(near), f"{digits_or_0(median)}{unit}", f"{digits_or_0(max(off))}{unit}"]


def digits_or_0(value: float) -> str:
    """A number with two digits, or 0."""
    return digits(value, 2) if value else "0"


def realism_points(result: JSON, name: str) -> str:
    """Every measured number of one item beside the engine's."""
    item = result["items"][name]
    head = ["", f"measured, {item['unit']}", "tolerance"]
    choices = ["before", "after"] if result["before"] else ["after"]
    head += [{"before": result["before"], "after": "default"}[choice] for choice in choices]

    def shown(value: float | None) -> str:
        return "–" if value is None else f"{value:.4g}"

    lines = [
        [
            p["label"],
            shown(p["measured"]),
            f"± {p['tolerance']:.2g}",
            *(shown(p[c]) for c in choices),
        ]
        for p in item["points"]
    ]
    return markdown(head, lines)


def made(result: JSON) -> str:
    """How and when a result was made."""
    cells = [f"`{result['command']}`", result["commit"], result["date"]]
    return markdown(["Made by", "commit", "date"], [cells])


#: The items of the realism page whose numbers it shows one by one.
REALISM_ITEMS = (
    "throw", "returns", "carom-returns", "banks", "carom-rolling", "snooker-rolling",
    "corner-five-carom", "corner-five-pool", "plus-system", "ball-turn",
)  # fmt: skip

#: Published counts of breaks: rows of `breaks.py`, what happened, count and breaks, source.
PUBLISHED_BREAKS = (
    (
        ("nine-ball, beside the rail, template", "nine-ball, edge of the box, template"),
        "three balls past the head string, a ball falls, no foul",
        (75, 105),
        "nine-ball world championship 2016",
    ),
    (
        ("nine-ball, beside the rail, template", "nine-ball, edge of the box, template"),
        "a ball falls, no foul",
        (82, 105),
        "nine-ball world championship 2016",
    ),
    (
        ("eight-ball, 7 ft (bar-7ft), triangle", "eight-ball, 7 ft (showood-7ft), triangle"),
        "a ball falls, no foul",
        (82, 124),
        "Colorado Shootout 2024, 7 ft",
    ),
    (
        ("eight-ball, 7 ft (bar-7ft), triangle", "eight-ball, 7 ft (showood-7ft), triangle"),
        "the 8 falls",
        (2, 124),
        "Colorado Shootout 2024, 7 ft",
    ),
)


def _share(count: int, trials: int) -> str:
    """A share in percent with its Wilson interval."""
    chance = Chance.of(count, trials, 0.95)
    low, high = chance.low, chance.high
    return f"{100 * chance.probability:.1f} ({100 * low:.1f} to {100 * high:.1f})"


def published_breaks(result: JSON) -> str:
    """Published counts of breaks beside ours."""
    lines = []
    for names, what, (count, trials), source in PUBLISHED_BREAKS:
        for name in names:
            row = result["rows"][name]
            ours = _share(row["counts"].get(what, 0), row["racks"])
            lines.append(
                [name, what, f"{count} of {trials}: {_share(count, trials)}", ours, source]
            )
    head = ["Break", "what happens", "published, %", "ours, %", "source"]
    return markdown(head, lines)


def break_presets(result: JSON) -> str:
    """What happens in the breaks of each preset."""
    whats = ["a ball falls, no foul", "scratch", "a ball off the table"]
    lines = []
    for name, row in sorted(result["rows"].items()):
        counts = row["counts"]
        deciding = sum(count for what, count in counts.items() if what.startswith("the "))
        shares = [_share(counts.get(what, 0), row["racks"]) for what in whats]
        lines.append([name, *shares, _share(deciding, row["racks"])])
    head = ["Break", *(f"{what}, %" for what in whats), "the 8, 9 or 10 falls, %"]
    return markdown(head, lines)


def pockets(result: JSON) -> str:
    """The accepted width of a pocket at both ends of every parameter's range."""

    def end(row: JSON, base: list[float], which: str) -> str:
        changes = [f"{width - at:+.1f}" for width, at in zip(row[which], base, strict=True)]
        return " / ".join(changes).replace("-", "−")

    lines = []
    for pocket, rows in sorted(result["pockets"].items()):
        base = rows["base"]
        widths = " / ".join(f"{width:.1f}" for width in base)
        lines.append([f"`{pocket}`", "", "", f"width {widths}", ""])
        for name, row in rows.items():
            if name == "base":
                continue
            low, high = row["range"]
            unit = "°" if name.endswith("_deg") else ""
            if "." not in name and not unit:
                low, high, unit = 1000 * low, 1000 * high, " mm"
            span = f"{low:.4g} to {high:.4g}{unit}"
            ends = [end(row, base, "low"), end(row, base, "high")]
            lines.append([f"`{name}`", span, row["source"], *ends])
    head = ["Parameter", "range", "range from", "low end, mm", "high end, mm"]
    return markdown(head, lines)


#: What places a ball in a photo: names in the result, and in the page.
PHOTO_ROWS = {
    "tapped": "the tap itself",
    "without rails": "the centre of the outline near the tap, without the rails",
    "refined": "the centre of the outline near the tap",
    "layout": "the layout after contacts and rails",
}


def photo(result: JSON) -> str:
    """Errors of balls from photos, by the taps on the table and by the photographer's place."""
    stands = {"end": "from the end", "side": "from the side", "corner": "from a corner"}
    lines = []
    for taps, name in (("6", "all six places"), ("4", "the corners only")):
        for key, what in PHOTO_ROWS.items():
            row = result["errors_mm"][f"{taps} taps, {key}"]
            cells = [row, *(row[stand] for stand in stands)]
            shown = [f"{cell['median']:.1f} / {cell['percentile_95']:.0f}" for cell in cells]
            lines.append([name, what, *shown])
    return markdown(["Taps on the table", "place of a ball", "all", *stands.values()], lines)


def cost(result: JSON) -> str:
    """Instructions and events per shot, before and after the network took the strike."""
    lines = []
    for key, counted in result["classes"].items():
        before = counted["before"]
        cells = [NAMES[key], f"{before['instructions']:,}", f"{before['events']:.1f}"]
        for which in ("after", "after_default"):
            now = counted[which]
            change = 100 * (now["instructions"] / before["instructions"] - 1)
            cells += [f"{now['instructions']:,} ({change:+.1f} %)", f"{now['events']:.1f}"]
        lines.append(cells)
    now = ["the same physics", "events", "the default physics", "events"]
    return markdown(["Shots", "before", "events", *now], lines)


TABLES: dict[str, Callable[[JSON], str]] = (
    {
        "summary": summary,
        "times": times,
        "events": events,
        "amplification": amplification,
        "pushes": pushes,
        "rows": rows_of_balls,
        "breaks": breaks,
        "frozen": frozen_cue_ball,
        "slate-times": slate_times,
        "friction-of-blow": friction_of_blow,
        "published-breaks": published_breaks,
        "break-presets": break_presets,
        "pockets": pockets,
        "photo": photo,
        "made": made,
        "cost": cost,
        "realism-summary": realism_summary,
    }
    | {
        f"realism-{name}": lambda result, name=name: realism_points(result, name)
        for name in REALISM_ITEMS
    }
    | {
        name: lambda result, table=table: markdown(*head_and_lines(table(result["experiments"])))
        for name, table in strategy.TABLES.items()
    }
    | {
        name: lambda result, table=table: markdown(*head_and_lines(table(result["games"])))
        for name, table in strategy.VALUE_TABLES.items()
    }
    | {
        name: lambda result, table=table: markdown(*head_and_lines(table(result)))
        for name, table in ladder.TABLES.items()
    }
    | {f"paper-{name}": lambda _, table=table: table() for name, table in paper.TABLES.items()}
)


if __name__ == "__main__":
    main()
