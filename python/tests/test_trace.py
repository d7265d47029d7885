"""The trace, `carom-trace/1`: what it holds, exact states at any time, replay."""

from __future__ import annotations

import itertools
import json
import math
import pickle
from pathlib import Path
from typing import Any

import carom
import jsonschema
import numpy as np
import pytest
from carom import InputError, Shot, Trace
from carom.event_table import plain

ROOT = Path(__file__).parents[2]

# Tolerance of states between events, m and m/s: a few roundings of positions of a few metres, which
# closed forms give for times of a few seconds.
CLOSED_FORM_ROUNDING = 1e-12

# Physics with a jump cue: light, with a phenolic tip (TP A.30).
JUMP_CUE = {"cue": {"mass": 0.25, "tip_restitution": 0.87}, "contact_times": {"tip": 8e-4}}


def test_a_trace_has_the_documented_keys(pot: dict[str, Any]) -> None:
    trace = Shot.from_dict(pot).simulate().to_dict()
    assert trace["format"] == "carom-trace/1"
    assert trace["engine"].startswith("carom ")
    assert {"duration", "events", "final", "outcome", "hash"} <= trace.keys()
    assert len(trace["hash"]) == 16
    assert int(trace["hash"], 16) >= 0
    kinds = {event["type"] for event in trace["events"]}
    assert {"cue-strike", "ball-collision", "rail-collision", "motion-transition"} <= kinds
    impact = {"impulses", "points"}
    extra = {
        "cue-strike": {"tip_contacts", "pushed"} | impact,
        "ball-collision": impact,
        "slate-collision": impact,
        "rail-collision": {"rail", "part"} | impact,
        "pocket-collision": {"pocket"},
        "motion-transition": {"from", "to"},
    }
    for event in trace["events"]:
        assert event.keys() == {"time", "type", "balls", "before", "after"} | extra.get(
            event["type"], set()
        )
        for side in ("before", "after"):
            assert [ball["id"] for ball in event[side]] == event["balls"]
            for ball in event[side]:
                assert ball.keys() == {"id", "position", "velocity", "angular_velocity", "motion"}
    assert [ball["id"] for ball in trace["final"]] == ["cue", "1"]


def test_the_impulse_of_an_impact_is_the_change_of_momentum_at_its_point(
    pot: dict[str, Any],
) -> None:
    shot = Shot.from_dict(pot)
    trace = shot.simulate()
    mass, radius = dict(zip(shot.ids, shot.mass, strict=True)), shot.radius[0]
    impacts = [event for event in trace.events if "impulses" in event]
    assert {event.type for event in impacts} >= {"cue-strike", "ball-collision", "rail-collision"}
    for event in impacts:
        for ball, before, after, impulse in zip(
            event.balls, event.before, event.after, event.impulses, strict=True
        ):
            change = np.subtract(after["velocity"], before["velocity"])
            np.testing.assert_allclose(impulse, mass[ball] * change, rtol=0, atol=1e-15)
        place = event.before[0]["position"]
        assert abs(np.linalg.norm(np.subtract(event.points[0], place)) - radius) < 1e-9


def test_a_polyline_lies_on_the_path_of_a_ball(pot: dict[str, Any]) -> None:
    trace = Shot.from_dict(pot).simulate()
    line = trace.polyline("cue", 1e-3)
    np.testing.assert_array_equal(line, trace.polyline(0, 1e-3))
    assert line.shape[1] == 4
    np.testing.assert_allclose(line[:, :3], trace.at(line[:, 3]).position[:, 0], atol=1e-12)
    times = [event.time for event in trace.events if "cue" in event.balls]
    assert set(times) <= set(line[:, 3])
    assert len(trace.polyline("cue", 1e-6)) > len(line)
    # No chord is further than the tolerance from the path.
    for (x, y, _, t), (u, v, _, end) in itertools.pairwise(line):
        if end == t:
            continue
        middle = trace.at(0.5 * (t + end)).position[0, :2]
        across = (middle[0] - x) * (v - y) - (middle[1] - y) * (u - x)
        assert abs(across) <= 1e-3 * math.hypot(u - x, v - y) + 1e-12
    for ball, tolerance, place in (
        ("2", 1e-3, "ball"),
        (2, 1e-3, "ball"),
        (-1, 1e-3, "ball"),
        (0.5, 1e-3, "ball"),
        ("cue", 0.0, "tolerance"),
        ("cue", float("nan"), "tolerance"),
    ):
        with pytest.raises(InputError, match=rf"^{place}: "):
            trace.polyline(ball, tolerance)  # type: ignore[arg-type]


