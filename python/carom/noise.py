"""Errors of a player: strikes differ from the intended ones, positions from the perceived ones."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING, Any, Self

from carom import _core
from carom.arguments import (
    WORD,
    check_results,
    core,
    instance,
    number,
    numbers,
    text,
    thread_count,
    whole,
)
from carom.batch import Arrays, BatchResult, in_chunks, own_strike
from carom.build import Strike, like
from carom.deprecated import renamed_fields
from carom.device import opened
from carom.errors import InputError
from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    import carom

    # Rows of five numbers, or an array of shape (n, 5).
    Rows = Sequence[Sequence[float]] | NDArray[np.float64]

# The errors among the fields of `Noise` that hold one number, and all such fields.
_SIGMAS = ("speed", "azimuth", "elevation", "side_m", "height_m", "speed_relative")
_NUMBERS = (*_SIGMAS[:5], "cling_probability", "cling_friction", "speed_relative")


@renamed_fields(side="side_m", height="height_m")
@dataclass(frozen=True, slots=True)
class Noise:
    """Errors of a strike, and cling between balls.

    The Gaussian parts add up: the error is normal, its mean is the bias, and its covariance is the
    sum of ``covariance`` and the squared standard deviations. Vectors and matrices have the order
    speed (m/s), azimuth (rad), elevation (rad), side (m), height (m), and describe executed minus
    intended.

    Attributes:
        speed: Standard deviation of the cue's speed, m/s.
        azimuth: Of the cue's direction, rad.
        elevation: Of the cue's elevation, rad.
        side_m: Of the contact point to the side, m. It is in metres, not in ball radii as the
            offsets of a strike, because a player's error does not depend on the ball's size.
        height_m: Of the contact point's height, m.
        cling_probability: Probability with which a contact of two balls clings (kick, skid), 0 to
            1. No source gives one for pool; the presets have 0.
        cling_friction: Coefficient of friction of a contact that clings. 0.22 gives the throw that
            was measured with chalk at the contact (docs/rails-and-balls.md).
        speed_relative: Standard deviation of a further error of the speed, as a share of the
            intended speed, 0 to 1.
        covariance: Covariance of errors that depend on each other, shape (5, 5), such as
            ``numpy.cov(errors.T)``; None is none.
        bias: Mean of the error, shape (5,).
        samples: Measured errors, shape (n, 5), in place of standard deviations and a covariance:
            every drawn strike has the error of one row, all equally likely. None is none.

    Raises:
        InputError: A number is negative, not finite, or far beyond what a player does; the
            covariance is not symmetric or not positive semidefinite; samples stand beside standard
            deviations or a covariance.
    """

    speed: float = 0.0
    azimuth: float = 0.0
    elevation: float = 0.0
    side_m: float = 0.0
    height_m: float = 0.0
    cling_probability: float = 0.0
    cling_friction: float = 0.22
    speed_relative: float = field(default=0.0, kw_only=True)
    covariance: Rows | None = field(default=None, kw_only=True)
    bias: Sequence[float] = field(default=(0.0,) * 5, kw_only=True)
    samples: Rows | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        for name in _NUMBERS:
            value = number(f"noise.{name}", getattr(self, name))
            object.__setattr__(self, name, value)
        bias = numbers("noise.bias", self.bias, 5)
        object.__setattr__(self, "bias", bias)
        if self.covariance is not None:
            rows = _rows("noise.covariance", self.covariance)
            if len(rows) != 5:
                fault = f"found {len(rows)} rows"
                remedy = "give five rows of five numbers"
                raise InputError("wrong-count", "noise.covariance", fault, remedy)
            object.__setattr__(self, "covariance", rows)
        if self.samples is not None:
            object.__setattr__(self, "samples", _rows("noise.samples", self.samples))
        _core.check_noise(self)

    @classmethod
    def olympiad(cls, multiplier: float = 1.0) -> Self:
        """The noise of the Computational Olympiad, whose tournaments used 0.5, 1 and 2 times it.

        σ: offsets 0.5 mm each, elevation 0.1°, azimuth 0.125°, speed 0.075 m/s (Archibald, Altman
        & Shoham, *Analysis of a winning computational billiards player*, 2009).
        """
        return cls(*_core.olympiad(number("multiplier", multiplier)))

    @classmethod
    def preset(cls, name: str) -> Self:
        """The noise of a level of play by its name, or the Olympiad's noise.

        ``beginner``, ``casual``, ``club``, ``advanced`` and ``professional`` are **estimates**: we
        found no study that measured these σ. ``olympiad`` is published. A multiplier may follow
        the name: ``olympiad:0.5``.

        Raises:
            InputError: There is no such preset.
        """
        presets = dict(_core.noise_presets())
        base, colon, factor = text("noise", name, '"club"').partition(":")
        if base not in presets:
            known = ", ".join(presets)
            raise InputError(
                "unknown-name", "noise", f"there is no preset {base!r}", f"write one of {known}"
            )
        try:
            multiplier = float(factor) if colon else 1.0
        except ValueError:
            raise InputError(
                "wrong-type", "noise", f"{factor!r} is not a multiplier", "write a number"
            ) from None
        return cls(*presets[base]).scaled(multiplier)

    def scaled(self, multiplier: float) -> Self:
        """This noise with every error multiplied by ``multiplier``; the cling stays.

        Raises:
            InputError: The multiplier is negative, not finite or too large.
        """
        factor = number("multiplier", multiplier)
        scaled: dict[str, Any] = {name: getattr(self, name) * factor for name in _SIGMAS}
        scaled["bias"] = _times(self.bias, factor)
        if self.covariance is not None:
            scaled["covariance"] = [_times(row, factor * factor) for row in self.covariance]
        if self.samples is not None:
            scaled["samples"] = [_times(row, factor) for row in self.samples]
        return replace(self, **scaled)

    def __add__(self, other: Noise) -> Self:
        """The noise of both, with independent errors: means and covariances add up.

        Cling is taken from the one that has it.

        Raises:
            InputError: One has samples, or both have cling.
        """
        if not isinstance(other, Noise):
            return NotImplemented
        for noise in (self, other):
            if noise.samples is not None:
                remedy = "give numpy.cov of the samples as covariance, and their mean as bias"
                raise InputError("conflict", "noise.samples", "samples cannot be added", remedy)
        if self.cling_probability and other.cling_probability:
            fault, remedy = "both have cling", "set it to 0 in one of them"
            raise InputError("conflict", "noise.cling_probability", fault, remedy)
        total: dict[str, Any] = {
            name: math.hypot(getattr(self, name), getattr(other, name)) for name in _SIGMAS
        }
        total["bias"] = [a + b for a, b in zip(self.bias, other.bias, strict=True)]
        matrices = [np.array(m.covariance) for m in (self, other) if m.covariance is not None]
        if matrices:
            total["covariance"] = sum(matrices)
        if other.cling_probability:
            total["cling_probability"] = other.cling_probability
            total["cling_friction"] = other.cling_friction
        return replace(self, **total)

    def mean(self) -> tuple[float, ...]:
        """The mean error: speed (m/s), azimuth, elevation (rad), side, height (m)."""
        mean, _ = _core.noise_moments(self, 0.0)
        return tuple(mean)

    def deviations(self, speed: float = 1.0) -> tuple[float, ...]:
        """The standard deviations of all errors together, in the order and the units of ``mean``.

        Args:
            speed: The intended speed of the cue, m/s, on which ``speed_relative`` depends.
        """
        _, deviations = _core.noise_moments(self, number("speed", speed))
        return tuple(deviations)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for files: all numbers, and of the rest what is not at its default."""
        values: dict[str, Any] = {name: getattr(self, name) for name in _NUMBERS}
        if self.speed_relative == 0.0:
            del values["speed_relative"]
        if self.covariance is not None:
            values["covariance"] = [list(row) for row in self.covariance]
        if any(self.bias):
            values["bias"] = list(self.bias)
        if self.samples is not None:
            values["samples"] = [list(row) for row in self.samples]
        return values

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """The noise with the values of ``to_dict``; missing keys are at their defaults.

        Raises:
            InputError: There is an unknown key, or a value is wrong.
        """
        return cls(**_known("noise", values, [each.name for each in fields(cls)]))

    def draw(self, shot: carom.Shot, index: int = 0, *, seed: int = 0) -> Strike:
        """One execution of the strike of ``shot``: that of variant ``index`` of ``Shot.vary``.

        It has the ball, ``obstruction`` and ``miscue`` of the shot's strike. If the strike of the
        shot can be played, so can this one: what cannot be played is replaced by the nearest strike
        that can, as described for ``Shot.vary``. ``variant`` gives the whole shot, with the
        contacts that cling; in a game ``Frame.play`` draws both.

        Raises:
            InputError: The shot has no strike, or a number is out of range.
        """
        inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
        (row,) = _core.draw_strikes(inner, self, 1, whole("seed", seed), whole("index", index))
        return like(row.tolist(), shot.to_dict()["strike"])

    def variant(self, shot: carom.Shot, index: int = 0, *, seed: int = 0) -> carom.Shot:
        """Variant ``index`` of ``Shot.vary`` as an ordinary shot, with its strike and its cling.

        The contacts that cling are the key ``cling`` of its file, so it simulates to the same bits
        everywhere.

        Raises:
            InputError: The shot has no strike, a number is out of range, or the drawn strike cannot
                be played, as in ``NoisyResult.errors``.
        """
        inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
        return shot._wrap(_core.variant(inner, self, whole("seed", seed), whole("index", index)))


