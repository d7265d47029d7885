"""Pictures: exact paths, and all the elements that belong in a picture."""

from __future__ import annotations

import copy
import math
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import carom
import carom.env
import gymnasium
import matplotlib
import numpy as np
import pytest
from carom import Shot, picture
from carom.picture import evaluation, maps, plays, solutions
from carom.picture.balls import mark
from carom.picture.colors import look
from carom.picture.paths import Leg, routes, starts
from carom.picture.table import Ground

# Tolerance between a leg's curve and the ball's state, m. They are computed by different closed
# forms, which differ by a few roundings of positions of a few metres.
CURVE_ROUNDING = 1e-12
# Relative accuracy of the numerical length below.
QUADRATURE = 1e-9

# A trace of two balls, written by hand: `a` slides on a parabola into a rail and comes back on a
# straight line; `b` never moves.
BY_HAND: dict[str, Any] = {
    "engine": "by hand",
    "hash": "0" * 16,
    "duration": 3.0,
    "events": [
        {
            "time": 1.0,
            "type": "rail-collision",
            "balls": ["a"],
            "rail": "right",
            "part": "nose",
            "before": [{"id": "a", "position": [1.0, 0.5, 0.03], "velocity": [1.0, 1.0, 0.0]}],
            "after": [{"id": "a", "position": [1.0, 0.5, 0.03], "velocity": [-1.0, 0.0, 0.0]}],
        },
    ],
    "final": [
        {"id": "a", "position": [0.0, 0.5, 0.03], "motion": "stationary"},
        {"id": "b", "position": [2.0, 2.0, 0.03], "motion": "stationary"},
    ],
}
BALLS: list[dict[str, Any]] = [
    {"id": "a", "position": [0.0, 0.0, 0.03], "velocity": [1.0, 0.0, 0.0], "radius": 0.03},
    {"id": "b", "position": [2.0, 2.0, 0.03], "velocity": [0.0, 0.0, 0.0], "radius": 0.03},
]


def test_a_leg_is_the_parabola_from_one_event_to_the_next() -> None:
    a, b = routes(BY_HAND, BALLS)
    first, second = a.legs
    assert (first.start, first.control, first.end) == ((0.0, 0.0), (0.5, 0.0), (1.0, 0.5))
    assert (second.start, second.control, second.end) == ((1.0, 0.5), (0.0, 0.5), (0.0, 0.5))
    assert (first.start_time, first.end_time, second.end_time) == (0.0, 1.0, 3.0)
    assert b.legs == ()
    assert b.length == 0.0


def test_a_flight_is_the_parabola_in_height_too() -> None:
    leg = Leg(0.0, 0.2, (0.0, 0.0), (0.1, 0.0), (0.2, 0.0), (0.03, 0.23, 0.13))
    rising = (0.23 - 0.03) / 0.1
    fall = (0.03 + rising * 0.2 - 0.13) / 0.2**2
    assert leg.flies
    assert math.isclose(leg.at(0.07)[2], 0.03 + rising * 0.07 - fall * 0.07**2)
    assert math.isclose(leg.top, 0.03 + rising**2 / (4 * fall))
    level = Leg(0.0, 0.2, (0.0, 0.0), (0.1, 0.0), (0.2, 0.0), (0.07, 0.07, 0.07))
    assert not level.flies
    assert level.top == 0.07
    falling = Leg(0.0, 0.2, (0.0, 0.0), (0.1, 0.0), (0.2, 0.0), (0.07, 0.06, 0.03))
    assert falling.top == 0.07


def test_the_curves_are_the_paths_of_the_balls(nine_ball_trace: carom.Trace) -> None:
    shot = nine_ball_trace.shot
    start = nine_ball_trace.at(0.0)
    balls = [
        {"id": i, "radius": r, "position": p, "velocity": v}
        for i, r, p, v in zip(shot.ids, shot.radius, start.position, start.velocity, strict=True)
    ]
    checked = 0
    for index, route in enumerate(routes(nine_ball_trace.to_dict(), balls)):
        for leg in route.legs:
            for s in (0.0, 0.21, 0.5, 0.83):
                time = leg.start_time + s * (leg.end_time - leg.start_time)
                weights = ((1 - s) ** 2, 2 * s * (1 - s), s**2)
                curve = np.dot(weights, (leg.start, leg.control, leg.end))
                ball = nine_ball_trace.at(time).position[index, :2]
                assert np.abs(curve - ball).max() < CURVE_ROUNDING
                checked += 1
    assert checked > 100


