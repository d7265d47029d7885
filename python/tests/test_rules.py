"""Frames of every game from Python: the referee itself is tested in Rust."""

import copy
import json
import math
import pickle
from collections.abc import Callable
from dataclasses import replace

import carom
import numpy as np
import pytest


def aim(frame: carom.Frame, target: str, speed: float = 2.0) -> carom.Strike:
    """A strike towards the middle of a ball."""
    cue, ball = frame.balls[frame.request.cue_ball], frame.balls[target]
    return carom.Strike(speed=speed, azimuth=math.atan2(ball[1] - cue[1], ball[0] - cue[0]))


def test_a_break_of_nine_ball_is_ruled_on() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    assert frame.request.in_hand == "behind-head-string"
    assert frame.request.on == ["1"]
    ruling = frame.play(aim(frame, "1", speed=8.0), cue_ball=(0.635, 0.5))
    assert ruling.legal
    assert ruling.trace is not None
    assert ruling.trace.outcome["first_contact"] == "1"
    assert set(ruling.trace.at(ruling.trace.duration).position.shape) == {10, 3}
    on_table = set(frame.balls) - {"cue"}
    fallen = {ball for ball, _ in ruling.trace.outcome["pocketed"]}
    assert on_table == {str(n) for n in range(1, 10)} - fallen


def test_a_push_into_a_near_ball_is_a_foul_and_a_strike_into_a_frozen_ball_is_not() -> None:
    def ruling(gap: float) -> carom.Ruling:
        places = {"cue": [0.6, 0.6], "1": [0.6, 0.6 + 2 * 0.028575 + gap], "9": [1.0, 2.0]}
        shot = carom.Shot.from_dict(
            {
                "format": "carom-shot/1",
                "table": "wpa-9ft",
                "balls": [{"id": ball, "position": place} for ball, place in places.items()],
            }
        )
        frame = carom.Frame.of_shot("nine-ball", shot)
        return frame.play(carom.Strike(speed=3.0, azimuth=math.pi / 2))

    near = ruling(1e-3)
    assert [foul.rule for foul in near.fouls] == ["WPA 6.7"]
    assert "tip was still on the cue ball" in near.fouls[0].what
    assert near.trace is not None
    assert near.trace.outcome.pushed
    assert ruling(0.0).legal


def test_the_same_seed_and_plays_give_the_same_frame() -> None:
    one, other = (carom.Frame("snooker", seed=5) for _ in range(2))
    strike = carom.Strike(speed=3.0, azimuth=math.pi / 2)
    hashes = [f.play(strike, cue_ball=(0.7, 0.6)).trace for f in (one, other)]
    assert hashes[0] is not None
    assert hashes[1] is not None
    assert hashes[0].hash == hashes[1].hash
    assert one.to_dict() == other.to_dict()


def test_a_foul_names_its_rule_and_passes_the_turn() -> None:
    frame = carom.Frame("nine-ball", seed=1)
    away = carom.Strike(speed=0.5, azimuth=-math.pi / 2)
    ruling = frame.play(away, cue_ball=(0.635, 0.5))
    assert not ruling.legal
    assert {"what": "no ball was hit", "rule": "WPA 6.3"} in ruling.fouls
    assert (frame.player, frame.request.in_hand) == (1, "anywhere")
    assert frame.fouls_in_a_row == (1, 0)


def test_a_soft_break_of_eight_ball_asks_for_a_choice() -> None:
    frame = carom.Frame("eight-ball")
    frame.play(carom.Strike(speed=1.0, azimuth=math.pi / 2), cue_ball=(0.635, 0.6))
    assert frame.request.kind == "choice"
    assert frame.request.player == 1
    before = frame.copy()
    assert frame.choose("rebreak").racked
    assert frame.request.kind == "shot"
    assert before.request.kind == "choice", "a copy goes its own way"


def test_a_move_that_is_not_allowed_is_refused_and_changes_nothing() -> None:
    frame = carom.Frame("eight-ball")
    strike = carom.Strike(speed=1.0, azimuth=1.0)
    before = frame.to_dict()
    with pytest.raises(carom.InputError, match=r"cue_ball: \[0\.6, 2\.0\] is not behind"):
        frame.play(strike, cue_ball=(0.6, 2.0))
    with pytest.raises(carom.InputError, match="call: this shot is not called"):
        frame.play(strike, call=carom.Call.pocket("1", "left"))
    with pytest.raises(carom.InputError, match=r"call\.ball: no ball has the id"):
        frame.play(strike, call=carom.Call.pocket("16", "left"))
    with pytest.raises(carom.InputError, match=r"call\.into: there is no pocket"):
        frame.play(strike, call=carom.Call.pocket("1", "middle"))
    with pytest.raises(carom.InputError, match="choice: the frame does not ask for a choice"):
        frame.choose("rebreak")
    with pytest.raises(carom.InputError, match=r'choice: "again" is not a choice; write one of'):
        frame.choose("again")
    with pytest.raises(carom.InputError, match='game: there is no game "pool"'):
        carom.Frame("pool")
    with pytest.raises(carom.InputError, match="table: eight-ball is played on a table with pock"):
        carom.Frame("eight-ball", table="carom-10ft")
    with pytest.raises(carom.InputError, match=r"options\.points: 0 is out of range"):
        carom.Frame("straight-pool", points=0)
    assert frame.to_dict() == before


