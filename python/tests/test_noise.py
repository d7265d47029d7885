"""`Shot.vary`: reproducible variants for any threads and chunks, and their errors."""

from __future__ import annotations

import dataclasses
import json
import math
import pickle
from pathlib import Path
from typing import Any

import carom
import numpy as np
import pytest
from carom import InputError, Noise, Shot, batch

ROOT = Path(__file__).parents[2]
GOLDENS = json.loads((ROOT / "goldens" / "noise.json").read_text())
STRIKE = ("speed", "azimuth", "elevation", "side", "height")


def strikes_of(result: carom.NoisyResult) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.stack([getattr(result, name) for name in STRIKE], axis=1)


def same(a: carom.NoisyResult, b: carom.NoisyResult) -> bool:
    fields = [field.name for field in dataclasses.fields(a) if field.name != "errors"]
    equal = all(getattr(a, f).tobytes() == getattr(b, f).tobytes() for f in fields)
    return equal and a.errors == b.errors


@pytest.mark.parametrize("golden", GOLDENS, ids=[golden["shot"] for golden in GOLDENS])
def test_noise_reproduces_its_goldens_bit_by_bit(golden: dict[str, Any]) -> None:
    shot = Shot.load(ROOT / "shots" / f"{golden['shot']}.json")
    noise = Noise.olympiad(golden["olympiad"])
    variants = golden["variants"]
    result = shot.vary(noise, len(variants), seed=golden["seed"], first=golden["first"])
    assert strikes_of(result).tolist() == [variant["strike"] for variant in variants]
    assert result.events.tolist() == [variant["events"] for variant in variants]
    assert result.final_position[:, 0].tolist() == [variant["final"] for variant in variants]


def test_the_olympiads_noise_has_the_published_values() -> None:
    noise = Noise.olympiad()
    assert (noise.side_m, noise.height_m, noise.speed) == (0.0005, 0.0005, 0.075)
    assert noise.elevation == math.radians(0.1)
    assert noise.azimuth == math.radians(0.125)
    assert Noise.olympiad(2.0) == noise.scaled(2.0)
    assert noise.scaled(0) == Noise()


