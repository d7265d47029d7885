"""`Shot.evaluate`: counts of the variants, intervals, and when to stop."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import pytest
from carom import InputError, Noise, Shot
from carom.picture import evaluation as picture

if TYPE_CHECKING:
    from conftest import CommandLine

SHOTS = Path(__file__).parents[2] / "shots"
CLUB = Noise.preset("club")


@pytest.fixture(scope="module")
def cut() -> Shot:
    return Shot.load(SHOTS / "side_pocket_cut.json")


def test_an_evaluation_counts_the_variants_of_the_same_seed(cut: Shot) -> None:
    found = cut.evaluate(CLUB, 3000, seed=5)
    ends = cut.vary(CLUB, 3000, seed=5)
    for pocket in range(len(found.pockets)):
        assert (found.potted[:, pocket] == (ends.pocket == pocket).sum(axis=0)).all()
    assert (found.off_table == (ends.pocket == -2).sum(axis=0)).all()
    rest = ends.pocket[:, 0] == -1
    assert found.cue_ball_ends[rest].tolist() == ends.final_position[rest, 0, :2].tolist()
    assert found.at_rest[0] == rest.sum()
    lain = ends.final_position[rest, 0, :2]
    assert np.allclose(found.end_mean[0], lain.mean(axis=0), rtol=0, atol=1e-12)
    assert np.allclose(found.end_covariance[0], np.cov(lain.T), rtol=0, atol=1e-12)


def test_an_evaluation_is_the_same_for_any_number_of_threads(cut: Shot) -> None:
    one, two = (cut.evaluate(CLUB, 2000, threads=threads) for threads in (1, 2))
    assert one.to_dict() == two.to_dict()
    assert one.cue_ball_ends.tobytes() == two.cue_ball_ends.tobytes()


def test_chances_add_up(cut: Shot) -> None:
    found = cut.evaluate(CLUB, 2000)
    assert found.pot("1").count == sum(found.pocket("1", p).count for p in found.pockets)
    chance = found.pocket("1", "right")
    assert 0 <= chance.low <= chance.probability <= chance.high <= 1
    assert float(chance) == chance.probability == chance.count / 2000


def test_sampling_stops_at_the_wanted_precision(cut: Shot) -> None:
    noise = Noise.preset("casual")
    found = cut.evaluate(noise, 10**6, precision=0.01, watch=("1", "right"))
    assert found.pocket("1", "right").half_width <= 0.01
    assert 1024 < found.n < 10**6
    again = cut.evaluate(noise, found.n)
    assert again.to_dict() == found.to_dict()


def test_a_better_player_pots_more(cut: Shot) -> None:
    levels = ("beginner", "casual", "club", "advanced", "professional")
    chances = [cut.evaluate(Noise.preset(level), 2000).pot("1").probability for level in levels]
    assert chances == sorted(chances)
    assert chances[0] < 0.8 < chances[-1]


def test_a_frame_decides_what_is_legal() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    strike = carom.Strike(speed=9.0, azimuth=np.pi / 2)
    shot = frame.shot(strike, cue_ball=(0.635, 0.5))
    found = shot.evaluate(CLUB, 300, frame=frame)
    assert found.legal is not None
    assert found.turn_kept is not None
    assert found.legal.count >= found.turn_kept.count > 0
    assert "legal" in str(found)
    with pytest.raises(InputError, match="frame: "):
        shot.evaluate(CLUB, 300, frame=carom.Frame("nine-ball", seed=4))


def test_a_frame_can_continue_from_the_balls_of_a_shot() -> None:
    balls = {"9": (0.3, 2.0), "cue": (0.5, 1.2), "5": (0.9, 1.9)}
    shot = carom.Shot("wpa-9ft", balls, carom.Strike(2.0, np.radians(60)))
    frame = carom.Frame.of_shot("nine-ball", shot)
    assert frame.player == 0
    assert frame.balls == balls
    asked = frame.shot(carom.Strike(2.0, np.radians(60)))
    found = asked.evaluate(CLUB, 500, frame=frame)
    # The 5 is the lowest ball: a shot that hits it first and drives a ball to a rail is legal.
    assert found.legal is not None
    assert found.legal.probability > 0.9
    assert found.turn_kept is not None
    assert found.turn_kept.count == found.pot("5").count - found.scratch.count
    for wrong, place in (
        ({"cue": (0.5, 1.2), "5": (0.9, 1.9)}, "places: "),
        ({"cue": (0.5, 1.2), "9": (0.9, 1.9), "12": (0.3, 0.3)}, "balls"),
    ):
        with pytest.raises(InputError, match=place):
            carom.Frame.of_shot("nine-ball", carom.Shot("wpa-9ft", wrong))


def test_the_command_counts_legal_shots(run: CommandLine, tmp_path: Path) -> None:
    balls = {"8": (0.3, 2.0), "cue": (0.5, 1.2), "5": (0.9, 1.9)}
    file = tmp_path / "shot.json"
    carom.Shot("wpa-9ft", balls, carom.Strike(2.0, np.radians(60))).save(file)
    ask = ("evaluate", str(file), "-n", "300", "--game", "eight-ball", "--json")
    done = run(*ask, "--call", "5:top-right", "--watch", "legal", "--precision", "0.2")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["legal"] > 250
    assert "turn kept" in found["chances"]
    silent = run(*ask)
    assert silent.returncode == 2
    assert silent.stderr.startswith("carom: call: ")


def test_the_command_keeps_policies_cling_and_event_cap_of_a_shot_in_a_game(
    run: CommandLine, tmp_path: Path
) -> None:
    balls = {"cue": (0.5, 0.04), "9": (0.9, 1.9)}
    strike = {"ball": "cue", "speed": 2.0, "azimuth_deg": 60, "elevation_deg": 0, "side": 0.55}
    file = tmp_path / "shot.json"

    def ask(shot: carom.Shot, *more: str) -> tuple[int, str]:
        shot.save(file)
        done = run("evaluate", str(file), "-n", "20", "--game", "nine-ball", *more)
        return done.returncode, done.stdout if done.returncode == 0 else done.stderr

    def shot(**keys: Any) -> carom.Shot:
        base = carom.Shot("wpa-9ft", balls, {**strike, "miscue": "report"})
        file = base.to_dict()
        file["strike"] |= keys.pop("strike", {})
        return carom.Shot.from_dict(file | keys)

    code, printed = ask(shot(), "--json")
    assert code == 0, printed
    assert json.loads(printed)["failed"] == 0
    # Every variant is above the cap of one event.
    code, printed = ask(shot(max_events=1), "--json")
    assert code == 0, printed
    assert json.loads(printed)["failed"] == 20
    # The intended cue just clears the rail, and half of the variants are lower.
    least = shot(strike={"side": 0.0}).simulate().outcome.least_elevation_deg
    clear = {"side": 0.0, "elevation_deg": least + 0.01, "obstruction": "refuse"}
    code, printed = ask(shot(strike=clear), "--noise", "olympiad:10", "--json")
    assert code == 0, printed
    assert "the cue would pass" in json.loads(printed)["first_failure"]


def test_noise_presets_accept_a_multiplier() -> None:
    assert Noise.preset("olympiad:0.5") == Noise.olympiad(0.5)
    for wrong in ("grandmaster", "club:much"):
        with pytest.raises(InputError, match="noise: "):
            Noise.preset(wrong)


@pytest.mark.parametrize(
    ("given", "place"),
    [
        ({"n": -1}, "n: "),
        ({"seed": 2**64}, "seed: "),
        ({"level": 0}, "level: "),
        ({"level": "high"}, "level: "),
        ({"precision": 0.7}, "precision: "),
        ({"precision": 0.1, "watch": "99"}, "watch: "),
        ({"precision": 0.1, "watch": ("1", "cellar")}, "watch: "),
        ({"precision": 0.1, "watch": "legal"}, "watch: "),
        ({"watch": "scratch"}, "watch: "),
        ({"noise": 1.0}, "noise: "),
        ({"perception": 0.002}, "perception: "),
        ({"threads": 0}, "threads: "),
    ],
)
def test_bad_arguments_are_refused_by_name(cut: Shot, given: dict[str, Any], place: str) -> None:
    with pytest.raises(InputError, match=f"^{place}"):
        cut.evaluate(**({"noise": CLUB} | given))


def test_perceived_positions_differ_slightly_from_the_true_ones(cut: Shot) -> None:
    sight = carom.Perception(position=0.003)
    true = cut.simulate().at(0.0).position
    off = np.array([sight.see(cut, k).simulate().at(0.0).position - true for k in range(200)])
    assert np.std(off[:, :, :2]) == pytest.approx(0.003, rel=0.1)
    assert (off[:, :, 2] == 0).all()
    assert sight.see(cut, 5) == sight.see(cut, 5) != sight.see(cut, 5, seed=1)
    for wrong in (-0.1, float("nan"), "near"):
        with pytest.raises(InputError, match=r"^perception\.position: "):
            carom.Perception(wrong).see(cut)  # type: ignore[arg-type]


def test_errors_of_perception_lower_the_chance_of_a_pot(cut: Shot) -> None:
    sights = [carom.Perception(position) for position in (0.0, 0.001, 0.004)]
    made = [cut.evaluate(CLUB, 2000, perception=sight).pot("1").count for sight in sights]
    assert made[0] > made[1] > made[2]
    assert made[0] == cut.evaluate(CLUB, 2000).pot("1").count


def test_an_evaluation_with_perception_counts_the_variants_of_vary(cut: Shot) -> None:
    sight = carom.Perception(0.003)
    found = cut.evaluate(CLUB, 1500, perception=sight, seed=5)
    ends = cut.vary(CLUB, 1500, perception=sight, seed=5)
    for pocket in range(len(found.pockets)):
        assert (found.potted[:, pocket] == (ends.pocket == pocket).sum(axis=0)).all()
    later = cut.vary(CLUB, 500, perception=sight, seed=5, first=1000)
    assert later.final_position.tobytes() == ends.final_position[1000:].tobytes()
    one = cut.evaluate(CLUB, 1500, perception=sight, seed=5, threads=1)
    assert one.to_dict() == found.to_dict()
    assert found.to_dict()["perception"] == {"position": 0.003}


def test_a_frame_does_not_change_the_counts() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    shot = frame.shot(carom.Strike(speed=9.0, azimuth=np.pi / 2), cue_ball=(0.635, 0.5))
    for sight in (None, carom.Perception(0.001)):
        alone = shot.evaluate(CLUB, 200, perception=sight)
        ruled = shot.evaluate(CLUB, 200, perception=sight, frame=frame)
        assert alone.potted.tolist() == ruled.potted.tolist()
        assert alone.end_mean.tobytes() == ruled.end_mean.tobytes()


def test_unknown_balls_and_pockets_are_refused(cut: Shot) -> None:
    found = cut.evaluate(CLUB, 10)
    for ask in (lambda: found.pot("7"), lambda: found.pocket("1", "cellar")):
        with pytest.raises(InputError, match="there is no"):
            ask()


def test_the_command_prints_the_table_and_json(run: CommandLine, tmp_path: Path) -> None:
    file = str(SHOTS / "side_pocket_cut.json")
    done = run("evaluate", file, "--noise", "club", "-n", "500")
    assert done.returncode == 0
    assert "1 into right" in done.stdout
    drawn = tmp_path / "chances.svg"
    done = run("evaluate", file, "--noise", "club", "-n", "500", "--json", "--svg", str(drawn))
    found = json.loads(done.stdout)
    assert found == Shot.load(file).evaluate(CLUB, 500).to_dict()
    text = drawn.read_text()
    for part in ("heat", "ellipse", "fan-0-cue"):
        assert f'id="{part}"' in text
    sight = ("--perception", "0.003")
    done = run("evaluate", file, "--noise", "club", "-n", "500", *sight, "--json")
    seen = Shot.load(file).evaluate(CLUB, 500, perception=carom.Perception(0.003))
    assert json.loads(done.stdout) == seen.to_dict()
    refused = run("evaluate", file, "--precision", "0.01", "--watch", "1:cellar")
    assert refused.returncode == 2
    assert "cellar" in refused.stderr


def test_the_picture_is_the_same_each_time(cut: Shot) -> None:
    found = cut.evaluate(CLUB, 100)
    assert picture.svg(found) == picture.svg(found)
