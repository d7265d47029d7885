"""Reading tracks: ``carom-tracks/1`` and the tables and files of other programs."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from carom.errors import InputError
from carom.files import checked_path, read_text, refuse_other_encoding, shown
from carom.lazy import np
from carom.learn.column_names import recognise_columns
from carom.learn.findings import Finding
from carom.learn.foreign import foreign
from carom.learn.header import TracksHeader
from carom.learn.jumps import without_jumps
from carom.learn.parquet import MAGIC, read_parquet
from carom.learn.plausible import check_clock, leave_out_far_places
from carom.learn.rows_of_table import rows_of_table, with_units
from carom.learn.samples import Rows, locator, shots_of
from carom.learn.speeds import speeds_of
from carom.learn.text_table import plain_bytes, read_text_table
from carom.learn.tracks import Tracks

if TYPE_CHECKING:
    from carom.learn.header import FileFrame

# The columns of a public three-cushion match, whose frame and table are known.
_MATCH = ["shot", "ball", "t_s", "x_m", "y_m"]
_MATCH_TABLE, _MATCH_RADIUS = "carom-10ft", 0.03075
_HEADER_ENDING = ".json"


def header_path(path: Path) -> Path:
    """The file beside the data that has their header."""
    return path.with_name(path.name + _HEADER_ENDING)


def read_tracks(
    path: str | os.PathLike[str],
    *,
    header: TracksHeader | None = None,
    columns: Mapping[str, str] | None = None,
    table: str | Mapping[str, Any] | None = None,
    radius: float | None = None,
    sigma: float | None = None,
    least_move: float | None = None,
    rate: float | None = None,
    unit: str | float | None = None,
    origin: str | tuple[float, float] | None = None,
    x: Literal["width", "length"] | None = None,
    mirrored: bool | None = None,
    time_unit: str | None = None,
) -> Tracks:
    """Read tracks from a file.

    The file is CSV (also with semicolons or tabs, and gzipped) or Parquet with one row per sample;
    a system that pooltool saved after its simulation; or shots of tailuge/billiards. What the file
    does not say is in the header beside it, ``PATH.json`` (``carom-tracks/1``), or in the
    arguments, which have precedence.

    Args:
        path: The file with the samples.
        header: The header, in place of the one beside the file.
        columns: The names of the columns by ``shot``, ``ball``, ``t``, ``x``, ``y``, ``sigma``,
            ``visible``. The usual names are recognised, also with a unit, as in ``x_mm``.
        table: The table, as a shot file has it.
        radius: Radius of the balls, m.
        sigma: Standard deviation of a measured coordinate, m.
        least_move: The distance by which a ball must move before a sample is stored, m.
        rate: Pictures per second, Hz.
        unit: Unit of length in the file, or the metres in it.
        origin: Origin of the file's coordinates: ``"corner"``, ``"centre"``, or the coordinates of
            the table's centre.
        x: Along which side of the table x runs.
        mirrored: Whether y points to the right of x.
        time_unit: Unit of the times: ``s``, ``ms``, ``us``, or ``frame``.

    Returns:
        The tracks in the table's frame. ``findings`` lists everything that was assumed, repaired
        or left out.

    Raises:
        OSError: The file cannot be read.
        InputError: It has no tracks, or they cannot be those of balls on the table; the message
            names the place and the remedy.
    """
    file = checked_path("path", path, "match.csv")
    name = shown(file.name)
    data = file.read_bytes()
    beside = header_path(file)
    findings: list[Finding] = []
    known: TracksHeader | None = header
    if known is None and beside.exists():
        known = TracksHeader.from_json(read_text(beside), shown(beside.name))
    frame = {"unit": unit, "origin": origin, "x": x, "mirrored": mirrored}
    others = {
        "columns": columns,
        "table": table,
        "radius": radius,
        "sigma": sigma,
        "least_move": least_move,
        "rate": rate,
        "time_unit": time_unit,
    }
    given = {key: value for key, value in (frame | others).items() if value is not None}
    rows, full = _rows(data, name, known, given, findings)
    locate = locator(name, "row" if data.startswith(MAGIC) else "line")
    leave_out_far_places(rows, full, locate, findings)
    shots = shots_of(rows, locate, findings)
    step, speeds = speeds_of(shots)
    check_clock(speeds, step, full, name)
    shots = [without_jumps(shot, findings) for shot in shots]
    return Tracks(full, tuple(shots), tuple(findings))


def _rows(
    data: bytes,
    name: str,
    known: TracksHeader | None,
    given: dict[str, Any],
    findings: list[Finding],
) -> tuple[Rows, TracksHeader]:
    left_out = 0
    lines: Any
    if data.startswith(MAGIC):
        found, columns = read_parquet(data, name)
        lines = np.arange(1, len(columns[0]) + 1) if columns else []
        locate = locator(name, "row")
    else:
        refuse_other_encoding(data, name)
        plain = plain_bytes(data, name, findings)
        if _is_tree(plain):
            return _foreign_rows(plain, name, known, given, findings)
        table = read_text_table(plain, name)
        findings.extend(table.findings)
        found, lines, left_out = table.names, table.lines, table.left_out
        columns = list(zip(*table.rows, strict=True)) if table.rows else [()] * len(found)
        locate = locator(name)
    if known is None and found == _MATCH and not given.keys() & {"origin", "x", "unit"}:
        known, note = _match_header(name)
        findings.append(note)
    header = _with(known or TracksHeader(), given)
    names = recognise_columns(found, header.columns, name)
    stated = set(given) | ({"unit", "time_unit"} if known is not None else set())
    header = with_units(header, names, stated)
    if names.unused:
        unused = ", ".join(map(repr, names.unused))
        findings.append(Finding("note", "unused", name, f"columns {unused}", "not used"))
    if "shot" not in names.names:
        findings.append(
            Finding("note", "assumed", name, "no column for the shot", "taken as one shot, 1")
        )
    if header.table is None:
        findings.append(
            Finding(
                "note",
                "assumed",
                name,
                "the table is not named",
                "taken as metres from the bottom left corner of a table; name it (table, --table)",
            )
        )
    rows = rows_of_table(columns, lines, names, found, header, locate, findings, name, left_out)
    return rows, header


def _foreign_rows(
    data: bytes,
    name: str,
    known: TracksHeader | None,
    given: dict[str, Any],
    findings: list[Finding],
) -> tuple[Rows, TracksHeader]:
    if given.pop("columns", None) is not None:
        raise InputError(
            "conflict", "columns", "the file is not a table of samples", "leave it out"
        )
    of = foreign(data, name, given.get("rate"))
    findings.extend(of.findings)
    header = _with(known or of.header, given)
    shot: list[str] = []
    ball: list[str] = []
    parts: list[list[Any]] = [[], [], []]
    for title, own, *values in of.samples:
        shot += [title] * len(values[0])
        ball += [own] * len(values[0])
        for part, more in zip(parts, values, strict=True):
            part.extend(more)
    found = ["shot", "ball", "t", "x", "y"]
    names = recognise_columns(found, {}, name)
    columns = [shot, ball, *parts]
    lines = range(1, len(shot) + 1)
    locate = locator(name, "sample")
    rows = rows_of_table(columns, lines, names, found, header, locate, findings, name, 0)
    return rows, header


def _with(header: TracksHeader, given: dict[str, Any]) -> TracksHeader:
    frame: FileFrame = header.frame
    own = {key: given[key] for key in ("unit", "origin", "x", "mirrored") if key in given}
    if own:
        frame = replace(frame, **own)
    rest = {key: value for key, value in given.items() if key not in own}
    return replace(header, frame=frame, **rest)


def _match_header(name: str) -> tuple[TracksHeader, Finding]:
    header = TracksHeader(table=_MATCH_TABLE, radius=_MATCH_RADIUS)
    header = _with(header, {"x": "length"})
    note = Finding(
        "note",
        "assumed",
        name,
        f"the columns {','.join(_MATCH)} without a header are those of a three-cushion match",
        f"taken as metres from a corner along the length of {_MATCH_TABLE}, "
        f"balls of {2e3 * _MATCH_RADIUS:g} mm",
    )
    return header, note


def _is_tree(data: bytes) -> bool:
    """Whether it is JSON or MessagePack, and not a table."""
    start = data.lstrip(b"\xef\xbb\xbf \t\r\n")[:1]
    return start in (b"{", b"[", b"\xde", b"\xdf") or b"\x80" <= start <= b"\x8f"
