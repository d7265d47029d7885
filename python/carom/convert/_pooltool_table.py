"""A pooltool table, which a file describes by segments, arcs and holes, as parameters.

This inverts pooltool's ``create_pocket_table_cushion_segments``, which computed the segments from
the table's specs. It reads one corner pocket (``lb``) and one side pocket (``lc``).
"""

from __future__ import annotations

import math
from typing import Any

from carom.convert._place import Place
from carom.reference import tables

JSON = dict[str, Any]

# Dimensions computed by pooltool's sines and back agree to this, m or degrees.
_SAME = 1e-9
# Decimal digits that are kept: a picometre is more than their rounding error.
_DIGITS = 12
_PRESETS = {"pocket": "showood-7ft", "snooker": "snooker-12ft", "billiard": "carom-10ft"}
_PHYSICS = {"pocket": "pool", "snooker": "snooker", "billiard": "carom"}
# A snooker table's baulk line, D and black spot, m (WPBSA).
_BAULK, _D_RADIUS, _BLACK = 0.737, 0.292, 0.324


def table(at: Place, notes: list[str]) -> tuple[str | JSON, str]:
    """The table for a shot file, and the name of its base physics preset."""
    kind = at["table_type"].text()
    if kind not in _PRESETS:
        raise at["table_type"].refuse(
            "unknown-name", f'is "{kind}"', f"write one of {', '.join(_PRESETS)}"
        )
    segments, base = at["cushion_segments"]["linear"], _PRESETS[kind]
    width = segments["12"]["p1"].vector()[0]
    length = segments["9"]["p1"].vector()[1]
    height = segments["9"]["p1"].vector()[2]
    found: JSON = {"base": base, "length": length, "width": width, "cushion_height": height}
    if kind == "billiard":
        found["markings"] = _quarters(width, length)
        return _named(base, found), _PHYSICS[kind]
    _check_symmetry(at, width, length, notes)
    rubber = -segments["5"]["p1"].vector()[0]
    found["cushion_width"] = rubber
    found["corner_pocket"] = _rounded(_corner(at))
    found["side_pocket"] = _rounded(_side(at, rubber))
    _widen(found["side_pocket"], rubber, notes)
    found["markings"] = (
        _quarters(width, length) if kind == "pocket" else _snooker_spots(width, length)
    )
    notes.append(
        f"Sights and the rails behind the cushions are not in the file: those of {base} were used."
    )
    return _named(base, found), _PHYSICS[kind]


def _corner(at: Place) -> JSON:
    """The corner pocket, from nose "18" and facing "1"; the tip is their intersection."""
    facing = at["cushion_segments"]["linear"]["1"]
    deep, shallow = facing["p1"].vector(), facing["p2"].vector()
    angle = math.atan2(shallow[0] - deep[0], shallow[1] - deep[1])
    tip = shallow[0] - shallow[1] * math.tan(angle)
    hole = at["pockets"]["lb"]
    center, radius = hole["center"].vector(), hole["radius"].number()
    mouth = math.sqrt(2.0) * tip
    return {
        "mouth": mouth,
        "cut_angle_deg": 90.0 + math.degrees(angle),
        "shelf": 0.5 * mouth - math.sqrt(2.0) * center[0] - radius,
        "hole_radius": radius,
        "point_radius": at["cushion_segments"]["circular"]["1t"]["radius"].number(),
    }


def _side(at: Place, rubber: float) -> JSON:
    """The side pocket, from nose "6" and facing "5" of the left rail's upper half.

    The rounded point touches the nose and the facing at the same distance d from the tip. On the
    facing this is d·cos α behind the nose line and d·sin α towards the pocket, which gives d and α.
    """
    segments = at["cushion_segments"]["linear"]
    deep, shallow = segments["5"]["p1"].vector(), segments["5"]["p2"].vector()
    nose, other = segments["6"]["p1"].vector(), segments["4"]["p1"].vector()
    middle = 0.5 * (deep[1] + other[1])
    behind, along = -shallow[0], nose[1] - shallow[1]
    if along > 0.0:
        inward = 0.5 * (along * along - behind * behind) / along
        tip = nose[1] - (along - inward)
        angle = math.atan2(inward, behind)
    else:
        tip = nose[1]
        angle = math.asin((tip - deep[1]) / rubber)
    hole = at["pockets"]["lc"]
    radius = hole["radius"].number()
    mouth, throat = 2.0 * (tip - middle), deep[1] - other[1]
    pocket = {
        "mouth": mouth,
        "cut_angle_deg": 90.0 + math.degrees(angle),
        "shelf": -hole["center"].vector()[0] - radius,
        "hole_radius": radius,
        "point_radius": at["cushion_segments"]["circular"]["5t"]["radius"].number(),
    }
    has_facing = behind < rubber
    if has_facing and abs(throat - (mouth - 2.0 * rubber * math.tan(angle))) > _SAME:
        pocket["throat"] = throat
    return pocket


