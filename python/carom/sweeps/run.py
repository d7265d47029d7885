"""Writing a sweep into a folder, on all cores of this machine or on Ray."""

from __future__ import annotations

import json
import time
from collections.abc import Generator, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import closing, contextmanager
from pathlib import Path
from threading import Event
from typing import TYPE_CHECKING

from carom import __version__
from carom.arguments import cores, whole
from carom.errors import InputError
from carom.files import read_text, write_whole
from carom.lock import locked
from carom.progress import progress_bar
from carom.sweeps import on_ray
from carom.sweeps.parts import Parts, Receipt, default_rows
from carom.sweeps.report import Report
from carom.threads import startable

if TYPE_CHECKING:
    from carom.sweeps.play import RowPlayer

# The file that describes the folder.
MANIFEST = "sweep.json"
FORMAT = "carom-sweep-parts/1"
# Most files in one folder, far more than a file system lists quickly. The limit keeps a typing
# error in a spec from filling the disk.
MOST_PARTS = 10**6
# Seconds between two looks at Ctrl-C.
_PATIENCE = 0.2


def run(
    player: RowPlayer,
    folder: Path,
    *,
    threads: int | None,
    part_rows: int | None,
    ray: bool | str,
    progress: bool,
) -> Report:
    """``Sweep.run``."""
    threads = cores(threads)
    if part_rows is not None:
        part_rows = whole("part_rows", part_rows, low=1)
    begun = time.perf_counter()
    with _claimed(player, folder, part_rows) as parts:
        parts.tidy()
        before = parts.receipts(player, threads)
        if parts.sha256 != player.spec.sha256:
            parts.check_values(player)
        there = {receipt.part for receipt in before}
        missing = [k for k in range(len(parts)) if k not in there]
        ray_start = None
        with progress_bar(player.spec.rows, show=progress, what="rows") as advance:
            advance(sum(receipt.rows for receipt in before))
            if ray is False:
                written = _here(player, parts, missing, threads)
            else:
                started = time.perf_counter()
                on_ray.start(ray, threads)
                ray_start = time.perf_counter() - started
                written = on_ray.write(player, parts, missing)
            receipts = list(before)
            with closing(written):
                for receipt in written:
                    receipts.append(receipt)
                    advance(receipt.rows)
        parts.tidy()
    return Report(
        folder=str(folder),
        sha256=player.spec.sha256,
        rows=sum(receipt.rows for receipt in receipts),
        failed=sum(receipt.failed for receipt in receipts),
        parts=len(parts),
        parts_before=len(before),
        parts_unchecked=sum(not receipt.checked for receipt in receipts),
        bytes=sum(receipt.bytes for receipt in receipts),
        seconds=time.perf_counter() - begun - (ray_start or 0.0),
        ray_start_seconds=ray_start,
        workers=len({receipt.worker for receipt in receipts} - {0}),
    )


def _here(player: RowPlayer, parts: Parts, missing: list[int], threads: int) -> Generator[Receipt]:
    """Write parts, one per thread: Rust and Parquet release the interpreter's lock."""
    stop = Event()

    def go_on() -> bool:
        return not stop.is_set()

    threads = startable(threads)
    if threads == 0:
        for part in missing:
            yield parts.write(player, part)
        return
    left = iter(missing)
    with ThreadPoolExecutor(threads) as pool:
        running: list[Future[Receipt]] = []
        try:
            while True:
                # Submit no more than the threads can write: waiting parts would fill memory.
                for part in left:
                    running.append(pool.submit(parts.write, player, part, go_on))
                    if len(running) > threads:
                        break
                if not running:
                    return
                wait(running, timeout=_PATIENCE, return_when=FIRST_COMPLETED)
                # In the order of the parts, so that an error is that of the first of them.
                for future in [one for one in running if one.done()]:
                    running.remove(future)
                    yield future.result()
        finally:
            # After Ctrl-C, or an error such as a full disk, unfinished parts are abandoned.
            stop.set()
            for future in running:
                future.cancel()


@contextmanager
def _claimed(player: RowPlayer, folder: Path, part_rows: int | None) -> Iterator[Parts]:
    """The parts of the sweep in its folder, locked against other runs.

    Raises:
        InputError: The folder belongs to another sweep, or another run writes to it.
    """
    manifest = folder / MANIFEST
    if not manifest.exists():
        strangers = sorted(folder.glob("*.parquet"))
        if strangers:
            raise InputError(
                "mismatch",
                str(strangers[0]),
                f"the file belongs to no sweep ({MANIFEST} is missing)",
                "choose another folder",
            )
        _check_count(player.spec.rows, part_rows or default_rows(player.spec.rows))
        player.check()
        folder.mkdir(parents=True, exist_ok=True)
    with locked(folder, "sweep"):
        # Another run may have begun since.
        if not manifest.exists():
            _begin(player, manifest, part_rows or default_rows(player.spec.rows))
        rows, sha256 = _manifest(player, manifest, read_text(manifest), part_rows)
        _check_count(player.spec.rows, rows)
        yield Parts(folder, player.spec.rows, rows, sha256)


def _begin(player: RowPlayer, manifest: Path, rows: int) -> None:
    said = {
        "format": FORMAT,
        "carom": __version__,
        "sha256": player.spec.sha256,
        "rows": player.spec.rows,
        "part_rows": rows,
        "spec": player.spec.file,
    }
    write_whole(manifest, json.dumps(said, ensure_ascii=False, indent=1))


def _check_count(rows: int, part_rows: int) -> None:
    if rows > MOST_PARTS * part_rows:
        least = -(-rows // MOST_PARTS)
        raise InputError(
            "out-of-range",
            "part_rows",
            f"{rows} rows in parts of {part_rows} are more than {MOST_PARTS} files",
            f"give part_rows ≥ {least}, or a sweep of fewer rows",
        )


def _manifest(player: RowPlayer, manifest: Path, text: str, wanted: int | None) -> tuple[int, str]:
    """Rows of a part and hash from the manifest, which must be that of this sweep and this run."""
    remedy = "choose another folder, or delete this one"
    try:
        said = json.loads(text)
        sha256, version = said["sha256"], said["carom"]
        rows = whole("part_rows", said["part_rows"], low=1)
    except (ValueError, KeyError, TypeError):
        raise InputError("format", str(manifest), "it does not describe a sweep", remedy) from None
    if sha256 not in (player.spec.sha256, player.spec.undated_sha256):
        raise InputError("mismatch", str(manifest), "the folder holds another sweep", remedy)
    if version != __version__:
        what = f"the folder was begun by carom {version}, and this is {__version__}"
        raise InputError("mismatch", str(manifest), f"{what}, whose results may differ", remedy)
    if wanted not in (None, rows):
        what = f"the folder has parts of {rows} rows, and part_rows is {wanted}"
        raise InputError(
            "mismatch", str(manifest), what, "leave part_rows out, or choose another folder"
        )
    return rows, sha256
