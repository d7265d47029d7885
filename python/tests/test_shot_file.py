"""The shot file, `carom-shot/1`: reading, writing, and every refusal."""

from __future__ import annotations

import copy
import json
import math
import pickle
import re
from pathlib import Path
from typing import Any

import carom
import numpy as np
import pytest
from carom import InputError, Layout, Physics, Shot, Strike, Table


def test_a_shot_can_be_loaded_from_a_file_a_dict_or_text(
    pot: dict[str, Any], tmp_path: Path
) -> None:
    path = tmp_path / "shot.json"
    path.write_text(json.dumps(pot))
    assert Shot.load(path) == Shot.from_dict(pot) == Shot.from_json(json.dumps(pot))


def test_a_shot_goes_to_json_and_back_without_losing_a_bit(pot: dict[str, Any]) -> None:
    pot["balls"][0]["position"] = [0.1 + 0.2, math.nextafter(0.7, 1.0)]
    pot["strike"]["azimuth_deg"] = 100 / 3
    shot = Shot.from_dict(pot)
    again = Shot.from_json(shot.to_json())
    assert again.to_dict() == shot.to_dict()
    assert again.simulate().hash == shot.simulate().hash


def test_a_saved_shot_loads_as_the_same_shot(pot: dict[str, Any], tmp_path: Path) -> None:
    shot = Shot.from_dict(pot)
    shot.save(tmp_path / "saved.json")
    assert Shot.load(tmp_path / "saved.json") == shot


