"""The columns of a table, as text or as arrays, made into rows of samples."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from carom.errors import InputError
from carom.lazy import np
from carom.learn.column_names import ColumnNames
from carom.learn.findings import Finding
from carom.learn.header import TracksHeader
from carom.learn.plausible import check_frame
from carom.learn.samples import Locate, Rows, check_left_out

if TYPE_CHECKING:
    from numpy.typing import NDArray

# A place further than this from the origin, m, is not on the ground of the same hall.
_HUGE = 1e4
# Texts of a cell that has no number.
_EMPTY = {"", "nan", "na", "n/a", "null", "none", "-", "--", "?"}
_FALSE = {"0", "false", "no", "n", "f", "0.0"}
_TRUE = {"1", "true", "yes", "y", "t", "1.0"}


def rows_of_table(
    columns: Sequence[Any],
    lines: Sequence[int],
    names: ColumnNames,
    found: list[str],
    header: TracksHeader,
    locate: Locate,
    findings: list[Finding],
    name: str,
    left_out: int,
) -> Rows:
    """The samples of a table in the table's frame, without those that cannot be used.

    Args:
        columns: The cells of each column, as texts or as an array.
        lines: The line of each row.
        names: Which column is which.
        found: The names of the columns, in the order of ``columns``.
        header: Frame and units.
        locate: Gives the place of some lines, for messages.
        findings: What is left out is added to them.
        name: The name of the file.
        left_out: How many rows were left out before.

    Raises:
        InputError: Too many rows cannot be used, or none is left.
    """
    total = len(lines) + left_out
    if not total:
        raise InputError("missing", name, "it has no samples", "give a table with rows")
    column = {key: columns[found.index(at)] for key, at in names.names.items()}
    where = np.asarray(lines, dtype=np.int64)
    t, _, t_bad = _numbers(column["t"])
    x, x_empty, x_bad = _numbers(column["x"])
    y, y_empty, y_bad = _numbers(column["y"])
    place = np.column_stack((x, y))
    bad_time = t_bad | ~np.isfinite(t)
    bad_place = x_bad | y_bad
    huge = ~bad_place & (np.abs(place) * header.frame.metres > _HUGE).any(axis=1)
    nameless = _nameless(column["ball"]) | _nameless(column.get("shot"), total=len(lines))
    dropped = bad_time | bad_place | huge | nameless
    for mask, kind, fault in (
        (bad_time, "bad-time", "the time is not a number"),
        (bad_place & ~bad_time, "bad-number", "a coordinate is not a number"),
        (huge & ~bad_time, "huge", "a coordinate is infinite or larger than 10 km"),
        (nameless & ~bad_time, "no-name", "the shot or the ball has no name"),
    ):
        if mask.any():
            at = locate([int(line) for line in where[mask]])
            findings.append(Finding("repair", kind, at, fault, "left out", int(mask.sum())))
    check_left_out(int(dropped.sum()) + left_out, total, findings, name)
    empty = (x_empty | y_empty) & ~dropped
    visible = ~empty
    if "visible" in column:
        visible &= _truths(column["visible"], where, locate, ~dropped)
    if empty.any() and "visible" not in column:
        at = locate([int(line) for line in where[empty]])
        findings.append(
            Finding(
                "note",
                "no-place",
                at,
                "a sample without a place",
                "kept as one in which the ball was not seen",
                int(empty.sum()),
            )
        )
    keep = ~dropped
    if not (keep & visible).any():
        raise InputError("missing", name, "no sample has a place", "give a table with places")
    shot, shots = _names(column.get("shot"), keep, "1")
    ball, balls = _names(column["ball"], keep, "")
    sigma = None
    if "sigma" in column:
        sigma = _sigma(column["sigma"], where, locate, findings, keep) * header.frame.metres
    check_frame(place[keep & visible], header, name)
    size = header.table_size
    table = header.frame.to_table(np.where(visible[:, None], place, np.nan)[keep], size)
    return Rows(
        shot=shot,
        shots=shots,
        ball=ball,
        balls=balls,
        t=t[keep] * header.seconds,
        x=table[:, 0],
        y=table[:, 1],
        sigma=sigma,
        visible=visible[keep],
        line=where[keep],
    )


def with_units(header: TracksHeader, names: ColumnNames, given: set[str]) -> TracksHeader:
    """The header with the units in the names of columns where none was given."""
    if names.unit is not None and "unit" not in given:
        header = replace(header, frame=replace(header.frame, unit=names.unit))
    if names.time_unit is not None and "time_unit" not in given:
        if names.time_unit == "frame" and header.rate is None:
            raise InputError(
                "missing",
                "rate",
                f"the column {names.names['t']!r} has numbers of pictures",
                "give the pictures per second: rate=..., or --rate",
            )
        header = replace(header, time_unit=names.time_unit)
    return header


def _numbers(
    cells: Any,
) -> tuple[NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_]]:
    """Numbers; which cells are empty, and which hold something else."""
    if isinstance(cells, np.ndarray) and cells.dtype.kind in "iufb":
        values = cells.astype(np.float64)
        return values, np.isnan(values), np.zeros(values.size, dtype=np.bool_)
    try:
        # NumPy reads 1_0 as 10.
        if any("_" in cell for cell in cells if isinstance(cell, str)):
            raise ValueError
        values = np.array(cells, dtype=np.float64)
    except (TypeError, ValueError):
        values = np.array([_number(cell) for cell in cells], dtype=np.float64)
        empty = np.array([_is_empty(cell) for cell in cells], dtype=np.bool_)
        return values, empty, np.isnan(values) & ~empty
    return values, np.isnan(values), np.zeros(values.size, dtype=np.bool_)


def _number(cell: Any) -> float:
    text = str(cell).strip()
    try:
        # Python reads 1_000 as a number.
        return math.nan if "_" in text else float(text)
    except ValueError:
        return math.nan


def _is_empty(cell: Any) -> bool:
    return cell is None or str(cell).strip().lower() in _EMPTY


def _truths(
    cells: Any, where: NDArray[np.int64], locate: Locate, keep: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    if isinstance(cells, np.ndarray) and cells.dtype.kind in "iufb":
        truths: NDArray[np.bool_] = np.nan_to_num(cells.astype(np.float64)) != 0.0
        return truths
    words = [str(cell).strip().lower() for cell in cells]
    known = np.array([word in _TRUE or word in _FALSE for word in words], dtype=np.bool_)
    if not known[keep].all():
        index = int(np.flatnonzero(~known & keep)[0])
        raise InputError(
            "wrong-type",
            locate([int(where[index])]),
            f"{words[index]!r} does not say whether the ball was seen",
            "write 1 or 0",
        )
    return np.array([word in _TRUE for word in words], dtype=np.bool_)


def _sigma(
    cells: Any,
    where: NDArray[np.int64],
    locate: Locate,
    findings: list[Finding],
    keep: NDArray[np.bool_],
) -> NDArray[np.float64]:
    values, empty, _ = _numbers(cells)
    bad = keep & ~empty & ~(np.isfinite(values) & (values > 0.0))
    if bad.any():
        at = locate([int(line) for line in where[bad]])
        fault = "a standard deviation is not above 0"
        findings.append(
            Finding(
                "repair", "bad-sigma", at, fault, "replaced by the ball's median", int(bad.sum())
            )
        )
    return np.where(bad, np.nan, values)[keep]


def _nameless(cells: Any, total: int = 0) -> NDArray[np.bool_]:
    if cells is None:
        return np.zeros(total, dtype=np.bool_)
    if isinstance(cells, np.ndarray):
        return np.isnan(cells) if cells.dtype.kind == "f" else np.zeros(cells.size, dtype=np.bool_)
    return np.array([_is_empty(cell) for cell in cells], dtype=np.bool_)


def _names(
    cells: Any, keep: NDArray[np.bool_], default: str
) -> tuple[NDArray[np.int64], list[str]]:
    """The index of each kept cell's name, and the names in order of appearance."""
    if cells is None:
        return np.zeros(int(keep.sum()), dtype=np.int64), [default]
    index: dict[str, int] = {}
    found = [
        index.setdefault(_name(cell), len(index))
        for cell, kept in zip(cells, keep, strict=True)
        if kept
    ]
    return np.array(found, dtype=np.int64), [*index]


def _name(cell: Any) -> str:
    """A name; numbers of a spreadsheet, which may have become 3.0, are whole numbers."""
    if isinstance(cell, float | np.floating) and float(cell).is_integer():
        return str(int(cell))
    text = str(cell).strip()
    return text[:-2] if text.endswith(".0") and text[:-2].isdigit() else text
