"""Which column of a table holds what, and in which unit, from the names of the columns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from carom.errors import InputError
from carom.learn.header import COLUMNS, NEEDED, UNITS

# Names in small letters that a column may have; a unit may follow behind an underscore.
_SYNONYMS: Mapping[str, tuple[str, ...]] = {
    "shot": ("shot", "shot_id", "shotid", "shot_name", "stroke"),
    "ball": ("ball", "ball_id", "ballid", "object", "object_id", "track_id"),
    "t": ("t", "time", "timestamp", "seconds", "frame", "frame_number"),
    "x": ("x", "pos_x", "position_x", "center_x", "cx"),
    "y": ("y", "pos_y", "position_y", "center_y", "cy"),
    "sigma": ("sigma", "sd", "std"),
    "visible": ("visible", "seen"),
}
_TIMES = {"s": "s", "sec": "s", "ms": "ms", "us": "us"}


@dataclass(frozen=True, slots=True)
class ColumnNames:
    """The names of the columns of a table, and the units that these names have.

    Attributes:
        names: The column of each of ``COLUMNS`` that the table has.
        unit: Unit of length in the names of x and y; None if they have none.
        time_unit: Unit of time in the name of t; None if it has none.
        unused: The columns that hold nothing of use.
    """

    names: dict[str, str]
    unit: str | None
    time_unit: str | None
    unused: list[str]


def recognise_columns(found: list[str], given: Mapping[str, str], place: str) -> ColumnNames:
    """Find out which column is which.

    Args:
        found: The names in the file.
        given: The names that the header or the caller gives for some of ``COLUMNS``.
        place: The file, for messages.

    Raises:
        InputError: A column is missing.
    """
    names: dict[str, str] = {}
    for key, column in given.items():
        if column not in found:
            raise InputError(
                "missing",
                place,
                f"it has no column {column!r} for {key}",
                f"write one of {', '.join(map(repr, found))} for {key}",
            )
        names[key] = column
    units: dict[str, str] = {}
    taken = set(names.values())
    for key in COLUMNS:
        if key in names:
            continue
        for column in found:
            if column in taken:
                continue
            unit = _matches(key, column)
            if unit is not None:
                names[key] = column
                units[key] = unit
                taken.add(column)
                break
    missing = [key for key in NEEDED if key not in names and key != "shot"]
    if missing:
        raise InputError(
            "missing",
            place,
            f"no column for {', '.join(missing)} among {', '.join(map(repr, found))}",
            f"name it: columns={{{missing[0]!r}: ...}}, or --columns {missing[0]}=...",
        )
    lengths = {units[key] for key in ("x", "y") if units.get(key)}
    if len(lengths) > 1:
        raise InputError(
            "conflict",
            place,
            f"the columns {names['x']!r} and {names['y']!r} have different units",
            "write both in one unit",
        )
    unit = next(iter(lengths), None)
    if unit == "px":
        raise InputError(
            "unsupported",
            place,
            f"the places in {names['x']!r} are pixels",
            "rename the columns to x and y, and give unit (metres in a pixel) and origin",
        )
    unused = [column for column in found if column not in names.values()]
    return ColumnNames(names, unit, units.get("t") or None, unused)


def _matches(key: str, column: str) -> str | None:
    """The unit in the name of a column if it is one of this kind, ``""`` without; else None."""
    name = column.strip().lower().replace(" ", "_").replace("[", "").replace("]", "")
    name = name.replace("(", "").replace(")", "")
    if name in _SYNONYMS[key]:
        return "frame" if key == "t" and name.startswith("frame") else ""
    stem, _, unit = name.rpartition("_")
    if key == "t" and stem in _SYNONYMS[key] and unit in _TIMES:
        return _TIMES[unit]
    if key in ("x", "y") and stem in _SYNONYMS[key] and (unit in UNITS or unit == "px"):
        return unit
    if key == "sigma" and stem in _SYNONYMS[key] and unit in UNITS:
        return ""
    return None