@pytest.mark.parametrize(
    "control",
    [(0.5, 0.0), (0.5, 1e-9), (0.5, 0.3), (-2.0, 0.0), (3.0, 0.0), (0.1, -4.0)],
    ids=str,
)
def test_the_length_of_a_leg_is_the_length_of_its_curve(control: tuple[float, float]) -> None:
    leg = Leg(0.0, 1.0, (0.0, 0.0), control, (1.0, 0.0))
    s = np.linspace(0.0, 1.0, 400_001)[:, None]
    points = 2 * s * (1 - s) * np.array(control) + s**2 * np.array([1.0, 0.0])
    length = np.hypot(*np.diff(points, axis=0).T).sum()
    assert math.isclose(leg.length, length, rel_tol=QUADRATURE)


def test_a_strike_into_a_frozen_ball_is_drawn_with_both_paths_and_a_mark() -> None:
    gap = 2 * 0.028575
    shot = Shot.from_dict(
        {
            "format": "carom-shot/1",
            "table": "wpa-9ft",
            "balls": [
                {"id": "cue", "position": [0.6, 0.6]},
                {"id": "1", "position": [0.6, 0.6 + gap]},
            ],
            "strike": {"ball": "cue", "speed": 0.5, "azimuth_deg": 90.0, "elevation_deg": 0.0},
        }
    )
    trace = shot.simulate()
    drawn = routes(trace.to_dict(), starts(trace))
    for index, route in enumerate(drawn):
        assert route.legs[0].start_time == 0.0
        for time in np.linspace(0.0, trace.duration, 7).tolist():
            assert np.abs(route.at(time) - trace.at(time).position[index]).max() < CURVE_ROUNDING
    by_id = {route.id: route for route in drawn}
    assert mark(trace.to_dict()["events"][0], by_id) == "ball-collision"
    ids = [patch.get_gid() for patch in picture.draw(trace).axes[0].patches]
    assert {"path-cue", "path-1"} <= set(ids)


def test_the_svg_holds_every_path_as_exact_curves(nine_ball_trace: carom.Trace) -> None:
    root = ElementTree.fromstring(picture.svg(nine_ball_trace))
    paths = {
        group.attrib["id"]: group
        for group in root.iter("{http://www.w3.org/2000/svg}g")
        if group.attrib.get("id", "").startswith("path-")
    }
    moved = {ball["id"] for event in nine_ball_trace.events for ball in event["after"]}
    assert {f"path-{ball}" for ball in moved} == set(paths)
    data = paths["path-cue"].find("{http://www.w3.org/2000/svg}path")
    assert data is not None
    assert len(re.findall("Q", data.attrib["d"])) >= 3
    assert "L" not in data.attrib["d"]


def of_gallery(name: str) -> carom.Trace:
    return Shot.load(Path(__file__).parents[2] / "shots" / f"{name}.json").simulate()


def test_a_jump_is_dotted_has_a_shadow_and_a_side_view_with_the_ball_under_it() -> None:
    trace = of_gallery("jump_shot")
    figure = picture.draw(trace)
    ids = [patch.get_gid() for patch in figure.axes[0].patches]
    assert {"path-cue", "flight-cue", "shadow-cue"} <= set(ids)
    _, side, *_ = figure.axes
    curves = [patch for patch in side.patches if patch.get_gid() == "side-cue"]
    heights = trace.at(np.linspace(0.0, trace.duration, 20_001)).position[:, 0, 2]
    drawn = max(patch.get_path().interpolated(1).vertices[:, 1].max() for patch in curves)
    # The control point of a parabola is twice as high above its ends as the curve.
    assert math.isclose(drawn - heights[0], 2 * (heights.max() - heights[0]), rel_tol=1e-4)
    # The 8 is drawn under the path, with its number, at its distance from the cue ball.
    eight = next(text for text in side.texts if text.get_text() == "8")
    cue, passed = (np.array(trace.shot.to_dict()["balls"][i]["position"]) for i in (0, 1))
    assert math.isclose(eight.get_position()[0], np.linalg.norm(passed - cue), rel_tol=1e-3)
    assert side.get_xlim()[0] < 0.0
    scale = [np.diff(limits)[0] for limits in (side.get_xlim(), side.get_ylim())]
    box = side.get_window_extent()
    assert math.isclose(scale[0] / box.width, scale[1] / box.height, rel_tol=1e-9)


