"""Tracks: their types, their frames, and the files that carom writes and reads."""

from __future__ import annotations

import copy
import gzip
import json
import math
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import carom
import jsonschema
import numpy as np
import pytest
from carom import InputError, learn
from carom.learn import FileFrame, TrackedBall, TrackedShot, Tracks, TracksHeader

TABLE = "carom-10ft"
WIDTH, LENGTH = 1.42, 2.84
RADIUS = 0.03075


def shot(speed: float = 4.0, azimuth: float = 1.2) -> carom.Shot:
    balls = {"1": (0.5, 0.6), "2": (0.9, 1.3), "3": (1.1, 2.2)}
    strike = carom.Strike(speed, azimuth, side=0.2, height=0.1, ball="1")
    return carom.Shot(TABLE, balls, strike)


@pytest.fixture(scope="module")
def made() -> learn.SyntheticTracks:
    return learn.synthetic([shot(), shot(3.0, 0.7)], sigma=0.001, lost=0.1, seed=3)


# Types.


def test_samples_are_checked_and_cannot_be_changed() -> None:
    ball = TrackedBall([0.0, 0.1], [(0.1, 0.2), (0.3, 0.4)], 0.001)
    assert ball.sigma is not None
    assert ball.sigma.tolist() == [0.001, 0.001]
    with pytest.raises(ValueError, match="read-only"):
        ball.time[0] = 1.0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (([0.0, 0.0], np.zeros((2, 2))), "strictly increasing"),
        (([0.0, math.nan], np.zeros((2, 2))), "strictly increasing"),
        (([0.0, 1.0], np.zeros((2, 3))), "do not fit"),
        (([0.0, 1.0], [(0.0, 0.0), (math.nan, 0.0)]), "not finite"),
        (([0.0, 1.0], np.zeros((2, 2)), -1.0), "standard deviation"),
        (([0.0, 1.0], np.zeros((2, 2)), None, [True]), "visible"),
    ],
)
def test_samples_that_cannot_be_are_refused(arguments: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        TrackedBall(*arguments)


def test_a_ball_that_was_not_seen_has_no_place() -> None:
    ball = TrackedBall([0.0, 0.1], [(0.1, 0.2), (0.3, 0.4)], visible=[True, False])
    assert np.isnan(ball.position[1]).all()
    assert len(ball.seen) == 1


def test_two_shots_of_one_name_are_refused() -> None:
    one = TrackedShot("1", {"cue": ([0.0], [(0.5, 0.5)])})
    with pytest.raises(InputError, match="two shots are named '1'"):
        Tracks(TracksHeader(), (one, one))


def test_shots_are_found_by_number_name_and_slice(made: learn.SyntheticTracks) -> None:
    tracks = made.tracks
    assert tracks["2"] is tracks[1]
    assert tracks[1:].names == ["2"]
    with pytest.raises(InputError, match="no shot 'x'"):
        tracks["x"]


def test_tracks_can_be_pickled(made: learn.SyntheticTracks) -> None:
    assert pickle.loads(pickle.dumps(made.tracks[0])) == made.tracks[0]
    assert copy.deepcopy(made.tracks[0].balls["1"]) == made.tracks[0].balls["1"]


# Files.


@pytest.mark.parametrize("ending", [".csv", ".csv.gz", ".parquet"])
@pytest.mark.parametrize(
    "frame",
    [
        FileFrame(),
        FileFrame("mm", "centre", "length", mirrored=True),
        FileFrame(0.0012, (1100.0, 620.0), "width", mirrored=True),
        FileFrame("in", "corner", "length"),
    ],
    ids=["own", "centre", "pixels", "inches"],
)
def test_tracks_that_are_written_are_read_again(
    made: learn.SyntheticTracks, tmp_path: Path, ending: str, frame: FileFrame
) -> None:
    header = TracksHeader(
        table=TABLE, radius=RADIUS, rate=50.0, frame=frame, time_unit="ms", columns={"t": "when"}
    )
    written = Tracks(header, made.tracks.shots)
    path = tmp_path / f"tracks{ending}"
    learn.write_tracks(written, path)
    found = learn.read_tracks(path)
    assert found.header == header
    assert found.names == written.names
    for a, b in zip(found, written, strict=True):
        assert a.ids == b.ids
        for ball in a.ids:
            np.testing.assert_allclose(a.balls[ball].time, b.balls[ball].time, atol=1e-8)
            np.testing.assert_allclose(a.balls[ball].position, b.balls[ball].position, atol=1e-8)
            assert (a.balls[ball].visible == b.balls[ball].visible).all()


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("x", ["width", "length"])
@pytest.mark.parametrize("origin", ["corner", "centre", (3.0, -1.0)])
def test_a_frame_keeps_distances_and_its_inverse_gives_the_file_again(
    origin: Any, x: Any, mirrored: bool
) -> None:
    frame = FileFrame("cm", origin, x, mirrored)
    places = np.random.default_rng(0).uniform(0.0, 100.0, (20, 2))
    table = frame.to_table(places, (WIDTH, LENGTH))
    np.testing.assert_allclose(frame.to_file(table, (WIDTH, LENGTH)), places, atol=1e-9)
    apart = np.hypot(*np.diff(places, axis=0).T)
    np.testing.assert_allclose(np.hypot(*np.diff(table, axis=0).T), apart * 0.01)
    (a, b), (c, d) = np.diff(places[:3], axis=0), np.diff(table[:3], axis=0)
    turn = np.sign((a[0] * b[1] - a[1] * b[0]) * (c[0] * d[1] - c[1] * d[0]))
    assert turn == (-1.0 if mirrored else 1.0)


def test_a_frame_along_the_length_puts_its_corner_on_a_corner() -> None:
    frame = FileFrame(x="length")
    found = frame.to_table(np.array([(0.0, 0.0), (LENGTH, 0.0)]), (WIDTH, LENGTH))
    np.testing.assert_allclose(found, [(WIDTH, 0.0), (WIDTH, LENGTH)])


def test_a_header_and_its_schema_agree() -> None:
    schema = carom.schema("tracks")
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    full = TracksHeader(
        table={"base": TABLE, "width": 1.4},
        radius=RADIUS,
        sigma=0.001,
        least_move=0.02,
        rate=50.0,
        frame=FileFrame(0.001, (1.0, 2.0), "length", mirrored=True),
        time_unit="frame",
        columns={"t": "frame"},
        note="a hall",
    )
    for header in (TracksHeader(), full):
        validator.validate(header.to_dict())
        assert TracksHeader.from_json(header.to_json()) == header
    assert set(full.to_dict()) == set(schema["properties"])


BROKEN_HEADERS: dict[str, dict[str, Any]] = {
    "an unknown key": {"tabel": TABLE},
    "another format": {"format": "carom-tracks/9"},
    "a radius of zero": {"radius": 0},
    "a radius in millimetres": {"radius": 30.75},
    "a text for a radius": {"radius": "30 mm"},
    "an unknown unit": {"frame": {"unit": "px"}},
    "an unknown origin": {"frame": {"origin": "top-left"}},
    "an origin of three numbers": {"frame": {"origin": [1, 2, 3]}},
    "an axis across": {"frame": {"x": "across"}},
    "a mirror that is a number": {"frame": {"mirrored": 1}},
    "an unknown unit of time": {"clock": {"unit": "min"}},
    "an unknown column": {"columns": {"z": "z"}},
    "a rate of zero": {"clock": {"rate": 0}},
    "a note that is a list": {"note": []},
}


@pytest.mark.parametrize("what", BROKEN_HEADERS)
def test_a_header_that_the_schema_refuses_is_refused(what: str) -> None:
    header = TracksHeader(table=TABLE).to_dict() | BROKEN_HEADERS[what]
    assert not jsonschema.Draft202012Validator(carom.schema("tracks")).is_valid(header)
    with pytest.raises(InputError):
        TracksHeader.from_dict(header)


@pytest.mark.parametrize(
    ("header", "words"),
    [
        ({"clock": {"unit": "frame"}}, "clock.rate"),
        ({"clock": {"rate": -1}}, "clock.rate"),
        ({"table": "no-such-table"}, "no table preset"),
        ({"table": {"cloth": "unbounded"}}, "name a table with rails"),
    ],
)
def test_a_header_that_means_nothing_is_refused(header: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        TracksHeader.from_dict({"format": "carom-tracks/1", **header})


def test_an_error_of_a_header_names_its_file(made: learn.SyntheticTracks, tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    learn.write_tracks(made.tracks, path)
    (tmp_path / "a.csv.json").write_text('{"format": "carom-tracks/1",\n oops}', encoding="utf-8")
    with pytest.raises(InputError, match=r"a\.csv\.json: not JSON: .*line 2, column 2"):
        learn.read_tracks(path)


def test_a_file_of_another_ending_is_not_written(
    made: learn.SyntheticTracks, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=r"\.parquet"):
        learn.write_tracks(made.tracks, tmp_path / "tracks.xlsx")


# Files of others.


def match_file(tracks: Tracks, path: Path) -> None:
    """Writes tracks with the columns and the frame of a public three-cushion match."""
    lines = ["shot,ball,t_s,x_m,y_m"]
    frame = FileFrame(x="length")
    for one in tracks:
        for ball, track in one.balls.items():
            places = frame.to_file(track.position, (WIDTH, LENGTH))
            for t, (x, y) in zip(track.time, places, strict=True):
                lines.append(f"{one.name},{ball},{t:.4f},{x:.5f},{y:.5f}")
    path.write_bytes(gzip.compress(("\n".join(lines) + "\n").encode()))


@pytest.mark.parametrize("given", [{}, {"table": TABLE, "radius": RADIUS}])
def test_a_three_cushion_match_is_read_without_a_header(
    given: dict[str, Any], tmp_path: Path
) -> None:
    tracks = learn.synthetic([shot()], least_move=0.02).tracks
    match_file(tracks, tmp_path / "match.csv.gz")
    found = learn.read_tracks(tmp_path / "match.csv.gz", **given)
    assert found.header.table == TABLE
    assert found.header.radius == RADIUS
    assert [finding.kind for finding in found.findings] == ["assumed"]
    for ball, track in found[0].balls.items():
        np.testing.assert_allclose(track.position, tracks[0].balls[ball].position, atol=1e-5)


def test_the_usual_names_of_columns_are_recognised_with_their_units(tmp_path: Path) -> None:
    path = tmp_path / "tracks.csv"
    path.write_text(
        "Frame;Ball_ID;X_mm;Y_mm;Confidence\n0;cue;635,0;700,5;0,9\n1;cue;636,0;710,5;0,8\n",
        encoding="utf-8",
    )
    found = learn.read_tracks(path, rate=100.0, table="wpa-9ft")
    np.testing.assert_allclose(found[0].balls["cue"].time, [0.0, 0.01])
    np.testing.assert_allclose(found[0].balls["cue"].position[1], (0.636, 0.7105))
    assert {finding.kind for finding in found.findings} == {"decimal-comma", "unused", "assumed"}


def test_columns_of_any_name_can_be_given(tmp_path: Path) -> None:
    path = tmp_path / "tracks.csv"
    path.write_text("when,who,east,north\n0,cue,0.5,0.6\n0.1,cue,0.5,0.7\n", encoding="utf-8")
    names = {"t": "when", "ball": "who", "x": "east", "y": "north"}
    assert len(learn.read_tracks(path, columns=names)[0].balls["cue"]) == 2
    with pytest.raises(InputError, match=r"no column for ball, t, x, y.*--columns"):
        learn.read_tracks(path)
    with pytest.raises(InputError, match="no column 'west'"):
        learn.read_tracks(path, columns=names | {"x": "west"})


POOLTOOL = Path(__file__).parent / "data" / "pooltool"


def test_a_simulated_system_of_pooltool_is_read() -> None:
    tracks = learn.read_tracks(POOLTOOL / "pot_simulated.msgpack", rate=200.0)
    shot = tracks[0]
    assert shot.ids == ["cue", "1", "2"]
    assert tracks.header.table == "showood-7ft"
    assert tracks.header.radius == 0.028575
    # The places and times of events are in the file: the collision, and the fall of the ball 1.
    cue = shot.balls["cue"]
    index = int(np.searchsorted(cue.time, 0.18947024237125387))
    place = (0.5982530432220583, 1.1471493389738732)
    assert math.dist(cue.position[index], place) < 0.4 * 0.005
    assert math.dist(cue.position[index - 1], place) < 2.9 * 0.005
    assert shot.balls["1"].time[-1] < 0.5538052582043306 < shot.balls["1"].time[-1] + 0.006
    assert (shot.balls["2"].position == (0.2, 1.7)).all()


def test_a_system_that_was_not_simulated_is_refused() -> None:
    with pytest.raises(InputError, match="simulate the system"):
        learn.read_tracks(POOLTOOL / "pot.json")


def tailuge_shots(frame: FileFrame, key: str) -> list[dict[str, Any]]:
    tracks = learn.synthetic([shot()], least_move=0.02).tracks
    balls = {}
    for ball, track in tracks[0].balls.items():
        x, y = frame.to_file(track.position, (WIDTH, LENGTH)).T
        balls[ball] = {"t": track.time.tolist(), "x": x.tolist(), "y": y.tolist()}
    return [{key: 7, "balls": balls}]


@pytest.mark.parametrize(("origin", "key"), [("centre", "id"), ("corner", "shotID")])
def test_shots_of_tailuge_billiards_are_read(tmp_path: Path, origin: str, key: str) -> None:
    frame = FileFrame(origin=origin, x="length")
    path = tmp_path / "shots.json"
    path.write_text(json.dumps(tailuge_shots(frame, key)), encoding="utf-8")
    found = learn.read_tracks(path)
    assert found.names == ["7"]
    assert found.header.frame == frame
    true = learn.synthetic([shot()], least_move=0.02).tracks[0]
    for ball, track in found[0].balls.items():
        np.testing.assert_allclose(track.position, true.balls[ball].position, atol=1e-9)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda shots: shots[0]["balls"]["1"]["t"].pop(), r"\[0\]\.balls\.1: has \d+ times"),
        (lambda shots: shots[0].pop("balls"), 'has no "balls"'),
        (lambda shots: shots.clear(), "empty list"),
    ],
)
def test_broken_shots_of_tailuge_billiards_are_refused(
    tmp_path: Path, change: Callable[[Any], object], words: str
) -> None:
    shots = tailuge_shots(FileFrame(x="length"), "id")
    change(shots)
    path = tmp_path / "shots.json"
    path.write_text(json.dumps(shots), encoding="utf-8")
    with pytest.raises(InputError, match=words):
        learn.read_tracks(path)


