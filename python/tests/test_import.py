"""Systems of pooltool and table states of FastFiz are converted to the same shots."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import pytest
from carom import convert
from carom.convert._msgpack import unpack

if TYPE_CHECKING:
    from conftest import CommandLine

DATA = Path(__file__).parent / "data" / "pooltool"

# Tolerance of the cue ball's final position against pooltool's, m. pooltool evaluates the friction
# between balls at another speed, which makes 1.1 mm after one collision and half a metre.
SAME_STOP = 2e-3
# Rounding of the trigonometry, ball radii.
ROUNDING = 1e-12

# Five balls: the cue ball, one at rest, one in the left pocket, one rolling, one not in play.
STATE = (
    "5 0.028575 1 0 0.4 0.6 0.028575 1 8 0.8 1.7 0.028575 6 3 0 0 "
    "0.028575 4 9 0.3 1.2 0.028575 0 15 0 0 "
)


def pot() -> dict[str, Any]:
    return json.loads((DATA / "pot.json").read_text())


def said(made: convert.Converted, words: str) -> bool:
    return any(words in sentence for sentence in made.left_out)


def test_a_pot_of_pooltool_is_a_pot_here_and_the_cue_ball_stops_at_the_same_place() -> None:
    theirs = unpack((DATA / "pot_simulated.msgpack").read_bytes())["balls"]
    trace = convert.pooltool(DATA / "pot.json").shot.simulate()
    assert trace.outcome["pocketed"] == [["1", "top-right"]]
    assert theirs["1"]["state"]["s"] == 4
    stop = trace.at(trace.duration).position[0]
    assert np.linalg.norm(stop - theirs["cue"]["state"]["rvw"][0]) < SAME_STOP


def test_json_messagepack_dict_and_a_simulated_system_are_the_same_shot() -> None:
    shots = [
        convert.pooltool(DATA / "pot.json").shot,
        convert.pooltool((DATA / "pot.json").read_bytes()).shot,
        convert.pooltool(pot()).shot,
        convert.pooltool(DATA / "pot_simulated.msgpack").shot,
    ]
    assert all(shot == shots[0] for shot in shots)
    assert said(convert.pooltool(DATA / "pot_simulated.msgpack"), "from its start")


def test_the_strike_has_the_parameters_of_the_cue() -> None:
    strike = convert.pooltool(pot()).shot.to_dict()["strike"]
    assert strike["ball"] == "cue"
    assert strike["speed"] == 2.2
    assert strike["elevation_deg"] == 4.0
    # a = +1 is left, side = +1 right.
    assert (strike["side"], strike["height"]) == (-0.1, -0.15)
    assert strike["azimuth_deg"] == pot()["cue"]["phi"]


def test_a_preset_table_is_written_by_name_and_another_by_its_dimensions() -> None:
    assert convert.pooltool(pot()).shot.to_dict()["table"] == "showood-7ft"
    assert convert.pooltool(DATA / "three_cushion.json").shot.to_dict()["table"] == "carom-10ft"
    made = convert.pooltool(DATA / "snooker.json")
    table = made.shot.to_dict()["table"]
    assert (table["length"], table["width"]) == (3.5445, 1.7465)
    assert table["corner_pocket"]["mouth"] == 0.083
    assert table["side_pocket"]["mouth"] == 0.075
    assert said(made, "widened")
    assert len(made.shot.ids) == 22


def test_moving_balls_keep_their_motion_and_the_shot_has_no_strike() -> None:
    system = pot()
    system["balls"]["2"]["state"] = {
        "rvw": [[0.2, 1.7, 0.028575], [0.5, 0.0, 0.0], [0.0, 17.5, 3.0]],
        "s": 3,
        "t": 0.0,
    }
    made = convert.pooltool(system)
    file = made.shot.to_dict()
    assert file["balls"][2]["velocity"] == [0.5, 0.0, 0.0]
    assert file["balls"][2]["angular_velocity"] == [0.0, 17.5, 3.0]
    assert "strike" not in file
    assert said(made, "would not strike")


def test_everything_that_is_lost_is_reported() -> None:
    system = pot()
    system["balls"]["1"]["state"]["s"] = 4
    system["balls"]["2"]["params"]["u_s"] = 0.3
    system["table"]["pockets"]["rt"]["radius"] = 0.07
    made = convert.pooltool(system)
    assert made.shot.ids == ["cue", "2"]
    assert said(made, "left out: 1.")
    assert said(made, "those of 2 differed")
    assert said(made, "not symmetric")


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (["balls", "1", "params", "R"], "wide", ["balls.1.params.R", "'wide'"]),
        (["balls", "cue", "state", "rvw"], [[0.1, 0.2]], ["balls.cue.state.rvw"]),
        (["cue", "cue_ball_id"], "white", ["cue", '"white"']),
        (["cue", "V0"], math.inf, ["cue.V0", "finite"]),
        (["table", "table_type"], "bar", ["table.table_type", "snooker"]),
        (["table", "pockets", "lb"], None, ["table.pockets", '"lb"']),
        (["balls"], [], ["balls", "not an object"]),
    ],
)
def test_a_bad_system_is_refused_with_the_place(
    path: list[str], value: Any, words: list[str]
) -> None:
    system = pot()
    inner = system
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    with pytest.raises(carom.InputError) as refused:
        convert.pooltool(system)
    for word in words:
        assert word in str(refused.value)


@pytest.mark.parametrize("data", [b"\xc1", b"\x82\xa1a", b"{", b"[1, 2]", b""])
def test_data_that_is_not_a_system_is_refused(data: bytes) -> None:
    with pytest.raises(carom.InputError):
        convert.pooltool(data)


@pytest.mark.parametrize("source", [5, None, ["pot.json"], "pot\0.json"])
def test_a_source_that_is_not_a_path_is_refused(source: Any) -> None:
    with pytest.raises(carom.InputError, match=r"^source: .*; "):
        convert.pooltool(source)


def test_an_array_that_would_be_unpickled_is_refused() -> None:
    import msgpack

    evil = msgpack.packb({b"nd": True, b"type": "|O", b"kind": b"O", b"shape": [1], b"data": b""})
    with pytest.raises(carom.InputError, match="not of numbers"):
        unpack(evil)


def test_without_msgpack_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "msgpack", None)
    with pytest.raises(carom.InputError, match=r"carom\[import\]"):
        convert.pooltool(DATA / "pot_simulated.msgpack")


def test_a_table_state_gives_its_balls_in_play_on_the_table_poolfiz() -> None:
    made = convert.fastfiz(STATE)
    file = made.shot.to_dict()
    assert file["table"] == "poolfiz"
    assert [b["id"] for b in file["balls"]] == ["cue", "8", "9"]
    assert file["balls"][1]["position"] == [0.8, 1.7]
    assert said(made, "3 (left)")
    assert said(made, "at rest: 9")
    assert said(made, "not in play were left out: 15")
    assert said(made, "no strike")


@pytest.mark.parametrize("theta", [0.0, 12.0, 40.0])
def test_a_fastfiz_strike_gives_the_ball_the_velocity_of_its_formula(theta: float) -> None:
    """Leckie and Greenspan's strike, with a and b level and upright at the ball, is FastFiz's."""
    a, b, phi, v = 6.0, 9.0, 70.0, 2.0
    shot = convert.fastfiz(STATE, (a, b, theta, phi, v)).shot
    (strike,) = (e for e in shot.simulate().events if e["type"] == "cue-strike")
    radius, mass, cue_mass = 0.028575, 0.16301, 0.6
    a, b = 1e-3 * a, 1e-3 * b
    c = math.sqrt(radius**2 - a**2 - b**2)
    sin, cos = math.sin(math.radians(theta)), math.cos(math.radians(theta))
    lever = a**2 + (b * cos) ** 2 + (c * sin) ** 2 - 2 * b * c * cos * sin
    impulse = 2 * v / (1 + mass / cue_mass + 2.5 / radius**2 * lever)
    after = strike["after"][0]
    assert np.hypot(*after["velocity"][:2]) == pytest.approx(impulse * cos, abs=ROUNDING)
    spin = np.array([-c * sin + b * cos, -a * sin, a * cos]) * impulse * 2.5 / radius**2
    turn = math.radians(phi + 90.0)
    expected = [
        spin[0] * math.cos(turn) - spin[1] * math.sin(turn),
        spin[0] * math.sin(turn) + spin[1] * math.cos(turn),
        spin[2],
    ]
    assert after["angular_velocity"] == pytest.approx(expected, abs=1e3 * ROUNDING)


@pytest.mark.parametrize(
    ("state", "words"),
    [
        ("", "number of balls"),
        ("2 0.028575 1 0 0.4 0.6", "2 balls"),
        ("1e300 0.028575 1 0 0.4 0.6", "begins with 1e+300 balls"),
        ("1.2 0.028575 1 0 0.4 0.6 0", "begins with 1.2 balls"),
        ("1 0.028575 1 0 0.4 west", "west"),
        ("1 0.028575 11 0 0.4 0.6", "state 11"),
        ("1 0.028575 1 16 0.4 0.6", "type 16"),
        ("1 0.028575 5 1 0.4 0.6", "no ball in play"),
        ("1 0.028575 1 0 0.4 nan", "finite"),
        ("2 0.028575 1 0 0.4 0.6 0.028575 1 1 0.41 0.6", "balls[1]"),
    ],
)
def test_a_bad_table_state_is_refused(state: str, words: str) -> None:
    with pytest.raises(carom.InputError) as refused:
        convert.fastfiz(state)
    assert words in str(refused.value)


def log() -> str:
    """A log of a game: a break with the cue ball in hand, a decision, and a state of LogWriter."""
    radius, rack = "0.028575", " 0.028575 1 1 0.558 0.559 0.028575 1 8 0.50 0.50"
    before = f"3 {radius} 1 0 0.558 1.677{rack}"
    scratched = f"3 {radius} 6 0 0.0 1.118{rack}"
    strike, meant = "0.1 7.9 5.2 270.4 4.6", "0 8 5 270 4.5"
    rest = '0.25 3.1 2 0.5 0.5 0.1 0.125 0.075 "A" "B"'
    return "\n".join(
        [
            "GTYPE 1",
            f"STATE 1 4 600 600 1 {before} 1 1",
            f"SHOT {strike} {meant} 16 6 0 0.48 1.67705 {rest}",
            f"STATE 1 6 600 600 0 {before} 1 0",
            f"SHOT 0 0 0 0 0 0 0 0 0 0 16 6 1 0 0 {rest}",
            f"STATE 1 1 600 600 0 {scratched} 1 0",
            f"SHOT {strike} {meant} 1 0 0 0.3 1.0 {rest}",
            "COMMENT the rest is a test of its own",
            f"TSTATE {before}",
            f"TSHOT {meant}",
            f"TSTATE {before}",
        ]
    )


def test_a_log_of_a_game_gives_a_shot_for_each_state() -> None:
    shots = [made.shot.to_dict() for made in convert.fastfiz_log(log())]
    assert [shot.get("strike", {}).get("azimuth_deg") for shot in shots] == [
        pytest.approx(270.4),
        None,
        pytest.approx(270.4),
        pytest.approx(270.0),
        None,
    ]
    # The shot puts a cue ball in hand where its line says, also one that was pocketed.
    assert [shot["balls"][0]["id"] for shot in shots] == 5 * ["cue"]
    places = [tuple(shot["balls"][0]["position"]) for shot in shots]
    assert places == [(0.48, 1.67705), (0.558, 1.677), (0.3, 1.0), *2 * [(0.558, 1.677)]]
    made = convert.fastfiz(log(), index=2)
    assert made.shot.to_dict() == shots[2]
    assert said(made, "number 2")
    assert said(made, "executed one")
    assert said(convert.fastfiz(log(), index=1), "a decision in place of a shot")


@pytest.mark.parametrize(
    ("text", "index", "words"),
    [
        (log(), 9, "the log has 5 states"),
        (log().replace("COMMENT", "REMARK"), 0, "line 8: a line of a FastFiz log begins with"),
        (log().replace("0.48 1.67705", "0.48 north"), 0, "line 3: the shot: 'north'"),
        (log().replace("STATE 1 6", "STATE 1 six"), 0, "line 4: the type of the turn: 'six'"),
    ],
)
def test_a_bad_log_is_refused_with_its_line(text: str, index: int, words: str) -> None:
    with pytest.raises(carom.InputError) as refused:
        convert.fastfiz(text, index=index)
    assert words in str(refused.value)


def test_a_bad_state_of_a_log_is_refused_with_its_number() -> None:
    with pytest.raises(carom.InputError, match="state 3: strike"):
        convert.fastfiz_log(log().replace("TSHOT 0 8", "TSHOT 0 80"))
    with pytest.raises(carom.InputError, match="not a log"):
        convert.fastfiz_log(STATE)
    with pytest.raises(carom.InputError, match="leave it out"):
        convert.fastfiz(log(), (0, 0, 5, 68, 2))


def test_the_command_prints_every_state_of_a_log(run: CommandLine) -> None:
    done = run("import", "-", "--all", stdin=log())
    assert done.returncode == 0
    lines = done.stdout.splitlines()
    shots = [made.shot for made in convert.fastfiz_log(log())]
    assert [carom.Shot.from_json(line) for line in lines] == shots
    assert done.stderr.count("default table") == 1
    assert run("import", "-", "--all", "--index", "1", stdin=log()).returncode == 2


@pytest.mark.parametrize("strike", [(0, 0, 5, 68), (30, 0, 5, 68, 2), (0, 0, 5, math.nan, 2)])
def test_a_bad_fastfiz_strike_is_refused(strike: tuple[float, ...]) -> None:
    with pytest.raises(carom.InputError, match="strike"):
        convert.fastfiz(STATE, strike)


def test_the_command_prints_the_shot_file_and_what_is_lost_on_stderr(run: CommandLine) -> None:
    done = run("import", str(DATA / "pot.json"))
    assert done.returncode == 0
    assert carom.Shot.from_json(done.stdout) == convert.pooltool(DATA / "pot.json").shot
    assert len(done.stderr.splitlines()) == len(convert.pooltool(DATA / "pot.json").left_out)
    done = run("import", "-", "--strike", "0 0 5 68 3", stdin=STATE)
    assert done.returncode == 0
    assert json.loads(done.stdout)["strike"]["azimuth_deg"] == 68
    done = run("import", "-", "--format", "fastfiz", stdin="{}")
    assert done.returncode == 2
    assert done.stdout == ""
