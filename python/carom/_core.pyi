"""The extension module in Rust: conversions only. Private; the package ``carom`` is the API."""

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Literal, NoReturn, Self, final

import numpy as np
from numpy.typing import NDArray

from carom.call import PlayArguments
from carom.noise import Noise, Perception
from carom.plan.options import Goal, Sampling, Search
from carom.player.thinking import Thinking

__all__ = [
    "MOST_EVENTS",
    "MOST_SAMPLES",
    "TIP",
    "BallTracks",
    "Candidates",
    "CudaDevice",
    "Frame",
    "OpenMatch",
    "Player",
    "Shot",
    "Study",
    "Trace",
    "VectorEnv",
    "__version__",
    "acceptance",
    "accepted_puzzles",
    "adjusted_share",
    "bank_table",
    "break_presets",
    "break_shot",
    "break_statistics",
    "build",
    "check_keys",
    "check_noise",
    "check_part",
    "check_perception",
    "check_player",
    "check_record",
    "clustered",
    "dated_value",
    "default_options",
    "draw_strikes",
    "error_kinds",
    "evaluate",
    "foul_words",
    "game_facts",
    "judge",
    "judge_shot",
    "kick_table",
    "make_puzzle",
    "meanings",
    "noise_moments",
    "noise_presets",
    "normalised_elo",
    "olympiad",
    "pair_interval",
    "physics",
    "plain",
    "play_match",
    "play_pair",
    "play_rows",
    "player_entry",
    "players",
    "points",
    "position_map",
    "pot_map",
    "pots",
    "puzzle_themes",
    "quantiles",
    "read_drill",
    "read_json",
    "read_number",
    "read_puzzle",
    "read_whole",
    "repaired",
    "replay_match",
    "rolling_bands",
    "row_shot",
    "sample_states",
    "schema",
    "see",
    "simulate",
    "simulate_batch",
    "simulate_strikes",
    "simulate_to_cap",
    "simulate_variants",
    "solve",
    "spread",
    "stages",
    "start_states",
    "successors",
    "supervise",
    "tables",
    "tasks",
    "test_state",
    "track_residuals",
    "unknown_word",
    "variant",
    "wilson",
    "wrong_type",
]

__version__: str
TIP: float
MOST_EVENTS: int
MOST_SAMPLES: int

# Speed, azimuth, elevation, side, height; an elevation of None is the default one.
_Strike = tuple[float, float, float | None, float, float]

# Called with the number of the stage, the items done in it, and the number of its items.
_Report = Callable[[int, int, int], object]

# An external program: its name, the folder to which its files are relative, the executable of
# Python, the file of this module, the log, files that it must not read, and whether everything must
# be enforced.
_Program = tuple[
    str,
    PathLike[str],
    str,
    str,
    Callable[[str], object] | None,
    Sequence[PathLike[str]],
    bool,
]
# A player of a match: the name of a built-in one; name, class, and the function that begins a
# frame; or a program.
_Entrant = str | tuple[str, str, Callable[[int, int], Callable[..., Any]]] | _Program

# Position, velocity and spin, each (candidates, balls, 3).
_States = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
# Times (n), positions (n, 2), standard deviations (n).
_Observed = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]

@final
class Candidates:
    def __new__(
        cls,
        shots: Sequence[Shot],
        shot_of: NDArray[np.uint32],
        numbers: Sequence[str],
        values: NDArray[np.float64],
        states: _States | None,
        strikes: tuple[NDArray[np.float64], bool] | None,
    ) -> Candidates: ...
    def shot(self, index: int) -> Shot: ...
    def part(self, first: int, end: int) -> Candidates: ...
    def __len__(self) -> int: ...

@final
class BallTracks:
    def __new__(cls, balls: Sequence[tuple[str, _Observed]]) -> BallTracks: ...
    def counts(self, horizons: Sequence[float]) -> list[list[int]]: ...

