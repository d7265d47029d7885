"""Helpers of the validation rows: build a shot, simulate it, read its events.

All of them use the public API (`carom.Shot.from_dict`, `simulate`, `to_dict`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

Vector = npt.NDArray[np.float64]
JSON = dict[str, Any]

FOOT = 0.3048
INCH = 0.0254
MPH = 0.44704
#: Alciatore's technical proofs use this gravity (m/s²) and this ball radius (m).
TP_GRAVITY = 9.807
TP_RADIUS = 1.125 * INCH
#: Alciatore's mass ratio ball/cue: 6 oz to 19 oz.
TP_MASS_RATIO = 6.0 / 19.0
#: TP A.14's slow, medium and fast shot, m/s (1, 3 and 7 mph).
TP_SPEEDS = {"slow": 0.447, "medium": 1.341, "fast": 3.129}
#: TP A.14's fit of ball–ball friction to slip speed (Marlow's data): μ = a + b·exp(−c·s).
TP_FRICTION: JSON = {"a": 0.009951, "b": 0.108, "c": 1.088}

UNBOUNDED: JSON = {"cloth": "unbounded"}


@dataclass(frozen=True)
class Ball:
    """A ball at one instant; the vectors are in SI units."""

    position: Vector
    velocity: Vector
    spin: Vector
    motion: str

    @property
    def speed(self) -> float:
        """Horizontal speed, m/s."""
        return math.hypot(self.velocity[0], self.velocity[1])

    @property
    def heading(self) -> float:
        """Direction of motion, counter-clockwise from +x, rad."""
        return math.atan2(self.velocity[1], self.velocity[0])


@dataclass(frozen=True)
class Event:
    """An event with the states of its balls before and after it, by id."""

    time: float
    type: str
    before: Mapping[str, Ball]
    after: Mapping[str, Ball]


@dataclass(frozen=True)
class Run:
    """A simulated shot."""

    trace: Any

    @cached_property
    def record(self) -> JSON:
        """The trace as `carom-trace/1`."""
        record: JSON = self.trace.to_dict()
        return record

    @cached_property
    def events(self) -> list[Event]:
        """All events in order."""
        return [
            Event(e["time"], e["type"], _balls(e["before"]), _balls(e["after"]))
            for e in self.record["events"]
        ]

    @cached_property
    def final(self) -> Mapping[str, Ball]:
        """The balls at the end."""
        return _balls(self.record["final"])

    def all(self, kind: str, ball: str | None = None) -> Iterator[Event]:
        """The events of one type, of one ball if given."""
        return (e for e in self.events if e.type == kind and (ball is None or ball in e.after))

    def first(self, kind: str, ball: str | None = None) -> Event:
        """The first event of one type, of one ball if given.

        Raises:
            LookupError: there is none.
        """
        for event in self.all(kind, ball):
            return event
        raise LookupError(f"no {kind} of ball {ball or 'any'} in {len(self.events)} events")

    def rolling(self, ball: str) -> Event:
        """The motion transition with which the ball starts to roll for the first time."""
        for event in self.all("motion-transition", ball):
            if event.after[ball].motion == "rolling":
                return event
        raise LookupError(f"ball {ball} never starts to roll")

    def final_roll(self, ball: str) -> Ball:
        """The ball after the last event that leaves it rolling: a transition or a bounce."""
        for event in reversed(self.events):
            if ball in event.after and event.after[ball].motion == "rolling":
                return event.after[ball]
        raise LookupError(f"ball {ball} never rolls")


def _balls(items: Sequence[JSON]) -> dict[str, Ball]:
    return {
        b["id"]: Ball(
            np.array(b["position"]),
            np.array(b["velocity"]),
            np.array(b["angular_velocity"]),
            b["motion"],
        )
        for b in items
    }


def ball(
    id: str = "cue",  # noqa: A002 -- the key of the shot file
    position: Sequence[float] | Vector = (0.0, 0.0),
    velocity: Sequence[float] | Vector = (0.0, 0.0, 0.0),
    spin: Sequence[float] | Vector = (0.0, 0.0, 0.0),
    **more: float,
) -> JSON:
    """A moving ball in the form of a shot file."""
    return {
        "id": id,
        "position": [float(x) for x in position],
        "velocity": [float(x) for x in velocity],
        "angular_velocity": [float(x) for x in spin],
        **more,
    }


def simulate(
    *balls: JSON,
    physics: JSON | str = "pool",
    table: JSON | str | None = None,
    strike: JSON | None = None,
    cling: JSON | None = None,
) -> Run:
    """Simulates balls that move from the start, or a strike; on unbounded cloth by default.

    `strike` and `cling` are those keys of a shot file.
    """
    shot: JSON = {
        "format": "carom-shot/1",
        "table": UNBOUNDED if table is None else table,
        "physics": physics,
        "balls": list(balls),
    }
    if strike is not None:
        shot["strike"] = strike
        for b in shot["balls"]:
            if b["id"] == strike["ball"]:
                del b["velocity"], b["angular_velocity"]
    if cling is not None:
        shot["cling"] = cling
    return Run(carom.Shot.from_dict(shot).simulate())


def tp_physics(**sections: JSON) -> JSON:
    """The `pool` preset with Alciatore's constants: μ_s = 0.2, μ_r = 0.01, his g and R."""
    merged: JSON = {
        "base": "pool",
        "gravity": TP_GRAVITY,
        "ball": {"radius": TP_RADIUS, "mass": 6 * 0.0283495},
        "cloth": {"sliding_friction": 0.2, "rolling_friction": 0.01},
    }
    for name, section in sections.items():
        merged[name] = {**merged.get(name, {}), **section}
    return merged


def touching(cut: float, radius: float, distance: float | None = None) -> tuple[float, float]:
    """The position of an object ball that touches a cue ball at the origin moving along +y.

    `cut` (rad) > 0 drives the object ball to the left of the cue ball's path. `distance` (m) is
    that of the centres; by default they touch.
    """
    d = 2 * radius if distance is None else distance
    return (-d * math.sin(cut), d * math.cos(cut))


def degrees_between(a: float, b: float) -> float:
    """a − b in degrees, in (−180, 180]."""
    return math.degrees(math.remainder(a - b, 2 * math.pi))


def maximum(
    f: Callable[[float], float], low: float, high: float, width: float = 1e-7
) -> tuple[float, float]:
    """The x in [low, high] at which a function with one maximum is largest, and the value there.

    Golden-section search, to `width` in x.
    """
    ratio = (math.sqrt(5.0) - 1.0) / 2.0
    a, b = low, high
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    fc, fd = f(c), f(d)
    while b - a > width:
        if fc >= fd:
            b, d, fd = d, c, fc
            c = b - ratio * (b - a)
            fc = f(c)
        else:
            a, c, fc = c, d, fd
            d = a + ratio * (b - a)
            fd = f(d)
    x = 0.5 * (a + b)
    return x, f(x)


def crossing(f: Callable[[float], float], low: float, high: float, width: float = 1e-13) -> float:
    """The x between low and high at which f changes sign, by bisection to `width`.

    Raises:
        ValueError: f has the same sign at both ends.
    """
    f_low = f(low)
    if f_low * f(high) > 0.0:
        raise ValueError(f"no sign change between {low} and {high}")
    while high - low > width:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if f_low * f(middle) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
