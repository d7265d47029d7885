"""What single environments, vectors and matches share: their state, copies, and looks inside."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Space

from carom._core import VectorEnv as Core
from carom.arguments import thread_count, whole
from carom.build import Strike
from carom.env import infos
from carom.env.arrays import floats
from carom.env.opponents import asking
from carom.env.settings import checked, known
from carom.env.starts import start
from carom.errors import InputError
from carom.noise import Noise
from carom.player import Play
from carom.rules import Frame
from carom.shot import Shot

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    Array = NDArray[Any]


class Environments:
    """The environments in Rust, with everything that does not depend on the interface."""

    _core: Core
    _task: str
    _count: int
    _given: dict[str, Any]
    _settings: dict[str, Any]
    _ask: Any
    _width: int
    _seeded: bool
    _reports_more: bool

    def _make(self, task: str, count: int, given: dict[str, Any]) -> None:
        """Make the environments with the settings in ``given``."""
        self._task, self._count, self._given = task, count, given
        self._settings = known(given)
        self._core = Core(task, count, checked(self._settings))
        self._width = self._core.action_size
        self._ask = self._asking()
        self._reports_more = self._has_traces or self._has_opponent or self._randomize is not None
        self._seeded = False

    @property
    def _opponent(self) -> Any:
        return self._settings.get("opponent", "none")

    @property
    def _has_opponent(self) -> bool:
        """Whether the agent has one seat, and not both."""
        return not (isinstance(self._opponent, str) and self._opponent == "none")

    @property
    def _has_traces(self) -> bool:
        return bool(self._settings.get("traces"))

    @property
    def _randomize(self) -> Mapping[str, Any] | None:
        return self._settings.get("randomize")

    def _asking(self) -> Any:
        return asking(self._opponent, self._settings.get("noise") or Noise(), self._width)

    @property
    def presets(self) -> dict[str, Any]:
        """The settings ``table`` and ``physics`` with dated names, for records.

        A name without a date will have other values one day. ``physics`` is missing if the table's
        name implies it. If the environments of a vector have tables or physics of their own, these
        are those of the first one.
        """
        return self._core.presets()

    def get_state(self) -> bytes:
        """Everything on which the results of further steps and resets depend.

        That is the balls, scores and requests, the seeds with the numbers of the episode, the step
        and the move, and the rewards to come. The state of an opponent of one's own is included if
        it has the methods ``get_state() -> bytes`` and ``set_state(bytes)``.

        Wrappers have states of their own: ``pickle`` or ``copy.deepcopy`` of the whole environment
        keeps these too.

        Raises:
            ResetNeeded: The environment has not been reset yet.
            InputError: An opponent's exception interrupted the last step.
        """
        self._check_seeded("get_state")
        opponent = self._opponent
        own = opponent.get_state() if hasattr(opponent, "get_state") else b""
        return self._core.state(own)

    def set_state(self, state: bytes | bytearray | memoryview) -> None:
        """Continue from a state of :meth:`get_state`, with the same bits.

        Only ``threads``, ``traces`` and ``autoreset_mode`` may differ between the two environments.

        Raises:
            InputError: The bytes are not a state, are damaged or of another version, or belong to
                another task or to other settings. The environment is unchanged then.
        """
        own = self._core.set_state(_bytes(state))
        self._seeded = True
        opponent = self._opponent
        if hasattr(opponent, "set_state"):
            opponent.set_state(own)

    def copy(self) -> Self:
        """An independent environment in the same state, in a few microseconds.

        It shares the spaces and the opponent with this one; ``copy.deepcopy`` copies them too.
        """
        twin = object.__new__(type(self))
        twin.__dict__.update(self.__dict__)
        twin._core = self._core.copy()
        return twin

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        twin = self.copy()
        memo[id(self)] = twin
        for name, value in self.__dict__.items():
            if isinstance(value, Space):
                twin.__dict__[name] = _copy_of_space(value)
            elif name not in _SHARED:
                twin.__dict__[name] = copy.deepcopy(value, memo)
        if self._ask is not None:
            twin._given = copy.deepcopy(self._given, memo)
            twin._settings = known(twin._given)
            twin._ask = twin._asking()
        return twin

    def __getstate__(self) -> dict[str, Any]:
        kept = {name: value for name, value in self.__dict__.items() if name not in _MADE}
        return kept | {"_state": self._core.state(b"") if self._seeded else None}

    def __setstate__(self, kept: dict[str, Any]) -> None:
        kept = dict(kept)
        state, seeded = kept.pop("_state"), kept["_seeded"]
        self.__dict__.update(kept)
        self._make(self._task, self._count, self._given)
        self._seeded = seeded
        if state is not None:
            self._core.set_state(state)

    @property
    def frame(self) -> Frame | None:
        """A copy of the frame; None in a task without a referee. See :meth:`frame_of`."""
        return self.frame_of(0)

    def frame_of(self, index: int) -> Frame | None:
        """A copy of the frame of environment ``index``, without its seed and its record."""
        core = self._core.frame(self._index(index))
        return None if core is None else Frame._seen(core)

    @property
    def shot(self) -> Shot:
        """Table, physics and the balls on the table, as a shot without a strike."""
        return self.shot_of(0)

    def shot_of(self, index: int) -> Shot:
        """Likewise, of environment ``index``."""
        return Shot._wrap(self._core.shot(self._index(index)))

    def play_of(self, action: Array, index: int = 0) -> Play:
        """What an action means in environment ``index``.

        That is the strike as it is intended, the place of a cue ball in hand, and the call that is
        made for the agent.

        Args:
            action: Shape (action size,); numbers outside [−1, 1] are clipped.
            index: The environment's number.

        Raises:
            InputError: The action has another shape, or the episode is over.
        """
        row = floats("action", action)
        if row.shape != (self._width,):
            raise InputError(
                "wrong-count", "action", f"found the shape {row.shape}", f"give {(self._width,)}"
            )
        fields = self._core.play(self._index(index), row)
        if fields is None:
            raise InputError(
                "wrong-state", "action", "the episode is over", "reset the environment"
            )
        return Play._read(fields)

    def strike_of(self, action: Array, index: int = 0) -> Strike:
        """The strike of :meth:`play_of`."""
        return self.play_of(action, index).strike

    def observation_of(self, position: Shot | Frame | Mapping[str, Any], index: int = 0) -> Array:
        """What the player who shoots first observes in an episode that starts at ``position``.

        Args:
            position: As for ``reset(options={"shot": position})``.
            index: The environment whose table and physics it has.

        Raises:
            InputError: The task cannot start there.
        """
        return self._core.observe_start(self._index(index), start(position, "position"))

    def branches(
        self,
        actions: Array,
        *,
        index: int = 0,
        seeds: Sequence[int] | Array | None = None,
        threads: int | None = None,
    ) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """The results of many actions from the present state, which does not change.

        Args:
            actions: Shape (n, action size).
            index: The environment's number.
            seeds: One whole number for each action: the errors of strikes, the decisions of the
                opponent and the racks to come are drawn from it. None uses those of the
                environment itself, so that branch k is what ``step`` with action k would return.
            threads: Number of threads; None means one per core.

        Returns:
            Observations, rewards, ``terminated``, ``truncated`` and ``info``, as the step of a
            vector of n environments that do not reset by themselves.

        Raises:
            InputError: The actions have another shape, or there is another number of seeds.
            ResetNeeded: The environment has not been reset yet.
        """
        self._check_seeded("branches")
        rows = floats("actions", actions)
        if rows.ndim != 2 or rows.shape[1] != self._width:
            raise InputError(
                "wrong-count",
                "actions",
                f"found the shape {rows.shape}",
                f"give (n, {self._width})",
            )
        drawn = None if seeds is None else [whole("seeds", seed) for seed in seeds]
        count, threads = len(rows), thread_count(threads)
        copies = self._core.copies(self._index(index), count, drawn, threads)
        return self._results(copies, rows)

    def _results(
        self, core: Core, rows: Array
    ) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """A step of all environments of ``core``, as Gymnasium's vectors return it."""
        info = core.step(rows, self._ask)
        observations, rewards = info.pop("observations"), info.pop("rewards")
        terminated, truncated = info.pop("terminated"), info.pop("truncated")
        count = len(rewards)
        info["fouls"] = infos.all_fouls(info["fouls"])
        if self._has_traces:
            info["traces"] = infos.all_traces(core, count)
        if "why" in info:
            info["why"] = np.array(info["why"], dtype=object)
            info["_winner"] = info["_why"] = terminated | truncated
        if "final_obs" in info:
            ended = terminated | truncated
            last: dict[str, Any] = {"player": np.where(ended, np.int8(-1), np.int8(0))}
            for key in ("legal", "potted", "fouls", "strike", "winner", "why", "traces"):
                if key in info:
                    last[key] = _where(ended, info[key])
            for key in ("winner", "why"):
                del info[key], info[f"_{key}"]
            info["final_info"] = last | {f"_{key}": ended for key in last}
            info["_final_obs"] = info["_final_info"] = ended
        info |= self._about_episodes(core)
        return observations, rewards, terminated, truncated, info

    def _about_episodes(self, core: Core) -> dict[str, Any]:
        """What ``info`` reports of the present episodes: seats, and variables that were drawn."""
        about: dict[str, Any] = {}
        if self._has_opponent:
            about["seat"] = core.seats()
        if self._randomize is not None:
            about["randomized"] = infos.drawn(core, tuple(self._randomize))
        return about

    def _index(self, index: int) -> int:
        return whole("index", index, self._count)

    def _check_seeded(self, method: str) -> None:
        if not self._seeded:
            raise ResetNeeded(f"call reset before {method}")


# What a copy shares: it never changes, or has been copied before.
_SHARED = {"_core", "_given", "_settings", "_ask", "metadata", "spec", "render_mode", "agents"}
# What is made again from the task, the settings and the state.
_MADE = {"_core", "_settings", "_ask", "_width"}


def _bytes(state: Any) -> bytes:
    if not isinstance(state, bytes | bytearray | memoryview):
        found = type(state).__name__
        raise InputError(
            "wrong-type", "state", f"found a {found}", "give the bytes that get_state returned"
        )
    return bytes(state)


def _where(ended: Array, values: Array) -> Array:
    """``values`` where episodes ended; 0, or None for objects, elsewhere."""
    if ended.all():
        return values
    if values.dtype == object:
        out = np.full(values.shape, None, dtype=object)
        out[ended] = values[ended]
        return out
    return values * ended.reshape(-1, *(1,) * (values.ndim - 1))


def _copy_of_space(space: Any) -> Any:
    """The same space with a generator of its own. Its bounds never change."""
    twin = object.__new__(type(space))
    twin.__dict__.update(space.__dict__)
    twin._np_random = copy.deepcopy(space._np_random)
    return twin