@final
class Frame:
    def __new__(
        cls, game: str, table: object, physics: object, seed: int, options: tuple[int, bool, int]
    ) -> Frame: ...
    @staticmethod
    def recorded_setup(game: str, table: object, physics: object) -> dict[str, Any]: ...
    @staticmethod
    def of_shot(
        game: str, shot: Shot, options: tuple[int, bool, int], player: int | None
    ) -> Frame: ...
    def to_object(self) -> dict[str, Any]: ...
    def entry(self, key: str) -> Any: ...
    def shot(self, play: PlayArguments) -> Shot: ...
    def play(
        self, play: PlayArguments, noise: Noise | None, seeds: int | tuple[int, int]
    ) -> tuple[
        dict[str, Any], Trace, tuple[float, float, float, float, float], dict[str, Any] | None
    ]: ...
    def base(self) -> dict[str, Any]: ...
    def describe(self) -> str: ...
    def answer_schema(self) -> dict[str, Any]: ...
    @property
    def hand_bounds(self) -> tuple[tuple[float, float], tuple[float, float]] | None: ...
    def legal_calls(self) -> list[tuple[str, str | None, str | None]]: ...
    def legal_places(self, count: int, seed: int) -> list[list[float]]: ...
    def choose(self, choice: str) -> dict[str, Any]: ...
    def concede(self) -> dict[str, Any]: ...
    def copy(self) -> Frame: ...
    @property
    def hash(self) -> str: ...

@final
class Shot:
    @staticmethod
    def from_json(text: str, file: str | None) -> Shot: ...
    @staticmethod
    def from_object(value: object) -> Shot: ...
    def to_object(
        self, *, elevation: bool = True, dated: Literal["all", "named"] | None = None
    ) -> dict[str, Any]: ...
    def cue_pose(
        self,
    ) -> tuple[list[float], list[float], list[float], tuple[float, str] | None] | None: ...
    def strike_of_pose(
        self,
        tip: Sequence[float],
        direction: Sequence[float],
        speed: float,
        ball: str,
    ) -> tuple[float, float, float, float, float]: ...
    def to_json(self) -> str: ...
    def equals(self, other: Shot) -> bool: ...
    def geometry(self) -> dict[str, Any]: ...
    def with_strike(self, strike: _Strike) -> Shot: ...
    @property
    def until(self) -> float | None: ...
    def with_until(self, until: float | None) -> Shot: ...
    @property
    def physics_of_table(self) -> str: ...
    @property
    def has_default_elevation(self) -> bool: ...
    @property
    def ids(self) -> list[str]: ...
    @property
    def radius(self) -> list[float]: ...
    @property
    def mass(self) -> list[float]: ...
    @property
    def strike(self) -> tuple[float, float, float, float, float] | None: ...
    def __len__(self) -> int: ...

@final
class Study:
    @staticmethod
    def from_json(text: str, file: str | None) -> Study: ...
    @staticmethod
    def from_object(value: object) -> Study: ...
    def to_object(self) -> dict[str, Any]: ...
    def to_json(self) -> str: ...
    def shots(self) -> list[tuple[Shot, Shot | None]]: ...
    def check(self) -> list[dict[str, Any]]: ...

@final
class Trace:
    @staticmethod
    def from_json(text: str, file: str | None) -> Trace: ...
    @staticmethod
    def from_object(value: object) -> Trace: ...
    def to_object(self) -> dict[str, Any]: ...
    def to_json(self) -> str: ...
    def shot(self) -> Shot: ...
    def at(
        self, times: NDArray[np.float64]
    ) -> tuple[
        NDArray[np.float64],
        NDArray[np.float64],
        NDArray[np.float64],
        NDArray[np.float64],
        list[str],
    ]: ...
    def polyline(self, ball: int, tolerance: float) -> NDArray[np.float64]: ...
    def diamond_reading(self, ball: int, event: int | None) -> dict[str, Any] | None: ...
    def carom_route(self) -> dict[str, Any] | None: ...
    def first_difference(self, again: Trace) -> str | None: ...
    @property
    def duration(self) -> float: ...
    @property
    def end(self) -> str: ...
    @property
    def hash(self) -> str: ...
    def __len__(self) -> int: ...

