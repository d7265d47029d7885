"""Properties of every shot, checked on random shots."""

from __future__ import annotations

import math
from typing import Any

import carom
import numpy as np
import pytest
from carom import InputError, Shot, Trace
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

WIDTH, LENGTH = 1.27, 2.54
RADIUS = 0.028575
# Balls are placed on a grid of this spacing, m, so that they cannot overlap.
PITCH = 0.1
COLUMNS, ROWS = 11, 23

# Each example simulates several whole shots.
EXAMPLES = settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow], derandomize=True
)

speeds = st.floats(0.05, 12.0)
degrees = st.floats(-360.0, 360.0)
offsets = st.floats(-0.35, 0.35)


@st.composite
def shots(draw: st.DrawFn, *, most: int = 8) -> dict[str, Any]:
    """A shot with up to `most` balls on a pool table."""
    cells = draw(
        st.lists(
            st.tuples(st.integers(0, COLUMNS - 1), st.integers(0, ROWS - 1)),
            min_size=1,
            max_size=most,
            unique=True,
        )
    )
    nudge = st.floats(-0.02, 0.02)
    balls = [
        {
            "id": "cue" if i == 0 else str(i),
            "position": [0.135 + PITCH * x + draw(nudge), 0.17 + PITCH * y + draw(nudge)],
        }
        for i, (x, y) in enumerate(cells)
    ]
    return {
        "format": "carom-shot/1",
        "table": "wpa-9ft",
        "balls": balls,
        "strike": {
            "ball": "cue",
            "speed": draw(speeds),
            "azimuth_deg": draw(degrees),
            "elevation_deg": draw(st.floats(0.0, 60.0)),
            "side": draw(offsets),
            "height": draw(offsets),
        },
    }


@EXAMPLES
@given(shots())
def test_json_keeps_every_bit_of_shots_and_traces(file: dict[str, Any]) -> None:
    shot = Shot.from_dict(file)
    assert shot.to_dict() == file
    assert Shot.from_json(shot.to_json()) == shot
    trace = shot.simulate()
    again = Trace.from_json(trace.to_json())
    assert trace.difference(again) is None
    assert again.shot.simulate().hash == trace.hash


@EXAMPLES
@given(st.lists(shots(), min_size=1, max_size=5))
def test_a_batch_equals_its_single_shots_for_any_threads(files: list[dict[str, Any]]) -> None:
    batch = [Shot.from_dict(file) for file in files]
    one = carom.simulate_batch(batch, threads=1)
    two = carom.simulate_batch(batch, threads=2)
    assert one.final_position.tobytes() == two.final_position.tobytes()
    assert one.pocket.tobytes() == two.pocket.tobytes()
    assert one.errors == two.errors == {}
    backwards = carom.simulate_batch(batch[::-1])
    assert backwards.final_position[::-1].tobytes() == one.final_position.tobytes()
    for index, shot in enumerate(batch):
        trace = shot.simulate()
        n = len(shot.ids)
        final = np.array([ball["position"] for ball in trace.to_dict()["final"]])
        assert one.final_position[index, :n].tobytes() == final.tobytes()
        assert one.events[index] == len(trace)


@EXAMPLES
@given(shots(most=6))
def test_a_mirrored_shot_moves_as_the_mirror_image(file: dict[str, Any]) -> None:
    mirrored = {
        **file,
        "balls": [
            {**ball, "position": [WIDTH - ball["position"][0], ball["position"][1]]}
            for ball in file["balls"]
        ],
        "strike": {
            **file["strike"],
            "azimuth_deg": 180.0 - file["strike"]["azimuth_deg"],
            "side": -file["strike"]["side"],
        },
    }
    # Mirroring rounds the positions, and each collision amplifies a rounding error ten- to a
    # hundredfold, so only the time before the third collision is compared.
    ours, theirs = Shot.from_dict(file).simulate(), Shot.from_dict(mirrored).simulate()
    collisions = [e["time"] for e in ours.events if e["type"] == "ball-collision"]
    until = collisions[2] if len(collisions) > 2 else ours.duration
    for time in np.linspace(0.0, 0.999 * until, 7):
        expected = ours.at(time).position * [-1, 1, 1] + [WIDTH, 0, 0]
        assert np.abs(theirs.at(time).position - expected).max() < 1e-7


@EXAMPLES
@given(shots())
def test_balls_never_overlap_and_all_end_at_rest(file: dict[str, Any]) -> None:
    trace = Shot.from_dict(file).simulate()
    for time in np.linspace(0.0, trace.duration, 40):
        state = trace.at(time)
        on = state.position[state.motion != "pocketed"]
        gaps = np.linalg.norm(on[:, None] - on[None], axis=2)
        gaps[np.diag_indices(len(on))] = math.inf
        assert len(on) < 2 or gaps.min() > 2 * RADIUS - 1e-12
    end = trace.at(trace.duration)
    assert set(end.motion) <= {"stationary", "pocketed", "off-table"}


# Any JSON value; some keys are those of the shot file.
_KEYS = st.sampled_from(
    ["format", "table", "physics", "balls", "strike", "id", "position", "base", "speed", "model"]
)
_VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=8)
    | st.sampled_from(["carom-shot/1", "wpa-9ft", "pool", "cue"]),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(_KEYS | st.text(max_size=5), inner, max_size=4)
    ),
    max_leaves=12,
)


@settings(EXAMPLES, max_examples=300)
@given(st.dictionaries(_KEYS | st.text(max_size=5), _VALUES, max_size=6))
def test_a_random_object_is_refused_with_a_message(file: dict[str, Any]) -> None:
    with pytest.raises(InputError) as refusal:
        Shot.from_dict(file)
    assert str(refusal.value)


@settings(EXAMPLES, max_examples=150)
@given(shots(most=3), st.data())
def test_a_shot_with_one_random_value_is_simulated_or_refused(
    file: dict[str, Any], data: st.DataObject
) -> None:
    target: Any = file
    while True:
        key = data.draw(
            st.sampled_from(sorted(target))
            if isinstance(target, dict)
            else st.integers(0, len(target) - 1)
        )
        if not isinstance(target[key], dict | list) or data.draw(st.booleans()):
            break
        target = target[key]
    target[key] = data.draw(_VALUES)
    try:
        shot = Shot.from_dict(file)
    except InputError:
        return
    assert math.isfinite(shot.simulate().duration)


@pytest.mark.stress
@settings(EXAMPLES, max_examples=20_000, derandomize=False)
@given(shots(most=15))
def test_many_more_shots_replay_and_batch_with_the_same_bits(file: dict[str, Any]) -> None:
    shot = Shot.from_dict(file)
    trace = shot.simulate()
    assert trace.difference(Trace.from_json(trace.to_json()).shot.simulate()) is None
    batch = carom.simulate_batch([shot])
    final = np.array([ball["position"] for ball in trace.to_dict()["final"]])
    assert batch.final_position[0].tobytes() == final.tobytes()
    assert batch.events[0] == len(trace)


@pytest.mark.stress
def test_a_million_breaks_end_and_do_not_depend_on_the_threads() -> None:
    speeds = np.linspace(0.5, 12.0, 1_000_000)
    for game in ("nine-ball", "eight-ball", "straight-pool", "snooker"):
        one = carom.break_shot(game).batch(speed=speeds, threads=1)
        all_cores = carom.break_shot(game).batch(speed=speeds)
        assert one.errors == all_cores.errors == {}
        assert one.final_position.tobytes() == all_cores.final_position.tobytes()
