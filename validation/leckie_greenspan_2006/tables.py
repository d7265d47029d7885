"""The page's tables, from the stored results."""

from __future__ import annotations

from carom.validation.leckie_greenspan_2006.rows import counted, finders

CLASSES = {
    "pot_shot": "a pot, 2 balls",
    "random_eight_ball": "mid-game, 4–16 balls",
    "nine_ball_break": "nine-ball break",
    "eight_ball_break": "eight-ball break",
}


def spaced(count: float) -> str:
    """A number with its thousands apart."""
    return f"{count:,.0f}".replace(",", " ")


def markdown(head: list[str], lines: list[list[str]]) -> str:
    """A table."""
    rule = ["---"] * len(head)
    return "\n".join(f"| {' | '.join(cells)} |" for cells in [head, rule, *lines])


def finder_table(family: str) -> str:
    """Shots with an impossible result, by root finder and how its roots are read."""
    head = ["Roots", "taken: the smallest", "shots", "impossible by > 1 mm", "> 1 µm",
            "> promised", "overlap", "apart", "endless", "µs a shot"]  # fmt: skip
    lines = [
        [f["method"], f["reading"], spaced(f["shots"])]
        + [spaced(f["impossible"][limit]) for limit in ("millimetre", "micrometre", "promised")]
        + [spaced(f[kind]) for kind in ("overlap", "apart", "endless")]
        + [f"{f['microseconds_per_shot']:.0f}"]
        for f in finders()
        if f["family"] == family
    ]
    return markdown(head, lines)


def operation_table() -> str:
    """What is done per event, by class of shot."""
    head = ["Per event", *CLASSES.values()]
    per = [(c := counted()[name], c["events"]) for name in CLASSES]
    count = {
        "balls that move": [c["moving"] / n for c, n in per],
        "quartics, in the paper": [c["pairs"] / n for c, n in per],
        "pairs looked at, here": [c["looked_at"] / n for c, n in per],
        "of them turned away by proof": [(c["looked_at"] - c["solved"]) / n for c, n in per],
        "quartics solved": [c["solved"] / n for c, n in per],
        "paths held against the cushions": [c["searched"] / n for c, n in per],
        "of them clear by proof": [c["clear"] / n for c, n in per],
    }
    lines = [[name, *(f"{x:.2f}" for x in numbers)] for name, numbers in count.items()]
    lines += [
        [f"**operations, {way}**", *(spaced(c["operations"][way] / n) for c, n in per)]
        for way in ("by steps of 1 ms", "the paper's events", "carom")
    ]
    return markdown(head, lines)