def check_part(key: str, value: object) -> None: ...
def check_record(record: object) -> None: ...
def simulate(shot: Shot) -> Trace: ...
def simulate_to_cap(shot: Shot) -> Trace: ...

_Arrays = tuple[NDArray[np.float64], NDArray[np.int8], NDArray[np.int32], dict[int, str]]

@final
class CudaDevice:
    def __new__(cls, ordinal: int, ptx: bytes) -> Self: ...
    @property
    def name(self) -> str: ...
    @property
    def occupancy(self) -> tuple[int, int, int, int]: ...

def simulate_batch(shots: list[Shot], threads: int, device: CudaDevice | None) -> _Arrays: ...
def simulate_strikes(
    shot: Shot,
    strikes: NDArray[np.float64],
    own_elevation: bool,
    threads: int,
    device: CudaDevice | None,
) -> _Arrays: ...
def simulate_variants(
    shot: Shot,
    strikes: NDArray[np.float64],
    noise: Noise,
    perception: Perception,
    draw: tuple[int, int],
    threads: int,
    device: CudaDevice | None,
) -> _Arrays: ...
def start_states(
    shot: Shot,
) -> list[NDArray[np.float64]]: ...
def sample_states(
    candidates: Candidates,
    times: NDArray[np.float64],
    balls: Sequence[int],
    velocity: bool,
    angular_velocity: bool,
    threads: int,
) -> tuple[
    NDArray[np.float64],
    NDArray[np.float64] | None,
    NDArray[np.float64] | None,
    NDArray[np.bool_],
    dict[int, str],
]: ...
def track_residuals(
    candidates: Candidates,
    tracks: Sequence[BallTracks],
    placement: NDArray[np.float64],
    horizons: Sequence[float],
    samples: bool,
    threads: int,
) -> tuple[NDArray[np.float64] | None, NDArray[np.float64], NDArray[np.uint32], dict[int, str]]: ...
def variant(shot: Shot, noise: Noise, seed: int, index: int) -> Shot: ...
def check_perception(perception: Perception) -> None: ...
def check_noise(noise: Noise) -> None: ...
def noise_moments(noise: Noise, speed: float) -> tuple[list[float], list[float]]: ...
def draw_strikes(
    shot: Shot, noise: Noise, n: int, seed: int, first: int
) -> NDArray[np.float64]: ...
def olympiad(multiplier: float) -> list[float]: ...
def noise_presets() -> list[tuple[str, list[float]]]: ...
def evaluate(
    shot: Shot,
    sampling: Sampling,
    watch: tuple[str, str | None] | None,
    referee: tuple[Frame, tuple[str, str | None, str | None]] | None,
    tables: Sequence[Shot],
    threads: int,
    device: CudaDevice | None,
    report: _Report,
) -> dict[str, Any]: ...
def plain(value: object) -> Any: ...
def play_rows(
    rows: object, balls: int, outcomes: bool, device: CudaDevice | None
) -> dict[str, Any]: ...
def row_shot(rows: object) -> Shot: ...
def points(
    sequence: str, seed: int, index: NDArray[np.int64], dimensions: int
) -> NDArray[np.float64]: ...
def quantiles(
    distribution: str, a: list[float], b: list[float], u: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def see(shot: Shot, perception: Perception, seed: int, index: int) -> Shot: ...
def pot_map(
    shot: Shot,
    target: tuple[int, int],
    cells: tuple[int, int],
    sampling: Sampling,
    tables: Sequence[Shot],
    threads: int,
    report: _Report,
) -> tuple[
    NDArray[np.float64],
    NDArray[np.float64],
    NDArray[np.float64],
    NDArray[np.int64],
    NDArray[np.float64],
]: ...
def kick_table(
    shot: Shot,
    azimuths: list[float],
    speeds: list[float],
    sides: list[float],
    height: float,
    most: int,
    threads: int,
    report: _Report,
) -> tuple[list[str], NDArray[np.float64]]: ...
def bank_table(
    shot: Shot,
    ball: int,
    azimuths: list[float],
    speeds: list[float],
    most: int,
    threads: int,
    report: _Report,
) -> tuple[list[str], NDArray[np.float64]]: ...
def position_map(
    shot: Shot,
    target: tuple[int, int],
    speeds: list[float],
    spins: list[list[float]],
    threads: int,
    report: _Report,
) -> tuple[NDArray[np.bool_], NDArray[np.float64], NDArray[np.float64]]: ...
def acceptance(
    shot: Shot,
    pocket: int,
    speeds: list[float],
    angles: list[float],
    offsets: list[float],
    distance: float,
    threads: int,
    report: _Report,
) -> NDArray[np.int8]: ...
def break_statistics(
    game: str,
    preset: str | None,
    table: str | None,
    speed: float | None,
    gap: float | None,
    sampling: Sampling,
    threads: int,
    report: _Report,
) -> tuple[_Arrays, dict[str, Any]]: ...
def solve(
    shot: Shot,
    goal: Goal,
    search: Search,
    sampling: Sampling,
    tables: Sequence[Shot],
    threads: int,
    report: _Report,
) -> list[dict[str, Any]]: ...
def stages() -> list[str]: ...
def clustered(tables: Sequence[tuple[int, int]], level: float) -> tuple[float, float]: ...
def spread(tables: Sequence[tuple[int, int]]) -> float: ...
def wilson(hits: int, trials: int, level: float) -> tuple[float, float]: ...
def break_presets() -> list[dict[str, Any]]: ...
def repaired(
    file: object, tolerance: float
) -> tuple[dict[str, Any], list[tuple[str, list[float]]]]: ...
def break_shot(
    game: str,
    preset: str | None,
    table: str | None,
    speed: float | None,
    seed: int,
    gap: float | None,
) -> Shot: ...
def default_options() -> dict[str, Any]: ...
def game_facts() -> list[dict[str, Any]]: ...
def rolling_bands(
    law: tuple[float, float], tolerance: tuple[float, float, float], gravity: float
) -> Any: ...
def build() -> dict[str, Any]: ...
def physics() -> list[dict[str, Any]]: ...
def tables() -> list[dict[str, Any]]: ...
def error_kinds() -> list[tuple[str, str, list[str]]]: ...
def judge(trace: Trace, goal: object) -> dict[str, Any]: ...
def schema(kind: str) -> str: ...

@final
class Player:
    def __new__(cls, name: str) -> Player: ...
    @property
    def name(self) -> str: ...
    @property
    def noise(self) -> tuple[float, ...] | None: ...
    @property
    def simulations(self) -> int | None: ...
    def stop(self) -> None: ...
    def choose(self, frame: Frame, thinking: Thinking, threads: int) -> dict[str, Any]: ...
    def explain(
        self, frame: Frame, thinking: Thinking, plays: int, threads: int
    ) -> dict[str, Any]: ...

def players() -> list[str]: ...
def successors(
    frame: Frame,
    play: PlayArguments,
    noise: Noise,
    perception: Perception,
    seed: int,
    first: int,
    n: int,
    threads: int,
) -> list[tuple[Frame, dict[str, Any], list[float]]]: ...
def pots(
    frame: Frame,
    noise: Noise,
    perception: Perception,
    seed: int,
    cue_ball: Sequence[float] | None,
    each: int,
    n: int,
    threads: int,
) -> list[dict[str, Any]]: ...
def play_match(
    players: Sequence[_Entrant],
    agreed: object,
    secret: str | None,
    folder: PathLike[str],
    level: float,
    threads: int,
    report: _Report,
    interrupt: Callable[[], None],
) -> dict[str, Any]: ...
def play_pair(
    players: Sequence[_Entrant],
    agreed: object,
    secret: str,
    number: int,
    report: _Report,
    interrupt: Callable[[], None],
) -> tuple[str, str]: ...

@final
class OpenMatch:
    def __new__(
        cls,
        players: Sequence[_Entrant],
        agreed: object,
        secret: str | None,
        folder: PathLike[str],
    ) -> OpenMatch: ...
    @property
    def secret(self) -> str: ...
    @property
    def played(self) -> int: ...
    def next_pair(self) -> int | None: ...
    def add(self, number: int, lines: Sequence[str]) -> None: ...
    def close(self, level: float) -> dict[str, Any]: ...

def player_entry(name: str, folder: PathLike[str]) -> dict[str, Any]: ...
def test_state(
    counts: Sequence[int], p0: float, p1: float, alpha: float, beta: float, unit: str
) -> dict[str, Any]: ...
def adjusted_share(pairs: list[tuple[float, float]], level: float) -> dict[str, Any]: ...
def check_player(player: _Entrant, seconds: float, report: _Report) -> list[dict[str, Any]]: ...
def normalised_elo(counts: list[int], share: float) -> float: ...
def pair_interval(counts: list[int], level: float) -> tuple[float, float]: ...
def supervise() -> None: ...
def replay_match(
    text: str, luck: int | None, level: float, threads: int, report: _Report
) -> dict[str, Any]: ...

@final
class VectorEnv:
    def __new__(cls, task: str, n: int, settings: dict[str, Any]) -> VectorEnv: ...
    def reset(
        self,
        seeds: list[int] | None,
        mask: NDArray[np.bool_] | None,
        starts: Sequence[Shot | Frame | None],
        opponent: Callable[[Any], Any] | None,
    ) -> NDArray[np.float32]: ...
    def step(
        self, actions: NDArray[np.float32], opponent: Callable[[Any], Any] | None
    ) -> dict[str, Any]: ...
    def step_one(
        self, action: NDArray[np.float32], opponent: Callable[[Any], Any] | None
    ) -> tuple[
        NDArray[np.float32],
        float,
        bool,
        bool,
        int,
        bool,
        int,
        int,
        tuple[float, float, float, float, float] | None,
        int,
        str | None,
    ]: ...
    def close(self) -> None: ...
    def state(self, attachment: bytes) -> bytes: ...
    def set_state(self, state: bytes) -> bytes: ...
    def copy(self) -> VectorEnv: ...
    def copies(self, index: int, n: int, seeds: list[int] | None, threads: int) -> VectorEnv: ...
    def play(self, index: int, action: NDArray[np.float32]) -> dict[str, Any] | None: ...
    def frame(self, index: int) -> Frame | None: ...
    def shot(self, index: int) -> Shot: ...
    def observe_start(self, index: int, start: Shot | Frame) -> NDArray[np.float32]: ...
    def shots(self, index: int) -> list[Shot]: ...
    def observe(self, index: int, viewer: int) -> NDArray[np.float32]: ...
    def observations(self) -> NDArray[np.float32]: ...
    def player(self, index: int) -> int | None: ...
    def players(self) -> NDArray[np.int8]: ...
    def seats(self) -> NDArray[np.int8]: ...
    def drawn(self) -> NDArray[np.float64]: ...
    def presets(self) -> dict[str, Any]: ...
    def picture(self, index: int) -> dict[str, Any]: ...
    @property
    def autoreset_mode(self) -> str: ...
    @property
    def action_size(self) -> int: ...
    @property
    def observation_bounds(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]: ...

def read_json(text: str, file: str | None) -> Any: ...
def dated_value(path: str, value: object) -> Any: ...
def check_keys(value: object, place: str, known: Sequence[str]) -> None: ...
def read_number(value: object, place: str) -> float: ...
def read_whole(value: object, place: str, low: int, high: int) -> int: ...
def wrong_type(value: object, place: str, wanted: str) -> NoReturn: ...
def unknown_word(word: str, place: str, kind: str, known: Sequence[str]) -> NoReturn: ...
def make_puzzle(theme: str, number: int) -> dict[str, Any] | str: ...
def read_puzzle(name: str) -> dict[str, Any]: ...
def accepted_puzzles() -> list[tuple[str, int, int]]: ...
def puzzle_themes() -> list[str]: ...
def read_drill(text: str, file: str | None) -> dict[str, Any]: ...
def judge_shot(shot: Shot, goal: object, left: Sequence[str]) -> dict[str, Any]: ...
def tasks() -> list[str]: ...
def foul_words() -> list[str]: ...
def meanings() -> tuple[list[str], list[str], list[str]]: ...
