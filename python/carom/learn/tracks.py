"""Tracks: the places of balls over time, as a camera measured them.

Everything is in the table's frame: m and s; the origin is the bottom left corner of the playing
area (the corner of the nose lines), x along the table's width, y along its length.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, overload

from carom.arguments import array
from carom.errors import InputError
from carom.lazy import np
from carom.learn.findings import Finding
from carom.learn.header import TracksHeader

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]
    Truths = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, init=False, eq=False)
class TrackedBall:
    """The samples of one ball in one shot. The arrays are read-only.

    Attributes:
        time: s, strictly increasing, shape (n,).
        position: Centre, m, shape (n, 2); NaN where the ball was not visible.
        sigma: Standard deviation of a measured coordinate, m, shape (n,); None if it is unknown.
        visible: Whether the ball was seen, shape (n,). A sample in which it was not seen says
            that a picture was taken and the ball was not found in it.

    Raises:
        InputError: A time is not finite or does not increase, a position of a visible ball is not
            finite, a standard deviation is not above 0, or the shapes do not fit.
    """

    time: Floats
    position: Floats
    sigma: Floats | None
    visible: Truths

    def __init__(
        self,
        time: ArrayLike,
        position: ArrayLike,
        sigma: ArrayLike | None = None,
        visible: ArrayLike | None = None,
    ) -> None:
        times = np.array(array("time", time), dtype=np.float64)
        places = np.array(array("position", position), dtype=np.float64)
        count = times.size
        if times.ndim != 1 or places.shape != (count, 2):
            raise InputError(
                "wrong-count",
                "position",
                f"times of shape {times.shape} and positions of shape {places.shape} do not fit",
                "give n times and n × 2 positions",
            )
        seen = np.ones(count, dtype=np.bool_)
        if visible is not None:
            seen = np.array(visible, dtype=np.bool_)
            if seen.shape != (count,):
                raise InputError(
                    "wrong-count", "visible", f"its shape is {seen.shape}", f"give {count} values"
                )
        if not np.isfinite(times).all() or (np.diff(times) <= 0.0).any():
            raise InputError(
                "out-of-range",
                "time",
                "the times are not finite and strictly increasing",
                "sort the samples and remove those that are double",
            )
        if not np.isfinite(places[seen]).all():
            raise InputError(
                "out-of-range",
                "position",
                "a position is not finite",
                "set visible to False where the ball was not seen",
            )
        places[~seen] = np.nan
        object.__setattr__(self, "time", _frozen(times))
        object.__setattr__(self, "position", _frozen(places))
        object.__setattr__(self, "sigma", _sigma(sigma, count))
        object.__setattr__(self, "visible", _frozen(seen))

    def __len__(self) -> int:
        return int(self.time.size)

    @property
    def seen(self) -> TrackedBall:
        """The samples in which the ball was seen."""
        return self if self.visible.all() else self.part(self.visible)

    def part(self, chosen: Any) -> TrackedBall:
        """Some of the samples: those of a slice, a mask or an array of indices in order."""
        sigma = None if self.sigma is None else self.sigma[chosen]
        return TrackedBall(self.time[chosen], self.position[chosen], sigma, self.visible[chosen])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TrackedBall) and all(
            _same(getattr(self, name), getattr(other, name)) for name in self.__slots__
        )

    __hash__ = None  # type: ignore[assignment] # arrays have none

    def __reduce__(self) -> tuple[Any, ...]:
        return TrackedBall, (self.time, self.position, self.sigma, self.visible)

    def __repr__(self) -> str:
        if not len(self):
            return "<TrackedBall: no samples>"
        return f"<TrackedBall: {len(self)} samples, {self.time[0]:g} to {self.time[-1]:g} s>"


@dataclass(frozen=True, slots=True, init=False)
class TrackedShot:
    """One shot: what was seen of every ball.

    Attributes:
        name: The shot's name in the file.
        balls: The samples of each ball by its id; a tuple ``(time, position)`` or ``(time,
            position, sigma)`` is accepted for a ``TrackedBall``.

    Raises:
        InputError: There are no balls, or the samples of a ball are not valid.
    """

    name: str
    balls: Mapping[str, TrackedBall]

    def __init__(self, name: str, balls: Mapping[str, TrackedBall | Sequence[ArrayLike]]) -> None:
        made: dict[str, TrackedBall] = {}
        for ball, samples in balls.items():
            try:
                made[str(ball)] = (
                    samples if isinstance(samples, TrackedBall) else TrackedBall(*samples)
                )
            except InputError as error:
                raise error.inside(f"shot {name}, ball {ball}", ": ") from None
        if not made:
            raise InputError("ball-count", f"shot {name}", "it has no balls", "give at least one")
        object.__setattr__(self, "name", str(name))
        object.__setattr__(self, "balls", MappingProxyType(made))

    @property
    def ids(self) -> list[str]:
        """The balls' ids."""
        return [*self.balls]

    @property
    def start(self) -> float:
        """The first time of a sample, s."""
        return min(float(ball.time[0]) for ball in self.balls.values() if len(ball))

    @property
    def end(self) -> float:
        """The last time of a sample, s."""
        return max(float(ball.time[-1]) for ball in self.balls.values() if len(ball))

    def __len__(self) -> int:
        return sum(map(len, self.balls.values()))

    def __reduce__(self) -> tuple[Any, ...]:
        return TrackedShot, (self.name, dict(self.balls))

    def __repr__(self) -> str:
        return f"<TrackedShot {self.name!r}: {len(self.balls)} balls, {len(self)} samples>"


