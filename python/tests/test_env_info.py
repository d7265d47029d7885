"""What environments report, where they start, and what their actions and observations mean."""

from __future__ import annotations

from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom.errors import InputError

NAMES = sorted(carom.env.ENVIRONMENTS)
GAMES = sorted(
    task for task in carom.env.ENVIRONMENTS.values() if task not in ("potting", "sum-to-three")
)
NOISE = carom.Noise.olympiad(1.0)
POOL = {"cue": (0.45, 0.75), "1": (0.80, 1.45), "9": (0.3, 2.0)}


@pytest.mark.parametrize("name", NAMES)
def test_reset_tells_the_player_who_shoots(name: str) -> None:
    single = gymnasium.make(name)
    assert single.reset(seed=0)[1]["player"] == 0
    assert single.reset()[1]["player"] == 0
    vector = gymnasium.make_vec(name, num_envs=4)
    _, info = vector.reset(seed=0)
    assert info["player"].tolist() == [0] * 4
    assert info["player"].dtype == np.int8
    if name != "carom/Potting-v3":
        match = carom.env.aec(carom.env.ENVIRONMENTS[name])
        match.reset(seed=0)
        assert [match.infos[agent]["player"] for agent in match.agents] == [0, 0]


@pytest.mark.parametrize("key", ["balls", "sho", "reset_mask "])
def test_an_unknown_option_of_reset_is_refused_with_the_known_ones(key: str) -> None:
    for env in (
        carom.env.CaromEnv("nine-ball"),
        carom.env.CaromVectorEnv("nine-ball", 2),
        carom.env.aec("nine-ball"),
    ):
        with pytest.raises(InputError, match=rf"^options\.{key}: .*\(known: .*shot, frame"):
            env.reset(seed=0, options={key: 3})  # type: ignore[attr-defined]
        env.reset(seed=0, options={})  # type: ignore[attr-defined]


def places(observation: Any, env: Any) -> dict[int, tuple[float, float]]:
    """The places of the balls in an observation, m, by index."""
    rows = observation[: -len(carom.env.FEATURES)].reshape(-1, 4)
    size = np.array([1.27, 2.54])
    return {k: tuple((row[:2] + 1) / 2 * size) for k, row in enumerate(rows) if row[2]}


def test_reset_starts_from_a_shot_or_its_dict_in_every_kind_of_environment() -> None:
    shot = carom.Shot("wpa-9ft", POOL)
    for start in (shot, shot.to_dict(), carom.Frame.of_shot("nine-ball", shot)):
        env = carom.env.CaromEnv("nine-ball")
        observation, info = env.reset(seed=1, options={"shot": start})
        found = places(observation, env)
        assert sorted(found) == [0, 1, 9]
        for k, ball in ((0, "cue"), (1, "1"), (9, "9")):
            assert found[k] == pytest.approx(POOL[ball], abs=1e-6)
        assert info["player"] == 0
        vector = carom.env.CaromVectorEnv("nine-ball", 3)
        rows, _ = vector.reset(seed=1, options={"shot": start})
        np.testing.assert_array_equal(rows, [observation] * 3)
        match = carom.env.aec("nine-ball")
        match.reset(seed=1, options={"shot": start})
        np.testing.assert_array_equal(match.observe("player_0"), observation)
    # The next episode has the environment's own start again.
    np.testing.assert_array_equal(
        env.reset(seed=1)[0], carom.env.CaromEnv("nine-ball").reset(seed=1)[0]
    )


def test_a_vector_starts_each_environment_at_its_own_shot() -> None:
    shots = [carom.Shot("wpa-9ft", {**POOL, "1": (0.6 + 0.1 * k, 1.3)}) for k in range(2)]
    envs = carom.env.CaromVectorEnv("nine-ball", 3, autoreset_mode="disabled")
    rows, _ = envs.reset(seed=1, options={"shot": [shots[0], None, shots[1]]})
    assert places(rows[0], envs)[1] == pytest.approx((0.6, 1.3), abs=1e-6)
    assert places(rows[2], envs)[1] == pytest.approx((0.7, 1.3), abs=1e-6)
    assert len(places(rows[1], envs)) == 10
    mask = np.array([False, True, False])
    rows, _ = envs.reset(options={"shot": shots[0], "reset_mask": mask})
    assert places(rows[1], envs)[1] == pytest.approx((0.6, 1.3), abs=1e-6)
    assert places(rows[2], envs)[1] == pytest.approx((0.7, 1.3), abs=1e-6)


