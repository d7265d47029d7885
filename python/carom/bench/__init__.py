"""``carom bench``: the speed of the engine on this machine, and of pooltool if it is installed."""

from __future__ import annotations

import json as js
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import Progress

from carom.bench import report, states, timing
from carom.bench.peer import Pooltool
from carom.shot import Shot
from carom.streams import emit

__all__ = ["measure", "run"]


def run(*, json: bool = False, store: Path | None = None) -> int:
    """Measure, print and store.

    Args:
        json: Print JSON on stdout instead of tables.
        store: Folder for the JSON. By default it is ``benches/results`` of the checkout that
            carom is installed from, or of the working directory's. Without a checkout nothing is
            stored.

    Returns:
        The exit status of the command.
    """
    if store is not None:
        # Before the measurement, which takes minutes: an unusable folder then fails at once.
        store.mkdir(parents=True, exist_ok=True)
    stderr = Console(stderr=True)
    result = measure(stderr)
    if json:
        emit(js.dumps(result, indent=2, ensure_ascii=False))
    else:
        report.show(result, Console())
    root = report.checkout()
    if store is None and root is not None:
        store = root / "benches" / "results"
    if store is not None:
        stderr.print(f"stored in {report.store(result, store)}", soft_wrap=True)
    return 0


def measure(stderr: Console) -> dict[str, Any]:
    """The results of `carom bench`; progress and remarks go to `stderr`."""
    classes = states.load()
    peer = _peer(stderr)
    result = report.where() | {"peer": peer and f"pooltool {peer.version}", "classes": {}}
    count = timing.ROUNDS * sum(map(len, classes.values()))
    with Progress(console=stderr, transient=True) as progress, timing.one_core():
        task = progress.add_task("shots", total=count)
        for name, members in classes.items():
            times = timing.time_class(members, peer, lambda: progress.advance(task))
            result["classes"][name] = report.summary(times)
    shots = [Shot.from_dict(state.shot_file()) for state in classes["random_eight_ball"]]
    result["shots_per_second"] = timing.time_threads(shots)
    result["variants"] = {"count": timing.VARIANTS, "seconds": timing.time_variants(shots[0])}
    result["import"] = timing.time_import()
    return result


def _peer(stderr: Console) -> Pooltool | None:
    try:
        peer = Pooltool()
    except ImportError as error:
        stderr.print(str(error), soft_wrap=True)
        return None
    stderr.print(f"pooltool {peer.version} compiles itself first, which takes half a minute")
    return peer
