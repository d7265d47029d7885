"""Opponents of one's own, and the agent's seat."""

from __future__ import annotations

import pickle
from typing import Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom.errors import CaromError, InputError

NOISE = carom.Noise.olympiad(1.0)


def full(rows: Any) -> Any:
    """A policy that always plays the nearest ball full."""
    return np.zeros((len(rows), 7), dtype=np.float32)


class Simple:
    """A player of one's own: it plays soft and answers choices by the first option."""

    name = "simple"

    def __init__(self) -> None:
        self.seen: list[carom.Situation] = []

    def choose(self, situation: carom.Situation) -> Any:
        self.seen.append(situation)
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        cue_ball = (0.635, 0.5) if request.in_hand else None
        return carom.Play(carom.Strike(2.0, 1.2), cue_ball=cue_ball)


@pytest.mark.parametrize("seat", [0, 1, "random", "alternate"])
def test_a_policy_plays_the_other_seat_in_vectors_as_in_single_environments(seat: Any) -> None:
    settings: dict[str, Any] = {
        "opponent": full,
        "seat": seat,
        "noise": NOISE,
        "aim": "relative",
        "balls": (2, 4),
        "patience": 6,
    }
    vector = gymnasium.make_vec(
        "carom/NineBall-v3", num_envs=3, autoreset_mode="next-step", **settings
    )
    single = gymnasium.make("carom/NineBall-v3", **settings)
    first, info = vector.reset(seed=7)
    observation, one = single.reset(seed=9)
    np.testing.assert_array_equal(first[2], observation)
    assert one["seat"] == info["seat"][2]
    assert one["player"] == one["seat"]
    random, over, seats = np.random.default_rng(1), False, {one["seat"]}
    for _ in range(30):
        action = random.uniform(-1, 1, vector.action_space.shape).astype(np.float32)
        rows = vector.step(action)
        if over:
            observation, one = single.reset()
            np.testing.assert_array_equal(rows[0][2], observation)
            over = False
            seats.add(one["seat"])
            continue
        observation, reward, terminated, truncated, one = single.step(action[2])
        np.testing.assert_array_equal(rows[0][2], observation)
        assert (rows[1][2], rows[2][2], rows[3][2]) == (reward, terminated, truncated)
        over = terminated or truncated
        assert one["player"] == (-1 if over else one["seat"])
    assert seats == ({seat} if isinstance(seat, int) else {0, 1})


def test_the_rewards_of_both_seats_are_zero_sum() -> None:
    """The same two policies, once as agent and once as opponent, earn opposite rewards."""
    totals = []
    for seat in (0, 1):
        envs = carom.env.CaromVectorEnv(
            "nine-ball", 50, opponent=full, seat=seat, balls=2, aim="relative", patience=6
        )
        observations, _ = envs.reset(seed=0)
        total, live = np.zeros(50), np.ones(50, dtype=bool)
        for _ in range(40):
            observations, rewards, terminated, truncated, _ = envs.step(full(observations))
            total += rewards * live
            live &= ~(terminated | truncated)
        totals.append(total)
    assert np.any(totals[0] != 0)
    np.testing.assert_allclose(totals[0], -totals[1], atol=1e-12)


def test_a_player_of_ones_own_is_asked_with_a_situation_without_seeds() -> None:
    player = Simple()
    env = carom.env.CaromEnv("nine-ball", opponent=player, noise=NOISE)
    env.reset(seed=1)
    for _ in range(4):
        *_, terminated, truncated, _ = env.step(env.action_space.sample())
        if terminated or truncated:
            env.reset()
    situation = player.seen[0]
    assert (situation.player, situation.clock) == (1, None)
    assert situation.noise == situation.opponent_noise == NOISE
    assert situation.frame.player == 1
    with pytest.raises(CaromError, match="copy for a player"):
        _ = situation.frame.record
    # The frame is a copy: playing in it changes nothing.
    state = env.get_state()
    if situation.frame.request.kind == "shot":
        situation.frame.copy().concede()
    assert env.get_state() == state


@pytest.mark.parametrize("answer", ["play", "decision", "concede", "player"])
def test_every_kind_of_answer_is_taken(answer: str) -> None:
    class Answers:
        def choose(self, situation: carom.Situation) -> Any:
            if answer == "concede":
                return "concede"
            decision = carom.Player("greedy:30").choose(situation.frame)
            return decision.play if answer == "play" and decision.play else decision

    opponent = carom.Player("greedy:30") if answer == "player" else Answers()
    env = carom.env.CaromEnv("nine-ball", opponent=opponent, balls=2)
    env.reset(seed=1)
    soft = np.array([0.5, -0.9, 0, 0, 0, 0, 0], dtype=np.float32)
    *_, terminated, _, info = env.step(soft)
    assert info["player"] == (-1 if terminated else 0)
    if answer == "concede":
        assert terminated
        assert (info["winner"], info["why"]) == (0, "the other player conceded")