@pytest.mark.parametrize("copied", [carom.Frame.copy, copy.copy, copy.deepcopy])
def test_playing_on_a_copy_does_not_change_the_frame(
    copied: Callable[[carom.Frame], carom.Frame],
) -> None:
    frame = carom.Frame("nine-ball", seed=2)
    before, twin = frame.to_dict(), copied(frame)
    twin.play(carom.Strike(speed=5.0, azimuth=math.pi / 2), cue_ball=(0.6, 0.5))
    assert twin.to_dict()["shots"] == 1
    assert frame.to_dict() == before


def test_three_cushion_is_refused_on_a_table_with_pockets() -> None:
    with pytest.raises(carom.InputError, match="table: three-cushion is played on a table without"):
        carom.Frame("three-cushion", table="wpa-9ft")


@pytest.mark.parametrize("game", carom.rule_sets())
def test_every_game_begins_and_can_be_printed(game: str) -> None:
    frame = carom.Frame(game, seed=2)
    assert frame.game == game
    assert not frame.over
    assert game in repr(frame)
    places = {None: None, "behind-head-string": (0.5, 0.3), "the-d": (0.7, 0.6)}
    strike = carom.Strike(speed=1.0, azimuth=math.pi / 2)
    call = None if "nothing" in frame.request.calls else carom.Call.safety()
    shot = frame.shot(strike, cue_ball=places[frame.request.in_hand], call=call)
    assert set(shot.ids) == set(frame.balls)


def test_the_player_who_concedes_loses() -> None:
    frame = carom.Frame("snooker")
    assert frame.state.points_left == 147
    assert frame.concede().legal
    assert frame.over
    assert frame.request.winner == 1
    with pytest.raises(carom.InputError, match="concede: the frame is over"):
        frame.concede()


def played_frame() -> carom.Frame:
    """A few shots, a choice, and a cue ball in hand."""
    frame = carom.Frame("eight-ball", seed=4, patience=50)
    soft = carom.Strike(speed=1.0, azimuth=math.pi / 2)
    frame.play(soft, cue_ball=(0.635, 0.6))
    frame.choose("rebreak")
    frame.play(aim(frame, "1", speed=9.0), cue_ball=(0.6, 0.6))
    while frame.request.kind == "choice":
        frame.choose(frame.request.choices[0])
    place = (0.3, 1.2) if frame.request.in_hand == "anywhere" else None
    frame.play(soft, cue_ball=place, call=carom.Call.safety())
    return frame


def test_a_record_survives_json_and_gives_the_same_frame() -> None:
    frame = played_frame()
    record = json.loads(json.dumps(frame.record))
    again = carom.Frame.replay(record)
    assert again.to_dict() == frame.to_dict()
    assert again.record == frame.record
    again.concede()
    assert again.over
    assert carom.Frame.replay(again.record).over
    assert len(frame.record["moves"]) == len(again.record["moves"]) - 1


def test_frames_can_be_pickled() -> None:
    shot = carom.break_shot("nine-ball", seed=2)
    of_shot = carom.Frame.of_shot("nine-ball", shot, patience=9)
    of_shot.play(aim(of_shot, "1"))
    table = {
        "base": "bar-7ft",
        "cushion_height": np.float32(0.0365),
        "rail_width": np.array(0.15),
    }
    on_table = carom.Frame("practice", table=carom.Table("bar-7ft"), seed=3)
    by_numpy = carom.Frame("practice", table=table)
    for frame in (played_frame(), of_shot, on_table, by_numpy):
        assert json.loads(json.dumps(frame.record)) == frame.record
        assert pickle.loads(pickle.dumps(frame)).to_dict() == frame.to_dict()


def test_a_copy_has_its_own_moves() -> None:
    frame = played_frame()
    before = frame.record
    frame.copy().concede()
    assert frame.record == before


