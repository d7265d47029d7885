"""Shots a second on a CUDA device. Untried: no machine with a card has run it (docs/gpu.md).

    python benches/cuda.py [DEVICE]

For batches of 10³ to 10⁷ shots: pots, mid-game shots, breaks of nine- and eight-ball, each shot
unlike the one before, and variants of one shot. Times contain checks of the strikes and all copies.
The bits of the smallest batches are compared with those of this machine. The result is stored in
``benches/results/cuda-<name of the device>.json``.
"""

from __future__ import annotations

import json
import re
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from carom import BatchResult, Noise, Shot, device, simulate_batch
from carom.bench import report, states

RESULTS = Path(__file__).resolve().parent / "results"
SIZES = [10**power for power in range(3, 8)]
#: Shots of a call. More would fill the memory with results that are thrown away.
CALL = 1_000_000
#: Measurements of each size; the fastest counts.
TURNS = 3


def main(name: str) -> int:
    """Measures, prints and stores."""
    card = device.opened(name)
    if card is None:
        raise SystemExit('give a CUDA device, such as "cuda"')
    multiprocessors, threads, registers, local_bytes = card.occupancy
    result: dict[str, Any] = report.where() | {
        "device": card.name,
        "occupancy": {
            "multiprocessors": multiprocessors,
            "threads_of_each": threads,
            "registers_of_a_thread": registers,
            "local_bytes_of_a_thread": local_bytes,
        },
        "shots_per_second": {},
    }
    for kind, play in kinds().items():
        compare(kind, play, name)
        rates = {size: rate(play, size, name) for size in SIZES}
        result["shots_per_second"][kind] = rates
        print(kind, *(f"{size}: {found:,.0f}/s" for size, found in rates.items()), sep="  ")
    file = "cuda-" + re.sub(r"\W+", "-", card.name.lower()).strip("-") + ".json"
    (RESULTS / file).write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0


def kinds() -> dict[str, Callable[[int, str], BatchResult]]:
    """How a number of shots of each kind is played on a device."""
    found: dict[str, Callable[[int, str], BatchResult]] = {}
    for name, members in states.load().items():
        shots = [Shot.from_dict(member.shot_file()) for member in members]

        def in_turn(count: int, where: str, shots: list[Shot] = shots) -> BatchResult:
            chosen = (shots * (count // len(shots) + 1))[:count]
            return simulate_batch(chosen, device=where)

        found[name] = in_turn
        if name == "random_eight_ball":
            found["variants_of_one"] = lambda count, where, shot=shots[0]: shot.vary(
                Noise.olympiad(), count, device=where
            )
    return found


def compare(kind: str, play: Callable[[int, str], BatchResult], name: str) -> None:
    """Ends the program if the card's bits differ from this machine's."""
    here, there = play(SIZES[0], "cpu"), play(SIZES[0], name)
    same = np.array_equal(here.final_position.view(np.int64), there.final_position.view(np.int64))
    if not (same and np.array_equal(here.events, there.events)):
        raise SystemExit(f"{kind}: the device has other bits")


def rate(play: Callable[[int, str], BatchResult], count: int, name: str) -> float:
    """Shots a second in batches of ``count``."""
    times = []
    for _ in range(TURNS):
        began = time.perf_counter()
        for start in range(0, count, CALL):
            play(min(CALL, count - start), name)
        times.append(time.perf_counter() - began)
    return count / min(times)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:] or ["cuda"]))
