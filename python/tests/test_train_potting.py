"""The example of training: its players, its picture, and the training if PyTorch is installed."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import carom
import numpy as np
import pytest

SCRIPT = Path(__file__).parents[2] / "examples" / "train_potting.py"


@pytest.fixture(scope="module")
def example() -> ModuleType:
    spec = importlib.util.spec_from_file_location("train_potting", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    # Dataclasses look up their module by name.
    sys.modules["train_potting"] = module
    spec.loader.exec_module(module)
    return module


def observation(cue: tuple[float, float], ball: tuple[float, float]) -> np.ndarray[Any, Any]:
    """The observation of two balls on a nine-foot table at positions in m."""
    row = np.zeros((1, 19), dtype=np.float32)
    row[0, 0:2] = 2 * np.array(cue) / (1.27, 2.54) - 1
    row[0, 4:6] = 2 * np.array(ball) / (1.27, 2.54) - 1
    return row


def test_the_geometry_of_an_observation_is_right_for_two_balls_in_the_middle(
    example: ModuleType,
) -> None:
    table = example.Table()
    # The cue ball is on the long axis, the object ball between the side pockets.
    found = table.geometry(observation((0.635, 0.635), (0.635, 1.27)))
    assert found.between[0] == pytest.approx([0.635])
    assert found.fullness.shape == (1, 6)
    # For a side pocket the ghost ball is beside the ball, a diameter away, opposite the pocket.
    side = np.flatnonzero(np.isclose(found.into[0], 1.0))
    ghost = np.hypot(0.635, 2 * table.radius)
    assert found.near[0, side] == pytest.approx([ghost, ghost])
    assert sorted(found.across[0, side]) == pytest.approx([-0.635 / ghost, 0.635 / ghost])
    # The two pockets at the far end are possible, the two at the near end are not.
    assert (found.fullness[0] > 0.5).sum() == 2
    assert (found.fullness[0] < -0.5).sum() == 2
    view = table.view(observation((0.3, 0.3), (0.6, 0.6)))
    assert view.shape == (1, 35)
    assert view.dtype == np.float32


def test_the_input_is_finite_when_balls_are_pocketed(example: ModuleType) -> None:
    assert np.isfinite(example.Table().view(np.zeros((1, 19), dtype=np.float32))).all()


def test_the_geometric_aimer_pots_more_with_less_noise_and_more_than_a_random_player(
    example: ModuleType,
) -> None:
    table = example.Table()
    action = example.geometric_aimer(table)(observation((0.635, 1.27), (0.9, 1.27)))
    # A straight shot at the side pocket is a full hit.
    assert action[0, 0] == pytest.approx(0.0, abs=1e-6)
    aimer, at_random = example.geometric_aimer(table), example.random_player(0)
    exact, erring = (example.evaluate(aimer, noise, 3000) for noise in (0.0, 2.0))
    blind = example.evaluate(at_random, 1.0, 3000)
    assert blind.high < 0.12
    assert blind.high < erring.low < erring.high < exact.low


def test_all_players_are_evaluated_on_the_same_shots(example: ModuleType) -> None:
    table = example.Table()
    one, other = (example.evaluate(example.geometric_aimer(table), 1.0, 500) for _ in range(2))
    assert one == other
    assert one.trials == 500


def test_the_learning_curve_shows_both_other_players(example: ModuleType, tmp_path: Path) -> None:
    chance = carom.Chance.of(30, 100, 0.95)
    checkpoints = [example.Checkpoint(shots, 1.0, chance) for shots in (0, 1_000_000)]
    figure = example.draw(checkpoints, {"geometric aimer": chance, "random": chance}, 1.0)
    figure.savefig(tmp_path / "curve.png")
    labels = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert labels == ["agent", "geometric aimer", "random"]


def test_without_the_extra_the_error_says_what_to_install() -> None:
    code = "import sys; sys.modules['stable_baselines3'] = None; import carom.env.sb3"
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True)
    assert "pip install 'carom[train]'" in done.stderr


def test_the_vector_keeps_the_contract_of_stable_baselines(example: ModuleType) -> None:
    pytest.importorskip("stable_baselines3")
    import gymnasium
    from carom.env.sb3 import SB3VecEnv
    from carom.errors import InputError

    table = example.Table()
    envs = SB3VecEnv(example.make(6, 1.0), view=table.view)
    envs.seed(3)
    first = envs.reset()
    assert first in envs.observation_space or first.shape == (6, *envs.observation_space.shape)
    observations, rewards, done, infos = envs.step(np.zeros((6, 5), dtype=np.float32))
    assert done.all()
    assert rewards.dtype == np.float32
    last = np.stack([info["terminal_observation"] for info in infos])
    # The terminal observation belongs to the old episode, the returned one to the new episode.
    assert (last != observations).any(axis=1).all()
    envs.seed(3)
    np.testing.assert_array_equal(envs.reset(), first)
    raw, _ = example.make(6, 1.0).reset(seed=3)
    np.testing.assert_array_equal(table.view(raw), first)
    with pytest.raises(InputError, match="same-step"):
        SB3VecEnv(gymnasium.make_vec("carom/Potting-v3", num_envs=2, autoreset_mode="next-step"))


def test_a_short_training_beats_the_random_player(example: ModuleType, tmp_path: Path) -> None:
    pytest.importorskip("stable_baselines3")
    out = tmp_path / "out.json"
    words = ["--steps", "60000", "--envs", "1024", "--shots", "2000", "--json", str(out)]
    assert example.main([*words, "--picture", str(tmp_path / "curve.png")]) == 0
    found = json.loads(out.read_text(encoding="utf-8"))
    players = found["players"]
    assert players["agent"]["low"] > players["random"]["high"]
    assert found["checkpoints"][-1]["shots"] >= 60000
    assert (tmp_path / "curve.png").stat().st_size > 10_000
