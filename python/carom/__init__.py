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

from carom import notebook
from carom._core import __version__
from carom.arena import MatchReplay, MatchResult, play_match, replay_match
from carom.batch import BatchResult, simulate_batch
from carom.build import CuePose, Layout, MovedBall, Physics, Repaired, Strike, Table
from carom.call import Call
from carom.candidates import Candidates
from carom.carom_route import CaromRoute, DiamondReading
from carom.cloth import rolling_bands
from carom.drills import Drill, DrillStep, DrillVerdict, Puzzle, puzzle, puzzles
from carom.errors import (
    AngleWarning,
    CaromError,
    EndlessMotionError,
    EventCapError,
    InputError,
    PageError,
)
from carom.installed import build_info
from carom.noise import Noise, NoisyResult, Perception
from carom.plan import (
    Acceptance,
    BreakStatistics,
    Chance,
    CushionTable,
    Evaluation,
    PositionMap,
    PotMap,
    Solution,
    acceptance,
    bank_table,
    break_statistics,
    evaluate,
    kick_table,
    position_map,
    pot_map,
    solve,
)
from carom.player import (
    Analysis,
    Decision,
    Leave,
    Play,
    Player,
    PotPlay,
    Recommendation,
    Situation,
    Successor,
    players,
    pots,
    successors,
)
from carom.racks import break_presets, break_shot
from carom.reference import game_facts, physics, rule_sets, schema, tables
from carom.rules import Frame, LegalAnswers, Ruling
from carom.shot import Shot
from carom.study import Chapter, Study
from carom.trace import Snapshot, Trace
from carom.tracks import (
    BallTracks,
    SampledStates,
    TrackResiduals,
    sample_batch,
    track_residuals,
)

if TYPE_CHECKING:
    from carom import bench as bench
    from carom import convert as convert
    from carom import learn as learn
    from carom import page as page
    from carom import picture as picture
    from carom import serve as serve
    from carom.robot_frame import CueCommand, RobotFrame
    from carom.sweeps import Sweep, sweep

__all__ = [
    "Acceptance",
    "Analysis",
    "AngleWarning",
    "BallTracks",
    "BatchResult",
    "BreakStatistics",
    "Call",
    "Candidates",
    "CaromError",
    "CaromRoute",
    "Chance",
    "Chapter",
    "CueCommand",
    "CuePose",
    "CushionTable",
    "Decision",
    "DiamondReading",
    "Drill",
    "DrillStep",
    "DrillVerdict",
    "EndlessMotionError",
    "Evaluation",
    "EventCapError",
    "Frame",
    "InputError",
    "Layout",
    "Leave",
    "LegalAnswers",
    "MatchReplay",
    "MatchResult",
    "MovedBall",
    "Noise",
    "NoisyResult",
    "PageError",
    "Perception",
    "Physics",
    "Play",
    "Player",
    "PositionMap",
    "PotMap",
    "PotPlay",
    "Puzzle",
    "Recommendation",
    "Repaired",
    "RobotFrame",
    "Ruling",
    "SampledStates",
    "Shot",
    "Situation",
    "Snapshot",
    "Solution",
    "Strike",
    "Study",
    "Successor",
    "Sweep",
    "Table",
    "Trace",
    "TrackResiduals",
    "__version__",
    "acceptance",
    "bank_table",
    "break_presets",
    "break_shot",
    "break_statistics",
    "build_info",
    "evaluate",
    "game_facts",
    "kick_table",
    "physics",
    "play_match",
    "players",
    "position_map",
    "pot_map",
    "pots",
    "puzzle",
    "puzzles",
    "replay_match",
    "rolling_bands",
    "rule_sets",
    "sample_batch",
    "schema",
    "simulate_batch",
    "solve",
    "successors",
    "sweep",
    "tables",
    "track_residuals",
]


def _png_of(found: object, dots_per_inch: int) -> bytes:
    png: bytes = import_module("carom.picture.save").png_of(found, dots_per_inch)
    return png


notebook._drawn["png"] = _png_of

# Modules that few programs use; they are imported when they are first used.
_LAZY_MODULES = {"bench", "convert", "learn", "page", "picture", "serve"}
_LAZY_NAMES = {
    "CueCommand": "carom.robot_frame",
    "RobotFrame": "carom.robot_frame",
    "Sweep": "carom.sweeps",
    "sweep": "carom.sweeps",
}


def __getattr__(name: str) -> object:
    if name in _LAZY_MODULES:
        return import_module(f"carom.{name}")
    if name in _LAZY_NAMES:
        return getattr(import_module(_LAZY_NAMES[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_LAZY_MODULES, *_LAZY_NAMES})