def test_reset_starts_from_a_frame_or_its_record_with_scores_and_requests() -> None:
    frame = carom.Frame("straight-pool", seed=3, points=100)
    frame.play(carom.Strike(1.0, 1.5), cue_ball=(0.635, 0.6), call=carom.Call.safety())
    frame.choose(frame.request.choices[0])
    for start in (frame, frame.record):
        env = carom.env.CaromEnv("straight-pool")
        observation, info = env.reset(seed=1, options={"frame": start})
        assert info["player"] == frame.player
        copied = env.frame
        assert copied is not None
        assert copied.to_dict() == frame.to_dict()
        np.testing.assert_array_equal(env.observation_of(frame), observation)


def test_potting_starts_from_any_of_its_balls() -> None:
    env = carom.env.CaromEnv("potting", balls=3, aim="relative")
    shot = carom.Shot("wpa-9ft", {"3": (1.1, 2.3), "cue": (0.9, 2.0)})
    env.reset(seed=1, options={"shot": shot})
    assert set(env.shot.ids) == {"cue", "3"}
    aims = np.zeros((201, 5), dtype=np.float32)
    aims[:, 0] = np.linspace(-1, 1, 201)
    rewards = env.branches(aims)[1]
    assert rewards.max() == 1.0


@pytest.mark.parametrize(
    ("task", "start", "message"),
    [
        ("nine-ball", carom.Shot("wpa-8ft", POOL), "table: the shot is on another table"),
        (
            "nine-ball",
            carom.Shot("wpa-9ft", POOL, physics="ideal"),
            "physics: .*make the environment",
        ),
        (
            "nine-ball",
            carom.Shot("wpa-9ft", {"cue": (0.4, 0.7), "15": (0.8, 1.4)}),
            r"balls\[1\]\.id",
        ),
        (
            "nine-ball",
            carom.Shot("wpa-9ft", {"cue": (0.4, 0.7), "1": (0.8, 1.4)}),
            "places: the 9 is down",
        ),
        ("nine-ball", carom.Frame("ten-ball"), "frame: it is ten-ball, not nine-ball"),
        ("nine-ball", {"format": "carom-shot/1"}, r"options\.shot: "),
        ("nine-ball", 7, r"options\.shot: found a int; give a carom\.Shot"),
        ("nine-ball", [carom.Shot("wpa-9ft", POOL)] * 2, r"options\.shot: there are 2 for 1"),
        ("potting", carom.Shot("wpa-9ft", POOL), r"balls\[2\]\.id: the task has no ball \"9\""),
        ("potting", carom.Shot("wpa-9ft", {"cue": (0.4, 0.7)}), "balls: a ball to pot is missing"),
        ("potting", carom.Frame("nine-ball"), "shot: the task has no frames"),
    ],
)
def test_a_start_that_the_task_cannot_have_is_refused(task: str, start: Any, message: str) -> None:
    env = carom.env.CaromEnv(task)
    with pytest.raises(InputError, match=rf"^{message}"):
        env.reset(seed=0, options={"shot": start})
    env.reset(seed=0)


def test_info_tells_fouls_the_strike_and_the_end_of_an_episode() -> None:
    env = carom.env.CaromEnv("nine-ball")
    env.reset(seed=1, options={"shot": carom.Shot("wpa-9ft", POOL)})
    away = np.array([-0.5, -0.8, 0, 0, 0, 0, 0], dtype=np.float32)
    info = env.step(away)[4]
    assert info["fouls"] == ("no ball was hit",)
    assert not info["legal"]
    assert "winner" not in info
    assert len(info["strike"]) == 5
    assert carom.Strike(*info["strike"]).speed > 0
    # Two more fouls in a row of player 0 lose the rack; player 1 fouls too.
    for _ in range(10):
        *_, terminated, _, info = env.step(away)
        if terminated:
            break
    assert (info["winner"], info["why"]) == (1, "three fouls in a row")
    assert info["player"] == -1


