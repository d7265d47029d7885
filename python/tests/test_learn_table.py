"""A table and the strikes of its shots are found again from tracks that the engine made."""

from __future__ import annotations

import math
from pathlib import Path

import carom
import linear_films
import numpy as np
import pytest
from carom import learn
from carom.errors import CaromError, InputError
from carom.learn import filmed_strikes
from carom.learn.observation import Observation
from carom.learn.posterior import MODEL_ERROR
from carom.learn.table_model import Frame, TableModel
from scipy import stats

TRUTH = {
    "base": "carom",
    "cloth": {"sliding_friction": 0.195, "rolling_friction": carom.rolling_bands(0.048, 0.0142)},
    "cushion": {"restitution": {"a": 0.88}},
}
FREE = ("cloth.sliding_friction", "rolling.a", "cushion.restitution.a", "frame.x", "frame.y")
TRUE = (0.195, 0.048, 0.88, 0.0015, -0.001)


def three_cushion_shots(count: int, seed: int = 4) -> list[carom.Shot]:
    """Shots with random places of the balls and random strikes."""
    random = np.random.default_rng(seed)
    shots: list[carom.Shot] = []
    while len(shots) < count:
        places = random.uniform((0.1, 0.1), (1.32, 2.74), (3, 2))
        radius, angle = 0.4 * math.sqrt(random.random()), random.uniform(0.0, 2.0 * math.pi)
        strike = {
            "ball": "1",
            "speed": random.uniform(1.2, 3.0),
            "azimuth_deg": random.uniform(0.0, 360.0),
            "side": radius * math.cos(angle),
            "height": radius * math.sin(angle),
            "elevation_deg": random.uniform(2.0, 6.0),
        }
        try:
            shot = carom.Shot(
                "carom-10ft",
                {str(i + 1): place.tolist() for i, place in enumerate(places)},
                strike,
                physics=TRUTH,
            )
        except CaromError:  # balls that overlap
            continue
        shots.append(shot)
    return shots


def place_of(shot: carom.Shot, ball: str) -> tuple[float, float]:
    x, y, *_ = next(one["position"] for one in shot.to_dict()["balls"] if one["id"] == ball)
    return x, y


@pytest.fixture(scope="module")
def filmed() -> learn.SyntheticTracks:
    starts = np.linspace(0.3, 0.42, 8)
    return learn.synthetic(
        three_cushion_shots(8), sigma=0.001, clock_offset=starts, offset=(0.0015, -0.001), seed=1
    )


@pytest.fixture(scope="module")
def learned(filmed: learn.SyntheticTracks) -> learn.Posterior:
    return learn.table(filmed.tracks, physics="carom", free=FREE, rounds=2, starts=24)


def test_numbers_are_found_again(learned: learn.Posterior) -> None:
    errors = np.abs(learned.mean - TRUE) / learned.model.steps
    assert errors.max() < 0.5, learned.summary()


def scatter(found: learn.Posterior, name: str) -> tuple[float, float]:
    """The interval of 90 % without the error of the model that all shots share."""
    low, high = found.interval(name)
    middle, half = (low + high) / 2.0, (high - low) / 2.0 / MODEL_ERROR
    return middle - half, middle + half


def test_intervals_cover_the_truth_when_errors_of_a_shot_belong_together() -> None:
    """A linear model whose samples all have the error of their shot, 400 times."""
    random = np.random.default_rng(7)
    model = TableModel("carom-10ft", "carom", FREE[:3])
    truth, covered = model.start, []
    for _ in range(400):
        found = linear_films.learned(random, model, shots=40, samples=30)
        intervals = [scatter(found, name) for name in FREE[:3]]
        covered += [low < true < high for (low, high), true in zip(intervals, truth, strict=True)]
    assert 0.87 < np.mean(covered) < 0.94


def test_a_strike_is_found_whose_ball_meets_another_in_the_first_pictures() -> None:
    """Seen: 15 of 91 shots of a match ended on another way, with errors of 20 cm and more.

    The mean motion in the first 0.09 s, which the search began with, is that behind the contact.
    """
    shots = []
    for number, cut in enumerate((0.25, 0.5, -0.4, 0.7)):
        gap = 0.062 + 0.05 + 0.03 * number
        target = (0.5 + gap * math.sin(0.3), 1.0 + gap * math.cos(0.3))
        azimuth = math.pi / 2.0 - 0.3 + cut * 0.0615 / gap
        balls = {"1": (0.5, 1.0), "2": target, "3": (1.2, 0.3)}
        strike = carom.Strike(2.5, azimuth, side=0.2, height=0.1, ball="1", elevation=0.06)
        shots.append(carom.Shot("carom-10ft", balls, strike, physics=TRUTH))
    film = learn.synthetic(shots, rate=50.0, sigma=0.001, clock_offset=0.3, seed=6)
    found = learn.strikes(film.tracks, table="carom-10ft", physics=TRUTH, starts=12)
    assert [one.rmse < 0.004 for one in found] == [True] * 4, [one.rmse for one in found]


