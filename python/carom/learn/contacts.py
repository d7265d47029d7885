"""What caused the kinks of the tracks: rails and other balls."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn.header import TracksHeader
from carom.learn.kinks import Kink, Path
from carom.learn.pieces import Motion
from carom.learn.rails import Cushion, cushions_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Vector = tuple[float, float]

# How far a contact's place may be from where its cushion or its other ball says, m, besides the
# errors of the track: cushions that are not straight, a frame that is some millimetres off.
_RAIL_TOLERANCE = 0.012
_BALL_TOLERANCE = 0.010
# Standard deviations of the track that come on top.
_SIGMAS = 4.0
# The cosine of the angle between a change of velocity and the normal: friction turns the impulse by
# at most 25°, and a velocity after few samples is uncertain.
_ALONG_RAIL = 0.7
_ALONG_BALLS = 0.7
# Without a kink of the other ball the line of centres must fit better, and the change be larger
# than this, m/s.
_ALONG_ALONE = 0.9
_CHANGE_ALONE = 0.1
# Kinks of two balls belong together within this time, s, and this number of standard deviations.
_SAME_TIME = 0.02


#: Contacts of the same balls, or of a ball with the same rail, within this time, s, are one.
ONE = 0.03
# A change of velocity without a cause counts from this, m/s, and this number of standard
# deviations: a cut at the end of sliding that is some samples off looks like a small one.
_UNKNOWN_CHANGE = 0.25
_UNKNOWN_SIGMAS = 8.0
# Instants at which a path is looked at for a second contact between two samples.
_INSTANTS = 41


@dataclass(frozen=True, slots=True)
class Contact:
    """A contact that changed the velocity of a ball, or of two.

    Attributes:
        time: s, on the clock of the tracks.
        time_sigma: Its standard deviation, s, from the errors of the samples alone.
        balls: The balls: one and a rail, two, or one alone if the cause is unknown.
        rail: Name of the rail, as in traces; None without one.
        place: Centre of each ball, m.
        before: Velocity of each ball just before, m/s.
        after: Velocity of each ball just after, m/s.
        is_known: Whether a rail or another ball explains it.
    """

    time: float
    time_sigma: float
    balls: tuple[str, ...]
    rail: str | None
    place: Mapping[str, Vector]
    before: Mapping[str, Vector]
    after: Mapping[str, Vector]
    is_known: bool = True

    @property
    def change(self) -> float:
        """The largest change of a ball's velocity, m/s."""
        return max(math.dist(self.before[ball], self.after[ball]) for ball in self.balls)


@dataclass(frozen=True, slots=True)
class Found:
    """The contacts of a shot.

    Attributes:
        contacts: In order of time.
        before: Index of the contact at whose end a motion begins, by ball and last sample of the
            kink.
        after: Index of the contact at which a motion ends, likewise.
    """

    contacts: list[Contact]
    before: dict[tuple[str, int], int]
    after: dict[tuple[str, int], int]


@dataclass(frozen=True, slots=True)
class _Cause:
    """A contact, and its kinks with the side of each: what ends in it, what begins, or both."""

    contact: Contact
    kinks: list[tuple[Kink, bool, bool]]


def contacts_of(
    paths: Mapping[str, Path], header: TracksHeader, struck: str | None, start: float
) -> Found:
    """The contacts behind the kinks of a shot.

    Args:
        paths: The balls' paths.
        header: Table and radius.
        struck: The ball that was struck.
        start: Time of the strike, s.
    """
    kinks = sorted((k for path in paths.values() for k in path.kinks), key=lambda k: k.time)
    cushions = cushions_of(header)
    radius = header.radius
    causes = _plain(kinks, cushions, radius)
    done = {id(kink) for cause in causes for kink, _, _ in cause.kinks}
    for kink in kinks:
        if id(kink) in done:
            continue
        strike = kink.starts and kink.ball == struck and kink.time == start
        if kink.meets:
            if strike:
                continue
            alone = None if radius is None else _with_still_ball(kink, paths, radius)
            if alone is not None:
                causes.append(alone)
                continue
        more = _two_contacts(kink, paths, cushions, radius, strike=strike)
        causes += more
        size = float(np.hypot(*kink.change))
        error = math.hypot(
            kink.before.velocity_sigma(kink.time), kink.after.velocity_sigma(kink.time)
        )
        if not more and not strike and size > max(_UNKNOWN_CHANGE, _UNKNOWN_SIGMAS * error):
            causes.append(_Cause(_of_one(kink, None), [(kink, True, True)]))
    return _numbered(_without_repeats(causes))


