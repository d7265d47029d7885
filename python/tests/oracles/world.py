"""A shot in the form that both oracles use."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

Number = Any
JSON = dict[str, Any]
Point = tuple[float, float]


@dataclass(frozen=True)
class Wall:
    """A straight edge of a cushion at the nose's height; `inward` points to the playing area."""

    rail: str
    start: tuple[float, float]
    end: tuple[float, float]
    inward: tuple[float, float]
    part: str = "nose"


@dataclass(frozen=True)
class Post:
    """A round edge of a cushion between two ends, convex towards the playing area."""

    rail: str
    center: tuple[float, float]
    radius: float
    ends: tuple[tuple[float, float], tuple[float, float]]
    part: str = "point"


@dataclass(frozen=True)
class Hole:
    """A pocket: a hole in the slate, with a wall behind it up to the rails' tops.

    `wall` has the two ends of that wall, counter-clockwise, where the facings' lines meet it.
    """

    name: str
    center: tuple[float, float]
    radius: float
    wall: tuple[Point, Point]


@dataclass(frozen=True)
class World:
    """Everything in a shot that does not change.

    The rails' tops lie between the polygon of edges `inside` and the outer rectangle `border`
    (least x and y, largest x and y).
    """

    ids: list[str]
    mass: list[float]
    radius: list[float]
    physics: JSON
    nose_height: float = 0.0
    walls: list[Wall] = field(default_factory=list)
    posts: list[Post] = field(default_factory=list)
    holes: list[Hole] = field(default_factory=list)
    inside: list[Point] = field(default_factory=list)
    border: tuple[float, float, float, float] | None = None
    #: Numbers of the contacts of two balls that cling, counted from 0, and their friction.
    cling: tuple[tuple[int, ...], float] = ((), 0.0)

    @property
    def gravity(self) -> float:
        g: float = self.physics["gravity"]
        return g

    def law_of_balls(self, contact: int) -> JSON:
        """The law of this contact of two balls, counted from 0."""
        law: JSON = self.physics["ball_ball"]
        contacts, friction = self.cling
        return {**law, "friction": friction} if contact in contacts else law

    def law_of(self, part: str) -> JSON:
        """The law of a part of the rails: the cushion's, with the part's own surface."""
        cushion: JSON = self.physics["cushion"]
        if part in ("facing", "point"):
            return {**cushion, **self.physics.get("facing", {})}
        if part == "liner":
            return {**cushion, **self.physics["liner"]}
        return cushion


def world_of(shot: JSON, geometry: JSON | None = None, physics: JSON | None = None) -> World:
    """Reads a shot whose physics is written out in full, unless `physics` has the preset's numbers.

    The table is unbounded cloth or a plain rectangle, unless `geometry` gives its edges, holes,
    border and nose height.
    """
    physics = physics or shot["physics"]
    default = physics["ball"]
    table = shot["table"]
    shape: JSON = geometry or {}
    if not shape and table.get("cloth") != "unbounded":
        sizes = (table[k] for k in ("width", "length", "cushion_height", "rail_width"))
        shape = rectangle(*sizes)
    cling = shot.get("cling", {"contacts": []})
    return World(
        cling=(tuple(cling["contacts"]), cling.get("friction", CHALKED)),
        ids=[b["id"] for b in shot["balls"]],
        mass=[b.get("mass", default["mass"]) for b in shot["balls"]],
        radius=[b.get("radius", default["radius"]) for b in shot["balls"]],
        physics=physics,
        **shape,
    )


def rectangle(w: float, length: float, nose_height: float, rail_width: float) -> JSON:
    """The geometry of four straight rails."""
    return {
        "nose_height": nose_height,
        "walls": [
            Wall("bottom", (0.0, 0.0), (w, 0.0), (0.0, 1.0)),
            Wall("top", (0.0, length), (w, length), (0.0, -1.0)),
            Wall("left", (0.0, 0.0), (0.0, length), (1.0, 0.0)),
            Wall("right", (w, 0.0), (w, length), (-1.0, 0.0)),
        ],
        "inside": [(0.0, 0.0), (w, 0.0), (w, length), (0.0, length)],
        "border": _border((w, length), rail_width),
    }


