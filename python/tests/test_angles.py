"""Angles in degrees: given as such, and noticed where they were given as radians."""

from __future__ import annotations

import math
import pickle
import warnings
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import carom
import numpy as np
import pytest
from carom import AngleWarning, InputError, Shot, Strike

if TYPE_CHECKING:
    from collections.abc import Callable

BALLS = {"cue": (0.635, 0.635), "1": (0.635, 1.905)}


@pytest.fixture
def shot() -> Shot:
    return Shot("wpa-9ft", BALLS, Strike(2.0, 1.5))


def as_file(**strike: float) -> dict[str, Any]:
    file = Shot("wpa-9ft", BALLS).to_dict()
    return {**file, "strike": {"ball": "cue", "speed": 2.0, **strike}}


def swept(shot: Shot, azimuth: dict[str, Any], **spec: Any) -> carom.Sweep:
    vary = {"strike.azimuth": azimuth}
    return carom.Sweep.from_dict(
        {"format": "carom-sweep/1", "shots": shot.to_dict(), "vary": vary, **spec}
    )


# Seen: Strike(2.0, 90.0) played at 116.6° silently.
SILENT: dict[str, Callable[[Shot], object]] = {
    "a strike": lambda shot: Strike(2.0, 90.0),
    "with_strike": lambda shot: shot.with_strike(azimuth=90.0),
    "a batch": lambda shot: shot.batch(azimuth=[1.0, 90.0]),
    "a table of kicks": lambda shot: shot.kick_table(azimuth=[0.0, 90.0]),
    "a table of banks": lambda shot: shot.bank_table("1", azimuth=90.0),
    "a dict": lambda shot: Shot("wpa-9ft", BALLS, {"speed": 2.0, "azimuth": 90}),
    "a shot file": lambda shot: Shot.from_dict(as_file(azimuth=90.0)),
    "a grid of a sweep": lambda shot: swept(shot, {"grid": [0, 90]}),
    "steps of a sweep": lambda shot: swept(shot, {"from": 0, "to": 90, "count": 3}),
    "a draw of a sweep": lambda shot: swept(shot, {"uniform": [0, 90]}, samples=4),
    "a mean of a sweep": lambda shot: swept(shot, {"normal": [90, 1]}, samples=4),
    "a range for solve": lambda shot: shot.solve(pot="1", azimuth=(80, 90), n=9, samples=16),
    "a play": lambda shot: carom.Frame("nine-ball").play({"speed": 2.0, "azimuth": -90.0}),
}


@pytest.mark.parametrize("what", SILENT)
def test_an_azimuth_beyond_a_turn_warns_and_names_the_key_for_degrees(
    what: str, shot: Shot
) -> None:
    with pytest.warns(AngleWarning, match=r"azimuth: 90 rad .* write degrees as .*azimuth_deg"):
        SILENT[what](shot)


def test_the_warning_points_at_the_line_of_the_user(shot: Shot) -> None:
    for what in ("a strike", "with_strike", "a batch", "a dict", "a play"):
        with pytest.warns(AngleWarning) as caught:
            SILENT[what](shot)
        assert [warning.filename for warning in caught] == [__file__]


def test_no_angle_within_a_turn_and_none_in_degrees_warns(shot: Shot) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for azimuth in (-2 * math.pi, 0, 2 * math.pi, np.float64(6.28)):
            assert Strike(2.0, azimuth).azimuth == azimuth
        Strike(2.0, azimuth_deg=720.0)
        shot.batch(azimuth=np.linspace(0, 2 * math.pi, 5))
        shot.batch(azimuth_deg=[0.0, 359.0])
        shot.kick_table(azimuth_deg=[0.0, 359.0], speed=2.0, side=0.0)
        Shot.from_dict(as_file(azimuth_deg=359.0))
        swept(shot, {"grid": [0, 6.28]})


def test_the_warning_can_be_made_an_error() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", AngleWarning)
        with pytest.raises(AngleWarning):
            Strike(2.0, 90.0)


@pytest.mark.filterwarnings("ignore::carom.AngleWarning")
def test_a_recorded_or_pickled_shot_does_not_warn_again() -> None:
    frame = carom.Frame("nine-ball")
    frame.play(Strike(8.0, 7.9), cue_ball=(0.6, 0.5))
    turned = Shot("wpa-9ft", BALLS, Strike(2.0, 90.0))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert carom.Frame.replay(frame.record).balls == frame.balls
        assert pickle.loads(pickle.dumps(turned)) == turned
        assert turned.strike is not None
        assert turned.strike.azimuth == 90.0


def test_degrees_give_the_bits_of_a_file_with_degrees(shot: Shot) -> None:
    for angle in (90.0, 33.3, 271.7):
        file = Shot.from_dict(as_file(azimuth_deg=angle, elevation_deg=4.4))
        strike = Strike(2.0, azimuth_deg=angle, elevation_deg=4.4)
        assert Shot("wpa-9ft", BALLS, strike) == file
        assert shot.with_strike(azimuth_deg=angle, elevation_deg=4.4) == file
        assert (strike.azimuth_deg, strike.elevation_deg) == pytest.approx((angle, 4.4))
    degrees = shot.batch(azimuth_deg=[30.0, 60.0], elevation_deg=5.0)
    radians = shot.batch(azimuth=np.radians([30.0, 60.0]), elevation=math.radians(5.0))
    assert np.array_equal(degrees.final_position, radians.final_position)
    table = shot.kick_table(azimuth_deg=[30.0], speed=2.0, side=0.0)
    assert table.azimuth.tolist() == [math.radians(30.0)]


def test_a_strike_can_be_changed_with_replace() -> None:
    strike = Strike(2.0, azimuth_deg=90.0, side=0.1)
    assert replace(strike, speed=3.0) == Strike(3.0, azimuth_deg=90.0, side=0.1)
    assert Strike(2.0, 1.0).elevation_deg is None


def test_an_angle_in_both_units_or_in_none_is_refused(shot: Shot) -> None:
    for both in (
        lambda: Strike(2.0, 1.5, azimuth_deg=90.0),
        lambda: Strike(2.0, 1.5, 0.1, elevation_deg=5.0),
        lambda: shot.with_strike(azimuth=1.5, azimuth_deg=90.0),
        lambda: shot.batch(elevation=[0.1], elevation_deg=[5.0]),
        lambda: shot.bank_table("1", azimuth=1.5, azimuth_deg=90.0),
    ):
        with pytest.raises(InputError, match=r"gives the same angle; keep .* \(rad\) or .*_deg"):
            both()
    with pytest.raises(InputError, match=r"strike\.azimuth: is missing; give azimuth \(rad\)"):
        Strike(2.0)


def test_an_elevation_in_degrees_given_as_radians_names_the_key_for_degrees(shot: Shot) -> None:
    with pytest.raises(InputError, match=r"strike\.elevation: 45 rad .* write elevation_deg"):
        Strike(2.0, 1.5, 45.0)
    with pytest.raises(InputError, match="the key with _deg takes degrees"):
        shot.with_strike(elevation=45.0)
    assert "the key with _deg takes degrees" in shot.batch(elevation=45.0).errors[0]
