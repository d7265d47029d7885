"""What a camera saw of one shot, at even times: what a simulated shot is compared with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.errors import InputError
from carom.lazy import np
from carom.learn.tracks import TrackedBall, TrackedShot
from carom.tracks import BallTracks

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Pictures per second that are compared. A camera's own rate would weigh one that films faster
#: more, though the error of a model changes slowly.
RATE = 25.0
#: A pause between two samples that is longer, s, is a ball at rest or one that was not seen.
PAUSE = 0.1
#: The first picture in which a ball has moved is at most so long after the strike, s.
LONGEST_START = 0.1
#: Largest error of a picture's time at the strike, s: a tracker that smooths shows the first motion
#: two or three pictures late.
CLOCK_ERROR = 0.05
#: Distance from which a ball has moved, m: several times a camera's noise.
MOVED = 0.015


@dataclass(frozen=True, slots=True, eq=False)
class Observation:
    """The positions of every ball at even times, from the first picture to the last.

    Attributes:
        name: The shot's name.
        struck: The ball that was struck.
        rest: Where each ball lay before the strike, m, in the frame of the tracks.
        time: s, from 0 at the first picture, shape (n,).
        position: Of each ball, m, shape (n, 2); NaN while it was not seen.
        first_move: Time of the first picture in which the struck ball has moved, s.
        samples: The samples from which the even positions are taken, by ball.
    """

    name: str
    struck: str
    rest: Mapping[str, tuple[float, float]]
    time: Floats
    position: Mapping[str, Floats]
    first_move: float
    samples: Mapping[str, TrackedBall]

    @property
    def strike_time(self) -> tuple[float, float]:
        """The earliest and the latest time of the strike, s.

        The strike is after the last picture in which the ball lies at rest, and before the first
        one in which it has moved, but for ``CLOCK_ERROR`` of the camera's clock.
        """
        time = self.samples[self.struck].time - self.samples[self.struck].time[0]
        before = time[time < self.first_move - 1e-9]
        last = float(before[-1]) if before.size else 0.0
        earliest = max(last, self.first_move - LONGEST_START)
        return earliest - CLOCK_ERROR, self.first_move + CLOCK_ERROR

    @property
    def end(self) -> float:
        """Time of the last picture, s."""
        return float(self.time[-1])

    def until(self, horizon: float) -> BallTracks:
        """The positions up to a time, for the engine."""
        count = int(np.searchsorted(self.time, horizon, side="right"))
        chosen = {}
        for ball, places in self.position.items():
            seen = np.isfinite(places[:count, 0])
            chosen[ball] = (self.time[:count][seen], places[:count][seen])
        return BallTracks(chosen)


def observe(shot: TrackedShot, rate: float = RATE) -> Observation:
    """Samples a tracked shot at even times.

    Between two samples a ball is taken to move evenly, with two exceptions: before its first motion
    it rests until just before the next sample, and a ball that comes to rest slows down evenly. A
    camera that stores a sample only when a ball has moved shows neither.

    Raises:
        InputError: No ball moves, or the shot has fewer than five samples of the ball that does.
    """
    start, end = shot.start, shot.end
    balls = {name: ball.seen for name, ball in shot.balls.items()}
    balls = {name: ball for name, ball in balls.items() if len(ball)}
    moves = {name: when for name, ball in balls.items() if (when := first_move(ball)) is not None}
    if not moves:
        raise InputError(
            "wrong-state",
            f"shot {shot.name}",
            f"no ball moves by {1000.0 * MOVED:g} mm",
            "leave the shot out, or check the unit of its positions",
        )
    struck = min(moves, key=lambda name: moves[name])
    if len(balls[struck]) < 5:
        raise InputError(
            "wrong-count",
            f"shot {shot.name}",
            f"ball {struck} moves, and has {len(balls[struck])} samples",
            "leave the shot out",
        )
    time = np.arange(0.0, end - start + 1e-9, 1.0 / rate)
    return Observation(
        name=shot.name,
        struck=struck,
        rest={name: _rest(ball, moves.get(name)) for name, ball in balls.items()},
        time=time,
        position={name: _even(ball, time + start) for name, ball in balls.items()},
        first_move=moves[struck] - start,
        samples=balls,
    )


def first_move(ball: TrackedBall) -> float | None:
    """Time of the first sample that is away from the place of rest, s; None if there is none."""
    distance = np.hypot(*(ball.position - ball.position[0]).T)
    moved = np.flatnonzero(distance > MOVED)
    return float(ball.time[moved[0]]) if moved.size else None


def _rest(ball: TrackedBall, moves: float | None) -> tuple[float, float]:
    """The median place before the ball moves."""
    before = ball.position if moves is None else ball.position[ball.time < moves]
    # The last of several pictures before the motion may show its beginning.
    x, y = np.median(before[: max(1, len(before) - 1)], axis=0)
    return float(x), float(y)


def _even(ball: TrackedBall, time: Floats) -> Floats:
    """Positions at given times, shape (n, 2)."""
    t, places = ball.time, ball.position
    if len(t) == 1:
        return np.broadcast_to(places[0], (time.size, 2)).copy()
    step = np.hypot(*np.diff(places, axis=0).T)
    pause = np.diff(t)
    speed = step / pause
    begin, end = t[:-1].copy(), t[1:].copy()
    # The speed after the pause tells when the ball left its place.
    after = np.append(speed[1:], 0.0)
    starts = (pause > PAUSE) & (after > 2.5 * speed)
    first = np.flatnonzero(np.hypot(*(places[1:] - places[0]).T) > MOVED)[:1]
    starts[first] = after[first] > speed[first]
    begin[starts] = np.maximum(end[starts] - step[starts] / after[starts], begin[starts])
    # The speed before it tells when a ball that slows down evenly came to rest.
    before = np.insert(speed[:-1], 0, 0.0)
    stops = (pause > PAUSE) & ~starts & (2.0 * step < before * pause)
    end[stops] = begin[stops] + 2.0 * step[stops] / before[stops]
    index = np.clip(np.searchsorted(t, time, side="right") - 1, 0, len(t) - 2)
    share = (time - begin[index]) / np.maximum(end[index] - begin[index], 1e-9)
    share = np.clip(share, 0.0, 1.0)
    share = np.where(stops[index], share * (2.0 - share), share)[:, None]
    even: Floats = places[index] + share * (places[index + 1] - places[index])
    return even