def test_variants_are_the_same_for_any_number_of_threads_and_chunks(
    pot: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    shot = Shot.from_dict(pot)
    whole = shot.vary(Noise.olympiad(), 300, seed=3, threads=1)
    assert same(shot.vary(Noise.olympiad(), 300, seed=3, threads=2), whole)
    monkeypatch.setattr(batch, "_FIRST_CHUNK", 7)
    assert same(shot.vary(Noise.olympiad(), 300, seed=3), whole)
    tail = shot.vary(Noise.olympiad(), 100, seed=3, first=200)
    assert strikes_of(tail).tolist() == strikes_of(whole)[200:].tolist()
    assert tail.final_position.tobytes() == whole.final_position[200:].tobytes()


def test_a_variant_is_the_shot_with_the_strike_of_its_row(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    result = shot.vary(Noise.olympiad(2.0), 50, seed=1)
    again = shot.batch(**{name: getattr(result, name) for name in STRIKE})
    assert again.final_position.tobytes() == result.final_position.tobytes()
    assert again.pocket.tolist() == result.pocket.tolist()


def test_a_drawn_strike_equals_that_of_its_variant_to_the_bit(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    noise = Noise.olympiad(2.0)
    variants = shot.vary(noise, 20, seed=3, first=7)
    drawn = [noise.draw(shot, 7 + k, seed=3) for k in range(20)]
    assert [[getattr(s, name) for name in STRIKE] for s in drawn] == strikes_of(variants).tolist()


def test_a_drawn_strike_has_the_ball_and_the_policies_of_the_shot(pot: dict[str, Any]) -> None:
    def words(**policies: str) -> tuple[str, str, str]:
        shot = Shot.from_dict({**pot, "strike": {**pot["strike"], **policies}})
        drawn = Noise.olympiad().draw(shot)
        return drawn.ball, drawn.obstruction, drawn.miscue

    ball = pot["strike"]["ball"]
    assert words() == (ball, "report", "refuse")
    assert words(obstruction="refuse", miscue="report") == (ball, "refuse", "report")


def test_drawing_from_a_shot_without_a_strike_is_refused(pot: dict[str, Any]) -> None:
    still = Shot.from_dict({key: value for key, value in pot.items() if key != "strike"})
    with pytest.raises(InputError, match="strike: the shot has no strike"):
        Noise.olympiad().draw(still)
    with pytest.raises(InputError, match="index: -1 is out of range"):
        Noise.olympiad().draw(Shot.from_dict(pot), -1)


def test_errors_of_the_offsets_are_in_metres_for_any_ball(pot: dict[str, Any]) -> None:
    pool = Shot.from_dict(pot)
    small = Shot.from_dict({**pot, "physics": {"base": "pool", "ball": {"radius": 0.02}}})
    a, b = (shot.vary(Noise(side_m=0.001), 20) for shot in (pool, small))
    assert np.allclose(a.side * pool.radius[0], b.side * small.radius[0], rtol=1e-12, atol=0)
    assert (a.height == 0).all()
    assert (a.azimuth == math.radians(90)).all()


def test_errors_differ_between_seeds_and_have_the_given_spread(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    noise = Noise(speed=0.05, azimuth=0.002)
    one, two = (shot.vary(noise, 4000, seed=seed) for seed in (1, 2))
    assert (one.speed != two.speed).all()
    # Five standard errors of a standard deviation.
    assert one.speed.std() == pytest.approx(0.05, rel=5 / math.sqrt(2 * 4000))
    assert one.azimuth.std() == pytest.approx(0.002, rel=5 / math.sqrt(2 * 4000))


def test_a_miscue_is_moved_back_to_the_limit_unless_the_shot_reports_it(
    pot: dict[str, Any],
) -> None:
    pot["strike"]["side"] = 0.51
    limit = 0.6 / math.sqrt(1 + 0.6**2)
    result = Shot.from_dict(pot).vary(Noise(side_m=0.002), 60)
    assert result.errors == {}
    assert (result.side <= 0.999 * limit + 1e-15).all()
    moved = result.side > 0.9989 * limit
    assert 5 < moved.sum() < 55
    pot["strike"]["miscue"] = "report"
    reported = Shot.from_dict(pot).vary(Noise(side_m=0.002), 60)
    assert reported.errors == {}
    assert reported.side.max() > limit
    assert (reported.side[~moved] == result.side[~moved]).all()


def test_every_door_draws_the_same_strike_to_the_bit(pot: dict[str, Any]) -> None:
    # One strike beyond each limit, and one within all.
    for changes in (
        {"side": 0.5, "height": 0.1},
        {"speed": 0.02},
        {"elevation_deg": 89.5, "side": 0.1},
        {"elevation_deg": 0.1},
        {},
    ):
        shot = Shot.from_dict({**pot, "strike": {**pot["strike"], **changes}})
        noise = Noise.preset("beginner")
        rows = strikes_of(shot.vary(noise, 40, seed=6, first=11))
        for k in range(40):
            drawn = noise.draw(shot, 11 + k, seed=6)
            assert [getattr(drawn, name) for name in STRIKE] == rows[k].tolist()
            variant = noise.variant(shot, 11 + k, seed=6).to_dict()["strike"]
            assert variant["speed"] == rows[k, 0]
            assert (variant["side"], variant["height"]) == (rows[k, 3], rows[k, 4])
        played, chances = shot.vary(noise, 51, seed=6), shot.evaluate(noise, 51, seed=6)
        stays = played.pocket[:, 0] == -1
        assert stays.sum() > 10
        ends = played.final_position[stays, 0, :2]
        assert chances.cue_ball_ends[stays].tolist() == ends.tolist()
        assert chances.failed == 0


def test_a_frame_plays_the_strike_that_the_noise_draws() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    far = carom.Strike(speed=0.05, azimuth=1.5, side=0.45, height=0.2, elevation=0.1)
    meant = frame.shot(far, cue_ball=(0.635, 0.5))
    noise = Noise.preset("beginner")
    drawn = noise.draw(meant, 4, seed=8)
    assert math.hypot(drawn.side, drawn.height) <= 0.999 * 0.6 / math.sqrt(1.36) + 1e-15
    frame.play(drawn, cue_ball=(0.635, 0.5))
    played = frame.record["moves"][0]["play"]["strike"]
    (row,) = strikes_of(meant.vary(noise, 1, seed=8, first=4))
    assert [played[name] for name in STRIKE] == row.tolist()


def test_zero_variants_and_a_single_late_one_are_possible(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    assert len(shot.vary(Noise.olympiad(), 0)) == 0
    assert len(shot.vary(Noise.olympiad(), 1, first=2**64 - 2, seed=2**64 - 1)) == 1


@pytest.mark.parametrize(
    ("values", "place"),
    [
        ({"speed": -0.1}, "noise.speed"),
        ({"azimuth": math.nan}, "noise.azimuth"),
        ({"side_m": 0.5}, "noise.side_m"),
        ({"height_m": math.inf}, "noise.height_m"),
        ({"elevation": "0.1 degrees"}, "noise.elevation"),
        ({"elevation": None}, "noise.elevation"),
    ],
)
def test_bad_noise_is_refused_with_its_place(values: dict[str, Any], place: str) -> None:
    with pytest.raises(InputError, match=rf"^{place}: .*; write"):
        Noise(**values)


def test_bad_arguments_of_vary_are_refused(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    wrong: Any = {"speed": 0.1}
    with pytest.raises(InputError, match=r"^noise: .*carom\.Noise"):
        shot.vary(wrong, 10)
    for name, value in [("n", -1), ("n", 2.5), ("seed", -1), ("seed", 2**64), ("first", True)]:
        with pytest.raises(InputError, match=rf"^{name}: .* whole number"):
            shot.vary(Noise(), **{"n": 10, name: value})
    del pot["strike"]
    with pytest.raises(InputError, match=r"^strike: .*give it one"):
        Shot.from_dict(pot).vary(Noise(), 1)


def test_a_noise_can_be_sent_to_another_process() -> None:
    assert pickle.loads(pickle.dumps(Noise.olympiad(0.5))) == Noise.olympiad(0.5)


def test_the_old_names_of_the_offsets_still_work_and_warn() -> None:
    with pytest.warns(FutureWarning, match=r"Noise\(side=\.\.\.\) is now Noise\(side_m=\.\.\.\)"):
        noise = Noise(side=0.001)  # type: ignore[call-arg]
    assert noise == Noise(side_m=0.001)
    with pytest.warns(FutureWarning, match=r"Noise\.height is now Noise\.height_m"):
        assert noise.height == 0.0  # type: ignore[attr-defined]


def test_a_variant_with_cling_is_an_ordinary_shot_with_the_bits_of_its_row() -> None:
    shot = Shot.load(ROOT / "shots" / "half_ball_cut.json")
    noise = carom.Noise(speed=0.05, cling_probability=0.5, cling_friction=0.3)
    rows = shot.vary(noise, 20, seed=4, first=10)
    clung = 0
    for k in range(20):
        variant = noise.variant(shot, 10 + k, seed=4)
        again = Shot.from_json(variant.to_json())
        ends = carom.simulate_batch([again])
        assert ends.final_position.tobytes() == rows.final_position[k : k + 1].tobytes()
        clung += 0 in variant.to_dict()["cling"]["contacts"]
    assert 0 < clung < 20
    without = shot.vary(carom.Noise(speed=0.05), 20, seed=4, first=10)
    assert np.array_equal(rows.speed, without.speed)
    assert not np.array_equal(rows.final_position, without.final_position)


def test_the_presets_have_the_friction_of_a_cling_and_no_probability() -> None:
    for noise in (carom.Noise.preset("club"), carom.Noise.olympiad(2.0), carom.Noise()):
        assert (noise.cling_probability, noise.cling_friction) == (0.0, 0.22)
    half = carom.Noise(speed=0.1, cling_probability=0.1).scaled(0.5)
    assert (half.speed, half.cling_probability, half.cling_friction) == (0.05, 0.1, 0.22)
