"""A simulated shot: every event, and the exact state at any time."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Self

import carom
from carom import _core, arguments, notebook, page
from carom._core import Shot as CoreShot
from carom._core import Trace as CoreTrace
from carom.carom_route import CaromRoute, DiamondReading
from carom.errors import InputError
from carom.event_table import plain
from carom.events import Outcome, TraceEvent, event
from carom.files import read_text, shown, write_whole
from carom.lazy import np

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Mapping

    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The state of every ball at one time, or at several.

    Attributes:
        time: s; a float, or an array of shape (n_times,).
        position: Centres, m, shape ([n_times,] n_balls, 3).
        velocity: m/s, same shape.
        angular_velocity: rad/s, same shape.
        orientation: Rotation of each ball since the start, unit quaternions x, y, z, w; shape
            ([n_times,] n_balls, 4). While the axis of the spin is constant, it is exact to
            rounding. Otherwise it is integrated from the spin (Magnus expansion of fourth order,
            Blanes et al. 2009) to better than 1e-5 rad.
        motion: ``"stationary"``, ``"spinning"``, ``"rolling"``, ``"sliding"``, ``"airborne"``,
            ``"pocketed"`` or ``"off-table"``; strings, shape ([n_times,] n_balls).
    """

    time: float | NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    orientation: NDArray[np.float64]
    motion: NDArray[np.str_]


