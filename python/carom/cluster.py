"""Ray, on this machine or on a cluster: its start, and what its machines must have."""

from __future__ import annotations

import logging
import socket
import time
import warnings
from importlib import import_module
from typing import Any

from carom import __version__
from carom.errors import InputError

#: How often a cluster is looked at whose machines come and go, and the time between, s.
_LOOKS = 10
_PAUSE = 0.5


def start(address: bool | str, threads: int, module: str) -> bool:
    """Start Ray on ``threads`` cores of this machine, or join the cluster at ``address``.

    If Ray is running in this process already, that one is used.

    Args:
        address: True for this machine, or the address of a cluster.
        threads: Number of cores of this machine to use.
        module: The module of carom that the workers need.

    Returns:
        Whether Ray was not running in this process before.

    Raises:
        InputError: Ray is not installed, no cluster answers at the address, or one of its
            machines has no carom of this version.
    """
    library = ray()
    begun = not library.is_initialized()
    if begun:
        quiet = {"log_to_driver": False, "logging_level": logging.ERROR}
        if isinstance(address, str):
            _join(address, quiet)
        else:
            library.init(address="local", num_cpus=threads, include_dashboard=False, **quiet)
    check_machines(module)
    return begun


def _join(address: str, quiet: dict[str, Any]) -> None:
    try:
        ray().init(address=address, **quiet)
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


def check_machines(module: str) -> None:
    """Reject a cluster with a machine that has no carom, or another version.

    Raises:
        InputError: With the name of the first such machine and its version.
    """
    library = ray()
    wanted = __version__

    # Ray must send this function by value: a machine without carom could not import it.
    def look() -> str | None:
        host = socket.gethostname()
        try:
            import_module(module)
            found = import_module("carom").__version__
        except Exception as error:  # noqa: BLE001 -- carom's own errors do not exist there
            return f"{host} cannot load carom ({error})"
        return None if found == wanted else f"{host} has carom {found}"

    at = import_module("ray.util.scheduling_strategies").NodeAffinitySchedulingStrategy
    asked = library.remote(num_cpus=0)(look)
    unschedulable = import_module("ray.exceptions").TaskUnschedulableError

    def ask_all() -> list[str | None]:
        nodes = [n for n in library.nodes() if n["Alive"] and n["Resources"].get("CPU", 0) > 0]
        there = [asked.options(scheduling_strategy=at(n["NodeID"], soft=False)) for n in nodes]
        answers: list[str | None] = library.get([one.remote() for one in there])
        return answers

    for left in reversed(range(_LOOKS)):
        try:
            answers = ask_all()
            break
        except unschedulable:
            # A machine has left the cluster since the list was made, or is not ready yet.
            if left == 0:
                raise
            time.sleep(_PAUSE)
    for wrong in answers:
        if wrong:
            remedy = f"every machine needs carom[ray] {wanted}, or a runtime environment with it"
            raise InputError("mismatch", "", wrong, remedy)


def check_version(wanted: str) -> None:
    """Reject a machine with another version of carom, whose results may differ."""
    if __version__ != wanted:
        host = socket.gethostname()
        raise InputError(
            "mismatch",
            "",
            f"{host} has carom {__version__}, but the run needs {wanted}",
            "install that version",
        )


def cores() -> int:
    """Number of cores of the cluster."""
    return int(ray().cluster_resources().get("CPU", 1))


def ray() -> Any:
    """The library.

    Raises:
        InputError: It is not installed.
    """
    try:
        with warnings.catch_warnings():
            # Ray's own warnings do not concern users of carom.
            warnings.simplefilter("ignore")
            return import_module("ray")
    except ImportError:
        raise InputError(
            "unsupported", "ray", "Ray is not installed", "run pip install 'carom[ray]'"
        ) from None
