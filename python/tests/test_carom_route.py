"""Routes of caroms, readings of diamond systems, and rulings that count balls and cushions."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING

import carom
import pytest
from carom.carom_route import _HITS

if TYPE_CHECKING:
    from conftest import CommandLine

ROOT = Path(__file__).parents[2]

LAYOUT = {"white": (0.4, 0.6), "yellow": (1.1, 0.5), "red": (0.9, 2.2)}


def shot(azimuth_deg: float, side: float = 0.3) -> carom.Shot:
    """A strike of the white on the match table."""
    strike = carom.Strike(speed=4.0, azimuth_deg=azimuth_deg, side=side, height=0.3, ball="white")
    return carom.Shot("carom-10ft", LAYOUT, strike)


def test_a_trace_tells_the_route_of_its_carom() -> None:
    route = shot(350.5).simulate().carom_route
    assert route is not None
    assert (route.pattern, route.first, route.second) == ("around-the-table", "yellow", "red")
    assert (route.cushions, route.cushions_first) == (["long", "short", "long"], 0)
    assert route.rails == ["right", "bottom", "left"]
    assert route.name == "around the table off yellow"
    assert str(route) == (
        "three-quarter ball off yellow, long, short, long, half ball on red, running side"
    )
    assert str(route.system) == "corner five: 3.2 − 0.1 = 3.1, arrives at 3.1"


def test_cushions_before_the_first_ball_come_before_it() -> None:
    route = shot(319.0, -0.3).simulate().carom_route
    assert route is not None
    assert (route.pattern, route.cushions_first) == ("umbrella", 2)
    assert str(route).startswith("short, long, half ball off yellow, ")


def test_a_shot_that_meets_one_ball_has_no_route() -> None:
    assert shot(90.0).simulate().carom_route is None


def test_a_reading_is_the_sum_of_its_system() -> None:
    trace = shot(350.5).simulate()
    contact = next(i for i, event in enumerate(trace.events) if event.type == "ball-collision")
    reading = trace.diamond_reading("white", contact)
    assert reading is not None
    assert reading.system == "corner-five"
    assert reading.predicted == pytest.approx(reading.from_ - reading.over)
    assert trace.diamond_reading(0, contact) == reading
    assert trace.diamond_reading("red") is None, "it rests until it is hit"


def test_python_and_the_page_name_hits_by_the_same_shares_of_the_ball() -> None:
    source = ROOT / "web/src/app/pot/pot-words.ts"
    table = source.read_text(encoding="utf-8").partition("const HITS = [")[2].partition("]\n")[0]
    assert [float(least) for least in re.findall(r"\[([\d.]+),", table)] == [x for x, _ in _HITS]


def test_unknown_balls_and_events_of_a_reading_are_refused() -> None:
    trace = shot(350.5).simulate()
    with pytest.raises(carom.InputError, match="there is no ball 'blue'"):
        trace.diamond_reading("blue")
    with pytest.raises(carom.InputError, match="event"):
        trace.diamond_reading("white", len(trace))


@pytest.mark.parametrize("game", ["three-cushion", "straight-rail", "four-ball"])
def test_an_analysis_has_one_play_for_each_pattern(game: str) -> None:
    frame = carom.Frame(game)
    analysis = carom.Player(simulations=4000, seed=3).explain(frame, 6)
    routes = [play.route for play in analysis.plays if play.route is not None]
    assert routes
    found = [(route.pattern, route.first, route.cushions[:1]) for route in routes]
    assert all(one not in found[:k] for k, one in enumerate(found))
    for play in analysis.plays:
        assert (play.route is not None) == (play.kind == "carom")
        assert play.route is None or play.aim == f"{play.route.name}: {play.route}"


def test_rulings_of_carom_count_balls_and_cushions() -> None:
    frame = carom.Frame("three-cushion")
    count = frame.play(carom.Strike(speed=0.3, azimuth=1.57)).carom
    assert count is not None
    assert (count.balls, count.cushions, count.needed, count.stayed) == (0, 0, 3, False)
    assert carom.Frame("nine-ball").play(carom.Strike(2.0, 1.57)).carom is None


def test_think_prints_and_writes_routes(run: CommandLine, tmp_path: Path) -> None:
    file = tmp_path / "shot.json"
    cue = {"cue": LAYOUT["white"], "yellow": LAYOUT["yellow"], "red": LAYOUT["red"]}
    file.write_text(carom.Shot("carom-10ft", cue).to_json(), encoding="utf-8")
    arguments = ["think", str(file), "--game", "three-cushion", "--simulations", "4000"]
    printed = run(*arguments).stdout
    assert " off yellow, " in printed
    assert " on red, " in printed
    plays = json.loads(run(*arguments, "--json").stdout)["plays"]
    assert plays[0]["route"]["cushions"].count("long") >= 1
