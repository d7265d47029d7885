"""Policies of the environments as players of matches."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import carom
import carom.env
import gymnasium
import numpy as np
import pytest
from carom import InputError

if TYPE_CHECKING:
    from pathlib import Path

SHORT: dict[str, Any] = {
    "game": "nine-ball",
    "pairs": 1,
    "secret": "cd" * 32,
    "patience": 10,
    "simulations": 50,
}


def full(rows: Any) -> Any:
    """Hits the nearest ball full; how fast depends on what is observed."""
    actions = np.zeros((len(rows), 7), dtype=np.float32)
    actions[:, 1] = 0.3 + 0.2 * rows[:, 0]
    return actions


def test_a_policy_plays_a_match_and_the_record_replays(tmp_path: Path) -> None:
    player = carom.env.as_player(full, "NineBall-v3", name="full", aim="relative")
    records = []
    ways: list[dict[str, Any]] = [{}, {"threads": 2}, {"processes": 1}]
    for index, more in enumerate(ways):
        result = carom.play_match(player, "greedy:40", out=tmp_path / str(index), **SHORT, **more)
        assert result.record is not None
        records.append(result.record.read_text())
    assert len(set(records)) == 1
    assert carom.replay_match(records[0]).difference is None
    lines = [json.loads(line) for line in records[0].splitlines()]
    assert lines[0]["players"][0]["name"] == "full"
    moves = [m for line in lines[1:-1] for m in line["moves"] if line["seats"][m["seat"]] == 0]
    assert sum("executed" in move for move in moves) > 3
    assert not any("refused" in move for move in moves)


@pytest.mark.parametrize("task", ["eight-ball", "nine-ball", "snooker", "straight-pool"])
def test_a_policy_answers_as_the_environment_does_for_its_agent(task: str) -> None:
    """The same actions give the same frames, shot by shot, with calls and choices."""
    env = carom.env.CaromEnv(task, aim="relative")
    seen, _ = env.reset(seed=4)
    size = env.action_space.sample().shape[0]
    rng = np.random.default_rng(7)
    action = np.zeros(size, dtype=np.float32)
    player = carom.env.as_player(
        lambda rows: action[None].repeat(len(rows), 0), task, aim="relative"
    )
    kinds = set()
    for index in range(12):
        action = rng.uniform(-1, 1, size).astype(np.float32)
        if index == 0:
            action[1] = -0.6  # too weak a break, after which the other player chooses
        frame = env.frame
        assert frame is not None
        play = player.choose(
            carom.Situation(frame, carom.Noise(), carom.Noise(), frame.player or 0)
        )
        assert play == env.play_of(action)
        assert isinstance(play, carom.Play)
        ruling = frame.play(play.strike, cue_ball=play.cue_ball, call=play.call)
        seen, _, ended, stopped, info = env.step(action)
        assert info["legal"] == ruling.legal
        while frame.request.kind == "choice":
            kinds.add("choice")
            situation = carom.Situation(frame, carom.Noise(), carom.Noise(), frame.player or 0)
            frame.choose(str(player.choose(situation)))
        if ended or stopped:
            break
        after = env.frame
        assert after is not None
        assert after.balls == frame.balls
        assert after.request == frame.request
    assert seen.shape == env.observation_space.shape
    if task == "eight-ball":
        assert kinds == {"choice"}


def test_a_player_observes_the_frame_on_the_table_of_the_match(tmp_path: Path) -> None:
    observed: list[Any] = []

    def policy(rows: Any) -> Any:
        observed.append(np.array(rows))
        return np.zeros((len(rows), 7))

    player = carom.env.as_player(policy, "nine-ball", aim="relative")
    result = carom.play_match(
        player, "greedy:40", out=tmp_path / "m", table="bar-7ft", breaker=0, **SHORT
    )
    assert result.record is not None

    def rack(row: Any) -> Any:
        """The places of the balls, without their order, which the seed of the rack decides."""
        return np.sort(row[:40].reshape(10, 4)[:, :2], axis=0)

    places = {
        table: rack(
            carom.env.CaromEnv("nine-ball", table=table).observation_of(
                carom.Frame("nine-ball", table=table)
            )
        )
        for table in ("bar-7ft", "wpa-9ft")
    }
    assert np.allclose(rack(observed[0][0]), places["bar-7ft"], atol=1e-3)
    assert not np.allclose(rack(observed[0][0]), places["wpa-9ft"], atol=1e-3)


def test_a_policy_that_became_a_player_is_an_opponent_too() -> None:
    player = carom.env.as_player(full, "carom/NineBall-v3", aim="relative")
    ends = []
    for opponent in (full, player):
        envs = gymnasium.make_vec(
            "carom/NineBall-v3", num_envs=4, balls=2, aim="relative", opponent=opponent
        )
        envs.reset(seed=3)
        for _ in range(5):
            rows = envs.step(np.full(envs.action_space.shape, 0.1, dtype=np.float32))[0]
        ends.append(rows)
    assert np.allclose(ends[0], ends[1], atol=1e-6)


@pytest.mark.parametrize(
    ("policy", "task", "settings", "message"),
    [
        (5, "nine-ball", {}, r"^policy: found a int; give a function"),
        (full, "croquet", {}, r"croquet"),
        (full, "potting", {}, r"^task: potting has no frames"),
        (full, "nine-ball", {"table": "bar-7ft"}, r"^table: the match decides it"),
        (full, "nine-ball", {"aim": "up"}, r"^aim"),
    ],
)
def test_what_makes_no_player_is_refused_at_once(
    policy: Any, task: str, settings: dict[str, Any], message: str
) -> None:
    with pytest.raises(InputError, match=message):
        carom.env.as_player(policy, task, **settings)


def test_actions_of_another_shape_are_an_error_of_the_player(tmp_path: Path) -> None:
    player = carom.env.as_player(lambda rows: np.zeros((len(rows), 5)), "nine-ball")
    with pytest.raises(InputError, match=r"^policy: it returned actions of the shape \(1, 5\)"):
        carom.play_match(player, "greedy:40", out=tmp_path / "m", strict=True, **SHORT)