def strike_at(*balls: tuple[float, float], speed: float = 2.0) -> Trace:
    """A level strike straight up the table at balls with these gaps (m) and angles (rad)."""
    placed: list[dict[str, Any]] = [{"id": "cue", "position": [0.6, 0.6]}]
    for number, (gap, angle) in enumerate(balls, start=1):
        apart = 2 * 0.028575 + gap
        place = [0.6 + apart * math.sin(angle), 0.6 + apart * math.cos(angle)]
        placed.append({"id": str(number), "position": place})
    shot = {
        "format": "carom-shot/1",
        "table": "wpa-9ft",
        "balls": placed,
        "strike": {"ball": "cue", "speed": speed, "azimuth_deg": 90.0, "elevation_deg": 0.0},
    }
    return Shot.from_dict(shot).simulate()


def test_a_strike_into_a_frozen_ball_moves_both_balls_at_once() -> None:
    trace = strike_at((0.0, 0.0))
    strike = trace.events[0]
    assert (strike.type, strike.balls) == ("cue-strike", ["cue", "1"])
    assert (strike.tip_contacts, strike.pushed) == (1, False)
    assert trace.outcome.met_during_strike == ["1"]
    assert trace.outcome.first_contact == "1"
    start, soon = trace.at(0.0), trace.at(1e-3)
    for ball, after in enumerate(strike.after):
        assert list(start.velocity[ball]) == after["velocity"]
        moved = soon.position[ball] - start.position[ball]
        assert np.allclose(moved, 1e-3 * start.velocity[ball], rtol=1e-3, atol=1e-9)
    assert soon.position[1, 1] - soon.position[0, 1] > 2 * 0.028575, "they separate"
    assert Trace.from_json(trace.to_json()).outcome == trace.outcome


def test_the_table_of_events_names_a_push_and_a_double_hit() -> None:
    def first(trace: Trace) -> str:
        return plain(trace.to_dict()).splitlines()[1]

    assert "push" not in first(strike_at((0.0, 0.0)))
    assert "0.600, 0.600 push" in first(strike_at((1e-3, 0.0)))
    twice = strike_at((2e-3, math.radians(30)), speed=4.0)
    assert twice.outcome.tip_contacts == 2
    assert "0.600, 0.600 double hit" in first(twice)


def test_the_properties_agree_with_the_dict(nine_ball_trace: Trace) -> None:
    whole = nine_ball_trace.to_dict()
    assert nine_ball_trace.events == whole["events"]
    assert nine_ball_trace.outcome == whole["outcome"]
    assert nine_ball_trace.duration == whole["duration"]
    assert nine_ball_trace.hash == whole["hash"]
    assert len(nine_ball_trace) == len(whole["events"])
    assert nine_ball_trace.events[0].type == whole["events"][0]["type"] == "cue-strike"
    with pytest.raises(AttributeError, match="first_contact"):
        _ = nine_ball_trace.outcome.no_such_thing


def test_json_text_and_dict_are_equal_to_the_bit(nine_ball_trace: Trace) -> None:
    assert json.loads(nine_ball_trace.to_json()) == nine_ball_trace.to_dict()