def test_places_of_rest_are_found_with_the_strike(
    filmed: learn.SyntheticTracks, learned: learn.Posterior
) -> None:
    """A ball that was seen 2 mm beside its place is put back, and the film is explained better."""
    (first,) = filmed.tracks[1:2]
    balls = dict(first.balls)
    seen = balls["2"]
    (away,) = np.nonzero(np.hypot(*(seen.position - seen.position[0]).T) > 0.015)
    before = np.arange(len(seen)) < 0.8 * away[0]
    wrong = seen.position + np.where(before[:, None], (0.002, 0.0), 0.0)
    balls["2"] = learn.TrackedBall(seen.time, wrong, seen.sigma, seen.visible)
    shot = learn.TrackedShot(first.name, balls)
    tracks = learn.Tracks(filmed.tracks.header, [shot])
    (held,) = learn.strikes(tracks, learned, starts=24)
    (free,) = learn.strikes(tracks, learned, rest=0.002, starts=24)
    assert free.rmse < held.rmse
    true = place_of(filmed.traces[1].shot, "2")
    held_error, free_error = (math.dist(place_of(one.shot, "2"), true) for one in (held, free))
    assert free_error < held_error


def test_a_place_of_rest_needs_an_error_in_metres(filmed: learn.SyntheticTracks) -> None:
    with pytest.raises(InputError, match=r"^rest: 1.5 m is not the error .*such as 0.0015"):
        learn.strikes(filmed.tracks, rest=1.5)


def test_the_shot_of_a_strike_has_the_film_on_the_table(
    filmed: learn.SyntheticTracks, learned: learn.Posterior
) -> None:
    """Its track is in the frame and on the clock of the simulation."""
    (found,) = learn.strikes(filmed.tracks[:1], learned, starts=24)
    track = found.shot.track
    assert list(track) == found.shot.ids
    seen = filmed.tracks[0].balls["1"]
    assert track["1"].shape == (len(seen), 3)
    assert track["1"][0, 0] == pytest.approx(-found.clock, abs=1e-6)
    offset = track["1"][:, 1:] - seen.position
    assert np.abs(offset - learned.frame.offset).max() < 1e-5
    trace = found.shot.simulate()
    early = track["1"][(track["1"][:, 0] > 0.0) & (track["1"][:, 0] < 1.0)]
    model = trace.at(early[:, 0]).position[:, found.shot.ids.index("1"), :2]
    assert np.hypot(*(model - early[:, 1:]).T).max() < 0.01
    again = carom.Shot.from_json(found.shot.to_json())
    assert np.array_equal(again.track["1"], track["1"])


def test_a_film_with_too_many_pictures_is_thinned() -> None:
    time = np.arange(15_000) / 1000.0
    seen = learn.TrackedBall(time, np.column_stack((0.3 + 0.001 * time, time / 20.0)))
    shot = learn.TrackedShot("1", {"1": seen})
    (entry,) = filmed_strikes._track(shot, Frame(), (1.42, 2.84), clock=0.5)
    assert entry["samples"].shape == (7500, 3)
    assert entry["samples"][:2, 0].tolist() == [-0.5, -0.498]


def test_samples_of_a_strike_spread_about_it(
    filmed: learn.SyntheticTracks, learned: learn.Posterior
) -> None:
    (found,) = learn.strikes(filmed.tracks[:1], learned, starts=24)
    strike = found.shot.strike
    assert strike is not None
    assert found.samples.shape == (200, 6)
    spread = found.samples.std(axis=0)
    assert np.all(spread > 0.0)
    assert abs(found.samples[:, 0].mean() - strike.azimuth) < 3.0 * spread[0]
    assert abs(found.samples[:, 1].mean() - strike.speed) < 3.0 * spread[1]
    # The film tells the speed of the cue to a few percent, and not the elevation to a degree.
    assert spread[1] < 0.2 * strike.speed
    assert spread[4] < 0.3


def test_a_ball_that_is_seen_in_a_nose_is_placed_at_it() -> None:
    model = TableModel("carom-10ft", "carom", ["frame.x"])
    time = np.arange(5) / 25.0
    observed = Observation("1", "1", {"1": (0.0296, 1.0)}, time, {}, 0.1, {})
    shot, _ = model.shot(observed, model.start)
    assert 0.030 < place_of(shot, "1")[0] < 0.0302


