"""The command line: data to stdout, messages to stderr, exit 0, 2 (bad input), 1 (our bug)."""

from __future__ import annotations

import json
import os
import pty
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import carom
import pytest

if TYPE_CHECKING:
    from conftest import CommandLine


@pytest.fixture
def file(pot: dict[str, Any], tmp_path: Path) -> Path:
    path = tmp_path / "pot.json"
    path.write_text(json.dumps(pot))
    return path


def refused(done: subprocess.CompletedProcess[str], *words: str) -> None:
    """Exit code 2, nothing on stdout, one sentence on stderr."""
    assert done.returncode == 2
    assert done.stdout == ""
    assert len(done.stderr.strip().splitlines()) == 1
    assert "Traceback" not in done.stderr
    for word in words:
        assert word in done.stderr


def test_shot_json_prints_the_trace(run: CommandLine, file: Path, pot: dict[str, Any]) -> None:
    done = run("shot", str(file), "--json")
    assert done.returncode == 0
    assert done.stderr == ""
    assert json.loads(done.stdout) == carom.Shot.from_dict(pot).simulate().to_dict()


def test_a_shot_is_read_from_stdin(run: CommandLine, pot: dict[str, Any]) -> None:
    done = run("shot", "-", "--json", stdin=json.dumps(pot))
    assert done.returncode == 0
    assert json.loads(done.stdout)["format"] == "carom-trace/1"


def test_shot_prints_a_readable_table_of_events(run: CommandLine, file: Path) -> None:
    done = run("shot", str(file))
    assert done.returncode == 0
    assert "cue-strike" in done.stdout
    assert "first contact: 1" in done.stdout
    assert "pass through" not in done.stdout
    assert "\x1b" not in done.stdout


def test_shot_names_what_the_cue_would_pass_through(run: CommandLine, pot: dict[str, Any]) -> None:
    x, y = pot["balls"][0]["position"]
    pot["balls"].append({"id": "behind", "position": [x, y - 0.06]})
    done = run("shot", "-", stdin=json.dumps(pot))
    assert done.returncode == 0
    assert "the cue would pass through: behind" in done.stdout


def on_a_terminal(arguments: list[str], **environment: str) -> str:
    """What a command prints when its stdout is a terminal."""
    master, slave = pty.openpty()
    clean = {k: v for k, v in os.environ.items() if k not in {"NO_COLOR", "FORCE_COLOR"}}
    with subprocess.Popen(
        [sys.executable, "-m", "carom", *arguments],
        stdout=slave,
        env={**clean, "TERM": "xterm-256color", "COLUMNS": "120", **environment},
    ) as process:
        os.close(slave)
        chunks = []
        while True:
            try:
                chunk = os.read(master, 65536)
            except OSError:
                break
            if not chunk:
                break
            chunks.append(chunk)
    os.close(master)
    assert process.returncode == 0
    return b"".join(chunks).decode()


def test_the_table_has_colours_on_a_terminal_unless_no_color_is_set(file: Path) -> None:
    coloured = on_a_terminal(["shot", str(file)])
    assert "\x1b[33m" in coloured
    assert "ball-collision" in coloured
    plain = on_a_terminal(["shot", str(file)], NO_COLOR="1")
    assert "ball-collision" in plain
    # Bold and dim are not colours: https://no-color.org
    assert "\x1b[33m" not in plain
    assert "\x1b[36m" not in plain


def test_pictures_are_written_to_the_given_paths(
    run: CommandLine, file: Path, tmp_path: Path
) -> None:
    done = run("shot", str(file), "--svg", "a.svg", "--png", "b.png", "--json")
    assert done.returncode == 0
    assert json.loads(done.stdout)["format"] == "carom-trace/1"
    assert ElementTree.parse(tmp_path / "a.svg").getroot().tag.endswith("svg")
    assert (tmp_path / "b.png").read_bytes().startswith(b"\x89PNG")
    assert {p.name for p in tmp_path.iterdir()} == {"pot.json", "a.svg", "b.png"}


