"""Writing episodes for offline learning, in the Arrow layout of Minari's data sets."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv

from carom.arguments import text
from carom.errors import InputError
from carom.files import checked_path

if TYPE_CHECKING:
    import gymnasium
    from gymnasium.spaces import Box
    from numpy.typing import NDArray

    Array = NDArray[Any]

# The version of Minari whose layout this is; later ones read it.
_MINARI = "0.5.1"
# What each step's info keeps, with the value before the first step.
_INFOS = {"player": np.int8(-1), "legal": np.bool_(False), "potted": np.int64(0)}


class EpisodeWriter:
    """Writes the episodes of an environment while it is used.

    ::

        envs = gymnasium.make_vec("carom/NineBall-v3", num_envs=64, balls=(2, 4))
        with carom.env.EpisodeWriter(envs, "episodes") as writer:
            observations, infos = writer.reset(seed=0)
            for _ in range(100):
                actions = policy(observations)
                observations, rewards, terminated, truncated, infos = writer.step(actions)

    ``reset`` and ``step`` are those of the environment. Every episode that ends becomes a folder
    with the number of the episode, which holds ``part-0.arrow`` and ``metadata.json``; episodes
    that have not ended are left out. The folder is a data set for Minari:
    ``minari.MinariDataset("episodes")``. Its rows are ``observations``, ``actions``, ``rewards``,
    ``terminations``, ``truncations`` and ``infos`` (``player``, ``legal``, ``potted``). An episode
    of n steps has n + 1 rows: the last one has the last observation, and zeros for the others.

    Args:
        env: An environment of Gymnasium or a vector of them.
        folder: Where to write. It is created, and must not have a data set yet.
        dataset_id: The name of the data set; None uses that of the task.

    Raises:
        InputError: ``env`` is no environment, or the folder has a data set.
        ImportError: pyarrow is missing: ``pip install 'carom[sweep]'``.
    """

    def __init__(
        self,
        env: gymnasium.Env[Any, Any] | VectorEnv[Any, Any, Any],
        folder: str | os.PathLike[str],
        *,
        dataset_id: str | None = None,
    ) -> None:
        try:
            import pyarrow as pa
        except ImportError as error:
            raise ImportError(
                "carom.env.EpisodeWriter needs pyarrow; install it: pip install 'carom[sweep]'"
            ) from error
        if not hasattr(env, "step") or not hasattr(env, "action_space"):
            raise InputError(
                "wrong-type",
                "env",
                f"found a {type(env).__name__}",
                "give an environment of Gymnasium or a vector",
            )
        self._pa = pa
        self.env = env
        self.folder = checked_path("folder", folder, "episodes")
        if (self.folder / "metadata.json").exists():
            raise InputError(
                "conflict", "folder", f"{self.folder} has a data set", "choose another folder"
            )
        self.folder.mkdir(parents=True, exist_ok=True)
        self._is_vector = isinstance(env, VectorEnv)
        spaces: Any = env
        if self._is_vector:
            self._spaces = (spaces.single_observation_space, spaces.single_action_space)
        else:
            self._spaces = (spaces.observation_space, spaces.action_space)
        task = getattr(env.unwrapped, "_task", "episodes")
        self._id = f"carom/{task}-v0" if dataset_id is None else text("dataset_id", dataset_id)
        self._mode = env.metadata.get("autoreset_mode") if self._is_vector else None
        count = spaces.num_envs if self._is_vector else 1
        self._open: list[_Episode | None] = [None] * count
        self.episodes = self.steps = 0
        self._write_metadata()

    def reset(self, **arguments: Any) -> tuple[Any, dict[str, Any]]:
        """The environment's own ``reset``. Episodes in progress that it resets are left out."""
        observations, infos = self.env.reset(**arguments)
        mask = (arguments.get("options") or {}).get("reset_mask")
        for index, row in enumerate(self._rows(observations)):
            if mask is None or mask[index]:
                self._open[index] = _Episode(row, self._info(infos, index))
        return observations, infos

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """The environment's own ``step``."""
        result = self.env.step(actions)
        observations, rewards, terminated, truncated, infos = result
        seen, acted = self._rows(observations), self._rows(actions)
        same_step = self._mode is AutoresetMode.SAME_STEP
        for index, episode in enumerate(self._open):
            if episode is None:
                # In the mode next-step, this step began an episode and played no shot.
                self._open[index] = _Episode(seen[index], self._info(infos, index))
                continue
            ends = self._rows(terminated)[index], self._rows(truncated)[index]
            over = any(ends)
            last = infos.get("final_info", infos) if over and same_step else infos
            row = infos["final_obs"][index] if over and same_step else seen[index]
            reward = self._rows(rewards)[index]
            episode.add(row, acted[index], reward, ends, self._info(last, index))
            if over:
                self._write(episode)
                first = _Episode(seen[index], self._info(infos, index)) if same_step else None
                self._open[index] = first
        return result

    def close(self) -> None:
        """Write the numbers of episodes and steps. The environment stays open."""
        self._write_metadata()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        place: TracebackType | None,
    ) -> None:
        self.close()

    def _rows(self, values: Any) -> Any:
        return values if self._is_vector else [values]

    def _info(self, infos: dict[str, Any], index: int) -> dict[str, Any]:
        values = {key: infos.get(key) for key in _INFOS}
        return {
            key: _INFOS[key] if value is None else value[index] if self._is_vector else value
            for key, value in values.items()
        }

    def _write(self, episode: _Episode) -> None:
        """Write an episode that has ended."""
        place = self.folder / str(self.episodes)
        place.mkdir(exist_ok=True)
        batch = self._pa.RecordBatch.from_pydict(episode.columns(self._pa, *self._spaces))
        with (
            self._pa.OSFile(os.fspath(place / "part-0.arrow"), "wb") as file,
            self._pa.ipc.new_file(file, batch.schema) as writer,
        ):
            writer.write_batch(batch)
        steps = len(episode.rewards)
        _write_json(place / "metadata.json", {"id": self.episodes, "total_steps": steps})
        self.episodes += 1
        self.steps += steps

    def _write_metadata(self) -> None:
        seen, acted = self._spaces
        _write_json(
            self.folder / "metadata.json",
            {
                "dataset_id": self._id,
                "minari_version": _MINARI,
                "data_format": "arrow",
                "jpeg_encoding": False,
                "total_episodes": self.episodes,
                "total_steps": self.steps,
                "observation_space": _space(seen),
                "action_space": _space(acted),
            },
        )


