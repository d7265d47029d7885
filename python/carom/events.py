"""The parts of a trace with their types: events, the states of balls, the outcome.

Each is a dict, as ``carom-trace/1`` has it, whose keys are also attributes. A test compares them
with the JSON Schema of the trace (``carom schema trace``).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, Literal, TypeAlias

from carom.record import Record

Motion: TypeAlias = Literal[
    "stationary", "spinning", "rolling", "sliding", "airborne", "pocketed", "off-table"
]
RailName: TypeAlias = Literal[
    "bottom", "top", "left", "right", "left-lower", "left-upper", "right-lower", "right-upper"
]
PocketName: TypeAlias = Literal[
    "bottom-left", "bottom-right", "left", "right", "top-left", "top-right"
]
CushionPart: TypeAlias = Literal["nose", "facing", "point", "top", "liner"]


class BallState(Record):
    """A ball at one instant.

    Attributes:
        id: The ball's id.
        position: Centre, m, three numbers.
        velocity: m/s.
        angular_velocity: rad/s.
        motion: How it moves.
    """

    __slots__ = ()

    id: str
    position: list[float]
    velocity: list[float]
    angular_velocity: list[float]
    motion: Motion


class _Event(Record):
    """What all events have.

    Attributes:
        time: Time since the strike, s.
        balls: Ids of the balls in it.
        before: These balls just before.
        after: These balls just after.
    """

    __slots__ = ()

    time: float
    balls: list[str]
    before: list[BallState]
    after: list[BallState]


class _Impact(_Event):
    """What impacts have besides.

    Attributes:
        impulses: The change of each ball's momentum, N s, in the order of ``balls``.
        points: The points of contact, m; in a strike that of the tip comes first.
    """

    __slots__ = ()

    # Traces of early engines lack these keys.
    _DEFAULTS: ClassVar = {"impulses": (), "points": ()}

    impulses: Sequence[list[float]]
    points: Sequence[list[float]]


class CueStrike(_Impact):
    """The cue meets the cue ball; balls that it moves at the same instant belong to the event.

    Attributes:
        tip_contacts: How often the tip met the cue ball.
        pushed: Whether the cue ball met a ball that it did not touch before while the tip was on
            it.
    """

    __slots__ = ()

    _DEFAULTS: ClassVar = {**_Impact._DEFAULTS, "tip_contacts": 1, "pushed": False}

    type: Literal["cue-strike"]
    tip_contacts: int
    pushed: bool


class BallCollision(_Impact):
    """Two balls collide, or several in one many-ball contact."""

    __slots__ = ()

    type: Literal["ball-collision"]


class RailCollision(_Impact):
    """A ball meets a cushion."""

    __slots__ = ()

    type: Literal["rail-collision"]
    rail: RailName
    part: CushionPart


class MotionTransition(_Event):
    """A motion ends by the passage of time.

    Attributes:
        from_: The motion that ends; the key is ``from``.
        to: The motion that begins.
    """

    __slots__ = ()

    type: Literal["motion-transition"]
    from_: Motion
    to: Motion


class PocketCollision(_Event):
    """A ball falls into a pocket."""

    __slots__ = ()

    type: Literal["pocket-collision"]
    pocket: PocketName


class SlateCollision(_Impact):
    """A ball bounces on the slate, or on the edge of a hole in it."""

    __slots__ = ()

    type: Literal["slate-collision"]


class OffTable(_Event):
    """A ball crosses the border of the rails, or comes to rest on a rail."""

    __slots__ = ()

    type: Literal["off-table"]


TraceEvent: TypeAlias = (
    CueStrike
    | BallCollision
    | RailCollision
    | MotionTransition
    | PocketCollision
    | SlateCollision
    | OffTable
)

_EVENTS: dict[str, type[TraceEvent]] = {
    "cue-strike": CueStrike,
    "ball-collision": BallCollision,
    "rail-collision": RailCollision,
    "motion-transition": MotionTransition,
    "pocket-collision": PocketCollision,
    "slate-collision": SlateCollision,
    "off-table": OffTable,
}


def event(entry: Mapping[str, Any]) -> TraceEvent:
    """The event of a trace's entry."""
    states = {side: [BallState(state) for state in entry[side]] for side in ("before", "after")}
    return _EVENTS[entry["type"]]({**entry, **states})


class Outcome(Record):
    """What a referee needs of a shot. Lists are in the order of time.

    Attributes:
        cue_ball: The struck ball; without a strike the ball ``cue``; None if there is none.
        first_contact: The first ball that the cue ball touched; None if it touched none.
        pocketed: Balls and their pockets.
        cue_ball_scratched: Whether the cue ball was pocketed.
        off_table: Balls that left the table.
        hanging: Balls at rest over the edge of a pocket's hole, with that pocket.
        jumped: Balls in the air, with the balls over which they flew without touching them.
        rails_before_first_contact: Rails that the cue ball touched before any ball.
        rails_after_first_contact: For each ball the rails that it touched after the first contact.
        driven_to_rail: Balls that were driven to a rail.
        cue_ball_touched: What the cue ball touched: ``{"ball": id}`` or ``{"rail": name}``.
        tip_contacts: How often the tip met the cue ball; more than once in a double hit.
        pushed: Whether the cue ball met a ball that it did not touch before while the tip was on
            it.
        met_during_strike: Balls that the cue ball met during the strike.
        never_resting: Balls that never come to rest, because friction is zero.
        miscue: Whether the tip would slip off the ball.
        cue_obstructed: The ball or rail that the cue would pass through; None if there is none.
        least_elevation_deg: The least elevation at which it would not, degrees; None if there is
            none.
        events: Number of events.
    """

    __slots__ = ()

    cue_ball: str | None
    first_contact: str | None
    pocketed: list[list[str]]
    cue_ball_scratched: bool
    off_table: list[str]
    hanging: list[list[str]]
    jumped: list[list[str]]
    rails_before_first_contact: list[RailName]
    rails_after_first_contact: dict[str, list[RailName]]
    driven_to_rail: list[str]
    cue_ball_touched: list[dict[Literal["ball", "rail"], str]]
    tip_contacts: int
    pushed: bool
    met_during_strike: list[str]
    never_resting: list[str]
    miscue: bool
    cue_obstructed: str | None
    least_elevation_deg: float | None
    events: int
