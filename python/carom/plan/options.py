"""Options of questions about shots, as frozen objects. Rust reads them by attribute."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from carom.arguments import number, numbers, whole
from carom.errors import InputError
from carom.noise import Noise, Perception, noise_or_default, perception_or_none

# Largest number of variants of one question. A 95 % interval is then about 0.00006 wide, far
# shorter than needed.
MOST_VARIANTS = 10**9


@dataclass(frozen=True, slots=True)
class Sampling:
    """The errors of a player, and how precisely a probability is counted.

    Attributes:
        noise: Errors of the strike; the Olympiad's if None.
        perception: Errors of the perceived positions; none if None.
        seed: Seed of the random numbers, a whole number from 0 to 2⁶⁴ − 1.
        n: Largest number of variants.
        precision: Stop when half the width of the confidence interval is at most this; None
            plays all ``n``.
        level: Confidence level of the intervals, in (0, 1).

    Raises:
        InputError: A value has the wrong type or is out of range.
    """

    noise: Noise | None = None
    perception: Perception | None = None
    seed: int = 0
    n: int = 1000
    precision: float | None = None
    level: float = 0.95

    def __post_init__(self) -> None:
        precision = self.precision
        checked = {
            "noise": noise_or_default(self.noise),
            "perception": perception_or_none(self.perception),
            "seed": whole("seed", self.seed),
            "n": whole("n", self.n, MOST_VARIANTS + 1),
            "precision": None if precision is None else number("precision", precision),
            "level": number("level", self.level),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)


@dataclass(frozen=True, slots=True)
class Search:
    """The range and the effort of a search for strikes.

    Attributes:
        speed: Least and greatest speed of the cue, m/s.
        offset: Largest tip offset, ball radii; at most 95 % of the miscue limit is used.
        elevation: Largest elevation, rad, for jumps and massés; None tries only the shot's own.
        azimuth_reach: First and last azimuth, rad, counter-clockwise; None has no limit.
        elevation_reach: Least and greatest elevation of every strike, rad; None has no limit.
        butt: Corners of the rectangle in which the end of the butt must be, m; None has no limit.
        samples: Strikes spread over the whole range, in addition to those that geometry proposes.
        wanted: Largest number of strikes returned.
        per_route: Largest number of them over the same cushions and balls.

    Raises:
        InputError: A value has the wrong type.
    """

    speed: tuple[float, float] = (0.5, 7.0)
    offset: float = 0.45
    elevation: float | None = None
    samples: int = 4096
    wanted: int = 10
    per_route: int = 3
    azimuth_reach: tuple[float, float] | None = None
    elevation_reach: tuple[float, ...] | None = None
    butt: tuple[Sequence[float], Sequence[float]] | None = None

    def __post_init__(self) -> None:
        elevation = self.elevation
        checked = {
            "speed": numbers("speed", self.speed, 2),
            "offset": number("offset", self.offset),
            "elevation": None if elevation is None else number("elevation", elevation),
            "samples": whole("samples", self.samples),
            "wanted": whole("wanted", self.wanted),
            "per_route": whole("per_route", self.per_route),
            "azimuth_reach": _range("azimuth", self.azimuth_reach),
            "elevation_reach": _range("elevation", self.elevation_reach),
            "butt": None if self.butt is None else _corners(self.butt),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)


@dataclass(frozen=True, slots=True)
class Goal:
    """What a strike must achieve, with balls and pockets by index.

    Attributes:
        pot: A ball that falls, and the pocket, or None for any.
        leave: Centre (m) and radius (m) of the disc in which the cue ball comes to rest.
        first: The ball that the cue ball touches first.
    """

    pot: tuple[int, int | None] | None = None
    leave: tuple[tuple[float, float], float] | None = None
    first: int | None = None


def _range(name: str, limits: Any) -> tuple[float, ...] | None:
    return None if limits is None else numbers(name, limits, 2)


def _corners(butt: Any) -> tuple[tuple[float, ...], ...]:
    """Two corners of a rectangle.

    Raises:
        InputError: They are not two points.
    """
    try:
        one, other = butt
    except (TypeError, ValueError):
        raise InputError(
            "wrong-type", "butt", f"{butt!r} is not a rectangle", "give ((x, y), (x, y)) in m"
        ) from None
    return numbers("butt[0]", one, 2), numbers("butt[1]", other, 2)
