"""The shots of shots/ in which balls leave the cloth do what their names say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from carom import Shot, Trace

SHOTS = Path(__file__).parents[2] / "shots"
GRAVITY = 9.80665
RADIUS = 0.028575
CUSHION_HEIGHT = 1.27 * RADIUS
# Sampling interval of a flight, s: a ball of 5 m/s moves by 2.5 mm.
STEP = 5e-4


def played(name: str) -> Trace:
    return Shot.load(SHOTS / f"{name}.json").simulate()


def of(trace: Trace, ball: str, kind: str, *parts: str) -> list[float]:
    """Times of a ball's events of one kind; of rail collisions, only those with given parts."""
    return [
        event.time
        for event in trace.events
        if event.type == kind and ball in event.balls and (not parts or event.part in parts)
    ]


def test_the_jump_shot_passes_over_the_eight_and_pots_the_one() -> None:
    trace = played("jump_shot")
    cue, eight = trace.shot.ids.index("cue"), trace.shot.ids.index("8")
    contact = of(trace, "cue", "ball-collision")[0]
    path = trace.at(np.arange(0.0, contact, STEP))
    apart = path.position[:, cue] - path.position[:, eight]
    above = np.hypot(apart[:, 0], apart[:, 1]) < 2 * RADIUS
    assert above.any()
    assert set(path.motion[above, cue]) == {"airborne"}
    assert np.linalg.norm(apart, axis=1).min() > 2 * RADIUS
    assert trace.outcome.jumped == [["cue", "8"]]
    assert trace.outcome.first_contact == "1"
    assert trace.outcome.pocketed == [["1", "top-right"]]
    assert not trace.outcome.cue_ball_scratched


def test_the_jump_shot_struck_too_hard_ends_off_the_table() -> None:
    trace = played("off_the_table")
    assert trace.outcome.off_table == ["cue"]
    _, length = trace.shot.geometry()["size"]
    last = trace.events[-1]
    assert last.type == "off-table"
    assert last.before[0]["position"][1] > length
    assert last.before[0]["position"][2] > CUSHION_HEIGHT + RADIUS


def test_the_masse_bends_round_the_eight() -> None:
    trace = played("masse")
    contact = of(trace, "cue", "ball-collision")[0]
    path = trace.at(np.arange(0.0, contact, STEP)).position
    cue, eight, one = (path[:, trace.shot.ids.index(ball), :2] for ball in ("cue", "8", "1"))
    # The three balls are in a row along y.
    aside = cue[:, 0] - eight[:, 0]
    beside = np.abs(cue[:, 1] - eight[:, 1]) < RADIUS
    assert (aside[beside] > 2 * RADIUS).all()
    assert abs(aside[-1]) < RADIUS
    assert np.linalg.norm(cue[-1] - one[-1]) < 2 * RADIUS + STEP * 5
    assert trace.outcome.first_contact == "1"
    assert trace.outcome.jumped == []
    assert trace.outcome.rails_before_first_contact == []


def test_the_cue_ball_lands_on_the_rails_top_and_comes_back_to_the_cloth() -> None:
    trace = played("rail_top_landing")
    width, _ = trace.shot.geometry()["size"]
    landings = of(trace, "cue", "rail-collision", "top")
    assert landings
    at = trace.at(landings[0]).position[0]
    assert at[0] > width
    assert at[2] == pytest.approx(CUSHION_HEIGHT + RADIUS, abs=1e-12)
    last = trace.to_dict()["final"][0]
    assert last["motion"] == "stationary"
    assert last["position"][0] < width
    assert last["position"][2] == RADIUS
    assert trace.outcome.off_table == []


def test_the_rattling_ball_hits_both_jaws_and_is_not_pocketed() -> None:
    trace = played("rattle")
    touches = of(trace, "1", "rail-collision", "facing", "point")
    assert len(touches) >= 2
    rails = {e.rail for e in trace.events if e.time in touches}
    assert rails == {"top", "right-upper"}
    assert trace.outcome.pocketed == []
    assert trace.outcome.hanging == []
    # The ball was never over the hole.
    assert set(trace.at(np.arange(touches[0], trace.duration, STEP)).motion[:, 1]) <= {
        "sliding",
        "rolling",
        "spinning",
        "stationary",
    }


def test_the_spat_out_ball_was_in_the_pocket_and_comes_back() -> None:
    trace = played("spit_out")
    pocket = next(p for p in trace.shot.geometry()["pockets"] if p["name"] == "top-right")
    wall = of(trace, "cue", "rail-collision", "liner")
    assert wall
    at = trace.at(wall[0]).position[0]
    assert np.hypot(*(at[:2] - pocket["center"])) < pocket["radius"]
    path = trace.at(np.arange(0.0, trace.duration, STEP)).position[:, 0]
    away = np.hypot(*(path[:, :2] - pocket["center"]).T)
    over = away < pocket["radius"]
    assert path[over, 2].min() < RADIUS
    after = path[np.flatnonzero(over)[-1] :]
    assert (after[away[np.flatnonzero(over)[-1] :] > 0.5, 2] == RADIUS).any()
    assert ["cue", "top-right"] not in trace.outcome.pocketed


def test_the_hanging_ball_hangs() -> None:
    trace = played("hanging_ball")
    assert trace.outcome.hanging == [["1", "top-right"]]
    assert trace.outcome.pocketed == []
    pocket = next(p for p in trace.shot.geometry()["pockets"] if p["name"] == "top-right")
    last = np.array(trace.to_dict()["final"][1]["position"])
    beyond = np.hypot(*(last[:2] - pocket["center"])) - pocket["radius"]
    assert 0.0 <= beyond < RADIUS


def test_the_frozen_combination_pots_the_second_ball_in_one_impact() -> None:
    trace = played("frozen_combination")
    one, two = (np.array(ball["position"]) for ball in trace.shot.to_dict()["balls"][1:])
    assert np.linalg.norm(two - one) == pytest.approx(2 * RADIUS, abs=1e-9)
    impacts = [event for event in trace.events if event.type == "ball-collision"]
    assert [sorted(event.balls) for event in impacts] == [["1", "2", "cue"]]
    assert trace.outcome.pocketed == [["2", "top-right"]]


def test_the_cue_ball_of_the_follow_hop_leaves_the_cloth_at_the_contact() -> None:
    trace = played("follow_hop")
    contact = next(event for event in trace.events if event.type == "ball-collision")
    after = contact.after[contact.balls.index("cue")]
    assert after["motion"] == "airborne"
    rise = after["velocity"][2] ** 2 / (2 * GRAVITY)
    assert 3e-4 < rise < 1e-3
    # Topspin drives it forwards only after the landing, when it has contact with the cloth again.
    landing = of(trace, "cue", "slate-collision")[0]
    assert contact.time < landing
    before, later = trace.at([contact.time, trace.duration]).position[:, 0, :2]
    assert np.dot(later - before, contact.before[0]["velocity"][:2]) > 0.0
