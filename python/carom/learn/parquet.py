"""Tracks as Parquet."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

from carom.errors import InputError
from carom.lazy import LazyModule

if TYPE_CHECKING:
    import pyarrow as pa
    import pyarrow.parquet as pq
else:
    _MISSING = ("Parquet needs pyarrow", "install it: pip install 'carom[learn]'")
    pa = LazyModule("pyarrow", _MISSING)
    pq = LazyModule("pyarrow.parquet", _MISSING)

MAGIC = b"PAR1"


def read_parquet(data: bytes, name: str) -> tuple[list[str], list[Any]]:
    """The names of the columns and their values, as NumPy arrays or lists of texts.

    Raises:
        InputError: It is not Parquet, or pyarrow is not installed.
    """
    source = pa.BufferReader(data)
    try:
        table = pq.read_table(source)
    except (pa.ArrowException, OSError) as error:
        fault = str(error).splitlines()[0] if str(error) else "damaged"
        raise InputError(
            "syntax", name, f"the Parquet file cannot be read ({fault})", "copy or write it again"
        ) from None
    columns: list[Any] = []
    for column in table.columns:
        kind = column.type
        if pa.types.is_floating(kind) or pa.types.is_integer(kind):
            columns.append(
                column.to_numpy()
                if not column.null_count
                else column.cast("float64").to_numpy(zero_copy_only=False)
            )
        else:
            columns.append([None if value is None else value for value in column.to_pylist()])
    return list(table.column_names), columns


def parquet_bytes(columns: dict[str, Any]) -> bytes:
    """A table as the bytes of a Parquet file."""
    out = io.BytesIO()
    pq.write_table(pa.table(columns), out, compression="zstd")
    return out.getvalue()
