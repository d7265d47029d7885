"""A table as text (CSV): its encoding, delimiter, names and cells."""

from __future__ import annotations

import csv
import gzip
import io
import re
import zlib
from dataclasses import dataclass

from carom.errors import InputError
from carom.files import refuse_other_encoding
from carom.learn.findings import Finding, listed

_GZIP = b"\x1f\x8b"
_BOM = b"\xef\xbb\xbf"
# Most bytes of a decompressed file: ten hours of sixteen balls at 240 Hz are 6 GB of text, and a
# larger one would exhaust the memory of most machines.
_MOST_BYTES = 8 * 10**9
_CHUNK = 1 << 24
_DELIMITERS = (";", "\t", ",")
_DECIMAL_COMMA = re.compile(r"-?\d+,\d+(?:[eE][-+]?\d+)?$")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")


@dataclass(frozen=True, slots=True)
class TextTable:
    """The cells of a table.

    Attributes:
        names: The names of the columns.
        rows: The cells of each row, as many as there are names.
        lines: The number of each row's line in the file, from 1.
        findings: What was repaired.
        left_out: How many rows were left out.
    """

    names: list[str]
    rows: list[list[str]]
    lines: list[int]
    findings: list[Finding]
    left_out: int


def read_text_table(data: bytes, name: str) -> TextTable:
    """Read a table from the bytes of a file.

    Args:
        data: The content, without gzip.
        name: The name of the file, for messages.

    Raises:
        InputError: It is not such a table; the message names the line and the remedy.
    """
    findings: list[Finding] = []
    text = _text(data, name, findings)
    whole_lines = text.split("\n")
    first = next((i for i, line in enumerate(whole_lines) if line.strip()), None)
    if first is None:
        raise InputError("missing", name, "the file is empty", "give a table with samples")
    head = whole_lines[first]
    delimiter = _delimiter(head, name, first + 1)
    rows, lines = _cells(text, delimiter, name)
    names = [cell.strip() for cell in rows.pop(0)]
    lines.pop(0)
    _check_names(names, name, lines[0] - 1 if lines else 1)
    kept, kept_lines, wrong = [], [], []
    for row, line in zip(rows, lines, strict=True):
        if len(row) == len(names):
            kept.append(row)
            kept_lines.append(line)
        else:
            wrong.append((line, len(row)))
    if delimiter != ",":
        kept = _without_decimal_commas(kept, name, findings)
    elif wrong and len(wrong) > len(kept) and wrong[0][1] > len(names):
        raise InputError(
            "syntax",
            f"{name}, line {wrong[0][0]}",
            f"{wrong[0][1]} cells, but {len(names)} columns: probably with decimal commas",
            "save the table with semicolons between the columns, or with decimal points",
        )
    if wrong:
        findings.append(_wrong_rows(wrong, len(names), lines[-1], name))
    return TextTable(names, kept, kept_lines, findings, len(wrong))


def _wrong_rows(wrong: list[tuple[int, int]], columns: int, last: int, name: str) -> Finding:
    where = f"{name}, {listed([line for line, _ in wrong])}"
    count = wrong[0][1]
    cells = "one cell" if count == 1 else f"{count} cells"
    fault = f"{cells} in place of {columns}"
    if len(wrong) == 1 and wrong[0][0] == last:
        fault += ", as if the file had been cut off"
    return Finding("repair", "wrong-count", where, fault, "left out", len(wrong))


def plain_bytes(data: bytes, name: str, findings: list[Finding]) -> bytes:
    """The content of a file without gzip.

    Raises:
        InputError: The gzip data are damaged.
    """
    if not data.startswith(_GZIP):
        if name.endswith(".gz") and data:
            findings.append(
                Finding("note", "format", name, "it is not gzipped", "read as plain text")
            )
        return data
    pieces, size = [], 0
    try:
        with gzip.GzipFile(fileobj=io.BytesIO(data)) as file:
            while piece := file.read(_CHUNK):
                pieces.append(piece)
                size += len(piece)
                if size > _MOST_BYTES:
                    raise InputError(
                        "out-of-range", name, "more than 8 GB of text", "cut it into several files"
                    )
    except EOFError:
        raise InputError(
            "syntax",
            name,
            "the gzip data end early, so the file was cut off",
            "copy or download it again",
        ) from None
    except (OSError, zlib.error) as error:
        raise InputError(
            "syntax", name, f"the gzip data are damaged ({error})", "copy or download it again"
        ) from None
    return b"".join(pieces)


def _text(data: bytes, name: str, findings: list[Finding]) -> str:
    refuse_other_encoding(data, name)
    if data.startswith(_BOM):
        data = data.removeprefix(_BOM)
        findings.append(
            Finding("note", "encoding", name, "it begins with a byte order mark", "left out")
        )
    if b"\0" in data:
        line = data[: data.index(b"\0")].count(b"\n") + 1
        raise InputError(
            "syntax",
            f"{name}, line {line}",
            "it has a NUL byte, so it is not a text",
            "give a table as CSV or Parquet",
        )
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise InputError(
            "syntax",
            f"{name}, line {line}",
            f"not UTF-8 text ({error.reason})",
            "save it as UTF-8",
        ) from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _delimiter(head: str, name: str, line: int) -> str:
    for delimiter in _DELIMITERS:
        if delimiter in head:
            return delimiter
    shown = head if len(head) <= 40 else head[:40] + "…"
    raise InputError(
        "syntax",
        f"{name}, line {line}",
        f"no comma, semicolon or tab between the names of columns in {shown!r}",
        "begin the table with a line such as shot,ball,t,x,y",
    )


def _cells(text: str, delimiter: str, name: str) -> tuple[list[list[str]], list[int]]:
    rows, lines = [], []
    reader = csv.reader(io.StringIO(text), delimiter=delimiter, strict=True)
    try:
        for row in reader:
            # A line of delimiters, as spreadsheets write them, has no sample either.
            if any(cell.strip() for cell in row):
                rows.append(row)
                lines.append(reader.line_num)
    except csv.Error as error:
        raise InputError(
            "syntax",
            f"{name}, line {reader.line_num}",
            f"the cells cannot be read ({error})",
            "mend the quotation marks of this line",
        ) from None
    return rows, lines


def _check_names(names: list[str], name: str, line: int) -> None:
    where = f"{name}, line {line}"
    if all(_NUMBER.match(cell) for cell in names if cell):
        raise InputError(
            "missing",
            where,
            "the first line has numbers and not the names of the columns",
            "begin the table with a line such as shot,ball,t,x,y",
        )
    double = next((cell for cell in names if cell and names.count(cell) > 1), None)
    if double is not None:
        raise InputError(
            "duplicate", where, f"two columns are named {double!r}", "give each its own name"
        )


def _without_decimal_commas(
    rows: list[list[str]], name: str, findings: list[Finding]
) -> list[list[str]]:
    count = 0
    for row in rows:
        for index, cell in enumerate(row):
            if "," in cell and _DECIMAL_COMMA.match(cell.strip()):
                row[index] = cell.replace(",", ".")
                count += 1
    if count:
        findings.append(
            Finding(
                "note", "decimal-comma", name, f"{count} numbers have a decimal comma", "read so"
            )
        )
    return rows
