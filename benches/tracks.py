"""The instructions of a candidate: simulated alone, with states, with residuals.

    python benches/tracks.py

A three-cushion shot with three balls is played up to 8 s; each ball has 400 samples. The table of
docs/tracks-engine.md is printed. It needs valgrind; the counts do not depend on the machine's load.
"""

from __future__ import annotations

import sys

import callgrind

#: The ways of ``crates/carom/examples/track_cost.rs``, and what the table says of each.
WAYS = {
    "play": "simulated, without any result",
    "states": "with the 1200 positions",
    "sums": "with sums of squares of the residuals",
    "residuals": "with all residuals and their sums",
    "physics": "sums; physics, start states and strike of its own",
}
#: Numbers of candidates; the difference of their counts is free of the cost of starting.
FEW, MANY = 100, 300


def main() -> int:
    """Counts and prints."""
    if not callgrind.is_installed():
        raise SystemExit("valgrind is missing; install it")
    program = callgrind.build("carom", "track_cost")
    print("| A candidate | instructions | of the simulation alone |\n| --- | --- | --- |")
    alone = 0.0
    for way, text in WAYS.items():
        few, many = (callgrind.count(program, way, count)[0] for count in (FEW, MANY))
        each = (many - few) / (MANY - FEW)
        alone = alone or each
        print(f"| {text} | {each / 1000:.1f} k | {each / alone:.2f} × |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
