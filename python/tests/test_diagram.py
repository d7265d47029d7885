"""Diagrams for paper: SVG, PNG and PDF, and `carom diagram`."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import carom
import pytest
from carom.picture import diagram
from matplotlib.colors import to_rgb

if TYPE_CHECKING:
    from conftest import CommandLine
    from matplotlib.figure import Figure

MM = 25.4
ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def shot() -> carom.Shot:
    """The cue ball drives the 7 into the 12; the 8 stays."""
    layout = {"cue": (0.4, 0.5), "7": (0.6, 1.0), "12": (0.8, 1.5), "8": (0.3, 2.2)}
    return carom.Shot("wpa-9ft", layout, carom.Strike(speed=2.0, azimuth_deg=68.2))


def parts(page: Figure) -> dict[str, Any]:
    """The artists of a page by their ids."""
    return {a.get_gid(): a for a in page.findobj() if a.get_gid() is not None}


def test_a_diagram_has_balls_numbers_paths_and_ends(shot: carom.Shot) -> None:
    (page,) = diagram.draw(shot)
    found = parts(page)
    assert {"ball-cue", "ball-7", "ball-12", "ball-8", "path-cue", "path-7"} <= set(found)
    assert {"number-7", "number-12", "number-8"} <= set(found)
    assert "number-cue" not in found
    assert "path-8" not in found, "it rests"
    # The table lies: the cue ball at y = 0.5 m is left of the 8 at y = 2.2 m.
    x = [found[f"ball-{ball}"].get_window_extent().x0 for ball in ("cue", "8")]
    assert x[0] < x[1]


def test_lines_are_dark_and_differ_without_colours(shot: carom.Shot) -> None:
    found = parts(diagram.draw(shot)[0])
    moving = [found[f"path-{ball}"] for ball in ("cue", "7", "12") if f"path-{ball}" in found]
    assert len({str(path.get_linestyle()) for path in moving}) == len(moving) > 1
    for path in moving:
        red, green, blue = to_rgb(path.get_edgecolor())
        assert 0.299 * red + 0.587 * green + 0.114 * blue <= 0.46


def test_marks_of_a_shot_are_drawn_dark_and_their_text_is_only_text(shot: carom.Shot) -> None:
    marks: list[dict[str, Any]] = [
        {"kind": "arrow", "color": "yellow", "from": [0.4, 0.6], "to": [0.9, 1.5]},
        {"kind": "line", "color": "white", "from": [0.1, 0.1], "to": [0.1, 2.4]},
        {"kind": "circle", "color": "red", "center": [0.8, 1.8], "radius": 0.12},
        {"kind": "area", "color": "blue", "outline": [[0.9, 0.3], [1.2, 0.3], [1.2, 0.8]]},
        {"kind": "label", "color": "white", "at": [0.3, 2.0], "text": "$x$ & <here>"},
    ]
    marked = carom.Shot.from_dict(shot.to_dict() | {"marks": marks})
    (page,) = diagram.draw(marked)
    page.draw_without_rendering()
    found = parts(page)
    assert {f"mark-{index}" for index in range(5)} <= set(found)
    assert found["mark-1"].get_edgecolor()[:3] == (0.0, 0.0, 0.0), "white would not be seen"
    assert found["mark-4"].get_text() == "$x$ & <here>"
    assert not found["mark-4"].get_parse_math()


def test_marks_have_the_colours_of_the_page_s_diagrams() -> None:
    source = ROOT / "web/src/app/diagram/paper-marks.ts"
    table = source.read_text(encoding="utf-8").partition("INKS")[2].partition("};")[0]
    assert dict(re.findall(r'(\w+): "(#\w+)"', table)) == diagram.MARK_INKS


def test_numbers_keep_clear_of_balls(shot: carom.Shot) -> None:
    (page,) = diagram.draw(shot)
    page.draw_without_rendering()
    found = parts(page)
    balls = [a.get_window_extent() for gid, a in found.items() if gid.startswith("ball-")]
    for number in (a for gid, a in found.items() if gid.startswith("number-")):
        x, y = number.get_window_extent().get_points().mean(axis=0)
        assert not any(ball.contains(x, y) for ball in balls)


def test_balls_of_one_colour_have_no_letter_and_similar_names_differ() -> None:
    found = parts(diagram.draw(carom.Frame("snooker"))[0])
    assert not any(gid.startswith("number-red") for gid in found)
    names = [found[f"number-{ball}"].get_text() for ball in ("brown", "blue", "black", "green")]
    assert names == ["Br", "Blu", "Bla", "G"]


@pytest.mark.parametrize(
    ("paper", "per_page", "size"),
    [
        ("a4", 1, (297.0, 210.0)),
        ("a4", 2, (210.0, 297.0)),
        ("letter", 4, (279.4, 215.9)),
    ],
)
def test_pages_have_the_size_of_the_paper(
    shot: carom.Shot, paper: diagram.Paper, per_page: int, size: tuple[float, float]
) -> None:
    pages = diagram.draw([shot] * 5, paper=paper, per_page=per_page)
    assert len(pages) == -(-5 // per_page)
    for page in pages:
        assert [MM * side for side in page.get_size_inches()] == pytest.approx(size)
        for ax in page.axes:
            box = ax.get_position()
            assert box.x0 >= 0.02
            assert box.y0 >= 0.02
            assert box.x1 <= 0.98
            assert box.y1 <= 0.98


def test_files_are_the_same_for_the_same_shot(shot: carom.Shot, tmp_path: Path) -> None:
    for ending, head in ((".svg", b"<?xml"), (".png", b"\x89PNG"), (".pdf", b"%PDF")):
        files = [tmp_path / f"{name}{ending}" for name in "ab"]
        for file in files:
            diagram.save(shot, file, title="A $1 ball")
        one, other = (file.read_bytes() for file in files)
        assert one == other
        assert one.startswith(head)
    root = ElementTree.parse(tmp_path / "a.svg").getroot()
    assert any(element.get("id") == "path-cue" for element in root.iter())


def test_a_pdf_has_a_page_for_each_sheet(shot: carom.Shot, tmp_path: Path) -> None:
    file = tmp_path / "lesson.pdf"
    diagram.save(
        [shot, carom.Frame("three-cushion"), shot.simulate()], file, paper="a4", per_page=2
    )
    assert len(re.findall(rb"/Type /Page\b", file.read_bytes())) == 2


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"per_page": 3}, "write 1, 2, 4 or 6"),
        ({"paper": "b5"}, "write a4 or letter"),
        ({"per_page": 2}, "name a paper"),
    ],
)
def test_wrong_pages_are_refused(shot: carom.Shot, arguments: dict[str, Any], words: str) -> None:
    with pytest.raises(carom.InputError, match=words):
        diagram.draw(shot, **arguments)


def test_what_cannot_be_drawn_is_refused(shot: carom.Shot, tmp_path: Path) -> None:
    with pytest.raises(carom.InputError, match="nothing to draw"):
        diagram.draw([])
    with pytest.raises(carom.InputError, match="int is not a shot"):
        diagram.draw(3)  # type: ignore[arg-type]
    with pytest.raises(carom.InputError, match="ends neither"):
        diagram.save(shot, tmp_path / "shot.txt")
    with pytest.raises(carom.InputError, match="has one page, and there are 2"):
        diagram.save([shot, shot], tmp_path / "shots.svg")


def test_carom_diagram_writes_shots_traces_and_records(
    run: CommandLine, shot: carom.Shot, tmp_path: Path
) -> None:
    shot.save(tmp_path / "shot.json")
    shot.simulate().save(tmp_path / "trace.json")
    frame = carom.Frame("four-ball")
    (tmp_path / "frame.json").write_text(json.dumps(frame.record), encoding="utf-8")
    files = ["shot.json", "trace.json", "frame.json"]
    done = run("diagram", *files, "-o", "out.pdf", "--paper", "letter", "--per-page", "4")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "out.pdf").read_bytes().startswith(b"%PDF")
    refused = run("diagram", *files, "-o", "out.svg")
    assert refused.returncode == 2
    assert "write a .pdf" in refused.stderr