def test_a_shot_can_be_sent_to_another_process(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    assert pickle.loads(pickle.dumps(shot)) == shot


def test_a_track_stays_with_the_shot(pot: dict[str, Any]) -> None:
    assert Shot.from_dict(pot).track == {}
    samples = [[-0.04, 0.7, 1.0], [0.0, 0.7, 1.0], [0.04, 0.71, 1.0]]
    track = [{"ball": "1", "samples": samples}]
    shot = Shot.from_dict(pot | {"track": track})
    assert shot.to_dict()["track"] == track
    assert shot == Shot.from_dict(pot)
    for same in (shot, pickle.loads(pickle.dumps(shot)), shot.with_strike(speed=1.0)):
        assert same.track["1"].tolist() == samples
    with pytest.raises(InputError, match=r"^track\[0\].ball: no ball has the id"):
        Shot.from_dict(pot | {"track": [{"ball": "9", "samples": samples}]})


def test_marks_stay_with_the_shot(pot: dict[str, Any]) -> None:
    assert Shot.from_dict(pot).marks == []
    marks = [
        {"kind": "arrow", "color": "yellow", "from": [0.4, 0.6], "to": [0.9, 1.8]},
        {"kind": "label", "color": "white", "at": [0.4, 0.5], "text": "½ ball"},
    ]
    shot = Shot.from_dict(pot | {"marks": marks})
    assert shot.to_dict()["marks"] == marks
    assert shot == Shot.from_dict(pot)
    for same in (shot, pickle.loads(pickle.dumps(shot)), shot.with_strike(speed=1.0)):
        assert same.marks == marks
    with pytest.raises(InputError, match=r"^marks\[0\].kind: there is no kind of mark"):
        Shot.from_dict(pot | {"marks": [{"kind": "star", "color": "red"}]})


def test_numpy_scalars_and_arrays_are_accepted_as_numbers(pot: dict[str, Any]) -> None:
    pot["balls"][1]["position"] = [0.635, 1.5]
    plain = Shot.from_dict(pot)
    pot["balls"][0]["position"] = np.array([0.635, 0.635])
    pot["strike"]["speed"] = np.float64(2.0)
    pot["balls"][1]["position"] = [np.array(0.635), np.float32(1.5)]
    pot["max_events"] = np.int64(100_000)
    assert Shot.from_dict(pot).simulate().hash == plain.simulate().hash


def test_a_shot_can_be_built_from_its_parts(pot: dict[str, Any]) -> None:
    built = Shot(
        Table("wpa-9ft"),
        Layout.at({"cue": (0.635, 0.635), "1": (0.635, 1.905)}),
        Strike(speed=2.0, azimuth=math.radians(90.0), elevation=0.0),
        physics=Physics("pool"),
    )
    assert built.simulate().hash == Shot.from_dict(pot).simulate().hash


def test_parts_change_only_the_named_keys() -> None:
    fast = Shot(
        Table.rectangle(length=2.0, width=1.0),
        {"cue": (0.5, 0.5)},
        Strike(speed=1.0, azimuth=math.pi / 2),
        physics=Physics.preset("pool", cloth={"rolling_friction": 0.005}),
    )
    slow = Shot(
        Table.rectangle(length=2.0, width=1.0),
        {"cue": (0.5, 0.5)},
        Strike(speed=1.0, azimuth=math.pi / 2),
        physics=Physics.preset("pool", cloth={"rolling_friction": 0.01}),
    )
    assert fast.simulate().duration > slow.simulate().duration


def test_a_shot_has_a_short_description(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    assert shot.ids == ["cue", "1"]
    assert shot.radius.tolist() == [0.028575, 0.028575]
    assert shot.mass.shape == (2,)
    assert repr(shot) == "<carom.Shot: 2 balls on wpa-9ft>"


def test_balls_without_strike_start_with_their_own_velocities(endless: dict[str, Any]) -> None:
    trace = Shot.from_dict(endless).simulate()
    assert [e["type"] for e in trace.events].count("cue-strike") == 0
    assert trace.at(0.0).velocity[0].tolist() == [1.5, 0.0, 0.0]


def _set(*path: Any, to: Any) -> Any:
    def change(file: dict[str, Any]) -> None:
        target: Any = file
        for key in path[:-1]:
            target = target[key]
        target[path[-1]] = to

    return change


REFUSED = {
    "an unknown key": (_set("balls", 1, "colour", to="red"), "balls[1].colour"),
    "an unknown key at the top": (_set("tables", to="wpa-9ft"), "tables"),
    "a wrong type": (_set("strike", "speed", to="fast"), "strike.speed"),
    "a bool for a number": (_set("strike", "speed", to=True), "strike.speed"),
    "null for a number": (_set("strike", "speed", to=None), "strike.speed"),
    "a NaN": (_set("balls", 0, "position", 1, to=math.nan), "balls[0].position"),
    "an infinite number": (_set("strike", "azimuth_deg", to=math.inf), "strike.azimuth_deg"),
    "overlapping balls": (_set("balls", 1, "position", to=[0.635, 0.655]), "balls[1]"),
    "a ball outside the table": (_set("balls", 1, "position", to=[5.0, 5.0]), "balls[1].position"),
    "a ball inside a rail": (_set("balls", 1, "position", to=[0.635, 0.01]), "balls[1].position"),
    "a tip offset off the ball": (_set("strike", "side", to=1.2), "strike.side"),
    "a miscue": (_set("strike", "height", to=0.9), "strike.height"),
    "a negative mass": (_set("balls", 0, "mass", to=-0.1), "balls[0].mass"),
    "a radius of zero": (_set("balls", 0, "radius", to=0.0), "balls[0].radius"),
    "a speed of zero": (_set("strike", "speed", to=0.0), "strike.speed"),
    "a speed above 50 m/s": (_set("strike", "speed", to=50.1), "strike.speed"),
    "an elevation of 90°": (_set("strike", "elevation_deg", to=90.0), "strike.elevation_deg"),
    "a restitution above 1": (
        _set("physics", to={"ball_ball": {"restitution": 1.1}}),
        "physics.ball_ball.restitution",
    ),
    "a negative friction": (
        _set("physics", to={"cloth": {"rolling_friction": -0.01}}),
        "physics.cloth.rolling_friction",
    ),
    "a model that does not exist": (
        _set("physics", to={"cushion": {"model": "han-2006"}}),
        "physics.cushion.model",
    ),
    "a table that does not exist": (_set("table", to="wpa-10ft"), "table"),
    "a physics preset that does not exist": (_set("physics", to="billiards"), "physics"),
    "no balls": (_set("balls", to=[]), "balls"),
    "two balls with one id": (_set("balls", 1, "id", to="cue"), "balls[1].id"),
    "a strike on a ball that is not there": (_set("strike", "ball", to="7"), "strike.ball"),
    "a strike on a moving ball": (
        _set("balls", 0, "velocity", to=[1.0, 0.0, 0.0]),
        "strike",
    ),
    "a velocity above 100 m/s": (
        _set("balls", 1, "velocity", to=[101.0, 0.0, 0.0]),
        "balls[1].velocity",
    ),
    "a spin above 10 000 rad/s": (
        _set("balls", 1, "angular_velocity", to=[0.0, 0.0, 10_001.0]),
        "balls[1].angular_velocity",
    ),
    "a position of one number": (_set("balls", 1, "position", to=[0.5]), "balls[1].position"),
    "another format": (_set("format", to="carom-shot/9"), "format"),
    "a cap of no events": (_set("max_events", to=0), "max_events"),
}


@pytest.mark.parametrize("what", REFUSED)
def test_bad_input_is_refused_with_one_sentence_that_names_the_place(
    what: str, pot: dict[str, Any]
) -> None:
    change, place = REFUSED[what]
    Shot.from_dict(copy.deepcopy(pot))
    change(pot)
    with pytest.raises(InputError) as refusal:
        Shot.from_dict(pot)
    message = str(refusal.value)
    assert message.startswith(place)
    assert "\n" not in message
    # The fault and the remedy.
    assert ";" in message


def test_every_error_is_a_carom_error_and_bad_input_also_a_value_error() -> None:
    assert issubclass(carom.InputError, carom.CaromError)
    assert issubclass(carom.InputError, ValueError)
    assert issubclass(carom.EventCapError, carom.CaromError)
    assert not issubclass(carom.EventCapError, ValueError)


def test_a_missing_key_is_named(pot: dict[str, Any]) -> None:
    for key in ("format", "table", "balls"):
        broken = copy.deepcopy(pot)
        del broken[key]
        with pytest.raises(InputError, match=f"^{key}: "):
            Shot.from_dict(broken)


def test_a_duplicate_key_is_refused_with_its_place() -> None:
    text = """{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
               "balls": [{"id": "a", "position": [0, 0], "id": "b"}]}"""
    with pytest.raises(InputError, match=r"^balls\[0\].id: .*twice"):
        Shot.from_json(text)


def test_a_nan_in_a_file_is_refused_with_its_place() -> None:
    text = """{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
               "balls": [{"id": "a", "position": [0, NaN]}]}"""
    with pytest.raises(InputError, match=r"^balls\[0\].position.*finite"):
        Shot.from_json(text)


def test_invalid_json_is_refused_with_its_line() -> None:
    with pytest.raises(InputError, match=r"^not JSON: .* \(line 2, column 2\); correct"):
        Shot.from_json('{"format": "carom-shot/1",\n oops}')


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ('{"format": "carom-shot/1",\n oops}', r"not JSON: .*\(line 2, column 2\)"),
        ('{"balls": [\n{"id": "a", "id": "b"}]}', r"balls\[0\]\.id: .*\(line 2, column \d+\)"),
        ('{"max_events":\n NaN}', r"max_events: NaN \(line 2, column \d+\)"),
        ('{"max_events":\n 1e999}', r"max_events: .*too large.*\(line 2, column \d+\)"),
        ("", r"not JSON: .*\(line 1, column 0\)"),
    ],
)
def test_the_error_of_a_syntax_fault_names_the_file_the_line_and_the_column(
    text: str, fault: str, tmp_path: Path
) -> None:
    path = tmp_path / "broken.json"
    path.write_text(text, encoding="utf-8")
    for kind in (Shot, carom.Trace, carom.Sweep):
        with pytest.raises(InputError, match=f"^{re.escape(str(path))}: {fault}"):
            kind.load(path)


