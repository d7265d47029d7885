"""Cells of a notebook: their weight, the one page of a notebook, and what needs no script."""

from __future__ import annotations

import base64
import gzip
import json
import re
import sys
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import carom
import pytest
from carom import notebook, page

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

SMALL = f"<!doctype html><title>carom</title>{page.MARKER}</script><p>&amp;</p>"
# Bytes of a cell's output; it had 2.8 million.
MOST = 300_000


@pytest.fixture
def small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "index.html"
    path.write_text(SMALL)
    monkeypatch.setattr(page, "path", lambda: path)


@pytest.fixture
def kernel(monkeypatch: pytest.MonkeyPatch) -> Callable[[str | None, int], None]:
    """A kernel; call it with the id of the cell that runs, and the number of the run."""
    parent: dict[str, Any] = {"metadata": {}}
    shell = SimpleNamespace(kernel=None, execution_count=1, get_parent=lambda: parent)
    monkeypatch.setitem(
        sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell, version_info=(9, 0))
    )
    monkeypatch.setattr(notebook, "_carrier", None)

    def run(cell: str | None, count: int) -> None:
        parent["metadata"] = {} if cell is None else {"cellId": cell}
        shell.execution_count = count

    return run


def unpacked(text: str) -> str:
    return gzip.decompress(base64.b64decode(text)).decode()


def has_page(cell: str) -> bool:
    return 'pages["' in cell


@pytest.mark.skipif(not page.is_built(), reason="needs the page: run `make page`")
def test_every_cell_but_that_with_the_page_is_light(kernel: Any) -> None:
    shots = [carom.break_shot(game, seed=20) for game in ("nine-ball", "eight-ball", "snooker")]
    shown = [*shots, *(shot.simulate() for shot in shots)]
    first, *others = (thing._repr_html_() for thing in [shots[0], *shown])
    assert has_page(first)
    assert not any(map(has_page, others))
    assert max(map(len, others)) < MOST
    assert len(carom.Frame("snooker")._repr_html_()) < MOST
    packed = re.search(r'pages\["(\w+)"\] = "([^"]*)"', first)
    assert packed
    assert unpacked(packed[2]) == page.html()
    assert len(first) < len(page.html())


@pytest.mark.usefixtures("small")
def test_a_cell_has_its_document_and_a_picture(kernel: Any) -> None:
    trace = carom.break_shot("nine-ball").simulate()
    text = notebook.cell(trace, height=321)
    document = re.search(r'data-carom-document="([^"]*)"', text)
    assert document
    assert json.loads(unpacked(document[1])) == trace.to_dict()
    assert 'data-carom-height="321"' in text
    picture = re.search(r'<img src="data:image/png;base64,([^"]*)"', text)
    assert picture
    assert base64.b64decode(picture[1]).startswith(b"\x89PNG")
    # Nothing within the script may end it or begin another one.
    assert (text.count("<script"), text.count("</script")) == (1, 1)


@pytest.mark.usefixtures("small")
def test_the_page_is_in_the_first_cell_and_again_when_that_cell_runs_again(kernel: Any) -> None:
    shot = carom.break_shot("nine-ball")
    runs = [("a", 1), ("a", 1), ("b", 2), ("c", 3), ("a", 4), ("b", 5), ("a", 6)]
    pages = []
    for run in runs:
        kernel(*run)
        pages.append(has_page(shot._repr_html_()))
    assert pages == [True, False, False, False, True, False, True]


@pytest.mark.usefixtures("small")
def test_a_kernel_without_ids_of_cells_has_the_page_once(kernel: Any) -> None:
    shot = carom.break_shot("nine-ball")
    pages = []
    for count in range(3):
        kernel(None, count)
        pages.append(has_page(shot._repr_html_()))
    assert pages == [True, False, False]


@pytest.mark.usefixtures("small", "kernel")
def test_where_every_cell_is_a_document_of_its_own_it_has_the_whole_page(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "google.colab", SimpleNamespace())
    shot = carom.break_shot("nine-ball")
    assert shot._repr_html_() == page.iframe(shot)


@pytest.mark.usefixtures("small")
def test_the_old_place_of_show_still_works() -> None:
    with pytest.warns(FutureWarning, match=r"carom\.page\.show\(\) is now carom\.notebook\.show"):
        show: Any = page.show
    assert show is notebook.show


@pytest.mark.usefixtures("small")
def test_a_document_with_markup_cannot_end_its_cell(kernel: Any) -> None:
    shot = carom.Shot("wpa-9ft", {'</script><b>"': (0.4, 0.4)})
    text = shot._repr_html_()
    assert (text.count("<script"), text.count("</script"), text.count("<b>")) == (1, 1, 0)