def test_bad_input_gives_one_sentence_and_exit_code_2(
    run: CommandLine, pot: dict[str, Any]
) -> None:
    pot["balls"][1]["position"] = [9.0, 9.0]
    refused(run("shot", "-", "--json", stdin=json.dumps(pot)), "balls[1].position")
    refused(run("shot", "-", stdin="{"), "JSON")
    refused(run("shot", "-", stdin=b"\xff\xfe"), "UTF-8")
    refused(run("shot", "-", stdin=""), "JSON")


@pytest.mark.parametrize(
    "command",
    [
        ("shot",),
        ("play", "--no-browser"),
        ("replay",),
        ("evaluate",),
        ("think",),
        ("solve", "--pot", "1"),
        ("map", "acceptance", "--pocket", "left"),
        ("sweep", "--out", "table"),
        ("import", "--format", "pooltool"),
    ],
)
def test_the_error_of_a_syntax_fault_names_the_file_or_stdin(
    run: CommandLine, tmp_path: Path, command: tuple[str, ...]
) -> None:
    file, text = tmp_path / "broken.json", '{"format": "carom-shot/1",\n oops}'
    file.write_text(text, encoding="utf-8")
    for done, name in (
        (run(*command, str(file)), str(file)),
        (run(*command, "-", stdin=text), "stdin"),
    ):
        refused(done, f"carom: {name}: ")
        refused(done, "not JSON: ")
        refused(done, "(line 2, column 2)")


def test_physics_prints_the_speed_bands_of_a_law(run: CommandLine) -> None:
    law = ("physics", "--rolling-bands", "0.0410,0.0142")
    done = run(*law)
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout) == carom.rolling_bands(0.0410, 0.0142)
    done = run(*law, "--fastest", "2", "--share", "0.02", "--least", "0.01", "--gravity", "9.81")
    options = {"fastest": 2.0, "share": 0.02, "least": 0.01, "gravity": 9.81}
    assert json.loads(done.stdout) == carom.rolling_bands(0.0410, 0.0142, **options)
    constant = run("physics", "--rolling-bands", "0.0980665,0", "--json")
    assert json.loads(constant.stdout) == pytest.approx(0.01)
    refused(run("physics", "--rolling-bands", "0.04"), "--rolling-bands: '0.04' is not A,B")
    refused(run("physics", "--rolling-bands", "-1,0"), "a: -1.0 is out of range")
    refused(run("physics", "--share", "0.1"), "--share: ", "give --rolling-bands too")
    refused(run("physics", "pool", "--rolling-bands", "0.04,0.01"), "NAME: ")


def test_a_missing_file_is_bad_input(run: CommandLine, tmp_path: Path) -> None:
    refused(run("shot", "nowhere.json"), "nowhere.json")
    refused(run("shot", str(tmp_path)), str(tmp_path))


def test_a_picture_that_cannot_be_written_is_bad_input(run: CommandLine, file: Path) -> None:
    refused(run("shot", str(file), "--svg", "no/such/folder.svg"), "no/such/folder.svg")


def test_the_error_of_a_full_disk_names_the_file(run: CommandLine, file: Path) -> None:
    refused(run("shot", str(file), "--svg", "/dev/full"), "/dev/full")
    refused(run("shot", str(file), "--png", "/dev/full"), "/dev/full")


