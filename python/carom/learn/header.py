"""The header of tracks, ``carom-tracks/1``: table, balls, frame, clock and sampling rule."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal

from carom.arguments import number, truth
from carom.arguments import text as checked_text
from carom.errors import InputError
from carom.lazy import np
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import NDArray

FORMAT = "carom-tracks/1"

#: Metres per unit of length.
UNITS: Mapping[str, float] = MappingProxyType(
    {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
)
#: Seconds per unit of time; a frame needs the rate.
TIME_UNITS: Mapping[str, float] = MappingProxyType({"s": 1.0, "ms": 1e-3, "us": 1e-6})
ORIGINS = ("corner", "centre")
AXES = ("width", "length")
#: The columns of a file.
COLUMNS = ("shot", "ball", "t", "x", "y", "sigma", "visible")
NEEDED = ("shot", "ball", "t", "x", "y")
_KEYS = (
    "format",
    "table",
    "radius",
    "sigma",
    "frame",
    "clock",
    "least_move",
    "columns",
    "note",
)


@dataclass(frozen=True, slots=True)
class FileFrame:
    """How the coordinates of a file lie on the table.

    Attributes:
        unit: Unit of length: ``m``, ``dm``, ``cm``, ``mm``, ``in`` or ``ft``, or the number of
            metres in a unit, such as that of a pixel.
        origin: ``"corner"``: the corner of the playing area from which x and y increase;
            ``"centre"``: the table's centre; or the centre's x and y in the file's unit.
        x: Along which side of the table x runs: ``"width"`` or ``"length"``.
        mirrored: Whether y points to the right of x, seen from above, as in a picture whose y
            points down.

    Raises:
        InputError: A value is not one of these.
    """

    unit: str | float = "m"
    origin: str | tuple[float, float] = "corner"
    x: Literal["width", "length"] = "width"
    mirrored: bool = False

    def __post_init__(self) -> None:
        _unit("frame.unit", self.unit, UNITS)
        origin: Any = self.origin
        if origin == "center":
            object.__setattr__(self, "origin", "centre")
        elif isinstance(origin, str):
            if origin not in ORIGINS:
                raise _not_one_of("frame.origin", origin, ORIGINS, " or two numbers")
        else:
            try:
                x, y = (float(value) for value in origin)
            except (TypeError, ValueError):
                raise _not_one_of("frame.origin", origin, ORIGINS, " or two numbers") from None
            if not (math.isfinite(x) and math.isfinite(y)):
                raise InputError(
                    "out-of-range", "frame.origin", "a number is not finite", "write two numbers"
                )
            object.__setattr__(self, "origin", (x, y))
        if self.x not in AXES:
            raise _not_one_of("frame.x", self.x, AXES)
        truth("frame.mirrored", self.mirrored)

    @property
    def metres(self) -> float:
        """Metres in a unit of the file."""
        return UNITS[self.unit] if isinstance(self.unit, str) else float(self.unit)

    @property
    def is_table_frame(self) -> bool:
        """Whether the coordinates are those of carom, apart from their unit."""
        return self.origin == "corner" and self.x == "width" and not self.mirrored

    def to_table(
        self, places: NDArray[np.float64], size: tuple[float, float] | None
    ) -> NDArray[np.float64]:
        """Places of the file in the table's frame, m.

        Args:
            places: Shape (n, 2), in the file's unit.
            size: Width and length of the playing area, m.

        Raises:
            InputError: The size is unknown, and this frame needs it.
        """
        metres = places * self.metres
        if self.is_table_frame:
            return metres
        width, length = _needed(size)
        along, across = (length, width) if self.x == "length" else (width, length)
        if self.origin == "corner":
            centre = np.array((along, across)) / 2.0
        elif self.origin == "centre":
            centre = np.zeros(2)
        else:
            centre = np.array(self.origin, dtype=np.float64) * self.metres
        u, v = (metres - centre).T
        if self.mirrored:
            v = -v
        x, y = (-v, u) if self.x == "length" else (u, v)
        return np.column_stack((x + width / 2.0, y + length / 2.0))

    def to_file(
        self, places: NDArray[np.float64], size: tuple[float, float] | None
    ) -> NDArray[np.float64]:
        """The inverse of ``to_table``."""
        if self.is_table_frame:
            return places / self.metres
        width, length = _needed(size)
        x, y = (places - np.array((width, length)) / 2.0).T
        u, v = (y, -x) if self.x == "length" else (x, y)
        if self.mirrored:
            v = -v
        along, across = (length, width) if self.x == "length" else (width, length)
        centre = np.zeros(2)
        if self.origin == "corner":
            centre = np.array((along, across)) / 2.0
        elif not isinstance(self.origin, str):
            centre = np.array(self.origin, dtype=np.float64) * self.metres
        return (np.column_stack((u, v)) + centre) / self.metres

    def to_dict(self) -> dict[str, Any]:
        """The header's ``frame``."""
        origin = self.origin if isinstance(self.origin, str) else list(self.origin)
        return {"unit": self.unit, "origin": origin, "x": self.x, "mirrored": self.mirrored}


