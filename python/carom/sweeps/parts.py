"""Parts of a table: a file of Parquet each, written whole or not at all."""

from __future__ import annotations

import itertools
import os
import socket
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from carom import __version__
from carom.errors import InputError
from carom.sweeps.arrow import pa, pq

if TYPE_CHECKING:
    from carom.sweeps.table import Sweep

# Rows that go to Rust in one call; between calls Ctrl-C is heard. Tens of milliseconds of work.
CHUNK = 16_384
# Rows of a row group: some tens of megabytes, all that a writer holds in memory.
GROUP = 131_072
# Rows of a part if nothing else is said, at most and at least: about a second of work, so that
# little is lost by a kill; and enough for a file to be worth opening.
MOST_ROWS = 131_072
LEAST_ROWS = 4096
# Parts that a small sweep has at least, so that all cores have some.
PARTS = 16
# Specs longer than this, such as those of a thousand layouts, stand in the folder only, bytes.
LONGEST_SPEC = 65_536
UNFINISHED = ".unfinished"

_counter = itertools.count()


class StoppedError(Exception):
    """A part was given up half-way, because the run is to end."""


@dataclass(frozen=True, slots=True)
class Receipt:
    """A part that lies complete in the folder.

    Attributes:
        part: Its number.
        rows: How many rows it has.
        failed: Of these, how many could not be played.
        bytes: Size of the file.
        worker: Process that wrote it; 0 if it was there already.
    """

    part: int
    rows: int
    failed: int
    bytes: int
    worker: int


@dataclass(frozen=True, slots=True)
class Parts:
    """How the rows of a sweep lie in files.

    Attributes:
        folder: Where.
        rows: Of the whole sweep.
        part_rows: Of each part but the last.
    """

    folder: Path
    rows: int
    part_rows: int

    def __len__(self) -> int:
        return (self.rows + self.part_rows - 1) // self.part_rows

    def path(self, part: int) -> Path:
        """The file of a part."""
        digits = max(6, len(str(len(self) - 1)))
        return self.folder / f"part-{part:0{digits}}.parquet"

    def range(self, part: int) -> tuple[int, int]:
        """The first row of a part, and the first that is not in it."""
        start = part * self.part_rows
        return start, min(start + self.part_rows, self.rows)

    def write(self, sweep: Sweep, part: int, go_on: Callable[[], bool] = lambda: True) -> Receipt:
        """Play a part and put its file into the folder.

        A pure function of sweep and part: whoever does it again after a kill writes the same file.

        Raises:
            StoppedError: ``go_on`` said no.
        """
        path = self.path(part)
        # A name that no other process takes, on no machine that sees the folder.
        name = f"{path.name}.{socket.gethostname()}-{os.getpid()}-{next(_counter)}{UNFINISHED}"
        unfinished = path.with_name(name)
        try:
            self._play_into(unfinished, sweep, part, go_on)
            with unfinished.open("rb+") as file:
                os.fsync(file.fileno())
            unfinished.replace(path)
        finally:
            unfinished.unlink(missing_ok=True)
        return self.receipt(sweep, part, worker=os.getpid())

    def _play_into(self, path: Path, sweep: Sweep, part: int, go_on: Callable[[], bool]) -> None:
        first, end = self.range(part)
        failed = 0
        with pq.ParquetWriter(path, sweep.schema, **_encoding(sweep)) as file:
            for start in range(first, end, GROUP):
                table = play_rows(sweep, start, min(start + GROUP, end), go_on)
                failed += len(table) - table["error"].null_count
                file.write_table(table, row_group_size=GROUP)
            file.add_key_value_metadata(metadata(sweep, first, failed))

    def receipt(self, sweep: Sweep, part: int, worker: int = 0) -> Receipt:
        """What the file of a part says about itself.

        Raises:
            InputError: It is not that part of this sweep, or it is broken.
        """
        path = self.path(part)
        try:
            found = pq.read_metadata(path)
        except (pa.ArrowInvalid, OSError) as error:
            remedy = "delete the file, and it is written anew"
            raise InputError(f"{path}: it cannot be read ({error}); {remedy}") from None
        said = found.metadata or {}
        start, stop = self.range(part)
        wanted = {
            b"carom.version": __version__,
            b"carom.sweep.sha256": sweep.sha256,
            b"carom.sweep.first_row": str(start),
        }
        same = all(said.get(key) == value.encode() for key, value in wanted.items())
        if not same or found.num_rows != stop - start:
            remedy = "delete the file, and it is written anew, or choose another folder"
            raise InputError(f"{path}: it is not part {part} of this sweep; {remedy}")
        failed = int(said[b"carom.sweep.failed"])
        return Receipt(part, stop - start, failed, path.stat().st_size, worker)

    def tidy(self) -> None:
        """Remove what killed writers have left behind."""
        for path in self.folder.glob(f"*{UNFINISHED}"):
            path.unlink(missing_ok=True)


def default_rows(rows: int) -> int:
    """Rows of a part, which depend on the sweep alone: never on the machine."""
    return min(max(rows // PARTS + 1, LEAST_ROWS), MOST_ROWS)


def play_rows(
    sweep: Sweep,
    start: int,
    stop: int,
    go_on: Callable[[], bool] = lambda: True,
    *,
    threads: int = 1,
) -> pa.Table:
    """Rows ``start`` up to ``stop``.

    Raises:
        StoppedError: ``go_on`` said no.
    """

    def chunk(first: int) -> pa.RecordBatch:
        if not go_on():
            raise StoppedError
        return sweep.play(sweep.parameters(first, min(first + CHUNK, stop)))

    firsts = range(start, stop, CHUNK)
    if threads == 1:
        return pa.Table.from_batches(map(chunk, firsts), schema=sweep.schema)
    with ThreadPoolExecutor(threads) as pool:
        return pa.Table.from_batches(pool.map(chunk, firsts), schema=sweep.schema)


def metadata(sweep: Sweep, first_row: int, failed: int) -> dict[str, str]:
    """What a file says about itself."""
    said = {
        "carom.version": __version__,
        "carom.sweep.sha256": sweep.sha256,
        "carom.sweep.first_row": str(first_row),
        "carom.sweep.failed": str(failed),
    }
    spec = sweep.to_json()
    return said | ({"carom.sweep": spec} if len(spec) <= LONGEST_SPEC else {})


def _encoding(sweep: Sweep) -> dict[str, object]:
    """How columns are packed: measured on mid-game shots, a quarter smaller than as by default."""
    draws = (d for d in sweep.spec.draws if d.kind == "number" and d.distribution != "choice")
    drawn = {draw.name for draw in draws}
    split = {name for name in sweep.schema.names if name in drawn or _is_measured(name)}
    encodings = dict.fromkeys(split, "BYTE_STREAM_SPLIT") | {"row": "DELTA_BINARY_PACKED"}
    # Balls that were not hit end where they were: zstd finds them in the plain bytes.
    plain = {name for name in sweep.schema.names if name.startswith("end_")}
    few = [name for name in sweep.schema.names if name not in encodings and name not in plain]
    return {
        "compression": "zstd",
        "use_dictionary": ["pocket.list.element" if name == "pocket" else name for name in few],
        "column_encoding": encodings,
    }


def _is_measured(name: str) -> bool:
    """Whether no two rows have the same number, whose bytes pack better when they are sorted."""
    return name == "duration" or name.startswith(("cue_end_", "played_"))
