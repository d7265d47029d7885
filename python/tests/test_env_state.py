"""Saved states, copies and branches of environments, and their use from several threads."""

from __future__ import annotations

import concurrent.futures
import copy
import pickle
import threading
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom.errors import CaromError, InputError
from gymnasium.error import ResetNeeded

NAMES = sorted(carom.env.ENVIRONMENTS)
NOISE = carom.Noise.olympiad(1.0)
RANDOMIZED = {"cloth.rolling_friction": (0.008, 0.012)}


def actions_of(envs: Any, steps: int, seed: int = 5) -> np.ndarray[Any, Any]:
    shape = (steps, *envs.action_space.shape)
    return np.random.default_rng(seed).uniform(-1, 1, shape).astype(np.float32)


def run(envs: Any, actions: Any) -> list[Any]:
    """All results of these steps; an episode of a single environment is reset at its end."""
    out: list[Any] = []
    for action in actions:
        observation, reward, terminated, truncated, info = envs.step(action)
        out += [observation, reward, terminated, truncated, info["player"]]
        if isinstance(envs, gymnasium.Env) and (terminated or truncated):
            out.append(envs.reset()[0])
    return out


def assert_same(one: list[Any], other: list[Any]) -> None:
    assert len(one) == len(other)
    for a, b in zip(one, other, strict=True):
        np.testing.assert_array_equal(a, b)


@pytest.mark.parametrize("name", NAMES)
def test_a_state_restores_a_single_environment_and_a_vector_to_the_bit(name: str) -> None:
    settings: dict[str, Any] = {"noise": NOISE, "patience": 5}
    for make in (
        lambda: gymnasium.make(name, **settings).unwrapped,
        lambda: gymnasium.make_vec(name, num_envs=20, **settings),
    ):
        env: Any = make()
        env.reset(seed=3)
        actions = actions_of(env, 18)
        run(env, actions[:6])
        state = env.get_state()
        assert isinstance(state, bytes)
        expected = run(env, actions[6:])
        for other in (env, make()):
            other.set_state(state)
            assert other.get_state() == state
            assert_same(run(other, actions[6:]), expected)


@pytest.mark.parametrize("name", ["carom/Potting-v3", "carom/EightBall-v6", "carom/Snooker-v6"])
@pytest.mark.parametrize("way", ["pickle", "deepcopy", "copy"])
def test_a_copy_continues_with_the_same_bits_and_is_independent(name: str, way: str) -> None:
    twin_of: Any = {
        "pickle": lambda env: pickle.loads(pickle.dumps(env)),
        "deepcopy": copy.deepcopy,
        "copy": lambda env: env.copy(),
    }[way]
    for env in (
        gymnasium.make(name, noise=NOISE, randomize=RANDOMIZED).unwrapped,
        gymnasium.make_vec(name, num_envs=10, noise=NOISE, opponent="none", randomize=RANDOMIZED),
    ):
        env.reset(seed=4)
        actions = actions_of(env, 10)
        run(env, actions[:3])
        twin = twin_of(env)
        run(twin_of(env), actions[::-1])
        assert_same(run(twin, actions[3:]), run(env, actions[3:]))


def test_wrapped_environments_can_be_pickled_with_their_wrappers() -> None:
    env = gymnasium.make("carom/NineBall-v3", balls=3, max_episode_steps=4, noise=NOISE)
    env.reset(seed=1)
    env.action_space.seed(2)
    env.step(env.action_space.sample())
    twin = pickle.loads(pickle.dumps(env))
    ends = [[one.step(one.action_space.sample())[3] for _ in range(3)] for one in (env, twin)]
    assert ends[0] == ends[1]
    assert ends[0][-1]
    fresh = pickle.loads(pickle.dumps(gymnasium.make("carom/NineBall-v3")))
    fresh.reset(seed=1)


def test_a_match_is_restored_and_pickled_to_the_bit() -> None:
    match = carom.env.aec("eight-ball", balls=(2, 4), noise=NOISE, patience=6)
    match.reset(seed=7)
    actions = actions_of(carom.env.CaromEnv("eight-ball"), 12)

    def play(one: Any, rows: Any) -> list[Any]:
        out: list[Any] = []
        for row in rows:
            observation, reward, terminated, truncated, info = one.last()
            out += [one.agent_selection, observation, reward, info["player"]]
            if terminated or truncated:
                break
            one.step(row)
        return out

    play(match, actions[:3])
    twin = pickle.loads(pickle.dumps(match))
    third = copy.deepcopy(match)
    expected = play(match, actions[3:])
    assert play(twin, actions[3:]) is not None
    for a, b in zip(play(third, actions[3:]), expected, strict=True):
        np.testing.assert_array_equal(a, b)


