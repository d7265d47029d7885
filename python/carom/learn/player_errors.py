"""Strikes as they were played, with the error of their measurement, beside intended ones."""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Self

from carom.errors import InputError
from carom.lazy import np
from carom.learn.filmed_strikes import FilmedStrike
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]

#: The numbers of a player's error. The first is a share of the intended speed.
NUMBERS = ("speed", "azimuth", "elevation", "side", "height")
#: For people: the unit of each number, and what a number is multiplied by.
UNITS = MappingProxyType(
    {
        "speed": ("%", 100.0),
        "azimuth": ("°", math.degrees(1.0)),
        "elevation": ("°", math.degrees(1.0)),
        "side": ("mm", 1000.0),
        "height": ("mm", 1000.0),
    }
)
#: Scale of each σ a priori: that of the noise preset `beginner`, at 2 m/s. Half of the prior is
#: below about 0.8 times it.
SCALE = (0.2, math.radians(0.6), math.radians(2.0), 0.003, 0.003)
#: A measurement is not taken as more exact than this share of the scale.
EXACT = 1e-3
#: Fewest samples of a strike from which a covariance is taken.
FEWEST = 12


@dataclass(frozen=True, slots=True, eq=False)
class PlayedStrike:
    """A strike as it was played, and how well it is known.

    Attributes:
        name: The shot's name.
        shot: The balls as they lay, with the played strike.
        vector: Natural logarithm of the speed in m/s, azimuth, elevation (rad), side, height (m);
            shape (5,).
        covariance: Covariance of the measurement in these units, shape (5, 5).

    Raises:
        InputError: A shape is another one, a number is not finite, or a variance is negative.
    """

    name: str
    shot: Shot
    vector: Floats
    covariance: Floats

    def __post_init__(self) -> None:
        place = f"shot {self.name}"
        if self.vector.shape != (5,) or self.covariance.shape != (5, 5):
            raise InputError(
                "wrong-count",
                place,
                f"the shapes are {self.vector.shape} and {self.covariance.shape}",
                "give five numbers and their covariance",
            )
        if not (np.isfinite(self.vector).all() and np.isfinite(self.covariance).all()):
            raise InputError(
                "out-of-range",
                place,
                "the strike or its covariance has a number that is not finite",
                "leave the shot out",
            )
        scaled = self.covariance / np.outer(SCALE, SCALE)
        values = np.linalg.eigvalsh((scaled + scaled.T) / 2.0)
        if values.min() < -1e-6 * max(1.0, values.max()):
            raise InputError(
                "out-of-range",
                place,
                "its covariance is not positive semidefinite",
                "give one such as numpy.cov(samples.T)",
            )

    @classmethod
    def exact(cls, name: str, shot: Shot) -> Self:
        """A strike that is known, such as that of a robot's log.

        Raises:
            InputError: The shot has no strike.
        """
        return cls(name, shot, vector_of(shot), np.zeros((5, 5)))

    @classmethod
    def of_samples(cls, name: str, shot: Shot, samples: ArrayLike) -> Self:
        """A strike that is known by draws from its posterior.

        Args:
            name: The shot's name.
            shot: The balls as they lay, with the played strike.
            samples: Shape (k, 6) or (k, 5), k at least 12: azimuth (rad), speed (m/s), side,
                height (ball radii), elevation (rad); a sixth column, the clock, is not used.

        Raises:
            InputError: The samples have another shape, are too few, or are not of strikes.
        """
        rows = np.asarray(samples, dtype=np.float64)
        if rows.ndim != 2 or rows.shape[1] not in (5, 6) or len(rows) < FEWEST:
            raise InputError(
                "wrong-count",
                f"samples of shot {name}",
                f"their shape is {rows.shape}",
                f"give at least {FEWEST} rows of azimuth, speed, side, height, elevation, clock",
            )
        if not np.isfinite(rows).all() or (rows[:, 1] <= 0.0).any():
            raise InputError(
                "out-of-range",
                f"samples of shot {name}",
                "a number is not finite, or a speed is not positive",
                "leave the shot out",
            )
        azimuth, speed, side, height, elevation = rows.T[:5]
        centre, radius = vector_of(shot), _radius(shot)
        turn = np.remainder(azimuth - centre[1] + math.pi, 2.0 * math.pi) - math.pi
        places = np.column_stack(
            (
                np.log(speed),
                centre[1] + turn,
                np.abs(elevation),
                side * radius,
                height * radius,
            )
        )
        return cls(name, shot, places.mean(axis=0), np.cov(places.T))

    @classmethod
    def of(cls, strike: FilmedStrike | Shot | PlayedStrike, name: str = "") -> PlayedStrike:
        """The strike of a film, or of a shot that is known.

        Raises:
            InputError: It has no strike, or a film's strike has no samples of its posterior.
        """
        if isinstance(strike, PlayedStrike):
            return strike
        if isinstance(strike, Shot):
            return cls.exact(name, strike)
        samples = getattr(strike, "samples", None)
        if samples is None or not len(samples):
            raise InputError(
                "missing",
                f"shot {strike.name}",
                "its strike has no samples, so its error of measurement is unknown",
                "find the strikes again, or give PlayedStrike.exact for strikes that are known",
            )
        return cls.of_samples(strike.name, strike.shot, samples)


def vector_of(shot: Shot) -> Floats:
    """The numbers of a strike, as in ``PlayedStrike.vector``.

    Raises:
        InputError: The shot has no strike.
    """
    strike, elevation = shot.strike, shot.elevation
    if strike is None or elevation is None:
        raise InputError("no-strike", "strike", "the shot has no strike", "give it one")
    radius = _radius(shot)
    return np.array(
        (
            math.log(strike.speed),
            strike.azimuth,
            elevation,
            strike.side * radius,
            strike.height * radius,
        )
    )


def _radius(shot: Shot) -> float:
    """Radius of the ball that is struck, m."""
    strike = shot.strike
    ball = None if strike is None else strike.ball
    return float(shot.radius[shot.ids.index(ball) if ball in shot.ids else 0])


def difference(played: Floats, intended: Floats) -> Floats:
    """Played minus intended, (..., 5), the azimuth within half a turn."""
    found: Floats = played - intended
    found[..., 1] = np.remainder(found[..., 1] + math.pi, 2.0 * math.pi) - math.pi
    return found
