"""Questions that are asked of all tables that may be the true one."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import pytest
from carom import InputError, Noise, Shot
from carom.learn import Posterior
from carom.learn.table_model import TableModel
from carom.plan import ListedTables

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from conftest import CommandLine

FRICTION = "rolling.a"
CLUB = Noise.preset("club")
EXACT = Noise.preset("olympiad").scaled(0.2)
# A slow pot: only on a fast cloth does the ball reach the pocket.
BALLS = {"cue": (0.5, 1.2), "9": (0.9, 1.9)}
NEVER = carom.Strike(0.5, math.radians(57))
CAROM_BALLS = {"cue": (0.864, 0.801), "yellow": (0.149, 0.143), "red": (1.076, 2.473)}


def posterior(
    steps: float, *names: str, table: str = "wpa-9ft", correlated: bool = False
) -> Posterior:
    """What is known about a table whose numbers have this standard deviation, in steps."""
    model = TableModel(table, None, names or (FRICTION,))
    size = model.steps * steps
    covariance = np.outer(size, size) if correlated else np.diag(size**2)
    return Posterior(model, model.start, covariance, 30)


def on_mean(shot: Shot, known: Posterior) -> Shot:
    return Shot(known.table, shot.balls, shot.strike, physics=known.physics)


@pytest.fixture(scope="module")
def slow() -> Shot:
    shot = Shot("wpa-9ft", BALLS, NEVER)
    found = on_mean(shot, posterior(0)).solve(
        pot=("9", "top-right"), noise=EXACT, wanted=1, n=64, speed=(0.78, 0.79), samples=0
    )
    return shot.with_strike(speed=found[0].speed, azimuth=found[0].azimuth)


@dataclass
class Tables:
    """Known tables without carom.learn: each draw is the next of a list."""

    table: Mapping[str, Any]
    physics: Mapping[str, Any]
    drawn: list[Tables]

    def draw(self, count: int, seed: int = 0, /) -> list[Tables]:
        return [self.drawn[(index + seed) % len(self.drawn)] for index in range(count)]


def of_length(*lengths: float) -> Tables:
    physics = {"base": "pool"}
    drawn = [Tables({"base": "wpa-9ft", "length": length}, physics, []) for length in lengths]
    return Tables({"base": "wpa-9ft"}, physics, drawn)


def test_a_posterior_without_uncertainty_gives_the_plain_result_to_the_bit(slow: Shot) -> None:
    known = posterior(0.0)
    mean = on_mean(slow, known)
    plain, drawn = mean.evaluate(CLUB, 2000), slow.evaluate(CLUB, 2000, posterior=known)
    assert drawn.shot == mean
    assert not drawn.by_table
    assert drawn.to_dict() == plain.to_dict()
    assert drawn.cue_ball_ends.tobytes() == plain.cue_ball_ends.tobytes()
    settings: dict[str, Any] = {"pot": "9", "n": 100, "samples": 128, "wanted": 3}
    assert slow.solve(**settings, posterior=known) == mean.solve(**settings)
    maps = [
        slow.pot_map("9", "top-right", columns=4, n=40, posterior=known),
        mean.pot_map("9", "top-right", columns=4, n=40),
    ]
    for name in ("chance", "low", "high", "n", "azimuth"):
        first, second = (getattr(found, name) for found in maps)
        assert first.tobytes() == second.tobytes()


def test_a_wider_posterior_gives_wider_intervals_and_shares_that_differ(slow: Shot) -> None:
    found = [slow.evaluate(EXACT, 3200, posterior=posterior(steps)) for steps in (1.0, 8.0, 30.0)]
    pots = [each.pot("9") for each in found]
    assert pots[0].half_width < pots[1].half_width < pots[2].half_width
    assert pots[0].spread < pots[1].spread < pots[2].spread
    widest = pots[2]
    assert len(widest.shares) == 32
    assert min(widest.shares) < 0.1
    assert max(widest.shares) > 0.9
    assert widest.count == sum(int(table.potted[1].sum()) for table in found[2].by_table)
    assert "32 drawn tables" in str(found[2])
    assert found[2].to_dict()["tables"] == 32
    plain = slow.evaluate(EXACT, 3200).pot("9")
    assert math.isnan(plain.spread)
    assert widest.half_width > 5 * plain.half_width


def test_the_spread_is_that_of_the_tables_without_the_noise_of_counting() -> None:
    rng = np.random.default_rng(1)
    alike = carom.Chance.over_tables([(int(c), 50) for c in rng.binomial(50, 0.4, 900)], 0.95)
    assert alike.spread < 0.02
    shares = np.clip(rng.normal(0.5, 0.1, 900), 0, 1)
    differ = carom.Chance.over_tables([(int(c), 50) for c in rng.binomial(50, shares)], 0.95)
    assert differ.spread == pytest.approx(0.1, abs=0.01)


def test_the_drawn_tables_are_the_same_for_any_number_of_threads(slow: Shot) -> None:
    known = posterior(10.0, FRICTION, "cushion.restitution.a")
    one, two = (
        slow.evaluate(CLUB, 640, seed=3, posterior=known, threads=threads) for threads in (1, 2)
    )
    assert one.to_dict() == two.to_dict()
    assert one.cue_ball_ends.tobytes() == two.cue_ball_ends.tobytes()
    assert one.pot("9").by_table == two.pot("9").by_table
    other = slow.evaluate(CLUB, 640, seed=4, posterior=known)
    assert other.pot("9").by_table != one.pot("9").by_table


def test_solutions_and_maps_count_over_the_tables(slow: Shot) -> None:
    known = posterior(30.0)
    settings: dict[str, Any] = {"pot": ("9", "top-right"), "noise": EXACT, "n": 320, "samples": 0}
    soft = slow.solve(**settings, speed=(0.78, 0.79), posterior=known)[0]
    hard = slow.solve(**settings, speed=(2.0, 2.1), posterior=known)[0]
    assert soft.chance.spread > 0.2
    assert hard.chance.spread < 0.05
    assert hard.chance.half_width < soft.chance.half_width
    assert soft.to_dict()["spread"] == soft.chance.spread
    wide, plain = (
        slow.pot_map("9", "top-right", noise=EXACT, columns=5, n=96, posterior=each)
        for each in (known, None)
    )
    counted = wide.n > 0
    assert np.nanmax((wide.high - wide.low) - (plain.high - plain.low)) > 0.2
    assert ((wide.low <= wide.chance) & (wide.chance <= wide.high))[counted].all()


def test_any_object_with_draws_will_do_and_a_ball_at_a_cushion_is_moved_by_millimetres() -> None:
    radius = 0.028575
    frozen = Shot(
        "wpa-9ft", {"cue": (0.6, 1.0), "1": (0.6, 2.54 - radius)}, carom.Strike(2.0, math.pi / 2)
    )
    found = frozen.evaluate(CLUB, 64, posterior=of_length(2.54, 2.538), draws=2)
    assert found.failed == 0
    assert [table.n for table in found.by_table] == [32, 32]
    with pytest.raises(InputError, match=r"draws\[1\]: balls\[1\].position: .*tolerance of 5e-3"):
        frozen.evaluate(CLUB, 64, posterior=of_length(2.54, 2.53), draws=2)
    # A draw that contradicts the place of a ball is left out while most remain.
    found = frozen.evaluate(CLUB, 64, posterior=of_length(2.54, 2.53, 2.541, 2.539), draws=4)
    assert [table.n for table in found.by_table] == [22, 21, 21]


def test_a_place_of_the_map_without_room_on_a_drawn_table_has_no_chance() -> None:
    shot = Shot("wpa-9ft", BALLS, carom.Strike(2.0, 1.0))
    tables = of_length(2.54, 2.51)
    mean, drawn = (
        shot.pot_map("9", "top-right", columns=21, n=8, posterior=each, draws=2)
        for each in (None, tables)
    )
    # The topmost row, away from the pockets.
    assert not np.isnan(mean.chance[-1, 3:-3]).any()
    assert np.isnan(drawn.chance[-1, 3:-3]).all()
    assert not np.isnan(drawn.chance[-2, 3:-3]).any()


def test_a_frame_rules_on_the_drawn_tables(slow: Shot) -> None:
    known = posterior(30.0)
    mean = on_mean(slow, known)
    frame = carom.Frame.of_shot("nine-ball", mean)
    asked = frame.shot(mean.strike)
    found = asked.evaluate(EXACT, 640, frame=frame, posterior=known)
    assert found.turn_kept is not None
    assert found.turn_kept.spread > 0.2
    assert found.turn_kept.count == pytest.approx(found.pot("9").count, rel=0.1)
    elsewhere = carom.Frame.of_shot("nine-ball", slow)
    with pytest.raises(InputError, match="frame: its table and physics are not those"):
        elsewhere.shot(slow.strike).evaluate(EXACT, 640, frame=elsewhere, posterior=known)


def test_bad_questions_are_refused_by_name(slow: Shot) -> None:
    known = posterior(5.0)
    for settings, place in (
        ({"posterior": {"table": "wpa-9ft"}}, "posterior: found dict"),
        ({"posterior": known, "draws": 1}, "draws: 1 is out of range"),
        ({"posterior": known, "draws": 1001}, "draws: 1001 is out of range"),
        ({"posterior": known, "n": 20}, "n: 20 variants are fewer than 32 drawn tables"),
    ):
        with pytest.raises(InputError, match=place):
            slow.evaluate(CLUB, **{"n": 100, **settings})
        with pytest.raises(InputError, match=place):
            slow.solve(pot="9", **{"n": 100, **settings})
        with pytest.raises(InputError, match=place):
            slow.pot_map("9", "top-right", columns=2, **{"n": 100, **settings})
    found = slow.evaluate(CLUB, 320, posterior=known)
    with pytest.raises(InputError, match="count: the interval needs the number on each"):
        found.chance(5)
    assert found.chance(lambda counts: counts.failed).count == 0


def test_a_player_ranks_its_plays_over_the_tables() -> None:
    known = posterior(12.0, FRICTION, "cushion.restitution.a", table="carom-10ft")
    shot = Shot("carom-10ft", CAROM_BALLS, carom.Strike(2.0, 1.0, ball="cue"))
    player = carom.Player(noise=Noise.preset("professional"), simulations=3000)
    found = player.explain(shot, 3, game="three-cushion", posterior=known)
    assert len(found.plays) == 3
    best = found.best
    assert best is not None
    assert len(best.kept.by_table) == 32
    assert best.kept.spread > 0.02
    assert best.leave.count > 0
    mean = on_mean(shot, known)
    decided = player.choose(mean, game="three-cushion", posterior=known)
    assert decided.play == best.play
    assert decided.win_chance == best.win_chance
    # The best play of a search that takes the learned table for the true one is made less often.
    plain = player.explain(mean, 1, game="three-cushion").best
    assert plain is not None

    def made(play: carom.Recommendation) -> float:
        found_again = play.shot.evaluate(
            player.noise,
            4096,
            7,
            frame=found.frame,
            call=play.play.call,
            posterior=known,
            draws=256,
        )
        assert found_again.turn_kept is not None
        return float(found_again.turn_kept)

    assert made(plain) < float(plain.kept) - 0.2
    assert made(best) > made(plain) + 0.05
    assert made(best) == pytest.approx(float(best.kept), abs=0.15)
    frame = carom.Frame.of_shot("three-cushion", shot)
    with pytest.raises(InputError, match="frame: "):
        player.choose(frame, posterior=known)


def test_the_commands_take_what_was_learned(slow: Shot, run: CommandLine, tmp_path: Path) -> None:
    learned, file = tmp_path / "learned.json", tmp_path / "shot.json"
    posterior(30.0).save(learned)
    slow.save(file)
    ask = ("--learned", str(learned), "--noise", "olympiad:0.2", "--json")
    done = run("evaluate", str(file), "-n", "640", "--game", "nine-ball", *ask)
    assert done.returncode == 0, done.stderr
    evaluated = json.loads(done.stdout)
    assert evaluated["tables"] == 32
    assert evaluated["chances"]["turn kept"]["spread"] > 0.2
    done = run("solve", str(file), "--pot", "9:top-right", "-n", "64", "--draws", "8", *ask)
    assert done.returncode == 0, done.stderr
    assert "spread" in json.loads(done.stdout)[0]
    aim = ("--ball", "9", "--pocket", "top-right", "--columns", "3", "-n", "32", *ask)
    done = run("map", "pot", str(file), *aim)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["n"][2][1] == 32
    think = ("think", str(file), "--game", "nine-ball", "--simulations", "500")
    done = run(*think, *ask)
    assert done.returncode == 0, done.stderr
    assert "spread" in json.loads(done.stdout)["plays"][0]["kept"]
    for words, text in (
        (("--learned", str(file)), "shot.json: format: it is 'carom-shot/1'"),
        (("--learned", str(tmp_path / "none.json")), "none.json"),
        (("--learned", str(learned), "--draws", "1"), "--draws"),
        (("--learned", str(learned), "-n", "20"), "n: 20 variants are fewer than 32"),
    ):
        done = run("evaluate", str(file), *words)
        assert done.returncode == 2
        assert text in done.stderr


def test_the_tables_of_a_file_are_draws_and_taken_in_turn(slow: Shot, tmp_path: Path) -> None:
    known = posterior(8.0)
    known.save(tmp_path / "learned.json", draws=7)
    file = json.loads((tmp_path / "learned.json").read_text(encoding="utf-8"))
    drawn = [{"table": one.table, "physics": one.physics} for one in known.draw(7)]
    assert file["draws"] == drawn
    assert Posterior.load(tmp_path / "learned.json").mean.tolist() == known.mean.tolist()
    listed = ListedTables.from_dict(file)
    # The second question of three tables has those behind the first one's, around the list.
    found = [drawn.index({"table": t.table, "physics": t.physics}) for t in listed.draw(3, 2)]
    assert found == [6, 0, 1]
    # Seed 0 draws the tables from the beginning, as the posterior does.
    both = [slow.evaluate(CLUB, 700, posterior=one, draws=7) for one in (known, listed)]
    assert both[0].to_dict() == both[1].to_dict()
    assert len(json.loads(known.to_json())["draws"]) == 96


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"draws": None}, "^draws: it is not a list"),
        ({"draws": [{}]}, r"^draws\[0\]: it has no table and physics"),
        ({"table": ...}, "^table: the key is missing"),
    ],
)
def test_a_file_without_drawn_tables_is_refused(change: dict[str, Any], words: str) -> None:
    file = {**posterior(8.0).to_dict(draws=3), **change}
    with pytest.raises(InputError, match=words):
        ListedTables.from_dict({key: value for key, value in file.items() if value is not ...})


def test_more_draws_than_a_file_has_are_refused(slow: Shot) -> None:
    listed = ListedTables.from_dict(posterior(8.0).to_dict(draws=3))
    with pytest.raises(InputError, match=r"4 tables are more than the 3 .*draws="):
        slow.evaluate(CLUB, 100, posterior=listed, draws=4)
    with pytest.raises(InputError, match="draws"):
        posterior(8.0).to_dict(draws=3001)
