"""Follows a trace with an oracle and measures their differences event by event."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from oracles.world import Happening, State, World, key_of, state_of

if TYPE_CHECKING:
    from collections.abc import Sequence

JSON = dict[str, Any]

#: Events closer in time than this, s, may be listed in either order.
TIE = 1e-9


@dataclass
class Worst:
    """The largest differences: of times in s, of states in m, m/s and m/s (spin × radius)."""

    time: float = 0.0
    before: float = 0.0
    after: float = 0.0
    events: int = 0
    where: str = ""
    #: Differences after the impacts of each type of event that is `apart` from the rest, as
    #: fractions of the approach speed.
    impacts: dict[str, list[float]] = field(default_factory=dict)

    @property
    def largest(self) -> float:
        return max(self.time, self.before, self.after)


def differ(a: State, b: State, radius: float) -> float:
    """Largest difference of position, velocity, and spin × radius."""
    return float(
        max(
            *(abs(p - q) for p, q in zip(a.position, b.position, strict=True)),
            *(abs(p - q) for p, q in zip(a.velocity, b.velocity, strict=True)),
            *(radius * abs(p - q) for p, q in zip(a.spin, b.spin, strict=True)),
        )
    )


def follow(
    oracle: Any,
    world: World,
    events: Sequence[JSON],
    resync: bool,
    limit: int | None = None,
    apart: Sequence[str] = (),
) -> Worst:
    """Compares each event of the oracle with the trace's.

    With `resync` the oracle takes over the trace's states after each event, so that each event is
    compared separately; without it, differences grow from event to event. `apart` has the types of
    impacts that the engine integrates numerically: their results are kept apart.

    Raises:
        AssertionError: The oracle finds another event than the trace has.
    """
    worst = Worst()
    waiting = [e for e in events if e["type"] != "cue-strike"]
    index = {name: i for i, name in enumerate(world.ids)}
    while waiting and (limit is None or worst.events < limit):
        seen = oracle.next()
        assert seen is not None, f"at rest before {key_of(waiting[0])} at {waiting[0]['time']}"
        event = _match(seen, waiting)
        worst.events += 1
        radii = {name: world.radius[index[name]] for name in seen.balls}
        trace_before = dict(zip(event["balls"], map(state_of, event["before"]), strict=True))
        trace_after = dict(zip(event["balls"], map(state_of, event["after"]), strict=True))
        before = max(
            differ(s, trace_before[b], radii[b])
            for b, s in zip(seen.balls, seen.before, strict=True)
        )
        after = 0.0
        if not seen.gentle and seen.key[0] != "pocket-collision":
            after = max(
                differ(s, trace_after[b], radii[b])
                for b, s in zip(seen.balls, seen.after, strict=True)
            )
        if seen.key[0] in apart and not seen.gentle:
            part = after / float(seen.approach)
            worst.impacts.setdefault(seen.key[0], []).append(part)
            after = 0.0
        time = abs(float(seen.time - event["time"]))
        if max(time, before, after) > worst.largest:
            worst.where = f"{seen.key} at {float(seen.time):.6f} s"
        worst.time = max(worst.time, time)
        worst.before, worst.after = max(worst.before, before), max(worst.after, after)
        if resync:
            for b in seen.balls:
                oracle.replace(index[b], trace_after[b])
    return worst


def _match(seen: Happening, waiting: list[JSON]) -> JSON:
    for k, event in enumerate(waiting):
        if key_of(event) == seen.key:
            return waiting.pop(k)
        if event["time"] - waiting[0]["time"] > TIE:
            break
    raise AssertionError(
        f"the oracle finds {seen.key} at {float(seen.time)!r}, "
        f"the trace {key_of(waiting[0])} at {waiting[0]['time']!r}"
    )


def trace_of(oracle: Any, limit: int = 10_000) -> list[JSON]:
    """The oracle's own events, in the form of a `carom-trace/1`."""
    found: list[JSON] = []
    while len(found) < limit and (event := oracle.next()) is not None:
        item: JSON = {"time": float(event.time), "type": event.key[0], "balls": [*event.balls]}
        if event.key[0] == "motion-transition":
            item |= {"from": event.key[2], "to": event.key[3]}
        elif event.key[0] == "rail-collision":
            item |= {"rail": event.key[2], "part": event.key[-1]}
        elif event.key[0] == "pocket-collision":
            item |= {"pocket": event.key[2]}
        for name, states in (("before", event.before), ("after", event.after)):
            item[name] = [
                {
                    "id": b,
                    "position": [float(x) for x in s.position],
                    "velocity": [float(x) for x in s.velocity],
                    "angular_velocity": [float(x) for x in s.spin],
                    "motion": s.motion,
                }
                for b, s in zip(event.balls, states, strict=True)
            ]
        found.append(item)
    return found
