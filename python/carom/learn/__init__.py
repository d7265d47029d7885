"""Learning a table and its players from tracks: where a camera saw the balls over time.

tracks = carom.learn.read_tracks("match.csv.gz")
tracks["12"].balls["cue"].position      # (n, 2), m, in the table's frame
print(tracks.findings)                  # what was assumed, repaired or left out

learned = carom.learn.table(tracks)      # the physics, with intervals
carom.learn.strikes(tracks, learned)     # every shot as it was played

Parquet needs pyarrow: ``pip install 'carom[learn]'``.
"""

from carom.learn.contacts import Contact
from carom.learn.filmed_strikes import FilmedStrike, strikes
from carom.learn.findings import Finding
from carom.learn.fit_player import player, players
from carom.learn.header import FileFrame, TracksHeader
from carom.learn.learned import Posterior, table
from carom.learn.model_scores import ModelScore, compare_models
from carom.learn.player_chances import ChanceOfDraws, PlayerChances
from carom.learn.player_errors import PlayedStrike
from carom.learn.player_folder import read_players, read_strikes
from carom.learn.player_intentions import Intentions, find_intentions
from carom.learn.player_posterior import PlayerPosterior
from carom.learn.posterior import LearnedNumbers, LearnedTable
from carom.learn.quality import ShotQuality, TracksReport, check
from carom.learn.read import read_tracks
from carom.learn.recordings import cut_into_shots
from carom.learn.report_data import FitReport, ShotFit, fit_report
from carom.learn.segment import Run, Segments, segment
from carom.learn.synthetic import SyntheticTracks, TrueContact, synthetic
from carom.learn.table_model import PARAMETERS, Frame, Parameter
from carom.learn.tracks import TrackedBall, TrackedShot, Tracks
from carom.learn.write import write_tracks

__all__ = [
    "PARAMETERS",
    "ChanceOfDraws",
    "Contact",
    "FileFrame",
    "FilmedStrike",
    "Finding",
    "FitReport",
    "Frame",
    "Intentions",
    "LearnedNumbers",
    "LearnedTable",
    "ModelScore",
    "Parameter",
    "PlayedStrike",
    "PlayerChances",
    "PlayerPosterior",
    "Posterior",
    "Run",
    "Segments",
    "ShotFit",
    "ShotQuality",
    "SyntheticTracks",
    "TrackedBall",
    "TrackedShot",
    "Tracks",
    "TracksHeader",
    "TracksReport",
    "TrueContact",
    "check",
    "compare_models",
    "cut_into_shots",
    "find_intentions",
    "fit_report",
    "player",
    "players",
    "read_players",
    "read_strikes",
    "read_tracks",
    "segment",
    "strikes",
    "synthetic",
    "table",
    "write_tracks",
]