def test_each_ball_that_flies_over_unbounded_cloth_has_a_side_view(endless: dict[str, Any]) -> None:
    endless["balls"] = [
        {"id": "a", "position": [0.0, 0.0, 0.3], "velocity": [1.0, 0.2, 0.0]},
        {"id": "b", "position": [0.4, 0.1]},
        {"id": "12", "position": [0.0, 0.5, 0.2], "velocity": [1.0, -0.6, 1.0]},
    ]
    trace = Shot.from_dict(endless).simulate()
    rises = trace.at(np.linspace(0.0, trace.duration, 5001)).position[:, :, 2].max(axis=0)
    flyers = [b for b, top in zip("ab2", rises, strict=True) if top > trace.shot.radius[0] + 5e-3]
    assert len(picture.draw(trace).axes) == 1 + len(flyers) > 2


def test_a_shot_on_the_cloth_has_no_side_view(pot: dict[str, Any]) -> None:
    figure = picture.draw(Shot.from_dict(pot).simulate())
    assert len(figure.axes) == 1
    assert not [p for p in figure.axes[0].patches if str(p.get_gid()).startswith("flight")]


def test_a_run_of_hops_over_an_edge_has_one_mark() -> None:
    trace = of_gallery("rail_top_landing")
    nose = [e for e in trace.events if e.type == "rail-collision" and e.part == "nose"]
    bounces = [e for e in trace.events if e.type == "slate-collision"]
    assert len(nose) > 5
    marks = picture.draw(trace).axes[0].lines
    diamonds = [line for line in marks if line.get_marker() == "D"]
    # One for the hops over the nose, two for the cushions, one in the legend.
    assert len(diamonds) == 1 + 2 + 1
    hops = [line for line in marks if line.get_marker() == "v"]
    tops = [e for e in trace.events if e.type == "rail-collision" and e.part == "top"]
    assert 1 < len(hops) - 1 < len(bounces) + len(tops)


def test_a_ball_that_leaves_the_table_is_marked_at_that_place() -> None:
    trace = of_gallery("off_the_table")
    marks = picture.draw(trace).axes[0].lines
    crosses = [line for line in marks if line.get_marker() == "X"]
    x, y, _ = trace.events[-1].before[0]["position"]
    assert (x, y) in [(line.get_xdata()[0], line.get_ydata()[0]) for line in crosses]


def test_the_ground_under_a_point_is_bed_hole_rail_or_floor() -> None:
    geometry = next(table for table in carom.tables() if table["name"] == "wpa-9ft")
    under = Ground(geometry).under
    assert under((0.6, 1.0)) == "bed"
    assert under((-0.02, 0.6)) == "rail"
    assert under((-0.12, 0.6)) == "rail"
    assert under((-0.16, 0.6)) == "floor"
    assert under(tuple(geometry["pockets"][0]["center"])) == "hole"
    # In the mouth of a corner pocket, behind both nose lines.
    assert under((0.012, 0.012)) in {"bed", "hole"}
    assert under((-0.002, 0.03)) == "bed"


def test_the_same_trace_gives_the_same_picture(pot: dict[str, Any]) -> None:
    trace = Shot.from_dict(pot).simulate()
    assert picture.svg(trace) == picture.svg(trace)
    assert picture.png(trace) == picture.png(trace)