class _Episode:
    """The rows of an episode in progress."""

    def __init__(self, first: Array, info: dict[str, Any]) -> None:
        self.observations = [np.array(first)]
        self.infos = [info]
        self.actions: list[Array] = []
        self.rewards: list[float] = []
        self.ends: list[Sequence[bool]] = []

    def add(
        self,
        observation: Array,
        action: Array,
        reward: float,
        ends: Sequence[bool],
        info: dict[str, Any],
    ) -> None:
        self.observations.append(np.array(observation))
        self.actions.append(np.array(action))
        self.rewards.append(float(reward))
        self.ends.append(ends)
        self.infos.append(info)

    def columns(self, pa: Any, seen: Box, acted: Box) -> dict[str, Any]:
        """The columns of Minari, each one row longer than the episode has steps."""
        ends = np.asarray(self.ends, dtype=bool)
        infos = {
            key: np.array([info[key] for info in self.infos], dtype=first.dtype)
            for key, first in _INFOS.items()
        }
        return {
            "observations": _lists(pa, self.observations, seen, 0),
            "actions": _lists(pa, self.actions, acted, 1),
            "rewards": np.append(self.rewards, 0.0),
            "terminations": np.append(ends[:, 0], False),
            "truncations": np.append(ends[:, 1], False),
            "infos": pa.StructArray.from_arrays(
                [pa.array(values) for values in infos.values()], names=list(infos)
            ),
        }


def _lists(pa: Any, rows: list[Array], space: Box, padding: int) -> Any:
    """Rows of numbers as lists of one size, with rows of zeros at the end."""
    table = np.pad(np.asarray(rows, dtype=space.dtype), ((0, padding), (0, 0)))
    return pa.FixedSizeListArray.from_arrays(table.reshape(-1), table.shape[1])


def _space(space: Box) -> str:
    """A box in the words of Minari."""
    return json.dumps(
        {
            "type": "Box",
            "dtype": str(space.dtype),
            "shape": list(space.shape),
            "low": space.low.tolist(),
            "high": space.high.tolist(),
        }
    )


def _write_json(path: Path, value: dict[str, Any]) -> None:
    path.write_text(json.dumps(value) + "\n", encoding="utf-8")
