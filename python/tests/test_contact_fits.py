"""The stored fits of rails and ball surfaces are those that the engine gives."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType
from typing import Any

import carom
import pytest
from carom.validation.alciatore_throw_tests.rows import CHALK
from carom.validation.alciatore_tp_rail import rows as rail_rows
from carom.validation.lab import MPH
from carom.validation.wpa_specifications.rows import lengths_travelled

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "scripts"
STORED = json.loads((SCRIPTS / "contact_fits.json").read_text(encoding="utf-8"))
#: Stored residuals are rounded to four digits.
ROUNDED = 6e-5


def _script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("fit_contacts", SCRIPTS / "fit_contacts.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


FIT = _script()


def values(preset: str) -> dict[str, Any]:
    """The values of a preset as a shot file has them."""
    return next(entry["physics"] for entry in carom.physics() if entry["name"] == preset)


def has(whole: Any, part: Any) -> bool:
    """Whether `whole` has the values of `part`; it may have more keys."""
    if isinstance(part, dict):
        return all(has(whole[key], value) for key, value in part.items())
    return bool(whole == part)


def same(stored: dict[str, Any], residuals: list[float]) -> None:
    """The stored residuals are these, and the stored summary describes them."""
    assert list(stored["residuals"].values()) == pytest.approx(residuals, abs=ROUNDED)
    assert stored["largest"] == pytest.approx(max(map(abs, residuals)), abs=ROUNDED)


def test_surfaces_have_their_stored_throw() -> None:
    surfaces = STORED["surfaces"]
    same(surfaces["dirty"], FIT.residuals_2014(surfaces["dirty"]["friction"]))
    same(surfaces["used"], FIT.residuals_2006(surfaces["used"]["friction"]))
    same(surfaces["clean"], [FIT.at_45_slow(surfaces["clean"]["friction"]) - FIT.CLEANER])
    assert surfaces["used"]["cannot fit"] == FIT.cannot_fit_2006()
    assert pytest.approx(surfaces["chalked"]["friction"], abs=2e-3) == CHALK


@pytest.mark.parametrize("name", ["clean", "used", "dirty"])
def test_a_named_surface_is_the_stored_friction(name: str) -> None:
    friction = STORED["surfaces"][name]["friction"]
    for cut, speed in ((45.0, 0.447), (20.0, 3.0)):
        named = FIT.throw(cut, speed, FIT.with_friction(name))
        assert named == FIT.throw(cut, speed, FIT.with_friction(friction))


def test_snooker_balls_have_their_stored_motion() -> None:
    film = STORED["snooker"]["film"]
    same(film, FIT.residuals_snooker(film["friction"], film["restitution"]))
    assert film["outside"] == []
    fitted = {k: film[k] for k in ("restitution", "friction")}
    assert has(values("snooker")["ball_ball"], fitted)


def test_the_source_of_the_snooker_balls_names_their_largest_errors() -> None:
    film = STORED["snooker"]["film"]
    # Per shot: speeds of cue ball and object ball, m/s, and the direction of the cue ball, °.
    found = [abs(x) for x in FIT.residuals_snooker(film["friction"], film["restitution"])]
    angles = found[2::3]
    speeds = [x for k, x in enumerate(found) if k % 3 != 2]
    said = f"within {max(speeds):.3f} m/s and {max(angles):.2f}°"
    (snooker,) = (preset for preset in carom.physics() if preset["name"] == "snooker")
    for parameter in snooker["parameters"]:
        if parameter["key"].startswith("ball_ball.") and "filmed" in parameter["source"]:
            assert said in parameter["source"], parameter["key"]
    assert said in (ROOT / "crates/carom/src/physics/presets.rs").read_text(encoding="utf-8")


def test_the_comment_of_the_pool_rails_has_their_table_lengths() -> None:
    pool, gold_crown, valley = (
        lengths_travelled(10 * MPH, preset) for preset in ("pool", "pool-gold-crown", "pool-valley")
    )
    source = (ROOT / "crates/carom/src/physics/presets.rs").read_text(encoding="utf-8")
    text = " ".join(source.replace("///", " ").split())
    assert f"travels {pool:.1f} lengths of a 9 ft table" in text
    assert f"below {gold_crown:.1f} (Gold Crown) and {valley:.1f} (Valley)" in text
    page = (ROOT / "docs" / "rails-and-balls.md").read_text(encoding="utf-8")
    assert f"travels {pool:.1f} table lengths" in page
    assert f"({valley:.1f} on `pool-valley`, {gold_crown:.1f} on `pool-gold-crown`)" in page


@pytest.mark.parametrize("table", FIT.TABLES)
def test_a_table_has_its_stored_banks(table: str) -> None:
    for stored in (STORED["banks"][table], STORED["banks"][f"{table}, constant restitution"]):
        same(stored, FIT.residuals_banks(table, stored["cushion"]))
        assert stored["outside"] == []


def test_the_three_tables_differ_in_the_friction_of_their_rails_alone() -> None:
    cushions = [dict(STORED["banks"][table]["cushion"]) for table in FIT.TABLES]
    for table, cushion in zip(FIT.TABLES, cushions, strict=True):
        _, preset = rail_rows.TABLES[table]
        assert has(values(preset)["cushion"], cushion)
        cushion.pop("friction")
    assert cushions[0] == cushions[1] == cushions[2]


def test_the_presets_have_the_stored_fits() -> None:
    for preset, name in (
        ("pool", "used"),
        ("pool-clean-balls", "clean"),
        ("pool-dirty-balls", "dirty"),
    ):
        fitted = STORED["surfaces"][name]["friction"]
        assert has(values(preset)["ball_ball"]["friction"], fitted)
    assert has(values("snooker")["cushion"], STORED["film"]["stronge"]["cushion"])
    # The preset has a limit for balls that are faster than those of the match.
    tracked = STORED["tracked"]["han-2005"]["cushion"]
    law = {k: v for k, v in tracked["restitution"].items() if k in "abc"}
    assert has(values("carom")["cushion"], tracked | {"restitution": law})


@pytest.mark.parametrize("model", STORED["film"])
def test_a_model_has_its_stored_rebounds_of_the_film(model: str) -> None:
    stored = STORED["film"][model]
    same(stored, FIT.residuals_film(stored["cushion"]))
    # Han's rigid nose cannot return as much as the film shows, whatever its restitution.
    assert bool(stored["outside"]) == (model == "han-2005")


def test_the_tracked_rails_are_laws_of_a_shot_file() -> None:
    for stored in STORED["tracked"].values():
        carom.Physics.preset("carom", cushion=stored["cushion"])
