"""A pooltool table, of which a file holds segments, arcs and holes, as a parametric description.

What pooltool's ``create_pocket_table_cushion_segments`` made of the table's specs is undone here,
from one corner pocket (``lb``) and one side pocket (``lc``).
"""

from __future__ import annotations

import math
from typing import Any

from carom.convert._place import Place
from carom.reference import tables

JSON = dict[str, Any]

# Figures that went through pooltool's sines and back agree to this, m or degrees.
_SAME = 1e-9
# A picometre is more than their rounding.
_DIGITS = 12
_PRESETS = {"pocket": "showood-7ft", "snooker": "snooker-12ft", "billiard": "carom-10ft"}
_PHYSICS = {"pocket": "pool", "snooker": "snooker", "billiard": "carom"}
# A snooker table's baulk line, D and black spot, m (WPBSA).
_BAULK, _D_RADIUS, _BLACK = 0.737, 0.292, 0.324


def table(at: Place, notes: list[str]) -> tuple[str | JSON, str]:
    """What a shot file writes for the table, and the physics preset to start from."""
    kind = at["table_type"].text()
    if kind not in _PRESETS:
        raise at["table_type"].refuse(f'is "{kind}", but must be one of {", ".join(_PRESETS)}')
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
        f"Rails behind the cushions and sights are not in the file: they are those of {base}."
    )
    return _named(base, found), _PHYSICS[kind]


def _corner(at: Place) -> JSON:
    """Nose "18" and facing "1" of the bottom rail's left end; the tip is where they would meet."""
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
    """Nose "6" and facing "5" of the left rail's upper half.

    The point touches the nose at the distance d from the tip, and the facing at as much: there at
    d·cos α behind the nose line and d·sin α towards the pocket, which gives d and α.
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
    """Without the rounding of pooltool's sines, so that 0.083 m is written as that."""
    return {key: round(value, _DIGITS) for key, value in pocket.items()}


def _widen(pocket: JSON, rubber: float, notes: list[str]) -> None:
    """Widen a side's hole that does not reach the lines on which its jaws end.

    It would leave slate beside it, which this engine does not have. Its edge on the pocket's axis
    stays where it is. With half a gap g at the deep ends, w behind the nose line, and lines that
    close in at φ, the centre of a hole of radius r that begins s behind the nose line is as far
    from them as g·cos φ + (w − s − r)·sin φ.
    """
    arc, radius = pocket["point_radius"], pocket["hole_radius"]
    angle = math.radians(pocket["cut_angle_deg"] - 90.0)
    touch = arc / math.tan(0.5 * (0.5 * math.pi + angle))
    gap = 0.5 * pocket["mouth"] - rubber * math.tan(angle)
    if touch * math.cos(angle) >= rubber:
        # The point's arc ends before it is a facing.
        angle = math.asin((arc - rubber) / arc)
        gap = 0.5 * pocket["mouth"] + touch - arc * math.cos(angle)
    gap = 0.5 * pocket.get("throat", 2.0 * gap)
    sin, cos = math.sin(angle), math.cos(angle)
    least = (gap * cos + (rubber - pocket["shelf"]) * sin) / (1.0 + sin)
    if radius < least:
        # So that the engine's rounding finds it wide enough too.
        pocket["hole_radius"] = least + _SAME
        notes.append(
            "The holes of the side pockets do not reach their jaws: widened from a radius of "
            f"{1e3 * radius:.1f} mm to {1e3 * least:.1f} mm."
        )


def _check_symmetry(at: Place, width: float, length: float, notes: list[str]) -> None:
    """A description has two mirror planes; a table built by hand need not."""
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
            "The table is not symmetric: its pockets are taken to be as the bottom left and the "
            "left one."
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
    """The preset's bare name where every figure is its own."""
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
