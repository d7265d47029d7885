"""Studies: `carom.Study`, `carom study check`, their schema, their diagrams, and the examples."""

from __future__ import annotations

import copy
import json
import pickle
import re
import runpy
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import carom
import jsonschema
import pytest
from carom import Chapter, InputError, Shot, Study
from carom.page import MARKER
from carom.picture import diagram
from carom.picture.fonts import FontWarning
from carom.picture.wrapped_text import fitting, wrapped
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen
from matplotlib import font_manager
from referencing import Registry, Resource

if TYPE_CHECKING:
    from conftest import CommandLine

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "studies").glob("*.json"))
STRIKE = {"ball": "cue", "speed": 2.6, "azimuth_deg": 59.35, "height": -0.2}
TASK = {
    "goal": [
        {"kind": "first", "ball": "1"},
        {"kind": "stop", "area": {"center": [0.92, 1.96], "radius": 0.06}},
    ],
    "solution": STRIKE,
}


@pytest.fixture
def study() -> Study:
    shot = Shot("wpa-9ft", {"cue": (0.513, 1.263), "1": (0.95, 2.0)})
    follow = STRIKE | {"height": 0.4}
    tree = [
        {"strike": STRIKE, "comment": "It stops."},
        {"strike": follow},
        {"after": 0, "strike": STRIKE},
    ]
    return Study("A stop", [Chapter("Stop", shot, "Stop it.", tree, TASK)], language="en")


@pytest.fixture(scope="module")
def schema() -> jsonschema.Draft202012Validator:
    parts = [
        (f"carom-{kind}-1.json", Resource.from_contents(carom.schema(kind)))
        for kind in ("shot", "drill")
    ]
    registry: Any = Registry().with_resources(parts)
    jsonschema.Draft202012Validator.check_schema(carom.schema("study"))
    return jsonschema.Draft202012Validator(carom.schema("study"), registry=registry)


def test_a_study_is_written_and_read_again(study: Study, tmp_path: Path) -> None:
    study.save(tmp_path / "stop.json")
    read = Study.load(tmp_path / "stop.json")
    assert read == study
    assert (read.title, read.author, read.language) == ("A stop", None, "en")
    assert pickle.loads(pickle.dumps(read)) == study
    (chapter,) = read.chapters
    assert (chapter.title, chapter.text, len(chapter.tree)) == ("Stop", "Stop it.", 3)
    assert chapter.shot.strike is None
    assert chapter.solution is not None
    assert chapter.judge(chapter.solution.simulate()).met


def test_the_report_counts_shots_and_names_faults(study: Study) -> None:
    report = study.check()
    assert report.ok
    assert str(report) == "1  Stop: 4 shots, solved"
    file = study.to_dict()
    file["chapters"][0]["task"]["solution"]["height"] = 0.0
    report = Study.from_dict(file).check()
    assert not report.ok
    (fault,) = report.chapters[0].faults
    assert fault.startswith("chapters[0].task.solution: it does not meet goal[1]")
    solution = report.chapters[0].solution
    assert solution is not None
    assert solution.condition == 1
    assert solution.distance is not None
    assert solution.distance > 0.0


def test_a_goal_is_judged_on_any_shot(study: Study) -> None:
    chapter = study.chapters[0]
    assert chapter.solution is not None
    missed = chapter.judge(chapter.solution.with_strike(azimuth_deg=120.0).simulate())
    assert (missed.met, missed.fault, missed.condition) == (False, "condition", 0)
    with pytest.raises(InputError, match="the chapter has no task"):
        Chapter("No task", chapter.shot).judge(chapter.solution.simulate())


BROKEN: dict[str, tuple[str, Any]] = {
    "title": ("chapters[0].title", lambda c: c.update(title="")),
    "key": ("chapters[0].notes", lambda c: c.update(notes="x")),
    "ball": ("chapters[0].shot.balls[1].id", lambda c: c["shot"]["balls"][1].update(id="cue")),
    "goal": ("chapters[0].task.goal", lambda c: c["task"].update(goal=[])),
    "kind": ("chapters[0].task.goal[0].kind", lambda c: c["task"]["goal"][0].update(kind="hop")),
    "after": ("chapters[0].tree[2].after", lambda c: c["tree"][2].update(after=-1)),
}


