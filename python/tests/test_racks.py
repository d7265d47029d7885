"""Racks from Python: every game, reproducible, with gaps or frozen."""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any

import carom
import numpy as np
import pytest
from carom import InputError, Layout, Shot, Strike, break_shot

GAMES = {
    "eight-ball": 16,
    "nine-ball": 10,
    "ten-ball": 11,
    "straight-pool": 16,
    "snooker": 22,
    "three-cushion": 3,
}
# Largest gap of neighbours in a frozen rack, m: the rounding of their positions.
TOUCH = 1e-12


def gaps(shot: Shot) -> list[float]:
    """Distances between the surfaces of the nearest neighbours in the rack, m."""
    places = shot.simulate().at(0.0).position[1:]
    radius = float(shot.radius[1])
    distances = [float(np.linalg.norm(a - b)) - 2 * radius for a, b in combinations(places, 2)]
    return [d for d in distances if d < radius]


@pytest.mark.parametrize("game", GAMES)
def test_every_rack_has_the_balls_of_its_game(game: str) -> None:
    shot = break_shot(game)
    assert len(shot.ids) == GAMES[game]
    assert len(set(shot.ids)) == GAMES[game]
    assert shot.ids[0] == "cue"


def test_the_gaps_of_a_rack_are_about_a_tenth_of_a_millimetre() -> None:
    loose = gaps(break_shot("nine-ball", seed=1))
    assert len(loose) == 16
    assert min(loose) > 0
    assert 0.5e-4 < np.mean(loose) < 2e-4


def test_a_frozen_rack_is_frozen() -> None:
    frozen = gaps(break_shot("nine-ball", gap=0.0))
    assert len(frozen) == 16
    assert max(abs(gap) for gap in frozen) < TOUCH


def test_the_seed_determines_the_rack() -> None:
    assert break_shot("eight-ball", seed=7) == break_shot("eight-ball", seed=7)
    assert break_shot("eight-ball", seed=7) != break_shot("eight-ball", seed=8)


def test_a_rack_can_be_used_as_a_layout() -> None:
    layout = Layout.rack("nine-ball", seed=3)
    shot = Shot("wpa-9ft", layout, Strike(speed=8.0, azimuth=math.pi / 2))
    assert shot.ids == break_shot("nine-ball", seed=3).ids


@pytest.mark.parametrize(
    ("arguments", "place"),
    [
        ({"game": "nine-pin"}, "game: "),
        ({"table": "wpa-10ft"}, "table: "),
        ({"seed": -1}, "seed: "),
        ({"speed": 0.0}, "strike.speed: "),
        ({"gap": -1e-3}, "gap: "),
    ],
    ids=str,
)
def test_an_invalid_rack_is_refused_with_its_place(arguments: dict[str, Any], place: str) -> None:
    with pytest.raises(InputError) as refusal:
        break_shot(**arguments)
    assert str(refusal.value).startswith(place)


def test_every_break_preset_makes_a_shot_with_its_values() -> None:
    for preset in carom.break_presets():
        shot = carom.break_shot(preset["game"], preset=preset["name"], seed=2)
        strike = shot.to_dict()["strike"]
        assert strike["speed"] == preset["speed"]
        assert strike.get("side", 0.0) == preset["side"]
        assert strike.get("height", 0.0) == preset["height"]
        assert {source["key"] for source in preset["sources"]} >= {"place", "speed", "aim"}


def test_options_of_a_break_replace_those_of_its_preset() -> None:
    shot = carom.break_shot("nine-ball", preset="box", speed=6.0, gap=1e-4, seed=5)
    places = {ball["id"]: ball["position"] for ball in shot.to_dict()["balls"]}
    assert shot.to_dict()["strike"]["speed"] == 6.0
    assert places["cue"][0] == pytest.approx(0.635 - 8 * 0.0254)
    assert (
        places["1"] != carom.break_shot("nine-ball", preset="box").to_dict()["balls"][1]["position"]
    )


def test_break_statistics_of_a_preset_are_those_of_its_shots() -> None:
    noise = carom.Noise()
    found = carom.break_statistics("nine-ball", 3, noise=noise, preset="rail", gap=1e-4, seed=9)
    for row in range(3):
        shot = carom.break_shot("nine-ball", preset="rail", gap=1e-4, seed=9 + row)
        assert found.result.events[row] == len(shot.simulate())
    with pytest.raises(carom.InputError, match=r"preset: nine-ball has no break preset"):
        carom.break_statistics("nine-ball", 3, preset="corner")
