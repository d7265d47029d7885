"""The elevation of a strike that gives none, in the Python interface."""

from __future__ import annotations

import math
import pickle
from typing import Any

import carom
import numpy as np
import pytest

STROKE = math.radians(3.0)
BALLS = {"cue": (0.635, 0.06), "1": (0.635, 1.905)}
UP = math.pi / 2


def near_the_rail(**strike: Any) -> carom.Shot:
    return carom.Shot("wpa-9ft", BALLS, carom.Strike(speed=2.0, azimuth=UP, **strike))


def test_a_strike_that_omits_the_elevation_has_the_default_and_is_written_with_it() -> None:
    shot = near_the_rail()
    assert shot.has_default_elevation
    assert shot.elevation == pytest.approx(math.radians(13.66), abs=1e-3)
    written = shot.to_dict()["strike"]
    assert ("elevation" in written) != ("elevation_deg" in written)
    again = carom.Shot.from_dict(shot.to_dict())
    assert again == shot
    assert not again.has_default_elevation
    assert again.simulate().hash == shot.simulate().hash
    trace = carom.Trace.from_json(shot.simulate().to_json())
    assert trace.shot.elevation == shot.elevation
    level = near_the_rail(elevation=0.0)
    assert (level.elevation, level.to_dict()["strike"]["elevation"]) == (0.0, 0.0)


def test_with_strike_keeps_a_given_elevation_and_lets_a_default_one_follow() -> None:
    assert near_the_rail().with_strike(azimuth=0.0).elevation == pytest.approx(STROKE)
    assert near_the_rail(elevation=0.2).with_strike(azimuth=0.0).elevation == 0.2
    raised = near_the_rail().with_strike(elevation=0.5)
    assert (raised.elevation, raised.has_default_elevation) == (0.5, False)


def test_a_batch_gives_each_variant_the_elevation_of_its_own_shot() -> None:
    shot = near_the_rail()
    azimuth = np.linspace(0.0, 6.0, 12)
    batch = shot.batch(azimuth=azimuth)
    alone = [shot.with_strike(azimuth=turn).simulate() for turn in azimuth.tolist()]
    ends = [trace.at(trace.duration).position for trace in alone]
    np.testing.assert_array_equal(batch.final_position, np.array(ends))
    assert len({trace.shot.elevation for trace in alone}) > 1
    level = shot.batch(azimuth=azimuth, elevation=0.0)
    assert (level.final_position != batch.final_position).any()
    # A given elevation stays.
    fixed = near_the_rail(elevation=0.1)
    np.testing.assert_array_equal(
        fixed.batch(azimuth=azimuth).final_position,
        fixed.batch(azimuth=azimuth, elevation=0.1).final_position,
    )


def test_a_pickled_shot_keeps_the_omission() -> None:
    for shot in (near_the_rail(), near_the_rail(elevation=0.0)):
        copy = pickle.loads(pickle.dumps(shot))
        assert copy == shot
        assert copy.has_default_elevation == shot.has_default_elevation
        assert copy.with_strike(azimuth=0.0) == shot.with_strike(azimuth=0.0)


def test_a_frame_records_the_angle_that_was_used_and_replays_it() -> None:
    frame = carom.Frame("nine-ball", seed=7)
    strike = carom.Strike(speed=8.0, azimuth=UP)
    asked = frame.shot(strike, cue_ball=(0.635, 0.1))
    ruling = frame.play(strike, cue_ball=(0.635, 0.1))
    assert ruling.trace is not None
    used = frame.record["moves"][0]["play"]["strike"]["elevation"]
    assert used == ruling.trace.shot.elevation == asked.elevation
    assert used > STROKE
    assert carom.Frame.replay(frame.record).to_dict() == frame.to_dict()
    level = carom.Frame("nine-ball", seed=7)
    level.play(carom.Strike(speed=8.0, azimuth=UP, elevation=0.0), cue_ball=(0.635, 0.1))
    assert level.record["moves"][0]["play"]["strike"]["elevation"] == 0.0