def _plain(kinks: list[Kink], cushions: list[Cushion], radius: float | None) -> list[_Cause]:
    """The kinks that one rail or one other kink explains, the best explanations first."""
    possible: list[tuple[float, int, int, Contact, list[Kink]]] = []
    for i, kink in enumerate(kinks):
        if kink.meets:
            for cushion in cushions:
                misfit = _rail_misfit(kink, cushion)
                if misfit is not None:
                    possible.append((misfit, i, -1, _of_one(kink, cushion.rail), [kink]))
        for j in range(i + 1, len(kinks)):
            other = kinks[j]
            if radius is None or other.ball == kink.ball or not (kink.meets or other.meets):
                continue
            misfit = _pair_misfit(kink, other, radius)
            if misfit is not None:
                possible.append((misfit, i, j, _of_two(kink, other), [kink, other]))
    used: set[int] = set()
    causes = []
    for _, i, j, contact, own in sorted(possible, key=lambda item: item[:3]):
        if i in used or j in used:
            continue
        used |= {i, j} - {-1}
        causes.append(_Cause(contact, [(kink, True, True) for kink in own if kink.meets]))
    return causes


def _with_still_ball(kink: Kink, paths: Mapping[str, Path], radius: float) -> _Cause | None:
    """The contact with a ball whose own change of velocity was not seen."""
    best: tuple[float, _Cause] | None = None
    for ball, path in paths.items():
        if ball == kink.ball:
            continue
        misfit = _alone_misfit(kink, path, radius)
        if misfit is not None and (best is None or misfit < best[0]):
            best = misfit, _Cause(_of_pair(kink, path), [(kink, True, True)])
    return None if best is None else best[1]


def _two_contacts(
    kink: Kink,
    paths: Mapping[str, Path],
    cushions: list[Cushion],
    radius: float | None,
    *,
    strike: bool,
) -> list[_Cause]:
    """The contacts between two motions that do not meet.

    The motion before leads to the first contact, and the one after it comes from the last. What the
    ball did between them is too short to be seen.
    """
    track = paths[kink.ball].track
    low, high = float(track.time[kink.last]), float(track.time[kink.next])
    first = None
    if not kink.starts:
        first = _met(kink, kink.before, (low, high), paths, cushions, radius, ends=True)
    elif not strike:
        first = _met(kink, kink.before, (low, high), paths, [], radius, ends=True)
    last = _met(kink, kink.after, (low, high), paths, cushions, radius, ends=False)
    if first is not None and last is not None:
        same = first.balls == last.balls and first.rail == last.rail
        if same or first.time > last.time:
            # One of them is what happened, if the other is the same seen from its other side.
            last = None
    causes = []
    if first is not None:
        causes.append(_Cause(first, [(kink, True, last is None)]))
    if last is not None:
        causes.append(_Cause(last, [(kink, first is None and not strike, True)]))
    return causes


