"""Breaks of professionals, counted on video, beside the break presets with the default physics.

The errors of the player are those of the noise preset `professional`. A published share is compared
as its Wilson interval at 95 % confidence.
"""

from functools import cache

import carom
from carom.plan.chance import Chance
from carom.validation import lab
from carom.validation.lab import JSON
from carom.validation.row import Kind, Range, row

#: The player's errors: a preset of `carom.Noise`.
NOISE = "professional"
#: Racks that are broken for each row: their share has a 95 % interval of about ±5 points.
RACKS = 400
#: Balls that must be pocketed or touch the line of the head string in a legal break of the world
#: championship of 2016.
LEAST_PAST_HEAD_STRING = 3
LEGAL = "three balls past the head string, a ball falls, no foul"
SUCCESS = "a ball falls, no foul"

WORLD_2016 = "105 breaks, nine-ball world championship 2016 (forums.azbilliards.com, post 5630580)"
COLORADO = "124 breaks, Colorado Shootout 2024, 7 ft (forums.azbilliards.com, thread 568443)"


def happened(
    seed: int, game: str, preset: str | None, table: str | None = None, gap: float | None = None
) -> list[str]:
    """What happened in the break of one rack, with the errors of the player."""
    shot = carom.break_shot(game, preset=preset, table=table, gap=gap, seed=seed)
    drawn = carom.Noise.preset(NOISE).draw(shot, seed)
    keys = ("speed", "azimuth", "elevation", "side", "height")
    run = lab.Run(shot.with_strike(**{key: getattr(drawn, key) for key in keys}).simulate())
    outcome = run.trace.outcome
    fallen = {ball for ball, _ in outcome["pocketed"]}
    off = set(outcome["off_table"])
    foul = "cue" in fallen or bool(off) or outcome["first_contact"] is None
    if game in ("nine-ball", "ten-ball"):
        foul = foul or outcome["first_contact"] != "1"
    potted = fallen - {"cue"}
    succeeds = bool(potted) and not foul
    deciding = {"eight-ball": "8", "nine-ball": "9", "ten-ball": "10"}[game]
    # The check needs the states of all events, so only where it decides.
    legal = succeeds and len(potted | past_head_string(run, shot)) >= LEAST_PAST_HEAD_STRING
    found = {
        "a ball falls": bool(potted),
        SUCCESS: succeeds,
        LEGAL: legal,
        "scratch": "cue" in fallen,
        "a ball off the table": bool(off),
        f"the {deciding} falls": deciding in fallen,
    }
    return [what for what, is_so in found.items() if is_so]


def past_head_string(run: lab.Run, shot: carom.Shot) -> set[str]:
    """Object balls that touched the plane of the head string.

    Checked at the events and at the end. A ball that turned back between two events without
    meeting a cushion or a ball would be missed; only strong spin could do that.
    """
    line = shot.geometry()["markings"]["head_string"]
    radius = dict(zip(shot.ids, shot.radius.tolist(), strict=True))
    states: list[JSON] = [state for event in run.record["events"] for state in event["after"]]
    return {
        state["id"]
        for state in states + run.record["final"]
        if state["id"] != "cue" and state["position"][1] - radius[state["id"]] <= line
    }


@cache
def shares(game: str, preset: str, table: str | None = None) -> dict[str, float]:
    """The percentage of the racks in which each thing happened."""
    counts: dict[str, int] = {}
    for seed in range(RACKS):
        for what in happened(seed, game, preset, table):
            counts[what] = counts.get(what, 0) + 1
    return {what: 100.0 * count / RACKS for what, count in counts.items()}


def published(count: int, breaks: int) -> Range:
    """The Wilson interval of a published count, %."""
    chance = Chance.of(count, breaks, 0.95)
    return Range(round(100.0 * chance.low, 1), round(100.0 * chance.high, 1))


@row(
    "BR-eight",
    "Eight-ball on 7 ft: a ball falls and no foul (`head`, triangle)",
    unit="%",
    source=COLORADO,
    kind=Kind.MEASURED,
    held=True,
    uses_preset=True,
    reference=dict.fromkeys(("bar-7ft", "showood-7ft"), published(82, 124)),
    note="The table of the source had tighter corner pockets, 4 to 4⅛ in.",
)
def br_eight() -> list[float]:
    return [shares("eight-ball", "head", table)[SUCCESS] for table in ("bar-7ft", "showood-7ft")]


@row(
    "BR-8",
    "Eight-ball on 7 ft: the 8 falls (`head`, triangle)",
    unit="%",
    source=COLORADO,
    kind=Kind.MEASURED,
    uses_preset=True,
    reference=dict.fromkeys(("bar-7ft", "showood-7ft"), published(2, 124)),
    misses=("showood-7ft",),
    note="Two of 124 is a small count. docs/breaks.md has ours for 4000 racks.",
)
def br_8() -> list[float]:
    tables = ("bar-7ft", "showood-7ft")
    return [shares("eight-ball", "head", table).get("the 8 falls", 0.0) for table in tables]


NINE_BALL = {
    f"{preset}, {what}": (preset, what, count)
    for preset in ("rail", "box")
    for what, count in ((LEGAL, 75), (SUCCESS, 82))
}


@row(
    "BR-nine",
    "Nine-ball, template: the break succeeds (`rail`, `box`)",
    unit="%",
    source=WORLD_2016,
    kind=Kind.MEASURED,
    uses_preset=True,
    reference={label: published(count, 105) for label, (_, _, count) in NINE_BALL.items()},
    misses=tuple(NINE_BALL),
    note="The players broke from anywhere behind the line; our place is the same in every rack. "
    "The result of a frozen rack depends strongly on it (docs/breaks.md).",
)
def br_nine() -> list[float]:
    return [shares("nine-ball", preset)[what] for preset, what, _ in NINE_BALL.values()]
