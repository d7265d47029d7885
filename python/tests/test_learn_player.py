"""A player's errors are found again from strikes that were played with them."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import jsonschema
import numpy as np
import pytest
from carom import learn
from carom.errors import InputError
from carom.learn.player_errors import NUMBERS, SCALE, vector_of
from test_stored_results import load

if TYPE_CHECKING:
    from conftest import CommandLine

bench: Any = load("benches/player_match.py")

SIGMA = np.array((0.05, math.radians(0.2), math.radians(0.7), 0.001, 0.0015))
DRILL = carom.Shot(
    "wpa-9ft",
    {"cue": (0.6, 0.6), "1": (0.9, 1.7)},
    carom.Strike(2.0, math.atan2(1.1, 0.3), elevation=math.radians(5.0), height=0.1),
)


def strikes(
    count: int, error: float, seed: int, name: str = "", share: float = 1.0
) -> list[learn.PlayedStrike]:
    """A drill of a player with a share of SIGMA; the error of measurement is in σ."""
    random = np.random.default_rng(seed)
    sigma = share * SIGMA
    centre, spread = vector_of(DRILL), error * sigma
    moves = random.standard_normal((count, 5)) * sigma + random.standard_normal((count, 5)) * spread
    return [
        learn.PlayedStrike(f"{name}{i}", DRILL, centre + move, np.diag(spread**2))
        for i, move in enumerate(moves)
    ]


def test_intervals_of_a_drill_cover_the_truth_as_often_as_they_say() -> None:
    """20 players, 20 strikes each, measured with an error as large as the player's.

    Of 100 independent intervals of 90 %, 80 to 98 cover the truth with a probability of 99.8 %.
    """
    played, by_shot = [], {}
    for player in range(20):
        own = strikes(20, 1.0, player, f"{player}-")
        played += own
        by_shot |= {strike.name: str(player) for strike in own}
    found = learn.players(played, DRILL, by_shot, pooled=False, draws=200)
    covered = 0
    for one in found.values():
        for name, true in zip(NUMBERS, SIGMA, strict=True):
            low, high = one.interval(name)
            covered += low < true < high
    assert 80 <= covered <= 98


def test_the_error_of_measurement_is_not_taken_for_the_players() -> None:
    played = strikes(60, 2.0, 3)
    found = learn.player(played, DRILL, draws=400)
    raw = np.std([strike.vector for strike in played], axis=0)
    assert (np.median(found.sigma, axis=0) < 0.8 * raw).all()
    assert found.measured == pytest.approx(2.0 * SIGMA, rel=1e-6)


def test_correlations_of_the_errors_are_found() -> None:
    random = np.random.default_rng(5)
    correlation = np.eye(5)
    correlation[1, 3] = correlation[3, 1] = 0.8
    root = np.linalg.cholesky(correlation) * 1.0
    moves = random.standard_normal((150, 5)) @ root.T * SIGMA
    played = [
        learn.PlayedStrike(str(i), DRILL, vector_of(DRILL) + move, np.zeros((5, 5)))
        for i, move in enumerate(moves)
    ]
    covariance = np.array(learn.player(played, DRILL, draws=400).noise.covariance)
    found = covariance[1, 3] / math.sqrt(covariance[1, 1] * covariance[3, 3])
    assert found == pytest.approx(0.8, abs=0.12)


def test_a_player_with_few_strikes_is_taken_to_be_as_good_as_the_others() -> None:
    played = strikes(3, 0.1, 1, "new-", 0.2)
    alone = learn.player(played, DRILL, draws=400)
    by_shot = {strike.name: "new" for strike in played}
    for other in range(8):
        own = strikes(20, 0.1, 10 + other, f"{other}-", 0.2)
        played += own
        by_shot |= {strike.name: str(other) for strike in own}
    among = learn.players(played, DRILL, by_shot, draws=400)["new"]
    assert all(among.interval(name)[1] < alone.interval(name)[1] for name in NUMBERS)


def test_a_strike_that_was_not_measured_as_its_samples_say_is_left_out() -> None:
    played = strikes(40, 0.1, 2)
    wrong = [
        learn.PlayedStrike(f"wrong {i}", DRILL, strike.vector + 0.5, strike.covariance)
        for i, strike in enumerate(played[:3])
    ]
    found = learn.player(played + wrong, DRILL, draws=400)
    low, high = found.interval("azimuth")
    assert low < SIGMA[1] < high
    assert 0.03 < found.background < 0.2


def test_samples_of_a_strike_become_its_error_of_measurement() -> None:
    random = np.random.default_rng(0)
    spread = np.array((0.003, 0.04, 0.02, 0.03, 0.01, 0.001))
    strike = DRILL.strike
    assert strike is not None
    centre = np.array((strike.azimuth - 2.0 * math.pi, 2.0, 0.0, 0.1, math.radians(5.0), 0.3))
    samples = centre + random.standard_normal((4000, 6)) * spread
    found = learn.PlayedStrike.of_samples("1", DRILL, samples)
    radius = float(DRILL.radius[0])
    wanted = (0.02, 0.003, 0.01, 0.02 * radius, 0.03 * radius)
    assert np.sqrt(np.diag(found.covariance)) == pytest.approx(wanted, rel=0.06)
    assert found.vector == pytest.approx(vector_of(DRILL), abs=0.002)


def test_a_noise_belongs_to_an_intended_speed() -> None:
    found = learn.player(strikes(30, 0.1, 4), DRILL, draws=100)
    slow, fast = found.at(1.0).noise, found.at(4.0).noise
    assert fast.deviations()[0] == pytest.approx(4.0 * slow.deviations()[0])
    assert fast.deviations()[1:] == pytest.approx(slow.deviations()[1:])


def test_a_player_is_read_as_it_was_written_and_is_a_noise_of_the_command_line(
    tmp_path: Path, run: CommandLine
) -> None:
    found = learn.player(strikes(20, 0.1, 6), DRILL, draws=100)
    path, drill = tmp_path / "player.json", tmp_path / "shot.json"
    found.save(path)
    DRILL.save(drill)
    again = learn.PlayerPosterior.load(path)
    assert again.interval("side") == pytest.approx(found.interval("side"), rel=1e-5)
    done = run("evaluate", str(drill), "--noise", str(path), "-n", "50", "--json")
    assert json.loads(done.stdout)["noise"] == found.noise.to_dict()


@pytest.fixture(scope="module")
def player_file() -> dict[str, Any]:
    """The file of a player with unknown intentions, which has all keys."""
    found = learn.player(aimed_shots(3, 0.005, 2), draws=20)
    assert len(found.choices) == 6
    file: dict[str, Any] = json.loads(found.to_json())
    return file


def test_the_file_of_a_player_and_its_schema_agree(player_file: dict[str, Any]) -> None:
    schema = carom.schema("player")
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(player_file)
    assert set(player_file) == set(schema["properties"])
    assert player_file["engine"] == f"carom {carom.__version__}"
    again = learn.PlayerPosterior.from_dict(player_file).to_dict()
    # The noise is computed again from draws that were rounded to six digits.
    noise, written = again.pop("noise"), player_file["noise"]
    assert again == {key: value for key, value in player_file.items() if key != "noise"}
    for key in ("covariance", "bias"):
        np.testing.assert_allclose(noise[key], written[key], rtol=1e-3, atol=1e-8)


def test_a_file_of_an_older_or_a_newer_engine_is_read(player_file: dict[str, Any]) -> None:
    found = learn.PlayerPosterior.from_dict(player_file)
    older = {key: value for key, value in player_file.items() if key != "engine"}
    for file in (older, player_file | {"hand": "left"}):
        assert learn.PlayerPosterior.from_dict(file).to_dict() == found.to_dict()


BROKEN: dict[str, tuple[dict[str, Any], str]] = {
    "another format": ({"format": "carom-shot/1"}, "format"),
    "no name": ({"name": None}, "name"),
    "no strikes": ({"shots": 0}, "shots"),
    "a speed of zero": ({"speed": 0.0}, "speed"),
    "a text for a speed": ({"speed": "3 m/s"}, "speed"),
    "no draws": ({"draws": {}}, "draws.bias"),
    "draws that are a list": ({"draws": []}, "draws"),
    "an empty list of draws": ({"draws": {"bias": [], "covariance": []}}, "draws.bias"),
    "rows of four": ({"draws": {"bias": [[0] * 4], "covariance": [[1] * 15]}}, "draws.bias"),
    "rows of texts": ({"draws": {"bias": [["0"] * 5], "covariance": [[1] * 15]}}, "draws.bias"),
    "four deviations": ({"measured": [0.1] * 4}, "measured"),
    "a negative deviation": ({"measured": [0.1, 0.1, 0.1, 0.1, -0.1]}, "measured"),
    "a share above 1": ({"background": 1.5}, "background"),
    "a choice without sigma": ({"choices": [{"name": "all"}]}, "choices[0].sigma"),
    "a choice of one sigma": (
        {"choices": [{"name": "all", "sigma": [[1, 2, 3]]}]},
        "choices[0].sigma",
    ),
    "a noise without its covariance": ({"noise": {"covariance": [[1.0]]}}, "noise.covariance[0]"),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_damaged_file_of_a_player_is_refused_at_its_place(
    what: str, player_file: dict[str, Any], tmp_path: Path
) -> None:
    change, place = BROKEN[what]
    broken = player_file | change
    assert not jsonschema.Draft202012Validator(carom.schema("player")).is_valid(broken)
    path = tmp_path / "player.json"
    path.write_text(json.dumps(broken), encoding="utf-8")
    with pytest.raises(InputError) as refused:
        learn.PlayerPosterior.load(path)
    assert refused.value.place == f"{path}: {place}"
    assert refused.value.remedy


def test_what_a_schema_cannot_tell_of_a_player_is_refused(player_file: dict[str, Any]) -> None:
    for draws, words in (
        ({"bias": [[0] * 5] * 2, "covariance": [[1] * 15]}, "do not fit"),
        ({"bias": [[0] * 5], "covariance": [[-1.0] * 15]}, "not positive definite"),
        ({"bias": [[math.inf] * 5], "covariance": [[1] * 15]}, "not finite"),
    ):
        with pytest.raises(InputError, match=words):
            learn.PlayerPosterior.from_dict(player_file | {"draws": draws})
    for key in carom.schema("player")["required"]:
        with pytest.raises(InputError) as refused:
            learn.PlayerPosterior.from_dict({k: v for k, v in player_file.items() if k != key})
        assert refused.value.place == key


def test_a_file_without_a_noise_is_refused_by_the_command_line(
    player_file: dict[str, Any], tmp_path: Path, run: CommandLine
) -> None:
    path, drill = tmp_path / "player.json", tmp_path / "shot.json"
    DRILL.save(drill)
    without = {key: value for key, value in player_file.items() if key != "noise"}
    for text, words in (
        (drill.read_text(encoding="utf-8"), "'carom-shot/1' has no noise"),
        (json.dumps(without), "noise: the key is missing"),
        ("{", f"{path}"),
    ):
        path.write_text(text, encoding="utf-8")
        done = run("evaluate", str(drill), "--noise", str(path), "-n", "50")
        assert done.returncode == 2
        assert str(path) in done.stderr
        assert words in done.stderr


def test_chances_include_what_is_not_known_of_the_player() -> None:
    few = learn.player(strikes(6, 0.1, 7), DRILL, draws=200)
    many = learn.player(strikes(100, 0.1, 7), DRILL, draws=200)
    ball = {"cue": (0.6, 0.6), "1": (0.9, 1.7)}
    shot = carom.Shot("wpa-9ft", ball, DRILL.strike)
    wide = few.evaluate(shot, 200, draws=30)["1 falls"].interval
    narrow = many.evaluate(shot, 200, draws=30)["1 falls"].interval
    assert wide[1] - wide[0] > narrow[1] - narrow[0]
    assert few.evaluate(shot, 50, draws=2)["nothing"].mean == 0.0


def test_too_few_strikes_and_missing_intentions_are_named() -> None:
    with pytest.raises(InputError, match="at least two strikes"):
        learn.player(strikes(1, 0.1, 0), DRILL)
    with pytest.raises(InputError, match="shot 1 has no intention"):
        learn.player(strikes(3, 0.1, 0), {"0": DRILL})
    with pytest.raises(InputError, match="two are called"):
        learn.player(strikes(2, 0.1, 0) * 2, DRILL)
    with pytest.raises(InputError, match="not finite"):
        learn.PlayedStrike("7", DRILL, vector_of(DRILL), np.full((5, 5), np.nan))
    with pytest.raises(InputError, match="not positive semidefinite"):
        learn.PlayedStrike("7", DRILL, vector_of(DRILL), -np.eye(5))
    with pytest.raises(InputError, match="at least 12 rows"):
        learn.PlayedStrike.of_samples("7", DRILL, np.zeros((3, 6)))


def aimed_shots(count: int, sigma: float, seed: int) -> list[carom.Shot]:
    """Strikes of a player who aims at the middle of the azimuths that pot a ball.

    Speed and tip offset are intended at random, and the estimate does not know them.
    """
    random = np.random.default_rng(seed)
    shots: list[carom.Shot] = []
    while len(shots) < count:
        ball = random.uniform((0.3, 1.4), (0.97, 2.2))
        cue = random.uniform((0.2, 0.3), (1.07, 0.9))
        aim = math.atan2(*(ball - cue)[::-1])
        strike = carom.Strike(
            random.uniform(1.5, 3.0), aim, height=random.uniform(-0.2, 0.2), elevation=0.05
        )
        shot = carom.Shot("wpa-9ft", {"cue": cue.tolist(), "1": ball.tolist()}, strike)
        middle = bench.middle_of_window(shot, aim)
        if middle is None:
            continue
        played = middle + random.normal(0.0, sigma)
        shots.append(shot.with_strike(azimuth=float(played)))
    return shots


def test_the_aim_of_a_match_is_found_without_intentions() -> None:
    """The azimuth's σ lies in its interval; the report says what a match does not tell."""
    sigma = math.radians(0.4)
    found = learn.player(aimed_shots(16, sigma, 1), draws=100)
    low, high = found.interval("azimuth")
    assert low < sigma < high
    assert found.information[0] < 5.0 < found.information[1]
    words = found.summary()
    assert "speed: these strikes say as much as" in words
    assert "what the player is taken to intend" in words
    assert {choice.name for choice in found.choices} >= {
        "all intentions",
        "the nearest intention only",
        "aims anywhere in the window",
    }


