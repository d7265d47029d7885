"""Rolling resistance that grows with speed."""

from __future__ import annotations

from typing import Any

from carom import _core
from carom.arguments import number

#: Standard gravity (CGPM 1901), m/s², as in the presets except ``poolfiz``.
STANDARD_GRAVITY = 9.80665


def rolling_bands(
    a: float,
    b: float,
    *,
    fastest: float = 3.0,
    share: float = 0.005,
    least: float = 0.005,
    gravity: float = STANDARD_GRAVITY,
) -> float | list[dict[str, Any]]:
    """Speed bands that follow a measured deceleration of rolling balls, a + b·v.

    The result is a value of ``cloth.rolling_friction``::

        bands = carom.rolling_bands(0.0410, 0.0142)
        physics = carom.Physics.preset("carom", cloth={"rolling_friction": bands})

    In each band the coefficient is the one with which a ball that slows from the upper to the lower
    end rolls as far as by the law: (c² − f²)/2gS for a band from f to c, where
    S = (c − f)/b − (a/b²) ln((a + bc)/(a + bf)). A ball that starts at an end of a band therefore
    comes to rest at the place of the law; one that starts within a band stops at most the error
    below short of it. The bands are the fewest with this error.

    Args:
        a: Deceleration at speed 0, m/s², > 0.
        b: Growth with speed, 1/s, ≥ 0.
        fastest: Highest speed at which the law is followed, m/s. The last band holds for all
            faster balls.
        share: Largest error of the place where a ball stops, as a share of the roll's length.
        least: An error that is always allowed, m, > 0; the larger of the two counts.
        gravity: m/s².

    Returns:
        The list of bands, or a number if one band is enough.

    Raises:
        InputError: A value is out of range, or the law needs more than 16 bands.
    """
    law = (number("a", a), number("b", b))
    tolerance = (number("fastest", fastest), number("share", share), number("least", least))
    bands: float | list[dict[str, Any]] = _core.rolling_bands(
        law, tolerance, number("gravity", gravity)
    )
    return bands