def _rounded(pocket: JSON) -> JSON:
    """The pocket without the rounding errors of pooltool's sines, so that 0.083 m stays 0.083."""
    return {key: round(value, _DIGITS) for key, value in pocket.items()}


def _widen(pocket: JSON, rubber: float, notes: list[str]) -> None:
    """Widen a side pocket's hole that does not reach the lines on which its jaws end.

    Otherwise there would be slate beside the hole, which this engine does not model. The hole's
    edge on the pocket's axis stays in place. Let the jaws' deep ends be 2g apart and w behind the
    nose line, and let the jaws converge at the angle φ. The centre of a hole of radius r whose edge
    is s behind the nose line is then at the distance g·cos φ + (w − s − r)·sin φ from the jaws.
    """
    arc, radius = pocket["point_radius"], pocket["hole_radius"]
    angle = math.radians(pocket["cut_angle_deg"] - 90.0)
    touch = arc / math.tan(0.5 * (0.5 * math.pi + angle))
    gap = 0.5 * pocket["mouth"] - rubber * math.tan(angle)
    if touch * math.cos(angle) >= rubber:
        # The rail ends within the point's arc, before the facing.
        angle = math.asin((arc - rubber) / arc)
        gap = 0.5 * pocket["mouth"] + touch - arc * math.cos(angle)
    gap = 0.5 * pocket.get("throat", 2.0 * gap)
    sin, cos = math.sin(angle), math.cos(angle)
    least = (gap * cos + (rubber - pocket["shelf"]) * sin) / (1.0 + sin)
    if radius < least:
        # The margin keeps the hole wide enough after the engine's rounding.
        pocket["hole_radius"] = least + _SAME
        notes.append(
            "The holes of the side pockets do not reach their jaws: widened from a radius of "
            f"{1e3 * radius:.1f} mm to {1e3 * least:.1f} mm."
        )


def _check_symmetry(at: Place, width: float, length: float, notes: list[str]) -> None:
    """Note a table that is not symmetric: a parametric description always is."""
    points = [
        (*(c["center"].vector()[:2]), c["radius"].number())
        for part in (at["pockets"], at["cushion_segments"]["circular"])
        for _, c in part.members()
    ]
    for _, segment in at["cushion_segments"]["linear"].members():
        points += [(*segment[end].vector()[:2], 0.0) for end in ("p1", "p2")]

    def held(x: float, y: float, r: float) -> bool:
        return any(max(abs(x - a), abs(y - b), abs(r - c)) <= _SAME for a, b, c in points)

    if not all(held(width - x, y, r) and held(x, length - y, r) for x, y, r in points):
        notes.append(
            "The table is not symmetric: all its pockets were made like the bottom left one and "
            "the left one."
        )


def _quarters(width: float, length: float) -> JSON:
    spots = zip(("head", "center", "foot"), (0.25, 0.5, 0.75), strict=True)
    return {
        "head_string": 0.25 * length,
        "spots": [{"name": n, "position": [0.5 * width, y * length]} for n, y in spots],
    }


def _snooker_spots(width: float, length: float) -> JSON:
    middle = 0.5 * width
    spots = {
        "yellow": [middle + _D_RADIUS, _BAULK],
        "green": [middle - _D_RADIUS, _BAULK],
        "brown": [middle, _BAULK],
        "blue": [middle, 0.5 * length],
        "pink": [middle, 0.75 * length],
        "black": [middle, length - _BLACK],
    }
    return {
        "head_string": _BAULK,
        "d_radius": _D_RADIUS,
        "spots": [{"name": name, "position": at} for name, at in spots.items()],
    }


def _named(base: str, found: JSON) -> str | JSON:
    """The preset's name if all dimensions are the preset's, else the description."""
    preset = next(t for t in tables() if t["name"] == base)
    own = {d["key"]: d["value"] for d in preset["dimensions"]}
    for key, value in found.items():
        if key in {"base", "markings"}:
            continue
        figures = value if isinstance(value, dict) else {"": value}
        for inner, figure in figures.items():
            theirs = own.get(f"{key}.{inner}".rstrip("."))
            if theirs is None or abs(theirs - figure) > _SAME:
                return found
    return base
