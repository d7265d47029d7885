"""`carom sweep`: each row is a function of the spec and the row's number."""

from __future__ import annotations

import copy
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import carom
import numpy as np
import pyarrow as pa
import pytest
from carom import InputError, Sweep
from carom.sweeps.columns import OUTCOMES
from scipy import special, stats

# Probability that a correct generator fails a test of its distribution.
SIGNIFICANCE = 1e-4

Spec = dict[str, Any]


# Rows.


def test_a_row_equals_the_shot_file_with_the_values_of_the_row(spec: Spec) -> None:
    sweep = Sweep.from_dict({**spec, "columns": [*OUTCOMES]})
    table = sweep.table()
    assert len(table) == len(sweep) == 2 * 5 * 2 * 10
    for row in table.to_pylist()[::13]:
        file = copy.deepcopy(spec["shots"][row["layout"]])
        file["strike"] |= {"speed": row["speed"], "azimuth_deg": row["azimuth_deg"]}
        friction = row["physics_cloth_sliding_friction"]
        file["physics"] = {"base": file["physics"], "cloth": {"sliding_friction": friction}}
        shot = carom.Shot.from_dict(file)
        trace = shot.simulate()
        outcome = trace.outcome
        balls = len(shot.ids)
        end = trace.at(trace.duration).position
        ends = np.array([row["end_x"], row["end_y"], row["end_z"]], dtype=float).T
        assert (ends[:balls] == end).all()
        assert np.isnan(ends[balls:]).all()
        assert (row["cue_end_x"], row["cue_end_y"]) == tuple(end[0, :2])
        assert row["events"] == len(trace.events)
        assert row["duration"] == trace.duration
        assert row["first_contact"] == outcome["first_contact"]
        assert row["scratch"] == outcome["cue_ball_scratched"]
        names = [pocket["name"] for pocket in shot.geometry()["pockets"]]
        fallen = {ball: names.index(pocket) for ball, pocket in outcome["pocketed"]}
        assert row["pocket"][:balls] == [fallen.get(ball, -1) for ball in shot.ids]
        assert row["rails_before_contact"] == len(outcome["rails_before_first_contact"])
        touches = outcome["rails_after_first_contact"].values()
        assert row["rails_after_contact"] == sum(map(len, touches))
        assert row["driven_to_rail"] == len(outcome["driven_to_rail"])
        assert row["error"] is None


def test_the_shot_of_a_row_ends_as_the_row_does(spec: Spec) -> None:
    sweep = Sweep.from_dict(spec)
    for row in sweep.table().to_pylist()[::17]:
        shot = sweep.shot(row["row"])
        trace = shot.simulate()
        assert len(trace.events) == row["events"]
        end = trace.at(trace.duration).position[:, :2]
        ends = np.array([row["end_x"], row["end_y"]], dtype=float).T
        assert (ends[: len(shot.ids)] == end).all()


def test_the_shot_of_a_row_with_noise_has_the_strike_after_the_noise(spec: Spec) -> None:
    sweep = Sweep.from_dict({**spec, "noise": "olympiad", "variants": 2})
    for row in sweep.table().to_pylist()[::29]:
        shot = sweep.shot(row["row"])
        strike = shot.to_dict()["strike"]
        for key in ("speed", "side", "height"):
            assert strike[key] == row[f"played_{key}"]
        # The shot has radians where degrees would not keep the bits.
        for key in ("azimuth", "elevation"):
            degrees = strike[f"{key}_deg"] if f"{key}_deg" in strike else np.degrees(strike[key])
            assert degrees == pytest.approx(row[f"played_{key}_deg"], rel=1e-15, abs=0)
        trace = shot.simulate()
        end = trace.at(trace.duration).position[:, 0]
        assert end.tolist() == row["end_x"][: len(shot.ids)]


def test_the_shot_of_a_row_that_fails_is_refused_with_the_error_of_the_row(spec: Spec) -> None:
    vary = {"strike.side": {"grid": [0.1, 0.95]}}
    sweep = Sweep.from_dict({**spec, "vary": vary, "samples": 1})
    error = sweep.table()["error"][1].as_py()
    with pytest.raises(InputError) as refused:
        sweep.shot(1)
    assert str(refused.value) == error