@pytest.mark.parametrize(
    ("command", "word"),
    [
        ("shot - <&-", "stdin: it is closed"),
        ("import - <&-", "stdin: it is closed"),
        ("shot {} >&-", "stdout: it is closed"),
        ("shot {} --json >&-", "stdout: it is closed"),
        ("shot nowhere.json 2>&-", ""),
    ],
)
def test_a_closed_stream_gives_at_most_one_sentence(file: Path, command: str, word: str) -> None:
    done = subprocess.run(
        ["bash", "-c", f"{sys.executable} -m carom {command.format(file)}"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stdout == ""
    assert len(done.stderr.splitlines()) == (1 if word else 0)
    assert word in done.stderr


def test_control_characters_in_names_do_not_reach_the_terminal(
    run: CommandLine, pot: dict[str, Any]
) -> None:
    refused(run("shot", "no\nwhere\x1b[31m.json"), r"no\nwhere\x1b[31m.json")
    pot["balls"][1]["id"] = "\x1b[31m\n"
    done = run("shot", "-", stdin=json.dumps(pot))
    assert "\x1b" not in done.stdout
    assert r"first contact: \x1b[31m\n" in done.stdout.splitlines()


def test_a_call_without_a_game_is_bad_input(run: CommandLine, file: Path) -> None:
    refused(run("evaluate", str(file), "--call", "safety"), "--call", "--game")


def test_an_impossible_folder_is_refused_before_anything_is_measured(run: CommandLine) -> None:
    refused(run("bench", "--store", "/dev/null/results"), "/dev/null/results")


def test_too_deep_nesting_is_bad_input(run: CommandLine) -> None:
    deep = "[" * 100_000
    for command in (["shot"], ["replay"], ["sweep", "--out", "out"], ["import"]):
        refused(run(*command, "-", stdin=deep))
    refused(run("import", "-", stdin=b"\x91" * 100_000))


def test_a_trace_in_place_of_a_shot_is_recognised_in_the_error(
    run: CommandLine, file: Path
) -> None:
    trace = run("shot", str(file), "--json").stdout
    for command in ("shot", "evaluate", "solve"):
        told = "the file is a trace", "carom-trace/1", "carom-shot/1", "`carom replay` and"
        refused(run(command, "-", stdin=trace), "format", *told)
    told = "the file is a shot", "carom-trace/1", "`carom shot FILE --json` prints its trace"
    refused(run("replay", str(file)), "format", *told)


def test_an_unknown_option_is_bad_input(run: CommandLine, file: Path) -> None:
    done = run("shot", str(file), "--jsn")
    assert done.returncode == 2
    assert done.stdout == ""
    assert "--jsn" in done.stderr


def test_reaching_a_chosen_cap_of_events_shows_the_shot_on_stderr(
    run: CommandLine, pot: dict[str, Any]
) -> None:
    pot["max_events"] = 3
    done = run("shot", "-", "--json", stdin=json.dumps(pot))
    assert done.returncode == 2
    assert done.stdout == ""
    sentence, shot = done.stderr.strip().splitlines()
    assert "3 events" in sentence
    assert carom.Shot.from_json(shot) == carom.Shot.from_dict(pot)


def test_an_end_time_cuts_a_shot_off(run: CommandLine, file: Path) -> None:
    trace = run("shot", str(file), "--until", "0.5", "--json").stdout
    written = json.loads(trace)
    assert (written["duration"], written["end"]) == (0.5, "until")
    assert written["shot"]["until"] == 0.5
    assert "reproduced bit by bit" in run("replay", "--check", "-", stdin=trace).stdout
    table = run("shot", str(file), "--until", "0.5").stdout
    assert "ends at its end time; still moving: " in table
    refused(run("shot", str(file), "--until", "-1"), "until", "a number > 0 s")


def test_motion_without_friction_is_bad_input_and_not_our_bug(run: CommandLine) -> None:
    # Seen: exit code 1 for a shot that no friction can stop.
    cloth = {"sliding_friction": 0, "rolling_friction": 0, "spin_deceleration": 0}
    shot = {
        "format": "carom-shot/1",
        "table": {"length": 2, "width": 1, "pockets": "none"},
        "physics": {"base": "ideal", "cloth": cloth},
        "balls": [{"id": "cue", "position": [0.5, 0.5], "velocity": [1, 0.3, 0]}],
    }
    done = run("shot", "-", stdin=json.dumps(shot))
    assert (done.returncode, done.stdout) == (2, "")
    assert "until: no friction stops" in done.stderr
    done = run("shot", "-", "--until", "20", stdin=json.dumps(shot))
    assert done.returncode == 0


def test_a_trace_that_ended_at_its_cap_is_reproduced(run: CommandLine, pot: dict[str, Any]) -> None:
    pot["max_events"] = 3
    with pytest.raises(carom.EventCapError) as error:
        carom.Shot.from_dict(pot).simulate()
    done = run("replay", "--check", "-", stdin=error.value.trace.to_json())
    assert "3 events" in done.stdout


def test_a_bug_of_ours_is_reported_as_one_with_instructions(tmp_path: Path) -> None:
    program = (
        "import sys, carom\n"
        "from carom.cli import main\n"
        "def broken(*_): raise RuntimeError('a wheel came off')\n"
        "carom.Shot.simulate = broken\n"
        "sys.argv = ['carom', 'shot', '-']\n"
        "main()\n"
    )
    shot = json.dumps(
        {
            "format": "carom-shot/1",
            "table": {"cloth": "unbounded"},
            "balls": [{"id": "a", "position": [0, 0]}],
        }
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        input=shot,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
    )
    assert done.returncode == 1
    assert done.stdout == ""
    assert "bug in carom" in done.stderr
    assert "report" in done.stderr
    assert "a wheel came off" in done.stderr


def test_a_closed_pipe_ends_quietly(file: Path) -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "carom", "tables", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        process.stdout.close()
        assert process.stderr is not None
        assert process.stderr.read() == b""


@pytest.mark.parametrize(
    "game", ["nine-ball", "eight-ball", "ten-ball", "straight-pool", "snooker", "three-cushion"]
)
def test_break_plays_every_game(run: CommandLine, game: str) -> None:
    done = run("break", "--game", game, "--json")
    assert done.returncode == 0
    trace = json.loads(done.stdout)
    assert trace["events"][0]["type"] == "cue-strike"
    assert any(event["type"] == "ball-collision" for event in trace["events"])


def test_the_same_seed_breaks_the_same_rack(run: CommandLine) -> None:
    def hash_of(*args: str) -> str:
        return str(json.loads(run("break", *args, "--json").stdout)["hash"])

    assert hash_of("--seed", "5") == hash_of("--seed", "5")
    assert hash_of("--seed", "5") != hash_of("--seed", "6")
    assert hash_of("--seed", "5", "--speed", "8") != hash_of("--seed", "5", "--speed", "9")


def test_break_refuses_an_unknown_game(run: CommandLine) -> None:
    refused(run("break", "--game", "nine-pin"), "nine-pin", "nine-ball")
    refused(run("break", "--speed", "-1"), "speed")


def test_replay_checks_a_saved_trace_bit_by_bit(
    run: CommandLine, file: Path, tmp_path: Path
) -> None:
    saved = run("shot", str(file), "--json").stdout
    (tmp_path / "trace.json").write_text(saved)
    done = run("replay", "--check", "trace.json")
    assert done.returncode == 0
    assert "bit by bit" in done.stdout
    assert run("replay", "--check", "-", stdin=saved).returncode == 0
    assert run("replay", "trace.json").stdout == saved


def test_replay_refuses_a_trace_with_one_changed_digit(run: CommandLine, file: Path) -> None:
    trace = json.loads(run("shot", str(file), "--json").stdout)
    trace["events"][1]["time"] += 1e-15
    refused(run("replay", "--check", "-", stdin=json.dumps(trace)), "hash")


def test_replay_refuses_a_trace_with_a_changed_outcome(run: CommandLine, file: Path) -> None:
    trace = json.loads(run("shot", str(file), "--json").stdout)
    trace["outcome"]["first_contact"] = None
    refused(run("replay", "--check", "-", stdin=json.dumps(trace)), "outcome.first_contact")


def test_a_difference_to_a_trace_of_another_engine_names_that_engine(
    run: CommandLine, file: Path
) -> None:
    trace = json.loads(run("shot", str(file), "--json").stdout)
    trace["engine"] = "carom 0.0.1"
    assert run("replay", "--check", "-", stdin=json.dumps(trace)).returncode == 0
    trace["shot"]["strike"]["speed"] *= 1.5
    done = run("replay", "--check", "-", stdin=json.dumps(trace))
    refused(done, "events[0].after[0].velocity", "carom 0.0.1")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("option", ["--json", None])
def test_a_full_disk_is_an_error_with_exit_code_2(file: Path, option: str | None) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "carom", "shot", str(file), *([option] if option else [])],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            env={**os.environ, "PYTHONUNBUFFERED": ""},
        )
    assert done.returncode == 2
    assert done.stderr.startswith("carom: stdout: No space left")
    assert len(done.stderr.splitlines()) == 1