@pytest.mark.parametrize("geometry", carom.tables(), ids=lambda table: table["name"])
def test_every_table_can_be_drawn(geometry: dict[str, Any], pot: dict[str, Any]) -> None:
    pot["table"] = geometry["name"]
    del pot["physics"]
    width, length = geometry["size"]
    pot["balls"][0]["position"] = [width / 2, length / 4]
    pot["balls"][1]["position"] = [width / 2, 3 * length / 4]
    figure = picture.draw(Shot.from_dict(pot).simulate())
    holes = [p for p in figure.axes[0].patches if p.get_gid() == "hole"]
    assert len(holes) == len(geometry["pockets"])


@pytest.mark.parametrize(
    "table", [{"cloth": "unbounded"}, {"length": 2.0, "width": 1.5, "pockets": "none"}], ids=str
)
def test_tables_without_pockets_can_be_drawn(
    table: dict[str, Any], endless: dict[str, Any]
) -> None:
    endless["table"] = table
    endless["balls"][0]["position"] = [0.2, 0.5]
    endless["balls"][1]["position"] = [0.7, 0.51]
    text = picture.svg(Shot.from_dict(endless).simulate())
    assert "path-a" in text
    assert "ball-b" in text


def test_one_ball_that_never_moves_can_be_drawn(endless: dict[str, Any]) -> None:
    del endless["balls"][0]
    assert "ball-b" in picture.svg(Shot.from_dict(endless).simulate())


def test_ids_with_markup_do_not_break_a_picture(endless: dict[str, Any]) -> None:
    endless["balls"][0]["id"] = '<b>$x_1$ & "co"'
    endless["balls"][1]["id"] = "[red]$"
    trace = Shot.from_dict(endless).simulate()
    ElementTree.fromstring(picture.svg(trace))


# A computer may lack a font for one of them.
@pytest.mark.filterwarnings("ignore:no installed font:carom.picture.fonts.FontWarning")
@pytest.mark.parametrize("name", ["$$", r"$\frac$", "\x1b[31m", "\x00", "8\n", "\N{BILLIARDS}"])
def test_a_ball_and_a_picture_may_have_any_name(endless: dict[str, Any], name: str) -> None:
    endless["balls"][0]["id"] = name
    trace = Shot.from_dict(endless).simulate()
    ElementTree.fromstring(picture.svg(trace, title=name))
    assert picture.png(trace, title=name).startswith(b"\x89PNG")


def test_an_answer_about_a_ball_with_any_name_can_be_drawn(
    pot: dict[str, Any], tmp_path: Path
) -> None:
    pot["balls"][1]["id"] = "$$"
    shot = Shot.from_dict(pot)
    for found in (
        shot.evaluate(carom.Noise(), 8),
        shot.solve(pot="$$", samples=256, n=8),
        carom.bank_table(shot, "$$", azimuth=[1.0]),
    ):
        picture.save(found, tmp_path / "a.svg", title="$\\foo$")
        ElementTree.parse(tmp_path / "a.svg")


def test_pool_balls_have_their_usual_colours() -> None:
    assert look("9", 0).striped
    assert not look("8", 0).striped
    assert look("9", 0).body == look("1", 0).body
    assert look("red-4", 0).body == look("red", 5).body == look("red4", 1).body
    assert look("other", 0) != look("other", 1)


def test_arguments_of_a_wrong_type_are_refused_by_name(pot: dict[str, Any], tmp_path: Path) -> None:
    shot = Shot.from_dict(pot)
    trace = shot.simulate()
    wrong: Any = 5
    asks: list[tuple[str, Callable[[], object]]] = [
        ("trace", lambda: picture.draw(wrong)),
        ("trace", lambda: picture.svg(wrong)),
        ("title", lambda: picture.draw(trace, title=wrong)),
        ("geometry", lambda: picture.draw_table(wrong)),
        ("geometry", lambda: picture.draw_table({})),
        ("path", lambda: picture.save(trace, wrong)),
        ("path", lambda: picture.save(trace, tmp_path / "a.gif")),
        ("found", lambda: picture.save(wrong, tmp_path / "a.svg")),
        ("found", lambda: picture.save([wrong], tmp_path / "a.svg")),
        ("found", lambda: picture.save([], tmp_path / "a.svg")),
        ("evaluation", lambda: evaluation.draw(wrong)),
        ("shot", lambda: solutions.draw(wrong, [])),
        ("solutions", lambda: solutions.draw(shot, [wrong])),
        ("leave", lambda: solutions.draw(shot, [], leave=wrong)),
        ("leave", lambda: solutions.draw(shot, [], leave=((0.1,), 0.2))),
    ]
    for name, ask in asks:
        with pytest.raises(carom.InputError, match=rf"^{name}: .*; "):
            ask()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("dots", [0, -1, 10**9, 1.5, "many"])