@pytest.mark.parametrize("text", ['"\ud800"', b"{}", None])
def test_text_that_is_not_unicode_is_refused(text: Any) -> None:
    for kind in (Shot, carom.Trace):
        with pytest.raises(InputError, match=r"^text: .*; write"):
            kind.from_json(text)


@pytest.mark.parametrize("place", [5, None, "ab"])
def test_a_ball_without_a_position_is_refused_with_its_place(place: Any) -> None:
    with pytest.raises(InputError, match=r"^balls\[0\].position: found"):
        Shot("wpa-9ft", {"cue": place})


def test_a_binary_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "picture.json"
    path.write_bytes(b"\x89PNG\xff\xfe")
    with pytest.raises(InputError, match="UTF-8"):
        Shot.load(path)


def test_an_unexpected_object_in_a_dict_is_refused_with_its_place(pot: dict[str, Any]) -> None:
    pot["balls"][1]["position"] = object()
    with pytest.raises(InputError, match=r"^balls\[1\].position: found a object"):
        Shot.from_dict(pot)
    pot["balls"][1]["position"] = b"ab"
    with pytest.raises(InputError, match=r"^balls\[1\].position: found bytes"):
        Shot.from_dict(pot)
    with pytest.raises(InputError, match="not a string"):
        Shot.from_dict({1: 2})  # type: ignore[dict-item]


