"""`simulate_batch` and `Shot.batch`: the results of single shots, for any number of threads."""

from __future__ import annotations

import copy
import math
import subprocess
import sys
import threading
import time
from typing import Any

import carom
import numpy as np
import pytest
from carom import InputError, Shot

PADDING = -3
ON_TABLE = -1


def one_by_one(shots: list[Shot]) -> list[dict[str, Any]]:
    return [shot.simulate().to_dict() for shot in shots]


def varied(pot: dict[str, Any], speeds: list[float]) -> list[Shot]:
    shots = []
    for speed in speeds:
        file = copy.deepcopy(pot)
        file["strike"]["speed"] = speed
        shots.append(Shot.from_dict(file))
    return shots


def test_a_batch_ends_where_the_single_shots_end(pot: dict[str, Any], nine_ball: Shot) -> None:
    shots = [*varied(pot, [0.5, 1.0, 2.0, 4.0]), nine_ball]
    result = carom.simulate_batch(shots, threads=1)
    for index, trace in enumerate(one_by_one(shots)):
        for ball, state in enumerate(trace["final"]):
            assert result.final_position[index, ball].tolist() == state["position"]
        assert result.events[index] == len(trace["events"])


def test_arrays_have_the_documented_shapes_and_types(pot: dict[str, Any], nine_ball: Shot) -> None:
    result = carom.simulate_batch([Shot.from_dict(pot), nine_ball])
    n = len(nine_ball.ids)
    assert result.final_position.shape == (2, n, 3)
    assert result.final_position.dtype == np.float64
    assert result.pocket.shape == (2, n)
    assert result.pocket.dtype == np.int8
    assert result.events.shape == (2,)
    assert result.events.dtype == np.int32
    assert result.errors == {}
    assert len(result) == 2


def test_shots_with_fewer_balls_are_padded(pot: dict[str, Any], nine_ball: Shot) -> None:
    result = carom.simulate_batch([Shot.from_dict(pot), nine_ball])
    assert np.isfinite(result.final_position[0, :2]).all()
    assert np.isnan(result.final_position[0, 2:]).all()
    assert (result.pocket[0, 2:] == PADDING).all()
    assert np.isfinite(result.final_position[1]).all()


def test_pockets_are_numbered_in_the_order_of_the_tables(nine_ball: Shot) -> None:
    names = [pocket["name"] for pocket in nine_ball.geometry()["pockets"]]
    assert names == ["bottom-left", "bottom-right", "left", "right", "top-left", "top-right"]
    speeds = np.linspace(5.0, 10.0, 40)
    result = nine_ball.batch(speed=speeds)
    seen = set()
    for index, speed in enumerate(speeds):
        file = nine_ball.to_dict()
        file["strike"]["speed"] = float(speed)
        fallen = dict(Shot.from_dict(file).simulate().outcome["pocketed"])
        seen |= set(fallen.values())
        for ball, name in enumerate(nine_ball.ids):
            expected = names.index(fallen[name]) if name in fallen else ON_TABLE
            assert result.pocket[index, ball] == expected
    assert len(seen) >= 3


def test_results_do_not_depend_on_the_number_of_threads(nine_ball: Shot) -> None:
    speeds = np.linspace(2.0, 10.0, 500)
    one = nine_ball.batch(speed=speeds, threads=1)
    for threads in (2, 3, None):
        other = nine_ball.batch(speed=speeds, threads=threads)
        assert one.final_position.tobytes() == other.final_position.tobytes()
        assert one.pocket.tobytes() == other.pocket.tobytes()
        assert one.events.tobytes() == other.events.tobytes()


