"""The rails of a table as lines on which the centres of balls turn back."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from carom.lazy import np
from carom.learn.header import TracksHeader, table_geometry

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Cushion:
    """A straight part of a rail.

    Attributes:
        rail: Its name, as traces have it.
        part: ``"nose"``, ``"facing"`` or ``"point"``, the chord of its arc.
        start: m.
        end: m.
        inward: Unit normal that points to the balls.
        reach: Distance of a ball's centre from the line of the nose in a contact, m.
    """

    rail: str
    part: str
    start: tuple[float, float]
    end: tuple[float, float]
    inward: tuple[float, float]
    reach: float

    def contact(self, place: Floats) -> tuple[float, Floats]:
        """Distance of a ball's surface from the cushion, m, and the direction away from it."""
        start = np.array(self.start)
        along = np.array(self.end) - start
        share = float((place - start) @ along) / float(along @ along)
        if 0.0 <= share <= 1.0:
            away: Floats = np.array(self.inward)
            return float((place - start) @ away) - self.reach, away
        off = place - (start if share < 0.0 else np.array(self.end))
        size = float(np.hypot(*off))
        return size - self.reach, off / max(size, 1e-9)


def cushions_of(header: TracksHeader) -> list[Cushion]:
    """The straight parts of the rails of a table; empty without a table or a radius."""
    if header.table is None or header.radius is None:
        return []
    table = header.table
    key = table if isinstance(table, str) else _frozen(table)
    return list(_cushions(key, header.radius))


def _frozen(table: Mapping[str, Any]) -> str:
    return json.dumps(dict(table), sort_keys=True)


@lru_cache(maxsize=32)
def _cushions(key: str, radius: float) -> tuple[Cushion, ...]:
    table = json.loads(key) if key.startswith("{") else key
    geometry = table_geometry(table)
    width, length = geometry["size"]
    centre = np.array((width, length)) / 2.0
    middles = {
        c["rail"]: (np.array(c["start"]) + np.array(c["end"])) / 2.0
        for c in geometry["cushions"]
        if c["part"] == "nose"
    }
    above = geometry["cushion_height"] - radius
    reach = math.sqrt(max(radius * radius - above * above, 0.0))
    found = []
    for cushion in geometry["cushions"]:
        if "start" not in cushion or cushion["part"] not in ("nose", "facing", "point"):
            continue
        start, end = cushion["start"], cushion["end"]
        along = np.subtract(end, start)
        size = float(np.hypot(*along))
        if size < 1e-6:
            continue
        normal = np.array((-along[1], along[0])) / size
        # A nose faces the table; facings and points face away from the middle of their rail.
        middle = middles[cushion["rail"]]
        towards = centre - middle if cushion["part"] == "nose" else np.array(start) - middle
        if normal @ towards < 0.0:
            normal = -normal
        found.append(
            Cushion(
                cushion["rail"],
                cushion["part"],
                (float(start[0]), float(start[1])),
                (float(end[0]), float(end[1])),
                (float(normal[0]), float(normal[1])),
                reach,
            )
        )
    return tuple(found)
