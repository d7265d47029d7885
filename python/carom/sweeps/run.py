"""A sweep written into a folder: by all cores here, or by Ray."""

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
from carom.batch import progress_bar
from carom.errors import InputError
from carom.sweeps.parts import UNFINISHED, Parts, Receipt, default_rows
from carom.sweeps.report import Report

if TYPE_CHECKING:
    from carom.sweeps.table import Sweep

# What the folder says about itself.
MANIFEST = "sweep.json"
FORMAT = "carom-sweep-parts/1"
# How often Ctrl-C is looked for, s.
_PATIENCE = 0.2


def run(
    sweep: Sweep,
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
    with _claimed(sweep, folder, part_rows) as parts:
        parts.tidy()
        before = [parts.receipt(sweep, k) for k in range(len(parts)) if parts.path(k).exists()]
        there = {receipt.part for receipt in before}
        missing = [k for k in range(len(parts)) if k not in there]
        ray_start = None
        with progress_bar(len(sweep), show=progress, what="rows") as advance:
            advance(sum(receipt.rows for receipt in before))
            if ray is False:
                written = _here(sweep, parts, missing, threads)
            else:
                from carom.sweeps import on_ray

                started = time.perf_counter()
                on_ray.start(ray, threads)
                ray_start = time.perf_counter() - started
                written = on_ray.write(sweep, parts, missing)
            receipts = list(before)
            with closing(written):
                for receipt in written:
                    receipts.append(receipt)
                    advance(receipt.rows)
        parts.tidy()
    return Report(
        folder=str(folder),
        sha256=sweep.sha256,
        rows=sum(receipt.rows for receipt in receipts),
        failed=sum(receipt.failed for receipt in receipts),
        parts=len(parts),
        parts_before=len(before),
        bytes=sum(receipt.bytes for receipt in receipts),
        seconds=time.perf_counter() - begun - (ray_start or 0.0),
        ray_start_seconds=ray_start,
        workers=len({receipt.worker for receipt in receipts} - {0}),
    )


def _here(sweep: Sweep, parts: Parts, missing: list[int], threads: int) -> Generator[Receipt]:
    """Write parts, one thread each: Rust and Parquet let go of the interpreter."""
    stop = Event()

    def go_on() -> bool:
        return not stop.is_set()

    left = iter(missing)
    with ThreadPoolExecutor(threads) as pool:
        running: set[Future[Receipt]] = set()
        try:
            while True:
                # No more than are being written: what waits would only fill memory.
                for part in left:
                    running.add(pool.submit(parts.write, sweep, part, go_on))
                    if len(running) > threads:
                        break
                if not running:
                    return
                done, running = wait(running, timeout=_PATIENCE, return_when=FIRST_COMPLETED)
                for future in done:
                    yield future.result()
        finally:
            # Ctrl-C, or an error such as a full disk: what is half done is given up.
            stop.set()
            for future in running:
                future.cancel()


@contextmanager
def _claimed(sweep: Sweep, folder: Path, part_rows: int | None) -> Iterator[Parts]:
    """The parts of the sweep in its folder, which nobody else writes meanwhile.

    Raises:
        InputError: The folder belongs to another sweep, or another run writes there.
    """
    manifest = folder / MANIFEST
    if not manifest.exists():
        strangers = sorted(folder.glob("*.parquet"))
        if strangers:
            raise InputError(
                f"{strangers[0]}: it belongs to no sweep ({MANIFEST} is missing); "
                "choose another folder"
            )
        sweep._player.check()
        folder.mkdir(parents=True, exist_ok=True)
        rows = part_rows or default_rows(len(sweep))
        said = {
            "format": FORMAT,
            "carom": __version__,
            "sha256": sweep.sha256,
            "rows": len(sweep),
            "part_rows": rows,
            "spec": sweep.to_dict(),
        }
        unfinished = folder / f"{MANIFEST}{UNFINISHED}"
        unfinished.write_text(json.dumps(said, ensure_ascii=False, indent=1), encoding="utf-8")
        unfinished.replace(manifest)
    with manifest.open(encoding="utf-8") as file:
        _lock(file.fileno(), folder)
        yield Parts(folder, len(sweep), _part_rows(sweep, manifest, file.read(), part_rows))


def _part_rows(sweep: Sweep, manifest: Path, text: str, wanted: int | None) -> int:
    """Rows of a part as the manifest has them, if it is that of this sweep and of this run."""
    remedy = "choose another folder, or delete this one"
    try:
        said = json.loads(text)
        sha256, version, rows = said["sha256"], said["carom"], int(said["part_rows"])
    except (ValueError, KeyError, TypeError):
        raise InputError(f"{manifest}: it does not say which sweep this is; {remedy}") from None
    if sha256 != sweep.sha256:
        raise InputError(f"{manifest}: the folder has another sweep in it; {remedy}")
    if version != __version__:
        what = f"the folder was begun by carom {version}, and this is {__version__}"
        raise InputError(f"{manifest}: {what}, whose results may differ; {remedy}")
    if wanted not in (None, rows):
        what = f"the folder has parts of {rows} rows, and {wanted} are asked for"
        raise InputError(f"{manifest}: {what}; leave that out, or choose another folder")
    return rows


def _lock(file: int, folder: Path) -> None:
    """Claim the folder until the file is closed, also by a kill."""
    try:
        import fcntl
    except ImportError:
        # Windows: two runs in one folder write the same files twice, and no wrong ones.
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InputError(
            f"{folder}: another run writes there; wait for its end, or choose another folder"
        ) from None
    except OSError:
        # A file system without locks; see above.
        return
