"""Tracks of simulated shots with the errors of a camera."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from carom.arguments import flat, number, numbers, whole
from carom.errors import InputError
from carom.lazy import np
from carom.learn.header import TracksHeader
from carom.learn.tracks import TrackedBall, TrackedShot, Tracks
from carom.shot import Shot
from carom.trace import Trace

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

# Most pictures of a shot: an hour at 240 Hz. More are a typing error.
_MOST_PICTURES = 10**6


class TrueContact(NamedTuple):
    """A contact as the engine computed it, on the clock and in the frame of the tracks.

    Attributes:
        time: s.
        balls: The ids of the balls: one and a rail, or two and more.
        rail: Name of the rail; None for a contact of balls.
        place: Centre of each ball, m.
        before: Velocity of each ball just before, m/s.
        after: Velocity of each ball just after, m/s.
    """

    time: float
    balls: tuple[str, ...]
    rail: str | None
    place: dict[str, tuple[float, float]]
    before: dict[str, tuple[float, float]]
    after: dict[str, tuple[float, float]]

    @property
    def change(self) -> float:
        """The largest change of a ball's velocity, m/s."""
        return max(math.dist(self.before[ball], self.after[ball]) for ball in self.balls)


@dataclass(frozen=True, slots=True)
class _Camera:
    """The clock and the frame of a camera, in ``to_track`` of ``SyntheticTracks``."""

    centre: tuple[float, float]
    rotation: float
    offset: tuple[float, float]
    scale: float

    def places(self, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Places of the table's frame, (..., 2), in that of the camera."""
        centre = np.array(self.centre)
        placed: NDArray[np.float64] = self.vectors(table - centre - np.array(self.offset)) + centre
        return placed

    def vectors(self, table: NDArray[np.float64]) -> NDArray[np.float64]:
        """Differences of places, in the frame of the camera."""
        cos, sin = math.cos(self.rotation), math.sin(self.rotation)
        back = np.array(((cos, sin), (-sin, cos)))
        turned: NDArray[np.float64] = table @ back.T / self.scale
        return turned


@dataclass(frozen=True, slots=True)
class SyntheticTracks:
    """Tracks of simulated shots, and the truth behind them.

    Attributes:
        tracks: The tracks.
        traces: The trace of each shot.
        clock_offset: Time of each strike on the camera's clock, s, shape (n_shots,).
        clock_drift: Camera's seconds per second less 1.
    """

    tracks: Tracks
    traces: tuple[Trace, ...]
    clock_offset: NDArray[np.float64]
    clock_drift: float
    _camera: _Camera

    def contacts(self, index: int) -> list[TrueContact]:
        """The contacts of a shot with balls and rails, in order of time."""
        found = []
        for event in self.traces[index].events:
            if event.type not in ("ball-collision", "rail-collision"):
                continue
            states = zip(event.before, event.after, strict=True)
            place, before, after = {}, {}, {}
            for old, new in states:
                place[old.id] = _pair(self._camera.places(np.array(old.position[:2])))
                before[old.id] = _pair(self._camera.vectors(np.array(old.velocity[:2])))
                after[old.id] = _pair(self._camera.vectors(np.array(new.velocity[:2])))
            rail = event["rail"] if event.type == "rail-collision" else None
            time = self.clock_offset[index] + event.time * (1.0 + self.clock_drift)
            found.append(TrueContact(float(time), tuple(event.balls), rail, place, before, after))
        return found


def synthetic(
    shots: Shot | Iterable[Shot],
    *,
    rate: float = 50.0,
    sigma: float = 0.001,
    least_move: float | None = None,
    lost: float = 0.0,
    gap: float = 0.2,
    clock_offset: ArrayLike = 0.0,
    clock_drift: float = 0.0,
    jitter: float = 0.0,
    rotation: float = 0.0,
    offset: Sequence[float] = (0.0, 0.0),
    scale: float = 1.0,
    after: float = 0.0,
    until: float | None = None,
    names: Sequence[str] | None = None,
    seed: int = 0,
) -> SyntheticTracks:
    """Make tracks of simulated shots, as a camera would measure them.

    A place of the table is ``centre + scale * R(rotation) @ (place - centre) + offset`` of the
    measured one, R being the rotation counter-clockwise and the centre that of the playing area.

    Args:
        shots: The shots, all on one table.
        rate: Pictures per second, Hz; the first picture is at 0 on the camera's clock.
        sigma: Standard deviation of a measured coordinate, m; 0 measures exactly.
        least_move: The sampling rule: a sample of a ball is stored when its measured place is at
            least this far from its last one, m, and at the first and the last picture. None
            stores every picture.
        lost: Share of the time in which a ball is not seen, 0 to 0.9.
        gap: Mean time for which a ball is not seen, s; the times are exponentially distributed.
        clock_offset: Time of the strike on the camera's clock, s, ≥ 0: a number, or one for each
            shot.
        clock_drift: Camera's seconds per second less 1; 1e-4 is a clock that gains 8.6 s a day.
        jitter: Standard deviation of a picture's written time, s; at most a fifth of a picture's.
        rotation: rad.
        offset: m.
        scale: Metres of the table in a measured metre.
        after: Time for which the balls are filmed after their rest, s.
        until: End of each shot, s since the strike, in place of the rest.
        names: The shots' names; by default their numbers from 1.
        seed: Seed of the errors.

    Returns:
        The tracks, with the traces and contacts of the engine.

    Raises:
        InputError: An argument is out of its range, or the shots' tables differ.
        EventCapError: A shot reached its largest number of events.
    """
    played = [shots] if isinstance(shots, Shot) else list(shots)
    if not played:
        raise InputError("wrong-count", "shots", "there is no shot", "give at least one")
    table = played[0].table
    if any(shot.table != table for shot in played):
        raise InputError("mismatch", "shots", "their tables differ", "give those of one table")
    rate = _within("rate", rate, 1.0, 1e5, "Hz")
    sigma = _within("sigma", sigma, 0.0, 1.0, "m")
    lost = _within("lost", lost, 0.0, 0.9, "")
    gap = _within("gap", gap, 1e-3, 1e3, "s")
    jitter = _within("jitter", jitter, 0.0, 0.2 / rate, "s")
    scale = _within("scale", scale, 0.1, 10.0, "")
    drift = _within("clock_drift", clock_drift, -0.1, 0.1, "")
    after = _within("after", after, 0.0, 3600.0, "s")
    angle = number("rotation", rotation)
    moved = numbers("offset", tuple(offset), 2)
    starts = np.broadcast_to(flat("clock_offset", clock_offset), (len(played),)).copy()
    if (starts < 0.0).any():
        raise InputError(
            "out-of-range", "clock_offset", "the strike is before the film", "give numbers ≥ 0"
        )
    titles = [str(i + 1) for i in range(len(played))] if names is None else list(names)
    if len(titles) != len(played):
        raise InputError(
            "wrong-count",
            "names",
            f"{len(titles)} names for {len(played)} shots",
            "give as many",
        )
    radius = played[0].radius
    size = played[0].geometry()["size"]
    centre = (0.0, 0.0) if size is None else (size[0] / 2.0, size[1] / 2.0)
    camera = _Camera(centre, angle, (moved[0], moved[1]), scale)
    rng = np.random.default_rng(whole("seed", seed))
    traces, tracked = [], []
    for shot, title, start in zip(played, titles, starts, strict=True):
        trace = shot.simulate()
        duration = trace.duration + after if until is None else number("until", until)
        last = start + duration * (1.0 + drift)
        count = int(last * rate) + 2
        if count > _MOST_PICTURES:
            raise InputError(
                "out-of-range",
                "rate",
                f"{count} pictures of one shot are too many",
                f"give a lower rate or an end time, for at most {_MOST_PICTURES}",
            )
        pictures = np.arange(count) / rate
        true = pictures + rng.normal(0.0, jitter, count) if jitter else pictures
        seen = trace.at(np.maximum((true - start) / (1.0 + drift), 0.0))
        balls = {}
        for index, ball in enumerate(shot.ids):
            places = camera.places(seen.position[:, index, :2])
            places = places + rng.normal(0.0, sigma, places.shape) if sigma else places
            gone = np.isin(seen.motion[:, index], ("pocketed", "off-table"))
            visible = ~gone & ~_hidden(pictures, lost, gap, rng)
            balls[ball] = _stored(pictures, places, visible, least_move)
        traces.append(trace)
        tracked.append(
            TrackedShot(title, {ball: track for ball, track in balls.items() if len(track)})
        )
    header = TracksHeader(
        table=None if size is None else table.description,
        radius=float(radius[0]),
        sigma=sigma or None,
        least_move=least_move,
        rate=rate,
        note="made by carom.learn.synthetic",
    )
    return SyntheticTracks(Tracks(header, tuple(tracked)), tuple(traces), starts, drift, camera)


def _within(name: str, value: Any, low: float, high: float, unit: str) -> float:
    found = number(name, value)
    if not low <= found <= high:
        of = f" {unit}" if unit else ""
        raise InputError(
            "out-of-range",
            name,
            f"{found:g}{of} is out of range",
            f"write a number from {low:g} to {high:g}{of}",
            {"value": found, "low": low, "high": high, "open": "none", "unit": unit},
        )
    return found


def _pair(values: NDArray[np.float64]) -> tuple[float, float]:
    return float(values[0]), float(values[1])


def _hidden(
    times: NDArray[np.float64], lost: float, gap: float, rng: np.random.Generator
) -> NDArray[np.bool_]:
    """When a ball is not seen: exponentially distributed times, after one in which it is seen."""
    hidden = np.zeros(times.size, dtype=np.bool_)
    if not lost:
        return hidden
    mean_seen = gap * (1.0 - lost) / lost
    at = times[0] + rng.exponential(mean_seen)
    while at < times[-1]:
        end = at + rng.exponential(gap)
        hidden |= (times >= at) & (times < end)
        at = end + rng.exponential(mean_seen)
    return hidden


def _stored(
    times: NDArray[np.float64],
    places: NDArray[np.float64],
    visible: NDArray[np.bool_],
    least_move: float | None,
) -> TrackedBall:
    """The samples of a ball under the sampling rule."""
    if least_move is None:
        return TrackedBall(times, places, None, visible)
    seen = np.flatnonzero(visible)
    kept: list[int] = []
    for index in seen.tolist():
        if not kept or math.dist(places[index], places[kept[-1]]) >= least_move:
            kept.append(index)
    if kept and kept[-1] != seen[-1]:
        kept.append(int(seen[-1]))
    return TrackedBall(times[kept], places[kept])
