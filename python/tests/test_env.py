"""Environments for reinforcement learning."""

from __future__ import annotations

import copy
import importlib
import json
import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom import _core
from carom.errors import InputError
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AsyncVectorEnv, AutoresetMode, SyncVectorEnv
from gymnasium.wrappers import vector
from pettingzoo.test import api_test, seed_test

NAMES = sorted(carom.env.ENVIRONMENTS)
TASKS = sorted(carom.env.ENVIRONMENTS.values())


def _middle(facts: dict[str, Any]) -> tuple[int, int]:
    """Object balls of a game that begins in the middle: the setting, and additional ones."""
    if facts["objective"] == "caroms":
        return facts["balls"] - 1, 0
    return (2, 6) if facts["objective"] == "reds-and-colors" else (5, 0)


FACTS = {facts["name"]: facts for facts in carom.game_facts()}
MIDDLES = {
    name: _middle(FACTS[task]) for name, task in carom.env.ENVIRONMENTS.items() if task in FACTS
}
NOISE = carom.Noise.olympiad(1.0)

ROOT = Path(__file__).parents[2]
GOLDENS = json.loads((ROOT / "goldens" / "environments.json").read_text())


def play(envs: Any, steps: int, seed: int = 3) -> list[np.ndarray[Any, Any]]:
    """All results of some steps with random actions."""
    random = np.random.default_rng(5)
    shape = envs.action_space.shape
    out = [envs.reset(seed=seed)[0]]
    for _ in range(steps):
        out += envs.step(random.uniform(-1, 1, shape).astype(np.float32))[:4]
    return out


@pytest.fixture(scope="module")
def write_goldens() -> Iterator[ModuleType]:
    """The module scripts/write_goldens.py."""
    sys.path.insert(0, str(ROOT / "scripts"))
    yield importlib.import_module("write_goldens")
    sys.path.remove(str(ROOT / "scripts"))


@pytest.mark.parametrize("name", NAMES)
def test_gymnasiums_checker_accepts_the_environment(name: str) -> None:
    env = gymnasium.make(name, render_mode="rgb_array", noise=NOISE)
    with warnings.catch_warnings():
        # The checker warns about wrapped environments; this one is unwrapped.
        warnings.simplefilter("error")
        check_env(env.unwrapped)


@pytest.mark.parametrize("name", NAMES)
def test_observations_stay_within_their_bounds(name: str) -> None:
    envs = gymnasium.make_vec(name, num_envs=16, noise=NOISE)
    envs.action_space.seed(1)
    observations, _ = envs.reset(seed=1)
    for _ in range(30):
        assert observations.dtype == np.float32
        assert observations in envs.observation_space
        observations, rewards, *_ = envs.step(envs.action_space.sample())
        assert np.isfinite(rewards).all()


@pytest.mark.parametrize("name", NAMES)
def test_an_environment_of_a_vector_equals_the_single_one_with_its_seed(name: str) -> None:
    envs = gymnasium.make_vec(name, num_envs=3, noise=NOISE, autoreset_mode="next-step")
    single = gymnasium.make(name, noise=NOISE)
    random = np.random.default_rng(2)
    actions = random.uniform(-1, 1, (6, *envs.action_space.shape)).astype(np.float32)
    first, _ = envs.reset(seed=7)
    observation, _ = single.reset(seed=9)
    np.testing.assert_array_equal(first[2], observation)
    over = False
    for action in actions:
        row = [part[2] for part in envs.step(action)[:4]]
        if over:
            observation, over = single.reset()[0], False
            np.testing.assert_array_equal(row[0], observation)
            assert row[1:] == [0.0, False, False]
            continue
        observation, reward, terminated, truncated, _ = single.step(action[2])
        np.testing.assert_array_equal(row[0], observation)
        assert row[1:] == [reward, terminated, truncated]
        over = terminated or truncated


