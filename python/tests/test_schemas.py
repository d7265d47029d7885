"""The JSON Schemas of `carom schema` agree with the files that carom reads and writes."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import carom
import jsonschema
import pytest
from carom import InputError, Shot, Sweep
from carom.sweeps.columns import OUTCOMES

SHOTS = sorted((Path(__file__).parents[2] / "shots").glob("*.json"))


@pytest.fixture(scope="module")
def shot_file() -> jsonschema.Draft202012Validator:
    schema = carom.schema("shot")
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


@pytest.fixture(scope="module")
def trace_file() -> jsonschema.Draft202012Validator:
    schema = carom.schema("trace")
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def test_there_are_example_shots() -> None:
    assert len(SHOTS) >= 5


@pytest.mark.parametrize("path", SHOTS, ids=lambda p: p.stem)
def test_every_example_shot_and_its_trace_follow_their_schemas(
    path: Path,
    shot_file: jsonschema.Draft202012Validator,
    trace_file: jsonschema.Draft202012Validator,
) -> None:
    shot = Shot.load(path)
    shot_file.validate(shot.to_dict())
    trace_file.validate(shot.simulate().to_dict())


def _changed(**changes: Any) -> Any:
    def change(file: dict[str, Any]) -> None:
        file.update(changes)

    return change


BROKEN = {
    "an unknown key": _changed(tables="wpa-9ft"),
    "another format": _changed(format="carom-shot/9"),
    "no balls": _changed(balls=[]),
    "a text for a cap": _changed(max_events="many"),
    "an unknown model": _changed(physics={"cushion": {"model": "han-2006"}}),
    "a restitution above 1": _changed(physics={"ball_ball": {"restitution": 1.5}}),
    "a strike without a ball": _changed(strike={"speed": 1.0, "azimuth_deg": 0.0}),
    "a speed of zero": _changed(strike={"ball": "cue", "speed": 0, "azimuth_deg": 0.0}),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_shot_that_the_schema_refuses_is_refused_by_the_engine(
    what: str, pot: dict[str, Any], shot_file: jsonschema.Draft202012Validator
) -> None:
    assert shot_file.is_valid(pot)
    broken = copy.deepcopy(pot)
    BROKEN[what](broken)
    assert not shot_file.is_valid(broken)
    with pytest.raises(InputError):
        Shot.from_dict(broken)


SPEC = {
    "format": "carom-sweep/1",
    "shots": ["shots/*.json"],
    "vary": {
        "strike.speed": {"from": 1, "to": 2, "count": 3},
        "strike.side": {"normal": [0, 0.1], "relative": True, "name": "english"},
        "balls.cue.position": {"uniform": [[0.2, 0.2], [1.0, 1.0]]},
        "physics": {"grid": ["pool", {"base": "pool"}]},
    },
    "samples": 10,
    "sequence": "even",
    "noise": {"azimuth_deg": 0.1, "side_m": 0.001},
    "variants": 2,
    "columns": ["pocket"],
}

BROKEN_SPECS: dict[str, dict[str, Any]] = {
    "an unknown key": {"sample": 10},
    "another format": {"format": "carom-sweep/9"},
    "no shots": {"shots": []},
    "a path that no shot file has": {"vary": {"stroke.speed": {"grid": [1]}}},
    "two ways at once": {"vary": {"strike.speed": {"grid": [1], "uniform": [1, 2]}}},
    "steps without an end": {"vary": {"strike.speed": {"from": 1, "count": 2}}},
    "a single end": {"vary": {"strike.speed": {"uniform": [1]}}},
    "a name with a blank": {"vary": {"strike.speed": {"grid": [1], "name": "the speed"}}},
    "no samples": {"samples": 0},
    "an unknown sequence": {"sequence": "sobol"},
    "an unknown error": {"noise": {"azimuth": 0.1}},
    "an unknown column": {"columns": ["pockets"]},
}


@pytest.mark.parametrize("what", BROKEN_SPECS)
def test_a_spec_that_the_schema_refuses_is_refused_by_sweep(what: str, pot: dict[str, Any]) -> None:
    schema = carom.schema("sweep")
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    whole = SPEC | {"shots": pot}
    for good in (SPEC, whole, Sweep.from_dict(whole).to_dict()):
        validator.validate(good)
    assert not validator.is_valid(whole | BROKEN_SPECS[what])
    with pytest.raises(InputError):
        Sweep.from_dict(whole | BROKEN_SPECS[what])


def test_the_schema_lists_every_column_of_a_sweep() -> None:
    known = carom.schema("sweep")["properties"]["columns"]["items"]["enum"]
    assert known == list(OUTCOMES)


def test_a_schema_that_does_not_exist_is_refused() -> None:
    with pytest.raises(InputError, match="table"):
        carom.schema("table")  # type: ignore[arg-type]
