"""Rolling resistance in bands of speed, as docs/formats.md describes it."""

from __future__ import annotations

from typing import Any

Number = Any
JSON = dict[str, Any]

#: A ball at the end of a band has the speed of the end up to rounding, a fraction of it, and
#: begins the band below.
ROUNDING = 1e-12


def band(cloth: JSON, speed: Number) -> tuple[float, float]:
    """The coefficient at a speed (m/s), and the lower end of its band, m/s."""
    friction = cloth["rolling_friction"]
    if not isinstance(friction, list):
        return friction, 0.0
    low = 0.0
    for item in friction[:-1]:
        if speed <= item["up_to"] * (1 + ROUNDING):
            return item["friction"], low
        low = item["up_to"]
    return friction[-1]["friction"], low