def _met(
    kink: Kink,
    motion: Motion,
    window: tuple[float, float],
    paths: Mapping[str, Path],
    cushions: list[Cushion],
    radius: float | None,
    *,
    ends: bool,
) -> Contact | None:
    """What a motion meets at its end, or leaves at its beginning, within a window of time."""
    times = np.linspace(*window, _INSTANTS)
    places = np.array([motion.place(time) for time in times])
    side = -1.0 if ends else 1.0
    found: list[tuple[float, Contact]] = []
    ball = kink.ball

    def contact(time: float, balls: tuple[str, ...], rail: str | None, other: Path | None) -> None:
        place = {ball: _pair(motion.place(time))}
        before = {ball: _pair(motion.velocity(time) if ends else kink.incoming)}
        after = {ball: _pair(kink.outgoing if ends else motion.velocity(time))}
        if other is not None:
            was, now = other.motion(time, before=True), other.motion(time, before=False)
            place[other.ball] = _pair(was.place(time))
            before[other.ball] = _pair(was.velocity(time))
            after[other.ball] = _pair(now.velocity(time))
        size = max(float(np.hypot(*motion.velocity(time))), 1e-3)
        error = motion.place_sigma(time) / size
        found.append((time, Contact(time, error, balls, rail, place, before, after)))

    for cushion in cushions:
        distances = np.array([cushion.contact(place)[0] for place in places])
        time = _crossing(times, distances, _RAIL_TOLERANCE, last=not ends)
        if time is None:
            continue
        away = cushion.contact(motion.place(time))[1]
        if side * float(motion.velocity(time) @ away) > 0.0:
            contact(time, (ball,), cushion.rail, None)
    for other in paths.values() if radius is not None else ():
        if other.ball == ball:
            continue
        lines = places - np.array([other.motion(time, before=ends).place(time) for time in times])
        assert radius is not None
        distances = np.hypot(*lines.T) - 2.0 * radius
        time = _crossing(times, distances, _BALL_TOLERANCE, last=not ends)
        if time is None:
            continue
        theirs = other.motion(time, before=ends)
        line = motion.place(time) - theirs.place(time)
        speed = float((motion.velocity(time) - theirs.velocity(time)) @ line)
        if side * speed > 0.0:
            contact(time, (ball, other.ball), None, other)
    if not found:
        return None
    # A motion ends at the first thing that it meets, and began at the last that it left.
    time, best = min(found, key=lambda item: item[0]) if ends else max(found, key=lambda i: i[0])
    return best


def _crossing(times: Floats, distances: Floats, tolerance: float, *, last: bool) -> float | None:
    """When a distance passes zero, or comes nearest to it within a tolerance; None if neither."""
    changes = np.flatnonzero(distances[:-1] * distances[1:] <= 0.0)
    if changes.size:
        index = int(changes[-1] if last else changes[0])
        a, b = distances[index], distances[index + 1]
        share = 0.0 if a == b else float(a / (a - b))
        return float(times[index] + share * (times[index + 1] - times[index]))
    index = int(np.argmin(np.abs(distances)))
    return float(times[index]) if abs(distances[index]) <= tolerance else None


def _without_repeats(causes: list[_Cause]) -> list[_Cause]:
    """The causes without contacts that both balls, or two kinks at one rail, have found."""
    kept: list[_Cause] = []
    for cause in sorted(causes, key=lambda c: (c.contact.time, -len(c.kinks))):
        own = cause.contact
        same = next(
            (
                k
                for k in kept
                if (len(own.balls) == 2 or own.rail is not None)
                and set(k.contact.balls) == set(own.balls)
                and k.contact.rail == own.rail
                and own.time - k.contact.time < ONE
            ),
            None,
        )
        if same is None:
            kept.append(cause)
        else:
            same.kinks.extend(cause.kinks)
    return kept


def _numbered(causes: list[_Cause]) -> Found:
    before: dict[tuple[str, int], int] = {}
    after: dict[tuple[str, int], int] = {}
    for number, cause in enumerate(causes):
        for kink, ends, begins in cause.kinks:
            if ends:
                after[kink.ball, kink.last] = number
            if begins:
                before[kink.ball, kink.last] = number
    return Found([cause.contact for cause in causes], before, after)


def _rail_misfit(kink: Kink, cushion: Cushion) -> float | None:
    """Distance from the cushion in parts of the tolerance; None if it is not the cause."""
    if kink.starts:
        return None  # a rail moves no ball that rests
    distance, away = cushion.contact(kink.place)
    tolerance = _RAIL_TOLERANCE + _SIGMAS * kink.place_sigma
    change = kink.change
    size = float(np.hypot(*change))
    if abs(distance) > tolerance or float(change @ away) < _ALONG_RAIL * size:
        return None
    if float(kink.incoming @ away) > 0.1 * size:
        return None
    return abs(distance) / tolerance


