"""Rolling resistance in bands of speed, from Python."""

from __future__ import annotations

import math
from typing import Any

import carom
import numpy as np
import pytest

GRAVITY = 9.80665
RADIUS = 0.03075
#: Heated carom cloth: deceleration at speed 0, m/s², and its growth, 1/s.
LAW = (0.0410, 0.0142)


def shot(friction: Any, speed: float) -> carom.Shot:
    ball = {
        "id": "cue",
        "position": [0.0, 0.0],
        "velocity": [0.0, speed, 0.0],
        "angular_velocity": [-speed / RADIUS, 0.0, 0.0],
    }
    physics = carom.Physics.preset("carom", cloth={"rolling_friction": friction})
    return carom.Shot(carom.Table.unbounded(), [ball], physics=physics)


def distance(speed: float) -> float:
    a, b = LAW
    return (speed - a / b * math.log(1 + b * speed / a)) / b


@pytest.mark.parametrize(("share", "least"), [(0.01, 0.01), (0.005, 0.005), (0.002, 0.01)])
def test_bands_of_a_law_stop_balls_where_the_law_does(share: float, least: float) -> None:
    bands = carom.rolling_bands(*LAW, share=share, least=least)
    for speed in np.linspace(0.05, 3.0, 60):
        end = carom.simulate_batch([shot(bands, float(speed))]).final_position[0, 0, 1]
        exact = distance(float(speed))
        assert -1e-9 <= exact - end <= 1.001 * max(share * exact, least)


def test_bands_have_the_constant_that_takes_the_distance_of_the_law() -> None:
    bands = carom.rolling_bands(*LAW)
    assert isinstance(bands, list)
    low = 0.0
    for band in bands:
        high = band.get("up_to", 3.0)
        roll = (high**2 - low**2) / (2 * GRAVITY * band["friction"])
        assert roll == pytest.approx(distance(high) - distance(low), rel=1e-11)
        low = high
    assert "up_to" not in bands[-1]
    assert [*map(sorted, bands[:-1])] == [["friction", "up_to"]] * (len(bands) - 1)


def test_a_law_without_growth_is_a_number() -> None:
    assert carom.rolling_bands(0.0981, 0.0, gravity=9.81) == pytest.approx(0.01, rel=1e-15)


@pytest.mark.parametrize(
    ("arguments", "place"),
    [
        ({"a": 0.0}, "a"),
        ({"b": -1.0}, "b"),
        ({"b": math.nan}, "b"),
        ({"fastest": 0.0}, "fastest"),
        ({"share": -0.1}, "share"),
        ({"least": 0.0}, "least"),
        ({"gravity": math.inf}, "gravity"),
        ({"a": "0.04"}, "a"),
        ({"share": 1e-5, "least": 1e-5}, "share"),
    ],
)
def test_a_value_out_of_range_is_refused_by_name(arguments: dict[str, Any], place: str) -> None:
    given: dict[str, Any] = {"a": LAW[0], "b": LAW[1], **arguments}
    with pytest.raises(carom.InputError, match=rf"^{place}: "):
        carom.rolling_bands(**given)


def test_a_trace_is_exact_at_the_end_of_a_band_and_between() -> None:
    friction = [{"up_to": 0.5, "friction": 0.004}, {"friction": 0.008}]
    trace = shot(friction, 1.0).simulate()
    (end,) = [e for e in trace.events if e.get("from") == e.get("to") == "rolling"]
    assert end["after"][0]["velocity"] == [0.0, 0.5, 0.0]
    assert end["time"] == pytest.approx(0.5 / (0.008 * GRAVITY), rel=1e-14)
    for after in (0.0, 0.1, 3.0):
        now = trace.at(end["time"] + after)
        assert now.velocity[0, 1] == pytest.approx(0.5 - 0.004 * GRAVITY * after, rel=1e-13)
    assert carom.Trace.from_dict(trace.to_dict()).hash == trace.hash
    assert "rolling→rolling" in str(trace)


def test_a_wider_band_of_less_resistance_gives_a_longer_roll() -> None:
    lists = [[{"up_to": end, "friction": 0.004}, {"friction": 0.008}] for end in (0.2, 0.8)]
    found = carom.simulate_batch([shot(bands, 1.0) for bands in lists]).final_position[:, 0, 1]
    assert found[1] > found[0] > 0.0
