"""The JSON Schemas that `carom schema` prints hold for what goes in and what comes out."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import carom
import jsonschema
import pytest
from carom import InputError, Shot

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
def test_what_the_schema_refuses_the_engine_refuses_too(
    what: str, pot: dict[str, Any], shot_file: jsonschema.Draft202012Validator
) -> None:
    assert shot_file.is_valid(pot)
    broken = copy.deepcopy(pot)
    BROKEN[what](broken)
    assert not shot_file.is_valid(broken)
    with pytest.raises(InputError):
        Shot.from_dict(broken)


def test_a_schema_that_does_not_exist_is_refused() -> None:
    with pytest.raises(InputError, match="table"):
        carom.schema("table")  # type: ignore[arg-type]