def _pair_misfit(kink: Kink, other: Kink, radius: float) -> float | None:
    """Difference from a contact of both balls in parts of the tolerance; None if it is none."""
    apart = abs(kink.time - other.time)
    if apart > _SAME_TIME + _SIGMAS * math.hypot(kink.sigma, other.sigma):
        return None
    time = _common_time(kink, other)
    a, b = _place_at(kink, time), _place_at(other, time)
    line = b - a
    distance = float(np.hypot(*line))
    faster = max(float(np.hypot(*kink.incoming)), float(np.hypot(*other.incoming)))
    tolerance = _BALL_TOLERANCE + _SIGMAS * math.hypot(
        kink.place_sigma, other.place_sigma, faster * min(kink.sigma, other.sigma)
    )
    if abs(distance - 2.0 * radius) > tolerance:
        return None
    along = line / distance
    # The balls push each other apart; of the lighter change the direction is uncertain.
    main = max(
        -float(kink.change @ along) / float(np.hypot(*kink.change)),
        float(other.change @ along) / float(np.hypot(*other.change)),
    )
    if main < _ALONG_BALLS:
        return None
    return abs(distance - 2.0 * radius) / tolerance + (1.0 - main)


def _alone_misfit(kink: Kink, path: Path, radius: float) -> float | None:
    """As ``_pair_misfit``, with a ball whose own change was not seen."""
    if float(np.hypot(*kink.change)) < _CHANGE_ALONE:
        return None
    time = path.track.time
    if not time[0] - 0.1 <= kink.time <= time[-1] + 0.1:
        return None
    motion = path.motion(kink.time, before=True)
    line = motion.place(kink.time) - kink.place
    distance = float(np.hypot(*line))
    tolerance = _BALL_TOLERANCE + _SIGMAS * math.hypot(
        kink.place_sigma, motion.place_sigma(kink.time)
    )
    if abs(distance - 2.0 * radius) > tolerance:
        return None
    along = -float(kink.change @ line) / distance / float(np.hypot(*kink.change))
    if along < _ALONG_ALONE:
        return None
    return abs(distance - 2.0 * radius) / tolerance + (1.0 - along)


def _common_time(kink: Kink, other: Kink) -> float:
    """The mean of both times with the weights of their variances."""
    a, b = max(kink.sigma, 1e-6) ** -2, max(other.sigma, 1e-6) ** -2
    return (kink.time * a + other.time * b) / (a + b)


def _place_at(kink: Kink, time: float) -> Floats:
    """The ball's place just before a contact at this time."""
    motion = kink.before
    if kink.before.place_sigma(time) > kink.after.place_sigma(time):
        motion = kink.after
    return motion.place(time)


def _pair(values: Floats) -> Vector:
    return float(values[0]), float(values[1])


def _of_one(kink: Kink, rail: str | None) -> Contact:
    ball = kink.ball
    return Contact(
        kink.time,
        kink.sigma,
        (ball,),
        rail,
        {ball: _pair(kink.place)},
        {ball: _pair(kink.incoming)},
        {ball: _pair(kink.outgoing)},
        is_known=rail is not None,
    )


def _of_two(kink: Kink, other: Kink) -> Contact:
    time = _common_time(kink, other)
    sigma = 1.0 / math.hypot(1.0 / max(kink.sigma, 1e-6), 1.0 / max(other.sigma, 1e-6))
    both = (kink, other)
    return Contact(
        time,
        sigma,
        (kink.ball, other.ball),
        None,
        {k.ball: _pair(_place_at(k, time)) for k in both},
        {k.ball: _pair(k.before.velocity(time)) for k in both},
        {k.ball: _pair(k.after.velocity(time)) for k in both},
    )


def _of_pair(kink: Kink, path: Path) -> Contact:
    before = path.motion(kink.time, before=True)
    after = path.motion(kink.time, before=False)
    return Contact(
        kink.time,
        kink.sigma,
        (kink.ball, path.ball),
        None,
        {kink.ball: _pair(kink.place), path.ball: _pair(before.place(kink.time))},
        {kink.ball: _pair(kink.incoming), path.ball: _pair(before.velocity(kink.time))},
        {kink.ball: _pair(kink.outgoing), path.ball: _pair(after.velocity(kink.time))},
    )