def test_scalars_broadcast_and_omitted_values_stay(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    own = carom.simulate_batch([shot])
    result = shot.batch(side=[0.0, 0.3], height=0.0)
    assert result.final_position.shape == (2, 2, 3)
    assert result.final_position[0].tobytes() == own.final_position[0].tobytes()
    assert result.final_position[1].tobytes() != own.final_position[0].tobytes()
    assert len(shot.batch(speed=3.0)) == 1
    assert len(shot.batch()) == 1


def test_arrays_broadcast_against_each_other_in_c_order(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    grid = shot.batch(speed=np.array([[1.0], [2.0]]), side=np.array([0.0, 0.1, 0.2]))
    assert len(grid) == 6
    assert (
        grid.final_position[4].tobytes()
        == shot.batch(speed=2.0, side=0.1).final_position[0].tobytes()
    )


def test_angles_are_radians(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    assert (
        shot.batch(azimuth=math.radians(90.0)).final_position.tobytes()
        == carom.simulate_batch([shot]).final_position.tobytes()
    )
    raised = copy.deepcopy(pot)
    raised["strike"]["elevation_deg"] = 30.0
    assert (
        shot.batch(elevation=math.radians(30.0)).final_position.tobytes()
        == carom.simulate_batch([Shot.from_dict(raised)]).final_position.tobytes()
    )


def test_a_failing_shot_is_reported_by_index_and_does_not_affect_others(
    pot: dict[str, Any],
) -> None:
    shot = Shot.from_dict(pot)
    height = np.zeros(7)
    height[3] = 0.9
    result = shot.batch(height=height, speed=[1, 2, 3, 4, 5, 60, math.nan])
    assert sorted(result.errors) == [3, 5, 6]
    assert "miscue" in result.errors[3]
    assert "speed" in result.errors[5]
    assert "speed" in result.errors[6]
    for index in result.errors:
        assert np.isnan(result.final_position[index]).all()
        assert (result.pocket[index] == PADDING).all()
        assert result.events[index] == 0
    good = [0, 1, 2, 4]
    alone = shot.batch(speed=[1, 2, 3, 5])
    assert result.final_position[good].tobytes() == alone.final_position.tobytes()


def test_a_capped_shot_in_a_batch_is_reported_by_index(pot: dict[str, Any]) -> None:
    capped = copy.deepcopy(pot)
    capped["max_events"] = 2
    result = carom.simulate_batch([Shot.from_dict(pot), Shot.from_dict(capped)])
    assert list(result.errors) == [1]
    assert "2 events" in result.errors[1]


def test_an_empty_batch_is_empty(pot: dict[str, Any]) -> None:
    result = carom.simulate_batch([])
    assert result.final_position.shape == (0, 0, 3)
    assert result.pocket.shape == (0, 0)
    assert len(result) == 0
    nothing = Shot.from_dict(pot).batch(speed=[])
    assert nothing.final_position.shape == (0, 2, 3)


def test_bad_arguments_of_batches_are_refused(pot: dict[str, Any], endless: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    with pytest.raises(InputError, match=r"shots\[1\]: found a dict"):
        carom.simulate_batch([shot, pot])  # type: ignore[list-item]
    with pytest.raises(InputError, match="do not broadcast"):
        shot.batch(speed=[1.0, 2.0], side=[0.0, 0.1, 0.2])
    with pytest.raises(InputError, match=r"^speed: not a number"):
        shot.batch(speed="fast")
    with pytest.raises(InputError, match=r"^strike: "):
        Shot.from_dict(endless).batch(speed=1.0)
    for threads in (0, -1, 1.5, True):
        with pytest.raises(InputError, match=r"^threads: "):
            shot.batch(threads=threads)  # type: ignore[arg-type]


def test_other_python_threads_run_during_a_batch(nine_ball: Shot) -> None:
    # The counter advances only if the batch has released the GIL.
    ticks = 0
    stop = threading.Event()

    def tick() -> None:
        nonlocal ticks
        while not stop.is_set():
            ticks += 1
            time.sleep(0.001)

    counter = threading.Thread(target=tick)
    counter.start()
    try:
        before, start = ticks, time.perf_counter()
        nine_ball.batch(speed=np.linspace(5.0, 10.0, 8000), threads=1)
        elapsed = time.perf_counter() - start
        heard = ticks - before
    finally:
        stop.set()
        counter.join()
    # A batch of one chunk; a tenth of the possible ticks leaves room for a busy machine.
    assert heard > 0.1 * elapsed / 0.002


def test_the_progress_bar_goes_to_stderr_and_nothing_to_stdout() -> None:
    program = (
        "import carom\n"
        "s = carom.Shot('wpa-9ft', {'cue': (0.6, 0.6)}, carom.Strike(speed=1, azimuth=1))\n"
        "s.batch(speed=[1.0] * 100, progress=True)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout == ""
    assert "100/100" in done.stderr


def test_one_call_accepts_a_hundred_thousand_variants(pot: dict[str, Any]) -> None:
    angles = math.pi / 2 + np.linspace(-0.02, 0.02, 100_000)
    result = Shot.from_dict(pot).batch(azimuth=angles, side=0.1)
    assert result.final_position.shape == (100_000, 2, 3)
    assert np.isfinite(result.final_position).all()
    assert result.errors == {}
    # Spot checks against single calls, across the borders of the chunks.
    for index in (0, 8191, 8192, 50_000, 99_999):
        alone = Shot.from_dict(pot).batch(azimuth=angles[index], side=0.1)
        assert alone.final_position[0].tobytes() == result.final_position[index].tobytes()