def _border(size: Any, rail: float) -> tuple[float, float, float, float]:
    return (-rail, -rail, size[0] + rail, size[1] + rail)


#: The friction of a cling that has none of its own: chalk (docs/rails-and-balls.md).
CHALKED = 0.22

#: Number of straight pieces of an arc in the polygon `World.inside`. Their sagitta is below 10 µm,
#: which matters only where a ball touches exactly the line of an edge.
PIECES = 64


def geometry_of(table: JSON) -> JSON:
    """Edges and holes of a table from `carom.tables()`, which lists rails counter-clockwise.

    Each rail has its nose, between its points and, where it has them, its facings.
    """
    if not table["pockets"]:
        return rectangle(*table["size"], table["cushion_height"], table["rail_width"])
    rails = [list(group) for _, group in groupby(table["cushions"], key=lambda c: c["rail"])]
    walls: list[Wall] = []
    posts: list[Post] = []
    holes: list[Hole] = []
    inside: list[Point] = []
    for k, rail in enumerate(rails):
        nose = next(m for m, c in enumerate(rail) if c["part"] == "nose")
        for m, c in enumerate(rail):
            a, b = tuple(c["start"]), tuple(c["end"])
            # Pieces before the nose are listed from their ends at the nose.
            way = (b, a) if m < nose else (a, b)
            if "center" in c:
                posts.append(Post(c["rail"], tuple(c["center"]), c["radius"], (a, b)))
                inside += _arc(c["center"], *way)
            else:
                along = _direction(*way)
                walls.append(Wall(c["rail"], a, b, (-along[1], along[0]), c["part"]))
                inside += way
        # The next pocket: its liner continues behind both jaws and then around the hole.
        here, there = rail[-1], rails[(k + 1) % len(rails)][0]
        hole = min(table["pockets"], key=lambda h: math.dist(h["center"], here["end"]))
        ends = []
        for jaw, turn in ((here, 1), (there, -1)):
            deep, down = _deep_end(jaw)
            ends.append(_leaves(deep, down, hole))
            inward = (-turn * down[1], turn * down[0])
            walls.append(Wall(jaw["rail"], deep, ends[-1], inward, "liner"))
        center = tuple(hole["center"])
        holes.append(Hole(hole["name"], center, hole["radius"], (ends[0], ends[1])))
        inside += _arc(center, *ends, outward=True)
    return {
        "nose_height": table["cushion_height"],
        "walls": walls,
        "posts": posts,
        "holes": holes,
        "inside": inside,
        "border": _border(table["size"], table["rail_width"]),
    }


def _deep_end(jaw: JSON) -> tuple[Point, Point]:
    """The deep end of a jaw, and its direction there."""
    a, b = tuple(jaw["start"]), tuple(jaw["end"])
    if "center" not in jaw:
        return b, _direction(a, b)
    out = _direction(tuple(jaw["center"]), b)
    down = (-out[1], out[0])
    forward = down[0] * (b[0] - a[0]) + down[1] * (b[1] - a[1]) > 0.0
    return b, down if forward else (-down[0], -down[1])


def _leaves(deep: Point, down: Point, hole: JSON) -> Point:
    """The point where a line leaves the hole's disc."""
    d = (deep[0] - hole["center"][0], deep[1] - hole["center"][1])
    half = d[0] * down[0] + d[1] * down[1]
    square = half * half - (d[0] ** 2 + d[1] ** 2 - hole["radius"] ** 2)
    t = -half + math.sqrt(square)
    return (deep[0] + t * down[0], deep[1] + t * down[1])


