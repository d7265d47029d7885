"""Makes the example studies: twenty basic positions, in `studies/`, in each language of the page.

A position has two balls and a strike; what the task asks for follows from the strike: the second
ball is put on the path of the cue ball, or a circle where it stops. Then the solution is the
direction nearest to the aim that solves the task with a margin. The texts are in `studies/texts/`.

    .venv/bin/python scripts/example_study.py
"""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from carom import Chapter, Shot, Study
from carom.study import judge

ROOT = Path(__file__).resolve().parents[1]
STUDIES = ROOT / "studies"

Point = tuple[float, float]

POOL, CAROM = "wpa-9ft", "carom-10ft"
# Radii of the balls, m.
RADIUS = {POOL: 0.028575, CAROM: 0.03075}
# Where a ball is aimed that shall fall: between the jaws, m.
POCKETS: dict[str, Point] = {
    "bottom-left": (0.0, 0.0),
    "bottom-right": (1.27, 0.0),
    "left": (-0.02, 1.27),
    "right": (1.29, 1.27),
    "top-left": (0.0, 2.54),
    "top-right": (1.27, 2.54),
}
# Step of the directions that are tried, degrees, and the fewest in a row that must solve a task: a
# careful player can play it.
STEP, LEAST = 0.02, 8


@dataclass(frozen=True)
class Position:
    """A position and its task.

    Attributes:
        key: Key of its texts.
        balls: Places of the balls, m; the first one is the cue ball.
        table: The table.
        goal: Conditions, as the file of a study has them.
        strike: Speed, m/s, height and side, ball radii.
        aim: Direction in which the search begins, degrees, and its half-width.
        second: A ball that is put on the path of the cue ball: its id, the number of the cushions
            before, and the distance behind the last of them or behind the first ball, m.
        circle: Radius of the circle around the place where the cue ball stops, m; 0 for none.
        others: Strikes of variations, each with the key of its comment.
    """

    key: str
    balls: dict[str, Point]
    goal: list[dict[str, Any]]
    strike: tuple[float, float, float]
    aim: tuple[float, float]
    table: str = POOL
    second: tuple[str, int, float] | None = None
    circle: float = 0.0
    others: dict[str, tuple[float, float, float]] = field(default_factory=dict)

    @property
    def cue(self) -> str:
        """The id of the cue ball."""
        return next(iter(self.balls))


def cut(ball: Point, pocket: str, back: float, degrees: float) -> tuple[Point, float]:
    """A place from which a ball is cut into a pocket.

    Args:
        ball: The ball, m.
        pocket: The pocket.
        back: Distance of the cue ball from the ghost ball, m.
        degrees: Cut angle, counter-clockwise.

    Returns:
        The place, rounded to 1 mm, and the direction from it, degrees.
    """
    to = POCKETS[pocket]
    line = math.atan2(to[1] - ball[1], to[0] - ball[0])
    ghost = along(ball, line, -2 * RADIUS[POOL])
    aim = line + math.radians(degrees)
    x, y = along(ghost, aim, -back)
    return (round(x, 3), round(y, 3)), math.degrees(aim)


def along(place: Point, direction: float, distance: float) -> Point:
    """The place at a distance (m) in a direction (rad)."""
    return (
        place[0] + distance * math.cos(direction),
        place[1] + distance * math.sin(direction),
    )


def potted(
    key: str,
    ball: Point,
    pocket: str,
    back: float,
    degrees: float,
    strike: tuple[float, float, float],
    **more: Any,
) -> Position:
    """A position in which the 1 is potted."""
    place, aim = cut(ball, pocket, back, degrees)
    goal = [{"kind": "pot", "ball": "1", "pocket": pocket}]
    return Position(key, {"cue": place, "1": ball}, goal, strike, (aim, 2.0), **more)


def carom(
    key: str,
    white: Point,
    yellow: Point,
    strike: tuple[float, float, float],
    passing: float,
    **more: Any,
) -> Position:
    """A position of three balls, of which the white one is the cue ball.

    Args:
        key: Key of its texts.
        white: The cue ball, m.
        yellow: The first object ball, m.
        strike: As of the position.
        passing: How far left of the yellow ball's centre the line of aim passes, ball diameters.
        more: Others of the position.
    """
    away = math.dist(white, yellow)
    line = math.atan2(yellow[1] - white[1], yellow[0] - white[0])
    aim = line + math.asin(2 * RADIUS[CAROM] * passing / away)
    balls = {"white": white, "yellow": yellow}
    return Position(key, balls, [], strike, (round(math.degrees(aim), 2), 3.0), CAROM, **more)