def test_rows_are_in_c_order_of_layout_grids_and_sample(spec: Spec) -> None:
    table = Sweep.from_dict(spec).parameters()
    row = np.arange(200)
    assert table["row"].to_pylist() == row.tolist()
    assert table["layout"].to_pylist() == (row // 100).tolist()
    assert table["speed"].to_pylist() == (1.0 + 0.5 * (row // 20 % 5)).tolist()
    friction = table["physics_cloth_sliding_friction"].to_numpy()
    assert (friction == np.where(row // 10 % 2, 0.2, 0.15)).all()
    assert table["sample"].to_pylist() == (row % 10).tolist()


def test_a_row_has_the_same_bits_alone_and_among_others(spec: Spec) -> None:
    sweep = Sweep.from_dict(spec | {"noise": "olympiad", "variants": 3})
    whole = sweep.table()
    for start, stop in ((0, 1), (17, 18), (123, 456), (599, 600)):
        assert sweep.table(start, stop).equals(whole.slice(start, stop - start))


def test_the_order_in_which_rows_are_simulated_does_not_matter(spec: Spec) -> None:
    spec["vary"]["physics.ball_ball.model"] = {"grid": ["elastic", "compliant"]}
    sweep = Sweep.from_dict(spec | {"noise": "olympiad", "variants": 2})
    order = np.random.default_rng(1).permutation(len(sweep))
    mixed = sweep.play(sweep.parameters().take(pa.array(order)))
    straight = pa.Table.from_batches([sweep.play(sweep.parameters())])
    assert pa.Table.from_batches([mixed]).sort_by("row").equals(straight)


def test_a_table_in_memory_is_the_same_for_any_number_of_threads(spec: Spec) -> None:
    sweep = Sweep.from_dict(spec | {"samples": 2000})
    one = sweep.table(5, 37_000, threads=1)
    assert one.equals(sweep.table(5, 37_000, threads=3))
    assert one.equals(sweep.table(5, 37_000))


def test_a_range_includes_both_ends_to_the_bit(pot: dict[str, Any]) -> None:
    vary = {"strike.speed": {"from": 0.1, "to": 0.7, "count": 7}}
    sweep = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary})
    speeds = sweep.parameters()["speed"].to_pylist()
    assert (speeds[0], speeds[-1], len(speeds)) == (0.1, 0.7, 7)
    assert np.diff(speeds) == pytest.approx(0.1)


def test_relative_values_are_added_to_the_own_numbers_of_each_layout(spec: Spec) -> None:
    spec["shots"][1]["strike"]["azimuth_deg"] = 80.0
    spec["vary"] = {"strike.azimuth_deg": {"grid": [-1.5, 0.0], "relative": True}}
    del spec["samples"]
    relative = Sweep.from_dict(spec).table()
    assert relative["azimuth_deg_offset"].to_pylist() == [-1.5, 0.0, -1.5, 0.0]
    spec["vary"] = {"strike.azimuth_deg": {"grid": [88.5, 90.0, 78.5, 80.0]}}
    absolute = Sweep.from_dict(spec).table().take([0, 1, 6, 7])
    assert relative["end_x"].equals(absolute["end_x"])


def test_relative_angles_are_added_to_a_strike_in_radians(pot: dict[str, Any]) -> None:
    # Seen: a strike with `azimuth` in radians counted as one with an azimuth of 0°.
    vary = {
        "strike.azimuth_deg": {"grid": [-1.5, 0.0], "relative": True},
        "strike.elevation_deg": {"grid": [0.0, 2.0], "relative": True},
    }
    spec = {"format": "carom-sweep/1", "shots": pot, "vary": vary}
    pot["strike"] |= {"azimuth_deg": 88.0, "elevation_deg": 5.0}
    in_degrees = Sweep.from_dict(spec).table()
    del pot["strike"]["azimuth_deg"], pot["strike"]["elevation_deg"]
    pot["strike"] |= {"azimuth": math.radians(88.0), "elevation": math.radians(5.0)}
    assert Sweep.from_dict(spec).table().equals(in_degrees)


def test_any_value_of_a_shot_file_may_vary(pot: dict[str, Any]) -> None:
    vary = {
        "table": {"grid": ["wpa-9ft", {"base": "wpa-9ft", "cushion_height": 0.037}]},
        "physics": {"grid": ["pool", "ideal"]},
        "physics.cloth.rolling_friction": {"grid": [0.005, 0.01], "name": "rolling"},
        "balls.1.position": {"uniform": [[0.3, 1.5], [0.9, 2.0]]},
        "balls.cue.position[0]": {"uniform": [0.3, 0.9]},
        "strike.side": {"choice": [-0.2, 0.2]},
        "strike.obstruction": {"choice": ["report", "refuse"]},
    }
    spec = {"format": "carom-sweep/1", "shots": pot, "vary": vary, "samples": 20}
    sweep = Sweep.from_dict(spec)
    for row in sweep.table(0, len(sweep)).to_pylist()[::7]:
        file = copy.deepcopy(pot)
        table, physics = row["table"], row["physics"]
        file["table"] = json.loads(table) if table.startswith("{") else table
        file["physics"] = {"base": physics, "cloth": {"rolling_friction": row["rolling"]}}
        file["balls"][1]["position"] = row["balls_1_position"]
        file["balls"][0]["position"][0] = row["balls_cue_position_0"]
        file["strike"] |= {"side": row["side"], "obstruction": row["obstruction"]}
        trace = carom.Shot.from_dict(file).simulate()
        assert row["duration"] == trace.duration
        assert row["end_x"] == trace.at(trace.duration).position[:, 0].tolist()


def test_noise_gives_the_same_variants_as_vary(pot: dict[str, Any]) -> None:
    shot = carom.Shot.from_dict(pot)
    spec = {"format": "carom-sweep/1", "shots": shot, "noise": "club", "variants": 50, "seed": 9}
    table = Sweep.from_dict(spec).table()
    result = shot.vary(carom.Noise.preset("club"), 50, seed=9)
    assert table["played_speed"].to_pylist() == result.speed.tolist()
    assert np.degrees(result.azimuth) == pytest.approx(table["played_azimuth_deg"].to_numpy())
    assert table["events"].to_pylist() == result.events.tolist()
    assert np.array(table["end_y"].to_pylist()).tolist() == result.final_position[..., 1].tolist()


def test_paired_draws_are_the_same_at_every_point_of_the_grids(spec: Spec) -> None:
    noisy = spec | {"noise": "club", "variants": 2}
    drawn = {}
    for paired in (False, True):
        table = Sweep.from_dict(noisy | {"paired": paired}).table()
        for name in ("azimuth_deg", "played_side"):
            drawn[name, paired] = np.array(table[name].to_pylist()).reshape(20, 20)
    for name in ("azimuth_deg", "played_side"):
        assert (drawn[name, True] == drawn[name, True][0]).all()
        assert (drawn[name, False][0] != drawn[name, False][1]).any()


def test_draws_have_the_distributions_of_the_spec(pot: dict[str, Any]) -> None:
    vary = {
        "strike.speed": {"log_uniform": [0.5, 8]},
        "strike.azimuth_deg": {"normal": [90, 2.5]},
        "strike.side": {"uniform": [-0.3, 0.5]},
        "physics.ball_ball.model": {"choice": ["elastic", "frictional", "compliant"]},
    }
    spec = {"format": "carom-sweep/1", "shots": pot, "vary": vary, "samples": 5000}
    for sequence in ("random", "even"):
        table = Sweep.from_dict(spec | {"sequence": sequence}).parameters()
        for name, shape in (
            ("speed", stats.loguniform(0.5, 8)),
            ("azimuth_deg", stats.norm(90, 2.5)),
            ("side", stats.uniform(-0.3, 0.8)),
        ):
            assert stats.kstest(table[name].to_numpy(), shape.cdf).pvalue > SIGNIFICANCE
        counts = table["physics_ball_ball_model"].value_counts().field("counts").to_pylist()
        assert stats.chisquare(counts).pvalue > SIGNIFICANCE


def test_normal_draws_are_the_quantiles_of_scipy() -> None:
    share = np.concatenate([np.linspace(1e-6, 1 - 1e-6, 10_001), [1e-300, 1e-16]])[:, None]
    ours = carom._core.quantiles("normal", [0.0], [1.0], share)
    # Both formulas are accurate to about 1 part in 10¹⁶.
    assert ours[:, 0] == pytest.approx(special.ndtri(share[:, 0]), rel=4e-15, abs=1e-15)


def test_rows_that_fail_have_an_error_and_no_outcome(pot: dict[str, Any]) -> None:
    vary = {"strike.side": {"grid": [0.0, 0.95]}, "balls.1.position[1]": {"grid": [1.9, 0.64]}}
    table = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary}).table()
    good, overlap, miscue, both = table.to_pylist()
    assert good["error"] is None
    assert "overlaps" in overlap["error"]
    assert "miscue" in miscue["error"]
    assert "overlaps" in both["error"]
    parameters = {"row", "layout", "side", "balls_1_position_1", "error"}
    for row in (overlap, miscue, both):
        assert all(value is None for name, value in row.items() if name not in parameters)
    assert all(good[name] is not None for name in ("pocket", "end_x", "events", "first_contact"))


def test_a_strike_that_is_valid_only_with_the_rows_physics_is_simulated(
    pot: dict[str, Any],
) -> None:
    # With the slippery tip the file's own strike is a miscue, and the first row's is not.
    pot["strike"]["side"] = 0.4
    vary = {"physics.cue.tip_friction": {"grid": [0.2, 0.7]}, "strike.side": {"grid": [0.1, 0.4]}}
    table = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary}).table()
    assert [error is None for error in table["error"].to_pylist()] == [True, False, True, True]


