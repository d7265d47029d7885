"""The writer of episodes for offline learning."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pyarrow as pa
import pytest
from carom.errors import InputError


def make(mode: str) -> Any:
    settings: dict[str, Any] = {"balls": 2, "patience": 4, "noise": carom.Noise.olympiad(1.0)}
    if mode == "single":
        return gymnasium.make("carom/NineBall-v3", **settings)
    return gymnasium.make_vec("carom/NineBall-v3", num_envs=3, autoreset_mode=mode, **settings)


def write(env: Any, folder: Path, steps: int = 40) -> None:
    with carom.env.EpisodeWriter(env, folder) as writer:
        writer.reset(seed=5)
        random = np.random.default_rng(0)
        for _ in range(steps):
            action = random.uniform(-1, 1, env.action_space.shape).astype(np.float32)
            _, _, terminated, truncated, _ = writer.step(action)
            if isinstance(env, gymnasium.Env) and (terminated or truncated):
                writer.reset()


def read(folder: Path, number: int) -> dict[str, Any]:
    """An episode, by Minari's documented layout."""
    with pa.OSFile(str(folder / str(number) / "part-0.arrow")) as file:
        table = pa.ipc.open_file(file).read_all()
    return {name: np.array(table[name].to_pylist()) for name in table.column_names}


@pytest.mark.parametrize("mode", ["single", "same-step", "next-step"])
def test_written_episodes_replay_with_the_same_observations(mode: str, tmp_path: Path) -> None:
    folder = tmp_path / "episodes"
    write(make(mode), folder)
    about = json.loads((folder / "metadata.json").read_text())
    assert about["data_format"] == "arrow"
    assert about["total_episodes"] > 3
    assert json.loads(about["action_space"])["shape"] == [7]
    total = 0
    for number in range(about["total_episodes"]):
        rows = read(folder, number)
        steps = len(rows["rewards"]) - 1
        total += steps
        assert json.loads((folder / str(number) / "metadata.json").read_text()) == {
            "id": number,
            "total_steps": steps,
        }
        assert (rows["terminations"] | rows["truncations"]).tolist() == [False] * (steps - 1) + [
            True,
            False,
        ]
        assert rows["observations"].shape[0] == steps + 1
    assert total == about["total_steps"]
    if mode == "single":
        env = make(mode)
        observation = env.reset(seed=5)[0]
        rows = read(folder, 0)
        for k, action in enumerate(rows["actions"][:-1]):
            np.testing.assert_array_equal(rows["observations"][k], observation)
            observation, reward, *_ = env.step(action.astype(np.float32))
            assert reward == rows["rewards"][k]
        np.testing.assert_array_equal(rows["observations"][-1], observation)


def test_vectors_of_both_modes_write_the_same_episodes(tmp_path: Path) -> None:
    """An environment's first episode does not depend on when the others reset."""
    first = {}
    for mode in ("same-step", "next-step"):
        write(make(mode), tmp_path / mode, steps=8)
        first[mode] = read(tmp_path / mode, 0)
    for key, values in first["same-step"].items():
        np.testing.assert_array_equal(values, first["next-step"][key])


def test_a_folder_with_a_data_set_is_not_overwritten(tmp_path: Path) -> None:
    write(make("single"), tmp_path)
    with pytest.raises(InputError, match=r"^folder: .* has a data set; choose another folder"):
        carom.env.EpisodeWriter(make("single"), tmp_path)
    with pytest.raises(InputError, match=r"^env: found a int"):
        carom.env.EpisodeWriter(3, tmp_path / "new")  # type: ignore[arg-type]


def test_minari_reads_the_data_set(tmp_path: Path) -> None:
    minari = pytest.importorskip("minari")
    write(make("same-step"), tmp_path)
    found = minari.MinariDataset(tmp_path)
    assert found.total_episodes > 3
    assert found.action_space == gymnasium.make("carom/NineBall-v3").action_space
    for episode in found.iterate_episodes():
        assert len(episode.observations) == len(episode.rewards) + 1 == len(episode.actions) + 1
        assert len(episode.infos["player"]) == len(episode.observations)
