"""States and residuals of candidates: shapes, broadcasting, errors, and the trace's bits."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import carom
import numpy as np
import pytest

TIMES = np.linspace(0.0, 6.0, 61)


def three_balls(**changes: Any) -> carom.Shot:
    strike = {"speed": 4.0, "azimuth_deg": 78, "side": 0.3, "height": 0.2} | changes
    return carom.Shot("carom-10ft", {"cue": (0.7, 0.6), "1": (0.9, 2.2), "2": (0.4, 2.0)}, strike)


def tracks_of(shot: carom.Shot, clock: float = 0.0, sigma: float = 1.0) -> carom.BallTracks:
    """Exact tracks of the balls 2 and cue, at different times, the cue's in reverse order."""
    trace = shot.simulate()
    times = {"2": TIMES[::3], "cue": TIMES[::-1]}
    seen = {}
    for ball, at in times.items():
        position = trace.at(at).position[:, shot.ids.index(ball), :2]
        seen[ball] = (at + clock, position, sigma)
    return carom.BallTracks(seen)


def refused(kind: str, place: str, call: Callable[[], object]) -> carom.InputError:
    with pytest.raises(carom.InputError) as caught:
        call()
    assert (caught.value.kind, caught.value.place) == (kind, place), caught.value
    return caught.value


class TestStates:
    def test_they_have_the_bits_of_the_trace(self) -> None:
        shot = three_balls()
        at = shot.simulate().at(TIMES)
        found = carom.sample_batch(shot, TIMES, velocity=True, angular_velocity=True)
        assert len(found) == 1
        assert found.velocity is not None
        assert found.angular_velocity is not None
        assert np.array_equal(found.position[0], at.position)
        assert np.array_equal(found.velocity[0], at.velocity)
        assert np.array_equal(found.angular_velocity[0], at.angular_velocity)
        assert found.in_play.all()

    def test_parts_that_are_not_asked_for_are_none(self) -> None:
        found = carom.sample_batch(three_balls(), TIMES)
        assert found.velocity is None
        assert found.angular_velocity is None

    def test_balls_are_chosen_by_id_or_index(self) -> None:
        shot = three_balls()
        every = carom.sample_batch(shot, TIMES).position
        assert np.array_equal(
            carom.sample_batch(shot, TIMES, balls=["2", 0]).position, every[:, :, [2, 0]]
        )

    def test_every_candidate_may_have_its_own_times(self) -> None:
        shots = [three_balls(speed=speed) for speed in (2.0, 3.0)]
        times = np.array([[0.5, np.nan, 2.0], [0.1, 0.2, 0.3]])
        found = carom.sample_batch(shots, times)
        for row, shot in enumerate(shots):
            wanted = ~np.isnan(times[row])
            expected = shot.simulate().at(times[row][wanted]).position
            assert np.array_equal(found.position[row][wanted], expected)
        assert np.isnan(found.position[0, 1]).all()
        assert not found.in_play[0, 1].any()

    def test_shots_with_fewer_balls_are_padded(self) -> None:
        two = carom.Shot("carom-10ft", {"cue": (0.7, 0.6), "1": (0.9, 2.2)})
        found = carom.sample_batch([two, three_balls()], [0.0, 1.0])
        assert found.position.shape == (2, 2, 3, 3)
        assert np.isnan(found.position[0, :, 2]).all()
        assert np.isfinite(found.position[0, :, :2]).all()

    def test_the_number_of_threads_changes_no_bit(self) -> None:
        many = carom.Candidates(three_balls(), strike={"azimuth_deg": np.linspace(60, 80, 300)})
        one, four = (carom.sample_batch(many, TIMES[::10], threads=n) for n in (1, 4))
        assert np.array_equal(one.position, four.position)

    @pytest.mark.parametrize(
        ("times", "kind", "place"),
        [
            ([-0.1], "out-of-range", "times[0]"),
            ([0.0, np.inf], "out-of-range", "times[1]"),
            (1.0, "wrong-type", "times"),
            (np.zeros((3, 2)), "wrong-count", "times"),
        ],
    )
    def test_wrong_times_are_refused(self, times: Any, kind: str, place: str) -> None:
        refused(kind, place, lambda: carom.sample_batch(three_balls(), times))

    def test_unknown_balls_are_refused(self) -> None:
        shot = three_balls()
        refused("unknown-ball", "balls[1]", lambda: carom.sample_batch(shot, [1], balls=["1", "8"]))
        refused("out-of-range", "balls[0]", lambda: carom.sample_batch(shot, [1], balls=[3]))
        refused("duplicate", "balls[1]", lambda: carom.sample_batch(shot, [1], balls=[1, "1"]))
        refused("wrong-type", "balls", lambda: carom.sample_batch(shot, [1], balls="12"))

    def test_a_result_that_would_exhaust_the_memory_is_refused(self) -> None:
        many = carom.Candidates(three_balls(), physics={"gravity": np.full(100_000, 9.8)})
        refused("out-of-range", "", lambda: carom.sample_batch(many, np.zeros(10_000)))


