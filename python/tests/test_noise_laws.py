"""Errors of robots and measured players: covariance, bias, relative speed, samples, perception."""

from __future__ import annotations

import json
import pickle

import carom
import carom.env  # registers the environments
import gymnasium
import numpy as np
import pytest
from carom import Noise, Perception

RADIUS = 0.028575
COVARIANCE = np.diag([0.05, 0.002, 0.004, 0.0006, 0.0005]) ** 2
COVARIANCE[1, 3] = COVARIANCE[3, 1] = 0.8 * 0.002 * 0.0006
COVARIANCE[0, 4] = COVARIANCE[4, 0] = -0.5 * 0.05 * 0.0005
BIAS = (0.1, -0.003, 0.01, 0.0004, -0.0002)


def shot(**strike: float) -> carom.Shot:
    given = {"speed": 2.0, "azimuth": 1.4, "elevation": 0.2, "side": 0.05, "height": -0.1}
    balls = {"cue": (0.6, 0.6), "1": (0.7, 1.3), "2": (0.3, 1.9)}
    return carom.Shot(
        table=carom.Table(),
        layout=carom.Layout.at(balls),
        strike=carom.Strike(**{**given, **strike}),
    )


def errors(noise: Noise, n: int = 20_000, **strike: float) -> np.ndarray:
    """Executed minus intended, shape (n, 5), with offsets in metres."""
    meant = shot(**strike)
    drawn = meant.vary(noise, n, seed=3)
    own = meant.to_dict()["strike"]
    keys = ("speed", "azimuth", "elevation", "side", "height")
    found = np.stack([getattr(drawn, key) - own[key] for key in keys], axis=1)
    return found * [1, 1, 1, RADIUS, RADIUS]


def test_the_errors_of_a_robot_have_its_covariance_and_its_bias() -> None:
    found = errors(Noise(covariance=COVARIANCE, bias=BIAS))
    sigma = np.sqrt(np.diag(COVARIANCE))
    assert np.abs((found.mean(axis=0) - BIAS) / sigma).max() < 5 / np.sqrt(len(found))
    relative = (np.cov(found.T) - COVARIANCE) / np.outer(sigma, sigma)
    assert np.abs(relative).max() < 8 / np.sqrt(len(found))


def test_standard_deviations_and_a_covariance_add_up() -> None:
    found = errors(Noise(speed=0.05, azimuth=0.002, covariance=COVARIANCE))
    sigma = found.std(axis=0)
    assert sigma[0] == pytest.approx(0.05 * np.sqrt(2), rel=0.03)
    assert sigma[1] == pytest.approx(0.002 * np.sqrt(2), rel=0.03)
    assert sigma[2] == pytest.approx(0.004, rel=0.03)


def test_a_relative_error_of_the_speed_grows_with_the_speed() -> None:
    noise = Noise(speed_relative=0.02)
    for speed in (1.0, 4.0):
        found = errors(noise, speed=speed)
        assert found[:, 0].std() == pytest.approx(0.02 * speed, rel=0.03)
        assert not found[:, 1:].any()


def test_measured_errors_are_drawn_as_they_are_and_equally_often() -> None:
    rows = np.random.default_rng(1).normal(size=(7, 5)) * [0.05, 0.002, 0.004, 0.0006, 0.0005]
    found = errors(Noise(samples=rows), n=7000)
    nearest = np.abs(found[:, None, 1] - rows[None, :, 1]).argmin(axis=1)
    assert np.abs(found - rows[nearest]).max() < 1e-12
    counts = np.bincount(nearest, minlength=7)
    assert np.abs(counts - 1000).max() < 150


def test_a_covariance_that_two_parameters_share_moves_them_together() -> None:
    # Rank one, as of one loose joint.
    direction = np.array([0.0, 0.003, 0.0, 0.0009, 0.0])
    found = errors(Noise(covariance=np.outer(direction, direction)), n=500)
    assert np.abs(found[:, 1] / 0.003 - found[:, 3] / 0.0009).max() < 1e-9
    assert not found[:, [0, 2, 4]].any()


def test_a_noise_without_the_new_keys_keeps_every_bit() -> None:
    plain, zeros = Noise.olympiad(), Noise.olympiad()
    zeros = carom.Noise.from_dict({**plain.to_dict(), "bias": [0.0] * 5, "speed_relative": 0})
    assert zeros == plain
    assert plain.draw(shot(), 17, seed=5) == zeros.draw(shot(), 17, seed=5)
    # Drawn before the new keys existed.
    assert plain.draw(shot(), 17, seed=5).azimuth == pytest.approx(1.4, abs=0.02)


def test_every_question_takes_the_errors_of_a_robot() -> None:
    cut = shot(azimuth=1.4289)
    rows = np.random.default_rng(2).normal(size=(50, 5)) * [0.05, 0.002, 0.004, 0.0006, 0.0005]
    for noise in (
        Noise(covariance=COVARIANCE, bias=BIAS, speed_relative=0.03),
        Noise(samples=rows),
    ):
        assert cut.evaluate(noise=noise, n=50).n == 50
        found = cut.solve(first="1", noise=noise, samples=256, n=50, wanted=1)
        assert found
        frame = carom.Frame("nine-ball", seed=3)
        result = frame.copy().play(carom.Strike(7.0, 1.57), noise=noise, seed=2)
        assert result is not None
        player = carom.Player(noise=noise, simulations=60, seed=1)
        assert player.choose(frame).play is not None
        environment = gymnasium.make("carom/Potting-v3", noise=noise)
        environment.reset(seed=1)
        environment.step(np.zeros(environment.action_space.shape))