def test_the_middle_of_a_window_is_an_intention() -> None:
    (shot,) = aimed_shots(1, 0.0, 3)
    found = learn.find_intentions(learn.PlayedStrike.exact("1", shot))
    strike = shot.strike
    assert strike is not None
    nearest = found.nearest(vector_of(shot))
    assert nearest.vectors[0, 1] == pytest.approx(strike.azimuth, abs=math.radians(0.15))


def test_a_strike_that_scores_nowhere_has_no_intention() -> None:
    shot = carom.Shot(
        "wpa-9ft", {"cue": (0.6, 0.6), "1": (0.9, 1.7)}, carom.Strike(1.0, -math.pi / 2.0)
    )
    found = learn.find_intentions(learn.PlayedStrike.exact("1", shot))
    assert found.weights.tolist() == [1e-12]
    with pytest.raises(InputError, match="there is no 'win'"):
        learn.find_intentions(learn.PlayedStrike.exact("1", shot), goal="win")


def test_three_cushions_are_a_goal_on_a_table_without_pockets() -> None:
    layout = {"1": (0.5, 0.6), "2": (0.9, 2.2), "3": (0.3, 1.8)}
    base = carom.Shot("carom-10ft", layout, {"ball": "1", "speed": 3.0, "azimuth": 0.0})
    frame = carom.Frame.of_shot(
        "three-cushion",
        carom.Shot(
            "carom-10ft",
            dict(zip(("cue", "yellow", "red"), layout.values(), strict=True)),
            carom.Strike(3.0, 0.0),
        ),
    )
    scoring = [
        angle
        for angle in np.radians(np.arange(0.0, 360.0, 1.5))
        if frame.copy().play(carom.Strike(3.0, float(angle))).points[0]
    ]
    found = [
        learn.find_intentions(learn.PlayedStrike.exact("1", base.with_strike(azimuth=float(angle))))
        for angle in scoring[:4]
    ]
    assert any(one.windows.any() for one in found)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Strikes as `carom learn strikes` writes them, with samples."""
    place = tmp_path / "strikes"
    place.mkdir()
    random = np.random.default_rng(0)
    rows = []
    noise = carom.Noise(speed=0.1, azimuth=0.003, elevation=0.01, side_m=0.001, height_m=0.001)
    for index in range(6):
        shot = noise.variant(DRILL, index)
        strike = shot.strike
        assert strike is not None
        assert strike.elevation is not None
        shot.save(place / f"{index:04}.json")
        centre = (strike.azimuth, strike.speed, strike.side, strike.height, strike.elevation, 0.3)
        samples = np.array(centre) + random.standard_normal((40, 6)) * 1e-3
        rows.append({"name": str(index), "file": f"{index:04}.json", "samples": samples.tolist()})
    file = {"format": "carom-strikes/1", "strikes": rows}
    (place / "strikes.json").write_text(json.dumps(file), encoding="utf-8")
    return place


def test_the_command_writes_a_player(folder: Path, tmp_path: Path, run: CommandLine) -> None:
    out, drill = tmp_path / "player.json", tmp_path / "drill.json"
    DRILL.save(drill)
    common = ["--intention", str(drill), "--draws", "50"]
    done = run("learn", "player", str(folder), *common, "-o", str(out))
    assert "6 strikes" in done.stdout
    assert learn.PlayerPosterior.load(out).shots == 6


def test_the_command_writes_every_player_of_a_file(
    folder: Path, tmp_path: Path, run: CommandLine
) -> None:
    drill, names, out = tmp_path / "drill.json", tmp_path / "players.csv", tmp_path / "players"
    DRILL.save(drill)
    names.write_text("shot,player\n0,Ann\n1,Ann\n2,Ann\n3,Bob\n4,Bob\n5,Bob\n", encoding="utf-8")
    common = ["--intention", str(drill), "--players", str(names), "--draws", "50"]
    assert run("learn", "player", str(folder), *common, "-o", str(out)).returncode == 0
    found = [learn.PlayerPosterior.load(file) for file in sorted(out.glob("*.json"))]
    assert [one.name for one in found] == ["Ann", "Bob"]


def test_a_folder_without_samples_is_refused_unless_its_strikes_are_exact(folder: Path) -> None:
    (folder / "strikes.json").unlink()
    with pytest.raises(InputError, match="errors of measurement are unknown"):
        learn.read_strikes(folder)
    assert len(learn.read_strikes(folder, exact=True)) == 6
    assert SCALE[0] == 0.2
