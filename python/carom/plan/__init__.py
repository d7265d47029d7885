"""Questions about shots: chances, solutions, maps, statistics of breaks, tables of cushions.

Every question about a shot is a function whose first argument is the shot, and a method of
``carom.Shot`` with the same name and the same further arguments: ``carom.pot_map(shot, "1",
"left")`` is ``shot.pot_map("1", "left")``.
"""

from carom.plan.breaks import BreakStatistics, break_statistics
from carom.plan.chance import Chance
from carom.plan.cushions import CushionTable, bank_table, kick_table
from carom.plan.drawn_tables import ListedTables, PossibleTable, TablePosterior
from carom.plan.evaluate import Evaluation, ResultCounts, evaluate
from carom.plan.maps import Acceptance, PositionMap, PotMap, acceptance, position_map, pot_map
from carom.plan.options import Sampling, Search
from carom.plan.solve import Solution, solve

__all__ = [
    "Acceptance",
    "BreakStatistics",
    "Chance",
    "CushionTable",
    "Evaluation",
    "ListedTables",
    "PositionMap",
    "PossibleTable",
    "PotMap",
    "ResultCounts",
    "Sampling",
    "Search",
    "Solution",
    "TablePosterior",
    "acceptance",
    "bank_table",
    "break_statistics",
    "evaluate",
    "kick_table",
    "position_map",
    "pot_map",
    "solve",
]
