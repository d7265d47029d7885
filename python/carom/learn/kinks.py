"""Kinks: the instants at which the velocity of one ball changes, from its track alone."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from carom.lazy import np
from carom.learn.pieces import Motion, cut, motion_at_end, resting

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.learn.tracks import TrackedBall

    Floats = NDArray[np.float64]

# A change of velocity counts from this many standard deviations...
_SIGMAS = 4.0
# ... and from this, m/s: the rolling resistance, the slope of a table and the distortion of a lens
# change a velocity slowly, and a cut there is not a contact.
_LEAST_CHANGE = 0.03
# A piece whose mean velocity is below this, m/s, or this many standard deviations, is at rest.
_REST_SPEED = 0.01
_REST_SIGMAS = 3.0
# A single sample that is separated from the next ones by this time, s, was one of a ball at rest
# under a sampling rule.
_REST_GAP = 0.1
# A ball that began to move after this share of the first step was at rest in the first sample.
_LATE = 0.25
# The kink may lie outside the samples on its sides by this time, s, and this number of steps of
# samples.
_SLACK = 0.02
_SLACK_STEPS = 2.0
_NEWTON = 12


@dataclass(frozen=True, slots=True)
class Kink:
    """A change of a ball's velocity.

    Attributes:
        ball: The ball.
        time: s.
        sigma: Standard deviation of the time, s.
        before: The motion before it.
        after: The motion after it.
        last: The last sample before it, an index into the samples in which the ball was seen.
        next: The first sample of the motion after it; samples between are those of a motion too
            short to be known.
        meets: Whether both motions meet in it: if not, more than one contact lies between them.
        starts: Whether the ball was at rest before.
    """

    ball: str
    time: float
    sigma: float
    before: Motion
    after: Motion
    last: int
    next: int
    meets: bool
    starts: bool

    @property
    def place(self) -> Floats:
        """The centre of the ball, m: that of the motion that is known better."""
        a, b = self.before, self.after
        va, vb = a.place_sigma(self.time) ** 2, b.place_sigma(self.time) ** 2
        mean: Floats = (a.place(self.time) * vb + b.place(self.time) * va) / (va + vb)
        return mean

    @property
    def place_sigma(self) -> float:
        """Standard deviation of a coordinate of the place, m."""
        a, b = self.before.place_sigma(self.time), self.after.place_sigma(self.time)
        return a * b / math.hypot(a, b)

    @property
    def incoming(self) -> Floats:
        """Velocity just before, m/s."""
        return self.before.velocity(self.time)

    @property
    def outgoing(self) -> Floats:
        """Velocity just after, m/s."""
        return self.after.velocity(self.time)

    @property
    def change(self) -> Floats:
        """Change of the velocity, m/s."""
        found: Floats = self.outgoing - self.incoming
        return found


@dataclass(frozen=True, slots=True)
class Path:
    """The track of a ball, cut into pieces, and its kinks.

    Attributes:
        ball: The ball's id.
        track: The samples in which it was seen.
        sigma: Of each sample, m.
        pieces: First and last sample of each piece.
        rests: Whether the ball is at rest in each piece.
        kinks: In order of time.
    """

    ball: str
    track: TrackedBall
    sigma: Floats
    pieces: list[tuple[int, int]]
    rests: list[bool]
    kinks: list[Kink]

    def motion(self, time: float, *, before: bool) -> Motion:
        """The motion at a time: that before or after a kink in this instant."""
        index = 0
        for kink in self.kinks:
            if kink.time > time or (before and kink.time >= time):
                break
            index = kink.next
        number = next(i for i, (first, last) in enumerate(self.pieces) if first <= index <= last)
        while number + 1 < len(self.pieces):
            first, last = self.pieces[number]
            if self.track.time[last] >= time or self._is_kinked(last):
                break
            number += 1
        first, last = self.pieces[number]
        middle = 0.5 * (self.track.time[first] + self.track.time[last])
        return _motion(
            self.track, self.sigma, (first, last), self.rests[number], end=bool(time > middle)
        )

    def _is_kinked(self, last: int) -> bool:
        return any(kink.last == last for kink in self.kinks)


def path_of(ball: str, track: TrackedBall, sigma: Floats) -> Path:
    """Cut the track of a ball at its kinks.

    Args:
        ball: The ball's id.
        track: Its samples; all must be visible.
        sigma: Of each sample, m.
    """
    first = int(_starts_late(track, sigma))
    pieces = cut(track.time[first:], track.position[first:], sigma[first:])
    pieces = [(0, 0)] * first + [(a + first, b + first) for a, b in pieces]
    pieces = _joined_rests(track, sigma, pieces)
    rests = [_rests(track, sigma, pieces, number) for number in range(len(pieces))]
    kinks: list[Kink] = []
    known = [
        number
        for number, (first, last) in enumerate(pieces)
        if rests[number] or last > first or number in (0, len(pieces) - 1)
    ]
    for number, following in pairwise(known):
        kink = _kink(ball, track, sigma, pieces, rests, (number, following))
        if kink is not None and (not kinks or kink.time > kinks[-1].time):
            kinks.append(kink)
    return Path(ball, track, sigma, pieces, rests, kinks)


def _joined_rests(
    track: TrackedBall, sigma: Floats, pieces: list[tuple[int, int]]
) -> list[tuple[int, int]]:
    """Neighbouring pieces at rest at the same place, joined: a long rest is cut into several."""
    found: list[tuple[int, int]] = []
    for piece in pieces:
        if found:
            joined = (found[-1][0], piece[1])
            both = _is_still(track, sigma, found[-1]) and _is_still(track, sigma, piece)
            if both and _is_still(track, sigma, joined):
                found[-1] = joined
                continue
        found.append(piece)
    return found


def _starts_late(track: TrackedBall, sigma: Floats) -> bool:
    """Whether the ball was at rest in its first sample alone, and began to move later.

    Then it reaches its second place sooner after the first one than the time between them.
    """
    if len(track) < 3:
        return False
    wait, step = np.diff(track.time[:3])
    way, further = np.hypot(*np.diff(track.position[:3], axis=0).T)
    if further < _SIGMAS * sigma[1]:
        return False
    late = wait - way * step / further
    return bool(late > _LATE * wait and late * further / step > _SIGMAS * 1.5 * sigma[0])


def _is_still(track: TrackedBall, sigma: Floats, piece: tuple[int, int]) -> bool:
    first, last = piece
    if first == last:
        return False
    place, error = track.position[first : last + 1], sigma[first : last + 1]
    half = max(1, (last + 1 - first) // 2)
    moved = float(np.hypot(*(place[-half:].mean(axis=0) - place[:half].mean(axis=0))))
    time = track.time[first : last + 1]
    duration = float(time[-half:].mean() - time[:half].mean())
    allowed = _REST_SIGMAS * float(error.mean()) * math.sqrt(2.0 / half)
    spread = float(np.hypot(*(place - place.mean(axis=0)).T).max())
    return (
        moved <= max(allowed, _REST_SPEED * duration)
        and moved <= 0.5 * allowed + 5.0 * float(error.mean())
        and spread <= 6.0 * float(error.max())
    )


def _rests(track: TrackedBall, sigma: Floats, pieces: list[tuple[int, int]], number: int) -> bool:
    first, last = pieces[number]
    if first < last:
        return _is_still(track, sigma, (first, last))
    # A single sample: the first one before a ball starts, or the last one long after it stopped.
    time = track.time
    if number == 0:
        return True
    return last == len(time) - 1 and float(time[last] - time[last - 1]) > _REST_GAP


def _motion(
    track: TrackedBall, sigma: Floats, piece: tuple[int, int], rests: bool, *, end: bool
) -> Motion:
    own = slice(piece[0], piece[1] + 1)
    if rests:
        time = float(track.time[piece[1] if end else piece[0]])
        return resting(track.position[own], float(sigma[own].mean()), time)
    return motion_at_end(track.time[own], track.position[own], sigma[own], end=end)


def _kink(
    ball: str,
    track: TrackedBall,
    sigma: Floats,
    pieces: list[tuple[int, int]],
    rests: list[bool],
    numbers: tuple[int, int],
) -> Kink | None:
    """The kink between two pieces; None if the velocity does not change."""
    number, following = numbers
    before = _motion(track, sigma, pieces[number], rests[number], end=True)
    after = _motion(track, sigma, pieces[following], rests[following], end=False)
    last, first = pieces[number][1], pieces[following][0]
    low, high = float(track.time[last]), float(track.time[first])
    slack = _SLACK + _SLACK_STEPS * min(high - low, 0.05)
    time = 0.5 * (low + high)
    if rests[number] and not rests[following]:
        time = high
    for _ in range(_NEWTON):
        change = after.velocity(time) - before.velocity(time)
        size = float(np.hypot(*change))
        if size < 1e-6:
            return None
        gap = after.place(time) - before.place(time)
        step = -float(gap @ change) / size**2
        time = min(max(time + step, low - slack), high + slack)
    change = after.velocity(time) - before.velocity(time)
    size = float(np.hypot(*change))
    error = math.hypot(before.velocity_sigma(time), after.velocity_sigma(time))
    if size < max(_LEAST_CHANGE, _SIGMAS * error):
        return None
    across = math.hypot(before.place_sigma(time), after.place_sigma(time))
    apart = float(np.hypot(*(after.place(time) - before.place(time))))
    return Kink(
        ball=ball,
        time=time,
        sigma=across / size,
        before=before,
        after=after,
        last=last,
        next=first,
        meets=apart <= 0.004 + 5.0 * across,
        starts=rests[number],
    )