@dataclass(frozen=True, slots=True)
class TracksHeader:
    """What is known about the table, the balls and the camera of tracks.

    Attributes:
        table: The table, as a shot file has it: a preset's name or a description; None if it is
            unknown.
        radius: Radius of the balls, m; None if it is unknown.
        sigma: Standard deviation of a measured coordinate, m; None if it is unknown.
        least_move: The sampling rule: a sample was stored only when the ball had moved by this
            distance, m; None if every picture was stored.
        rate: Pictures per second, Hz; None if it is unknown.
        frame: How the file's coordinates lie on the table. Tracks in memory are in the table's
            frame whatever it is.
        time_unit: Unit of the file's times: ``s``, ``ms``, ``us``, or ``frame`` for numbers of
            pictures.
        columns: The names of the file's columns by ``shot``, ``ball``, ``t``, ``x``, ``y``,
            ``sigma``, ``visible``; a column that is missing has its own name.
        note: Anything that people should know, such as where the tracks come from.

    Raises:
        InputError: A value is out of its range, or the table is not valid.
    """

    table: str | Mapping[str, Any] | None = None
    radius: float | None = None
    sigma: float | None = None
    least_move: float | None = None
    rate: float | None = None
    frame: FileFrame = field(default_factory=FileFrame)
    time_unit: str = "s"
    columns: Mapping[str, str] = field(default_factory=dict)
    note: str = ""

    def __post_init__(self) -> None:
        for name, most in (("radius", 0.2), ("sigma", 1.0), ("least_move", 1.0), ("rate", 1e6)):
            value = getattr(self, name)
            if value is None:
                continue
            found = number(name, value)
            if not 0.0 < found <= most:
                unit = "Hz" if name == "rate" else "m"
                raise InputError(
                    "out-of-range",
                    name,
                    f"{found:g} {unit} is out of range",
                    f"write a number above 0 and at most {most:g} {unit}",
                    {"value": found, "low": 0.0, "high": most, "open": "low", "unit": unit},
                )
            object.__setattr__(self, name, found)
        if self.time_unit != "frame" and self.time_unit not in TIME_UNITS:
            raise _not_one_of("clock.unit", self.time_unit, (*TIME_UNITS, "frame"))
        if self.time_unit == "frame" and self.rate is None:
            raise InputError(
                "missing", "clock.rate", "the times are numbers of pictures", "write the rate, Hz"
            )
        for key, column in self.columns.items():
            if key not in COLUMNS:
                raise InputError(
                    "unknown-key",
                    f"columns.{key}",
                    "there is no such column",
                    f"write one of {', '.join(COLUMNS)}",
                )
            checked_text(f"columns.{key}", column)
        checked_text("note", self.note)
        object.__setattr__(self, "columns", MappingProxyType(dict(self.columns)))
        if self.table is not None:
            _size(self.table)

    @property
    def seconds(self) -> float:
        """Seconds in a unit of the file's times."""
        if self.time_unit == "frame":
            assert self.rate is not None
            return 1.0 / self.rate
        return TIME_UNITS[self.time_unit]

    @property
    def table_size(self) -> tuple[float, float] | None:
        """Width and length of the playing area, nose to nose, m; None without a table."""
        return None if self.table is None else _size(self.table)

    def in_table_frame(self) -> TracksHeader:
        """The header of the same tracks in a file with carom's frame, units and columns."""
        return replace(self, frame=FileFrame(), time_unit="s", columns={})

    def to_dict(self) -> dict[str, Any]:
        """The header as a file has it, ``carom-tracks/1``; ``from_dict`` of it gives it again."""
        found: dict[str, Any] = {"format": FORMAT}
        table = dict(self.table) if isinstance(self.table, Mapping) else self.table
        clock: dict[str, Any] = {"unit": self.time_unit}
        if self.rate is not None:
            clock["rate"] = self.rate
        optional = {
            "table": table,
            "radius": self.radius,
            "sigma": self.sigma,
            "frame": self.frame.to_dict(),
            "clock": clock,
            "least_move": self.least_move,
            "columns": dict(self.columns) or None,
            "note": self.note or None,
        }
        return found | {key: value for key, value in optional.items() if value is not None}

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> TracksHeader:
        """Read a header from a dict in the form of the file.

        Raises:
            InputError: It is not a valid header; the message names the place.
        """
        if not isinstance(file, Mapping):
            raise InputError("wrong-type", "", "the header is not an object {...}", "write one")
        if file.get("format") != FORMAT:
            raise InputError(
                "format", "format", f"found {file.get('format')!r}", f'write "{FORMAT}"'
            )
        _known("", file, _KEYS)
        frame = _part(file, "frame", ("unit", "origin", "x", "mirrored"))
        clock = _part(file, "clock", ("unit", "rate"))
        columns = _part(file, "columns", COLUMNS)
        if isinstance(frame.get("origin"), list):
            frame["origin"] = tuple(frame["origin"])
        try:
            return cls(
                table=file.get("table"),
                radius=file.get("radius"),
                sigma=file.get("sigma"),
                least_move=file.get("least_move"),
                rate=clock.get("rate"),
                frame=FileFrame(**frame),
                time_unit=clock.get("unit", "s"),
                columns=columns,
                note=file.get("note", ""),
            )
        except InputError as error:
            raise (error.at("clock.rate") if error.place == "rate" else error) from None

    @classmethod
    def from_json(cls, text: str, file: str = "the header") -> TracksHeader:
        """Read a header from JSON text; ``file`` is its name for an error message.

        Raises:
            InputError: It is not a valid header.
        """
        try:
            tree = json.loads(text)
        except json.JSONDecodeError as error:
            raise InputError(
                "syntax",
                file,
                f"not JSON: {error.msg} (line {error.lineno}, column {error.colno})",
                "mend the header",
                {"line": error.lineno, "column": error.colno},
            ) from None
        except (ValueError, RecursionError) as error:
            raise InputError("syntax", file, f"not JSON ({error})", "mend the header") from None
        try:
            return cls.from_dict(tree)
        except InputError as error:
            raise error.inside(file, ": ") from None

    def to_json(self) -> str:
        """The header as text."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False)


def _unit(place: str, unit: Any, known: Mapping[str, float]) -> None:
    if isinstance(unit, str):
        if unit not in known:
            raise _not_one_of(place, unit, tuple(known), " or the number of metres in a unit")
        return
    if not 0.0 < number(place, unit) < math.inf:
        raise InputError(
            "out-of-range", place, f"{unit} is out of range", "write the metres in a unit, above 0"
        )


def _not_one_of(place: str, found: Any, known: tuple[str, ...], more: str = "") -> InputError:
    return InputError(
        "unknown-name", place, f"found {found!r}", f"write one of {', '.join(known)}{more}"
    )


def _known(place: str, found: Mapping[str, Any], keys: tuple[str, ...]) -> None:
    for key in found:
        if key not in keys:
            raise InputError(
                "unknown-key",
                f"{place}{key}",
                "there is no such key",
                f"write one of {', '.join(keys)}",
            )


def _part(file: Mapping[str, Any], key: str, keys: tuple[str, ...]) -> dict[str, Any]:
    part = file.get(key, {})
    if not isinstance(part, Mapping):
        raise InputError("wrong-type", key, "it is not an object {...}", "write one")
    _known(f"{key}.", part, keys)
    return dict(part)


def _needed(size: tuple[float, float] | None) -> tuple[float, float]:
    if size is None:
        raise InputError(
            "missing",
            "table",
            "the frame is not that of carom, and without the table's size it cannot be turned",
            'name the table, such as "carom-10ft" (carom tables lists them)',
        )
    return size


# A ball at this place is on every table with rails, m.
_INSIDE = (0.3, 0.3)


def table_geometry(table: str | Mapping[str, Any]) -> dict[str, Any]:
    """The dimensions and cushions of a table, as ``Shot.geometry`` gives them."""
    return Shot(table, {"ball": _INSIDE}).geometry()


def _size(table: str | Mapping[str, Any]) -> tuple[float, float]:
    try:
        size = table_geometry(table)["size"]
    except InputError as error:
        known = error if error.place.startswith("table") else error.at("table")
        raise known from None
    if size is None:
        raise InputError(
            "unsupported", "table", "unbounded cloth has no rails", "name a table with rails"
        )
    width, length = size
    return float(width), float(length)