def test_a_trace_goes_to_json_and_back_without_losing_a_bit(
    nine_ball_trace: Trace, tmp_path: Path
) -> None:
    nine_ball_trace.save(tmp_path / "trace.json")
    for again in (
        Trace.load(tmp_path / "trace.json"),
        Trace.from_json(nine_ball_trace.to_json()),
        Trace.from_dict(nine_ball_trace.to_dict()),
        pickle.loads(pickle.dumps(nine_ball_trace)),
    ):
        assert again == nine_ball_trace
        assert again.hash == nine_ball_trace.hash
        assert nine_ball_trace.difference(again) is None
        assert again.at(1.234).position.tobytes() == nine_ball_trace.at(1.234).position.tobytes()


def test_a_saved_trace_reproduces_bit_by_bit(nine_ball_trace: Trace) -> None:
    saved = Trace.from_json(nine_ball_trace.to_json())
    assert saved.difference(saved.shot.simulate()) is None


def test_the_first_changed_bit_is_found(nine_ball_trace: Trace) -> None:
    changed = nine_ball_trace.to_dict()
    place = changed["events"][5]["after"][0]["position"]
    place[0] = math.nextafter(place[0], math.inf)
    with pytest.raises(InputError, match="hash"):
        Trace.from_dict(changed)


def test_a_trace_cannot_be_constructed_directly() -> None:
    with pytest.raises(TypeError, match="simulate"):
        Trace()
    with pytest.raises(InputError, match=r"^format"):
        Trace.from_dict({})


def test_states_have_the_documented_shapes(nine_ball_trace: Trace) -> None:
    n = len(nine_ball_trace.shot.ids)
    now = nine_ball_trace.at(0.25)
    assert now.time == 0.25
    for array in (now.position, now.velocity, now.angular_velocity):
        assert array.shape == (n, 3)
        assert array.dtype == np.float64
    assert now.motion.shape == (n,)
    assert now.orientation.shape == (n, 4)
    several = nine_ball_trace.at([0.0, 0.25, 1.0])
    assert several.orientation.shape == (3, n, 4)
    assert several.position.shape == (3, n, 3)
    assert several.motion.shape == (3, n)
    assert (several.position[1] == now.position).all()
    assert (several.motion[1] == now.motion).all()
    assert nine_ball_trace.at([]).position.shape == (0, n, 3)


def test_at_the_instant_of_an_event_the_state_is_the_one_after_it(nine_ball_trace: Trace) -> None:
    ids = nine_ball_trace.shot.ids
    last = {}
    for event in nine_ball_trace.events:
        for ball in event["after"]:
            last[(ball["id"], event["time"])] = ball
    for (ball_id, time), ball in last.items():
        state = nine_ball_trace.at(time)
        index = ids.index(ball_id)
        assert state.position[index].tolist() == ball["position"]
        assert state.velocity[index].tolist() == ball["velocity"]
        assert state.angular_velocity[index].tolist() == ball["angular_velocity"]
        assert state.motion[index] == ball["motion"]


def test_the_orientation_of_a_rolling_ball_matches_its_path() -> None:
    """The rotation of a ball that rolls by a vector: about the axis to its left, by length / R."""
    radius, speed = 0.028575, 1.0
    ball = {
        "id": "cue",
        "position": [0.0, 0.0],
        "velocity": [speed, 0.0, 0.0],
        "angular_velocity": [0.0, speed / radius, 0.0],
        "radius": radius,
    }
    file = {"format": "carom-shot/1", "table": {"cloth": "unbounded"}, "balls": [ball]}
    trace = Shot.from_dict(file).simulate()
    states = trace.at(np.linspace(0.0, trace.duration, 50))
    half = states.position[:, 0, 0] / radius / 2.0
    expected = np.stack([0.0 * half, np.sin(half), 0.0 * half, np.cos(half)], axis=1)
    turned = states.orientation[:, 0, :]
    assert np.allclose(np.abs(np.sum(turned * expected, axis=1)), 1.0, atol=CLOSED_FORM_ROUNDING)
    assert turned[0].tolist() == [0.0, 0.0, 0.0, 1.0]


