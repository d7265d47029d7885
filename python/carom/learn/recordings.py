"""A long recording cut into shots, by the times at which all balls are at rest."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.arguments import instance, number
from carom.errors import InputError
from carom.lazy import np
from carom.learn.noise_of_track import LEAST_SIGMA, USUAL_SIGMA, noise_of
from carom.learn.tracks import TrackedBall, TrackedShot, Tracks

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Places are averaged over this time, s, before they are compared.
_BLOCK = 0.2
# A ball moves if two such means differ by this, m, and this number of standard deviations.
_LEAST_MOVE = 0.004
_SIGMAS = 5.0


def cut_into_shots(tracks: Tracks, *, rest: float = 1.0, lead: float = 0.5) -> Tracks:
    """Cut recordings into shots where all balls rest.

    Args:
        tracks: Tracks whose shots may be recordings of several shots.
        rest: Least time for which all balls rest between two shots, s, > 0.
        lead: How much of the rest belongs to a shot, before its first motion and after its last, s,
            ≥ 0 and at most half of ``rest``.

    Returns:
        Tracks in which a recording ``a`` of several shots has become ``a/1``, ``a/2``, and so on.
        A shot with one motion keeps its name and its samples. A recording without motion is left
        as it is.

    Raises:
        InputError: An argument is out of its range.
    """
    instance("tracks", tracks, Tracks, "learn.read_tracks(...)")
    rest, lead = number("rest", rest), number("lead", lead)
    if not rest > 0.0 or not 0.0 <= lead <= 0.5 * rest:
        raise InputError(
            "out-of-range",
            "rest",
            f"a rest of {rest:g} s and a lead of {lead:g} s do not fit",
            "give a rest above 0 and a lead of at most half of it",
        )
    shots = [piece for shot in tracks for piece in _cut(shot, rest, lead)]
    return Tracks(tracks.header, tuple(shots), tracks.findings)


def moving_spans(shot: TrackedShot, rest: float = 1.0) -> list[tuple[float, float]]:
    """The times in which a ball moves, s, joined over rests shorter than ``rest``."""
    spans = sorted(span for ball in shot.balls.values() for span in _spans(ball.seen))
    joined: list[tuple[float, float]] = []
    for start, end in spans:
        if joined and start - joined[-1][1] < rest:
            joined[-1] = (joined[-1][0], max(joined[-1][1], end))
        else:
            joined.append((start, end))
    return joined


def _cut(shot: TrackedShot, rest: float, lead: float) -> list[TrackedShot]:
    spans = moving_spans(shot, rest)
    if len(spans) < 2:
        return [shot]
    found = []
    for number_, (start, end) in enumerate(spans, 1):
        balls: dict[str, TrackedBall] = {}
        for name, ball in shot.balls.items():
            inside = (ball.time >= start - lead) & (ball.time <= end + lead)
            # A ball whose rest was not stored lies where it was seen last.
            before = np.flatnonzero(ball.visible & (ball.time < start - lead))
            if before.size and not (inside & ball.visible).any():
                inside[before[-1]] = True
            if inside.any():
                balls[name] = ball.part(inside)
        found.append(TrackedShot(f"{shot.name}/{number_}", balls))
    return found


def _spans(ball: TrackedBall) -> list[tuple[float, float]]:
    """The times in which a ball moves, s."""
    if len(ball) < 2:
        return []
    error = max(noise_of(ball) or USUAL_SIGMA, LEAST_SIGMA)
    block = np.floor((ball.time - ball.time[0]) / _BLOCK).astype(np.int64)
    starts = np.flatnonzero(np.r_[True, np.diff(block) > 0])
    counts = np.diff(np.r_[starts, len(ball)])
    means = np.add.reduceat(ball.position, starts) / counts[:, None]
    way = np.hypot(*np.diff(means, axis=0).T)
    allowed = np.maximum(
        _LEAST_MOVE, _SIGMAS * error * np.sqrt(1.0 / counts[:-1] + 1.0 / counts[1:])
    )
    moves: NDArray[np.int64] = np.flatnonzero(way > allowed)
    found = []
    for index in moves:
        first, after = starts[index], starts[index + 1]
        last = starts[index + 2] - 1 if index + 2 < len(starts) else len(ball) - 1
        # Of a long time without a sample, the ball moved at its end.
        begin = float(ball.time[first])
        if ball.time[after] - ball.time[after - 1] > _BLOCK:
            begin = float(ball.time[after]) - _BLOCK
        found.append((begin, float(ball.time[last])))
    return found
