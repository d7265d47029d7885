"""Strikes that are known apart from a film: where the search for the played ones begins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.arguments import instance
from carom.errors import InputError
from carom.lazy import np
from carom.learn.tracks import Tracks
from carom.noise import Noise
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


#: A strike is not taken as known more exactly than this: azimuth (rad), speed (m/s), side, height
#: (ball radii), elevation (rad). Smaller, and rounding would decide the search.
SMALLEST = (1e-5, 1e-4, 1e-4, 1e-4, 1e-5)


@dataclass(frozen=True, slots=True, eq=False)
class IntendedStrike:
    """A strike as it was intended, or measured by other means than the film.

    Attributes:
        vector: Azimuth (rad), speed (m/s), side, height (ball radii), elevation (rad).
        sigma: Standard deviation of the played strike about it; infinite if it is unknown.
    """

    vector: Floats
    sigma: Floats

    def to_list(self) -> list[list[float]]:
        """Both, as values of JSON."""
        return [self.vector.tolist(), self.sigma.tolist()]


def intended_strikes(
    tracks: Tracks, intended: Shot | Mapping[str, Shot] | None, noise: Noise | None
) -> list[IntendedStrike | None]:
    """The intended strike of each shot of some tracks, None where there is none.

    Args:
        tracks: The filmed shots.
        intended: The shot with the intended strike, if all shots are repetitions of it; or one for
            each shot by its name.
        noise: Errors of the played strikes about the intended ones; None if they are unknown.

    Raises:
        InputError: A shot has no strike, a name is not that of a filmed shot, or there is a noise
            without an intention.
    """
    if intended is None:
        if noise is not None:
            fault, remedy = "there is no strike that it belongs to", "give intended too"
            raise InputError("missing", "noise", fault, remedy)
        return [None] * len(tracks)
    names = [shot.name for shot in tracks]
    if not isinstance(intended, Mapping):
        return [_intended(intended, noise)] * len(names)
    for name in intended:
        if name not in names:
            raise InputError(
                "unknown-name",
                "intended",
                f"no shot is called {name!r}",
                "give names of the tracks",
            )
    return [_intended(intended[name], noise) if name in intended else None for name in names]


def _intended(shot: Shot, noise: Noise | None) -> IntendedStrike:
    instance("intended", shot, Shot, "carom.Shot.load(...)")
    strike = shot.strike
    if strike is None:
        raise InputError("no-strike", "intended", "the shot has no strike", "give it one")
    meant = (strike.azimuth, strike.speed, strike.side, strike.height, shot.elevation)
    if noise is None:
        return IntendedStrike(np.array(meant, dtype=float), np.full(5, np.inf))
    instance("noise", noise, Noise, 'carom.Noise.preset("club")')
    radius = float(shot.radius[shot.ids.index(strike.ball)])
    unit, order = np.array((1.0, 1.0, 1.0, radius, radius)), [1, 0, 3, 4, 2]
    mean = (np.array(noise.mean()) / unit)[order]
    sigma = (np.array(noise.deviations(strike.speed)) / unit)[order]
    return IntendedStrike(np.array(meant, dtype=float) + mean, np.maximum(sigma, SMALLEST))
