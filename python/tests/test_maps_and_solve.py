"""Maps and solutions agree with single shots."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import pytest
from carom import InputError, Noise, Shot
from carom.picture import maps as picture
from carom.picture import save, solutions

if TYPE_CHECKING:
    from conftest import CommandLine

FILE = Path(__file__).parents[2] / "shots" / "side_pocket_cut.json"
CLUB = Noise.preset("club")


@pytest.fixture(scope="module")
def cut() -> Shot:
    return Shot.load(FILE)


def test_solutions_pot_and_leave_the_cue_ball_in_the_disc(cut: Shot) -> None:
    found = cut.solve(pot=("1", "right"), leave=((0.9, 1.8), 0.25), noise=CLUB, n=200)
    assert found
    for solution in found:
        trace = solution.shot.simulate()
        assert ["1", "right"] in trace.outcome.pocketed
        end = trace.at(trace.duration).position[0]
        assert np.hypot(end[0] - 0.9, end[1] - 1.8) <= 0.25 + 1e-6
        assert np.allclose(end[:2], solution.cue_ball_end, rtol=0, atol=1e-6)
    chances = [solution.chance.count for solution in found]
    assert chances == sorted(chances, reverse=True)


def test_the_chance_of_a_solution_is_that_of_an_evaluation(cut: Shot) -> None:
    best = cut.solve(pot=("1", "right"), noise=CLUB, n=1000, wanted=1)[0]
    measured = best.shot.evaluate(CLUB, 1000).pocket("1", "right")
    # `solve` does not count a pot with a scratch.
    assert 0 <= measured.count - best.chance.count <= 20
    assert (best.shot.azimuth, best.shot.elevation) == (best.azimuth, best.elevation)
    assert best.kind == "direct"
    assert "direct" in str(best)


def test_every_solution_hits_the_given_ball_first(cut: Shot) -> None:
    found = cut.solve(first="1", noise=CLUB, n=100, wanted=3)
    assert all(s.shot.simulate().outcome.first_contact == "1" for s in found)
    assert len(found) == 3


def test_a_raised_cue_jumps_over_blocking_balls_or_curves_around_them() -> None:
    balls = {"cue": (0.5, 0.5), "1": (0.5, 1.2), "8": (0.5, 0.8)}
    # A jump cue: light, with a phenolic tip (TP A.30).
    cue = {"mass": 0.25, "tip_restitution": 0.87}
    physics = {"base": "pool", "cue": cue, "contact_times": {"tip": 8e-4}}
    strike = carom.Strike(speed=2.0, azimuth=math.pi / 2)
    hidden = Shot("wpa-9ft", balls, strike, physics=physics)
    ask = {"first": "1", "noise": CLUB, "n": 100, "wanted": 40, "per_route": 1, "samples": 512}
    assert all("kick" in s.kind for s in hidden.solve(**ask))
    ways = {s.route: s for s in hidden.solve(**ask, elevation=math.radians(70))}
    jump, curve = ways["over 8, 1"], ways["around 8, 1"]
    assert (jump.kind, curve.kind) == ("jump", "massé")
    assert ["cue", "8"] in jump.shot.simulate().outcome.jumped
    first = next(e for e in curve.shot.simulate().events if e.type == "ball-collision")
    assert first.balls == ["cue", "1"]
    assert 0 < jump.elevation <= math.radians(70)
    text = solutions.svg(hidden, [jump, curve])
    assert 'id="flight-1-cue"' in text


def test_chances_are_counted_until_they_are_precise(cut: Shot) -> None:
    found = cut.solve(pot=("1", "right"), noise=CLUB, n=3000, precision=0.04, samples=256)
    assert all(s.chance.half_width <= 0.04 for s in found)
    assert len({s.chance.trials for s in found}) > 1
    pots = carom.pot_map(cut, "1", "right", noise=CLUB, columns=3, n=3000, precision=0.04)
    known = pots.n > 0
    assert ((pots.high - pots.low)[known] <= 0.08).all()
    assert np.isnan(pots.low[~known]).all()
    assert 128 <= pots.n[known].min() < pots.n[known].max() < 3000
    breaks = carom.break_statistics("nine-ball", 10_000, noise=CLUB, precision=0.032)
    assert breaks.half_width <= 0.032
    assert breaks.racks == len(breaks.potted) == 1024
    again = carom.break_statistics("nine-ball", 1024, noise=CLUB)
    assert again.to_dict() == breaks.to_dict()


def test_solutions_and_maps_take_errors_of_perception_into_account(cut: Shot) -> None:
    sight = carom.Perception(0.004)
    ask = {"pot": ("1", "right"), "noise": CLUB, "n": 300, "wanted": 1, "samples": 256}
    clear, blurred = (cut.solve(**ask, perception=p)[0].chance for p in (None, sight))
    assert clear.count > blurred.count
    maps = [
        carom.pot_map(cut, "1", "right", noise=CLUB, perception=p, columns=4, n=60)
        for p in (None, sight)
    ]
    assert np.nanmean(maps[0].chance) > np.nanmean(maps[1].chance)


def test_the_picture_of_solutions_shows_each_route_with_its_chance(
    cut: Shot, tmp_path: Path
) -> None:
    area = ((0.9, 1.8), 0.25)
    found = cut.solve(pot=("1", "right"), leave=area, noise=CLUB, n=100, samples=256)
    text = solutions.svg(cut, found, leave=area)
    assert 'id="leave"' in text
    for index in range(1, min(len(found), solutions.SHOWN) + 1):
        assert f'id="way-{index}-cue"' in text
        assert f'id="chance-{index}"' in text
    assert f'id="way-{solutions.SHOWN + 1}-cue"' not in text
    assert text == solutions.svg(cut, found, leave=area)
    assert "way-1" not in solutions.svg(cut, [])
    save(found, tmp_path / "ways.svg", leave=area)
    assert (tmp_path / "ways.svg").read_text() == solutions.svg(cut, found, leave=area)


def test_every_answer_can_be_saved_as_a_picture(cut: Shot, tmp_path: Path) -> None:
    for found in (
        cut.simulate(),
        cut.evaluate(CLUB, 50),
        carom.kick_table(cut, azimuth=[1.0]),
        carom.acceptance(cut, "left", speed=[1.0], angle=[0.0, 0.1]),
    ):
        save(found, tmp_path / "found.png")
        assert (tmp_path / "found.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(InputError, match=r"^path: "):
        save(cut.simulate(), tmp_path / "found.gif")
    with pytest.raises(InputError, match=r"^found: "):
        save([], tmp_path / "found.png")


def test_maps_have_the_documented_shapes(cut: Shot) -> None:
    pots = carom.pot_map(cut, "1", "right", noise=CLUB, columns=4, n=20)
    assert pots.chance.shape == pots.azimuth.shape == (len(pots.y), len(pots.x)) == (8, 4)
    ends = carom.position_map(cut, "1", "right", speed=[1.0, 2.0], height=[-0.3, 0.0, 0.3])
    assert ends.falls.shape == (2, 3)
    assert ends.end.shape == (2, 3, 2)
    taken = carom.acceptance(cut, "left", speed=[1.0], angle=[0.0, 0.5])
    assert taken.accepted.shape == (1, 2, 161)
    assert taken.width[0, 0] > taken.width[0, 1] > 0


def test_a_pot_map_agrees_with_evaluations(cut: Shot) -> None:
    pots = carom.pot_map(cut, "1", "right", noise=CLUB, columns=4, n=200)
    row, column = np.unravel_index(np.nanargmax(pots.chance), pots.chance.shape)
    file = cut.to_dict()
    file["balls"][0]["position"] = [pots.x[column], pots.y[row]]
    file["strike"]["azimuth_deg"] = np.degrees(pots.azimuth[row, column])
    found = Shot.from_dict(file).evaluate(CLUB, 200)
    potted = found.pocket("1", "right").probability
    assert abs(potted - found.scratch.probability - pots.chance[row, column]) < 0.03


def test_breaks_count_every_ball_by_its_id() -> None:
    found = carom.break_statistics("nine-ball", 60, noise=Noise(), seed=3)
    for index in (0, 7, 59):
        trace = carom.break_shot("nine-ball", seed=3 + index).simulate()
        fell = {ball for ball, _ in trace.outcome.pocketed}
        ours = {b for b, p in zip(found.ids, found.result.pocket[index], strict=True) if p >= 0}
        assert ours == fell
    chances = found.chances()
    assert chances["a ball falls"].count == (found.potted > 0).sum()
    assert "9 falls" in str(found)


def test_kick_and_bank_tables_agree_with_traces(cut: Shot) -> None:
    turns = np.radians([60.0, 100.0, 250.0])
    kicks = carom.kick_table(cut, azimuth=turns, speed=[6.0], side=[0.0, 0.4])
    assert kicks.contact.shape == (3, 1, 2, 3, 2)
    file = cut.to_dict()
    file["balls"] = file["balls"][:1]
    file["strike"] |= {"azimuth_deg": 60.0, "speed": 6.0, "side": 0.4, "height": 0.0}
    events = Shot.from_dict(file).simulate().events
    met = [e for e in events if e.type == "rail-collision"][:3]
    # The table ends at the first jaw, so the comparison needs three noses.
    assert [e.part for e in met] == ["nose"] * 3
    assert kicks.rail[0, 0, 1].tolist() == [e.rail for e in met]
    assert kicks.contact[0, 0, 1].tolist() == [e.before[0]["position"][:2] for e in met]
    # Side changes the angle off the cushion.
    assert np.isfinite(kicks.contact[0, 0, :, 1]).all()
    assert not np.allclose(kicks.contact[0, 0, 0, 1], kicks.contact[0, 0, 1, 1], atol=0.01)
    banks = carom.bank_table(cut, "1", azimuth=turns, speed=[1.0, 4.0], cushions=2)
    assert banks.contact.shape == (3, 2, 1, 2, 2)
    assert (banks.rail[:, 1, 0, 0] != "").all()


@pytest.mark.parametrize(
    ("ask", "place"),
    [
        (lambda shot: shot.solve(), "goal: "),
        (lambda shot: shot.solve(pot="7"), "ball: "),
        (lambda shot: shot.solve(pot=("1", "cellar")), "pocket: "),
        (lambda shot: shot.solve(pot="1", leave=3), "leave: "),
        (lambda shot: shot.solve(pot="1", speed=(3.0, 1.0)), "speed: "),
        (lambda shot: shot.solve(pot="1", noise=1), "noise: "),
        (lambda shot: shot.solve(pot="1", elevation="high"), "elevation: "),
        (lambda shot: shot.solve(pot="1", elevation=2.0), "elevation: "),
        (lambda shot: shot.solve(pot="1", perception=1), "perception: "),
        (lambda shot: shot.solve(pot="1", precision=0.5), "precision: "),
        (lambda shot: carom.pot_map(shot, "1", "right", precision="fine"), "precision: "),
        (lambda shot: carom.pot_map(shot, "1", "right", level=2), "level: "),
        (lambda _: carom.break_statistics(precision=0), "precision: "),
        (lambda shot: shot.solve(pot="cue"), "goal: "),
        (lambda shot: carom.pot_map(shot, "1", "right", columns=0), "columns: "),
        (lambda shot: carom.pot_map(shot, "7", "right"), "ball: "),
        (lambda shot: carom.position_map(shot, "1", "right", speed="fast"), "speed: "),
        (lambda shot: carom.acceptance(shot, "cellar"), "pocket: "),
        (lambda shot: carom.acceptance(shot, "left", distance=0), "distance: "),
        (lambda shot: carom.bank_table(shot, "7"), "ball: "),
        (lambda shot: carom.kick_table(shot, cushions=99), "cushions: "),
        (lambda _: carom.break_statistics("croquet"), "game: "),
        (lambda _: carom.break_statistics("nine-ball", 0), "racks: "),
    ],
)
def test_bad_arguments_are_refused_by_name(cut: Shot, ask: Any, place: str) -> None:
    with pytest.raises(InputError, match=f"^{place}"):
        ask(cut)


def test_the_commands_print_numbers_and_draw(run: CommandLine, tmp_path: Path) -> None:
    drawn = tmp_path / "map.svg"
    ball = ("--ball", "1", "--pocket", "right")
    for words, key, part in (
        (("map", "pot", str(FILE), *ball, "--columns", "4", "-n", "10"), "chance", "chance"),
        (("map", "position", str(FILE), *ball, "--speed", "1:2:3"), "end", "spin-0"),
        (("map", "acceptance", str(FILE), "--pocket", "left"), "width", "speed-0"),
        (("map", "kick", str(FILE), "--azimuth-deg", "0:90:3"), "contact", "way-0-0-0"),
        (("map", "bank", str(FILE), "--ball", "1"), "rail", "way-0-0-0"),
        (("stats", "break", "-n", "20"), "chances", "axes_1"),
    ):
        done = run(*words, "--json", "--svg", str(drawn))
        assert done.returncode == 0, done.stderr
        assert key in json.loads(done.stdout)
        assert f'id="{part}"' in drawn.read_text()
        plain = run(*words)
        assert plain.returncode == 0
        assert len(plain.stdout.splitlines()) > 1
    ask = ("solve", str(FILE), "--pot", "1:right", "-n", "50", "--wanted", "2", "--speed", "1:3")
    done = run(*ask, "--json", "--svg", str(drawn))
    found = json.loads(done.stdout)
    assert len(found) == 2
    assert all(1 <= solution["strike"]["speed"] <= 3 for solution in found)
    assert 'id="way-2-cue"' in drawn.read_text()
    best = tmp_path / "best.json"
    assert run(*ask, "--best", str(best)).returncode == 0
    assert Shot.load(best).to_dict()["strike"] == found[0]["strike"]
    raised = run("solve", str(FILE), "--pot", "1:right", "-n", "50", "--elevation-deg", "95")
    assert raised.returncode == 2
    assert raised.stderr.startswith("carom: elevation: ")
    refused = run("solve", str(FILE), "--leave", "1,2")
    assert refused.returncode == 2
    assert refused.stderr.startswith("carom: --leave: ")


def test_old_spellings_on_the_command_line_work_and_name_the_new_ones(run: CommandLine) -> None:
    for old, new, line in (
        (
            ("map", "pocket", str(FILE), "--pocket", "left"),
            ("map", "acceptance", str(FILE), "--pocket", "left"),
            "carom: carom map pocket is now carom map acceptance; the old spelling still works",
        ),
        (
            ("map", "kick", str(FILE), "--azimuth=0:90:3"),
            ("map", "kick", str(FILE), "--azimuth-deg=0:90:3"),
            "carom: --azimuth is now --azimuth-deg; the old spelling still works",
        ),
        (
            ("map", "bank", str(FILE), "--ball", "1", "--azimuth", "0:90:3"),
            ("map", "bank", str(FILE), "--ball", "1", "--azimuth-deg", "0:90:3"),
            "carom: --azimuth is now --azimuth-deg; the old spelling still works",
        ),
    ):
        before, after = run(*old), run(*new)
        assert before.stdout == after.stdout
        assert (before.returncode, after.returncode) == (0, 0)
        assert before.stderr.splitlines() == [line]
        assert after.stderr == ""
    ask = ("solve", str(FILE), "--pot", "1:right", "-n", "20", "--samples", "64")
    old_flags = run(*ask, "--of-a-way", "1", "--elevation", "5")
    assert len(old_flags.stderr.splitlines()) == 2
    assert old_flags.stdout == run(*ask, "--per-route", "1", "--elevation-deg", "5").stdout


def test_angles_in_json_are_given_in_the_unit_of_their_names(run: CommandLine) -> None:
    kick = json.loads(run("map", "kick", str(FILE), "--azimuth-deg", "0:90:3", "--json").stdout)
    assert kick["azimuth_deg"] == pytest.approx([0.0, 45.0, 90.0])
    assert kick["azimuth"] == pytest.approx([0.0, math.pi / 4, math.pi / 2])
    taken = json.loads(run("map", "acceptance", str(FILE), "--pocket", "left", "--json").stdout)
    assert np.degrees(taken["angle"]) == pytest.approx(taken["angle_deg"])


def test_the_old_names_of_a_route_warn_and_give_the_new_ones(cut: Shot) -> None:
    ask: dict[str, Any] = {"pot": "1", "noise": CLUB, "n": 20, "samples": 64}
    with pytest.warns(FutureWarning, match=r"solve\(per_route=\.\.\.\)"):
        (found, *_) = cut.solve(**ask, of_a_way=1)
    with pytest.warns(FutureWarning, match=r"Solution\.way is now Solution\.route"):
        assert found.way == found.route
    assert found.to_dict()["way"] == found.to_dict()["route"] == found.route


def test_printed_maps_have_the_orientation_of_the_table(cut: Shot) -> None:
    pots = carom.pot_map(cut, "1", "right", noise=CLUB, columns=4, n=20)
    _, *rows, places = str(pots).splitlines()
    assert [int(x) for x in places.split()] == [round(100 * x) for x in pots.x]
    assert [int(row.split()[0]) for row in rows] == [round(100 * y) for y in pots.y[::-1]]
    highest = [float("nan") if cell == "-" else int(cell) / 100 for cell in rows[0].split()[1:]]
    np.testing.assert_allclose(highest, pots.chance[-1], atol=0.0051)

    ends = carom.position_map(cut, "1", "right", speed=[1.0, 2.0], height=[-0.3, 0.3])
    _, *rows = str(ends).splitlines()
    assert [row.split()[:3] for row in rows[:2]] == [
        ["1.00", "+0.00", "-0.30"],
        ["2.00", "+0.00", "-0.30"],
    ]
    last = rows[-1].split()
    assert last[4] == ("yes" if ends.falls[-1, -1] else "no")
    assert [float(x) for x in last[5:]] == pytest.approx(ends.end[-1, -1], abs=6e-4)

    taken = carom.acceptance(cut, "left", speed=[1.0], angle=np.radians([-10.0, 0.0]))
    widths = [float(row.split()[1]) for row in str(taken).splitlines()[2:]]
    assert widths == pytest.approx(1e3 * taken.width[0], abs=0.6)


def test_pictures_are_the_same_each_time(cut: Shot) -> None:
    found = carom.position_map(cut, "1", "right", speed=[1.0, 2.0])
    assert picture.svg(found) == picture.svg(found)
