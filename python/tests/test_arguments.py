"""Arguments in Python: NumPy's numbers are accepted, bad values are refused by name."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import pytest
from carom import CaromError, Frame, InputError, Noise, Perception, Shot, Strike, convert, picture

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

CLUB = Noise.preset("club")
STRIKE = Strike(speed=1.0, azimuth=1.5)
# A number that no double can hold.
HUGE = 10**400


@pytest.fixture
def shot(pot: dict[str, Any]) -> Shot:
    return Shot.from_dict(pot)


def refused(place: str, call: Callable[[], object]) -> None:
    """One sentence that names the place, as a CaromError that is a ValueError."""
    with pytest.raises(InputError) as caught:
        call()
    assert isinstance(caught.value, CaromError)
    assert isinstance(caught.value, ValueError)
    sentence = str(caught.value)
    assert sentence.startswith((f"{place}: ", f"{place}[", f"{place}.")), sentence
    assert "\n" not in sentence
    assert ";" in sentence, "and the remedy"


def test_numpy_numbers_are_accepted_as_counts_and_seeds(shot: Shot) -> None:
    one, two = np.int64(1), np.uint32(2)
    counts: Any = {"n": np.int32(64), "seed": one, "threads": two}
    plain = {"n": 64, "seed": 1, "threads": 2}
    assert shot.evaluate(CLUB, **counts).to_dict() == shot.evaluate(CLUB, **plain).to_dict()
    ours, theirs = (shot.vary(CLUB, first=first, **c) for first, c in ((two, counts), (2, plain)))
    assert np.array_equal(ours.final_position, theirs.final_position, equal_nan=True)
    assert carom.break_shot(seed=one) == carom.break_shot(seed=1)
    assert Frame("nine-ball", seed=one).balls == Frame("nine-ball", seed=1).balls
    assert len(carom.simulate_batch([shot], threads=one)) == 1


def test_noise_number_and_seed_can_be_positional(shot: Shot) -> None:
    assert shot.evaluate(CLUB, 64, 5).to_dict() == shot.evaluate(CLUB, n=64, seed=5).to_dict()
    assert shot.vary(CLUB, 8, 5).speed.tolist() == shot.vary(CLUB, n=8, seed=5).speed.tolist()


def test_too_many_threads_are_reduced_to_a_possible_number(shot: Shot) -> None:
    assert len(shot.batch(speed=[1.0, 2.0], threads=10**6)) == 2


@pytest.mark.parametrize("threads", [0, -1, 1.0, "2", True])
def test_a_bad_number_of_threads_is_refused(shot: Shot, threads: Any) -> None:
    refused("threads", lambda: shot.batch(threads=threads))
    refused("threads", lambda: shot.evaluate(CLUB, 8, threads=threads))
    refused("threads", lambda: shot.solve(pot="1", threads=threads))


@pytest.mark.parametrize("shots", [None, 5])
def test_a_batch_of_something_else_than_shots_is_refused(shots: Any) -> None:
    refused("shots", lambda: carom.simulate_batch(shots))


@pytest.mark.parametrize("shots", ["", b"", {}])
def test_an_empty_string_or_dict_is_not_an_empty_batch(shots: Any) -> None:
    refused("shots", lambda: carom.simulate_batch(shots))


@pytest.mark.parametrize("speed", ["2", [True], 1j, {}, [[1.0], [1.0, 2.0]], b"2"])
def test_a_batch_with_something_else_than_numbers_is_refused(shot: Shot, speed: Any) -> None:
    refused("speed", lambda: shot.batch(speed=speed))


@pytest.mark.parametrize("seed", [-1, 2**64, 0.5, "1", None, True])
def test_a_bad_seed_is_refused(shot: Shot, seed: Any) -> None:
    refused("seed", lambda: shot.evaluate(CLUB, 8, seed=seed))
    refused("seed", lambda: shot.vary(CLUB, 8, seed=seed))
    refused("seed", lambda: shot.solve(pot="1", seed=seed))
    refused("seed", lambda: carom.break_shot(seed=seed))
    refused("seed", lambda: carom.break_statistics(racks=8, seed=seed))
    refused("seed", lambda: Frame("nine-ball", seed=seed))


@pytest.mark.parametrize(
    ("place", "value"),
    [
        ("noise", "club"),
        ("perception", 0.001),
        ("n", 2.5),
        ("precision", "0.1"),
        ("level", 1.0),
        ("watch", 5),
        ("watch", ("1",)),
        ("watch", ("1", 5)),
        ("frame", "eight-ball"),
        ("call", "safety"),
        ("call", carom.Call.safety()),
    ],
)
def test_bad_arguments_of_evaluate_are_refused(shot: Shot, place: str, value: Any) -> None:
    given: Any = {"noise": CLUB, "n": 8, "precision": 0.1, place: value}
    refused(place, lambda: shot.evaluate(**given))


@pytest.mark.parametrize(
    ("place", "value"),
    [
        ("pot", 5),
        ("pot", ("1", "left", "right")),
        ("leave", 5),
        ("leave", ((0.6, "a"), 0.1)),
        ("leave", ((0.6, 0.6, 0.6), 0.1)),
        ("speed", 2.0),
        ("speed", (1.0,)),
        ("speed", ("1", 2.0)),
        ("offset", None),
        ("wanted", 0),
        ("per_route", -1),
        ("samples", 10**30),
        ("n", 0),
    ],
)
def test_bad_arguments_of_solve_are_refused(shot: Shot, place: str, value: Any) -> None:
    given: Any = {"pot": "1", place: value}
    refused(place, lambda: shot.solve(**given))


@pytest.mark.parametrize("value", ["1", None, True, HUGE, [1.0, 2.0]])
def test_something_else_than_a_number_is_refused_by_name(value: Any) -> None:
    refused("noise.speed", lambda: Noise(speed=value))
    refused("multiplier", lambda: Noise.olympiad(value))
    refused("multiplier", lambda: CLUB.scaled(value))
    refused("perception.position", lambda: Perception(value))
    if value is not None:
        refused("speed", lambda: carom.break_shot(speed=value))
        refused("gap", lambda: carom.break_statistics(racks=8, gap=value))


@pytest.mark.parametrize("name", [5, None, "club:", "club:x"])
def test_a_bad_name_of_a_noise_is_refused(name: Any) -> None:
    refused("noise", lambda: Noise.preset(name))


@pytest.mark.parametrize("game", [5, None, ["nine-ball"]])
def test_a_bad_name_of_a_game_is_refused(game: Any) -> None:
    refused("game", lambda: carom.break_shot(game))
    refused("game", lambda: carom.break_statistics(game, 8))
    refused("game", lambda: Frame(game))
    refused("game", lambda: Frame.of_shot(game, carom.break_shot()))


@pytest.mark.parametrize(
    ("place", "value"),
    [
        ("options.points", "many"),
        ("options.points", 2**40),
        ("options.patience", -1),
        ("options.miss", "yes"),
    ],
)
def test_bad_options_of_a_frame_are_refused(place: str, value: Any) -> None:
    given: Any = {place.removeprefix("options."): value}
    refused(place, lambda: Frame("snooker", **given))


def test_a_frame_refuses_bad_arguments_and_stays_unchanged(shot: Shot) -> None:
    frame = Frame("nine-ball")
    before = frame.to_dict()
    wrong: Any
    for wrong in (5, None, {"speed": 1.0}):
        refused("strike", lambda wrong=wrong: frame.play(wrong))
    for wrong in ("fast", None, HUGE):
        refused("strike.speed", lambda wrong=wrong: frame.play(Strike(wrong, 1.0)))
    for wrong in (5, (0.6,), ("a", "b"), (0.6, 0.6, 0.6), (HUGE, 0.6)):
        refused("cue_ball", lambda wrong=wrong: frame.play(STRIKE, cue_ball=wrong))
    wrong = "safety"
    refused("call", lambda: frame.play(STRIKE, call=wrong))
    wrong = 5
    refused("call.ball", lambda: carom.Call.pocket(wrong, "left"))
    refused("choice", lambda: frame.choose(wrong))
    refused("shot", lambda: Frame.of_shot("nine-ball", wrong))
    assert frame.to_dict() == before


def test_bad_arguments_of_maps_are_refused(shot: Shot) -> None:
    wrong: Any = 5
    for call in (
        lambda: carom.pot_map(wrong, "1", "left"),
        lambda: carom.position_map(wrong, "1", "left", speed=1.0),
        lambda: carom.acceptance(wrong, "left"),
        lambda: carom.kick_table(wrong),
        lambda: carom.bank_table(wrong, "1"),
    ):
        refused("shot", call)
    refused("ball", lambda: carom.pot_map(shot, wrong, "left"))
    refused("pocket", lambda: carom.pot_map(shot, "1", wrong))
    for columns in (0, 10**6):
        refused(
            "columns", lambda columns=columns: carom.pot_map(shot, "1", "left", columns=columns)
        )
    for speed in (0.0, -1.0, math.nan):
        refused("speed", lambda speed=speed: carom.acceptance(shot, "left", speed=speed))
        refused("speed", lambda speed=speed: carom.bank_table(shot, "1", speed=speed))
    refused("cushions", lambda: carom.kick_table(shot, cushions=0))
    refused("cushions", lambda: carom.kick_table(shot, cushions=10**9))
    refused("strike.speed", lambda: carom.kick_table(shot, speed=-1.0))
    refused("level", lambda: carom.break_statistics(racks=8, level=1.0))


def test_a_position_map_of_a_billion_cells_is_refused_before_it_is_allocated(shot: Shot) -> None:
    speed, spin = np.full(10**4, 1.0), np.zeros(10**5)
    with pytest.raises(InputError, match=r"^speed, spin: 10000 × 100000 .* at most 10000000"):
        shot.position_map("1", "left", speed=speed, height=spin, side=spin)


@pytest.mark.parametrize(
    ("place", "given"),
    [
        ("speed", {"speed": -1.0}),
        ("speed", {"speed": 0.0}),
        ("speed", {"speed": 1e300}),
        ("speed", {"speed": math.nan}),
        ("speed", {"speed": []}),
        ("side, height", {"speed": 1.0, "height": 5.0}),
        ("side, height", {"speed": 1.0, "side": -0.9, "height": 0.9}),
        ("side, height", {"speed": 1.0, "side": [0.0, 0.1], "height": [0.0, 0.1, 0.2]}),
    ],
)
def test_strikes_of_a_position_map_out_of_range_are_refused(
    shot: Shot, place: str, given: dict[str, Any]
) -> None:
    refused(place, lambda: shot.position_map("1", "left", **given))


@pytest.mark.parametrize(
    ("place", "given"),
    [
        ("distance", {"distance": 1e9}),
        ("distance", {"distance": 0.0}),
        ("distance", {"distance": math.nan}),
        ("speed", {"speed": 101.0}),
        ("angle", {"angle": 4.0}),
        ("offset", {"offset": 10.0}),
        ("speed, angle, offset", {"speed": np.full(10**4, 1.0)}),
    ],
)
def test_approaches_to_a_pocket_out_of_range_are_refused(
    shot: Shot, place: str, given: dict[str, Any]
) -> None:
    refused(place, lambda: shot.acceptance("left", **given))


def test_cushion_tables_and_pot_maps_of_unbounded_cloth_are_refused(
    endless: dict[str, Any],
) -> None:
    del endless["balls"][0]["velocity"]
    endless["strike"] = {"ball": "a", "speed": 1.0, "azimuth_deg": 0.0}
    shot = Shot.from_dict(endless)
    refused("table", shot.kick_table)
    refused("table", lambda: shot.bank_table("b"))
    refused("pocket", lambda: shot.acceptance("left"))
    refused("pocket", lambda: shot.pot_map("b", "left"))


def test_break_statistics_of_nine_ball_on_a_carom_table_are_refused() -> None:
    refused("table", lambda: carom.break_statistics("nine-ball", 8, table="carom-10ft"))
    refused("table", lambda: carom.break_statistics("snooker", 8, table="carom-9ft"))
    assert carom.break_statistics("three-cushion", 8).racks == 8


@pytest.mark.parametrize("racks", [0, -1, 10**7, 2.5, None, math.nan])
def test_a_bad_number_of_racks_is_refused(racks: Any) -> None:
    refused("racks", lambda: carom.break_statistics(racks=racks))


def test_results_that_would_exhaust_the_memory_are_refused(shot: Shot) -> None:
    refused("n", lambda: shot.vary(CLUB, 10**12))
    speeds = np.broadcast_to(1.0, (10**5, 1))
    refused("shapes", lambda: shot.batch(speed=speeds, side=np.broadcast_to(0.0, (1, 10**5))))
    refused("n", lambda: shot.evaluate(CLUB, 10**10))


def test_every_question_is_a_function_and_a_method_with_the_same_arguments(shot: Shot) -> None:
    asked: dict[str, Any] = {"columns": 2, "n": 8}
    function, method = carom.pot_map(shot, "1", "left", **asked), shot.pot_map("1", "left", **asked)
    assert np.array_equal(function.chance, method.chance, equal_nan=True)
    assert carom.evaluate(shot, CLUB, 8).to_dict() == shot.evaluate(CLUB, 8).to_dict()
    for name in ("solve", "position_map", "acceptance", "kick_table", "bank_table"):
        assert getattr(Shot, name).__wrapped__ is getattr(carom, name)


def test_bad_arguments_of_pictures_and_comparisons_are_refused(shot: Shot, tmp_path: Path) -> None:
    wrong: Any = 5
    refused("found", lambda: picture.save(wrong, tmp_path / "a.svg"))
    refused("again", lambda: shot.simulate().difference(wrong))


@pytest.mark.parametrize("source", [None, 5, []])
def test_an_import_of_something_else_than_a_file_is_refused(source: Any) -> None:
    refused("source", lambda: convert.pooltool(source))
    refused("text", lambda: convert.fastfiz(source))


@pytest.mark.parametrize("strike", [5, ("a",) * 5, (0.0,) * 4])
def test_an_import_with_a_bad_strike_is_refused(strike: Any) -> None:
    state = "1 0.028575 1 0 0.40 0.60"
    refused("strike", lambda: convert.fastfiz(state, strike=strike))


@pytest.mark.parametrize("value", [-1, 1e300, None, "x", [], 2**64, True])
def test_a_chance_of_bad_counts_is_refused(value: Any) -> None:
    refused("trials", lambda: carom.Chance.of(0, value, 0.95))
    refused("count", lambda: carom.Chance.of(value, 2, 0.95))


def test_a_chance_of_more_counts_than_trials_or_a_bad_level_is_refused() -> None:
    refused("count", lambda: carom.Chance.of(3, 2, 0.95))
    level: Any
    for level in (0.0, 1.0, math.nan, "x", None):
        refused("level", lambda level=level: carom.Chance.of(1, 2, level))


@pytest.mark.parametrize("name", [None, 5, [], np.array([])])
def test_names_that_are_not_texts_are_refused(shot: Shot, name: Any) -> None:
    found = shot.evaluate(CLUB, 8)
    refused("ball", lambda: found.pot(name))
    refused("pocket", lambda: found.pocket("1", name))
    refused("kind", lambda: carom.schema(name))