def test_the_path_between_events_ends_where_the_next_event_begins(nine_ball_trace: Trace) -> None:
    ids = nine_ball_trace.shot.ids
    for event in nine_ball_trace.events:
        just_before = nine_ball_trace.at(math.nextafter(event["time"], 0.0))
        for ball in event["before"]:
            index = ids.index(ball["id"])
            if event["time"] == 0.0:
                continue
            gap = np.abs(just_before.position[index] - ball["position"]).max()
            assert gap < CLOSED_FORM_ROUNDING


def test_after_the_end_the_state_is_constant(nine_ball_trace: Trace) -> None:
    for time in (nine_ball_trace.duration, nine_ball_trace.duration + 100.0):
        state = nine_ball_trace.at(time)
        for index, ball in enumerate(nine_ball_trace.to_dict()["final"]):
            assert state.position[index].tolist() == ball["position"]
            assert state.motion[index] == ball["motion"]
        assert not state.velocity.any()


@pytest.mark.parametrize("time", [-1.0, math.nan, math.inf, "soon", "0.5", True, [[0.0]], None])
def test_bad_times_are_refused(nine_ball_trace: Trace, time: Any) -> None:
    with pytest.raises(InputError, match=r"^time: "):
        nine_ball_trace.at(time)


def test_a_trace_prints_as_a_table_of_its_events(pot: dict[str, Any]) -> None:
    trace = Shot.from_dict(pot).simulate()
    lines = str(trace).splitlines()
    assert lines[0].split() == ["time", "s", "event", "balls", "where", "speed", "m/s"]
    for line, event in zip(lines[1:], trace.events, strict=False):
        assert event["type"] in line
        assert f"{event['time']:.4f}" in line
    assert f"{len(trace)} events" in str(trace)
    assert trace.hash in str(trace)
    assert repr(trace) == (
        f"<carom.Trace: {len(trace)} events in {trace.duration:.3f} s, hash {trace.hash}>"
    )


def test_events_are_in_order_of_time(nine_ball_trace: Trace) -> None:
    times = [event["time"] for event in nine_ball_trace.events]
    assert times == sorted(times)
    assert times[0] == 0.0
    assert nine_ball_trace.duration == times[-1]


def test_positions_stay_finite_after_pocketing() -> None:
    trace = Shot.load(ROOT / "shots" / "side_pocket_cut.json").simulate()
    fallen = [b for b in trace.to_dict()["final"] if b["motion"] == "pocketed"]
    assert fallen
    assert all(math.isfinite(x) for ball in fallen for x in ball["position"])
    assert trace.outcome["pocketed"] == [
        [e["balls"][0], e["pocket"]] for e in trace.events if e["type"] == "pocket-collision"
    ]


def test_the_outcome_names_the_first_contact(nine_ball_trace: Trace) -> None:
    first = next(e for e in nine_ball_trace.events if e["type"] == "ball-collision")
    assert nine_ball_trace.outcome["first_contact"] in first["balls"]


def _simulated(balls: list[dict[str, Any]], **more: Any) -> Trace:
    file = {"format": "carom-shot/1", "table": "wpa-9ft", "balls": balls, **more}
    return Shot.from_dict(file).simulate()


def test_the_outcome_gives_the_least_clear_elevation() -> None:
    cue = {"id": "cue", "position": [0.635, 0.06]}
    strike = {"ball": "cue", "speed": 1.0, "azimuth_deg": 90.0, "elevation_deg": 0.0}
    level = _simulated([cue], strike=strike)
    assert level.outcome.cue_obstructed == "bottom"
    least = level.outcome.least_elevation_deg
    raised = _simulated([cue], strike={**strike, "elevation_deg": least})
    assert raised.outcome.cue_obstructed is None
    assert raised.outcome.least_elevation_deg == least
    assert "would pass through: bottom; at 13.7° it would not" in str(level)
    with pytest.raises(InputError, match=r"the bottom rail; raise the elevation to 13\.67 degrees"):
        _simulated([cue], strike={**strike, "obstruction": "refuse"})


