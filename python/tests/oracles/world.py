"""A shot, as the two oracles read it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

Number = Any
JSON = dict[str, Any]


@dataclass(frozen=True)
class Wall:
    """A straight piece of a cushion's nose line; `inward` points to the playing area."""

    rail: str
    start: tuple[float, float]
    end: tuple[float, float]
    inward: tuple[float, float]
    part: str = "nose"


@dataclass(frozen=True)
class Post:
    """A round piece of a cushion's nose line, bulging to the playing area."""

    rail: str
    center: tuple[float, float]
    radius: float
    part: str = "point"


@dataclass(frozen=True)
class Hole:
    """A pocket: it takes a ball whose centre comes over it."""

    name: str
    center: tuple[float, float]
    radius: float


@dataclass(frozen=True)
class World:
    """Everything about a shot that does not change."""

    ids: list[str]
    mass: list[float]
    radius: list[float]
    physics: JSON
    nose_height: float = 0.0
    walls: list[Wall] = field(default_factory=list)
    posts: list[Post] = field(default_factory=list)
    holes: list[Hole] = field(default_factory=list)

    @property
    def gravity(self) -> float:
        g: float = self.physics["gravity"]
        return g


def world_of(shot: JSON, geometry: JSON | None = None) -> World:
    """Reads a shot whose physics is written out in full (no preset is known here).

    The table is unbounded cloth or a plain rectangle, unless `geometry` gives its walls, posts,
    holes and nose height.
    """
    physics = shot["physics"]
    default = physics["ball"]
    table = shot["table"]
    shape: JSON = geometry or {}
    if not shape and table.get("cloth") != "unbounded":
        w, length = table["width"], table["length"]
        shape = {
            "nose_height": table["cushion_height"],
            "walls": [
                Wall("bottom", (0.0, 0.0), (w, 0.0), (0.0, 1.0)),
                Wall("top", (0.0, length), (w, length), (0.0, -1.0)),
                Wall("left", (0.0, 0.0), (0.0, length), (1.0, 0.0)),
                Wall("right", (w, 0.0), (w, length), (-1.0, 0.0)),
            ],
        }
    return World(
        ids=[b["id"] for b in shot["balls"]],
        mass=[b.get("mass", default["mass"]) for b in shot["balls"]],
        radius=[b.get("radius", default["radius"]) for b in shot["balls"]],
        physics=physics,
        **shape,
    )


def geometry_of(table: JSON) -> JSON:
    """Walls, posts and holes of a table as `carom.tables()` lists it."""
    posts = [
        Post(c["rail"], tuple(c["center"]), c["radius"]) for c in table["cushions"] if "center" in c
    ]
    walls = []
    for c in table["cushions"]:
        if "center" in c:
            continue
        a, b = c["start"], c["end"]
        length = math.dist(a, b)
        n = (-(b[1] - a[1]) / length, (b[0] - a[0]) / length)
        # The round points stand behind the straight pieces that they join.
        post = min(posts, key=lambda p: min(math.dist(p.center, a), math.dist(p.center, b)))
        if (post.center[0] - a[0]) * n[0] + (post.center[1] - a[1]) * n[1] > 0.0:
            n = (-n[0], -n[1])
        walls.append(Wall(c["rail"], tuple(a), tuple(b), n, c["part"]))
    holes = [Hole(p["name"], tuple(p["center"]), p["radius"]) for p in table["pockets"]]
    return {
        "nose_height": table["cushion_height"],
        "walls": walls,
        "posts": posts,
        "holes": holes,
    }


@dataclass(frozen=True)
class State:
    """A ball at one instant, in the trace's words."""

    position: tuple[Number, Number, Number]
    velocity: tuple[Number, Number, Number]
    spin: tuple[Number, Number, Number]
    motion: str


@dataclass(frozen=True)
class Happening:
    """An event, in the trace's words; `key` names what happened without the numbers."""

    time: Number
    key: tuple[str, ...]
    balls: tuple[str, ...]
    before: tuple[State, ...]
    after: tuple[State, ...]


def start_of(shot: JSON) -> list[State]:
    """The balls at time 0; a strike is not played here."""
    radius = shot["physics"]["ball"]["radius"]
    states = []
    for b in shot["balls"]:
        x, y = b["position"][:2]
        v = tuple(b.get("velocity", (0.0, 0.0, 0.0)))
        w = tuple(b.get("angular_velocity", (0.0, 0.0, 0.0)))
        r = b.get("radius", radius)
        states.append(State((x, y, r), v, w, motion_of(v, w, r)))
    return states


def motion_of(v: Any, w: Any, radius: Number, rounding: float = 1e-12) -> str:
    """The motion state that a ball's velocities mean; slip below `rounding` of them is none."""
    slip = (v[0] - radius * w[1]) ** 2 + (v[1] + radius * w[0]) ** 2
    speeds = v[0] ** 2 + v[1] ** 2 + radius**2 * (w[0] ** 2 + w[1] ** 2)
    if slip > rounding**2 * speeds:
        return "sliding"
    if v[0] != 0 or v[1] != 0:
        return "rolling"
    return "spinning" if w[2] != 0 else "stationary"


def state_of(item: JSON) -> State:
    """A ball of a trace."""
    return State(
        tuple(item["position"]),
        tuple(item["velocity"]),
        tuple(item["angular_velocity"]),
        item["motion"],
    )


def key_of(event: JSON) -> tuple[str, ...]:
    """What happened, without the numbers."""
    kind = event["type"]
    if kind == "rail-collision":
        return (kind, *event["balls"], event["rail"], event["part"])
    if kind == "motion-transition":
        return (kind, *event["balls"], event["from"], event["to"])
    if kind == "pocket-collision":
        return (kind, *event["balls"], event["pocket"])
    return (kind, *sorted(event["balls"]))
