"""Tables and physics per environment, and drawn for every episode."""

from __future__ import annotations

from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom.errors import InputError

LAWS = {
    "cloth.rolling_friction": (0.008, 0.012),
    "physics.ball_ball.restitution": {"choice": [0.9, 0.95]},
    "cue.mass": {"normal": [0.54, 0.02]},
    "cloth.spin_deceleration": {"log_uniform": [5.0, 20.0]},
    "table.cushion_height": (0.0355, 0.0365),
}


@pytest.mark.parametrize("name", sorted(carom.env.ENVIRONMENTS))
def test_every_episode_draws_its_physics_from_its_seed(name: str) -> None:
    laws = {key: LAWS[key] for key in ("cloth.rolling_friction", "cue.mass")}
    vector = gymnasium.make_vec(name, num_envs=20, randomize=laws)
    _, info = vector.reset(seed=5)
    drawn = info["randomized"]
    assert list(drawn) == list(laws)
    rolling = drawn["cloth.rolling_friction"]
    assert rolling.shape == (20,)
    assert len(np.unique(rolling)) == 20
    assert ((rolling > 0.008) & (rolling < 0.012)).all()
    single = gymnasium.make(name, randomize=laws)
    _, one = single.reset(seed=8)
    assert one["randomized"] == {key: values[3] for key, values in drawn.items()}
    _, again = single.reset()
    assert again["randomized"] != one["randomized"]
    again = single.reset(seed=8)[1]
    assert again["randomized"] == one["randomized"]


def test_a_drawn_value_is_that_of_the_physics_and_the_table() -> None:
    env = carom.env.CaromEnv("nine-ball", physics="pool-worn-cloth", randomize=LAWS)
    _, info = env.reset(seed=1)
    drawn = info["randomized"]
    found = env.shot.to_dict()
    rolling = found["physics"]["cloth"]["rolling_friction"]
    assert rolling == drawn["cloth.rolling_friction"]
    assert found["physics"]["ball_ball"]["restitution"] in (0.9, 0.95)
    assert found["physics"]["cue"]["mass"] == drawn["cue.mass"]
    assert found["table"]["cushion_height"] == drawn["table.cushion_height"]


def test_drawn_physics_change_the_motion_and_a_copy_keeps_them() -> None:
    actions = np.tile(np.float32([0.3, -0.4, 0, 0, 0]), (10, 1))
    ends = []
    for randomize in ({"cloth.rolling_friction": (0.005, 0.02)}, None):
        envs = carom.env.CaromVectorEnv("sum-to-three", 10, randomize=randomize)
        envs.reset(seed=3)
        state = envs.get_state()
        first = envs.step(actions)[0]
        envs.set_state(state)
        np.testing.assert_array_equal(envs.step(actions)[0], first)
        ends.append(first)
    assert (ends[0] != ends[1]).any(axis=1).all()


def test_environments_of_a_vector_have_tables_and_physics_of_their_own() -> None:
    physics = [
        carom.Physics.preset("pool", cloth={"rolling_friction": 0.006 + 0.002 * k})
        for k in range(3)
    ]
    tables = ["wpa-9ft", carom.Table.preset("wpa-8ft"), {"base": "wpa-9ft"}]
    envs = carom.env.CaromVectorEnv("potting", 3, physics=physics, table=tables)
    envs.reset(seed=4)
    actions = np.tile(np.float32([0.3, 0.1, 0, 0, 0]), (3, 1))
    rows = envs.step(actions)[4]["final_obs"]
    for k in range(3):
        single = carom.env.CaromEnv("potting", physics=physics[k], table=tables[k])
        single.reset(seed=4 + k)
        np.testing.assert_array_equal(single.step(actions[k])[0], rows[k])


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"physics": ["pool", "snooker"]}, r"setups: there are 2 for 3"),
        (
            {"physics": ["pool", "snooker"], "table": ["wpa-9ft"] * 3},
            r"physics: there are 2 for 3 tables",
        ),
        ({"physics": ["pool", {"gravty": 9.8}, "pool"]}, r"\[1\]\.physics"),
        ({"randomize": 3}, "randomize: found a int"),
        (
            {"randomize": {"cloth.rolling_friction": 0.01}},
            r"randomize\.cloth\.rolling_friction: it is not a law",
        ),
        (
            {"randomize": {"cloth.rolling_friction": (0.02, 0.01)}},
            r"randomize\.cloth\.rolling_friction: the first",
        ),
        (
            {"randomize": {"cloth.rolling_friction": {"cauchy": [1, 2]}}},
            r"randomize.*there is no law",
        ),
        ({"randomize": {"cloth.rolling_friction": {"log_uniform": [0, 2]}}}, r"randomize.*above 0"),
        (
            {"randomize": {"cloth.roling_friction": (0.01, 0.02)}},
            r"physics\.cloth\.roling_friction",
        ),
        (
            {"randomize": {"cloth.rolling_friction": (-2.0, -1.0)}},
            r"physics\.cloth\.rolling_friction",
        ),
    ],
)
def test_laws_and_lists_that_are_not_possible_are_refused(
    settings: dict[str, Any], message: str
) -> None:
    with pytest.raises(InputError, match=rf"^{message}"):
        carom.env.CaromVectorEnv("nine-ball", 3, **settings)