def _arc(center: Any, a: Any, b: Any, outward: bool = False) -> list[Point]:
    """Points of the shorter arc from a to b; with `outward`, of the counter-clockwise arc."""
    start = math.atan2(a[1] - center[1], a[0] - center[0])
    turn = math.remainder(math.atan2(b[1] - center[1], b[0] - center[0]) - start, 2 * math.pi)
    if outward:
        turn %= 2 * math.pi
    r0, r1 = math.dist(a, center), math.dist(b, center)
    return [
        (
            center[0] + (r0 + (r1 - r0) * s) * math.cos(start + turn * s),
            center[1] + (r0 + (r1 - r0) * s) * math.sin(start + turn * s),
        )
        for s in (k / PIECES for k in range(PIECES + 1))
    ]


def _direction(a: Point, b: Point) -> Point:
    length = math.dist(a, b)
    return ((b[0] - a[0]) / length, (b[1] - a[1]) / length)


@dataclass(frozen=True)
class State:
    """A ball at one instant, as in a trace."""

    position: tuple[Number, Number, Number]
    velocity: tuple[Number, Number, Number]
    spin: tuple[Number, Number, Number]
    motion: str


@dataclass(frozen=True)
class Happening:
    """An event as in a trace; `key` identifies it without numbers.

    `gentle` contacts are so slow, or press so lightly, that the engine's rules for persistent
    contacts may decide their result.
    """

    time: Number
    key: tuple[str, ...]
    balls: tuple[str, ...]
    before: tuple[State, ...]
    after: tuple[State, ...]
    gentle: bool = False
    #: Speed along the contact's normal, m/s; 0 for other events.
    approach: Number = 0


def start_of(shot: JSON, played: JSON | None = None, physics: JSON | None = None) -> list[State]:
    """The balls at time 0; the struck ball in the state after the trace's strike `played`."""
    radius = (physics or shot["physics"])["ball"]["radius"]
    states = []
    for b in shot["balls"]:
        r = b.get("radius", radius)
        x, y, z = (*b["position"], r)[:3]
        v = tuple(b.get("velocity", (0.0, 0.0, 0.0)))
        w = tuple(b.get("angular_velocity", (0.0, 0.0, 0.0)))
        aloft = z > r or v[2] != 0.0
        states.append(State((x, y, z), v, w, "airborne" if aloft else motion_of(v, w, r)))
        if played is not None and played["balls"] == [b["id"]]:
            states[-1] = state_of(played["after"][0])
    return states


def motion_of(v: Any, w: Any, radius: Number, rounding: float = 1e-12) -> str:
    """The motion state of a ball from its velocities; slip below `rounding` of them counts as 0."""
    slip = (v[0] - radius * w[1]) ** 2 + (v[1] + radius * w[0]) ** 2
    speeds = v[0] ** 2 + v[1] ** 2 + radius**2 * (w[0] ** 2 + w[1] ** 2)
    if slip > rounding**2 * speeds:
        return "sliding"
    if v[0] != 0 or v[1] != 0:
        return "rolling"
    return "spinning" if w[2] != 0 else "stationary"


def state_of(item: JSON) -> State:
    """The state of a ball of a trace."""
    return State(
        tuple(item["position"]),
        tuple(item["velocity"]),
        tuple(item["angular_velocity"]),
        item["motion"],
    )


def key_of(event: JSON) -> tuple[str, ...]:
    """The key of an event: what happened, without numbers."""
    kind = event["type"]
    if kind == "rail-collision":
        # The top and the liner are one piece each here, while the engine names the nearest rail.
        rail = () if event["part"] in ("top", "liner") else (event["rail"],)
        return (kind, *event["balls"], *rail, event["part"])
    if kind == "motion-transition":
        return (kind, *event["balls"], event["from"], event["to"])
    if kind == "pocket-collision":
        return (kind, *event["balls"], event["pocket"])
    return (kind, *sorted(event["balls"]))
