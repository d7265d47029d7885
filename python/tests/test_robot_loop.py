"""The example of a robot that watches, learns, plans and commands, in a short form."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

FILE = Path(__file__).parents[2] / "examples" / "robot_loop.py"


@pytest.fixture(scope="module")
def loop() -> ModuleType:
    spec = importlib.util.spec_from_file_location("robot_loop", FILE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["robot_loop"] = module
    spec.loader.exec_module(module)
    return module


def test_a_robot_learns_its_table_and_its_errors_and_then_states_chances(loop: ModuleType) -> None:
    world = loop.World(3)
    robot = loop.Robot(world.marks, world.marks_measured(), 500)
    for _ in range(12):
        chance, _ = loop.play(world, robot)
        assert chance is None
    robot.learn()
    model = robot.table.model
    draw = np.random.default_rng(3).normal(size=len(loop.FREE))
    truth = model.clip(model.start + 2.0 * model.steps * draw)
    before, after = (np.abs(v - truth) / model.steps for v in (model.start, robot.table.mean))
    learned = [loop.FREE.index(name) for name in ("rolling.a", "cushion.restitution.a")]
    assert (after[learned] < 0.5).all()
    assert (before[learned] > 2 * after[learned]).all()
    low, high = robot.errors.interval("azimuth")
    assert low < 0.002 < high
    played = [loop.play(world, robot) for _ in range(2)]
    assert all(0.0 < chance < 1.0 for chance, _ in played)
    assert len(robot.shots) == 14
    # A plan reaches the cue: what it was asked is the best strike in the robot's true frame.
    last = robot.shots["13"]
    assert np.linalg.norm(np.array(last.moved.direction) - last.asked.direction) < 0.03
    assert last.moved.speed == pytest.approx(last.asked.speed, rel=0.2)