# Errors.


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"format": "carom-shot/1"}, r'^format: .*write "carom-sweep/1"'),
        # For a file of another format the error names the format, not the first unknown key.
        ({"format": "carom-shot/1", "table": "wpa-9ft"}, r"^format: .*a shot under `shots`"),
        ({"sample": 3}, r"^sample: unknown key; did you mean `samples`"),
        ({"shots": []}, r"^shots: the list is empty"),
        ({"shots": ["nowhere/*.json"]}, r"^shots\[0\]: no file matches"),
        ({"shots": [{"format": "carom-shot/1"}]}, r"^shots\[0\]: table: the key is missing"),
        ({"vary": {"stroke.speed": {"grid": [1]}}}, r'^vary.stroke.speed: .*did you mean "strike"'),
        (
            {"vary": {"strike.speed": [1, 2]}},
            r"^vary.strike.speed: found a list of 2; write",
        ),
        ({"vary": {"strike.speed": {"grid": []}}}, r"^vary.strike.speed.grid: found a list of 0"),
        (
            {"vary": {"strike.speed": {"from": 1, "to": 2}}},
            r"^vary.strike.speed: not exactly one way",
        ),
        ({"vary": {"strike.speed": {"grids": [1]}}}, r"^vary.strike.speed.grids: unknown key; did"),
        (
            {"vary": {"strike.speed": {"from": 1, "to": 2, "count": 0}}},
            r"^vary.strike.speed.count: 0 is out of range; write a whole number from 1",
        ),
        (
            {"vary": {"strike.speed": {"uniform": [2, 1]}}},
            r"^vary.strike.speed.uniform\[1\]: 1.0",
        ),
        ({"vary": {"strike.speed": {"normal": [2, -1]}}}, r"^vary.strike.speed.normal\[1\]: -1.0"),
        ({"vary": {"strike.speed": {"log_uniform": [0, 1]}}}, r"log_uniform\[0\]: 0.0 has no log"),
        (
            {"vary": {"table.length": {"grid": [1], "relative": True}}},
            r"^vary.table.length.relative: only a strike's numbers",
        ),
        (
            {"vary": {"balls.cue.id": {"grid": ["a"]}}},
            r"^vary.balls.cue.id: the ids of the balls cannot vary",
        ),
        (
            {"vary": {"table.row": {"grid": [1], "name": "row"}}},
            r'the table already has a column "row"',
        ),
        (
            {
                "vary": {
                    "physics.cloth.sliding_friction": {"grid": [0.2]},
                    "physics": {"grid": ["pool"]},
                }
            },
            r"^vary.physics: it would overwrite physics.cloth.sliding_friction; write it before",
        ),
        ({"vary": {5: {"grid": [1]}}}, r"^vary: the key 5 is not a string"),
        ({5: 1}, r"^the key 5 is not a string"),
        ({"samples": 0}, r"^samples: 0 is out of range; write"),
        ({"samples": True}, r"^samples: found true"),
        ({"vary": {}, "samples": 5}, r"^samples: nothing is drawn"),
        ({"seed": -1}, r"^seed: -1 is out of range; write"),
        ({"sequence": "sobol"}, r'^sequence: there is no sequence "sobol"'),
        ({"variants": 5}, r"^variants: without noise"),
        ({"noise": "amateur"}, r"^noise: there is no preset 'amateur'"),
        ({"noise": {"azimuth": 0.1}}, r"^noise.azimuth: unknown key; did you mean `azimuth_deg`"),
        ({"paired": 1}, r"^paired: found the number 1"),
        ({"columns": [["pocket"]]}, r"^columns\[0\]: found a list of 1; write a name"),
        ({"vary": {"strike.speed": {"grid": [1], "name": 0}}}, r"^vary.strike.speed.name: found"),
        ({"columns": ["pockets"]}, r'^columns\[0\]: .*did you mean "pocket"'),
    ],
)
def test_an_invalid_spec_is_refused_with_the_place(spec: Spec, change: Spec, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Sweep.from_dict({**spec, **change})


def test_draws_without_a_number_of_samples_are_refused(spec: Spec) -> None:
    del spec["samples"]
    with pytest.raises(InputError, match=r"^samples: the key is missing, and strike.azimuth_deg"):
        Sweep.from_dict(spec)


def test_a_sweep_without_any_valid_row_is_refused(spec: Spec, tmp_path: Path) -> None:
    spec["vary"]["physics.cloth.slippery"] = {"grid": [1]}
    with pytest.raises(
        InputError, match=r"no row can be simulated.*physics.cloth.slippery: unknown"
    ):
        carom.sweep(spec, tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"a": 1, "a": 2}', r"^a: the key occurs twice"),
        (
            '{"seed": NaN}',
            r"^seed: NaN \(line 1, column \d+\) is not a number .*; write a finite number",
        ),
        ("[1,", r"not JSON: .*line 1, column 3.*; correct the text there"),
        ("[]", r"^the spec: found a list of 0"),
    ],
)
def test_text_that_is_not_a_spec_is_refused(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Sweep.from_json(text)


def test_a_spec_may_hold_numpy_arrays_and_numbers(pot: dict[str, Any]) -> None:
    spec = {"format": "carom-sweep/1", "shots": pot}
    plain = Sweep.from_dict(spec | {"vary": {"strike.speed": {"grid": [1.0, 1.5, 2.0]}}})
    array = {"strike.speed": {"grid": np.linspace(1.0, 2.0, 3)}}
    assert Sweep.from_dict(spec | {"vary": array, "seed": np.int64(0)}).sha256 == plain.sha256
    assert plain.table(np.int64(1), np.int64(3)).num_rows == 2  # type: ignore[arg-type]


@pytest.mark.parametrize(("start", "stop"), [("a", None), (0, "b"), (0.5, None), (2, 1), (-1, 1)])
def test_invalid_ranges_of_rows_are_refused(pot: dict[str, Any], start: Any, stop: Any) -> None:
    vary = {"strike.speed": {"grid": [1.0, 1.5, 2.0]}}
    sweep = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary})
    with pytest.raises(InputError, match=r"^(start|stop|rows)\b"):
        sweep.table(start, stop)