@pytest.mark.parametrize(
    ("position", "found"),
    [
        ([np.True_, 1.0], r"\[0\]: found true"),
        ({0.5, 1.0}, ": found a set"),
        (frozenset({0.5, 1.0}), ": found a frozenset"),
    ],
)
def test_truth_values_and_sets_are_refused_as_numbers_and_lists(
    pot: dict[str, Any], position: Any, found: str
) -> None:
    pot["balls"][1]["position"] = position
    with pytest.raises(InputError, match=rf"^balls\[1\].position{found}"):
        Shot.from_dict(pot)


@pytest.mark.parametrize("azimuth", ["north", None, math.nan, 10**400])
def test_a_strike_without_a_direction_is_refused_with_its_place(azimuth: Any) -> None:
    with pytest.raises(InputError, match=r"^strike\.azimuth:"):
        Shot("wpa-9ft", {"cue": (0.6, 0.6)}, Strike(speed=1.0, azimuth=azimuth))


def test_with_strike_changes_only_the_given_values(pot: dict[str, Any]) -> None:
    pot["strike"] |= {"height": 0.25, "obstruction": "refuse"}
    shot = Shot.from_dict(pot)
    assert shot.with_strike() == shot
    pot["strike"] |= {"speed": 3.5, "side": -0.125, "azimuth_deg": 12.25, "elevation_deg": 8.0}
    struck = shot.with_strike(
        speed=3.5, azimuth=math.radians(12.25), side=-0.125, elevation=math.radians(8.0)
    )
    assert struck.to_dict() == pot
    assert shot.to_dict()["strike"]["speed"] == 2.0


def test_with_strike_agrees_with_batch_to_the_bit(pot: dict[str, Any]) -> None:
    shot = Shot.from_dict(pot)
    for step in range(40):
        asked = {"speed": 1.0 + 0.1 * step, "azimuth": 1.4 + 0.01 * step, "side": 0.01 * step}
        struck = shot.with_strike(**asked, elevation=0.003 * step)
        assert struck.azimuth is not None
        assert abs(struck.azimuth - asked["azimuth"]) <= math.ulp(asked["azimuth"])
        angles = {"azimuth": struck.azimuth, "elevation": struck.elevation}
        ends = shot.batch(**(asked | angles))
        final = [state["position"] for state in struck.simulate().to_dict()["final"]]
        assert ends.final_position[0].tolist() == final
        assert Shot.from_json(struck.to_json()).azimuth == struck.azimuth
        assert struck.with_strike(**angles) == struck


@pytest.mark.parametrize(
    ("strike", "place"),
    [
        ({"speed": "fast"}, "speed: "),
        ({"speed": 0.0}, "strike.speed: "),
        ({"azimuth": math.nan}, "strike.azimuth: "),
        ({"elevation": -0.1}, "strike.elevation: "),
        ({"side": 0.9}, "strike.side: a miscue"),
    ],
)
def test_a_strike_that_cannot_be_played_is_refused(
    pot: dict[str, Any], strike: dict[str, Any], place: str
) -> None:
    with pytest.raises(InputError, match=f"^{place}"):
        Shot.from_dict(pot).with_strike(**strike)


def test_with_strike_of_a_shot_without_a_strike_is_refused(endless: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=r"^strike: the shot has no strike"):
        Shot.from_dict(endless).with_strike(speed=1.0)


def test_a_list_that_contains_itself_is_refused(pot: dict[str, Any]) -> None:
    loop: list[Any] = []
    loop.append(loop)
    pot["balls"] = loop
    with pytest.raises(InputError, match="nested too deeply"):
        Shot.from_dict(pot)


