"""Draws the pots of `carom bench`: shots that pocket one ball alone, in carom and in pooltool.

    python scripts/draw_pots.py

It needs an environment with pooltool (`make bench-peer` makes one, .cache/peer), and writes them
into ``python/carom/data/bench_states.json.gz``. Layouts, speeds and spins are drawn from a fixed
seed. A grid of directions is played in carom; the middle of a range of directions that
pocket the same ball alone is played in pooltool, with its own default physics. A shot that pockets
the same ball alone there is taken, until every kind of pot has its number.
"""

from __future__ import annotations

import gzip
import json
import sys
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
from carom.bench.peer import Pooltool
from carom.bench.states import State
from carom.shot import Shot
from carom.trace import Trace

STATES = Path(__file__).parents[1] / "python" / "carom" / "data" / "bench_states.json.gz"
SEED = 37
#: How many shots of each kind are drawn.
KINDS = {"pot": 120, "bank": 40, "combination": 40, "kick": 40}
#: Directions of the grid.
DIRECTIONS = 1440
#: The playing area of the states' table, m, and the least distance of a centre from its edge.
SIZE, MARGIN = (0.9906, 1.9812), 0.06
#: The least distance of two centres, m.
APART = 0.08

ABOUT = (
    "Initial states to measure speed on: pots, breaks, and random mid-game layouts, on pooltool's "
    "seven_foot_showood table (carom's showood-7ft). balls: centre x, y (m, origin at the "
    "bottom-left corner); speed of the cue, m/s; azimuth_deg counter-clockwise from +x; "
    "elevation_deg of the butt; side > 0 right of the centre and height > 0 above it, in ball "
    "radii, perpendicular to the cue. Every number as it is in the source, to the last bit; "
    "pooltool's a is -side, its b is height. pots: the ball that the shot must pocket, alone, in "
    "carom and in pooltool."
)
SOURCE = (
    "Racks and layouts were generated with pooltool 0.6.0 (https://github.com/ekiefl/pooltool, "
    "Apache-2.0): one state for each seed 0, 1, 2, ... of a class. scripts/draw_pots.py drew the "
    f"pots for carom: {', '.join(f'{count} {kind}s' for kind, count in KINDS.items())}."
)


def main() -> int:
    """Draws and stores."""
    rng = np.random.default_rng(SEED)
    peer = Pooltool()
    found: dict[str, list[State]] = {kind: [] for kind in KINDS}
    while lacking := {kind for kind, count in KINDS.items() if len(found[kind]) < count}:
        drawn = draw(rng, peer, lacking)
        if drawn is not None:
            kind, state = drawn
            found[kind].append(state)
            print({kind: len(states) for kind, states in found.items()}, flush=True)
    store([state for states in found.values() for state in states])
    return 0


def draw(rng: np.random.Generator, peer: Pooltool, lacking: set[str]) -> tuple[str, State] | None:
    """One layout with one strike that pots in both engines in one of the ways that are lacking."""
    state = State(
        balls=layout(rng),
        speed=round(float(rng.uniform(1.0, 5.0)), 3),
        azimuth_deg=0.0,
        elevation_deg=round(float(rng.uniform(0.0, 5.0)), 2),
        side=round(float(rng.uniform(-0.3, 0.3)), 3),
        height=round(float(rng.uniform(-0.4, 0.4)), 3),
    )
    ranges = potting_ranges(Shot.from_dict(state.shot_file()))
    rng.shuffle(ranges)
    for name, azimuth in ranges:
        pot = replace(state, azimuth_deg=round(azimuth, 2), pots=name)
        trace = Shot.from_dict(pot.shot_file()).simulate()
        if [ball for ball, _ in trace.outcome.pocketed] != [name]:
            continue
        way = kind(trace, name)
        if way in lacking and peer.pocketed(peer.simulate(pot)[1]) == [name]:
            return way, pot
    return None


def layout(rng: np.random.Generator) -> dict[str, tuple[float, float]]:
    """A cue ball and one to three object balls, apart from each other and from the rails."""
    names = ["cue", "1", "2", "3"][: 2 + int(rng.integers(3))]
    balls: dict[str, tuple[float, float]] = {}
    for name in names:
        while True:
            x, y = (round(float(rng.uniform(MARGIN, side - MARGIN)), 4) for side in SIZE)
            if all(np.hypot(x - a, y - b) > APART for a, b in balls.values()):
                break
        balls[name] = (x, y)
    return balls


def potting_ranges(shot: Shot) -> list[tuple[str, float]]:
    """The ball that neighbouring directions pot alone, and their middle, degrees."""
    azimuths = np.linspace(0.0, 360.0, DIRECTIONS, endpoint=False)
    pocket = shot.batch(azimuth=np.radians(azimuths), threads=1).pocket
    alone = np.where((pocket >= 0).sum(axis=1) == 1, (pocket >= 0).argmax(axis=1), 0)
    edges = np.flatnonzero(np.diff(alone)) + 1
    return [
        (shot.ids[alone[part[0]]], float(azimuths[part].mean()))
        for part in np.split(np.arange(len(alone)), edges)
        if alone[part[0]] > 0 and len(part) > 1
    ]


def kind(trace: Trace, potted: str) -> str:
    """What the players call the shot: by what the two balls meet before the pot."""
    met = [
        event["balls"]
        for event in trace.events
        if event["type"] == "ball-collision" or event.get("part") == "nose"
    ]
    first = next(k for k, balls in enumerate(met) if len(balls) == 2)
    if first > 0:
        return "kick"
    last = max(k for k, balls in enumerate(met) if len(balls) == 2 and potted in balls)
    if "cue" not in met[last]:
        return "combination"
    return "bank" if [potted] in met[last:] else "pot"


def store(pots: list[State]) -> None:
    """Replaces the class ``pots`` of the stored states."""
    data = json.loads(gzip.decompress(STATES.read_bytes()))
    data["about"] = ABOUT
    data["source"] = SOURCE
    data["classes"] = {"pots": [asdict(state) for state in pots]} | {
        name: states for name, states in data["classes"].items() if name not in ("pots", "pot_shot")
    }
    STATES.write_bytes(gzip.compress(json.dumps(data).encode(), mtime=0))


if __name__ == "__main__":
    sys.exit(main())