def test_the_shot_of_a_row_beyond_the_end_is_refused_with_the_valid_rows(
    pot: dict[str, Any],
) -> None:
    # Seen: "rows 99 to 100: the sweep has rows 0 to 2" for a sweep of two rows.
    vary = {"strike.speed": {"grid": [1.0, 2.0]}}
    sweep = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary})
    for row in (99, 2, -1, 1.0, None):
        with pytest.raises(InputError, match=r"^row: .*; give a whole number from 0 to 1$"):
            sweep.shot(row)  # type: ignore[arg-type]


def test_more_rows_than_memory_holds_are_refused(pot: dict[str, Any]) -> None:
    vary = {"strike.speed": {"from": 1, "to": 2, "count": 10**12}}
    sweep = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary})
    for ask in (sweep.table, sweep.parameters):
        with pytest.raises(InputError, match=r"^stop: .*too many for memory; .*Sweep\.run"):
            ask()
    assert len(sweep.parameters(10**12 - 2)) == 2


def test_arguments_of_a_wrong_type_are_refused_by_name(pot: dict[str, Any], tmp_path: Path) -> None:
    # Seen: `carom.sweep(spec, 5)` raised a bare TypeError.
    spec: dict[str, Any] = {"format": "carom-sweep/1", "shots": pot}
    sweep = Sweep.from_dict(spec)
    wrong: Any = 5
    asks: list[tuple[str, Callable[[], object]]] = [
        ("out", lambda: carom.sweep(spec, wrong)),
        ("out", lambda: carom.sweep(spec, b"out")),  # type: ignore[arg-type]
        ("out", lambda: carom.sweep(spec, "a\0b")),
        ("threads", lambda: carom.sweep(spec, tmp_path / "out", threads=-1)),
        ("part_rows", lambda: carom.sweep(spec, tmp_path / "out", part_rows=0)),
        ("part_rows", lambda: carom.sweep(spec, tmp_path / "out", part_rows=1e300)),  # type: ignore[arg-type]
        ("ray", lambda: carom.sweep(spec, tmp_path / "out", ray=wrong)),
        ("progress", lambda: carom.sweep(spec, tmp_path / "out", progress=wrong)),
        ("path", lambda: Sweep.load(wrong)),
        ("text", lambda: Sweep.from_json(wrong)),
        ("folder", lambda: Sweep.from_dict(spec, folder=wrong)),
        ("spec", lambda: Sweep(wrong)),
        ("batch", lambda: sweep.play(wrong)),
        ("batch", lambda: sweep.play(sweep.parameters().select(["row"]))),
        ("threads", lambda: sweep.table(threads=wrong / 2)),
    ]
    for name, ask in asks:
        with pytest.raises(InputError, match=rf"^{name}: .*; "):
            ask()
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("column", "values", "message"),
    [
        ("layout", [0, 2], r"^batch: layout is out of range; give whole numbers from 0 to 1$"),
        ("layout", [0, -1], r"^batch: layout is out of range"),
        ("layout", [0, None], r"^batch: layout has nulls; give"),
        ("layout", ["a", "b"], r"^batch: layout has the type string; give int32"),
        ("speed", ["fast", "slow"], r"^batch: speed has the type string; give double"),
    ],
)
def test_a_batch_with_wrong_values_is_refused_by_column(
    spec: Spec, column: str, values: list[Any], message: str
) -> None:
    sweep = Sweep.from_dict(spec)
    batch = sweep.parameters(0, 2)
    with pytest.raises(InputError, match=message):
        sweep.play(batch.set_column(batch.schema.get_field_index(column), column, pa.array(values)))