class TestCandidates:
    def test_shapes_broadcast_in_c_order(self) -> None:
        shots = [three_balls(side=side) for side in (0.05, 0.1, 0.2)]
        many = carom.Candidates(
            shots,
            strike={"speed": np.array([[2.0], [3.0]])},
            physics={"cloth.sliding_friction": np.array([0.17, 0.18, 0.19])},
        )
        assert many.shape == (2, 3)
        assert len(many) == 6
        for index in range(6):
            file = many.shot(index).to_dict()
            assert file["strike"]["speed"] == (2.0, 3.0)[index // 3]
            assert file["strike"]["side"] == (0.05, 0.1, 0.2)[index % 3]
            assert file["physics"]["cloth"]["sliding_friction"] == (0.17, 0.18, 0.19)[index % 3]

    def test_a_candidate_simulates_to_its_row(self) -> None:
        rng = np.random.default_rng(3)
        shot = three_balls()
        start = np.array([[0.7, 0.6], [0.9, 2.2], [0.4, 2.0]])
        many = carom.Candidates(
            shot,
            strike={"speed": rng.uniform(2, 5, 8), "side": 0.1, "azimuth_deg": 75.0},
            physics={
                "cushion.restitution.a": rng.uniform(0.85, 0.95, 8),
                "ball_ball.restitution": 0.95,
                "cloth.rolling_friction[0].friction": rng.uniform(0.004, 0.005, 8),
            },
            position=start + rng.normal(0, 1e-3, (8, 3, 2)),
        )
        found = carom.sample_batch(many, TIMES)
        for index in range(8):
            expected = many.shot(index).simulate().at(TIMES).position
            assert np.array_equal(found.position[index], expected)

    def test_the_strikes_are_those_of_a_batch(self) -> None:
        shot = three_balls()
        azimuth = np.linspace(1.2, 1.4, 7)
        ends = shot.batch(azimuth=azimuth).final_position
        found = carom.sample_batch(carom.Candidates(shot, strike={"azimuth": azimuth}), [60.0])
        assert np.allclose(found.position[:, 0], ends, rtol=0, atol=1e-12)

    def test_a_refused_candidate_is_an_error_of_its_row(self) -> None:
        many = carom.Candidates(three_balls(), physics={"cloth.sliding_friction": [0.2, -0.1]})
        found = carom.sample_batch(many, TIMES, velocity=True)
        assert list(found.errors) == [1]
        assert found.errors[1].startswith("physics.cloth.sliding_friction: -0.1 is out of range; ")
        assert found.velocity is not None
        assert np.isnan(found.position[1]).all()
        assert np.isnan(found.velocity[1]).all()
        assert np.isfinite(found.position[0]).all()
        error = refused("out-of-range", "physics.cloth.sliding_friction", lambda: many.shot(1))
        assert str(error) == found.errors[1]

    def test_errors_of_later_chunks_have_the_index_of_their_candidate(self) -> None:
        speed = np.full(1000, 3.0)
        speed[[5, 700, 999]] = -1.0
        many = carom.Candidates(three_balls(), strike={"speed": speed})
        found = carom.sample_batch(many, [0.1])
        assert list(found.errors) == [5, 700, 999]
        assert np.isnan(found.position[[5, 700, 999]]).all()
        assert np.isfinite(np.delete(found.position, [5, 700, 999], axis=0)).all()

    def test_moving_balls_are_starts(self) -> None:
        shot = three_balls()
        trace = shot.simulate()
        middle = trace.at(0.9)
        resting = carom.Shot("carom-10ft", {"cue": (0.7, 0.6), "1": (0.9, 2.2), "2": (0.4, 2.0)})
        many = carom.Candidates(
            resting,
            position=middle.position,
            velocity=middle.velocity,
            angular_velocity=middle.angular_velocity,
        )
        assert many.shape == ()
        found = carom.sample_batch(many, [0.0, 0.05, 0.1]).position[0]
        assert np.allclose(found, trace.at([0.9, 0.95, 1.0]).position, rtol=0, atol=1e-9)

    def test_vectors_in_the_plane_keep_the_third_component(self) -> None:
        high = carom.Shot("carom-10ft", [{"id": "a", "position": [0.5, 0.5, 0.3]}])
        many = carom.Candidates(high, position=[[[0.6, 0.7]], [[0.8, 0.9]]])
        found = carom.sample_batch(many, [0.0]).position
        assert np.array_equal(found[:, 0, 0], [[0.6, 0.7, 0.3], [0.8, 0.9, 0.3]])

    @pytest.mark.parametrize(
        ("arguments", "kind", "place"),
        [
            ({"physics": {"cloth.sliding": 0.2}}, "unknown-name", "physics.cloth.sliding"),
            ({"physics": {"cushion.model": 1.0}}, "unsupported", "physics.cushion.model"),
            ({"physics": {"gravity": "9.8"}}, "wrong-type", "physics.gravity"),
            ({"physics": [0.2]}, "wrong-type", "physics"),
            ({"strike": {"velocity": 2.0}}, "unknown-key", "strike.velocity"),
            ({"strike": {"azimuth": 1.0, "azimuth_deg": 60}}, "duplicate", "strike.azimuth"),
            ({"strike": {"speed": [1, 2], "side": [0, 0, 0]}}, "wrong-count", ""),
            ({"position": np.zeros((2, 2))}, "wrong-count", "position"),
            ({"angular_velocity": np.zeros((3, 2))}, "wrong-count", "angular_velocity"),
            (
                {"physics": {"gravity": [9.8, 9.9]}, "position": np.zeros((3, 3, 2))},
                "wrong-count",
                "",
            ),
        ],
    )
    def test_wrong_arguments_are_refused(
        self, arguments: dict[str, Any], kind: str, place: str
    ) -> None:
        refused(kind, place, lambda: carom.Candidates(three_balls(), **arguments))

    def test_wrong_shots_are_refused(self) -> None:
        two = carom.Shot("carom-10ft", {"cue": (0.7, 0.6), "1": (0.9, 2.2)})
        refused("wrong-type", "shots", lambda: carom.Candidates(3))  # type: ignore[arg-type]
        refused("wrong-type", "shots[1]", lambda: carom.Candidates([two, 3]))  # type: ignore[list-item]
        refused("no-strike", "strike", lambda: carom.Candidates(two, strike={"speed": 2.0}))
        refused(
            "wrong-count",
            "position",
            lambda: carom.Candidates([two, three_balls()], position=np.zeros((2, 2))),
        )

    def test_impossible_starts_are_errors_of_their_rows(self) -> None:
        shot = carom.Shot("carom-10ft", {"cue": (0.7, 0.6), "1": (0.9, 2.2)})
        position = np.tile([[0.7, 0.6], [0.9, 2.2]], (4, 1, 1))
        position[1, 1] = (0.71, 0.6)  # overlaps
        position[2, 1] = (1.41, 2.2)  # beyond the nose
        position[3, 0] = (np.nan, 0.6)
        found = carom.sample_batch(carom.Candidates(shot, position=position), [0.0, 1.0])
        texts = ("overlaps balls[0]", "cushion", "NaN")
        assert list(found.errors) == [1, 2, 3]
        for index, text in enumerate(texts, 1):
            assert text in found.errors[index], found.errors[index]


class TestResiduals:
    def test_the_shot_that_made_the_tracks_has_none(self) -> None:
        shot = three_balls()
        tracks = tracks_of(shot)
        found = carom.track_residuals(shot, tracks)
        assert found.residual is not None
        assert found.residual.shape == (1, len(tracks), 2)
        assert not found.residual.any()
        assert not found.sum.any()
        assert found.count.tolist() == [[[21], [61]]]
        assert not found.out_of_play.any()

    def test_they_are_simulated_minus_placed_positions(self) -> None:
        tracks = tracks_of(three_balls(), clock=0.3, sigma=0.002)
        many = carom.Candidates(three_balls(), strike={"speed": [3.9, 4.0, 4.1]})
        rotation = np.array([0.0, 0.01, -0.02])
        offset, scale, clock = np.array([0.003, -0.001]), 1.001, 0.28
        found = carom.track_residuals(
            many, tracks, clock=clock, offset=offset, rotation=rotation, scale=scale
        )
        assert found.residual is not None
        centre = np.array([1.42, 2.84]) / 2
        for index in range(3):
            cos, sin = np.cos(rotation[index]), np.sin(rotation[index])
            turn = np.array([[cos, -sin], [sin, cos]])
            placed = centre + scale * (tracks.position - centre) @ turn.T + offset
            trace = many.shot(index).simulate()
            times = np.maximum(tracks.time - clock, 0.0)
            every = trace.at(times).position[..., :2]
            columns = [trace.shot.ids.index(ball) for ball in tracks.ids]
            simulated = every[np.arange(len(tracks)), np.array(columns)[tracks.ball]]
            expected = (simulated - placed) / 0.002
            assert np.allclose(found.residual[index], expected, rtol=0, atol=1e-9)
            for ball in range(2):
                squares = (expected[tracks.ball == ball] ** 2).sum()
                assert np.isclose(found.sum[index, ball, 0], squares, rtol=1e-9)

    def test_horizons_limit_sums_and_samples(self) -> None:
        tracks = tracks_of(three_balls())
        many = carom.Candidates(three_balls(), strike={"speed": [3.9, 4.1]})
        every = carom.track_residuals(many, tracks).residual
        found = carom.track_residuals(many, tracks, horizons=[1.0, 2.5])
        assert every is not None
        assert found.residual is not None
        used = tracks.time <= 2.5
        assert np.array_equal(found.residual[:, used], every[:, used])
        assert not found.residual[:, ~used].any()
        for h, horizon in enumerate((1.0, 2.5)):
            for ball in range(2):
                within = (tracks.time <= horizon) & (tracks.ball == ball)
                assert (found.count[:, ball, h] == within.sum()).all()
                squares = (every[:, within] ** 2).sum(axis=(1, 2))
                assert np.allclose(found.sum[:, ball, h], squares, rtol=1e-12)

    def test_sums_alone_have_the_same_bits(self) -> None:
        tracks = tracks_of(three_balls())
        many = carom.Candidates(three_balls(), strike={"speed": np.linspace(3, 5, 300)})
        both = carom.track_residuals(many, tracks, threads=1)
        sums = carom.track_residuals(many, tracks, residuals=False, threads=3)
        assert sums.residual is None
        assert np.array_equal(both.sum, sums.sum)

    def test_each_shot_may_have_its_own_tracks(self) -> None:
        shots = [three_balls(), three_balls(speed=3.0)]
        tracks = [tracks_of(shots[0]), carom.BallTracks({"1": ([0.5], [[0.9, 2.2]])})]
        many = carom.Candidates(shots, physics={"gravity": np.array([[9.80665], [9.7]])})
        found = carom.track_residuals(many, tracks)
        assert found.residual is not None
        assert found.residual.shape == (4, 82, 2)
        assert found.count[:, :, 0].tolist() == [[21, 61], [1, 0], [21, 61], [1, 0]]
        assert not found.sum[0].any()
        assert found.sum[2].any()

    def test_samples_of_a_ball_in_a_pocket_are_counted(self) -> None:
        shot = carom.Shot.load("shots/bank_shot.json")
        trace = shot.simulate()
        falls = next(event for event in trace.events if event.type == "pocket-collision")
        (ball,) = falls.balls
        times = falls.time + np.array([-0.2, 0.5, 1.0])
        position = trace.at(times).position[:, shot.ids.index(ball), :2]
        found = carom.track_residuals(shot, carom.BallTracks({ball: (times, position)}))
        assert found.out_of_play.tolist() == [[2]]
        assert not found.sum.any()

    def test_a_refused_candidate_is_an_error_of_its_row(self) -> None:
        tracks = tracks_of(three_balls())
        many = carom.Candidates(three_balls(), strike={"speed": [4.0, 99.0]})
        found = carom.track_residuals(many, tracks, scale=[0.0, 1.0])
        assert found.residual is not None
        assert found.errors[0].startswith("scale: ")
        assert found.errors[1].startswith("strike.speed: ")
        assert np.isnan(found.residual).all()
        assert np.isnan(found.sum).all()

    @pytest.mark.parametrize(
        ("arguments", "kind", "place"),
        [
            ({"clock": [0.0, 0.1]}, "wrong-count", "clock"),
            ({"offset": 0.1}, "wrong-count", "offset"),
            ({"offset": [0.1, 0.2, 0.3]}, "wrong-count", "offset"),
            ({"rotation": np.zeros((2, 1))}, "wrong-count", "rotation"),
            ({"horizons": [2.0, 1.0]}, "out-of-range", "horizons"),
            ({"horizons": []}, "out-of-range", "horizons"),
            ({"horizons": [np.nan]}, "out-of-range", "horizons"),
            ({"residuals": 1}, "wrong-type", "residuals"),
            ({"threads": 0}, "wrong-type", "threads"),
        ],
    )
    def test_wrong_arguments_are_refused(
        self, arguments: dict[str, Any], kind: str, place: str
    ) -> None:
        shot = three_balls()
        refused(kind, place, lambda: carom.track_residuals(shot, tracks_of(shot), **arguments))

    def test_wrong_tracks_are_refused(self) -> None:
        shot = three_balls()
        other = carom.BallTracks({"8": ([0.5], [[0.9, 2.2]])})
        refused("unknown-ball", "tracks", lambda: carom.track_residuals(shot, other))
        refused("wrong-count", "tracks", lambda: carom.track_residuals(shot, [other, other]))
        refused("wrong-type", "tracks", lambda: carom.track_residuals(shot, {}))  # type: ignore[arg-type]
        refused("wrong-type", "tracks[0]", lambda: carom.track_residuals(shot, [3]))  # type: ignore[list-item]


class TestTracks:
    def test_all_samples_follow_in_the_given_order(self) -> None:
        tracks = carom.BallTracks(
            {"b": ([2.0, 1.0], [[1, 2], [3, 4]]), "a": ([0.5], [[5, 6]], 0.01)}
        )
        assert tracks.ids == ["b", "a"]
        assert tracks.ball.tolist() == [0, 0, 1]
        assert tracks.time.tolist() == [2.0, 1.0, 0.5]
        assert tracks.position.tolist() == [[1, 2], [3, 4], [5, 6]]
        assert tracks.sigma.tolist() == [1.0, 1.0, 0.01]
        assert len(tracks) == 3
        assert str(tracks) == "<carom.BallTracks: 3 samples of b, a>"

    def test_a_pickle_has_the_same_samples(self) -> None:
        shot = three_balls(speed=3.5)
        tracks = tracks_of(three_balls())
        again = pickle.loads(pickle.dumps(tracks))
        assert again.ids == tracks.ids
        one, other = (carom.track_residuals(shot, seen).residual for seen in (tracks, again))
        assert np.array_equal(one, other)  # type: ignore[arg-type]

    @pytest.mark.parametrize(
        ("track", "kind", "place"),
        [
            (([0.5],), "wrong-count", "cue"),
            (([0.5], [[0.9, 2.2], [1, 2]]), "wrong-count", "cue"),
            (([0.5], [[0.9, 2.2]], [0.1, 0.2]), "wrong-count", "cue.sigmas"),
            (([0.5], [[0.9, 2.2]], 0.0), "out-of-range", "cue.sigmas[0]"),
            (([np.nan], [[0.9, 2.2]]), "out-of-range", "cue.times[0]"),
            (([0.5], [[0.9, np.inf]]), "out-of-range", "cue.positions[0]"),
            ((["x"], [[0.9, 2.2]]), "wrong-type", "cue.times"),
        ],
    )
    def test_wrong_samples_are_refused(self, track: Any, kind: str, place: str) -> None:
        refused(kind, place, lambda: carom.BallTracks({"cue": track}))

    def test_a_track_without_samples_has_no_residuals(self) -> None:
        tracks = carom.BallTracks({"cue": ([], np.empty((0, 2)))})
        found = carom.track_residuals(three_balls(), tracks)
        assert found.sum.tolist() == [[[0.0]]]
        assert found.count.tolist() == [[[0]]]