def test_info_of_a_vector_tells_the_ends_of_its_episodes() -> None:
    for mode in ("same-step", "disabled"):
        envs = carom.env.CaromVectorEnv("potting", 300, aim="relative", autoreset_mode=mode)
        envs.reset(seed=0)
        *_, info = envs.step(np.zeros(envs.action_space.shape))
        last = info["final_info"] if mode == "same-step" else info
        assert set(last["why"]) == {"the shot was played"}
        assert (last["winner"] == -1).all()
        assert last["_why"].all()
        assert any(fouls == ("the cue ball was pocketed",) for fouls in info["fouls"])
        np.testing.assert_array_equal(info["legal"], [not fouls for fouls in info["fouls"]])
    limited = carom.env.CaromEnv("nine-ball", max_episode_steps=1)
    limited.reset(seed=0)
    soft = np.array([0.5, -0.9, 0, 0, 0, 0, 0], dtype=np.float32)
    assert limited.step(soft)[4]["why"] == "the limit of steps was reached"


def test_traces_on_request_show_the_agents_shot_and_the_replies() -> None:
    settings: dict[str, Any] = {"opponent": "potter", "balls": 3, "noise": NOISE, "traces": True}
    env = carom.env.CaromEnv("nine-ball", **settings)
    env.reset(seed=2)
    info = env.step(np.array([0.3, -0.2, 0, 0, 0, 0, 0], dtype=np.float32))[4]
    assert len(info["traces"]) > 1
    strike = info["traces"][0].shot.to_dict()["strike"]
    assert strike["speed"] == info["strike"][0]
    assert np.deg2rad(strike["azimuth_deg"]) == pytest.approx(info["strike"][1], abs=1e-12)
    end = {
        ball: tuple(at[:2])
        for ball, at in zip(
            info["traces"][-1].shot.ids,
            info["traces"][-1].at(info["traces"][-1].duration).position,
            strict=True,
        )
    }
    for ball, at in env.frame.balls.items() if env.frame else ():
        if env.frame and not env.frame.request.in_hand:
            assert end[ball] == pytest.approx(at, abs=1e-9)
    vector = carom.env.CaromVectorEnv("nine-ball", 2, **settings)
    vector.reset(seed=2)
    rows = vector.step(np.tile(np.float32([0.3, -0.2, 0, 0, 0, 0, 0]), (2, 1)))[4]["traces"]
    assert [trace.hash for trace in rows[0]] == [trace.hash for trace in info["traces"]]


@pytest.mark.parametrize("task", GAMES)
def test_an_action_is_the_play_that_the_frame_takes(task: str) -> None:
    """Playing what ``play_of`` tells in a copy of the frame gives the table of the environment."""
    env = carom.env.CaromEnv(task)
    env.reset(seed=3)
    env.action_space.seed(3)
    for _ in range(3):
        action = env.action_space.sample()
        frame, play = env.frame, env.play_of(action)
        assert frame is not None
        assert env.strike_of(action) == play.strike
        frame.play(play.strike, cue_ball=play.cue_ball, call=play.call)
        *_, terminated, truncated, info = env.step(action)
        struck = [
            getattr(play.strike, key) for key in ("speed", "azimuth", "elevation", "side", "height")
        ]
        np.testing.assert_allclose(info["strike"], struck, rtol=0, atol=1e-12)
        if terminated or truncated or frame.request.kind != "shot":
            break
        assert env.frame is not None
        assert env.frame.balls == frame.balls


def test_an_observation_of_a_shot_is_that_of_an_episode_that_starts_there() -> None:
    env = carom.env.CaromVectorEnv("nine-ball", 2)
    env.reset(seed=0)
    shot = carom.Shot("wpa-9ft", POOL)
    state = env.get_state()
    seen = env.observation_of(shot.to_dict(), index=1)
    assert env.get_state() == state
    np.testing.assert_array_equal(env.reset(options={"shot": shot})[0][1], seen)
    assert set(env.shot_of(1).ids) == {"cue", "1", "9"}


@pytest.mark.parametrize("action", [np.zeros(6), np.zeros((1, 7)), "left"])
def test_an_action_of_another_shape_has_no_strike(action: Any) -> None:
    env = carom.env.CaromEnv("nine-ball")
    env.reset(seed=0)
    with pytest.raises(InputError, match=r"^action: "):
        env.strike_of(action)
