"""A sweep on Ray: the same function of the same rows, by processes on one machine or on many."""

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

from carom import __version__
from carom.errors import InputError
from carom.sweeps.arrow import pa
from carom.sweeps.parts import CHUNK, UNFINISHED, Parts, Receipt

if TYPE_CHECKING:
    from carom.sweeps.table import Sweep

# Large tasks that Ray is given at most: it keeps all of them in its books.
_MOST_TASKS = 10_000
# Parts of a task at most: some ten seconds of work, beside which the quarter of a second that a
# core waits for its next task is little.
_MOST_PARTS = 8
# Tasks that are left for each core when they begin to shrink, so that all cores end together.
_LAST_TASKS = 3
# What a task gives back: its receipts as JSON, or why it could not go on.
_ANSWER = pa.schema({"receipts": pa.string(), "refused": pa.string()})


def start(address: bool | str, threads: int) -> None:
    """Start Ray here on so many cores, or join the cluster at ``address``; once is enough.

    Raises:
        InputError: Ray is not installed, there is no cluster at that address, or it has machines
            that cannot play.
    """
    ray = _ray()
    begun = not ray.is_initialized()
    if begun:
        quiet = {"log_to_driver": False, "logging_level": logging.ERROR}
        if isinstance(address, str):
            _join(address, quiet)
        else:
            ray.init(address="local", num_cpus=threads, include_dashboard=False, **quiet)
    _check_machines()
    if begun:
        _wake()


def _join(address: str, quiet: dict[str, Any]) -> None:
    try:
        _ray().init(address=address, **quiet)
    except ConnectionError as error:
        if "InvalidAuthToken" in str(error.__cause__):
            remedy = "set RAY_AUTH_MODE=token, and have its token here as Ray says"
            raise InputError(f"address: {address!r} wants Ray's token; {remedy}") from None
        remedy = "start one (ray start --head), or leave the address out to start Ray here"
        raise InputError(f"address: no Ray cluster answers at {address!r}; {remedy}") from None
    except RuntimeError as error:
        # Another Ray or another Python there.
        raise InputError(f"address: {address!r} cannot be joined: {error}") from None


def _check_machines() -> None:
    """Refuse a cluster with a machine that has no carom, or another version.

    Raises:
        InputError: The first such machine, and what it has.
    """
    ray = _ray()
    wanted = __version__

    # Goes there in full: a reference into carom could not be followed where there is none.
    def look() -> str | None:
        host = socket.gethostname()
        try:
            import_module("carom.sweeps.play")
            found = import_module("carom").__version__
        except Exception as error:  # noqa: BLE001 -- carom's own errors are not known there
            return f"{host} cannot load carom ({error})"
        return None if found == wanted else f"{host} has carom {found}"

    at = import_module("ray.util.scheduling_strategies").NodeAffinitySchedulingStrategy
    asked = ray.remote(num_cpus=0)(look)
    nodes = [n for n in ray.nodes() if n["Alive"] and n["Resources"].get("CPU", 0) > 0]
    answers = [asked.options(scheduling_strategy=at(n["NodeID"], soft=False)) for n in nodes]
    for wrong in ray.get([answer.remote() for answer in answers]):
        if wrong:
            remedy = f"every machine needs carom[ray] {wanted}, or a runtime environment with it"
            raise InputError(f"{wrong}; {remedy}")


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
    # A worker stands in another folder than whoever asks for the run.
    parts = replace(parts, folder=parts.folder.absolute())
    sign = parts.folder / f"{uuid.uuid4().hex}{UNFINISHED}"
    sign.touch()

    def work(batch: pa.Table) -> pa.Table:
        receipts, refused = [], None
        try:
            _check_version(version)
            _check_folder(sign)
            receipts = [asdict(_receipt(sweep, parts, part)) for part in batch["part"].to_pylist()]
        except (InputError, OSError) as error:
            # Told as it is, not in the two pages that Ray makes of it.
            refused = str(error)
        return pa.table({"receipts": [json.dumps(receipts)], "refused": [refused]}, schema=_ANSWER)

    wanted = data.from_arrow([pa.table({"part": task}) for task in _tasks(missing, _cores())])
    done = wanted.map_batches(work, batch_size=1, batch_format="pyarrow")
    for batch in done.iter_batches(batch_size=None, batch_format="pyarrow", prefetch_batches=0):
        for answer in batch.to_pylist():
            if answer["refused"] is not None:
                raise InputError(answer["refused"])
            yield from (Receipt(**row) for row in json.loads(answer["receipts"]))


def _check_version(wanted: str) -> None:
    """Refuse to work on a machine with another version, whose results may differ."""
    if __version__ != wanted:
        host = socket.gethostname()
        raise InputError(
            f"{host} has carom {__version__}, and the run is of {wanted}; install the same"
        )


def _check_folder(sign: Path) -> None:
    """Refuse to write where the run has not left its sign: parts would lie there unseen."""
    if not sign.exists():
        raise InputError(
            f"{socket.gethostname()} does not see {sign.parent}; "
            "choose a folder that all machines of the cluster have under this path"
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
    if _ray().is_initialized():
        _check_machines()
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