@pytest.mark.parametrize("what", BROKEN)
def test_a_broken_study_is_refused_with_its_place(
    what: str, study: Study, schema: jsonschema.Draft202012Validator
) -> None:
    file = copy.deepcopy(study.to_dict())
    schema.validate(file)
    place, change = BROKEN[what]
    change(file["chapters"][0])
    # A schema cannot tell that two balls have one name.
    assert schema.is_valid(file) == (what == "ball")
    with pytest.raises(InputError) as error:
        Study.from_dict(file)
    assert error.value.place.startswith(place.removesuffix(".id") if what == "ball" else place)


def test_the_command_checks_a_study(study: Study, run: CommandLine, tmp_path: Path) -> None:
    study.save(tmp_path / "stop.json")
    done = run("study", "check", "stop.json")
    assert (done.returncode, done.stdout) == (0, "1  Stop: 4 shots, solved\n")
    file = study.to_dict()
    file["chapters"][0]["task"]["goal"] = [{"kind": "kick", "cushions": 1}]
    done = run("study", "check", "-", "--json", stdin=json.dumps(file))
    assert done.returncode == 1
    assert json.loads(done.stdout)["chapters"][0]["solution"]["condition"] == 0
    done = run("study", "check", "-", stdin='{"format": "carom-shot/1"}')
    assert done.returncode == 2
    assert "the file is a shot" in done.stderr


def test_a_diagram_has_title_text_goal_and_solution(study: Study) -> None:
    def ids(page: Any) -> set[str]:
        return {a.get_gid() for a in page.findobj() if a.get_gid() is not None}

    (page,) = diagram.draw(study)
    words = [text.get_text() for text in page.texts]
    assert words == ["Stop", "Stop it."]
    assert "mark-0" in ids(page)
    assert "path-cue" not in ids(page)
    (page,) = diagram.draw(study, solutions=True)
    assert "path-cue" in ids(page)
    pages = diagram.draw(Study.load(EXAMPLES[0]), paper="a4", per_page=4)
    assert len(pages) == 5
    assert pages[4].texts[0].get_text().startswith("17  ")


def test_the_command_draws_a_study(study: Study, run: CommandLine, tmp_path: Path) -> None:
    study.save(tmp_path / "stop.json")
    assert run("diagram", "stop.json", "-o", "stop.svg").returncode == 0
    assert 'id="ball-1"' in (tmp_path / "stop.svg").read_text()
    example = str(EXAMPLES[0])
    pages = run("diagram", example, "-o", "all.pdf", "--paper", "a4", "--per-page", "4")
    assert (pages.returncode, pages.stderr) == (0, "")
    assert len(re.findall(rb"/Type /Page\b", (tmp_path / "all.pdf").read_bytes())) == 5


def test_the_command_writes_a_page_that_opens_the_study(
    study: Study, run: CommandLine, tmp_path: Path
) -> None:
    study.save(tmp_path / "stop.json")
    done = run("play", "stop.json", "--html", "stop.html")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    page = (tmp_path / "stop.html").read_text(encoding="utf-8")
    document = page.partition(MARKER)[2].partition("</script>")[0]
    assert json.loads(document) == study.to_dict()
    (tmp_path / "drill.json").write_text('{"format": "carom-drill/1"}')
    done = run("play", "drill.json", "--html", "drill.html")
    assert done.returncode == 2
    assert "drop the file on the page" in done.stderr
    assert not (tmp_path / "drill.html").exists()