def test_a_frame_refuses_or_reports_a_miscue_as_the_strike_says() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    strike = carom.Strike(speed=3.0, azimuth=math.pi / 2, side=0.55)
    with pytest.raises(carom.InputError, match=r"^strike\.side: .*miscue"):
        frame.play(strike)
    reported = replace(strike, miscue="report")
    assert frame.shot(reported).to_dict()["strike"]["miscue"] == "report"
    ruling = frame.play(reported)
    assert ruling.trace is not None
    assert ruling.trace.outcome.miscue
    (move,) = frame.record["moves"]
    assert move["play"]["strike"]["miscue"] == "report"
    assert carom.Frame.replay(frame.record).to_dict() == frame.to_dict()


def test_a_frame_refuses_or_reports_an_obstructed_cue_as_the_strike_says() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    strike = carom.Strike(speed=3.0, azimuth=math.pi / 2, elevation=0.0, obstruction="refuse")
    near_rail = (0.635, 0.04)
    with pytest.raises(carom.InputError, match=r"^strike\.elevation_deg: the cue would pass"):
        frame.play(strike, cue_ball=near_rail)
    assert frame.record["moves"] == []
    # Without an elevation the cue is raised until it clears the rail.
    frame.copy().play(replace(strike, elevation=None), cue_ball=near_rail)
    ruling = frame.play(replace(strike, obstruction="report"), cue_ball=near_rail)
    assert ruling.trace is not None
    assert ruling.trace.outcome.cue_obstructed == "bottom"
    with pytest.raises(carom.InputError, match=r"^strike\.miscue: "):
        frame.play(replace(strike, miscue="maybe"))


def test_a_frame_draws_strike_and_cling_of_the_variant_with_the_number_of_the_shot() -> None:
    noise = carom.Noise(azimuth=0.002, speed=0.05, cling_probability=0.5, cling_friction=0.3)
    frame = carom.Frame("practice", seed=3)
    clings = []
    for number in range(3):
        strike = aim(frame, next(ball for ball in frame.balls if ball != "cue"), speed=4.0)
        meant = frame.shot(strike)
        variant = noise.variant(meant, number, seed=11)
        drawn = noise.draw(meant, number, seed=11)
        ruling = frame.play(strike, noise=noise, seed=11)
        assert ruling.trace is not None
        played = ruling.trace.shot.to_dict()
        assert played["cling"] == variant.to_dict()["cling"]
        clings.append(played["cling"]["contacts"])
        written = frame.record["moves"][-1]["play"]
        assert carom.Strike(**written["strike"]) == replace(drawn, ball="cue")
        assert written["cling"] == played["cling"]
    assert clings[0] != clings[1] != clings[2]
    record = json.loads(json.dumps(frame.record))
    assert carom.Frame.replay(record).to_dict() == frame.to_dict()
    assert carom.Frame.replay(record).record == record


def test_a_record_with_variations_replays_to_the_same_bits() -> None:
    frame = carom.Frame("nine-ball", seed=5)
    frame.play(carom.Strike(speed=8.0, azimuth=math.pi / 2))
    record = json.loads(json.dumps(frame.record))
    text = '[Carom "tree/1"]\n[Layout {}]\n1. "cue" speed=8 azimuth_deg=90 {too hard}'
    record["moves"][0]["variations"] = text
    again = carom.Frame.replay(record)
    assert again.to_dict() == frame.to_dict()
    assert again.record == frame.record


def test_the_cling_of_a_record_is_played_again() -> None:
    frame = carom.Frame("nine-ball", seed=3)
    before = frame.copy()
    strike = aim(frame, "1", speed=8.0)
    frame.play(strike, noise=carom.Noise(cling_probability=1.0, cling_friction=0.9), seed=1)
    assert carom.Frame.replay(frame.record).balls == frame.balls
    without = frame.record
    del without["moves"][0]["play"]["cling"]
    before.play(strike)
    assert carom.Frame.replay(without).balls == before.balls != frame.balls
    without["moves"][0]["play"]["cling"] = {"contacts": [256]}
    with pytest.raises(carom.InputError, match=r"^moves\[0\]\.cling\.contacts\[0\]: 256 is out"):
        carom.Frame.replay(without)


def test_a_noise_without_cling_plays_the_drawn_strike() -> None:
    noise = carom.Noise.olympiad(2.0)
    frame = carom.Frame("nine-ball", seed=3)
    strike = aim(frame, "1", speed=8.0)
    by_hand = frame.copy()
    by_hand.play(noise.draw(frame.shot(strike), 0, seed=5))
    frame.play(strike, noise=noise, seed=5)
    assert frame.record == by_hand.record
    with pytest.raises(carom.InputError, match=r"^noise: found a str"):
        frame.play(strike, noise="club")  # type: ignore[arg-type]
    with pytest.raises(carom.InputError, match=r"^seed: -1 is out of range"):
        frame.play(strike, noise=noise, seed=-1)


