"""The page of a learned table."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from carom import learn
from carom.errors import InputError
from carom.learn import FitReport, ModelScore, filmed_strikes, fit_report
from carom.learn.report_curves import coefficients, rolling_deceleration, throw
from carom.learn.report_page import report_html
from carom.learn.table_model import TableModel
from tests.test_learn_table import three_cushion_shots

NAMES = ("rolling.a", "cushion.restitution.a")


@pytest.fixture(scope="module")
def report() -> FitReport:
    film = learn.synthetic(three_cushion_shots(3), clock_offset=0.3, seed=1)
    first = learn.Posterior.of(
        TableModel("carom-10ft", "carom", NAMES, 0.03075),
        np.array([0.048, 0.88]),
        np.array([[[40.0, 2.0], [2.0, 30.0]]] * 3),
        np.array([[1.0, -1.0], [-2.0, 0.5], [1.0, 0.5]]),
    )
    found = learn.strikes(film.tracks[:2], first, starts=8)
    models = [ModelScore("han-2005", -118.1, 4.0), ModelScore("<stronge>", -120.3, 4.2)]
    return fit_report(film.tracks, first, found, models)


def test_the_page_has_every_number_shot_and_model_and_loads_nothing(report: FitReport) -> None:
    page = report_html(report, title="A & B")
    assert "<title>A &amp; B · carom</title>" in page
    assert "&lt;stronge&gt;" in page
    assert not re.search(r'(?:src|href)="(?!#)|@import', page)
    for name in (*NAMES, *(shot.name for shot in report.shots)):
        assert f'<th scope="row">{name}</th>' in page
    assert report.missing == ("3",)
    assert "no strike explains it" in page
    assert page == report_html(report, title="A & B")


def test_every_element_of_the_page_is_closed_and_has_an_id_of_its_own(report: FitReport) -> None:
    class Checker(HTMLParser):
        opened: list[str]
        ids: list[str]

        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            self.ids += [str(value) for key, value in attrs if key == "id"]
            if tag not in ("meta", "!doctype"):
                self.opened.append(tag)

        def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            self.ids += [str(value) for key, value in attrs if key == "id"]

        def handle_endtag(self, tag: str) -> None:
            assert self.opened.pop() == tag

    checker = Checker()
    checker.opened, checker.ids = [], []
    checker.feed(report_html(report, title="A"))
    assert checker.opened == []
    assert len(checker.ids) == len(set(checker.ids)) > 5


def test_the_rolling_curve_of_the_preset_is_that_of_the_engine() -> None:
    values = coefficients({"base": "carom"})
    found = rolling_deceleration(values, np.array([0.1, 1.0]))
    np.testing.assert_allclose(found, 0.0410 + 0.0142 * np.array([0.1, 1.0]), rtol=0.1)


def test_balls_without_friction_are_not_thrown() -> None:
    physics = {"base": "carom", "ball_ball": {"friction": 0.0}}
    np.testing.assert_allclose(throw(physics, np.radians([10.0, 50.0]), None), 0.0, atol=2e-3)
    assert (throw({"base": "carom"}, np.radians([20.0, 40.0]), None) > 0.01).all()


def test_a_report_searches_no_strike_that_the_fit_has_found(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tracks = learn.synthetic(three_cushion_shots(3), clock_offset=0.3, seed=1).tracks
    learned = learn.table(tracks, free=NAMES, rounds=2, starts=20)
    assert set(learned.strikes) == {"1", "2", "3"}
    searched = {one.name: one for one in learn.strikes(tracks, learned, starts=20)}

    def refuse(*_: Any) -> None:
        raise AssertionError("a strike was searched")

    monkeypatch.setattr(filmed_strikes, "search", refuse)
    for shot in fit_report(tracks, learned).shots:
        # Half a millimetre: both are minima, in which the noise of 1 mm remains.
        assert shot.strike.rmse < searched[shot.name].rmse + 0.0005
    learned.save(tmp_path / "learned.json")
    with pytest.raises(AssertionError, match="was searched"):
        fit_report(tracks, learn.Posterior.load(tmp_path / "learned.json"))


def test_strikes_that_are_known_already_are_checked() -> None:
    tracks = learn.synthetic(three_cushion_shots(1), seed=1).tracks
    for strike in ([1.0, 2.0], [np.nan] * 6, "fast"):
        with pytest.raises(InputError, match=r"begin\['1'\]"):
            learn.strikes(tracks, begin={"1": strike})  # type: ignore[dict-item]


def test_a_posterior_writes_its_page(report: FitReport, tmp_path: Path) -> None:
    film = learn.synthetic(three_cushion_shots(3), clock_offset=0.3, seed=1)
    found = [shot.strike for shot in report.shots]
    report.posterior.report(tmp_path / "out.html", film.tracks, found=found)
    assert (tmp_path / "out.html").read_text().startswith("<!doctype html>")