def test_a_solution_allows_for_the_bias() -> None:
    cut = shot()
    bias = (0.0, 0.02, 0.0, 0.0, 0.0)
    noise = Noise(azimuth=0.0005, bias=bias)
    (best, *_) = cut.solve(pot="1", noise=noise, samples=1024, n=200, wanted=1)
    assert float(best.chance) > 0.9
    meant = best.shot.evaluate(noise=noise, n=200)
    assert float(meant.pot("1")) > 0.9


def test_a_noise_is_the_same_after_a_file_a_pickle_and_a_scale_of_one() -> None:
    for noise in (
        Noise.olympiad(),
        Noise(covariance=COVARIANCE, bias=BIAS, speed_relative=0.03),
        Noise(samples=[BIAS, BIAS]),
    ):
        again = Noise.from_dict(json.loads(json.dumps(noise.to_dict())))
        assert again == noise
        assert pickle.loads(pickle.dumps(noise)) == noise
        assert noise.scaled(1.0) == noise
        assert hash(noise) == hash(again)
    seen = Perception((0.001, 0.003), correlation=0.5, balls={"1": 0.0, "2": (0.002, 0.001)})
    assert Perception.from_dict(json.loads(json.dumps(seen.to_dict()))) == seen
    assert pickle.loads(pickle.dumps(seen)) == seen


def test_the_command_line_takes_a_noise_from_a_file(tmp_path, capsys) -> None:
    from carom.cli.options import noise_of

    path = tmp_path / "robot.json"
    noise = Noise(covariance=COVARIANCE, cling_probability=0.1)
    path.write_text(json.dumps(noise.to_dict()))
    assert noise_of(str(path), 0.0) == noise
    path.write_text('{"sped": 1}')
    with pytest.raises(carom.InputError, match=r"robot.json: noise: there is no key 'sped'"):
        noise_of(str(path), 0.0)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"covariance": np.eye(5)[:4]}, "noise.covariance: found 4 rows"),
        ({"covariance": [[1.0] * 4] * 5}, r"noise.covariance\[0\]: .* is not 5 numbers"),
        ({"covariance": np.diag([1e-4, -1e-6, 0, 0, 0])}, r"covariance\[1\]\[1\]: -1e-6 is out"),
        ({"covariance": np.diag([1e-4, 1e-6, 0, 4.0, 0])}, r"noise.covariance\[3\]\[3\]: 4.0"),
        (
            {"covariance": np.diag([1e-4] * 2 + [0.0] * 3) + np.eye(5, k=1) * 1e-5},
            r"noise.covariance\[1\]\[0\]: 0.0 differs from 1e-5 at \[0\]\[1\]; write a symmetric",
        ),
        (
            {"covariance": [[1e-4, 2e-4, 0, 0, 0], [2e-4, 1e-4, 0, 0, 0]] + [[0.0] * 5] * 3},
            "noise.covariance: the matrix is not positive semidefinite",
        ),
        (
            {"covariance": [[0, 1e-6, 0, 0, 0], [1e-6, 1e-4, 0, 0, 0]] + [[0.0] * 5] * 3},
            "noise.covariance: the matrix is not positive semidefinite",
        ),
        ({"covariance": [[float("nan")] * 5] * 5}, r"noise.covariance\[0\].*finite"),
        ({"bias": [0, 0, 0, 0, 0.5]}, r"noise.bias\[4\]: 0.5 is out of range"),
        ({"bias": [0, 0]}, "noise.bias: .* is not 5 numbers"),
        ({"speed_relative": 1.5}, "noise.speed_relative: 1.5 is out of range"),
        ({"samples": []}, "noise.samples: 0 samples are out of range"),
        ({"samples": [[0] * 5], "speed": 0.1}, "noise.samples: measured errors stand beside"),
        ({"samples": [[0] * 5], "covariance": COVARIANCE}, "noise.samples: measured errors stand"),
        ({"samples": 3}, "noise.samples: found int; give rows"),
    ],
)
def test_an_invalid_error_is_refused_with_its_place(values: dict, message: str) -> None:
    with pytest.raises(carom.InputError, match=message):
        Noise(**values)


def test_a_camera_sees_each_ball_with_an_error_of_its_own() -> None:
    seen = Perception((0.001, 0.003), correlation=0.6, balls={"1": 0.0, "2": (0.002, 0.0)})
    own = shot()
    moved = np.array(
        [
            [[*ball["position"][:2]] for ball in seen.see(own, k, seed=4).to_dict()["balls"]]
            for k in range(3000)
        ]
    )
    places = np.array([ball["position"][:2] for ball in own.to_dict()["balls"]])
    away = moved - places
    assert away[:, 0].std(axis=0) == pytest.approx([0.001, 0.003], rel=0.06)
    assert np.corrcoef(away[:, 0].T)[0, 1] == pytest.approx(0.6, abs=0.05)
    assert not away[:, 1].any()
    assert away[:, 2, 0].std() == pytest.approx(0.002, rel=0.06)
    assert not away[:, 2, 1].any()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Perception((0.1, 0.2)), "perception.position: 0.2 is out of range"),
        (lambda: Perception((0.1, 0.1, 0.1)), "perception.position: .* is not 2 numbers"),
        (lambda: Perception(0.1, correlation=2), "perception.correlation: 2.0 is out of range"),
        (lambda: Perception(balls={"1": 3.0}), r"perception.balls\['1'\]: .*3.0 is out of range"),
        (lambda: Perception(balls=[1]), "perception.balls: found list; give a dict"),
    ],
)
def test_an_invalid_perception_is_refused_with_its_place(make, message: str) -> None:
    with pytest.raises(carom.InputError, match=message):
        make()