# Synthetic tracks.


def test_synthetic_tracks_have_the_errors_that_were_asked_for() -> None:
    made = learn.synthetic([shot()], sigma=0.002, rate=240.0, seed=1)
    ball = made.tracks[0].balls["1"]
    error = ball.position - made.traces[0].at(ball.time).position[:, 0, :2]
    assert abs(error.std() / 0.002 - 1.0) < 0.05
    assert made.tracks.header.sigma == 0.002


def test_synthetic_tracks_lose_the_share_that_was_asked_for() -> None:
    made = learn.synthetic([shot()] * 20, lost=0.3, gap=0.1)
    visible = np.concatenate([b.visible for s in made.tracks for b in s.balls.values()])
    assert abs(visible.mean() - 0.7) < 0.03


def test_the_sampling_rule_stores_a_ball_only_when_it_has_moved() -> None:
    made = learn.synthetic([shot()], sigma=0.0, least_move=0.02)
    for ball in made.tracks[0].balls.values():
        assert (np.hypot(*np.diff(ball.position, axis=0).T)[:-1] >= 0.02).all()
    assert made.tracks[0].balls["3"].time[0] == 0.0


def test_the_clock_and_the_frame_of_the_camera_are_undone_by_their_numbers() -> None:
    numbers = {"rotation": 0.01, "offset": (0.003, -0.002), "scale": 1.002}
    made = learn.synthetic(
        [shot()],
        sigma=0.0,
        clock_offset=0.3,
        clock_drift=1e-3,
        **numbers,  # type: ignore[arg-type]
    )
    ball = made.tracks[0].balls["1"]
    centre = np.array((WIDTH, LENGTH)) / 2.0
    cos, sin = math.cos(0.01), math.sin(0.01)
    turn = np.array(((cos, -sin), (sin, cos)))
    table = centre + 1.002 * (ball.position - centre) @ turn.T + (0.003, -0.002)
    times = np.maximum((ball.time - 0.3) / 1.001, 0.0)
    np.testing.assert_allclose(table, made.traces[0].at(times).position[:, 0, :2], atol=1e-12)
    first = made.contacts(0)[0]
    event = next(e for e in made.traces[0].events if e.type in ("ball-collision", "rail-collision"))
    assert first.time == pytest.approx(0.3 + 1.001 * event.time)
    assert first.balls == tuple(event.balls)


def test_a_pocketed_ball_is_not_seen_any_more() -> None:
    pot = carom.Shot.load(Path(__file__).parents[2] / "shots" / "side_pocket_cut.json")
    made = learn.synthetic(pot)
    fall = next(e for e in made.traces[0].events if e.type == "pocket-collision")
    ball = made.tracks[0].balls[fall.balls[0]]
    assert ball.time[ball.visible][-1] < fall.time
    assert not ball.visible[-1]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"rate": 0.0}, "rate"),
        ({"sigma": -1.0}, "sigma"),
        ({"lost": 1.0}, "lost"),
        ({"clock_offset": -0.1}, "clock_offset"),
        ({"jitter": 1.0}, "jitter"),
        ({"names": ["a", "b"]}, "names"),
        ({"rate": 1e5, "until": 1e4}, "too many"),
    ],
)
def test_synthetic_tracks_that_cannot_be_are_refused(arguments: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        learn.synthetic(shot(), **arguments)
    with pytest.raises(InputError, match="their tables differ"):
        learn.synthetic([shot(), carom.break_shot()])
