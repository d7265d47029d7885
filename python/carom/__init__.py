"""carom — the billiards engine: exact, deterministic, and fast enough to think with.

    import carom

    shot = carom.Shot.load("shot.json")
    trace = shot.simulate()
    print(trace)                       # a table of its events
    trace.at(0.25).position            # (n_balls, 3), m, exact at any time
    result = shot.batch(speed=[1.0, 2.0, 3.0])

SI units and radians; the origin is the bottom left corner of the playing area, x along the
table's width, y along its length, z up from the slate.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from carom._core import __version__
from carom.batch import BatchResult, simulate_batch
from carom.build import Layout, Physics, Strike, Table
from carom.cushions import CushionTable, bank_table, kick_table
from carom.errors import CaromError, EventCapError, InputError, PageError
from carom.maps import (
    Acceptance,
    BreakStatistics,
    PositionMap,
    PotMap,
    acceptance,
    break_statistics,
    position_map,
    pot_map,
)
from carom.noise import Noise, NoisyResult, Perception
from carom.plan import Chance, Evaluation
from carom.racks import break_shot
from carom.reference import schema, tables
from carom.rules import Call, Frame, Ruling, rule_sets
from carom.shot import Shot
from carom.solve import Solution
from carom.trace import Snapshot, Trace

if TYPE_CHECKING:
    from carom.sweeps import Sweep, sweep

__all__ = [
    "Acceptance",
    "BatchResult",
    "BreakStatistics",
    "Call",
    "CaromError",
    "Chance",
    "CushionTable",
    "Evaluation",
    "EventCapError",
    "Frame",
    "InputError",
    "Layout",
    "Noise",
    "NoisyResult",
    "PageError",
    "Perception",
    "Physics",
    "PositionMap",
    "PotMap",
    "Ruling",
    "Shot",
    "Snapshot",
    "Solution",
    "Strike",
    "Sweep",
    "Table",
    "Trace",
    "__version__",
    "acceptance",
    "bank_table",
    "break_shot",
    "break_statistics",
    "kick_table",
    "position_map",
    "pot_map",
    "rule_sets",
    "schema",
    "simulate_batch",
    "sweep",
    "tables",
]


def _svg(trace: Trace) -> str:
    # Matplotlib takes half a second to load.
    from carom.picture import svg

    return svg(trace)


Trace._svg = _svg


def __getattr__(name: str) -> object:
    # Sweeps take half as long to import as all the rest, and few programs use them.
    if name in {"Sweep", "sweep"}:
        return getattr(import_module("carom.sweeps"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
