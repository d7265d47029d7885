"""The kinds of errors: each has a case, and docs and page list the same ones."""

import contextlib
import copy
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import carom
import pytest
from carom import _core, streams
from carom.lock import locked

ROOT = Path(__file__).parents[2]
KINDS = {name: (sentence, details) for name, sentence, details in _core.error_kinds()}

FILE: dict[str, Any] = {
    "format": "carom-shot/1",
    "table": "wpa-9ft",
    "balls": [{"id": "cue", "position": [0.6, 0.6]}, {"id": "1", "position": [0.6, 1.8]}],
    "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 90},
}
STRIKE = carom.Strike(speed=2.0, azimuth_deg=90)


def shot(balls: Any = None, strike: Any = None, **keys: Any) -> carom.Shot:
    """The shot of ``FILE`` with other values: of the file, its second ball, and its strike."""
    file = copy.deepcopy(FILE) | keys
    if balls is not None:
        file["balls"][1] |= balls
    if strike is not None:
        file["strike"] |= strike
    return carom.Shot.from_dict(file)


def changed_trace() -> carom.Trace:
    trace = shot().simulate().to_dict()
    trace["hash"] = "0" * len(trace["hash"])
    return carom.Trace.from_dict(trace)


def played(game: str) -> carom.Frame:
    """A frame whose cue ball is not in hand."""
    frame = carom.Frame.of_shot(game, shot({"id": "9"}))
    assert frame.request["in_hand"] is None
    return frame


def over() -> carom.Frame:
    frame = carom.Frame("nine-ball")
    frame.concede()
    return frame


def replayed(*moves: Any) -> carom.Frame:
    return carom.Frame.replay(carom.Frame("nine-ball").record | {"moves": list(moves)})


def refused_break() -> carom.Frame:
    """A frame that asks what to do after a break that was too soft."""
    frame = carom.Frame("eight-ball", seed=1)
    frame.play(carom.Strike(speed=0.5, azimuth_deg=90), cue_ball=(0.6, 0.6))
    assert frame.request["kind"] == "choice"
    return frame


def after_scratch() -> carom.Frame:
    frame = carom.Frame("nine-ball")
    frame.play(carom.Strike(2.0, azimuth_deg=-135), cue_ball=(0.3, 0.3))
    assert frame.request["in_hand"] == "anywhere"
    return frame


def on_colors() -> carom.Frame:
    """A frame of snooker after a red was potted."""
    file = carom.Frame("snooker").shot(STRIKE, cue_ball=(0.8, 0.5)).to_dict()
    balls = {ball["id"]: ball for ball in file["balls"]}
    balls["red-1"]["position"] = [0.12, 3.45]
    balls["cue"]["position"] = [0.3, 3.2]
    frame = carom.Frame.of_shot("snooker", carom.Shot.from_dict(file))
    (pot,) = frame.shot(STRIKE).solve(pot=("red-1", "top-left"), wanted=1, n=50, samples=256)
    frame.play(carom.Strike(pot.speed, pot.azimuth, pot.elevation, pot.side, pot.height))
    return frame


def endless() -> carom.Trace:
    smooth = {"sliding_friction": 0, "rolling_friction": 0, "spin_deceleration": 0}
    return shot(physics={"base": "ideal", "cloth": smooth}, max_events=100).simulate()


def locked_twice() -> None:
    with TemporaryDirectory() as name:
        folder = Path(name)
        with locked(folder, "sweep"), locked(folder, "sweep"):
            pass


def emitted_to_nothing() -> None:
    with contextlib.redirect_stdout(None):
        streams.emit("text")


