"""The settings of environments: types, sentences, checks and defaults belong together."""

from __future__ import annotations

import ast
import inspect
import itertools
import re
from typing import Any

import carom.env
import pytest
from carom.env import settings

TREE = ast.parse(inspect.getsource(settings))
#: How a sentence names the default.
DEFAULT = re.compile(r"The\s+default\s+is\s+``(.+?)``")
CLASSES = {node.name: node for node in TREE.body if isinstance(node, ast.ClassDef)}


def sentences(name: str) -> dict[str, str]:
    """The sentences of the settings of a class, by name."""
    body = CLASSES[name].body
    return {
        field.target.id: ast.literal_eval(sentence.value)
        for field, sentence in itertools.pairwise(body)
        if isinstance(field, ast.AnnAssign)
        and isinstance(field.target, ast.Name)
        and isinstance(sentence, ast.Expr)
    }


WRITTEN = {
    setting: sentence
    for name in ("MatchSettings", "Settings", "VectorSettings")
    for setting, sentence in sentences(name).items()
}


def test_every_setting_has_a_type_a_sentence_and_a_check() -> None:
    types = carom.env.VectorSettings.__annotations__
    assert list(types) == list(WRITTEN) == list(settings._CHECKS)
    # A setting may be None, or its sentence has the default.
    for name, sentence in WRITTEN.items():
        assert bool(DEFAULT.search(sentence)) != ("None" in types[name].__forward_arg__), name
        # Sphinx would read what stands before a colon as the type.
        assert ":" not in sentence.splitlines()[0], name


@pytest.mark.parametrize("task", ["potting", "nine-ball", "sum-to-three"])
def test_the_written_defaults_are_those_of_rust(task: str) -> None:
    found = {name: DEFAULT.search(text) for name, text in WRITTEN.items()}
    defaults: dict[str, Any] = {
        name: ast.literal_eval(match.group(1)) for name, match in found.items() if match
    }
    assert defaults
    usual = carom.env.CaromVectorEnv(task)
    usual.reset(seed=1)
    given = carom.env.CaromVectorEnv(task, **defaults)
    # A state of other settings is refused.
    given.set_state(usual.get_state())
    assert given.metadata == usual.metadata
    with pytest.raises(carom.InputError, match="max_elevation"):
        carom.env.CaromVectorEnv(task, max_elevation=0.4).set_state(usual.get_state())
