"""How a player errs: strikes stray from what was meant, balls lie beside where they are seen."""

from __future__ import annotations

from dataclasses import astuple, dataclass, fields
from typing import TYPE_CHECKING, Self

from carom import _core
from carom.arguments import WORD, instance, number, text, thread_count, whole
from carom.batch import Arrays, BatchResult, in_chunks, own_strike
from carom.build import Strike
from carom.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from carom.shot import Shot


@dataclass(frozen=True, slots=True)
class Noise:
    """Standard deviations of a strike's errors: Gaussian, independent of each other.

    Attributes:
        speed: Of the cue's speed, m/s.
        azimuth: Of the cue's direction, rad.
        elevation: Of the cue's elevation, rad.
        side: Of the contact point to the side, **m**, where a strike has ball radii: a hand's
            error does not know the ball's size.
        height: Of the contact point's height, m.

    Raises:
        InputError: A number is negative, not finite, or beyond all sense.
    """

    speed: float = 0.0
    azimuth: float = 0.0
    elevation: float = 0.0
    side: float = 0.0
    height: float = 0.0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = number(f"noise.{field.name}", getattr(self, field.name))
            object.__setattr__(self, field.name, value)
        _core.check_noise(astuple(self))

    @classmethod
    def olympiad(cls, multiplier: float = 1.0) -> Self:
        """The Computational Olympiad's noise; its tournaments were played at 0.5, 1 and 2 times it.

        σ: offsets 0.5 mm each, elevation 0.1°, azimuth 0.125°, speed 0.075 m/s (Archibald, Altman
        & Shoham, *Analysis of a winning computational billiards player*, 2009).
        """
        return cls(*_core.olympiad(number("multiplier", multiplier)))

    @classmethod
    def preset(cls, name: str) -> Self:
        """A level of play by its name, or the Olympiad's noise.

        ``beginner``, ``casual``, ``club``, ``advanced`` and ``professional`` are **estimated**: no
        study that we found gives the σ of what a cue does. ``olympiad`` is published.
        A multiplier may follow: ``olympiad:0.5``.

        Raises:
            InputError: There is no such preset.
        """
        presets = dict(_core.noise_presets())
        base, colon, factor = text("noise", name, '"club"').partition(":")
        if base not in presets:
            known = ", ".join(presets)
            raise InputError(f"noise: there is no preset {base!r}; there are: {known}")
        try:
            multiplier = float(factor) if colon else 1.0
        except ValueError:
            raise InputError(f"noise: {factor!r} is no multiplier; write a number") from None
        return cls(*presets[base]).scaled(multiplier)

    def scaled(self, multiplier: float) -> Self:
        """The same with every σ times ``multiplier``."""
        factor = number("multiplier", multiplier)
        return type(self)(*(sigma * factor for sigma in astuple(self)))

    def draw(self, shot: Shot, index: int = 0, *, seed: int = 0) -> Strike:
        """The strike that comes out when a player means that of ``shot``.

        It is that of variant ``index`` of ``Shot.vary`` with the same seed. It may be one that
        cannot be played: a miscue, a speed ≤ 0.

        Raises:
            InputError: The shot has no strike, or a number is out of range.
        """
        from carom.shot import Shot

        core = instance("shot", shot, Shot, "carom.Shot.from_dict(...)")._core
        index, seed = whole("index", index), whole("seed", seed)
        (row,) = _core.draw_strikes(core, astuple(self), seed, index, 1)
        speed, azimuth, elevation, side, height = row.tolist()
        meant = shot.to_dict()["strike"]
        obstruction = meant.get("obstruction", Strike.obstruction)
        return Strike(speed, azimuth, elevation, side, height, meant["ball"], obstruction)


@dataclass(frozen=True, slots=True)
class Perception:
    """How far from where they are a player sees the balls: Gaussian, each on its own.

    Given to ``Shot.evaluate`` and its like, the shot is what the player sees and plans on, and each
    variant has the balls where they may truly lie: to err about one is to err about the other.

    Attributes:
        position: Standard deviation of each coordinate of each ball, m.

    Raises:
        InputError: It is negative, not finite, or more than 0.1 m.
    """

    position: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "position", number("perception.position", self.position))
        _core.check_perception(self.position)

    def see(self, shot: Shot, index: int = 0, *, seed: int = 0) -> Shot:
        """The shot with the balls a little beside where they are.

        No ball is seen in another or outside the table; one that would be is seen nearer to where
        it is: half as far off, or a quarter, ... ``index`` and ``seed`` say which of all sights,
        the same on every platform.

        Raises:
            InputError: A number is out of range, or the strike cannot be played on what is seen.
        """
        from carom.shot import Shot

        core = instance("shot", shot, Shot, "carom.Shot.from_dict(...)")._core
        return Shot._wrap(
            _core.see(core, self.position, whole("seed", seed), whole("index", index))
        )


@dataclass(frozen=True, slots=True)
class NoisyResult(BatchResult):
    """The ends of a shot's noisy variants, and the strikes that they were played with.

    Attributes:
        speed: The cue's speed, m/s, float64 of shape (n_shots,), as all that follow.
        azimuth: The cue's direction, rad.
        elevation: Butt raised above horizontal, rad.
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
    """

    speed: NDArray[np.float64]
    azimuth: NDArray[np.float64]
    elevation: NDArray[np.float64]
    side: NDArray[np.float64]
    height: NDArray[np.float64]


def vary(
    shot: _core.Shot,
    noise: Noise,
    n: int,
    *,
    perception: Perception | None,
    seed: int,
    first: int,
    threads: int | None,
    progress: bool,
) -> NoisyResult:
    """``Shot.vary``."""
    import numpy as np

    sigmas, position = sigmas_of(noise), position_of(perception)
    seed, first = whole("seed", seed), whole("first", first)
    n = whole("n", n, WORD - first)
    own_strike(shot)
    strikes = np.empty((5, n))

    def run(start: int, end: int) -> Arrays:
        rows = _core.draw_strikes(shot, sigmas, seed, first + start, end - start)
        strikes[:, start:end] = rows.T
        if position == 0.0:
            return _core.simulate_strikes(shot, rows, thread_count(threads))
        return _core.simulate_seen(shot, rows, position, seed, first + start, thread_count(threads))

    ends = in_chunks(run, n, len(shot), progress=progress)
    return NoisyResult(ends.final_position, ends.pocket, ends.events, ends.errors, *strikes)


def sigmas_of(noise: Noise | None) -> tuple[float, ...]:
    """The σ as Rust takes them; the Olympiad's if None."""
    noise = Noise.olympiad() if noise is None else noise
    return astuple(instance("noise", noise, Noise, 'carom.Noise.preset("club")'))


def position_of(perception: Perception | None) -> float:
    """The σ of positions, m; 0 if None."""
    if perception is None:
        return 0.0
    return instance("perception", perception, Perception, "carom.Perception(0.002)").position