def test_a_resolution_out_of_range_is_refused(pot: dict[str, Any], dots: Any) -> None:
    with pytest.raises(carom.InputError, match=r"^dots_per_inch: .*from 1 to 1200"):
        picture.png(Shot.from_dict(pot).simulate(), dots_per_inch=dots)


def test_drawing_does_not_change_the_trace(pot: dict[str, Any]) -> None:
    trace = Shot.from_dict(pot).simulate()
    before = copy.deepcopy(trace.to_dict())
    picture.svg(trace)
    assert trace.to_dict() == before


def test_the_cue_is_drawn_only_if_there_is_a_strike(
    pot: dict[str, Any], endless: dict[str, Any]
) -> None:
    assert 'id="cue"' in picture.svg(Shot.from_dict(pot).simulate())
    assert 'id="cue"' not in picture.svg(Shot.from_dict(endless).simulate())


# What a user's matplotlibrc may have, without LaTeX, which would hide the others.
SETTINGS: dict[str, Any] = {
    "savefig.bbox": "tight",
    "savefig.transparent": True,
    "savefig.facecolor": "red",
    "path.sketch": (3.0, 100.0, 2.0),
    "path.simplify": False,
    "lines.antialiased": False,
    "lines.solid_capstyle": "butt",
    "patch.force_edgecolor": True,
    "axes.grid": True,
    "axes.unicode_minus": False,
    "figure.constrained_layout.use": True,
    "font.family": ["monospace"],
    "image.interpolation": "nearest",
    "image.cmap": "gray",
    "svg.fonttype": "none",
    "text.hinting": "none",
}


def pictures(nine_ball: Shot) -> Iterator[bytes | str]:
    """A picture of every kind."""
    club = carom.Noise.preset("club")
    cut = Shot("wpa-9ft", {"cue": (0.5, 1.2), "9": (0.9, 1.9)}, carom.Strike(2.0, 1.05))
    yield picture.png(nine_ball.simulate())
    yield picture.svg(nine_ball.simulate())
    yield evaluation.png(cut.evaluate(club, 100))
    yield solutions.svg(cut, cut.solve(pot="9", n=200))
    yield plays.png(carom.Player("carom:50").explain(cut, game="nine-ball"))
    yield maps.png(cut.acceptance("left", speed=[1.0, 2.0]))
    yield maps.png(cut.pot_map("9", "top-right", columns=4, n=10))
    environment = gymnasium.make("carom/Potting-v3", render_mode="rgb_array")
    environment.reset(seed=0)
    pixels: Any = environment.render()
    yield pixels.tobytes()


@pytest.mark.parametrize("settings", [{"text.usetex": True}, SETTINGS])
def test_a_users_matplotlibrc_changes_no_picture(
    settings: dict[str, Any], nine_ball: Shot, as_by_default: list[bytes | str]
) -> None:
    with matplotlib.rc_context(settings):
        assert list(pictures(nine_ball)) == as_by_default
        kept = {key: matplotlib.rcParams[key] for key in settings}
    assert kept == settings, "the user's own settings stay"


# Seen: MPLBACKEND=nonsense made every picture a bug of carom.
@pytest.mark.parametrize(("named", "kept"), [("nonsense", False), ("svg", True)])
def test_pictures_need_no_valid_backend_and_keep_a_valid_one(named: str, kept: bool) -> None:
    code = (
        "import carom.picture, matplotlib, os\n"
        "print(matplotlib.get_backend() == os.environ['MPLBACKEND'])"
    )
    env = {**os.environ, "MPLBACKEND": named}
    done = subprocess.run(
        [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == str(kept)


@pytest.fixture(scope="module")
def as_by_default(nine_ball: Shot) -> list[bytes | str]:
    """The pictures with Matplotlib's defaults."""
    return list(pictures(nine_ball))
