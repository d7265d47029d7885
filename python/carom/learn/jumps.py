"""Places that no ball can reach in time: single errors of a tracker, and exchanged balls."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from carom.lazy import np
from carom.learn.findings import Finding
from carom.learn.plausible import MOST_SPEED
from carom.learn.tracks import TrackedBall, TrackedShot

if TYPE_CHECKING:
    from numpy.typing import NDArray

# A step that is shorter than this is not called a jump, m: errors of a camera, and of its clock,
# of a ball that moves at some m/s.
_LEAST_JUMP = 0.08
# A jump that no free ball makes: a step faster than the faster of its neighbours by this factor...
_TIMES_FASTER = 4.0
# ... plus this speed, m/s, by which the strike or a collision can change a ball's.
_MOST_CHANGE = 3.0
# Two balls that jump within this time are exchanged, s.
_SAME_TIME = 0.1
# More exchanges in a shot cannot be undone one by one.
_MOST_EXCHANGES = 20


def without_jumps(shot: TrackedShot, findings: list[Finding]) -> TrackedShot:
    """The shot without single wrong places and with exchanged balls exchanged back.

    Args:
        shot: A shot.
        findings: What was repaired, and jumps that could not be, are added to them.
    """
    balls = {
        ball: _without_spikes(shot.name, ball, track, findings)
        for ball, track in shot.balls.items()
    }
    for _ in range(_MOST_EXCHANGES):
        pair = _exchange(balls)
        if pair is None:
            break
        a, b, time = pair
        balls[a], balls[b] = _exchanged(balls[a], balls[b], time)
        findings.append(
            Finding(
                "repair",
                "exchanged",
                f"shot {shot.name}, {time:g} s",
                f"the balls {a} and {b} jump to each other's places",
                "exchanged from there on",
            )
        )
    for ball, track in balls.items():
        seen = track.seen
        for index in _jumps(seen)[:1]:
            distance = float(np.hypot(*(seen.position[index + 1] - seen.position[index])))
            findings.append(
                Finding(
                    "warning",
                    "jump",
                    f"shot {shot.name}, ball {ball}, {seen.time[index]:g} s",
                    f"the ball jumps by {distance:.2f} m",
                    "cut the shot there, or leave the ball out",
                )
            )
    return TrackedShot(shot.name, balls)


def _steps(seen: TrackedBall) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lengths of the steps between samples, m, and their speeds, m/s."""
    way = np.hypot(*np.diff(seen.position, axis=0).T)
    return way, way / np.diff(seen.time)


def _jumps(seen: TrackedBall) -> NDArray[np.int64]:
    """The steps, by the index of their first sample, that no ball can make."""
    if len(seen) < 2:
        return np.empty(0, dtype=np.int64)
    way, speed = _steps(seen)
    # The speed of the steps beside, so that a fast shot has no jumps.
    beside = np.maximum(np.r_[0.0, speed[:-1]], np.r_[speed[1:], 0.0])
    beyond = speed > np.minimum(MOST_SPEED, _TIMES_FASTER * beside + _MOST_CHANGE)
    return np.flatnonzero((way > _LEAST_JUMP) & beyond)


def _without_spikes(
    shot: str, name: str, track: TrackedBall, findings: list[Finding]
) -> TrackedBall:
    """The track without samples that jump away and back."""
    seen = track.seen
    if len(seen) < 3:
        return track
    way, speed = _steps(seen)
    back = np.hypot(*(seen.position[2:] - seen.position[:-2]).T)
    # Away and back: both steps are fast and long, but their sum is short.
    away = (way[:-1] > _LEAST_JUMP) & (way[1:] > _LEAST_JUMP)
    fast = np.minimum(speed[:-1], speed[1:]) > _MOST_CHANGE
    around = np.maximum(np.r_[0.0, speed[:-2]], np.r_[speed[2:], 0.0])
    faster = np.minimum(speed[:-1], speed[1:]) > _TIMES_FASTER * around
    spikes = np.flatnonzero(away & fast & faster & (back < 0.5 * np.minimum(way[:-1], way[1:]))) + 1
    if not spikes.size:
        return track
    times = seen.time[spikes]
    first = ", ".join(f"{time:g}" for time in times[:5])
    findings.append(
        Finding(
            "repair",
            "spike",
            f"shot {shot}, ball {name}, {first} s",
            "the ball jumps away and back",
            "kept as samples in which the ball was not seen",
            int(spikes.size),
        )
    )
    visible = track.visible & ~np.isin(track.time, times)
    return TrackedBall(track.time, track.position, track.sigma, visible)


def _exchange(balls: dict[str, TrackedBall]) -> tuple[str, str, float] | None:
    """The first two balls that jump to each other's places, and the time before the jump."""
    found: list[tuple[float, str, str]] = []
    places: dict[str, list[tuple[float, float, Any, Any]]] = {}
    for name, track in balls.items():
        seen = track.seen
        places[name] = [
            (
                float(seen.time[i]),
                float(seen.time[i + 1]),
                seen.position[i],
                seen.position[i + 1],
            )
            for i in _jumps(seen)
        ]
    names = list(balls)
    for i, a in enumerate(names):
        for b in names[i + 1 :]:
            for start, end, from_a, to_a in places[a]:
                for start_b, end_b, from_b, to_b in places[b]:
                    if start > end_b + _SAME_TIME or start_b > end + _SAME_TIME:
                        continue
                    apart = float(np.hypot(*(from_a - from_b)))
                    after = max(
                        float(np.hypot(*(to_a - from_b))), float(np.hypot(*(to_b - from_a)))
                    )
                    if after < 0.5 * apart:
                        found.append((min(start, start_b), a, b))
    if not found:
        return None
    time, a, b = min(found)
    return a, b, time


def _exchanged(a: TrackedBall, b: TrackedBall, time: float) -> tuple[TrackedBall, TrackedBall]:
    """The balls with each other's samples after this time."""
    return _joined(a, b, time), _joined(b, a, time)


def _joined(first: TrackedBall, then: TrackedBall, time: float) -> TrackedBall:
    before, after = first.time <= time, then.time > time
    sigma = None
    if first.sigma is not None and then.sigma is not None:
        sigma = np.r_[first.sigma[before], then.sigma[after]]
    return TrackedBall(
        np.r_[first.time[before], then.time[after]],
        np.r_[first.position[before], then.position[after]],
        sigma,
        np.r_[first.visible[before], then.visible[after]],
    )
