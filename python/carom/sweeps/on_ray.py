"""A sweep on Ray: the same function of the same rows, by processes on one machine or on many."""

from __future__ import annotations

import logging
import math
import socket
import warnings
from collections.abc import Generator
from importlib import import_module
from typing import TYPE_CHECKING, Any

from carom import __version__
from carom.errors import InputError
from carom.sweeps.arrow import pa
from carom.sweeps.parts import CHUNK, Parts, Receipt

if TYPE_CHECKING:
    from carom.sweeps.table import Sweep

# Large tasks that Ray is given at most: it keeps all of them in its books.
_MOST_TASKS = 10_000
# Parts of a task at most: some ten seconds of work, beside which the quarter of a second that a
# core waits for its next task is little.
_MOST_PARTS = 8
# Tasks that are left for each core when they begin to shrink, so that all cores end together.
_LAST_TASKS = 3


def start(address: bool | str, threads: int) -> None:
    """Start Ray here on so many cores, or join the cluster at ``address``; once is enough.

    Raises:
        InputError: Ray is not installed, or there is no cluster at that address.
    """
    ray = _ray()
    if ray.is_initialized():
        return
    quiet = {"log_to_driver": False, "logging_level": logging.ERROR}
    if isinstance(address, str):
        try:
            ray.init(address=address, **quiet)
        except ConnectionError:
            remedy = "start one (ray start --head), or leave the address out to start Ray here"
            raise InputError(f"address: no Ray cluster answers at {address!r}; {remedy}") from None
    else:
        ray.init(address="local", num_cpus=threads, include_dashboard=False, **quiet)
    _wake()


def _wake() -> None:
    """Let every worker load what it will need, and Ray Data what it keeps beside them."""

    def load(batch: pa.Table) -> pa.Table:
        import_module("carom.sweeps.play")
        return batch

    cores = _cores()
    numbers = _ray_data().range(cores, override_num_blocks=cores)
    numbers.map_batches(load, batch_format="pyarrow").materialize()


def write(sweep: Sweep, parts: Parts, missing: list[int]) -> Generator[Receipt]:
    """Write parts by Ray's workers, whose machines all see the folder.

    Files are put there whole or not at all, and are functions of the sweep and their number: when a
    worker is killed Ray gives its parts to another one, which writes the same files.
    """
    if not missing:
        return
    data = _ray_data()
    version = __version__

    def work(batch: pa.Table) -> pa.Table:
        _check_version(version)
        receipts = [_receipt(sweep, parts, part) for part in batch["part"].to_pylist()]
        columns = {name: [getattr(r, name) for r in receipts] for name in Receipt.__slots__}
        return pa.table(columns)

    wanted = data.from_arrow([pa.table({"part": task}) for task in _tasks(missing, _cores())])
    done = wanted.map_batches(work, batch_size=1, batch_format="pyarrow")
    for batch in done.iter_batches(batch_size=None, batch_format="pyarrow", prefetch_batches=0):
        yield from (Receipt(**row) for row in batch.to_pylist())


def _check_version(wanted: str) -> None:
    """Refuse to work on a machine with another version, whose results may differ."""
    if __version__ != wanted:
        host = socket.gethostname()
        raise InputError(
            f"{host} has carom {__version__}, and the run is of {wanted}; install the same"
        )


def _tasks(parts: list[int], cores: int) -> Generator[list[int]]:
    """Parts in the order in which they are begun, many at once first and one by one at the end."""
    most = max(_MOST_PARTS, math.ceil(len(parts) / _MOST_TASKS))
    begun = 0
    while begun < len(parts):
        share = (len(parts) - begun) // (_LAST_TASKS * cores)
        size = min(max(share, 1), most)
        yield parts[begun : begun + size]
        begun += size


def _receipt(sweep: Sweep, parts: Parts, part: int) -> Receipt:
    # Done already by a worker that was killed later in the same task.
    if parts.path(part).exists():
        return parts.receipt(sweep, part)
    return parts.write(sweep, part)


def dataset(sweep: Sweep) -> Any:
    """``Sweep.dataset``."""
    data = _ray_data()
    version = __version__

    def work(block: pa.Table) -> Generator[pa.Table]:
        _check_version(version)
        # A block is a run of consecutive numbers.
        first, last = block["id"][0].as_py(), block["id"][-1].as_py()
        for start in range(first, last + 1, CHUNK):
            stop = min(start + CHUNK, last + 1)
            yield pa.Table.from_batches([sweep.play(sweep.parameters(start, stop))])

    blocks = min(math.ceil(len(sweep) / CHUNK), _MOST_TASKS)
    numbers = data.range(len(sweep), override_num_blocks=blocks)
    made = numbers.map_batches(work, batch_size=None, batch_format="pyarrow")
    made.context.execution_options.preserve_order = True
    return made


def _cores() -> int:
    return int(_ray().cluster_resources().get("CPU", 1))


def _ray() -> Any:
    try:
        with warnings.catch_warnings():
            # Ray's own, of no use to who reads them here.
            warnings.simplefilter("ignore")
            import ray
    except ImportError:
        raise InputError("this needs Ray: pip install 'carom[ray]'") from None
    return ray


def _ray_data() -> Any:
    _ray()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import ray.data

        context = ray.data.DataContext.get_current()
    context.enable_progress_bars = False
    logging.getLogger("ray.data").setLevel(logging.ERROR)
    return ray.data
