"""Parts of a table: one Parquet file each with its checksum, written completely or not at all."""

from __future__ import annotations

import hashlib
import itertools
import json
import os
import socket
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from carom import __version__
from carom.errors import InputError
from carom.files import at_file
from carom.lazy import pa, pq
from carom.sweeps.play import CHUNK
from carom.threads import in_order

if TYPE_CHECKING:
    from carom.sweeps.play import RowPlayer

# Rows of a row group: a few tens of megabytes, all that a writer holds in memory.
GROUP = 131_072
# Largest and least default number of rows of a part. The largest takes about one second of work, so
# that a killed run loses little. The least keeps the cost of opening a file small.
MOST_ROWS = 131_072
LEAST_ROWS = 4096
# Number of parts of a sweep of medium size, so that every core gets some.
PARTS = 16
# Rows of a part that are compared with the sweep if the folder stores names without dates. Any
# change of a preset that matters shows in far fewer.
COMPARED = 64
# Longest spec that each part holds, bytes; longer ones, such as those of a thousand layouts, are in
# the manifest only.
LONGEST_SPEC = 65_536
UNFINISHED = ".unfinished"
# A part's checksum is in a file of its own, in the format that `sha256sum --check` reads.
CHECKSUM = ".sha256"

_counter = itertools.count()


class StoppedError(Exception):
    """The run is ending, so the part was abandoned."""


@dataclass(frozen=True, slots=True)
class Receipt:
    """A complete part in the folder.

    Attributes:
        part: Its number.
        rows: Its number of rows.
        failed: How many of these rows could not be simulated.
        bytes: Size of the file.
        worker: Process that wrote it; 0 if it existed before the run.
        checked: Whether the file agrees with a checksum; False if it has none.
    """

    part: int
    rows: int
    failed: int
    bytes: int
    worker: int
    checked: bool = True


@dataclass(frozen=True, slots=True)
class Parts:
    """How the rows of a sweep are divided into files.

    Attributes:
        folder: The folder of the files.
        rows: Rows of the whole sweep.
        part_rows: Rows of each part; the last one may have fewer.
        sha256: Hash of the spec in the folder's manifest; None is that of the sweep's spec. The
            manifest of an older folder has names of presets without dates.
    """

    folder: Path
    rows: int
    part_rows: int
    sha256: str | None = None

    def __len__(self) -> int:
        return (self.rows + self.part_rows - 1) // self.part_rows

    def path(self, part: int) -> Path:
        """The file of a part."""
        digits = max(6, len(str(len(self) - 1)))
        return self.folder / f"part-{part:0{digits}}.parquet"

    def range(self, part: int) -> tuple[int, int]:
        """The first row of a part, and the first row after it."""
        start = part * self.part_rows
        return start, min(start + self.part_rows, self.rows)

    def write(
        self, player: RowPlayer, part: int, go_on: Callable[[], bool] = lambda: True
    ) -> Receipt:
        """Simulate a part and put its file into the folder.

        The file is a pure function of the sweep and the part's number: a repetition after a kill
        writes the same bytes.

        Raises:
            StoppedError: ``go_on`` returned False.
            OSError: The folder cannot take the file, such as on a full disk.
        """
        path = self.path(part)
        # No other process uses this name, on any machine with access to the folder.
        name = f"{path.name}.{socket.gethostname()}-{os.getpid()}-{next(_counter)}{UNFINISHED}"
        unfinished = path.with_name(name)
        note = path.with_name(f"{CHECKSUM[1:]}-{name}")
        try:
            with at_file(path):
                failed = self._play_into(unfinished, player, part, go_on)
                with unfinished.open("rb+") as file:
                    os.fsync(file.fileno())
                size = unfinished.stat().st_size
                note.write_text(f"{_digest(unfinished)}  {path.name}\n", encoding="ascii")
                # The checksum comes first, so that a complete part always has one.
                note.replace(_checksum_path(path))
                unfinished.replace(path)
        finally:
            unfinished.unlink(missing_ok=True)
            note.unlink(missing_ok=True)
        first, end = self.range(part)
        return Receipt(part, end - first, failed, size, os.getpid())

    def _play_into(
        self, path: Path, player: RowPlayer, part: int, go_on: Callable[[], bool]
    ) -> int:
        first, end = self.range(part)
        failed = 0
        with pq.ParquetWriter(path, player.schema, **_encoding(player)) as file:
            for start in range(first, end, GROUP):
                table = play_rows(player, start, min(start + GROUP, end), go_on)
                failed += len(table) - table["error"].null_count
                file.write_table(table, row_group_size=GROUP)
            file.add_key_value_metadata(metadata(player, first, failed, self.sha256))
        return failed

    def receipt(self, player: RowPlayer, part: int, worker: int = 0) -> Receipt:
        """Check the file of a part: its metadata and its checksum.

        Raises:
            InputError: The file is damaged, or it is not that part of this sweep.
        """
        path = self.path(part)
        remedy = "delete the file; the next run writes it again"
        try:
            found = pq.read_metadata(path)
        except (pa.ArrowInvalid, OSError) as error:
            raise InputError("syntax", str(path), f"it cannot be read ({error})", remedy) from None
        said = found.metadata or {}
        start, stop = self.range(part)
        wanted = {
            b"carom.version": __version__,
            b"carom.sweep.sha256": self.sha256 or player.spec.sha256,
            b"carom.sweep.first_row": str(start),
        }
        same = all(said.get(key) == value.encode() for key, value in wanted.items())
        if not same or found.num_rows != stop - start:
            raise InputError(
                "mismatch",
                str(path),
                f"it is not part {part} of this sweep",
                f"{remedy}, or choose another folder",
            )
        expected = _expected_digest(path)
        if expected is not None and expected != _digest(path):
            raise InputError(
                "changed",
                str(path),
                "its checksum is wrong, so it has changed since it was written",
                remedy,
            )
        failed = int(said[b"carom.sweep.failed"])
        size = path.stat().st_size
        return Receipt(part, stop - start, failed, size, worker, checked=expected is not None)

    def receipts(self, player: RowPlayer, threads: int) -> list[Receipt]:
        """Check all parts that are in the folder.

        Raises:
            InputError: As from ``receipt``.
        """
        there = (part for part in range(len(self)) if self.path(part).exists())
        return list(in_order(lambda part: self.receipt(player, part), there, threads))

    def check_values(self, player: RowPlayer) -> None:
        """Compare the first rows of the first existing part with those of the sweep.

        Purpose: a name of a preset without a date meant the values of its time, and a spec with
        such names does not tell which.

        Raises:
            InputError: They differ.
        """
        part = next((part for part in range(len(self)) if self.path(part).exists()), None)
        if part is None:
            return
        start, stop = self.range(part)
        count = min(stop - start, COMPARED)
        found = pq.ParquetFile(self.path(part)).read(use_threads=False).slice(0, count)
        if not found.equals(play_rows(player, start, start + count)):
            raise InputError(
                "changed",
                str(self.path(part)),
                "its rows differ from those of this sweep, because the folder has names of presets "
                "without a date, which may have had other values",
                "choose another folder",
            )

    def tidy(self) -> None:
        """Remove the unfinished files that killed writers left."""
        for path in self.folder.glob(f"*{UNFINISHED}"):
            path.unlink(missing_ok=True)


