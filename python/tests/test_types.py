"""The types of results: they are those of the JSON Schema and of real frames."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, get_args, get_type_hints

import carom
import pytest
import typed_use
from carom import events, request
from carom.record import Record

ROOT = Path(__file__).parents[2]
TRACE = carom.schema("trace")
EVENTS = {
    name: TRACE["$defs"][name]
    for name in TRACE["$defs"]
    if name
    in {
        "cue_strike",
        "ball_collision",
        "rail_collision",
        "motion_transition",
        "pocket_collision",
        "slate_collision",
        "off_table",
    }
}
# In TypeScript the same types are here.
RULES = (ROOT / "web/src/engine/rules.ts").read_text(encoding="utf-8")


def keys_of(cls: type[Record]) -> set[str]:
    """The keys that a class declares, with their names in files."""
    return {name.rstrip("_") for name in get_type_hints(cls) if not name.startswith("_")}


def test_the_classes_of_events_have_the_keys_of_the_schema() -> None:
    assert (
        len(EVENTS)
        == len(get_args(events.TraceEvent))
        == len(TRACE["properties"]["events"]["items"]["oneOf"])
    )
    for cls in get_args(events.TraceEvent):
        (kind,) = get_args(get_type_hints(cls)["type"])
        entry = EVENTS[kind.replace("-", "_")]
        assert keys_of(cls) == entry["properties"].keys(), kind
        optional = entry["properties"].keys() - set(entry["required"])
        assert optional == cls._DEFAULTS.keys(), kind


def test_outcome_and_balls_have_the_keys_of_the_schema() -> None:
    assert keys_of(events.Outcome) == TRACE["properties"]["outcome"]["properties"].keys()
    assert keys_of(events.BallState) == TRACE["$defs"]["ball"]["properties"].keys()


@pytest.mark.parametrize(
    ("alias", "words"),
    [
        (events.Motion, TRACE["$defs"]["motion"]["enum"]),
        (events.RailName, TRACE["$defs"]["rail"]["enum"]),
        (events.PocketName, TRACE["$defs"]["pocket"]["enum"]),
        (events.CushionPart, EVENTS["rail_collision"]["properties"]["part"]["enum"]),
        (
            request.CallKind,
            carom.schema("play")["properties"]["call"]["properties"]["kind"]["enum"],
        ),
    ],
)
def test_the_words_of_a_type_are_those_of_the_schema(alias: Any, words: list[str]) -> None:
    assert set(get_args(alias)) == set(words)


@pytest.mark.parametrize("name", ["Choice", "Region"])
def test_the_words_of_a_type_are_those_of_typescript(name: str) -> None:
    declared = re.search(rf"export type {name} =([^;]*);", RULES)
    assert declared
    assert set(get_args(getattr(request, name))) == set(re.findall(r'"([a-z-]+)"', declared[1]))


def go_on(frame: carom.Frame, turn: int) -> None:
    """Answer the request somehow."""
    asked = frame.request
    if asked.kind == "choice":
        frame.choose(asked.choices[0])
        return
    calls: dict[str, Any] = {"on": {"kind": "on", "ball": next(iter(asked.on), None)}}
    call = next((calls.get(kind, {"kind": kind}) for kind in asked.calls if kind != "pocket"), None)
    place = frame.hand_bounds and [
        0.45 * sum(corners) for corners in zip(*frame.hand_bounds, strict=True)
    ]
    frame.play({"speed": 4.0, "azimuth_deg": 71.0 * turn}, cue_ball=place, call=call)


def test_requests_and_states_of_real_frames_have_the_declared_keys() -> None:
    kinds: set[str] = set()
    states: set[str] = set()
    for game in carom.rule_sets():
        frame = carom.Frame(game, seed=2)
        for turn in range(20):
            asked = frame.request
            assert keys_of(type(asked)) >= asked.keys(), game
            kinds.add(asked.kind)
            states |= frame.state.keys()
            if asked.kind == "over":
                break
            go_on(frame, turn)
    assert kinds >= {"shot", "choice"}
    assert states == keys_of(request.GameState)


def test_events_are_dicts_whose_keys_are_attributes() -> None:
    trace = carom.break_shot("nine-ball", seed=20).simulate()
    assert [dict(event) for event in trace.events] == trace.to_dict()["events"]
    transition = next(event for event in trace.events if event.type == "motion-transition")
    assert transition.from_ == transition["from"]
    assert {"from_", "to", "time"} <= set(dir(transition))
    with pytest.raises(AttributeError, match="no 'rail' here; there are: time, type"):
        _ = transition.rail  # type: ignore[attr-defined]


def test_what_a_type_checker_knows_is_so() -> None:
    shot = carom.break_shot("nine-ball", seed=20)
    trace = shot.simulate()
    typed_use.of_a_trace(trace)
    assert typed_use.of_transitions(trace)
    frame = carom.Frame("nine-ball")
    typed_use.of_a_frame(frame)
    typed_use.of_a_ruling(frame.play({"speed": 1, "azimuth_deg": 90}, cue_ball=(0.2, 0.2)))
    typed_use.of_a_shot(shot)
    typed_use.of_environments()
