"""Shot files, traces and records of strangers: refused or read, within bounds of size and time."""

from __future__ import annotations

import json
import tarfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import carom
import pytest
from carom import Frame, InputError, Shot, Trace

FILE: dict[str, Any] = {
    "format": "carom-shot/1",
    "table": "wpa-9ft",
    "balls": [{"id": "cue", "position": [0.6, 0.6]}, {"id": "1", "position": [0.7, 1.6]}],
    "strike": {"ball": "cue", "speed": 3.0, "azimuth_deg": 90},
}
MIB = 1 << 20


def text(**changes: Any) -> str:
    return json.dumps({**FILE, **changes})


def refusal(file: str) -> InputError:
    with pytest.raises(InputError) as caught:
        Shot.from_json(file)
    assert len(str(caught.value)) < 5000
    return caught.value


def test_a_shot_file_above_the_limit_is_refused_before_it_is_read() -> None:
    fits = text(note="x")
    assert refusal(fits).kind == "unknown-key"
    error = refusal(fits + " " * 16 * MIB)
    assert error.kind == "out-of-range"
    assert "16 MiB" in error.remedy


def test_a_trace_may_be_longer_than_a_shot_file() -> None:
    trace = Shot.from_dict(FILE).simulate()
    assert Trace.from_json(trace.to_json() + " " * 16 * MIB).hash == trace.hash
    with pytest.raises(InputError, match="128 MiB"):
        Trace.from_json(" " * (128 * MIB + 1))


@pytest.mark.parametrize(
    "deep",
    ["[" * 100_000, '{"a":' * 100_000, text(table="@").replace('"@"', "[" * 129 + "]" * 129)],
)
def test_deep_texts_are_refused(deep: str) -> None:
    assert refusal(deep).kind == "syntax"


def test_deep_values_are_refused() -> None:
    deep: Any = []
    for _ in range(100_000):
        deep = [deep]
    with pytest.raises(InputError):
        Shot.from_dict({**FILE, "table": deep})


@pytest.mark.parametrize(
    ("changes", "kind"),
    [
        ({"balls": [{"id": str(k), "position": [0.6, 0.6]} for k in range(200_000)]}, "ball-count"),
        ({"table": "w" * MIB}, "unknown-name"),
        ({"w" * MIB: 1}, "unknown-key"),
        ({"max_events": 1_000_001}, "out-of-range"),
        ({"track": [{"ball": "cue", "samples": [[0.0, 0.6, 0.6]] * 10_001}]}, "wrong-count"),
        ({"marks": [{}] * 101}, "wrong-count"),
    ],
)
def test_large_parts_are_refused_with_a_short_sentence(changes: dict[str, Any], kind: str) -> None:
    assert refusal(text(**changes)).kind == kind


def test_a_shot_that_never_ends_is_stopped_at_its_cap() -> None:
    endless = {
        "base": "ideal",
        "cloth": {"sliding_friction": 0, "rolling_friction": 0, "spin_deceleration": 0},
        "cushion": {"restitution": 1.0, "friction": 0.0},
    }
    shot = Shot.from_json(text(physics=endless, max_events=1000))
    with pytest.raises(carom.EventCapError):
        shot.simulate()


@pytest.mark.parametrize(
    "record",
    [
        {"format": "carom-frame/1", "setup": {"game": "nine-ball"}, "moves": [{"play": {}}]},
        {"format": "carom-frame/1", "setup": {"game": "nine-ball"}, "moves": [{}] * 100_000},
        {"format": "carom-frame/1", "setup": {"game": "w" * MIB}, "moves": []},
    ],
)
def test_hostile_records_are_refused(record: dict[str, Any]) -> None:
    with pytest.raises(InputError) as caught:
        Frame.replay(record)
    assert len(str(caught.value)) < 5000


def opened(read: Callable[[str], Any], file: str) -> Any:
    """What was read; None for bad input."""
    try:
        return read(file)
    except InputError:
        return None


def test_every_input_that_a_fuzzer_kept_is_a_file_or_bad_input() -> None:
    kept = Path(__file__).parents[2] / "fuzz" / "corpus" / "shot_parser.tar.xz"
    with tarfile.open(kept) as archive:
        members = [data for one in archive.getmembers() if (data := archive.extractfile(one))]
        files = [data.read().decode(errors="replace") for data in members]
    shots = [shot for file in files if (shot := opened(Shot.from_json, file)) is not None]
    for shot in shots:
        assert Shot.from_json(shot.to_json()).to_dict() == shot.to_dict()
    for file in files:
        opened(Trace.from_json, file)
    assert len(shots) > 20
    assert len(files) > 500 + len(shots)
