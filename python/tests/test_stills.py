"""Pictures of balls before they move: of a shot, and of a frame."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import carom
import pytest
from carom import InputError, Shot, Strike, picture

if TYPE_CHECKING:
    from pathlib import Path

SHOT = Shot("wpa-9ft", {"cue": (0.5, 0.6), "1": (0.5, 1.6), "9": (0.9, 1.9)}, Strike(2.0, 1.5708))


def ids(path: Path) -> set[str]:
    return set(re.findall(r'id="((?:ball|on|ghost|hand|aim|cue)[^"]*)"', path.read_text("utf-8")))


# Seen: "give carom.BreakStatistics".
def test_a_shot_is_drawn_with_its_balls_its_cue_and_its_aim(tmp_path: Path) -> None:
    picture.save(SHOT, tmp_path / "shot.svg")
    drawn = {"ball-cue", "ball-1", "ball-9", "ghost-ball", "aim", "cue"}
    assert drawn <= ids(tmp_path / "shot.svg")
    picture.save(SHOT, tmp_path / "shot.png")
    assert (tmp_path / "shot.png").read_bytes().startswith(b"\x89PNG")


def test_the_line_of_aim_ends_where_the_ball_meets_the_first_ball_or_a_rail() -> None:
    def ghost(shot: Shot) -> tuple[float, float]:
        (ring,) = [
            artist
            for artist in picture.still.draw_shot(shot).findobj()
            if artist.get_gid() == "ghost-ball"
        ]
        x, y = ring.center
        return x, y

    radius = 0.028575
    assert ghost(SHOT) == pytest.approx((0.5, 1.6 - 2 * radius), abs=1e-3)
    away = SHOT.with_strike(azimuth=0.0)
    assert ghost(away) == pytest.approx((1.27 - radius, 0.6), abs=1e-9)
    met = next(e for e in SHOT.simulate().events if e.type == "ball-collision")
    assert ghost(SHOT) == pytest.approx(met.before[0].position[:2], abs=1e-3)


def test_a_frame_is_drawn_with_the_balls_on_and_the_region_of_the_hand(tmp_path: Path) -> None:
    for game, on in (("nine-ball", {"on-1"}), ("three-cushion", {"on-red"})):
        picture.save(carom.Frame(game), tmp_path / f"{game}.svg", title="a frame")
        found = ids(tmp_path / f"{game}.svg")
        assert {name for name in found if name.startswith("on-")} == on
        assert ("hand" in found) == (game == "nine-ball")
    over = carom.Frame("snooker")
    over.concede()
    picture.save(over, tmp_path / "over.png")


def test_shots_without_a_strike_and_without_rails_are_drawn(tmp_path: Path) -> None:
    moving = [
        {"id": "a", "position": [0, 0], "velocity": [1, 0, 0]},
        {"id": "b", "position": [1, 0]},
    ]
    picture.save(Shot({"cloth": "unbounded"}, moving), tmp_path / "moving.svg")
    assert "cue" not in ids(tmp_path / "moving.svg")
    struck = Shot({"cloth": "unbounded"}, {"cue": (0, 0)}, Strike(1.0, 0.3))
    picture.save(struck, tmp_path / "struck.svg")
    assert {"cue", "aim"} <= ids(tmp_path / "struck.svg")


def test_the_same_shot_gives_the_same_file(tmp_path: Path) -> None:
    for name in ("a.svg", "b.svg"):
        picture.save(SHOT, tmp_path / name)
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_what_cannot_be_drawn_is_refused_with_all_that_can(tmp_path: Path) -> None:
    with pytest.raises(
        InputError, match=r"^found: found a int; give a carom\.Shot, a carom\.Frame"
    ):
        picture.save(5, tmp_path / "x.png")  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"^title: "):
        picture.save(SHOT, tmp_path / "x.png", title=5)  # type: ignore[arg-type]