def test_the_outcome_names_a_ball_that_hangs_over_a_pocket() -> None:
    # Its centre 1 cm short of the hole of the bottom left pocket.
    corner = next(t for t in carom.tables() if t["name"] == "wpa-9ft")["pockets"][0]
    x = corner["center"][0] + (corner["radius"] + 0.01) / math.sqrt(2.0)
    trace = _simulated([{"id": "8", "position": [x, x]}])
    assert trace.outcome.hanging == [["8", "bottom-left"]]
    assert "hanging: 8 (bottom-left)" in str(trace)


def test_the_table_of_events_ends_with_balls_off_the_table_and_jumps() -> None:
    still = {
        "position": [0.5, 0.5, 0.028575],
        "velocity": [0.0, 0.0, 0.0],
        "motion": "off-table",
    }
    trace = {
        "events": [
            {
                "time": 1.0,
                "type": "off-table",
                "balls": ["cue"],
                "before": [still],
                "after": [still],
            }
        ],
        "duration": 1.0,
        "hash": "0",
        "outcome": {"off_table": ["cue"], "jumped": [["cue", "1"]], "hanging": []},
    }
    lines = plain(trace).splitlines()
    assert lines[1].split() == ["1", "1.0000", "off-table", "cue", "0.500,", "0.500", "0.00"]
    assert lines[-2:] == ["off the table: cue", "jumped: cue over 1"]


def test_the_table_of_events_gives_heights_and_rises() -> None:
    lines = str(Shot.load(ROOT / "shots" / "off_the_table.json").simulate()).splitlines()
    # The ball leaves the slate while the tip is on it.
    jump, off = lines[1], lines[2]
    rise = int(jump.split("↑")[1].split()[0])
    trace = Shot.load(ROOT / "shots" / "off_the_table.json").simulate()
    heights = trace.at(np.linspace(0.0, trace.duration, 2001)).position[:, 0, 2]
    assert abs(1000 * (heights.max() - heights[0]) - rise) <= 0.51
    x, y, z = trace.events[-1].before[0]["position"]
    assert f"{x:.3f}, {y:.3f}, {z:.3f}" in off


def test_a_ball_that_tips_over_a_lip_takes_one_line_of_the_table() -> None:
    # 0.6 mm before the edge of the hole, while another ball rolls elsewhere.
    slow = {"id": "1", "position": [1.2578, 2.5278], "velocity": [0.06, 0.06, 0.0]}
    other = {"id": "2", "position": [0.6, 1.5], "velocity": [0.5, 0.0, 0.0]}
    trace = _simulated([slow, other])
    hops = [e for e in trace.events if e.type == "slate-collision" and e.balls == ["1"]]
    assert len(hops) > 20
    lines = [line for line in str(trace).splitlines() if "slate-collision" in line]
    assert len(lines) == 1
    assert f"{len(hops)} hops on the lip" in lines[0]
    table = str(trace).split("\n\n")[0].splitlines()[1:]
    numbers = [int(line.split()[0]) for line in table]
    # The other events keep their numbers.
    assert len(numbers) == len(trace) - len(hops) + 1
    assert [line.split()[2] for line in table] == [trace.events[i - 1].type for i in numbers]
    assert len(trace.to_dict()["events"]) == len(trace)


def test_a_jump_shot_and_a_ball_off_the_table_are_in_the_outcome() -> None:
    cue = {"id": "cue", "position": [0.635, 0.6]}
    blocker = {"id": "1", "position": [0.635, 0.8]}
    strike = {"ball": "cue", "speed": 5.0, "azimuth_deg": 90.0, "elevation_deg": 50.0}
    jump = _simulated([cue, blocker], strike=strike, physics=JUMP_CUE)
    assert jump.outcome.jumped[0] == ["cue", "1"]
    flying = {"id": "2", "position": [0.3, 0.8, 0.1], "velocity": [-3.0, 0.0, 1.5]}
    off = _simulated([flying, blocker])
    assert off.outcome.off_table == ["2"]
    assert off.events[-1].type == "off-table"
    jsonschema.validate(off.to_dict(), carom.schema("trace"))
    jsonschema.validate(jump.to_dict(), carom.schema("trace"))
    assert Trace.from_dict(jump.to_dict()).outcome == jump.outcome