def saved(task: str = "nine-ball", **settings: Any) -> bytes:
    env = carom.env.CaromEnv(task, **settings)
    env.reset(seed=1)
    return env.get_state()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda state: b"", "not the state of environments"),
        (lambda state: pickle.dumps({"state": 1}), "not the state of environments"),
        (lambda state: state[:-1], "damaged"),
        (lambda state: state[:60], "damaged"),
        (lambda state: state[:-20] + bytes([state[-20] ^ 1]) + state[-19:], "damaged"),
        (
            lambda state: state.replace(b"carom-environments\x02", b"carom-environments\x63"),
            "version",
        ),
        (lambda state: saved("ten-ball"), "saved with task ten-ball, and here it is nine-ball"),
        (lambda state: saved(balls=3), "saved with balls"),
        (lambda state: saved(noise=NOISE), "saved with noise"),
        (lambda state: saved(physics="pool-worn-cloth"), "saved with physics"),
        (lambda state: saved(opponent="potter"), "saved with opponent potter"),
        (lambda state: "state", "found a str"),
    ],
)
def test_bytes_of_another_kind_are_refused_and_change_nothing(change: Any, message: str) -> None:
    env = carom.env.CaromEnv("nine-ball")
    env.reset(seed=1)
    before = env.get_state()
    with pytest.raises(InputError, match=rf"^state: .*{message}.*; "):
        env.set_state(change(before))
    assert env.get_state() == before


def test_a_state_does_not_depend_on_threads_and_fits_another_number_of_them() -> None:
    states = []
    for threads in (1, 3):
        envs = carom.env.CaromVectorEnv("nine-ball", 40, threads=threads, noise=NOISE)
        envs.reset(seed=2)
        run(envs, actions_of(envs, 3))
        states.append(envs.get_state())
    assert states[0] == states[1]


def test_a_state_before_the_first_reset_is_refused() -> None:
    with pytest.raises(ResetNeeded, match="reset before get_state"):
        carom.env.CaromEnv("nine-ball").get_state()


def test_branches_are_the_steps_of_copies_and_leave_the_state() -> None:
    for env in (
        carom.env.CaromEnv("nine-ball", noise=NOISE, opponent="potter", balls=4),
        carom.env.CaromVectorEnv("nine-ball", 3, noise=NOISE, opponent="potter", balls=4),
    ):
        env.reset(seed=1)
        state = env.get_state()
        actions = actions_of(carom.env.CaromEnv("nine-ball"), 30)
        observations, rewards, terminated, truncated, info = env.branches(actions)
        assert env.get_state() == state
        assert observations.shape == (30, *carom.env.CaromEnv("nine-ball").observation_space.shape)
        single = carom.env.CaromEnv("nine-ball", noise=NOISE, opponent="potter", balls=4)
        single.reset(seed=1)
        for k, action in enumerate(actions):
            step = single.copy().step(action)
            np.testing.assert_array_equal(observations[k], step[0])
            assert (rewards[k], terminated[k], truncated[k]) == step[1:4]
            assert info["fouls"][k] == step[4]["fouls"]


def test_branches_with_seeds_have_errors_of_their_own() -> None:
    env = carom.env.CaromEnv("potting", noise=NOISE, aim="relative")
    env.reset(seed=1)
    actions = np.zeros((50, 5), dtype=np.float32)
    strikes = env.branches(actions)[4]["strike"]
    assert len(np.unique(strikes, axis=0)) == 1
    drawn = env.branches(actions, seeds=range(50))[4]["strike"]
    assert len(np.unique(drawn, axis=0)) == 50
    np.testing.assert_array_equal(drawn, env.branches(actions, seeds=range(50))[4]["strike"])


@pytest.mark.parametrize("actions", [np.zeros(7), np.zeros((2, 6)), np.zeros((1, 2, 7))])
def test_branches_of_another_shape_are_refused(actions: Any) -> None:
    env = carom.env.CaromEnv("nine-ball")
    env.reset(seed=1)
    with pytest.raises(InputError, match=r"^actions: found the shape .*; give \(n, 7\)"):
        env.branches(actions)
    with pytest.raises(InputError, match=r"^seeds: .*2"):
        env.branches(np.zeros((2, 7)), seeds=[1])


def test_a_vector_that_two_threads_use_says_so_in_a_sentence() -> None:
    entered, leave = threading.Event(), threading.Event()

    def policy(rows: Any) -> Any:
        entered.set()
        assert leave.wait(60)
        return np.zeros((len(rows), 7), dtype=np.float32)

    envs = carom.env.CaromVectorEnv("nine-ball", 2, opponent=policy, seat=1)
    leave.set()
    envs.reset(seed=0)
    entered.clear()
    leave.clear()
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        first = pool.submit(envs.reset, seed=0)
        assert entered.wait(60)
        for use in (envs.get_state, envs.copy, lambda: envs.reset(seed=0)):
            with pytest.raises(
                CaromError, match=r"^environment: another thread.* uses it now; give"
            ):
                use()
        leave.set()
        first.result()
    envs.get_state()