def test_a_sweep_gives_each_row_its_own_elevation() -> None:
    file = near_the_rail()._core.to_object(elevation=False)
    spec = {"format": "carom-sweep/1", "shots": file}
    turned = carom.Sweep.from_dict(spec | {"vary": {"strike.azimuth_deg": {"grid": [0.0, 90.0]}}})
    elevations = [turned.shot(row).elevation for row in range(2)]
    assert elevations == pytest.approx([STROKE, near_the_rail().elevation])
    places = {"balls.cue.position": {"grid": [[0.6, 1.0], [0.6, 0.06]]}}
    moved = carom.Sweep.from_dict(spec | {"vary": places})
    assert [moved.shot(row).elevation > STROKE + 0.01 for row in range(2)] == [False, True]
    again = carom.Sweep.from_json(turned.to_json())
    assert [again.shot(row).elevation for row in range(2)] == elevations
    rows = turned.table()
    for row in range(2):
        trace = turned.shot(row).simulate()
        assert rows["duration"][row].as_py() == trace.duration


def test_searches_and_maps_give_each_strike_its_own_elevation() -> None:
    shot = carom.Shot(
        "wpa-9ft", {"cue": (0.635, 0.06), "1": (0.9, 0.3)}, carom.Strike(speed=2.0, azimuth=UP)
    )
    found = shot.solve(pot="1", samples=256, wanted=20)
    assert found
    for solution in found:
        assert solution.shot.elevation == solution.elevation
        assert solution.shot.simulate().outcome.cue_obstructed is None
        assert solution.elevation >= STROKE - 1e-12
    assert len({round(solution.elevation, 6) for solution in found}) > 1
    level = shot.with_strike(elevation=0.0).solve(pot="1", samples=256, wanted=20)
    assert min(solution.elevation for solution in level) == 0.0


def test_a_kick_table_gives_each_cell_its_own_elevation_without_the_other_balls() -> None:
    behind = {"cue": (0.635, 0.3), "1": (0.635, 0.22)}
    shot = carom.Shot("wpa-9ft", behind, carom.Strike(speed=2.0, azimuth=UP, height=0.2))
    assert shot.elevation is not None
    assert shot.elevation > 0.1
    alone = carom.Shot("wpa-9ft", {"cue": behind["cue"]}, carom.Strike(speed=2.0, azimuth=UP))
    for azimuth in (0.3, UP):
        elevation = alone.with_strike(azimuth=azimuth, height=0.2, side=0.3).elevation
        given = shot.with_strike(elevation=elevation)
        cell = {"azimuth": [azimuth], "speed": [2.0], "side": [0.3], "height": 0.2}
        ours, same = shot.kick_table(**cell), given.kick_table(**cell)
        np.testing.assert_array_equal(ours.contact, same.contact)
        other = shot.with_strike(elevation=0.3).kick_table(**cell)
        assert (ours.contact != other.contact).any()


def test_an_elevation_out_of_range_is_refused_with_its_place() -> None:
    for value in (-0.1, math.pi / 2, math.nan):
        with pytest.raises(carom.InputError, match=r"^strike\.elevation"):
            near_the_rail(elevation=value)
    with pytest.raises(carom.InputError, match=r"^physics\.cue\.stroke_elevation_deg: "):
        carom.Shot(
            "wpa-9ft",
            BALLS,
            carom.Strike(speed=2.0, azimuth=UP),
            physics={"cue": {"stroke_elevation_deg": 90.0}},
        )
    with pytest.raises(carom.InputError, match=r"^strike\.elevation"):
        carom.Frame("nine-ball").play(
            carom.Strike(speed=2.0, azimuth=UP, elevation="3"),  # type: ignore[arg-type]
            cue_ball=(0.635, 0.5),
        )
