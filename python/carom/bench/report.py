"""The results of the benchmark as one JSON object, as tables on the terminal, and in a file."""

from __future__ import annotations

import json
import os
import platform
import statistics
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.table import Table

from carom import __version__
from carom.bench.states import CLASSES
from carom.files import write_whole
from carom.installed import commit_of

if TYPE_CHECKING:
    from rich.console import Console

    from carom.bench.timing import ClassTimes

#: The least ratio of medians, the peer's over carom's, that the project promises.
BAR_RATIO = 1000
#: The largest ratio of a shot's time with a trace to its time without one.
BAR_TRACE = 3
#: The most that `import carom` may take, s, and the peak memory of the process, MB.
BAR_IMPORT = {"seconds": 0.15, "megabytes": 60}


def summary(times: ClassTimes) -> dict[str, Any]:
    """The figures of one class: times in µs, costs of an event in ns."""
    result: dict[str, Any] = {
        "shots": len(times.ours),
        "median_us": _us(statistics.median(times.ours)),
        "mean_us": _us(statistics.mean(times.ours)),
        "mixed_mean_us": _us(times.mixed),
        "ns_per_event": _ns(times.ours, times.events),
        "events_mean": statistics.mean(times.events),
        "trace_ratio": statistics.median(
            with_ / without for with_, without in zip(times.traced, times.ours, strict=True)
        ),
    }
    if times.peer:
        result["peer"] = {
            "median_us": _us(statistics.median(times.peer)),
            "mean_us": _us(statistics.mean(times.peer)),
            "mixed_mean_us": _us(times.peer_mixed),
            "ns_per_event": _ns(times.peer, times.peer_events),
            "events_mean": statistics.mean(times.peer_events),
        }
        result["ratio_of_medians"] = statistics.median(times.peer) / statistics.median(times.ours)
        result["ratio_per_event"] = result["peer"]["ns_per_event"] / result["ns_per_event"]
        result["ratio_of_mixed_means"] = times.peer_mixed / times.mixed
        result["same_balls_pocketed"] = statistics.mean(times.same_pocketed)
    return result


def _us(seconds: float) -> float:
    return seconds * 1e6


def _ns(seconds: list[float], events: list[int]) -> float:
    return sum(seconds) * 1e9 / sum(events)


def where() -> dict[str, Any]:
    """The version, commit, date and machine of a measurement."""
    return {
        "format": "carom-bench/1",
        "carom": __version__,
        "commit": _commit(),
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "machine": {
            "processor": _processor(),
            "cores": os.cpu_count(),
            "system": platform.platform(terse=True),
            "python": platform.python_version(),
        },
    }


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def checkout() -> Path | None:
    """The checkout that this package is installed from, or else that of the working directory."""
    for root in (Path(__file__).resolve().parents[3], Path.cwd()):
        if (root / "Cargo.toml").is_file() and (root / "python" / "carom" / "bench").is_dir():
            return root
    return None


# Every tracked file but the results: one benchmark writes its results before the next one starts.
CODE = (".", ":(exclude)benches/results", ":(exclude)validation/leckie_greenspan_2006/*.json")


def _commit() -> str | None:
    """Short name of the checkout's commit, with ``+`` if files of CODE have changes."""
    root = checkout()
    return None if root is None else commit_of(root, CODE)


def store(result: dict[str, Any], folder: Path) -> Path:
    """Writes the result to ``<date>-<commit>.json`` in `folder`.

    Without the peer ``-alone`` is added to the name, so that a run without the peer does not
    overwrite one with it.
    """
    folder.mkdir(parents=True, exist_ok=True)
    commit = (result["commit"] or result["carom"]).replace("+", "-changed")
    alone = "" if result["peer"] else "-alone"
    path = folder / f"{result['date'][:10]}-{commit}{alone}.json"
    write_whole(path, json.dumps(result, indent=2, ensure_ascii=False) + "\n")
    return path