CASES: dict[str, Callable[[], Any]] = {
    "syntax": lambda: carom.Shot.from_json("{"),
    "format": lambda: shot(format="carom-trace/1"),
    "missing": lambda: carom.Shot.from_dict(FILE | {"balls": [{"id": "cue"}]}),
    "unknown-key": lambda: shot(wind=3),
    "wrong-type": lambda: shot(table=3),
    "unknown-name": lambda: carom.break_shot("croquet"),
    "unknown-ball": lambda: shot(strike={"ball": "9"}),
    "out-of-range": lambda: shot(strike={"speed": 60}),
    "wrong-count": lambda: shot({"position": [1.0]}),
    "duplicate": lambda: shot(strike={"azimuth": 1.0}),
    "conflict": lambda: shot(
        {"velocity": [1, 0, 0], "rolling": True, "angular_velocity": [0, 0, 1]}, strike={}
    ),
    "mismatch": lambda: carom.Frame.of_shot("nine-ball", shot({"mass": 0.2})),
    "changed": changed_trace,
    "wrong-table": lambda: shot(table={"base": "wpa-9ft", "corner_pocket": {"mouth": 0.01}}),
    "unsupported": lambda: carom.Frame("eight-ball", table="carom-10ft"),
    "wrong-state": lambda: carom.Frame("nine-ball").choose("rebreak"),
    "ball-count": lambda: carom.Shot.from_dict({**FILE, "balls": []}),
    "duplicate-id": lambda: shot({"id": "cue"}),
    "overlap": lambda: shot({"position": [0.6, 0.61]}),
    "in-cushion": lambda: shot({"position": [0.01, 0.8]}),
    "over-pocket": lambda: shot({"position": [0.0, 0.0]}),
    "outside-table": lambda: shot({"position": [-3.0, 1.0]}),
    "in-slate": lambda: shot({"position": [0.6, 1.8, 0.0]}),
    "wrong-radius": lambda: shot({"radius": 0.2}),
    "moving": lambda: carom.Shot.from_dict(
        FILE | {"balls": [FILE["balls"][0] | {"velocity": [1, 0, 0]}]}
    ),
    "not-on-cloth": lambda: carom.Shot.from_dict(
        FILE | {"balls": [{"id": "cue", "position": [0.6, 0.6, 0.5]}]}
    ),
    "no-strike": lambda: carom.Shot.from_dict(
        {key: FILE[key] for key in FILE if key != "strike"}
    ).evaluate(carom.Noise(speed=0.1), n=10),
    "misses-ball": lambda: shot(strike={"side": 0.8, "height": 0.8}).simulate(),
    "miscue": lambda: shot(strike={"side": 0.7}).simulate(),
    "cue-obstructed": lambda: shot(
        {"position": [0.6, 0.5]}, strike={"elevation_deg": 0, "obstruction": "refuse"}
    ),
    "too-many-events": lambda: shot(max_events=2).simulate(),
    "frame-over": lambda: over().concede(),
    "not-a-move": lambda: replayed({}),
    "not-called": lambda: played("nine-ball").play(
        STRIKE, call=carom.Call("pocket", "9", "top-left")
    ),
    "no-safety": lambda: played("nine-ball").play(STRIKE, call=carom.Call("safety")),
    "no-push-out": lambda: played("nine-ball").play(STRIKE, call=carom.Call("push-out")),
    "not-in-hand": lambda: played("nine-ball").play(STRIKE, cue_ball=(0.5, 0.5)),
    "outside-region": lambda: carom.Frame("nine-ball").play(STRIKE, cue_ball=(0.6, 2.0)),
    "called-ball-down": lambda: carom.Frame("straight-pool").play(
        STRIKE, cue_ball=(0.6, 0.6), call=carom.Call("pocket", "cue", "top-left")
    ),
    "wrong-nomination": lambda: played("nine-ball").play(STRIKE, call=carom.Call("on", "9")),
    "not-a-choice": lambda: refused_break().choose("replace"),
    "touches-ball": lambda: carom.Frame("snooker").play(STRIKE, cue_ball=(0.889, 0.737)),
    "endless-motion": endless,
    "unreachable": lambda: shot(
        physics={"cue": {"tip_efficiency": 0.1}}, strike={"height": 0.4}
    ).simulate(),
    "busy": locked_twice,
    "system": emitted_to_nothing,
    "no-place": lambda: after_scratch().play(STRIKE),
    "no-nomination": lambda: on_colors().play(STRIKE),
    "no-play": lambda: carom.Player("carom:50").choose(
        carom.Frame("nine-ball", physics={"cue": {"tip_efficiency": 0.1}})
    ),
    "no-call": lambda: carom.Frame("straight-pool").play(STRIKE, cue_ball=(0.6, 0.6)),
}

# Python has no case of these. Tests in Rust raise them: `a_stopped_replay_is_an_error` and
# `more_balls_than_the_table_has_room_for_are_refused`.
WITHOUT_CASE = {"stopped", "no-room"}


def test_every_kind_has_a_case() -> None:
    assert set(CASES) == set(KINDS) - WITHOUT_CASE


@pytest.mark.parametrize("kind", CASES)
def test_an_error_has_the_kind_of_its_case(kind: str) -> None:
    with pytest.raises(carom.CaromError) as raised:
        CASES[kind]()
    error: Any = raised.value
    assert error.kind == kind
    assert str(error).startswith(f"{error.place}: " if error.place else error.fault)
    assert set(error.details) <= set(KINDS[kind][1])


@pytest.mark.parametrize("kind", ["overlap", "too-many-events"])
def test_a_copied_error_keeps_its_parts(kind: str) -> None:
    with pytest.raises(carom.CaromError) as raised:
        CASES[kind]()
    again: Any = pickle.loads(pickle.dumps(raised.value))
    assert (type(again), str(again), vars(again)) == (
        type(raised.value),
        str(raised.value),
        vars(raised.value),
    )


def test_details_are_the_values_of_the_message() -> None:
    with pytest.raises(carom.InputError) as raised:
        shot(strike={"speed": 60})
    assert raised.value.details == {
        "value": 60.0,
        "low": 0.0,
        "high": 50.0,
        "open": "low",
        "unit": "m/s",
    }


def test_python_uses_no_kind_that_does_not_exist() -> None:
    used = set()
    for path in (ROOT / "python" / "carom").rglob("*.py"):
        used |= set(re.findall(r'InputError\(\s*"([^"]*)"', path.read_text(encoding="utf-8")))
    assert used
    assert used <= set(KINDS)


def test_the_documentation_lists_every_kind_with_its_details() -> None:
    text = (ROOT / "docs" / "errors.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([a-z-]+)` \| (.*) \| (.*) \|$", text, re.MULTILINE)
    listed = {name: (said, re.findall(r"`(\w+)`", details)) for name, said, details in rows}
    assert listed == KINDS


def test_the_page_lists_every_kind() -> None:
    text = (ROOT / "web" / "src" / "engine" / "error.ts").read_text(encoding="utf-8")
    listed = re.search(r"ERROR_KINDS = \[(.*?)\]", text, re.DOTALL)
    assert listed is not None
    assert re.findall(r'"([a-z-]+)"', listed[1]) == list(KINDS)