POSITIONS = [
    potted(
        "stop",
        (0.95, 2.0),
        "top-right",
        0.8,
        0.0,
        (2.6, -0.2, 0.0),
        circle=0.06,
        others={"follow": (2.6, 0.4, 0.0), "draw": (3.4, -0.4, 0.0)},
    ),
    potted(
        "stop-far",
        (1.1, 2.25),
        "top-right",
        1.5,
        0.0,
        (3.5, -0.24, 0.0),
        circle=0.08,
        others={"roll": (3.5, 0.1, 0.0)},
    ),
    potted(
        "tangent",
        (0.9, 1.9),
        "top-right",
        0.6,
        30.0,
        (2.6, -0.13, 0.0),
        second=("2", 0, 0.45),
        others={"follow": (2.6, 0.4, 0.0), "draw": (3.4, -0.4, 0.0)},
    ),
    potted(
        "tangent-thin",
        (0.35, 2.1),
        "top-left",
        0.6,
        -55.0,
        (2.6, -0.13, 0.0),
        second=("2", 0, 0.55),
    ),
    potted("stun-cushion", (0.25, 2.2), "top-left", 0.6, 40.0, (2.2, -0.2, 0.0), circle=0.2),
    potted("stun-follow", (0.9, 1.45), "right", 0.5, 20.0, (2.4, 0.0, 0.0), circle=0.12),
    potted(
        "follow",
        (0.8, 1.85),
        "top-right",
        0.6,
        6.0,
        (2.0, 0.4, 0.0),
        circle=0.15,
        others={"stop": (2.0, -0.25, 0.0)},
    ),
    potted(
        "draw",
        (0.95, 2.0),
        "top-right",
        0.7,
        0.0,
        (3.0, -0.4, 0.0),
        circle=0.15,
        others={"stop": (3.0, -0.12, 0.0)},
    ),
    potted("half-ball", (0.8, 1.9), "top-right", 0.6, 30.0, (2.2, 0.4, 0.0), second=("2", 0, 0.45)),
    potted(
        "quarter-ball", (0.7, 2.0), "top-right", 0.6, 48.6, (2.0, 0.4, 0.0), second=("2", 0, 0.4)
    ),
    potted(
        "three-quarter", (0.5, 1.6), "top-left", 0.6, -14.5, (2.0, 0.4, 0.0), second=("2", 0, 0.5)
    ),
    potted("natural-cushion", (0.3, 0.5), "bottom-left", 0.8, 30.0, (2.0, 0.35, 0.0), circle=0.15),
    potted(
        "no-scratch",
        (0.3, 1.3),
        "left",
        0.5,
        0.0,
        (2.4, -0.35, 0.0),
        circle=0.2,
        others={"scratch": (2.4, 0.4, 0.0)},
    ),
    carom("carom-half", (0.4, 0.6), (0.75, 1.5), (2.0, 0.4, 0.0), -0.5, second=("red", 0, 0.5)),
    carom("carom-thin", (0.9, 0.6), (0.85, 1.6), (2.0, 0.3, 0.0), 0.85, second=("red", 0, 0.7)),
    carom("carom-draw", (0.7, 0.9), (0.75, 1.6), (3.2, -0.45, 0.0), 0.25, second=("red", 0, 0.35)),
    carom("one-cushion", (0.5, 1.0), (1.1, 1.7), (2.4, 0.3, 0.0), -0.6, second=("red", 1, 0.5)),
    carom("two-cushions", (0.5, 0.8), (1.0, 2.2), (3.0, 0.3, -0.3), 0.6, second=("red", 2, 0.5)),
    carom("three-cushions", (0.35, 0.9), (0.9, 2.1), (4.0, 0.3, -0.4), 0.5, second=("red", 3, 0.5)),
    Position(
        "cushion-first",
        {"white": (0.4, 0.8), "yellow": (1.0, 2.0)},
        [{"kind": "kick", "cushions": 1}, {"kind": "first", "ball": "yellow"}],
        (2.4, 0.2, 0.0),
        (40.0, 15.0),
        CAROM,
        second=("red", 0, 0.3),
    ),
]


def strike_of(position: Position, azimuth_deg: float) -> dict[str, Any]:
    """The strike of a position in a direction, degrees."""
    speed, height, side = position.strike
    strike = {"ball": position.cue, "speed": speed, "azimuth_deg": azimuth_deg}
    return strike | {key: value for key, value in (("height", height), ("side", side)) if value}


def shot_of(position: Position, balls: dict[str, Point], azimuth_deg: float) -> Shot:
    """The shot of a position with these balls in a direction, degrees."""
    return Shot(position.table, balls, strike_of(position, azimuth_deg))


