"""Rows a second of a sweep, its memory, and the overhead of Ray on the same cores.

    python benches/sweep.py [ROWS]

Ten million mid-game shots (the 400 layouts of `carom bench`, with the Computational Olympiad's
noise) are written to Parquet by the threads of one process, and then by Ray's workers on as many
cores, three times in turns. Ray's start is measured separately. The files of all runs are compared.
The same shots are also played in a batch, which writes nothing, and in a sweep without the columns
of contacts. Every run is a process of its own. The result is stored in
``benches/results/sweep.json``.
"""

from __future__ import annotations

import hashlib
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path
from statistics import median
from typing import Any

from carom import Shot, Sweep, simulate_batch
from carom.bench import report, states

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "sweep.json"
ROWS = 10_000_000
#: Number of measurements of each, in turns.
TURNS = 3
#: The largest overhead of Ray that is allowed.
BAR_OVERHEAD = 0.15
#: Shots of the batch and rows of the small sweep, as a share of all rows.
SHARE = 0.1
#: Columns that need no record of contacts.
WITHOUT_FACTS = ["events", "duration", "pocket", "end_x", "end_y"]


def main(rows: int) -> int:
    """Measures, prints and stores."""
    result: dict[str, Any] = report.where()
    with tempfile.TemporaryDirectory() as folder:
        turns = [(child("here", rows, folder), child("ray", rows, folder)) for _ in range(TURNS)]
        small = round(rows * SHARE)
        plain = child("plain", small, folder)
        batch = child("batch", small, folder)
    runs = [run for turn in turns for run in turn]
    if any(run["files"] != runs[0]["files"] for run in runs):
        raise SystemExit("the files that Ray wrote differ from those of the single process")
    here, ray = (middle(side) for side in zip(*turns, strict=True))
    result |= {
        "cores": os.cpu_count(),
        "here": here,
        "ray": ray,
        "without_facts": without_files(plain),
        "batch": batch,
        "ray_overhead": round(median(b["seconds"] / a["seconds"] for a, b in turns) - 1, 4),
    }
    print(json.dumps(result, indent=2))
    print(f"bar: Ray adds under {BAR_OVERHEAD:.0%}")
    STORED.parent.mkdir(parents=True, exist_ok=True)
    STORED.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def middle(runs: Iterable[dict[str, Any]]) -> dict[str, Any]:
    """The run of median duration."""
    return without_files(sorted(runs, key=lambda run: run["seconds"])[TURNS // 2])


def without_files(run: dict[str, Any]) -> dict[str, Any]:
    """The figures of a run that are stored."""
    return {key: value for key, value in run.items() if key != "files"}


def child(what: str, rows: int, folder: str) -> dict[str, Any]:
    """One measurement, in a process of its own."""
    command = [sys.executable, __file__, what, str(rows), folder]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    print(what, {k: v for k, v in found.items() if k != "files"}, file=sys.stderr)
    return found


def measure(what: str, rows: int, folder: Path) -> dict[str, Any]:
    """The measurement of a child process."""
    return batch(rows) if what == "batch" else sweep(what, rows, folder / what)


def sweep(what: str, rows: int, folder: Path) -> dict[str, Any]:
    """Rows a second, memory, size and the files' hashes; deletes the files."""
    shots = [state.shot_file() for state in states.load()["random_eight_ball"]]
    spec: dict[str, Any] = {
        "format": "carom-sweep/1",
        "shots": shots,
        "noise": "olympiad",
        "variants": rows // len(shots),
    }
    if what == "plain":
        spec["columns"] = WITHOUT_FACTS
    made = Sweep.from_dict(spec)
    begun = time.process_time()
    done = made.run(folder, ray=what == "ray")
    result: dict[str, Any] = {
        "rows": done.rows,
        "failed": done.failed,
        "parts": done.parts,
        "seconds": round(done.seconds, 2),
        "rows_per_second": round(done.rows / done.seconds),
        "bytes_per_row": round(done.bytes / done.rows, 1),
    }
    if what == "ray":
        result |= {"workers": done.workers, "start_seconds": round(done.ray_start_seconds or 0, 2)}
    else:
        processor = time.process_time() - begun
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        result |= {
            "rows_per_core_second": round(done.rows / processor),
            "peak_megabytes": round(peak / 1024),
        }
    result["files"] = {}
    for path in sorted(folder.glob("*.parquet")):
        result["files"][path.name] = hashlib.sha256(path.read_bytes()).hexdigest()
        path.unlink()
    return result


def batch(rows: int) -> dict[str, Any]:
    """The mid-game shots of `carom bench`, without noise, in a batch."""
    members = [Shot.from_dict(s.shot_file()) for s in states.load()["random_eight_ball"]]
    shots = members * (rows // len(members))
    simulate_batch(members)
    begun = time.perf_counter(), time.process_time()
    simulate_batch(shots)
    wall, processor = time.perf_counter() - begun[0], time.process_time() - begun[1]
    return {
        "rows": len(shots),
        "rows_per_second": round(len(shots) / wall),
        "rows_per_core_second": round(len(shots) / processor),
    }


if __name__ == "__main__":
    if len(sys.argv) == 4:
        print(json.dumps(measure(sys.argv[1], int(sys.argv[2]), Path(sys.argv[3]))))
        sys.exit(0)
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else ROWS))