def test_refused_moves_are_not_recorded() -> None:
    frame = carom.Frame("nine-ball")
    with pytest.raises(carom.InputError):
        frame.play(carom.Strike(speed=1.0, azimuth=0.0), cue_ball=(9.0, 9.0))
    with pytest.raises(carom.InputError):
        frame.choose("rebreak")
    assert frame.record["moves"] == []


@pytest.mark.parametrize(
    ("change", "place"),
    [
        (lambda record: record.update(format="carom-shot/1"), "format"),
        (lambda record: record.pop("moves"), "record"),
        (lambda record: record["setup"].update(colour="red"), r"setup\.colour: unknown key"),
        (lambda record: record.update(setup=[]), "setup: found "),
        (lambda record: record["setup"].pop("game"), r"setup\.game"),
        (lambda record: record["setup"].update(game="golf"), "game"),
        (lambda record: record["moves"].insert(1, {"choice": "golf"}), r"moves\[1\]"),
        (lambda record: record["moves"].append({}), r"moves\[4\]"),
        (lambda record: record["moves"][0]["play"].update(spin=1), r"moves\[0\]\.play\.spin"),
        (lambda record: record["moves"][0].update(because=1), r"moves\[0\]\.because"),
        (lambda record: record["moves"][0]["play"]["strike"].pop("speed"), r"moves\[0\]\.play"),
    ],
)
def test_a_damaged_record_is_refused_with_the_place(
    change: Callable[[dict[str, object]], object], place: str
) -> None:
    record = played_frame().record
    change(record)
    with pytest.raises(carom.InputError, match=f"^{place}"):
        carom.Frame.replay(record)


def after_a_scratch_on_the_break() -> carom.Frame:
    """A game of eight-ball after a break that would be legal if the cue ball had not fallen."""
    place = (0.3, 0.6)
    for seed in range(1000):
        frame = carom.Frame("eight-ball", seed=seed)
        object_balls = {ball: at for ball, at in frame.balls.items() if ball != "cue"}
        x, y = min(object_balls.values(), key=lambda at: at[1])
        azimuth = math.atan2(y - place[1], x - place[0])
        level = carom.Strike(speed=9.0, azimuth=azimuth, elevation=0.0)
        ruling = frame.play(level, cue_ball=place)
        scratched = [foul["what"] for foul in ruling.fouls] == ["the cue ball was pocketed"]
        if scratched and frame.request.kind == "shot":
            return frame
    raise AssertionError("no break scratches")


def test_a_record_with_the_old_choice_after_a_scratch_on_the_eight_ball_break_replays() -> None:
    # Before, the frame asked for a choice with the one option "play-from-hand" here.
    frame = after_a_scratch_on_the_break()
    assert frame.request.in_hand == "behind-head-string"
    choice = {"choice": "play-from-hand"}
    old = frame.record
    old["moves"].append(choice)
    again = carom.Frame.replay(old)
    assert again.to_dict() == frame.to_dict()
    assert again.record == frame.record
    # It is skipped only there.
    for moves, index in (([choice, *frame.record["moves"]], 0), ([*old["moves"], choice], 2)):
        with pytest.raises(carom.InputError, match=rf"^moves\[{index}\]\.choice"):
            carom.Frame.replay(old | {"moves": moves})


def test_the_old_name_of_the_winning_points_works_in_calls_and_records() -> None:
    with pytest.warns(FutureWarning, match=r"Frame\(target=\.\.\.\) is now Frame\(points="):
        frame = carom.Frame("straight-pool", target=50)  # type: ignore[call-arg]
    record = frame.record
    assert record["setup"]["points"] == 50
    record["setup"]["target"] = record["setup"].pop("points")
    assert carom.Frame.replay(record).record == frame.record


def test_a_record_has_the_dated_names_of_presets() -> None:
    setup = carom.Frame("nine-ball").record["setup"]
    assert setup["table"] == "wpa-9ft-2026-12"
    # The table's dated name implies its physics.
    assert "physics" not in setup
    setup = carom.Frame("nine-ball", physics="ideal").record["setup"]
    assert setup["physics"] == "ideal-2026-11"
    table = {"length": 2.84, "width": 1.42}
    frame = carom.Frame("three-cushion", table=table)
    assert frame.record["setup"]["physics"] == "pool-2026-12"
    assert carom.Frame.replay(frame.record).to_dict() == frame.to_dict()
