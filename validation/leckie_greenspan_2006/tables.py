"""The tables of the README, made from the stored results.

    python -m carom.validation.leckie_greenspan_2006.tables

prints them.
"""

from __future__ import annotations

from carom.validation.leckie_greenspan_2006.rows import counted, finders, stored

CLASSES = {
    "pot_shot": "a pot, 2 balls",
    "random_eight_ball": "mid-game, 4–16 balls",
    "nine_ball_break": "nine-ball break",
    "eight_ball_break": "eight-ball break",
}


#: The pairs that a finder searches: the engine's only those that its proofs leave, a peer's all.
SEARCHED = {"carom": "left by the proofs"}

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


def finder_table(family: str) -> str:
    """Shots with an impossible result, by root finder and by which of its roots is the contact."""
    head = ["Roots by", "time of the contact", "shots", "impossible by > 1 mm", "> 1 µm",
            "> promised", "overlap", "apart", "endless", "pairs searched", "µs a shot"]  # fmt: skip
    lines = [
        [f["method"], RULES[f["reading"]], spaced(f["shots"])]
        + [spaced(f["impossible"][limit]) for limit in ("millimetre", "micrometre", "promised")]
        + [spaced(f[kind]) for kind in ("overlap", "apart", "endless")]
        + [SEARCHED.get(f["method"], "all"), f"{f['microseconds_per_shot']:.0f}"]
        for f in finders()
        if f["family"] == family
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
        "paths compared with the cushions": [c["searched"] / n for c, n in per],
        "of them proved clear": [c["clear"] / n for c, n in per],
    }
    lines = [[name, *(f"{x:.2f}" for x in numbers)] for name, numbers in count.items()]
    lines += [
        [f"**operations, {way}**", *(spaced(c["operations"][way] / n) for c, n in per)]
        for way in ("by steps of 1 ms", "the paper's events", "carom")
    ]
    return markdown(head, lines)


def made(name: str) -> str:
    """The commit and date of a stored result, as the README gives them."""
    result = stored(name)
    return f"commit {result['commit']}, {result['date']}"


if __name__ == "__main__":
    for name, tables in (
        ("root_finders.json", [finder_table("ordinary"), finder_table("frozen")]),
        ("operations.json", [operation_table()]),
    ):
        print(f"{name} ({made(name)})\n", *tables, sep="\n", end="\n\n")