def show(result: dict[str, Any], console: Console) -> None:
    """Prints the result as tables."""
    console.print(
        f"carom {result['carom']} ({result['commit'] or 'no checkout'}) on "
        f"{result['machine']['processor']}, one core, no traces.\n"
        "Processor time. In turn: the mean over a class's shots, each unlike the one before.\n"
        "Repeated: the median of a shot's rounds, then of a class's shots.",
        highlight=False,
    )
    console.print(_means(result), highlight=False)
    console.print(_medians(result), highlight=False)
    console.print(_events(result), highlight=False)
    console.print(_others(result), highlight=False)


def _means(result: dict[str, Any]) -> Table:
    """The means over shots in turn."""
    peer = result["peer"]
    table = _table(["in turn, mean", *(["carom", peer, "ratio"] if peer else ["carom"])])
    for name, row in result["classes"].items():
        cells = [CLASSES[name], f"{row['mixed_mean_us']:.2f} µs"]
        if peer:
            cells.append(f"{row['peer']['mixed_mean_us'] / 1000:.2f} ms")
            cells.append(f"{row['ratio_of_mixed_means']:.0f}")
        table.add_row(*cells)
    return table


def _medians(result: dict[str, Any]) -> Table:
    """The medians of repeated shots."""
    peer = result["peer"]
    names = ["carom", peer, "ratio", f"≥ {BAR_RATIO}"] if peer else ["carom"]
    table = _table(["repeated, median", *names])
    for name, row in result["classes"].items():
        cells = [CLASSES[name], f"{row['median_us']:.2f} µs"]
        if peer:
            ratio = row["ratio_of_medians"]
            cells.append(f"{row['peer']['median_us'] / 1000:.2f} ms")
            cells += [f"{ratio:.0f}", _verdict(ratio >= BAR_RATIO)]
        table.add_row(*cells)
    return table


def _events(result: dict[str, Any]) -> Table:
    """Numbers of events, which differ where the default models do, and the cost of an event."""
    peer = result["peer"]
    names = ["carom", "ns/event", "trace"]
    table = _table(["events", *names, "peer's", "ratio"] if peer else ["events", *names])
    for name, row in result["classes"].items():
        cells = [
            CLASSES[name],
            f"{row['events_mean']:.1f}",
            f"{row['ns_per_event']:.0f}",
            f"× {row['trace_ratio']:.2f}",
        ]
        if peer:
            cells += [f"{row['peer']['events_mean']:.1f}", f"{row['ratio_per_event']:.0f}"]
        table.add_row(*cells)
    return table


def _table(names: list[str]) -> Table:
    """An empty table with these columns; the first one is aligned to the left."""
    table = Table()
    table.add_column(names[0], no_wrap=True)
    for name in names[1:]:
        table.add_column(name, justify="right")
    return table


def _others(result: dict[str, Any]) -> Table:
    table = Table.grid(padding=(0, 2))
    rows = result["classes"].values()
    if result["peer"]:
        same = ", ".join(f"{100 * row['same_balls_pocketed']:.0f} %" for row in rows)
        table.add_row("same balls pocketed", same)
    trace = max(row["trace_ratio"] for row in rows)
    table.add_row(
        "trace", f"at most × {trace:.2f} (bar {BAR_TRACE}: {_verdict(trace <= BAR_TRACE)})"
    )
    threads = ", ".join(f"{n}: {rate:,.0f}" for n, rate in result["shots_per_second"].items())
    table.add_row("shots/s by threads", threads)
    variants = result["variants"]
    table.add_row(f"{variants['count']:,} variants", f"{variants['seconds']:.3f} s in one call")
    took = result["import"]
    holds = all(took[key] <= bar for key, bar in BAR_IMPORT.items())
    table.add_row(
        "import carom",
        f"{took['seconds']:.3f} s, {took['megabytes']:.0f} MB "
        f"(bars {BAR_IMPORT['seconds']} s, {BAR_IMPORT['megabytes']} MB: {_verdict(holds)})",
    )
    return table


def _verdict(holds: bool) -> str:
    return "yes" if holds else "no"
