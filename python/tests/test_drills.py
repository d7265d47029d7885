"""Drill files, their verdicts and sheets, and puzzles."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import jsonschema
import pytest
from carom.cli.main import app
from carom.picture import drill_sheet
from typer.testing import CliRunner

if TYPE_CHECKING:
    from conftest import CommandLine

STORED = json.loads(
    (Path(__file__).parents[2] / "benches" / "results" / "puzzles.json").read_text(encoding="utf-8")
)


def drill_file() -> dict[str, Any]:
    pot = {"kind": "pot", "ball": "1", "pocket": "top-right"}
    stop = {"kind": "stop", "area": {"center": [0.9525, 2.2225], "radius": 0.2}}
    balls = [{"id": "cue", "position": [0.635, 1.905]}, {"id": "1", "position": [0.9525, 2.2225]}]
    more = [*balls, {"id": "2", "position": [0.4, 0.9]}]
    zones = [{"area": {"from": [0.2, 0.2], "to": [0.6, 0.7]}, "points": 4}]
    return {
        "format": "carom-drill/1",
        "name": "Stop",
        "text": "Stop the cue ball.",
        "table": "wpa-9ft",
        "attempts": 6,
        "misses": 2,
        "order": "ladder",
        "steps": [
            {"balls": balls, "goal": {"kind": "shot", "needs": [pot, stop], "points": 3}},
            {"balls": balls, "goal": {"kind": "shot", "needs": [pot], "zones": zones}},
            {
                "balls": more,
                "hand": {"from": [0, 0], "to": [1.27, 0.6]},
                "goal": {"kind": "run", "balls": ["1", "2"], "order": "rotation"},
            },
        ],
    }


def test_a_drill_reads_back_and_is_of_its_schema(tmp_path: Path) -> None:
    drill = carom.Drill.from_json(json.dumps(drill_file()))
    drill.save(tmp_path / "drill.json")
    again = carom.Drill.load(tmp_path / "drill.json")
    assert again.to_dict() == drill.to_dict()
    assert (drill.name, drill.attempts, drill.misses, drill.order) == ("Stop", 6, 2, "ladder")
    schema = carom.schema("drill")
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(drill.to_dict(), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**drill.to_dict(), "script": "alert(1)"}, schema)


def test_an_error_names_the_file_and_the_place(tmp_path: Path) -> None:
    file = drill_file()
    file["steps"][0]["goal"]["needs"][0]["ball"] = "7"
    path = tmp_path / "wrong.json"
    path.write_text(json.dumps(file), encoding="utf-8")
    with pytest.raises(carom.InputError, match=r'steps\[0\].goal.needs\[0\].ball: .*"7"'):
        carom.Drill.load(path)


def test_the_sheet_of_a_drill_with_an_outline_is_drawn(run: CommandLine, tmp_path: Path) -> None:
    file = drill_file()
    zone = {"area": {"outline": [[0.1, 0.1], [1.0, 0.1], [0.5, 1.2]]}, "points": 3}
    file["steps"] = [file["steps"][0]]
    file["steps"][0]["goal"]["zones"] = [zone]
    (tmp_path / "drill.json").write_text(json.dumps(file), encoding="utf-8")
    jsonschema.validate(file, carom.schema("drill"))
    done = run("drill", "drill.json", "-o", "sheet.svg")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "sheet.svg").exists()
    done = run("diagram", "drill.json", "-o", "sheet.svg")
    assert done.returncode == 2
    assert "carom drill drill.json -o" in done.stderr


def test_a_step_judges_a_shot_and_its_trace() -> None:
    first, second, third = carom.Drill.from_json(json.dumps(drill_file())).steps
    stopped = first.shot.with_strike(azimuth_deg=45, speed=2.0, height=-0.3)
    assert first.judge(stopped) == {"points": 3, "fault": None, "left": []}
    assert first.judge(stopped.simulate()).points == 3
    soft = first.shot.with_strike(azimuth_deg=45, speed=0.05)
    assert first.judge(soft).fault == {"kind": "need", "index": 0, "distance": 0.0}
    assert second.judge(stopped).fault["kind"] == "zone"  # type: ignore[index]
    verdict = third.judge(third.shot.with_strike(azimuth_deg=45, speed=2.0, height=-0.3))
    assert (verdict.points, verdict.left) == (1, ["2"])
    with pytest.raises(carom.InputError, match="has no ball"):
        third.judge(stopped, ["2"]) and first.judge(carom.break_shot("three-cushion"))


@pytest.mark.parametrize("paper", ["a4", "letter"])
def test_a_sheet_draws_every_step(paper: Any) -> None:
    drill = carom.Drill.from_json(json.dumps(drill_file()))
    (page,) = drill_sheet.draw(drill, paper=paper)
    assert len(page.axes) == 3
    words = [text.get_text().replace("\n", " ") for text in page.texts]
    assert "3  Stop" in words
    assert drill.steps[0].words() in words
    many = drill_file()
    many["steps"] = [many["steps"][0]] * 8
    pages = drill_sheet.draw(carom.Drill.from_json(json.dumps(many)), paper=paper)
    assert [len(one.axes) for one in pages] == [6, 2]


def test_every_goal_has_words() -> None:
    needs = [
        {"kind": "pot", "ball": "1"},
        {"kind": "pot-any"},
        {"kind": "first", "ball": "1"},
        {"kind": "kick", "cushions": 2},
        {"kind": "cushions", "ball": "1", "cushions": 1},
        {"kind": "carom", "cushions": 0},
        {"kind": "touch", "balls": ["1", "2"]},
        {"kind": "avoid", "ball": "1"},
        {"kind": "stop", "area": {"from": [0.1, 0.1], "to": [0.4, 0.4]}},
        {"kind": "hidden", "ball": "1"},
        {"kind": "next", "ball": "1"},
        {"kind": "apart", "balls": ["1", "2"], "distance": 0.3},
    ]
    file = drill_file()
    file["steps"] = [{**file["steps"][2], "goal": {"kind": "shot", "needs": needs}}]
    (step,) = carom.Drill.from_json(json.dumps(file)).steps
    assert step.words().count(".") >= len(needs)
    assert "at least 30 cm apart" in step.words()
    assert "2 cushions" in step.words()


def test_a_puzzle_is_made_again_with_its_stored_chances() -> None:
    for theme, stored in STORED["themes"].items():
        number, rating, *chances = stored["puzzles"][-1]
        puzzle = carom.puzzle(f"{theme}-{number}")
        assert puzzle.rating == pytest.approx(rating, abs=1e-4)
        assert list(puzzle.chances.values()) == pytest.approx(chances, abs=1e-4)
        assert carom.puzzles(theme)[puzzle.id] == 10 * round(rating / 10)
        assert puzzle.judge(puzzle.solution()).fault is None
        assert puzzle.judge(puzzle.solution(-1).simulate()).fault is None


def test_the_list_is_the_stored_one() -> None:
    stored = STORED["themes"].items()
    listed = {
        f"{theme}-{number}": 10 * round(rating / 10)
        for theme, found in stored
        for number, rating, *_ in found["puzzles"]
    }
    assert carom.puzzles() == listed
    assert len(listed) >= 2000


def test_an_unknown_puzzle_or_theme_is_refused() -> None:
    with pytest.raises(carom.InputError, match="is no id of a puzzle"):
        carom.puzzle("cut")
    with pytest.raises(carom.InputError, match="no theme"):
        carom.puzzles("moon")


def test_the_commands_print_and_draw(tmp_path: Path) -> None:
    path = tmp_path / "drill.json"
    path.write_text(json.dumps(drill_file()), encoding="utf-8")
    run = CliRunner().invoke
    said = run(app, ["drill", str(path)]).stdout
    assert "It ends after 2 misses." in said
    assert "3. Hit the first ball that is left, and pot 1, 2 without a miss." in said
    run(app, ["drill", str(path), "-o", str(tmp_path / "sheet.pdf")])
    assert (tmp_path / "sheet.pdf").read_bytes().startswith(b"%PDF")
    name = next(iter(carom.puzzles("bank")))
    said = run(app, ["puzzle", name, "--solution"]).stdout
    assert "meets a cushion." in said
    assert "way 1:" in said
    run(app, ["puzzle", name, "--solution", "-o", str(tmp_path / "shot.json")])
    assert carom.puzzle(name).judge(carom.Shot.load(tmp_path / "shot.json")).points == 1
    run(app, ["puzzle", "--theme", "cut", "-o", str(tmp_path / "p.svg")])
    assert "<svg" in (tmp_path / "p.svg").read_text(encoding="utf-8")
    assert len(run(app, ["puzzle", "--list"]).stdout.splitlines()) == len(carom.puzzles())
    assert json.loads(run(app, ["puzzle", name, "--json"]).stdout)["id"] == name