def test_reaching_the_cap_of_events_is_an_error_with_the_shot(pot: dict[str, Any]) -> None:
    pot["max_events"] = 3
    with pytest.raises(carom.EventCapError, match="3 events") as error:
        Shot.from_dict(pot).simulate()
    assert Shot.from_dict(error.value.shot) == Shot.from_dict(pot)
    trace = error.value.trace
    assert (len(trace), trace.end) == (3, "cap")
    assert carom.Trace.from_dict(trace.to_dict()) == trace
    again = pickle.loads(pickle.dumps(error.value))
    assert (again.shot, again.trace) == (error.value.shot, trace)
    assert str(again) == str(error.value)
    assert not isinstance(error.value, InputError)


_SMOOTH = {"sliding_friction": 0, "rolling_friction": 0, "spin_deceleration": 0}


def _endless(**more: Any) -> Shot:
    balls = {"cue": (0.5, 0.5), "1": (0.5, 1.5)}
    strike = carom.Strike(1.0, 0.65, elevation=0.0)
    table = {"length": 2, "width": 1, "pockets": "none"}
    return Shot(table, balls, strike, physics={"base": "ideal", "cloth": _SMOOTH}, **more)


def test_motion_without_an_end_is_bad_input_and_gives_the_trace_so_far() -> None:
    # Seen: exit code 1, "report the shot file", for balls that no friction can stop.
    shot = _endless(max_events=100)
    with pytest.raises(
        InputError, match=r'^until: no friction stops ball "cue".*write the time'
    ) as e:
        shot.simulate()
    assert isinstance(e.value, carom.EndlessMotionError)
    assert len(e.value.trace) == 100
    assert pickle.loads(pickle.dumps(e.value)).trace == e.value.trace
    result = shot.batch(speed=[1.0, 2.0])
    assert all(text.startswith("until: ") for text in result.errors.values())
    assert len(result.errors) == 2


def test_a_shot_with_an_end_time_ends_there_everywhere() -> None:
    shot = _endless(until=3.0)
    trace = shot.simulate()
    assert (shot.until, trace.end, trace.duration) == (3.0, "until", 3.0)
    assert trace.to_dict()["end"] == "until"
    np.testing.assert_array_equal(trace.at(3.0).position, trace.at(99.0).position)
    final = [ball["position"] for ball in trace.to_dict()["final"]]
    np.testing.assert_array_equal(final, trace.at(3.0).position)
    np.testing.assert_array_equal(carom.simulate_batch([shot]).final_position[0], final)
    np.testing.assert_array_equal(shot.batch(speed=[1.0]).final_position[0], final)
    assert shot.with_strike(speed=2.0).simulate().duration == 3.0
    assert "ends at its end time; still moving: cue" in str(trace)
    assert pickle.loads(pickle.dumps(shot)) == shot == Shot.from_dict(shot.to_dict())
    assert shot.with_until(None).until is None
    for wrong in (0.0, -1.0, float("nan"), "soon"):
        with pytest.raises(InputError, match=r"^until: "):
            shot.with_until(wrong)  # type: ignore[arg-type]
        with pytest.raises(InputError, match=r"^until: "):
            _endless(until=wrong)


def test_questions_of_a_shot_follow_its_end_time() -> None:
    shot = Shot.load("shots/bank_shot.json")
    falls = next(e.time for e in shot.simulate().events if e.type == "pocket-collision")
    noise = carom.Noise(speed=0.0, azimuth=0.0, elevation=0.0, side_m=0.0, height_m=0.0)
    for until, potted in ((falls - 1e-6, 0), (falls, 5)):
        evaluation = shot.with_until(until).evaluate(noise, n=5)
        assert evaluation.potted.sum() == potted
        batch = shot.with_until(until).batch(azimuth=[shot.azimuth])
        assert 5 * (batch.pocket >= 0).sum() == potted


def test_the_rules_of_a_game_do_not_judge_a_shot_that_is_cut_off(pot: dict[str, Any]) -> None:
    frame = carom.Frame.of_shot("practice", carom.break_shot("eight-ball").with_until(0.1))
    assert frame.shot(carom.Strike(1.0, 1.5)).until is None
    game = carom.Frame("nine-ball")
    asked = game.shot(carom.Strike(8.0, 1.57), cue_ball=(0.635, 0.6)).with_until(0.5)
    with pytest.raises(InputError, match=r"^until: .*at rest; leave it out"):
        asked.evaluate(carom.Noise.preset("club"), frame=game, n=10)
