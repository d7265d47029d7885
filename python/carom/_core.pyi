"""The extension module in Rust: conversions only. Private; the package ``carom`` is the API."""

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, NoReturn, final

import numpy as np
from numpy.typing import NDArray

from carom.call import PlayArguments
from carom.env.settings import Settings
from carom.noise import Noise, Perception
from carom.plan.options import Goal, Sampling, Search
from carom.player.thinking import Thinking

__all__ = [
    "TIP",
    "Frame",
    "Player",
    "Shot",
    "Trace",
    "VectorEnv",
    "__version__",
    "acceptance",
    "bank_table",
    "break_presets",
    "break_shot",
    "break_statistics",
    "check_keys",
    "check_noise",
    "check_perception",
    "dated_value",
    "draw_strikes",
    "evaluate",
    "games",
    "kick_table",
    "meanings",
    "noise_presets",
    "olympiad",
    "pair_interval",
    "physics",
    "plain",
    "play_match",
    "play_rows",
    "players",
    "points",
    "position_map",
    "pot_map",
    "quantiles",
    "read_json",
    "read_number",
    "read_whole",
    "replay_match",
    "rolling_bands",
    "row_shot",
    "rule_sets",
    "schema",
    "see",
    "simulate",
    "simulate_batch",
    "simulate_strikes",
    "simulate_to_cap",
    "simulate_variants",
    "solve",
    "stages",
    "tables",
    "tasks",
    "unknown_word",
    "variant",
    "wilson",
    "wrong_type",
]

__version__: str
TIP: float

# Speed, azimuth, elevation, side, height; an elevation of None is the default one.
_Strike = tuple[float, float, float | None, float, float]

# Called with the number of the stage, the items done in it, and the number of its items.
_Report = Callable[[int, int, int], object]

@final
class Frame:
    def __new__(
        cls, game: str, table: object, physics: object, seed: int, options: tuple[int, bool, int]
    ) -> Frame: ...
    @staticmethod
    def recorded_setup(game: str, table: object, physics: object) -> dict[str, Any]: ...
    @staticmethod
    def of_shot(game: str, shot: Shot, options: tuple[int, bool, int]) -> Frame: ...
    def to_object(self) -> dict[str, Any]: ...
    def shot(self, play: PlayArguments) -> Shot: ...
    def play(
        self, play: PlayArguments, noise: Noise | None, seed: int
    ) -> tuple[
        dict[str, Any], Trace, tuple[float, float, float, float, float], dict[str, Any] | None
    ]: ...
    def choose(self, choice: str) -> dict[str, Any]: ...
    def concede(self) -> dict[str, Any]: ...
    def copy(self) -> Frame: ...

@final
class Shot:
    @staticmethod
    def from_json(text: str, file: str | None) -> Shot: ...
    @staticmethod
    def from_object(value: object) -> Shot: ...
    def to_object(self) -> dict[str, Any]: ...
    def to_json(self) -> str: ...
    def geometry(self) -> dict[str, Any]: ...
    def to_record(self) -> dict[str, Any]: ...
    def to_source(self) -> dict[str, Any]: ...
    def to_record_source(self) -> dict[str, Any]: ...
    def to_dated_source(self) -> dict[str, Any]: ...
    def with_strike(self, strike: _Strike) -> Shot: ...
    @property
    def until(self) -> float | None: ...
    def with_until(self, until: float | None) -> Shot: ...
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
    def first_difference(self, again: Trace) -> str | None: ...
    @property
    def duration(self) -> float: ...
    @property
    def end(self) -> str: ...
    @property
    def hash(self) -> str: ...
    def __len__(self) -> int: ...

def simulate(shot: Shot) -> Trace: ...
def simulate_to_cap(shot: Shot) -> Trace: ...

_Arrays = tuple[NDArray[np.float64], NDArray[np.int8], NDArray[np.int32], dict[int, str]]

def simulate_batch(shots: list[Shot], threads: int) -> _Arrays: ...
def simulate_strikes(
    shot: Shot, strikes: NDArray[np.float64], own_elevation: bool, threads: int
) -> _Arrays: ...
def simulate_variants(
    shot: Shot,
    strikes: NDArray[np.float64],
    noise: Noise,
    perception: Perception,
    draw: tuple[int, int],
    threads: int,
) -> _Arrays: ...
def variant(shot: Shot, noise: Noise, seed: int, index: int) -> Shot: ...
def check_perception(perception: Perception) -> None: ...
def check_noise(noise: Noise) -> None: ...
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
    threads: int,
    report: _Report,
) -> dict[str, Any]: ...
def plain(value: object) -> Any: ...
def play_rows(rows: object, balls: int, outcomes: bool) -> dict[str, Any]: ...
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
    threads: int,
    report: _Report,
) -> list[dict[str, Any]]: ...
def stages() -> list[str]: ...
def wilson(hits: int, trials: int, level: float) -> tuple[float, float]: ...
def break_presets() -> list[dict[str, Any]]: ...
def break_shot(
    game: str,
    preset: str | None,
    table: str | None,
    speed: float | None,
    seed: int,
    gap: float | None,
) -> Shot: ...
def games() -> list[str]: ...
def rolling_bands(
    law: tuple[float, float], tolerance: tuple[float, float, float], gravity: float
) -> Any: ...
def physics() -> list[dict[str, Any]]: ...
def tables() -> list[dict[str, Any]]: ...
def schema(kind: str) -> str: ...
def rule_sets() -> list[str]: ...

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
def play_match(
    players: tuple[str, str],
    agreed: object,
    secret: str | None,
    folder: PathLike[str],
    level: float,
    threads: int,
    report: _Report,
) -> dict[str, Any]: ...
def pair_interval(counts: list[int], level: float) -> tuple[float, float]: ...
def replay_match(text: str, level: float, threads: int, report: _Report) -> dict[str, Any]: ...

@final
class VectorEnv:
    def __new__(cls, task: str, n: int, settings: Settings) -> VectorEnv: ...
    def reset(
        self, seeds: list[int] | None, mask: NDArray[np.bool_] | None
    ) -> NDArray[np.float32]: ...
    def step(self, actions: NDArray[np.float32]) -> dict[str, Any]: ...
    def observe(self, index: int, viewer: int) -> NDArray[np.float32]: ...
    def player(self, index: int) -> int | None: ...
    def presets(self) -> dict[str, Any]: ...
    def picture(self, index: int) -> dict[str, Any]: ...
    def __deepcopy__(self, _memo: object) -> VectorEnv: ...
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
def tasks() -> list[str]: ...
def meanings() -> tuple[list[str], list[str], list[str]]: ...