def solved(position: Position, balls: dict[str, Point], goal: list[dict[str, Any]]) -> float:
    """The direction nearest to the aim that meets the goal, as do its neighbours, degrees."""
    aim, window = position.aim
    if not goal:
        return aim
    count = round(window / STEP)
    tried = [round(aim + STEP * k, 2) for k in range(-count, count + 1)]
    met = [judge(shot_of(position, balls, a).simulate(), goal)["met"] for a in tried]
    half = LEAST // 2
    safe = [a for k, a in enumerate(tried) if k >= half and all(met[k - half : k + half + 1])]
    if not safe:
        raise SystemExit(f"{position.key}: too few directions meet {goal}")
    return min(safe, key=lambda azimuth: abs(azimuth - aim))


def placed(position: Position, azimuth: float) -> tuple[dict[str, Point], list[dict[str, Any]]]:
    """All balls, and the whole goal."""
    balls, goal = dict(position.balls), list(position.goal)
    trace = shot_of(position, balls, azimuth).simulate()
    if position.second:
        ball, cushions, distance = position.second
        balls[ball] = on_path(trace, position.cue, cushions, distance)
        goal.append({"kind": "carom", "cushions": cushions})
    if position.circle:
        x, y, _ = trace.at(trace.duration).position[0]
        area = {"center": [round(float(x), 2), round(float(y), 2)], "radius": position.circle}
        goal.append({"kind": "stop", "area": area})
    return balls, goal


def on_path(trace: Any, cue: str, cushions: int, distance: float) -> Point:
    """A place on the path of the cue ball: behind the first ball and a number of cushions, m."""
    met = next(e.time for e in trace.events if e.type == "ball-collision" and cue in e.balls)
    rails = (
        e.time
        for e in trace.events
        if e.type == "rail-collision" and e.balls == [cue] and e.time > met
    )
    begin = [met, *rails][cushions]
    path = trace.polyline(cue, 0.001)
    path = path[path[:, 3] >= begin]
    lengths = np.cumsum([0.0, *np.hypot(*np.diff(path[:, :2], axis=0).T)])
    if lengths[-1] < distance:
        raise SystemExit(f"the path behind {cushions} cushions is {lengths[-1]:.2f} m long")
    x, y = (float(np.interp(distance, lengths, path[:, k])) for k in (0, 1))
    return (round(x, 3), round(y, 3))


def marks_of(position: Position, balls: dict[str, Point], azimuth: float) -> list[dict[str, Any]]:
    """The line of aim up to the ghost ball or the cushion, and the way of a ball that is potted."""
    cue = balls[position.cue]
    trace = shot_of(position, balls, azimuth).simulate()
    first = next(e for e in trace.events if e.type in {"ball-collision", "rail-collision"})
    x, y, _ = trace.at(first.time).position[0]
    to = [round(float(x), 3), round(float(y), 3)]
    marks: list[dict[str, Any]] = [
        {"kind": "line", "color": "white", "from": list(cue), "to": to},
        {"kind": "circle", "color": "white", "center": to, "radius": RADIUS[position.table]},
    ]
    for need in position.goal:
        if need["kind"] == "pot":
            start, end = balls[need["ball"]], POCKETS[need["pocket"]]
            arrow = {"kind": "arrow", "color": "yellow", "from": list(start), "to": list(end)}
            marks.append(arrow)
    return marks


def chapter(position: Position, texts: dict[str, Any]) -> Chapter:
    """The chapter of a position with the texts of a language."""
    balls, goal = placed(position, solved(position, position.balls, position.goal))
    azimuth = solved(position, balls, goal)
    solution = strike_of(position, azimuth)
    own = texts[position.key]
    tree = [{"strike": solution, "comment": own["solution"]}]
    for name, other in position.others.items():
        strike = strike_of(replace(position, strike=other), azimuth)
        tree.append({"strike": strike, "comment": texts["others"][name]})
    shot = Shot.from_dict(
        {
            "format": "carom-shot/1",
            "table": position.table,
            "balls": [{"id": ball, "position": list(place)} for ball, place in balls.items()],
            "marks": marks_of(position, balls, azimuth),
        }
    )
    task = {"goal": goal, "solution": solution}
    return Chapter(own["title"], shot, own["text"], tree, task)


def main() -> None:
    """Write the studies."""
    for path in sorted((STUDIES / "texts").glob("*.toml")):
        texts = tomllib.loads(path.read_text(encoding="utf-8"))
        chapters = [chapter(position, texts) for position in POSITIONS]
        study = Study(texts["title"], chapters, author="carom", language=path.stem)
        print(study.check())
        study.save(STUDIES / f"twenty_positions.{path.stem}.json")


if __name__ == "__main__":
    main()