@dataclass(frozen=True, slots=True)
class Tracks:
    """Shots that a camera followed on one table.

    Attributes:
        header: What is known about the table, the balls and the camera.
        shots: The shots. ``tracks[3]`` is the fourth one, ``tracks["12"]`` that of this name, and
            ``tracks[::2]`` are tracks of every second one.
        findings: What the reader assumed, repaired or left out.

    Raises:
        InputError: Two shots have the same name.
    """

    header: TracksHeader
    shots: tuple[TrackedShot, ...]
    findings: tuple[Finding, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "shots", tuple(self.shots))
        object.__setattr__(self, "findings", tuple(self.findings))
        names = [shot.name for shot in self.shots]
        double = next((name for name in names if names.count(name) > 1), None)
        if double is not None:
            raise InputError(
                "duplicate", "shots", f"two shots are named {double!r}", "give each its own name"
            )

    @overload
    def __getitem__(self, key: int | str) -> TrackedShot: ...
    @overload
    def __getitem__(self, key: slice) -> Tracks: ...
    def __getitem__(self, key: int | str | slice) -> TrackedShot | Tracks:
        if isinstance(key, slice):
            return Tracks(self.header, self.shots[key], self.findings)
        if isinstance(key, str):
            for shot in self.shots:
                if shot.name == key:
                    return shot
            raise InputError(
                "unknown-name",
                "shot",
                f"there is no shot {key!r}",
                f"the tracks have {len(self.shots)} shots; tracks.names lists them",
            )
        return self.shots[key]

    @property
    def names(self) -> list[str]:
        """The shots' names."""
        return [shot.name for shot in self.shots]

    def __len__(self) -> int:
        return len(self.shots)

    def __iter__(self) -> Iterator[TrackedShot]:
        return iter(self.shots)

    def __repr__(self) -> str:
        samples = sum(map(len, self.shots))
        return f"<Tracks: {len(self.shots)} shots, {samples} samples>"


def _frozen(values: Any) -> Any:
    values.flags.writeable = False
    return values


def _sigma(sigma: ArrayLike | None, count: int) -> Floats | None:
    if sigma is None:
        return None
    values = array("sigma", sigma)
    if values.ndim == 0:
        values = np.full(count, float(values))
    if values.shape != (count,):
        raise InputError("wrong-count", "sigma", f"its shape is {values.shape}", f"give {count}")
    if not (np.isfinite(values) & (values > 0.0)).all():
        raise InputError(
            "out-of-range",
            "sigma",
            "a standard deviation is not finite and above 0",
            "write m, such as 0.001",
        )
    frozen: Floats = _frozen(np.array(values))
    return frozen


def _same(a: Any, b: Any) -> bool:
    if a is None or b is None:
        return a is b
    return bool(np.array_equal(a, b, equal_nan=a.dtype.kind == "f"))