def _checksum_path(path: Path) -> Path:
    return path.with_name(path.name + CHECKSUM)


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _expected_digest(path: Path) -> str | None:
    """The digest in the checksum file of a part; None if the part was written without one."""
    try:
        text = _checksum_path(path).read_text(encoding="ascii", errors="replace")
    except FileNotFoundError:
        return None
    return text.partition(" ")[0].strip()


def default_rows(rows: int) -> int:
    """Rows of a part; they depend on the sweep only, never on the machine."""
    return min(max(rows // PARTS + 1, LEAST_ROWS), MOST_ROWS)


def play_rows(
    player: RowPlayer,
    start: int,
    stop: int,
    go_on: Callable[[], bool] = lambda: True,
    *,
    threads: int = 1,
) -> pa.Table:
    """The rows from ``start`` up to ``stop``.

    Raises:
        StoppedError: ``go_on`` returned False.
    """

    def chunk(first: int) -> pa.RecordBatch:
        if not go_on():
            raise StoppedError
        return player.play(player.parameters(first, min(first + CHUNK, stop)))

    firsts = range(start, stop, CHUNK)
    return pa.Table.from_batches(in_order(chunk, firsts, threads), schema=player.schema)


def metadata(
    player: RowPlayer, first_row: int, failed: int, sha256: str | None = None
) -> dict[str, str]:
    """The metadata of a part's file."""
    said = {
        "carom.version": __version__,
        "carom.sweep.sha256": sha256 or player.spec.sha256,
        "carom.sweep.first_row": str(first_row),
        "carom.sweep.failed": str(failed),
    }
    is_undated = said["carom.sweep.sha256"] != player.spec.sha256
    file = player.spec.undated if is_undated else player.spec.file
    spec = json.dumps(file, ensure_ascii=False)
    return said | ({"carom.sweep": spec} if len(spec) <= LONGEST_SPEC else {})


def _encoding(player: RowPlayer) -> dict[str, object]:
    """The encoding of each column; a quarter smaller than the default on mid-game shots."""
    draws = (d for d in player.spec.draws if d.kind == "number" and d.distribution != "choice")
    drawn = {draw.name for draw in draws}
    split = {name for name in player.schema.names if name in drawn or _is_measured(name)}
    encodings = dict.fromkeys(split, "BYTE_STREAM_SPLIT") | {"row": "DELTA_BINARY_PACKED"}
    # Balls that were not hit end where they started; zstd finds these repetitions in plain bytes.
    plain = {name for name in player.schema.names if name.startswith("end_")}
    few = [name for name in player.schema.names if name not in encodings and name not in plain]
    return {
        "compression": "zstd",
        "use_dictionary": ["pocket.list.element" if name == "pocket" else name for name in few],
        "column_encoding": encodings,
        # Readers that verify checksums of pages can find damage as well.
        "write_page_checksum": True,
    }


def _is_measured(name: str) -> bool:
    """Whether nearly all values differ, so that splitting them by byte compresses better."""
    return name == "duration" or name.startswith(("cue_end_", "played_"))