def test_a_long_batch_has_the_rows_of_short_ones(pot: dict[str, Any]) -> None:
    # Long batches go to Rust in pieces, so that Ctrl-C can end them.
    pot["strike"]["speed"] = 0.1
    vary = {
        "strike.azimuth_deg": {"from": 0, "to": 359, "count": 10_000},
        "physics": {"grid": ["pool", "ideal"]},
        "strike.speed": {"grid": [0.1, 0.2]},
    }
    sweep = Sweep.from_dict({"format": "carom-sweep/1", "shots": pot, "vary": vary})
    long = sweep.play(sweep.parameters())
    assert len(long) == 40_000
    for start in (0, 16_380, 39_990):
        assert long.slice(start, 10).equals(sweep.play(sweep.parameters(start, start + 10)))


def test_a_batch_made_elsewhere_may_have_wider_types(spec: Spec) -> None:
    sweep = Sweep.from_dict(spec)
    batch = sweep.parameters(0, 4)
    wide = batch.set_column(1, "layout", batch["layout"].cast(pa.int64()))
    assert sweep.play(wide).equals(sweep.play(batch))


def test_sigmas_of_the_noise_have_their_unit_in_the_name(pot: dict[str, Any]) -> None:
    spec = {"format": "carom-sweep/1", "shots": pot}
    new = Sweep.from_dict(spec | {"noise": {"side_m": 1e-3, "height_m": 2e-3, "azimuth_deg": 1}})
    old = Sweep.from_dict(spec | {"noise": {"side": 1e-3, "height": 2e-3, "azimuth_deg": 1}})
    assert new.table().equals(old.table())
    with pytest.raises(
        InputError, match=r"^noise\.side: side_m gives the same number; keep only side_m"
    ):
        Sweep.from_dict(spec | {"noise": {"side_m": 1e-3, "side": 1e-3}})


def test_a_spec_of_a_wrong_type_is_refused(tmp_path: Path) -> None:
    wrong: Any
    for wrong in (None, 5, ["spec.json"]):
        with pytest.raises(InputError, match=r"^spec: found a .*; give a Sweep"):
            carom.sweep(wrong, tmp_path)
    with pytest.raises(InputError, match="recursion limit"):
        Sweep.from_json("[" * 100_000)
