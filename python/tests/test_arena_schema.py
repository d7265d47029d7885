"""The messages of real frames follow the schema of the protocol ``carom-arena/1``."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import carom
import pytest
from jsonschema import Draft202012Validator

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="programs play on Linux")

SCHEMA = carom.schema("arena")

# Its log has every message: what it reads, and what it answers. At each request it first gives an
# answer that is refused. Then it picks from the menu, plays or takes the first choice; it concedes
# at its fourth request.
PROGRAM = """
import json, sys

def answer(message):
    print("MESSAGE", json.dumps(message), file=sys.stderr)
    print(json.dumps(message), flush=True)

requests = 0
for line in sys.stdin:
    message = json.loads(line)
    print("MESSAGE", json.dumps(message), file=sys.stderr)
    kind = message["type"]
    if kind == "hello":
        options = {"text": True, "schema": True}
        answer({"type": "hello", "name": "test", "version": "1", "options": options})
    elif kind == "match":
        answer({"type": "ready"})
    elif kind == "request":
        request = message
        requests += 1
        answer({"type": "choose", "id": message["id"], "choice": "nothing"})
    elif kind == "refused":
        if requests == 4:
            answer({"type": "concede", "id": message["id"]})
        elif request.get("menu"):
            answer({"type": "pick", "id": message["id"], "item": 1})
        elif request["kind"] == "choice":
            choice = request["choices"][0]
            answer({"type": "choose", "id": message["id"], "choice": choice})
        else:
            strike = {"speed": 1.0, "azimuth": 0.1}
            answer({"type": "play", "id": message["id"], "strike": strike})
"""


def messages(log: Path) -> list[dict[str, Any]]:
    found = []
    for line in log.read_text(encoding="utf-8").splitlines():
        _, mark, text = line.partition("MESSAGE ")
        if mark:
            found.append(json.loads(text))
    return found


@pytest.mark.parametrize("game", [facts["name"] for facts in carom.game_facts()])
def test_every_message_of_a_match_follows_the_schema(game: str, tmp_path: Path) -> None:
    file = tmp_path / "program.py"
    file.write_text(PROGRAM, encoding="utf-8")
    seen: dict[str, int] = {}
    for settings in ("", "[menu=3]"):
        out = tmp_path / f"match{settings}"
        program = f"exec{settings}:'{sys.executable}' '{file}'"
        carom.play_match(
            program, "greedy:9", game=game, pairs=1, secret="5" * 64, out=out, simulations=9
        )
        for message in messages(out / "errors.log"):
            errors = [error.message for error in Draft202012Validator(SCHEMA).iter_errors(message)]
            assert not errors, (message, errors)
            seen[message["type"]] = seen.get(message["type"], 0) + 1
    assert {"hello", "match", "ready", "request", "refused", "over", "bye", "concede"} <= set(seen)
    assert {"play", "choose"} <= set(seen)


@pytest.mark.parametrize(
    "wrong",
    [
        {"type": "play", "id": 1},
        {"type": "play", "id": "1", "strike": {"speed": 1.0, "azimuth": 0.0}},
        {"type": "choose", "id": 1},
        {"type": "request", "id": 1},
        {"type": "dance", "id": 1},
    ],
)
def test_the_schema_refuses_wrong_messages(wrong: dict[str, Any]) -> None:
    assert not Draft202012Validator(SCHEMA).is_valid(wrong)
