"""Writing tracks: a table of samples, and their header beside it."""

from __future__ import annotations

import csv
import gzip
import io
import math
import os
from typing import Any

from carom.errors import InputError
from carom.files import checked_path, write_whole
from carom.lazy import np
from carom.learn.parquet import parquet_bytes
from carom.learn.read import header_path
from carom.learn.tracks import Tracks

_ENDINGS = (".csv", ".csv.gz", ".parquet")
# Ten digits: a tenth of a nanometre on a table, and a microsecond in a day.
_DIGITS = 10


def write_tracks(tracks: Tracks, path: str | os.PathLike[str]) -> None:
    """Write tracks as CSV or Parquet, and their header to ``PATH.json``.

    The samples are in the frame of the header: ``read_tracks`` of the file gives these tracks
    again, in CSV to ten digits and in Parquet to rounding.

    Args:
        tracks: The tracks.
        path: The file for the samples: ``.csv``, ``.csv.gz`` or ``.parquet``.

    Raises:
        InputError: The name ends otherwise, or the frame needs a table and the header has none.
        OSError: A file cannot be written.
    """
    file = checked_path("path", path, "match.csv.gz")
    if not file.name.endswith(_ENDINGS):
        raise InputError(
            "format",
            "path",
            f"{file.name!r} has none of the endings {', '.join(_ENDINGS)}",
            "name the file so",
        )
    columns = _columns(tracks)
    if file.name.endswith(".parquet"):
        data = parquet_bytes(columns)
    else:
        text = _csv(columns).encode()
        # Without the time and the name, so that equal tracks are equal files.
        data = gzip.compress(text, mtime=0) if file.name.endswith(".gz") else text
    write_whole(file, data)
    write_whole(header_path(file), tracks.header.to_json() + "\n")


def _columns(tracks: Tracks) -> dict[str, Any]:
    header = tracks.header
    balls = [(shot.name, ball, track) for shot in tracks for ball, track in shot.balls.items()]
    size = header.table_size
    place = [header.frame.to_file(track.position, size) for _, _, track in balls]
    flat = np.concatenate(place) if place else np.empty((0, 2))
    names = dict(header.columns)
    columns: dict[str, Any] = {
        "shot": [shot for shot, _, track in balls for _ in range(len(track))],
        "ball": [ball for _, ball, track in balls for _ in range(len(track))],
        "t": _joined([track.time / header.seconds for _, _, track in balls]),
        "x": flat[:, 0],
        "y": flat[:, 1],
    }
    if any(track.sigma is not None for _, _, track in balls):
        columns["sigma"] = _joined(
            [
                np.full(len(track), np.nan)
                if track.sigma is None
                else track.sigma / header.frame.metres
                for _, _, track in balls
            ]
        )
    if any(not track.visible.all() for _, _, track in balls):
        columns["visible"] = _joined([track.visible for _, _, track in balls])
    return {names.get(key, key): values for key, values in columns.items()}


def _joined(parts: list[Any]) -> Any:
    return np.concatenate(parts) if parts else np.empty(0)


def _csv(columns: dict[str, Any]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*(_cells(values) for values in columns.values()), strict=True))
    return out.getvalue()


def _cells(values: Any) -> list[str]:
    if not isinstance(values, np.ndarray):
        return list(values)
    if values.dtype.kind == "b":
        return ["1" if value else "0" for value in values.tolist()]
    return ["" if math.isnan(value) else f"{value:.{_DIGITS}g}" for value in values.tolist()]