def test_tables_prints_every_preset_with_its_dimensions(run: CommandLine) -> None:
    names = [
        "wpa-9ft",
        "wpa-8ft",
        "bar-7ft",
        "showood-7ft",
        "snooker-12ft",
        "english-7ft",
        "carom-10ft",
        "carom-9ft",
        "poolfiz",
        "chinese-9ft",
    ]
    done = run("tables")
    assert done.returncode == 0
    for name in names:
        assert name in done.stdout
    assert "142.00 deg  WPA equipment specifications" in done.stdout
    assert "from memory, not verified" in done.stdout
    listed = json.loads(run("tables", "--json").stdout)
    # Older editions follow the newest ones.
    older = [f"{name}-2026-11" for name in names if name not in ("poolfiz", "chinese-9ft")]
    assert [table["name"] for table in listed] == names + older
    assert [table["name"] for table in carom.tables()] == names + older


def test_physics_prints_every_value_with_its_evidence_and_source(run: CommandLine) -> None:
    done = run("physics", "carom")
    assert done.returncode == 0
    assert done.stdout.startswith("carom (carom-2026-12)\n")
    rolling = next(line for line in done.stdout.splitlines() if "rolling_friction" in line)
    assert "0.00445–0.00798  fit" in rolling
    spin = next(line for line in done.stdout.splitlines() if "spin_deceleration" in line)
    assert "3.6 rad/s²  fit" in spin
    assert "three-cushion match" in spin
    listed = json.loads(run("physics", "--json").stdout)
    assert listed == carom.physics()
    assert run("physics", "pool").stdout == run("physics", "pool-2026-12").stdout
    assert run("physics", "pool").stdout != run("physics", "pool-2026-11").stdout
    refused(run("physics", "felt"), "pool-worn-cloth")


