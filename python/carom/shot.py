"""A shot: everything that is decided before it starts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import carom
from carom import _core, arguments
from carom._core import Shot as CoreShot
from carom.build import Layout, Physics, Strike, Table
from carom.errors import InputError

if TYPE_CHECKING:
    import os

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from carom.batch import BatchResult
    from carom.noise import Noise, NoisyResult, Perception
    from carom.plan import Evaluation
    from carom.rules import Call, Frame
    from carom.solve import Solution
    from carom.trace import Trace


class Shot:
    """A validated, immutable shot (``carom-shot/1``).

    Build one from its parts, or read one with ``load``, ``from_dict`` or ``from_json``.

    Args:
        table: The table, or what the shot file writes for it (a preset's name, an object).
        layout: The balls, or what the shot file writes for them, or positions (m) by id.
        strike: What the player does; None if the balls move by themselves.
        physics: The parameters; None is the preset that belongs to the table.
        max_events: More events than this are an error; None is the engine's default.

    Raises:
        InputError: Something does not make sense; the message names the place.
    """

    __slots__ = ("_core",)
    _core: CoreShot

    def __init__(
        self,
        table: Table | str | Mapping[str, Any],
        layout: Layout | Mapping[str, Any] | list[Any],
        strike: Strike | Mapping[str, Any] | None = None,
        *,
        physics: Physics | str | Mapping[str, Any] | None = None,
        max_events: int | None = None,
    ) -> None:
        file: dict[str, Any] = {
            "format": "carom-shot/1",
            "table": table.description if isinstance(table, Table) else table,
            "balls": _balls(layout),
        }
        if isinstance(physics, Physics):
            physics = physics.description
        optional = {
            "physics": physics,
            "strike": strike.to_dict() if isinstance(strike, Strike) else strike,
            "max_events": max_events,
        }
        file |= {key: value for key, value in optional.items() if value is not None}
        self._core = _core.Shot.from_object(file)

    @classmethod
    def _wrap(cls, core: CoreShot) -> Self:
        shot = cls.__new__(cls)
        shot._core = core
        return shot

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a shot file.

        Raises:
            OSError: The file cannot be read.
            InputError: It is no valid shot.
        """
        return cls.from_json(read_text(path))

    @classmethod
    def from_json(cls, text: str) -> Self:
        """Read a shot from JSON text.

        Raises:
            InputError: It is no valid shot.
        """
        return cls._wrap(_core.Shot.from_json(arguments.text("text", text)))

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """Read a shot from a dict as the shot file has it.

        Raises:
            InputError: It is no valid shot.
        """
        return cls._wrap(_core.Shot.from_object(file))

    def to_dict(self) -> dict[str, Any]:
        """The shot file; ``from_dict`` of it gives this shot again, to the bit."""
        return self._core.to_object()

    def to_json(self) -> str:
        """The shot file as text; ``from_json`` of it gives this shot again, to the bit."""
        return self._core.to_json()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the shot file."""
        Path(path).write_text(self.to_json() + "\n", encoding="utf-8")

    @property
    def ids(self) -> list[str]:
        """The balls' ids; arrays of results have the balls in this order."""
        return self._core.ids

    @property
    def radius(self) -> NDArray[np.float64]:
        """The balls' radii, m, shape (n_balls,)."""
        import numpy as np

        return np.array(self._core.radius)

    @property
    def mass(self) -> NDArray[np.float64]:
        """The balls' masses, kg, shape (n_balls,)."""
        import numpy as np

        return np.array(self._core.mass)

    @property
    def azimuth(self) -> float | None:
        """Direction in which the cue moves, rad; None without a strike."""
        strike = self._core.strike
        return None if strike is None else strike[1]

    @property
    def elevation(self) -> float | None:
        """Butt of the cue raised above horizontal, rad; None without a strike."""
        strike = self._core.strike
        return None if strike is None else strike[2]

    def with_strike(
        self,
        *,
        speed: float | None = None,
        azimuth: float | None = None,
        side: float | None = None,
        height: float | None = None,
        elevation: float | None = None,
    ) -> Self:
        """The same shot struck otherwise; what is None stays as in this shot.

        A shot is always what its file says. Therefore angles are kept as the degrees that a file
        holds, which moves one in ten by its last bit; what ``azimuth`` and ``elevation`` then say
        is kept exactly, and simulated exactly as ``batch`` does.

        Args:
            speed: The cue's speed, m/s.
            azimuth: The cue's direction, counter-clockwise from +x, rad.
            side: Contact point right of centre, ball radii.
            height: Contact point above centre, ball radii.
            elevation: Butt raised above horizontal, rad.

        Raises:
            InputError: The shot has no strike, or this one cannot be played: a number is out of
                range, the tip would slip off, or the cue would pass through something and the shot
                has ``"obstruction": "refuse"``.
        """
        from carom.batch import VARIABLES, own_strike

        given = (speed, azimuth, elevation, side, height)
        own = own_strike(self._core)
        strike = tuple(
            default if value is None else arguments.number(name, value)
            for name, value, default in zip(VARIABLES, given, own, strict=True)
        )
        return self._wrap(self._core.with_strike(strike))

    def geometry(self) -> dict[str, Any]:
        """The table's dimensions, cushions and pockets, m, origin at the bottom left corner."""
        return self._core.geometry()

    def simulate(self) -> Trace:
        """Simulate the shot to its end.

        Raises:
            EventCapError: It reached its cap of events; the error carries the shot.
        """
        # By the package's name, for the two modules need each other: an import here would be a
        # tenth of what a short shot takes.
        return carom.Trace._wrap(self._core.simulate())

    def batch(
        self,
        *,
        speed: ArrayLike | None = None,
        azimuth: ArrayLike | None = None,
        side: ArrayLike | None = None,
        height: ArrayLike | None = None,
        elevation: ArrayLike | None = None,
        threads: int | None = None,
        progress: bool = False,
    ) -> BatchResult:
        """Simulate many variants of this shot's strike, over all cores, without traces.

        What is None stays as in this shot; scalars and arrays broadcast against each other, and
        the result is flat, in C order.

        Args:
            speed: The cue's speed, m/s.
            azimuth: The cue's direction, counter-clockwise from +x, rad.
            side: Contact point right of centre, ball radii.
            height: Contact point above centre, ball radii.
            elevation: Butt raised above horizontal, rad.
            threads: How many; None is one per core. Results do not depend on it.
            progress: Show a progress bar on stderr.

        Raises:
            InputError: The shot has no strike, or the shapes do not broadcast. A strike that is
                out of range does not raise: it is in ``errors`` of the result.
        """
        from carom.batch import vary

        given = {
            "speed": speed,
            "azimuth": azimuth,
            "elevation": elevation,
            "side": side,
            "height": height,
        }
        return vary(self._core, given, threads=threads, progress=progress)

    def vary(
        self,
        noise: Noise,
        n: int,
        seed: int = 0,
        *,
        perception: Perception | None = None,
        first: int = 0,
        threads: int | None = None,
        progress: bool = False,
    ) -> NoisyResult:
        """Simulate what comes out when a player means this strike, ``n`` times over.

        Variant ``index`` of a seed is the same whatever ``n``, ``first`` and ``threads`` are, on
        every platform. A cue never points upwards: an elevation drawn below 0 becomes 0.

        Args:
            noise: How far the strike strays.
            n: How many variants.
            seed: Which random numbers, a whole number from 0 to 2⁶⁴ − 1.
            perception: How far from where they are seen the balls truly lie, as in ``evaluate``.
            first: Index of the first variant, so that long runs can be continued.
            threads: How many; None is one per core.
            progress: Show a progress bar on stderr.

        Returns:
            A row for each variant, and the strikes. ``errors`` has those that cannot be played, by
            row: a miscue (unless the shot has ``"miscue": "report"``), a speed ≤ 0, ...

        Raises:
            InputError: The shot has no strike, a σ is negative, or a number is out of range.
        """
        from carom.noise import vary

        return vary(
            self._core,
            noise,
            n,
            perception=perception,
            seed=seed,
            first=first,
            threads=threads,
            progress=progress,
        )

    def evaluate(
        self,
        noise: Noise,
        n: int = 10_000,
        seed: int = 0,
        *,
        perception: Perception | None = None,
        precision: float | None = None,
        watch: str | tuple[str, str] | None = None,
        frame: Frame | None = None,
        call: Call | None = None,
        level: float = 0.95,
        threads: int | None = None,
        progress: bool = False,
    ) -> Evaluation:
        """The chances of what comes out when a player means this strike.

        The variants are those of ``vary`` with the same noise, perception and seed.

        Args:
            noise: How far the strike strays.
            n: How many variants, at most.
            seed: Which random numbers, a whole number from 0 to 2⁶⁴ − 1.
            perception: How far from where they are seen the balls truly lie. The shot is what the
                player sees and plans on; every variant has a layout of its own around it, as
                ``Perception.see`` draws it. The tip meets the cue ball where that truly is.
            precision: Stop as soon as half the width of the watched interval is at most this;
                looked at after every 1024 variants. None plays all ``n``.
            watch: Whose: a ball's id, ``(ball, pocket)``, ``"scratch"`` or ``"legal"``; None is
                everything that is counted.
            frame: The game in which it is played; it says what is legal, and must ask for this
                shot: ``frame.shot(...)`` gives it.
            call: What is announced to the frame.
            level: Confidence of the intervals.
            threads: How many; None is one per core. Results do not depend on it.
            progress: Show a progress bar on stderr.

        Raises:
            InputError: The shot has no strike, a number is out of range, there is nothing such to
                watch, or the frame asks for another shot.
        """
        from carom.plan import evaluate

        return evaluate(
            self,
            noise,
            n,
            perception=perception,
            seed=seed,
            precision=precision,
            watch=watch,
            frame=frame,
            call=call,
            level=level,
            threads=threads,
            progress=progress,
        )

    def solve(
        self,
        *,
        pot: str | tuple[str, str] | None = None,
        leave: tuple[Sequence[float], float] | None = None,
        first: str | None = None,
        noise: Noise | None = None,
        perception: Perception | None = None,
        wanted: int = 10,
        of_a_way: int = 3,
        n: int = 1000,
        precision: float | None = None,
        speed: tuple[float, float] = (0.5, 7.0),
        offset: float = 0.45,
        elevation: float | None = None,
        samples: int = 4096,
        seed: int = 0,
        level: float = 0.95,
        threads: int | None = None,
        progress: bool = False,
    ) -> list[Solution]:
        """The strikes that do what is wanted, the likeliest first.

        All that is named must come true, and the cue ball must stay on the table. Every direction
        that geometry proposes (ghost balls, mirror images, other balls' flanks) and points spread
        over all strikes are played, the nearest of every way refined until they do it exactly, and
        what is left ranked by its chance. Of this shot's own strike only the struck ball and the
        elevation count; the cue is raised where something is in its way, and with ``elevation`` to
        jump over balls or to curve around them.

        Args:
            pot: A ball that falls, or ``(ball, pocket)``.
            leave: ``((x, y), radius)``: the cue ball comes to rest with its centre in this disc, m.
            first: The ball that the cue ball touches before any other.
            noise: Under which the strikes are ranked; the Olympiad's if None.
            perception: How far from where they are seen the balls truly lie when they are.
            wanted: How many strikes.
            of_a_way: How many of them over the same cushions and balls.
            n: Variants that each chance is counted with, at most.
            precision: Stop counting a chance when half its interval's width is at most this;
                looked at after every 128 variants. None plays all ``n``.
            speed: Least and greatest speed of the cue, m/s.
            offset: Largest tip offset, ball radii; at most 95 % of the miscue limit.
            elevation: How far the cue may be raised, rad, for jumps and massés: they are tried
                besides strikes at the shot's elevation. None tries only those.
            samples: Points spread over all strikes.
            seed: Which random numbers.
            level: Confidence of the intervals.
            threads: How many; None is one per core. Results do not depend on it.
            progress: Show a progress bar on stderr.

        Raises:
            InputError: Nothing is wanted, there is no such ball or pocket, the shot has no strike,
                or a number is out of range.
        """
        from carom.solve import solve

        return solve(
            self,
            pot=pot,
            leave=leave,
            first=first,
            noise=noise,
            perception=perception,
            wanted=wanted,
            of_a_way=of_a_way,
            n=n,
            precision=precision,
            speed=speed,
            offset=offset,
            elevation=elevation,
            samples=samples,
            seed=seed,
            level=level,
            threads=threads,
            progress=progress,
        )

    def show(self, *, height: int | None = None) -> None:
        """Aim and play it: in the notebook, or else in the browser until Ctrl-C.

        Args:
            height: Of the viewer in the notebook, CSS pixels; None is a usual one.

        Raises:
            PageError: The page is not built into this installation.
        """
        from carom import page

        page.show(self, height=height or page.HEIGHT)

    def _repr_html_(self) -> str | None:
        """The viewer, for notebooks; nothing but text where the page is not built."""
        from carom import page

        return page.frame(self) if page.is_built() else None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shot) and self._core.to_json() == other._core.to_json()

    def __hash__(self) -> int:
        return hash(self._core.to_json())

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        return (Shot.from_json, (self.to_json(),))

    def __repr__(self) -> str:
        count = len(self.ids)
        name = self.geometry()["name"] or "table"
        return f"<carom.Shot: {count} ball{'s' * (count != 1)} on {name}>"


def read_text(path: str | os.PathLike[str]) -> str:
    """The text of a UTF-8 file.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not UTF-8.
    """
    try:
        return Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not a text file ({error.reason}); JSON is UTF-8") from None


def _balls(layout: Any) -> Any:
    if isinstance(layout, Layout):
        return layout.balls
    if isinstance(layout, Mapping):
        return Layout.at(layout).balls
    return layout