def test_strikes_are_found_on_the_learned_table(
    filmed: learn.SyntheticTracks, learned: learn.Posterior
) -> None:
    found = learn.strikes(filmed.tracks[:3], learned, starts=24)
    for strike, trace, start in zip(found, filmed.traces, filmed.clock_offset, strict=False):
        true = trace.shot.strike
        assert true is not None
        assert strike.shot.strike is not None
        assert strike.rmse < 0.004
        # The clock and the speed of the cue trade off in the first pictures.
        assert abs(strike.clock - start) < 0.012
        turn = strike.shot.strike.azimuth - true.azimuth
        assert abs(math.remainder(turn, 2.0 * math.pi)) < 0.05


def test_a_learned_table_is_read_as_it_was_written(
    learned: learn.Posterior, tmp_path: Path
) -> None:
    path = tmp_path / "learned.json"
    learned.save(path)
    again = learn.Posterior.load(path)
    assert again.to_dict() == learned.to_dict()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "learned.json"),
        ('{"format": "carom-shot/1"}', "carom-learned/1"),
        ('{"format": "carom-learned/1"}', "cannot be read"),
    ],
)
def test_a_damaged_file_of_a_learned_table_is_refused(
    text: str, words: str, tmp_path: Path
) -> None:
    path = tmp_path / "learned.json"
    path.write_text(text)
    with pytest.raises(InputError, match=words):
        learn.Posterior.load(path)


def test_draws_scatter_as_the_covariance_says(learned: learn.Posterior) -> None:
    draws = learned.draw(400, seed=3)
    sliding = [draw.physics["cloth"]["sliding_friction"] for draw in draws]
    assert np.std(sliding) == pytest.approx(learned.sigma[0], rel=0.15)


def test_shots_without_motion_are_named() -> None:
    still = learn.TrackedShot("7", {"1": ([0.0, 1.0], [[0.5, 0.5], [0.5, 0.5]])})
    tracks = learn.Tracks(learn.TracksHeader(table="carom-10ft"), (still,))
    with pytest.raises(InputError, match=r"shot 7: no ball moves"):
        learn.table(tracks)


def test_an_unknown_number_is_refused(filmed: learn.SyntheticTracks) -> None:
    with pytest.raises(InputError, match=r"cannot be learned"):
        learn.table(filmed.tracks, free=["cloth.colour"])


def test_a_number_at_its_upper_bound_is_learned() -> None:
    """Balls without loss: a step of their restitution upwards would leave its range."""
    physics = {"base": "carom", "ball_ball": {"restitution": 1.0}}
    balls = {"1": (0.5, 0.6), "2": (0.9, 1.6), "3": (0.3, 2.6)}
    shots = [
        carom.Shot(
            "carom-10ft",
            balls,
            {"ball": "1", "speed": speed, "azimuth_deg": 68.2 + turn, "elevation_deg": 4.0},
            physics=physics,
        )
        for speed, turn in ((1.2, -1.2), (1.5, 0.9), (1.8, 1.3))
    ]
    film = learn.synthetic(shots, sigma=0.001, clock_offset=0.3)
    free = ["ball_ball.restitution"]
    found = learn.table(film.tracks, physics=physics, free=free, rounds=1, starts=6)
    assert 0.97 < found.mean[0] <= 1.0


def test_a_number_of_which_no_shot_tells_has_the_width_of_its_prior() -> None:
    shot = carom.Shot(
        "carom-10ft",
        {"1": (0.5, 0.6), "2": (1.2, 2.6)},
        {"ball": "1", "speed": 0.8, "azimuth_deg": 100.0, "elevation_deg": 4.0},
    )
    film = learn.synthetic([shot, shot], sigma=0.001, clock_offset=0.3)
    found = learn.table(film.tracks, free=["ball_ball.restitution"], rounds=1, starts=6)
    assert found.sigma[0] == pytest.approx(10.0 * found.model.steps[0], rel=0.01)
    assert "do not tell" in found.summary()


@pytest.mark.parametrize(("weights", "freedom"), [([1.0] * 8, 7.0), ([1.0, 1e-4, 1e-4], 1.0)])
def test_an_interval_is_wider_where_few_shots_tell_most(
    weights: list[float], freedom: float
) -> None:
    """Against Student's t; n equal shots have n − 1 degrees of freedom, one heavy shot has one."""
    model = TableModel("carom-10ft", "carom", FREE[:1])
    curvatures = np.array(weights).reshape(-1, 1, 1)
    gradients = np.array([1e-3, -1e-3] + [0.0] * (len(weights) - 2))[:, None]
    found = learn.Posterior.of(model, model.start, 1e4 * curvatures, gradients)
    low, high = scatter(found, FREE[0])
    shots = len(weights)
    rest = 1e4 * (sum(weights) - curvatures[:, 0, 0])
    variance = ((gradients[:, 0] / rest) ** 2).sum() * (shots - 1) / shots
    variance += 1.0 / (1e4 * sum(weights))
    expected = stats.t.ppf(0.95, freedom) * math.sqrt(variance) * model.steps[0]
    assert (high - low) / 2.0 == pytest.approx(expected, rel=0.06)