@pytest.mark.parametrize("name", NAMES)
def test_the_bits_do_not_depend_on_the_threads(name: str) -> None:
    runs = [
        play(gymnasium.make_vec(name, num_envs=40, noise=NOISE, threads=threads), 6)
        for threads in (1, 3)
    ]
    for one, other in zip(*runs, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("name", NAMES)
def test_a_version_keeps_its_results(name: str, write_goldens: ModuleType) -> None:
    """After an intended change of results, increase the version in the name and the goldens."""
    assert {name: write_goldens.environment_hash(name)} == {name: GOLDENS[name]}


def test_every_task_has_its_name_in_the_registry() -> None:
    assert sorted(_core.tasks()) == TASKS


@pytest.mark.parametrize("name", MIDDLES)
def test_a_game_can_begin_in_the_middle(name: str) -> None:
    balls, besides = MIDDLES[name]
    envs = gymnasium.make_vec(name, num_envs=20, balls=balls, noise=NOISE, patience=10)
    observations, _ = envs.reset(seed=0)
    features = len(_core.meanings()[2])
    seen = observations[:, :-features].reshape(20, -1, 4)
    assert (seen[:, 1:, 2].sum(axis=1) == balls + besides).all()
    # The cue ball is at another place each time.
    assert len(np.unique(seen[:, 0, :2], axis=0)) == 20
    assert (observations[:, -features : 3 - features] == 0).all()
    ended = np.zeros(20, dtype=bool)
    envs.action_space.seed(0)
    for _ in range(40):
        _, _, terminated, truncated, _ = envs.step(envs.action_space.sample())
        ended |= terminated | truncated
    assert ended.any()


def test_different_seeds_give_different_games() -> None:
    envs = gymnasium.make_vec("carom/EightBall-v6", num_envs=4)
    one, other = play(envs, 2, seed=3), play(envs, 2, seed=30)
    assert any((a != b).any() for a, b in zip(one, other, strict=True))


def test_make_vec_steps_in_rust() -> None:
    envs = gymnasium.make_vec("carom/EightBall-v6", num_envs=8)
    assert isinstance(envs.unwrapped, carom.env.CaromVectorEnv)
    assert envs.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP


def test_same_step_mode_returns_the_final_observation_with_the_new_episode() -> None:
    envs = gymnasium.make_vec("carom/Potting-v3", num_envs=5)
    envs.reset(seed=0)
    observations, _, terminated, _, info = envs.step(np.zeros(envs.action_space.shape))
    # An episode of potting is one shot.
    assert terminated.all()
    assert info["_final_obs"].all()
    assert (info["final_obs"] != observations).any(axis=1).all()


def test_same_step_mode_has_the_infos_of_gymnasiums_own_vector() -> None:
    settings = {"balls": 2, "noise": NOISE, "patience": 6}
    ours = gymnasium.make_vec("carom/NineBall-v3", num_envs=3, **settings)
    theirs = SyncVectorEnv(
        [lambda: gymnasium.make("carom/NineBall-v3", **settings)] * 3,
        autoreset_mode=AutoresetMode.SAME_STEP,
    )
    random = np.random.default_rng(0)
    np.testing.assert_array_equal(ours.reset(seed=5)[0], theirs.reset(seed=5)[0])
    ends = 0
    for _ in range(60):
        actions = random.uniform(-1, 1, ours.action_space.shape).astype(np.float32)
        (*row, info), (*wanted, said) = ours.step(actions), theirs.step(actions)
        for one, other in zip(row, wanted, strict=True):
            np.testing.assert_array_equal(one, other)
        assert ("final_info" in info) == ("final_info" in said)
        if "final_info" not in said:
            continue
        ended = said["_final_obs"]
        ends += ended.sum()
        for mask in ("_final_obs", "_final_info"):
            np.testing.assert_array_equal(info[mask], said[mask])
        np.testing.assert_array_equal(info["final_obs"][ended], np.stack(said["final_obs"][ended]))
        assert set(info["final_info"]) == set(said["final_info"])
        for key, value in said["final_info"].items():
            # Gymnasium keeps a tuple of numbers as an object, None where there is none.
            found, wanted = info["final_info"][key], value
            if key == "strike":
                wanted = np.stack([strike or (0.0,) * 5 for strike in value])
            np.testing.assert_array_equal(found, wanted)
            assert (found.dtype == bool) == (wanted.dtype == bool)
    assert ends > 5


@pytest.mark.parametrize("name", ["carom/SumToThree-v3", "carom/NineBall-v3"])
def test_max_episode_steps_limits_the_episodes_of_a_vector(name: str) -> None:
    envs = gymnasium.make_vec(name, num_envs=2, max_episode_steps=3)
    envs.reset(seed=0)
    gentle = np.full(envs.action_space.shape, -0.9, dtype=np.float32)
    truncated = [envs.step(gentle)[3].tolist() for _ in range(6)]
    assert truncated == [[False] * 2, [False] * 2, [True] * 2] * 2


@pytest.mark.parametrize("name", NAMES)
def test_a_deep_copy_is_independent_and_in_the_same_state(name: str) -> None:
    env = gymnasium.make(name, noise=NOISE)
    env.reset(seed=4)
    env.action_space.seed(0)
    one, other = env.action_space.sample(), env.action_space.sample()
    tried = copy.deepcopy(env).step(one)
    copy.deepcopy(env).step(other)
    again = env.step(one)
    np.testing.assert_array_equal(tried[0], again[0])
    assert tried[1:] == again[1:]


def test_the_environments_work_in_gymnasiums_vectors_and_wrappers() -> None:
    def make() -> gymnasium.Env[Any, Any]:
        return gymnasium.make("carom/NineBall-v3", balls=2)

    ours = gymnasium.make_vec("carom/NineBall-v3", num_envs=3, balls=2, autoreset_mode="next-step")
    rows = [play(envs, 8) for envs in (SyncVectorEnv([make] * 3), AsyncVectorEnv([make] * 3), ours)]
    for one, two, three in zip(*rows, strict=True):
        np.testing.assert_array_equal(one, two)
        np.testing.assert_array_equal(one, three)
    for wrapper in (
        vector.RecordEpisodeStatistics,
        vector.NormalizeObservation,
        vector.NormalizeReward,
        vector.FlattenObservation,
    ):
        play(wrapper(ours), 8)


def test_a_vector_with_autoreset_disabled_is_reset_by_mask() -> None:
    envs = gymnasium.make_vec("carom/Potting-v3", num_envs=3, autoreset_mode="disabled")
    first, _ = envs.reset(seed=0)
    last, *_ = envs.step(np.zeros(envs.action_space.shape))
    mask = np.array([True, False, True])
    after, _ = envs.reset(options={"reset_mask": mask})
    np.testing.assert_array_equal(after[1], last[1])
    assert (after[mask] != last[mask]).any(axis=1).all()
    assert (after[mask] != first[mask]).any(axis=1).all()


def test_relative_aim_pots_often_and_is_rewarded() -> None:
    envs = gymnasium.make_vec("carom/Potting-v3", num_envs=2000, aim="relative")
    envs.reset(seed=0)
    actions = np.zeros(envs.action_space.shape, dtype=np.float32)
    actions[:, 4] = -1
    _, rewards, *_, info = envs.step(actions)
    assert set(np.unique(rewards)) == {0.0, 1.0}
    np.testing.assert_array_equal(rewards, (info["potted"] > 0).astype(float))
    # A full hit sends the ball along the line of centres, seldom into a pocket.
    assert 0.01 < rewards.mean() < 0.3


def test_noise_makes_potting_harder() -> None:
    def potted(noise: carom.Noise | None) -> float:
        match = gymnasium.make_vec(
            "carom/EightBall-v6", num_envs=300, opponent="potter", noise=noise, balls=(4, 6)
        )
        match.reset(seed=0)
        wild = np.zeros(match.action_space.shape, dtype=np.float32)
        return sum(float(match.step(wild)[1].sum()) for _ in range(5))

    # The opponent earns what the agent loses.
    assert potted(None) < potted(carom.Noise.olympiad(20.0))


@pytest.mark.parametrize("opponent", ["random", "potter"])
@pytest.mark.parametrize("name", ["carom/EightBall-v6", "carom/NineBall-v3", "carom/Snooker-v6"])
def test_with_an_opponent_the_agent_always_shoots_next(name: str, opponent: str) -> None:
    envs = gymnasium.make_vec(name, num_envs=8, opponent=opponent, noise=NOISE, patience=20)
    envs.action_space.seed(0)
    envs.reset(seed=0)
    for _ in range(20):
        *_, info = envs.step(envs.action_space.sample())
        assert (info["player"] == 0).all()


@pytest.mark.parametrize("opponent", ["level-1:20", "carom:20", "greedy[aim=simulated]:20"])
@pytest.mark.parametrize("name", ["carom/EightBall-v6", "carom/ThreeCushion-v6"])
def test_a_built_in_player_replies_with_the_same_bits_for_any_number_of_threads(
    name: str, opponent: str
) -> None:
    def results(opponent: str, threads: int) -> list[np.ndarray[Any, Any]]:
        envs = gymnasium.make_vec(
            name, num_envs=4, opponent=opponent, noise=NOISE, balls=2, threads=threads
        )
        return play(envs, 2)

    one = results(opponent, 1)
    for threads in (2, 3):
        for a, b in zip(one, results(opponent, threads), strict=True):
            np.testing.assert_array_equal(a, b)
    potter = results("potter", 1)
    assert any((a != b).any() for a, b in zip(one, potter, strict=True))


def test_a_frame_against_a_level_ends_by_its_rules() -> None:
    env = gymnasium.make(
        "carom/NineBall-v3", opponent="level-1:20", balls=2, aim="relative", patience=20
    )
    env.action_space.seed(0)
    env.reset(seed=1)
    for _ in range(100):
        _, reward, terminated, truncated, info = env.step(env.action_space.sample())
        if terminated or truncated:
            break
        assert info["player"] == 0
    assert terminated
    assert abs(reward) > 0.5
    assert info["player"] == -1


@pytest.mark.parametrize("task", ["potting", "sum-to-three"])
def test_a_task_without_a_referee_has_no_player_as_its_opponent(task: str) -> None:
    with pytest.raises(InputError, match=r"^opponent: .*; (leave it out|write none, random)"):
        carom.env.CaromEnv(task, opponent="level-2")


@pytest.mark.parametrize(
    ("opponent", "message"),
    [
        ("someone", r'^opponent: there is no "someone"; write one of none, .*, level-1, .*200'),
        ("carom:0", r"^opponent: .*; write a whole number from 1"),
        ("carom[finalists=-1]", r"^opponent\.finalists: "),
        ("cue-card:9000000", r"^opponent: .*; give a number up to 5000000"),
    ],
)
def test_an_unknown_opponent_is_refused_with_a_remedy(opponent: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        carom.env.CaromEnv("nine-ball", opponent=opponent)


@pytest.mark.parametrize("name", ["carom/ThreeCushion-v6", "carom/SumToThree-v3"])
def test_the_shooter_continues_after_a_point(name: str) -> None:
    envs = gymnasium.make_vec(name, num_envs=200)
    envs.action_space.seed(0)
    envs.reset(seed=0)
    player = np.zeros(200, dtype=np.int8)
    scored = 0
    for _ in range(10):
        _, rewards, _, _, info = envs.step(envs.action_space.sample())
        point = rewards > 0
        np.testing.assert_array_equal(info["player"], np.where(point, player, 1 - player))
        player = info["player"]
        scored += point.sum()
    # Random shots score now and then.
    assert scored > 5


def test_episodes_end_even_if_nothing_is_hit() -> None:
    envs = gymnasium.make_vec("carom/SumToThree-v3", num_envs=2, patience=5)
    envs.reset(seed=0)
    gentle = np.tile(np.float32([0, -1, 0, 0, -1]), (2, 1))
    truncated = [envs.step(gentle)[3] for _ in range(5)]
    assert not np.any(truncated[:4])
    assert truncated[4].all()


def test_actions_out_of_bounds_are_clipped_and_nan_counts_as_zero() -> None:
    envs = gymnasium.make_vec("carom/EightBall-v6", num_envs=1)
    envs.reset(seed=0)
    out = envs.step(np.full(envs.action_space.shape, 9.0, dtype=np.float32))
    envs.reset(seed=0)
    same = envs.step(np.ones(envs.action_space.shape, dtype=np.float32))
    np.testing.assert_array_equal(out[0], same[0])
    envs.reset(seed=0)
    out = envs.step(np.full(envs.action_space.shape, np.nan, dtype=np.float32))
    envs.reset(seed=0)
    same = envs.step(np.zeros(envs.action_space.shape, dtype=np.float32))
    np.testing.assert_array_equal(out[0], same[0])


@pytest.mark.parametrize(
    ("settings", "place"),
    [
        ({"balls": 0}, "balls"),
        ({"balls": (3, 2)}, "balls"),
        ({"balls": 99}, "balls"),
        ({"balls": "many"}, "balls"),
        ({"aim": "straight"}, "aim"),
        ({"opponent": "potter"}, "opponent"),
        ({"speed": (2.0, 1.0)}, "speed"),
        ({"speed": 2.0}, "speed"),
        ({"max_elevation": 2.0}, "max_elevation"),
        ({"max_elevation": "steep"}, "max_elevation"),
        ({"balls": True}, "balls"),
        ({"balls": 2.5}, "balls"),
        ({"balls": (1, 2, 3)}, "balls"),
        ({"threads": -1}, "threads"),
        ({"patience": 2.5}, "patience"),
        ({"points": "many"}, "points"),
        ({"max_episode_steps": 0}, "max_episode_steps"),
        ({"aim": None}, "aim"),
        ({"opponent": None}, "opponent"),
        ({"nois": NOISE}, 'nois: there is no such setting; did you mean "noise"'),
        ({"render_mode": "human"}, "render_mode"),
        ({"target_ball": "highest"}, "target_ball"),
        ({"table": "carom-10ft"}, "table"),
        ({"noise": 1.0}, "noise"),
        ({"rewards": 1.0}, "rewards"),
        ({"points": 2**40}, "points"),
        ({"threads": 0}, "threads"),
    ],
)
def test_an_invalid_setting_is_refused_by_name(settings: dict[str, Any], place: str) -> None:
    with pytest.raises(InputError, match=rf"^{place}"):
        carom.env.CaromEnv("potting", **settings)


@pytest.mark.parametrize("value", ["much", float("nan"), float("inf"), None])
def test_a_reward_that_is_not_a_finite_number_is_refused_by_name(value: Any) -> None:
    with pytest.raises(InputError, match=r"^rewards\.foul: .*; write"):
        carom.env.Rewards(foul=value)


def test_the_old_name_of_points_still_works_and_warns() -> None:
    with pytest.warns(FutureWarning, match=r"settings\.target is now settings\.points"):
        old = gymnasium.make_vec("carom/SumToThree-v3", num_envs=4, target=1)
    new = gymnasium.make_vec("carom/SumToThree-v3", num_envs=4, points=1)
    for one, other in zip(play(old, 5), play(new, 5), strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("count", [0, -1, 2.5, 10**6 + 1, "many"])
def test_a_number_of_environments_out_of_range_is_refused(count: Any) -> None:
    with pytest.raises(InputError, match=r"^num_envs: .*; give a whole number from 1 to 1000000"):
        carom.env.CaromVectorEnv("nine-ball", count)


@pytest.mark.parametrize("options", [5, "all", [True]])
def test_options_of_a_reset_that_are_not_a_dict_are_refused(options: Any) -> None:
    with pytest.raises(InputError, match=r"^options: .*; give"):
        carom.env.CaromVectorEnv("nine-ball", 1).reset(seed=0, options=options)


def test_numpy_integers_are_accepted_as_counts() -> None:
    three = np.int64(3)
    envs = gymnasium.make_vec("carom/NineBall-v3", num_envs=three, balls=three)
    same = gymnasium.make_vec("carom/NineBall-v3", num_envs=3, balls=3)
    for one, other in zip(play(envs, 2, seed=three), play(same, 2), strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("shape", [(7,), (7, 2), (14,), (3, 7), (2, 5)])
def test_actions_of_another_shape_are_refused(shape: tuple[int, ...]) -> None:
    envs = gymnasium.make_vec("carom/NineBall-v3", num_envs=2)
    envs.reset(seed=0)
    with pytest.raises(InputError, match=r"^actions: found the shape .*; give \(2, 7\)"):
        envs.step(np.zeros(shape))


@pytest.mark.parametrize("action", ["left", None, [["a"] * 7], {}])
def test_actions_that_are_not_numbers_are_refused(action: Any) -> None:
    for env in (carom.env.CaromEnv("nine-ball"), carom.env.CaromVectorEnv("nine-ball", 1)):
        env.reset(seed=0)
        with pytest.raises(InputError, match=r"^actions?: "):
            env.step(action)


def test_single_environments_accept_the_same_seeds_as_vectors() -> None:
    env = carom.env.CaromEnv("nine-ball")
    (first, _), (same, _) = env.reset(seed=np.int64(3)), env.reset(seed=3)  # type: ignore[arg-type]
    np.testing.assert_array_equal(first, same)
    match = carom.env.aec("nine-ball")
    for seed in (-1, 1.5, "x"):
        with pytest.raises(InputError, match=r"^seed: "):
            env.reset(seed=seed)  # type: ignore[arg-type]
        with pytest.raises(InputError, match=r"^seed: "):
            match.reset(seed=seed)


@pytest.mark.parametrize("seed", [-1, 2**64, 1.5, "x", [1], [1, None], [1, -1]])
def test_invalid_seeds_are_refused(seed: Any) -> None:
    envs = gymnasium.make_vec("carom/NineBall-v3", num_envs=2)
    with pytest.raises(InputError, match=r"^seeds?: "):
        envs.reset(seed=seed)


@pytest.mark.parametrize("mask", [[True], "xx", [0, 1], [[True, False]]])
def test_invalid_masks_are_refused(mask: Any) -> None:
    envs = gymnasium.make_vec("carom/NineBall-v3", num_envs=2, autoreset_mode="disabled")
    envs.reset(seed=0)
    with pytest.raises(InputError, match=r"^reset_mask: "):
        envs.reset(options={"reset_mask": mask})


@pytest.mark.parametrize(
    "env",
    [
        carom.env.CaromEnv("nine-ball"),
        carom.env.CaromVectorEnv("nine-ball", 1),
        carom.env.aec("nine-ball"),
    ],
)
def test_a_step_before_the_first_reset_is_refused(env: Any) -> None:
    with pytest.raises(ResetNeeded, match="reset"):
        env.step(np.zeros((1, 7)))


def test_a_picture_is_an_array_of_pixels() -> None:
    env = gymnasium.make("carom/Snooker-v6", render_mode="rgb_array")
    env.reset(seed=0)
    picture = env.render()
    assert isinstance(picture, np.ndarray)
    assert picture.dtype == np.uint8
    assert picture.shape[2] == 3
    # Many balls of many colours on green cloth.
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 100


@pytest.mark.parametrize("game", [task for task in TASKS if task != "potting"])
def test_pettingzoos_tests_accept_the_match(game: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        api_test(carom.env.aec(game), num_cycles=100)
        seed_test(lambda: carom.env.aec(game), num_cycles=20)


def test_a_match_is_a_zero_sum_game() -> None:
    match = carom.env.aec("nine-ball", patience=10, noise=NOISE)
    match.reset(seed=1)
    for agent in match.agents:
        match.action_space(agent).seed(1)
    totals = dict.fromkeys(match.agents, 0.0)
    for agent in match.agent_iter():
        _, reward, terminated, truncated, _ = match.last()
        totals[agent] += reward
        done = terminated or truncated
        match.step(None if done else match.action_space(agent).sample())
    assert sum(totals.values()) == pytest.approx(0.0)
    assert any(totals.values())


def test_carom_is_imported_without_gymnasium() -> None:
    code = "import sys, carom; assert not {'gymnasium', 'pettingzoo'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_an_environment_names_its_presets_with_dates() -> None:
    env = carom.env.CaromVectorEnv("nine-ball", 2)
    assert env.presets == {"table": "wpa-9ft-2026-12"}
    again = carom.env.CaromVectorEnv("nine-ball", 2, **env.presets)
    assert np.array_equal(again.reset(seed=3)[0], env.reset(seed=3)[0])
    pool = carom.env.CaromVectorEnv("three-cushion", physics="pool-worn-cloth")
    assert pool.presets["physics"] == "pool-worn-cloth-2026-12"
