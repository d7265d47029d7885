"""The tables of the README, made from the stored results.

`python benches/tables.py --write` writes them into the page.
"""

from __future__ import annotations

import statistics
from typing import TYPE_CHECKING

from carom.validation.leckie_greenspan_2006.rows import counted, finders, stored

if TYPE_CHECKING:
    from carom.validation.lab import JSON

#: The stored results, and what each of them holds.
FILES = {
    "operations.json": "operations per event",
    "operation_kinds.json": "operations of each kind of impact and search",
    "root_finders.json": "random shots by root finder",
    "fixed_step.json": "the fixed-step simulator",
}

CLASSES = {
    "pots": "pots, 2–4 balls",
    "random_eight_ball": "mid-game, 4–16 balls",
    "nine_ball_break": "nine-ball break",
    "eight_ball_break": "eight-ball break",
}


#: Which root counts as the contact, by the name of the rule in the stored results.
RULES = {
    "smallest positive root": "smallest positive root",
    "at which they approach": "smallest positive root at which they approach",
    "or touching at the start": "the same, or t = 0 if they touch and approach",
    "first contact": "first t with f ≤ 0 and f′ < 0",
}


def spaced(count: float) -> str:
    """A rounded number with a space before every three digits."""
    return f"{count:,.0f}".replace(",", " ")


def markdown(head: list[str], lines: list[list[str]]) -> str:
    """A Markdown table."""
    rule = ["---"] * len(head)
    return "\n".join(f"| {' | '.join(cells)} |" for cells in [head, rule, *lines])


def found_kinds() -> list[str]:
    """The kinds of faults that a finder has, in the order of their numbers at a micrometre."""
    sums: dict[str, int] = {}
    for finder in finders():
        for kinds in finder["first_faults"].values():
            for kind in kinds:
                sums.setdefault(kind, 0)
        for kind, count in finder["first_faults"]["micrometre"].items():
            sums[kind] += count
    return sorted(sums, key=lambda kind: (-sums[kind], kind))


def finder_table(family: str) -> str:
    """Shots with an impossible result, by root finder and by which of its roots is the contact.

    The columns of kinds are the first faults at a micrometre.
    """
    head = ["Roots by", "time of the contact", "shots", "impossible by > 1 mm", "> 1 µm",
            "> promised", *found_kinds(), "pairs searched"]  # fmt: skip
    lines = [
        [f["method"], RULES[f["reading"]], spaced(f["shots"])]
        + [spaced(f["impossible"][limit]) for limit in ("millimetre", "micrometre", "promised")]
        + [spaced(f["first_faults"]["micrometre"].get(kind, 0)) for kind in found_kinds()]
        + ["left by the proofs" if f["proofs"] else "all"]
        for f in finders()
        if f["family"] == family
    ]
    return markdown(head, lines)


def promised_table() -> str:
    """First faults of ordinary shots at the engine's own limits, by kind."""
    head = ["Roots by", "time of the contact", "shots", "faulty", *found_kinds()]
    lines = [
        [f["method"], RULES[f["reading"]], spaced(f["shots"]), spaced(f["impossible"]["promised"])]
        + [spaced(f["first_faults"]["promised"].get(kind, 0)) for kind in found_kinds()]
        for f in finders()
        if f["family"] == "ordinary"
    ]
    return markdown(head, lines)


def operation_table() -> str:
    """Mean numbers per event, by class of shot."""
    head = ["Per event", *CLASSES.values()]
    per = [(c := counted()[name], c["events"]) for name in CLASSES]
    count = {
        "balls that move": [c["moving"] / n for c, n in per],
        "quartics by the paper's method": [c["pairs"] / n for c, n in per],
        "pairs that the engine examines": [c["looked_at"] / n for c, n in per],
        "of them rejected by proof": [(c["looked_at"] - c["solved"]) / n for c, n in per],
        "quartics that it solves": [c["solved"] / n for c, n in per],
        "paths on the cloth compared with the table": [c["searched"] / n for c, n in per],
        "of them proved clear": [c["clear"] / n for c, n in per],
        "paths off the bed compared with the table": [c["searched_off_bed"] / n for c, n in per],
    }
    lines = [[name, *(f"{x:.2f}" for x in numbers)] for name, numbers in count.items()]
    lines += [
        [f"**operations, {way}**", *(spaced(c["operations"][way] / n) for c, n in per)]
        for way in ("by steps of 1 ms", "the paper's events", "carom")
    ]
    return markdown(head, lines)


def event_table() -> str:
    """Mean numbers of events per shot, by kind and class of shot."""
    head = ["Per shot", *CLASSES.values()]
    classes = [counted()[name] for name in CLASSES]
    lines = [
        [kind, *(f"{c['by_kind'][kind] / c['shots']:.2f}" for c in classes)]
        for kind in classes[0]["by_kind"]
    ]
    sizes = [c["network_balls"] / max(c["by_kind"]["network of balls"], 1) for c in classes]
    lines.append(["balls in a network", *(f"{size:.1f}" if size else "–" for size in sizes)])
    return markdown(head, lines)


def kind_table() -> str:
    """Operations of each kind of impact and search."""
    head = ["", "operations", "of them ÷", "of them √", "instructions"]
    lines, group = [], ""
    for kind in stored("operation_kinds.json")["kinds"]:
        if kind["group"] != group:
            group = kind["group"]
            lines.append([f"**{group}**", "", "", "", ""])
        values = (kind[key] for key in ("operations", "divisions", "square_roots", "instructions"))
        lines.append([kind["name"], *map(spaced, values)])
    return markdown(head, lines)


def step_table() -> str:
    """Errors of the fixed-step simulator over a set of shots, by step and form of the step."""
    result = stored("fixed_step.json")
    shots = result["shots"]
    forms = {"v dt": "v Δt", "v dt + a dt^2 / 2": "v Δt + ½aΔt²"}
    head = ["Δt, ms"]
    for form in forms.values():
        head += [f"{form}: end, median", "90 %", "first collision, median", "same collisions"]
    lines = []
    for k, dt in enumerate(result["steps"]):
        cells = [f"{1e3 * dt:g}"]
        for form in forms:
            found = [shot["by_steps"][form][k] for shot in shots]
            cells += [f"{1e3 * quantile(found, q):.3g} mm" for q in (0.5, 0.9)]
            late = [f["first_contact_error"] for f in found if f["first_contact_error"] is not None]
            same = sum(f["same_collisions"] for f in found)
            cells += [f"{1e3 * statistics.median(late):.2g} ms", f"{same} of {len(shots)}"]
        lines.append(cells)
    return markdown(head, lines)


def quantile(found: list[JSON], share: float) -> float:
    """The value that a share of the shots' errors at the end does not exceed, m."""
    errors = sorted(f["end_error"] for f in found)
    return float(errors[round(share * (len(errors) - 1))])


def file_table() -> str:
    """The stored results, with the command, commit and date of each."""
    lines = []
    for name, what in FILES.items():
        made = stored(name)
        lines.append([f"`{name}`", what, f"`{made['command']}`", made["commit"], made["date"]])
    return markdown(["File", "holds", "made by", "commit", "date"], lines)


#: The tables by the names that the page gives them.
TABLES = {
    "ordinary": lambda: finder_table("ordinary"),
    "frozen": lambda: finder_table("frozen"),
    "promised": promised_table,
    "operations": operation_table,
    "events": event_table,
    "kinds": kind_table,
    "steps": step_table,
    "files": file_table,
}