def test_every_listed_physics_is_that_of_a_shot_with_its_name() -> None:
    for preset in carom.physics():
        assert {p["evidence"] for p in preset["parameters"]} <= {
            "measured",
            "fit",
            "specified",
            "estimate",
        }
        cue = {"id": "cue", "position": [0.5, 0.5]}
        ends = {
            name: carom.Shot.from_dict(
                {
                    "format": "carom-shot/1",
                    "table": {"length": 2.0, "width": 1.0},
                    "physics": physics,
                    "balls": [cue],
                    "strike": {"ball": "cue", "speed": 4.0, "azimuth_deg": 50.0, "side": 0.3},
                }
            )
            .simulate()
            .hash
            for name, physics in (
                ("name", preset["name"]),
                ("dated", preset["dated_name"]),
                ("values", preset["physics"]),
            )
        }
        assert len(set(ends.values())) == 1, preset["name"]


@pytest.mark.parametrize("kind", ["shot", "trace", "arena", "tracks", "player"])
def test_schema_prints_a_json_schema(run: CommandLine, kind: str) -> None:
    done = run("schema", kind)
    assert done.returncode == 0
    assert json.loads(done.stdout) == carom.schema(kind)  # type: ignore[arg-type]


def test_schema_without_a_name_is_that_of_the_shot_file(run: CommandLine) -> None:
    assert run("schema").stdout == run("schema", "shot").stdout
    refused(run("schema", "table"), "table")


def test_version_is_printed(run: CommandLine) -> None:
    done = run("--version")
    assert done.returncode == 0
    assert done.stdout == f"carom {carom.__version__}\n"


def test_help_lists_the_commands(run: CommandLine) -> None:
    done = run("--help")
    assert done.returncode == 0
    for command in ("shot", "break", "validate", "bench", "replay", "tables", "schema"):
        assert command in done.stdout


def test_validate_prints_the_reference_numbers_and_ours(run: CommandLine) -> None:
    done = run("validate", "kim_2024")
    assert done.returncode == 0
    assert "kim_2024" in done.stdout
    assert "0 failed" in done.stdout