class Trace:
    """A simulated shot; immutable. ``print`` it for a table of its events."""

    # No __slots__: cached_property keeps its values in the instance's dict.
    _core: CoreTrace
    # The function for the shot of a Rust object. carom/shot.py sets it, because this module must
    # not import the layers above it.
    _shot_of: ClassVar[Callable[[CoreShot], carom.Shot]]

    def __init__(self) -> None:
        raise TypeError("a Trace comes from Shot.simulate(), Trace.load() or Trace.from_dict()")

    @classmethod
    def _wrap(cls, core: CoreTrace) -> Self:
        trace = cls.__new__(cls)
        trace._core = core
        return trace

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a saved trace.

        Raises:
            OSError: The file cannot be read.
            InputError: It is not a valid trace.
        """
        return cls._read(read_text(path), shown(path))

    @classmethod
    def from_json(cls, text: str) -> Self:
        """Read a trace from JSON text.

        Raises:
            InputError: It is not a valid trace.
        """
        return cls._read(arguments.text("text", text), None)

    @classmethod
    def _read(cls, text: str, file: str | None) -> Self:
        """Read a trace from JSON text; the error of a syntax fault names the file of the text."""
        return cls._wrap(_core.Trace.from_json(text, file))

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """Read a trace from a dict as ``to_dict`` gives it.

        Raises:
            InputError: It is not a valid trace.
        """
        return cls._wrap(_core.Trace.from_object(file))

    @cached_property
    def shot(self) -> carom.Shot:
        """The shot that was simulated."""
        return Trace._shot_of(self._core.shot())

    @cached_property
    def _dict(self) -> dict[str, Any]:
        return self._core.to_object()

    @cached_property
    def events(self) -> list[TraceEvent]:
        """The events in order, each as ``carom-trace/1`` has it; keys are also attributes.

        Impacts have ``impulses``, the change of each ball's momentum, N s, shape (n_balls, 3), and
        ``points``, the points of contact, m, shape (n_points, 3).
        """
        return [event(entry) for entry in self._dict["events"]]

    @cached_property
    def outcome(self) -> Outcome:
        """The result that rules need, as ``carom-trace/1`` has it; keys are also attributes."""
        return Outcome(self._dict["outcome"])

    @property
    def duration(self) -> float:
        """Time from the strike to the end, s.

        It is the time of the last event, or the shot's end time if a ball still moves then.
        """
        return self._core.duration

    @property
    def end(self) -> str:
        """What ended the shot.

        ``"rest"``: nothing more can happen; ``"until"``: the shot's end time, at which a ball still
        moves; ``"cap"``: the largest number of events, in the trace of an ``EventCapError``.
        """
        return self._core.end

    @property
    def hash(self) -> str:
        """16 hex digits over the exact bits of all events and final states."""
        return self._core.hash

    def at(self, time: ArrayLike) -> Snapshot:
        """The exact state at one time, or at many.

        Args:
            time: Time since the strike, s, ≥ 0; a number or an array of shape (n_times,). At the
                instant of an event the state is the one after it; past the end it is the final
                state. Only after an end at rest a ball that no friction stops moves on.

        Raises:
            InputError: A time is negative or not finite, or the array has more than one axis.
        """
        times = arguments.array("time", time)
        if times.ndim > 1:
            raise InputError(
                "wrong-type", "time", f"found {times.ndim} axes", "give a number or a flat array"
            )
        position, velocity, spin, orientation, motion = self._core.at(np.atleast_1d(times))
        motions = np.array(motion, dtype=np.str_).reshape(position.shape[:2])
        if times.ndim == 0:
            at = float(times)
            return Snapshot(at, position[0], velocity[0], spin[0], orientation[0], motions[0])
        return Snapshot(times, position, velocity, spin, orientation, motions)

    def polyline(self, ball: str | int, tolerance: float) -> NDArray[np.float64]:
        """The path of a ball's centre: x, y, z (m), t (s) per point, shape (n_points, 4).

        The points lie on the exact path, one at each event of the ball; no chord is further than
        the tolerance from the path. It is the same as JavaScript's ``Trace.polyline``.

        Args:
            ball: The ball's id, or its index in ``shot.ids``.
            tolerance: Largest distance of the path from the polyline, m, > 0.

        Raises:
            InputError: There is no such ball, or the tolerance is not above 0.
        """
        index = self._index(ball)
        width = arguments.number("tolerance", tolerance)
        if not width > 0.0:
            raise InputError(
                "out-of-range", "tolerance", f"{width} m is out of range", "write a number above 0"
            )
        return self._core.polyline(index, width)

    def diamond_reading(self, ball: str | int, event: int | None = None) -> DiamondReading | None:
        """What a diamond system says of the way of a ball, up to its contact with another ball.

        Args:
            ball: The ball's id, or its index in ``shot.ids``.
            event: Number of the event behind which the way begins; None for its beginning.

        Returns:
            The reading; None if no system fits the way, and on tables without sights.

        Raises:
            InputError: There is no such ball or event.
        """
        number = None if event is None else arguments.whole("event", event, len(self))
        found = self._core.diamond_reading(self._index(ball), number)
        return None if found is None else DiamondReading(found)

    @cached_property
    def carom_route(self) -> CaromRoute | None:
        """The route of the cue ball to its second object ball; None if it meets fewer than two."""
        return CaromRoute._read(self._core.carom_route())

    def _index(self, ball: str | int) -> int:
        ids = self.shot.ids
        if not isinstance(ball, str):
            return arguments.whole("ball", ball, len(ids))
        if ball not in ids:
            known = ", ".join(map(repr, ids))
            raise InputError(
                "unknown-ball", "ball", f"there is no ball {ball!r}", f"write one of {known}"
            )
        return ids.index(ball)

    def difference(self, again: Trace) -> str | None:
        """The first difference in any bit of any event or final state; None if there is none.

        Raises:
            InputError: ``again`` is not a ``carom.Trace``.
        """
        other = arguments.instance("again", again, Trace, "Shot.simulate()")
        return self._core.first_difference(other._core)

    def to_dict(self) -> dict[str, Any]:
        """The ``carom-trace/1``; ``from_dict`` of it gives this trace again, to the bit."""
        return self._core.to_object()

    def to_json(self) -> str:
        """The ``carom-trace/1`` as text; ``from_json`` of it gives this trace again."""
        return self._core.to_json()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the trace as JSON."""
        write_whole(path, self.to_json() + "\n")

    def show(self, *, height: int | None = None) -> None:
        """Replay the trace in the notebook, or else in the browser until Ctrl-C.

        Args:
            height: Height of the viewer in the notebook, CSS pixels; None is the usual one.

        Raises:
            PageError: The page is not built into this installation.
        """
        notebook.show(self, height=height or page.HEIGHT)

    def _repr_html_(self) -> str:
        """The viewer, for notebooks; a picture if the page is not built."""
        return notebook.cell(self) if page.is_built() else notebook.image(self)

    def __len__(self) -> int:
        return len(self._dict["events"])

    def __bool__(self) -> bool:
        # A trace without events is still a trace.
        return True

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Trace) and self._core.to_json() == other._core.to_json()

    def __hash__(self) -> int:
        return hash(self.hash)

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        return (Trace.from_json, (self.to_json(),))

    def __str__(self) -> str:
        return plain(self._dict)

    def __repr__(self) -> str:
        return f"<carom.Trace: {len(self)} events in {self.duration:.3f} s, hash {self.hash}>"
