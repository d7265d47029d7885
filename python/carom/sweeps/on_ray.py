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

from carom import __version__
from carom.errors import InputError
from carom.lazy import pa
from carom.sweeps.parts import UNFINISHED, Parts, Receipt
from carom.sweeps.play import CHUNK

if TYPE_CHECKING:
    from carom.sweeps.play import RowPlayer

# Most large tasks: Ray's scheduler holds all of them in memory.
_MOST_TASKS = 10_000
# Most parts of a task: about ten seconds of work, long against the quarter of a second that a core
# waits for its next task.
_MOST_PARTS = 8
# Tasks left per core when tasks begin to shrink, so that all cores end at the same time.
_LAST_TASKS = 3


def start(address: bool | str, threads: int) -> None:
    """Start Ray on ``threads`` cores of this machine, or join the cluster at ``address``.

    If Ray is running in this process already, that one is used.

    Raises:
        InputError: Ray is not installed, no cluster answers at the address, or one of its
            machines has no carom of this version.
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
            remedy = "set RAY_AUTH_MODE=token and provide the token as Ray's manual describes"
            raise InputError(
                "system", "address", f"{address!r} requires Ray's token", remedy
            ) from None
        remedy = "start one (ray start --head), or omit the address to start Ray on this machine"
        raise InputError(
            "system", "address", f"no Ray cluster answers at {address!r}", remedy
        ) from None
    except RuntimeError as error:
        # The cluster has another version of Ray or of Python.
        raise InputError(
            "system", "address", f"{address!r} cannot be joined: {error}", ""
        ) from None


def _check_machines() -> None:
    """Reject a cluster with a machine that has no carom, or another version.

    Raises:
        InputError: With the name of the first such machine and its version.
    """
    ray = _ray()
    wanted = __version__

    # Ray must send this function by value: a machine without carom could not import it.
    def look() -> str | None:
        host = socket.gethostname()
        try:
            import_module("carom.sweeps.play")
            found = import_module("carom").__version__
        except Exception as error:  # noqa: BLE001 -- carom's own errors do not exist there
            return f"{host} cannot load carom ({error})"
        return None if found == wanted else f"{host} has carom {found}"

    at = import_module("ray.util.scheduling_strategies").NodeAffinitySchedulingStrategy
    asked = ray.remote(num_cpus=0)(look)
    nodes = [n for n in ray.nodes() if n["Alive"] and n["Resources"].get("CPU", 0) > 0]
    answers = [asked.options(scheduling_strategy=at(n["NodeID"], soft=False)) for n in nodes]
    for wrong in ray.get([answer.remote() for answer in answers]):
        if wrong:
            remedy = f"every machine needs carom[ray] {wanted}, or a runtime environment with it"
            raise InputError("mismatch", "", wrong, remedy)


def _wake() -> None:
    """Run a small job, so that every worker and Ray Data itself load their modules."""

    def load(batch: pa.Table) -> pa.Table:
        import_module("carom.sweeps.play")
        return batch

    cores = _cores()
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
            _check_version(version)
            _check_folder(marker)
            receipts = [asdict(_receipt(player, parts, part)) for part in batch["part"].to_pylist()]
        # Returned as a value: Ray would add two pages of its own text to an exception.
        except InputError as error:
            refused = json.dumps([error.kind, error.place, error.fault, error.remedy])
        except OSError as error:
            refused = json.dumps(["system", "", str(error)])
        schema = pa.schema({"receipts": pa.string(), "refused": pa.string()})
        return pa.table({"receipts": [json.dumps(receipts)], "refused": [refused]}, schema=schema)

    wanted = data.from_arrow([pa.table({"part": task}) for task in _tasks(missing, _cores())])
    done = wanted.map_batches(work, batch_size=1, batch_format="pyarrow")
    for batch in done.iter_batches(batch_size=None, batch_format="pyarrow", prefetch_batches=0):
        for answer in batch.to_pylist():
            if answer["refused"] is not None:
                raise InputError(*json.loads(answer["refused"]))
            yield from (Receipt(**row) for row in json.loads(answer["receipts"]))


def _check_version(wanted: str) -> None:
    """Reject a machine with another version of carom, whose results may differ."""
    if __version__ != wanted:
        host = socket.gethostname()
        raise InputError(
            "mismatch",
            "",
            f"{host} has carom {__version__}, but the run needs {wanted}",
            "install that version",
        )


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
    if _ray().is_initialized():
        _check_machines()
    version = __version__

    def work(block: pa.Table) -> Generator[pa.Table]:
        _check_version(version)
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


def _cores() -> int:
    return int(_ray().cluster_resources().get("CPU", 1))


def _ray() -> Any:
    try:
        with warnings.catch_warnings():
            # Ray's own warnings do not concern users of carom.
            warnings.simplefilter("ignore")
            import ray
    except ImportError:
        raise InputError(
            "unsupported", "ray", "Ray is not installed", "run pip install 'carom[ray]'"
        ) from None
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