def test_an_exception_of_an_opponent_propagates_and_the_environment_can_go_on() -> None:
    class Broken:
        fails = True

        def choose(self, situation: carom.Situation) -> Any:
            if self.fails:
                raise ZeroDivisionError("my mistake")
            return Simple().choose(situation)

    player = Broken()
    envs = carom.env.CaromVectorEnv("nine-ball", 4, opponent=player)
    envs.reset(seed=1)
    before = envs.get_state()
    soft = np.tile(np.float32([0.5, -0.9, 0, 0, 0, 0, 0]), (4, 1))
    with pytest.raises(ZeroDivisionError, match="my mistake") as caught:
        envs.step(soft)
    assert "opponent of environment 0" in "".join(caught.value.__notes__)
    with pytest.raises(InputError, match=r"^environment: its last step .* did not end; reset"):
        envs.step(soft)
    player.fails = False
    envs.set_state(before)
    envs.step(soft)
    envs.reset(seed=2)
    envs.step(soft)


@pytest.mark.parametrize(
    ("opponent", "message"),
    [
        (lambda rows: np.zeros((len(rows), 3)), r"^opponent: it returned actions of the shape"),
        (lambda rows: "left", r"^opponent: not numbers"),
        (
            type("P", (), {"choose": lambda self, s: 7})(),
            r"^opponent: choose returned a int; return",
        ),
        (type("P", (), {"choose": lambda self, s: "sing"})(), r"^opponent\.choice: \"sing\""),
        (
            type("P", (), {"choose": lambda self, s: carom.Play(carom.Strike(2, 1), (9.0, 9.0))})(),
            r"^opponent\.cue_ball: ",
        ),
    ],
)
def test_an_answer_that_is_not_possible_is_refused_by_name(opponent: Any, message: str) -> None:
    env = carom.env.CaromEnv("nine-ball", opponent=opponent)
    env.reset(seed=1)
    with pytest.raises(InputError, match=message):
        env.step(np.array([0.5, -0.9, 0, 0, 0, 0, 0], dtype=np.float32))


@pytest.mark.parametrize(
    ("task", "settings", "place"),
    [
        ("nine-ball", {"opponent": 5}, "opponent: found a int"),
        ("sum-to-three", {"opponent": Simple()}, "opponent"),
        ("potting", {"opponent": full}, "opponent"),
        ("nine-ball", {"seat": 1}, "seat: without an opponent"),
        ("nine-ball", {"seat": 2, "opponent": "potter"}, "seat"),
        ("nine-ball", {"seat": "last", "opponent": "potter"}, "seat"),
    ],
)
def test_an_opponent_or_seat_that_is_not_possible_is_refused(
    task: str, settings: dict[str, Any], place: str
) -> None:
    with pytest.raises(InputError, match=rf"^{place}"):
        carom.env.CaromEnv(task, **settings)


def test_a_built_in_opponent_breaks_if_the_agent_has_the_second_seat() -> None:
    envs = carom.env.CaromVectorEnv("nine-ball", 6, opponent="potter", seat=1)
    observations, info = envs.reset(seed=0)
    assert (info["player"] == 1).all()
    racked = carom.env.CaromVectorEnv("nine-ball", 6).reset(seed=0)[0]
    assert (observations != racked).any(axis=1).all()
    # The observation is that of the agent, whose turn it is.
    assert (observations[:, -1] == 1).all()


def test_an_opponent_with_a_state_is_part_of_the_environments_state() -> None:
    class Counting(Simple):
        count = 0

        def choose(self, situation: carom.Situation) -> Any:
            self.count += 1
            return super().choose(situation)

        def get_state(self) -> bytes:
            return str(self.count).encode()

        def set_state(self, state: bytes) -> None:
            self.count = int(state)

    player = Counting()
    env = carom.env.CaromEnv("nine-ball", opponent=player)
    env.reset(seed=1)
    soft = np.array([0.5, -0.9, 0, 0, 0, 0, 0], dtype=np.float32)
    env.step(soft)
    state, count = env.get_state(), player.count
    assert count > 0
    env.step(soft)
    player.count = 99
    env.set_state(state)
    assert player.count == count


def test_an_environment_with_a_policy_can_be_pickled() -> None:
    env = carom.env.CaromEnv("nine-ball", opponent=full, noise=NOISE)
    env.reset(seed=1)
    twin = pickle.loads(pickle.dumps(env))
    action = np.array([0.5, -0.9, 0, 0, 0, 0, 0], dtype=np.float32)
    np.testing.assert_array_equal(twin.step(action)[0], env.step(action)[0])
