"""Errors of a player: strikes differ from the intended ones, positions from the perceived ones."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Self

from carom import _core
from carom.arguments import (
    WORD,
    check_results,
    core,
    instance,
    number,
    text,
    thread_count,
    whole,
)
from carom.batch import Arrays, BatchResult, in_chunks, own_strike
from carom.build import Strike, like
from carom.deprecated import renamed_fields
from carom.errors import InputError
from carom.lazy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    import carom


# The standard deviations among the fields of `Noise`.
_SIGMAS = ("speed", "azimuth", "elevation", "side_m", "height_m")


@renamed_fields(side="side_m", height="height_m")
@dataclass(frozen=True, slots=True)
class Noise:
    """Errors of a strike, Gaussian and independent of each other, and cling between balls.

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

    Raises:
        InputError: A number is negative, not finite, or far beyond what a player does.
    """

    speed: float = 0.0
    azimuth: float = 0.0
    elevation: float = 0.0
    side_m: float = 0.0
    height_m: float = 0.0
    cling_probability: float = 0.0
    cling_friction: float = 0.22

    def __post_init__(self) -> None:
        for field in fields(self):
            value = number(f"noise.{field.name}", getattr(self, field.name))
            object.__setattr__(self, field.name, value)
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
            raise InputError(f"noise: there is no preset {base!r}; write one of {known}")
        try:
            multiplier = float(factor) if colon else 1.0
        except ValueError:
            raise InputError(f"noise: {factor!r} is not a multiplier; write a number") from None
        return cls(*presets[base]).scaled(multiplier)

    def scaled(self, multiplier: float) -> Self:
        """This noise with every σ multiplied by ``multiplier``; the cling stays.

        Raises:
            InputError: The multiplier is negative, not finite or too large.
        """
        factor = number("multiplier", multiplier)
        scaled = {sigma: getattr(self, sigma) * factor for sigma in _SIGMAS}
        return replace(self, **scaled)

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
        position: Standard deviation of true minus perceived position, per coordinate, m.

    Raises:
        InputError: It is negative, not finite, or more than 0.1 m.
    """

    position: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "position", number("perception.position", self.position))
        _core.check_perception(self)

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
        progress: Show a progress bar on stderr.

    Returns:
        A row for each variant, and the strikes. ``errors`` has the variants that could not be
        played, by row: a cue that would pass through a ball, if the shot refuses that; an offset
        too large for the tip's efficiency; the cap on events.

    Raises:
        InputError: The shot has no strike, a number is out of range, or there are too many
            variants for one call.
    """
    inner = core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
    noise, perception = noise_or_default(noise), perception_or_none(perception)
    seed, first = whole("seed", seed), whole("first", first)
    n = whole("n", n, WORD - first)
    own_strike(inner)
    check_results("n", n, len(inner))
    strikes = np.empty((5, n))

    def run(start: int, end: int) -> Arrays:
        rows = _core.draw_strikes(inner, noise, end - start, seed, first + start)
        strikes[:, start:end] = rows.T
        draw = (seed, first + start)
        return _core.simulate_variants(inner, rows, noise, perception, draw, thread_count(threads))

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
