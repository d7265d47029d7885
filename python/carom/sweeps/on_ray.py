"""A sweep on Ray: the same rows, computed by processes on one machine or on many."""

from __future__ import annotations

import json
import logging
import math
import socket
import uuid
import warnings
from collections.abc import Generator
from dataclasses import asdict, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from carom import __version__, cluster
from carom.errors import InputError
from carom.lazy import pa
from carom.sweeps.parts import UNFINISHED, Parts, Receipt
from carom.sweeps.play import CHUNK

if TYPE_CHECKING:
    from carom.sweeps.play import RowPlayer

# The module that every worker needs.
_MODULE = "carom.sweeps.play"
# Most large tasks: Ray's scheduler holds all of them in memory.
_MOST_TASKS = 10_000
# Most parts of a task: about ten seconds of work, long against the quarter of a second that a core
# waits for its next task.
_MOST_PARTS = 8
# Tasks left per core when tasks begin to shrink, so that all cores end at the same time.
_LAST_TASKS = 3


def start(address: bool | str, threads: int) -> None:
    """Start Ray on ``threads`` cores of this machine, or join the cluster at ``address``.

    Raises:
        InputError: As for ``cluster.start``.
    """
    if cluster.start(address, threads, _MODULE):
        _wake()


def _wake() -> None:
    """Run a small job, so that every worker and Ray Data itself load their modules."""

    def load(batch: pa.Table) -> pa.Table:
        import_module(_MODULE)
        return batch

    cores = cluster.cores()
    numbers = _ray_data().range(cores, override_num_blocks=cores)
    numbers.map_batches(load, batch_format="pyarrow").materialize()


def write(player: RowPlayer, parts: Parts, missing: list[int]) -> Generator[Receipt]:
    """Write parts with Ray's workers; all their machines must have access to the folder.

    A file is written completely or not at all, and is a function of the sweep and its number. When
    a worker is killed, Ray gives its parts to another one, which writes the same files.
    """
    if not missing:
        return
    data = _ray_data()
    version = __version__
    # A worker's current folder differs from the caller's.
    parts = replace(parts, folder=parts.folder.absolute())
    marker = parts.folder / f"{uuid.uuid4().hex}{UNFINISHED}"
    marker.touch()

    def work(batch: pa.Table) -> pa.Table:
        receipts, refused = [], None
        try:
            cluster.check_version(version)
            _check_folder(marker)
            receipts = [asdict(_receipt(player, parts, part)) for part in batch["part"].to_pylist()]
        # Returned as a value: Ray would add two pages of its own text to an exception.
        except InputError as error:
            refused = json.dumps([error.kind, error.place, error.fault, error.remedy])
        except OSError as error:
            refused = json.dumps(["system", "", str(error)])
        schema = pa.schema({"receipts": pa.string(), "refused": pa.string()})
        return pa.table({"receipts": [json.dumps(receipts)], "refused": [refused]}, schema=schema)

    wanted = data.from_arrow(
        [pa.table({"part": task}) for task in _tasks(missing, cluster.cores())]
    )
    # Ray gives each task a card of its own.
    needs = {} if player.device == "cpu" else {"num_gpus": 1}
    done = wanted.map_batches(work, batch_size=1, batch_format="pyarrow", **needs)
    for batch in done.iter_batches(batch_size=None, batch_format="pyarrow", prefetch_batches=0):
        for answer in batch.to_pylist():
            if answer["refused"] is not None:
                raise InputError(*json.loads(answer["refused"]))
            yield from (Receipt(**row) for row in json.loads(answer["receipts"]))


def _check_folder(marker: Path) -> None:
    """Reject a machine where the run's marker file is missing: its parts would be lost."""
    if not marker.exists():
        raise InputError(
            "system",
            "",
            f"{socket.gethostname()} has no access to {marker.parent}",
            "choose a folder that all machines of the cluster can reach under this path",
        )


def _tasks(parts: list[int], cores: int) -> Generator[list[int]]:
    """Divide parts into tasks, in order: large tasks first, single parts at the end."""
    most = max(_MOST_PARTS, math.ceil(len(parts) / _MOST_TASKS))
    begun = 0
    while begun < len(parts):
        share = (len(parts) - begun) // (_LAST_TASKS * cores)
        size = min(max(share, 1), most)
        yield parts[begun : begun + size]
        begun += size


def _receipt(player: RowPlayer, parts: Parts, part: int) -> Receipt:
    # A worker that was killed later in the same task has written this part.
    if parts.path(part).exists():
        return parts.receipt(player, part)
    return parts.write(player, part)


def dataset(player: RowPlayer) -> Any:
    """``Sweep.dataset``."""
    data = _ray_data()
    if cluster.ray().is_initialized():
        cluster.check_machines(_MODULE)
    version = __version__

    def work(block: pa.Table) -> Generator[pa.Table]:
        cluster.check_version(version)
        # A block is a run of consecutive numbers.
        first, last = block["id"][0].as_py(), block["id"][-1].as_py()
        for start in range(first, last + 1, CHUNK):
            stop = min(start + CHUNK, last + 1)
            yield pa.Table.from_batches([player.play(player.parameters(start, stop))])

    blocks = min(math.ceil(player.spec.rows / CHUNK), _MOST_TASKS)
    numbers = data.range(player.spec.rows, override_num_blocks=blocks)
    made = numbers.map_batches(work, batch_size=None, batch_format="pyarrow")
    made.context.execution_options.preserve_order = True
    return made


def _ray_data() -> Any:
    cluster.ray()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import ray.data

        context = ray.data.DataContext.get_current()
    context.enable_progress_bars = False
    logging.getLogger("ray.data").setLevel(logging.ERROR)
    return ray.data