@pytest.fixture
def fonts(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The fonts of a computer that has Matplotlib's alone."""
    manager = font_manager.fontManager
    own = [font for font in manager.ttflist if font.name.startswith(("DejaVu", "Last Resort"))]
    monkeypatch.setattr(manager, "ttflist", own)
    manager._findfont_cached.cache_clear()
    return own


CHINESE = "打进一号球，并停在圆圈内。"


def chinese_font(path: Path) -> None:
    """A font with Chinese letters alone, each of them a triangle."""
    pen = TTGlyphPen(None)
    pen.moveTo((0, 0))
    pen.lineTo((900, 0))
    pen.lineTo((450, 900))
    pen.closePath()
    glyph = pen.glyph()
    builder = FontBuilder(1000, isTTF=True)
    builder.setupGlyphOrder([".notdef", "triangle"])
    builder.setupCharacterMap({ord(one): "triangle" for one in CHINESE})
    builder.setupGlyf({".notdef": TTGlyphPen(None).glyph(), "triangle": glyph})
    builder.setupHorizontalMetrics({".notdef": (1000, 0), "triangle": (1000, 0)})
    builder.setupHorizontalHeader(ascent=900, descent=-100)
    names = {"familyName": "Three Corners", "styleName": "Regular", "psName": "ThreeCorners"}
    builder.setupNameTable(names)
    builder.setupOS2()
    builder.setupPost()
    builder.save(path)


def test_chinese_text_is_drawn_in_an_installed_font(
    study: Study, fonts: list[Any], tmp_path: Path
) -> None:
    chinese_font(tmp_path / "three.ttf")
    font_manager.fontManager.addfont(tmp_path / "three.ttf")
    chapter = Chapter(CHINESE, study.chapters[0].shot, f"Stop: {CHINESE}")
    (page,) = diagram.draw(chapter)
    families = {tuple(text.get_fontfamily()) for text in page.texts}
    assert families == {("DejaVu Sans", "Three Corners")}
    # Every format writes the letters of that font, without a warning.
    for ending in ("svg", "png", "pdf"):
        diagram.save(chapter, tmp_path / f"page.{ending}")
    assert "ThreeCorners" in (tmp_path / "page.svg").read_text()
    assert b"ThreeCorners" in (tmp_path / "page.pdf").read_bytes()


@pytest.mark.usefixtures("fonts")
def test_without_a_font_for_a_text_a_sentence_names_the_remedy(study: Study) -> None:
    chapter = Chapter(CHINESE, study.chapters[0].shot)
    with pytest.warns(FontWarning, match="no installed font has 。一.*: install a font"):
        diagram.draw(chapter)


def test_text_is_broken_between_words_and_cut_with_a_sign() -> None:
    lines = wrapped("one two three\nfour", 22.0, 9.0)
    assert lines == ["one two three", "four"]
    assert wrapped("one two three", 14.0, 9.0) == ["one two", "three"]
    assert len(wrapped("打进一号球并停在圆圈内", 20.0, 9.0)) > 1
    assert fitting(["a", "b", "c"], 2.9) == ["a", "b …"]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_the_example_solves_its_tasks(path: Path, schema: jsonschema.Draft202012Validator) -> None:
    study = Study.load(path)
    schema.validate(study.to_dict())
    assert len(study.chapters) == 20
    report = study.check()
    assert report.ok, report
    assert all(chapter.solution and chapter.solution.met for chapter in report.chapters)
    texts = tomllib.loads((ROOT / f"studies/texts/{study.language}.toml").read_text("utf-8"))
    assert study.title == texts["title"]


def test_the_example_does_what_its_texts_say() -> None:
    study = Study.load(ROOT / "studies/twenty_positions.en.json")
    chapters = {chapter.title: chapter for chapter in study.chapters}

    def traces(title: str) -> list[carom.Trace]:
        chapter = chapters[title]
        file = chapter.shot.to_dict()
        shots = (Shot.from_dict(file | {"strike": one["strike"]}) for one in chapter.tree)
        return [shot.simulate() for shot in shots]

    _, scratch = traces("Do not follow into the pocket")
    assert scratch.outcome.cue_ball_scratched
    for title in ("Carom: two cushions", "Carom: three cushions"):
        route = traces(title)[0].carom_route
        assert route is not None
        assert route.side == "running"
    # Forward of the ghost ball with follow, behind it with draw; the stop between.
    stop, follow, draw = (float(t.at(t.duration).position[0, 1]) for t in traces("Stop shot"))
    assert draw < stop - 0.1 < stop + 0.1 < follow


def test_the_examples_are_those_that_the_script_makes(tmp_path: Path) -> None:
    script = runpy.run_path(str(ROOT / "scripts" / "example_study.py"))
    texts = tomllib.loads((ROOT / "studies/texts/de.toml").read_text("utf-8"))
    chapter = script["chapter"](script["POSITIONS"][18], texts)
    stored = Study.load(ROOT / "studies/twenty_positions.de.json").chapters[18]
    assert Study("x", [chapter]) == Study("x", [stored])