def test_a_terminal_without_arrows_still_gets_the_table(run: CommandLine, file: Path) -> None:
    done = run("shot", str(file), PYTHONIOENCODING="ascii")
    assert done.returncode == 0
    assert "sliding?rolling" in done.stdout


def test_validate_refuses_an_unknown_paper(run: CommandLine) -> None:
    refused(run("validate", "nobody_1999"), "nobody_1999")


def test_the_installed_command_is_the_module(file: Path) -> None:
    command = Path(sys.executable).parent / "carom"
    done = subprocess.run([command, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == f"carom {carom.__version__}\n"


def test_a_cling_of_every_contact_changes_the_chances(run: CommandLine, file: Path) -> None:
    plain, clung = (
        json.loads(run("evaluate", str(file), "-n", "200", "--cling", p, "--json").stdout)
        for p in ("0", "1")
    )
    assert plain["end_mean"] != clung["end_mean"]
    refused(run("evaluate", str(file), "--cling", "1.5"), "noise.cling_probability", "1.5")


def test_learn_table_and_strikes_write_what_they_found(run: CommandLine, tmp_path: Path) -> None:
    layout = {"1": (0.5, 0.6), "2": (0.9, 2.2), "3": (0.3, 1.8)}
    strikes = [carom.Strike(speed=1.6, azimuth_deg=angle) for angle in (50.0, 72.0)]
    shots = [
        carom.Shot("carom-10ft", layout, dict(strike.to_dict(), ball="1")) for strike in strikes
    ]
    film = tmp_path / "film.csv"
    carom.learn.write_tracks(carom.learn.synthetic(shots, clock_offset=0.3).tracks, film)
    learned, folder = tmp_path / "learned.json", tmp_path / "strikes"
    few = ["--starts", "8"]
    numbers = ["--free", "rolling.a", "--rounds", "1", "--out", str(learned)]
    done = run("learn", "table", str(film), *numbers, *few)
    assert "rolling.a" in done.stdout
    assert json.loads(learned.read_text())["posterior"]["names"] == ["rolling.a"]
    done = run("learn", "strikes", str(film), "--learned", str(learned), "--out", str(folder), *few)
    names = [path.name for path in sorted(folder.iterdir())]
    assert names == ["0001.json", "0002.json", "strikes.json"]
    assert "wrote 2 shots" in done.stderr
    shot = carom.Shot.load(folder / "0001.json")
    assert list(shot.track) == ["1", "2", "3"]
    found = shot.strike
    assert found is not None
    assert found.azimuth_deg == pytest.approx(50.0, abs=2.0)
    refused(run("learn", "table", str(film), "--free", "colour"), "cannot be learned")


def test_learn_check_prints_the_quality_of_each_shot(run: CommandLine, tmp_path: Path) -> None:
    rows = [f"{n};{x}" for n, x in enumerate([700, *range(700, 1300, 12)])]
    film = "time;px;py;who\n" + "".join(f"{row};0;cue\n" for row in rows)
    (tmp_path / "film.csv").write_text(film, encoding="utf-8")
    options = ["--columns", "t=time,x=px,y=py,ball=who", "--unit", "mm", "--time-unit", "frame"]
    options += ["--rate", "50", "--x", "length", "--table", "carom-10ft", "--origin", "0,-710"]
    options += ["--out", str(tmp_path / "film.parquet")]
    done = run("learn", "check", str(tmp_path / "film.csv"), *options)
    refused(done, "0 % of the places are on the playing area")
    options[options.index("0,-710")] = "0,0"
    done = run("learn", "check", str(tmp_path / "film.csv"), *options)
    assert done.returncode == 0, done.stderr
    assert "1 shot, 51 samples on carom-10ft" in done.stdout
    again = run("learn", "check", str(tmp_path / "film.parquet"), "--json")
    assert json.loads(again.stdout)["shots"][0]["struck"] == "cue"
    refused(run("learn", "check", str(tmp_path / "film.csv"), "--columns", "t"), "KEY=NAME")