@dataclass(frozen=True, slots=True)
class Perception:
    """Errors of the positions at which a player perceives the balls, which are Gaussian.

    ``Shot.evaluate`` and similar functions take the shot as the player sees and plans it. Every
    variant has the balls at positions where they may truly be: the difference between true and
    perceived positions has the same distribution in both directions.

    Attributes:
        position: Standard deviation of true minus perceived position, m: one for each coordinate,
            or a pair along x and along y, such as a camera's across and along its view.
        correlation: Correlation of the errors along x and y, −1 to 1.
        balls: Errors of single balls by id, in place of those: a standard deviation, a pair, or a
            ``Perception``. An id that is not on the table has no effect.

    Raises:
        InputError: A standard deviation is negative, not finite, or more than 0.1 m, or a
            correlation is beyond ±1.
    """

    position: float | Sequence[float] = 0.0
    correlation: float = field(default=0.0, kw_only=True)
    balls: Mapping[str, float | Sequence[float] | Perception] = field(
        default_factory=dict, kw_only=True, hash=False
    )

    def __post_init__(self) -> None:
        position: float | tuple[float, ...]
        if not hasattr(self.position, "__len__"):
            position = number("perception.position", self.position)
        else:
            position = numbers("perception.position", self.position, 2)
        object.__setattr__(self, "position", position)
        correlation = number("perception.correlation", self.correlation)
        object.__setattr__(self, "correlation", correlation)
        given: Any = self.balls
        if not isinstance(given, Mapping):
            fault = f"found {type(given).__name__}"
            raise InputError(
                "wrong-type", "perception.balls", fault, "give a dict of errors by ball"
            )
        balls = {
            text("perception.balls", ball, 'a ball\'s id, such as "cue"'): self._of_ball(
                ball, error
            )
            for ball, error in given.items()
        }
        object.__setattr__(self, "balls", balls)
        _core.check_perception(self)

    @staticmethod
    def _of_ball(ball: str, error: float | Sequence[float] | Perception) -> Perception:
        try:
            found = error if isinstance(error, Perception) else Perception(error)
        except InputError as refused:
            raise refused.inside(f"perception.balls[{ball!r}]", ": ") from None
        if found.balls:
            raise InputError(
                "conflict", f"perception.balls[{ball!r}].balls", "a ball has no balls", "remove it"
            )
        return found

    @property
    def sigma(self) -> tuple[float, float]:
        """Standard deviations along x and along y, m."""
        if isinstance(self.position, float):
            return (self.position, self.position)
        x, y = self.position
        return (x, y)

    @property
    def errors(self) -> list[tuple[str, tuple[float, float], float]]:
        """The balls with errors of their own: id, standard deviations (m), correlation."""
        return [
            (ball, error.sigma, error.correlation)
            for ball, error in self.balls.items()
            if isinstance(error, Perception)
        ]

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for files."""
        x, y = self.sigma
        values: dict[str, Any] = {"position": x if x == y else [x, y]}
        if self.correlation:
            values["correlation"] = self.correlation
        if self.balls:
            values["balls"] = {
                ball: error.to_dict()
                for ball, error in self.balls.items()
                if isinstance(error, Perception)
            }
        return values

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """The perception with the values of ``to_dict``.

        Raises:
            InputError: There is an unknown key, or a value is wrong.
        """
        known = dict(_known("perception", values, [each.name for each in fields(cls)]))
        balls = known.get("balls", {})
        if isinstance(balls, Mapping):
            known["balls"] = {
                ball: Perception.from_dict(error) if isinstance(error, Mapping) else error
                for ball, error in balls.items()
            }
        return cls(**known)

    def see(self, shot: carom.Shot, index: int = 0, *, seed: int = 0) -> carom.Shot:
        """The shot with the balls at perceived positions.

        Perceived balls do not overlap and stay on the table: where they would not, the error is
        halved until they do. The same ``index`` and ``seed`` give the same positions on every
        platform.

        Raises:
            InputError: A number is out of range, or the strike cannot be played on the perceived
                positions.
        """
        inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
        return shot._wrap(_core.see(inner, self, whole("seed", seed), whole("index", index)))


@dataclass(frozen=True, slots=True)
class NoisyResult(BatchResult):
    """The ends of a shot's noisy variants, with their strikes.

    Attributes:
        speed: The cue's speed, m/s, float64 of shape (n_shots,).
        azimuth: The cue's direction, rad, same shape.
        elevation: Butt raised above horizontal, rad, same shape.
        side: Contact point right of centre, ball radii, same shape.
        height: Contact point above centre, ball radii, same shape.
    """

    speed: NDArray[np.float64]
    azimuth: NDArray[np.float64]
    elevation: NDArray[np.float64]
    side: NDArray[np.float64]
    height: NDArray[np.float64]


def vary(
    shot: carom.Shot,
    noise: Noise,
    n: int,
    seed: int = 0,
    *,
    perception: Perception | None = None,
    first: int = 0,
    threads: int | None = None,
    device: str = "cpu",
    progress: bool = False,
) -> NoisyResult:
    """Simulate ``n`` executions of the shot's strike, each with other errors of the player.

    Variant ``index`` of a seed is the same for any ``n``, ``first`` and ``threads``, on every
    platform.

    A drawn strike that cannot be played is replaced by the nearest that can. A tip offset beyond
    the miscue limit is moved back along its direction to 0.999 of it (with ``"miscue": "report"``,
    of the ball's radius); the speed stays within [0.01, 50] m/s and the elevation within [0, 89°].
    So a strike near the miscue limit looks safer than it is.

    Args:
        shot: The shot as the player sees and plans it.
        noise: Errors of the strike.
        n: Number of variants.
        seed: Seed of the random numbers, a whole number from 0 to 2⁶⁴ − 1.
        perception: Errors of the perceived positions, as in ``Shot.evaluate``.
        first: Index of the first variant, so that long runs can be continued.
        threads: Number of threads; None is one per core.
        device: ``"cpu"``, ``"cuda"`` or ``"cuda:1"``; see ``carom.device``.
        progress: Show a progress bar on stderr.

    Returns:
        A row for each variant, and the strikes. ``errors`` has the variants that could not be
        played, by row: a cue that would pass through a ball, if the shot refuses that; an offset
        too large for the tip's efficiency; the cap on events.

    Raises:
        InputError: The shot has no strike, a number is out of range, ``device`` cannot be used, or
            there are too many variants for one call.
    """
    inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
    noise, perception = noise_or_default(noise), perception_or_none(perception)
    seed, first = whole("seed", seed), whole("first", first)
    n = whole("n", n, WORD - first)
    own_strike(inner)
    check_results("n", n, len(inner))
    strikes = np.empty((5, n))
    card = opened(device)

    def run(start: int, end: int) -> Arrays:
        rows = _core.draw_strikes(inner, noise, end - start, seed, first + start)
        strikes[:, start:end] = rows.T
        draw = (seed, first + start)
        return _core.simulate_variants(
            inner, rows, noise, perception, draw, thread_count(threads), card
        )

    ends = in_chunks(run, n, len(inner), progress=progress)
    return NoisyResult(ends.final_position, ends.pocket, ends.events, ends.errors, *strikes)


def noise_or_default(noise: Noise | None, name: str = "noise") -> Noise:
    """The noise; the Olympiad's if None. The error calls the argument ``name``.

    Raises:
        InputError: It is neither None nor a ``carom.Noise``.
    """
    return instance(
        name, Noise.olympiad() if noise is None else noise, Noise, 'carom.Noise.preset("club")'
    )


def perception_or_none(perception: Perception | None) -> Perception:
    """The perception; one without errors if None.

    Raises:
        InputError: It is neither None nor a ``carom.Perception``.
    """
    exact = Perception() if perception is None else perception
    return instance("perception", exact, Perception, "carom.Perception(0.002)")


def _rows(place: str, rows: Any) -> tuple[tuple[float, ...], ...]:
    """Rows of five numbers.

    Raises:
        InputError: They are not.
    """
    try:
        listed = list(rows)
    except TypeError:
        fault = f"found {type(rows).__name__}"
        raise InputError("wrong-type", place, fault, "give rows of five numbers") from None
    return tuple(numbers(f"{place}[{i}]", row, 5) for i, row in enumerate(listed))


def _times(row: Sequence[float], factor: float) -> list[float]:
    return [x * factor for x in row]


def _known(place: str, values: Any, keys: list[str]) -> Mapping[str, Any]:
    """The values, of which every key is one of ``keys``.

    Raises:
        InputError: One is not, or the values are not a mapping.
    """
    if not isinstance(values, Mapping):
        raise InputError("wrong-type", place, f"found {type(values).__name__}", "give a dict")
    for key in values:
        if key not in keys:
            raise InputError(
                "unknown-name", place, f"there is no key {key!r}", f"write one of {', '.join(keys)}"
            )
    return values
