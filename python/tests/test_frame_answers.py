"""What a program needs to play a frame: text, schemas, plain answers, and errors for each seat."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import carom
import jsonschema
import pytest
from carom import Call, Frame, InputError, Noise, Shot, Strike

if TYPE_CHECKING:
    from pathlib import Path

BREAK = {"speed": 8.0, "azimuth_deg": 90.0}


def broken() -> Frame:
    """Eight-ball after a break, with the cue ball where it lies."""
    for seed in range(20):
        frame = Frame("eight-ball", seed=seed)
        frame.play(BREAK, cue_ball=(0.635, 0.6))
        if frame.request.kind == "shot" and frame.request.in_hand is None:
            return frame
    raise AssertionError("every break pocketed the cue ball")


def validator(schema: dict[str, Any]) -> jsonschema.Draft202012Validator:
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def test_a_play_may_be_a_dict() -> None:
    one, other = Frame("nine-ball", seed=7), Frame("nine-ball", seed=7)
    ruling = one.play(BREAK, cue_ball=[0.635, 0.6], call={"kind": "nothing"})
    same = other.play(Strike(8.0, azimuth_deg=90.0), cue_ball=(0.635, 0.6))
    assert ruling == same
    assert one.record == other.record
    called = {"kind": "pocket", "ball": "8", "into": "left"}
    shot = broken().shot({"speed": 2, "azimuth_deg": 3}, call=called)
    assert shot.azimuth == pytest.approx(0.05236, abs=1e-5)


def test_a_play_of_another_form_is_refused_with_its_place() -> None:
    frame = Frame("nine-ball", seed=7)
    before = frame.record
    for play, place in [
        ({"azimuth_deg": 90}, r"strike\.speed: is missing"),
        ({"speed": 2}, r"strike\.azimuth: is missing"),
        ({"speed": 2, "azimut": 3}, r"strike\.azimut: unknown key; did you mean `azimuth`"),
        (Shot("wpa-9ft", {"cue": (0.4, 0.4)}), r"strike: found a Shot; give carom\.Strike"),
    ]:
        with pytest.raises(InputError, match=f"^{place}"):
            frame.play(play)  # type: ignore[arg-type]
    for call, place in [
        ({"kind": "corner"}, r"call\.kind: "),
        ({"ball": "3"}, r"call\.kind: is missing"),
        ({"kind": "safety", "pocket": "left"}, r"call\.pocket: unknown key"),
        ("safety", r"call: found a str; give carom\.Call"),
    ]:
        with pytest.raises(InputError, match=f"^{place}"):
            frame.play(BREAK, cue_ball=(0.6, 0.5), call=call)  # type: ignore[arg-type]
    assert frame.record == before


def test_nothing_among_the_calls_is_a_call_that_may_be_passed() -> None:
    frame = Frame("nine-ball", seed=7)
    assert frame.request.calls == ["nothing"]
    frame.play(BREAK, cue_ball=(0.635, 0.6), call=Call(frame.request.calls[0]))
    assert "call" not in frame.record["moves"][0]["play"]
    with pytest.raises(InputError, match=r"^call: nothing is called; call a ball"):
        broken().play(BREAK, call=Call("nothing"))


def test_the_winner_can_be_read_at_any_time() -> None:
    frame = broken()
    assert frame.winner is None
    assert frame.request.winner is None
    seat = frame.player
    frame.concede()
    assert seat is not None
    assert frame.winner == frame.request.winner == 1 - seat
    assert frame.request.player is frame.player is None
    assert (frame.request.on, frame.request.calls, frame.request.in_hand) == ((), (), None)
    with pytest.raises(AttributeError, match="no 'winer' here; there are: kind, winner, why"):
        _ = frame.request.winer  # type: ignore[attr-defined]
    assert {"kind", "winner", "on"} <= set(dir(frame.request))


def test_the_bounds_of_the_hand_are_those_of_the_refusal() -> None:
    frame = Frame("nine-ball", seed=7)
    assert frame.hand_bounds == ((0.0, 0.0), (1.27, 0.635))
    with pytest.raises(InputError, match=r"behind the head string; put it where y < 0\.635 m$"):
        frame.play(BREAK, cue_ball=(0.6, 1.0))
    assert Frame("three-cushion").hand_bounds is None


def test_table_physics_and_geometry_of_a_frame_can_be_read() -> None:
    frame = Frame("snooker", table=carom.Table.preset("snooker-12ft", length=3.5))
    assert frame.geometry()["size"] == [1.778, 3.5]
    shot = frame.shot(BREAK, cue_ball=(0.889, 0.5))
    assert shot.table == frame.table
    assert Frame.of_shot("snooker", shot).physics == frame.physics == carom.Physics("snooker")


def test_the_text_of_a_frame_is_its_description() -> None:
    frame = broken()
    text = frame.describe()
    assert str(frame) == text
    for ball, (x, y) in frame.balls.items():
        assert f" {ball} ({x:.4f}, {y:.4f})" in text
    assert f"Player {frame.player} shoots" in text
    assert "Call: a ball and its pocket, or a safety; required." in text


def test_every_decision_of_a_player_follows_the_schemas_of_its_request() -> None:
    any_play = validator(carom.schema("play"))
    for game in carom.rule_sets():
        frame = Frame(game, seed=5, points=2)
        player = carom.Player("greedy")
        for _ in range(6):
            if frame.over:
                break
            decision = player.choose(frame).to_dict()
            answer = {
                key: decision[key] for key in ("play", "choice", "concede") if key in decision
            }
            answer = json.loads(json.dumps(answer))
            validator(frame.answer_schema()).validate(answer)
            if "play" in answer:
                any_play.validate(answer["play"])
            frame.answer(answer)


def test_what_the_schema_of_a_request_refuses_is_refused_by_the_frame() -> None:
    frame = broken()
    schema = validator(frame.answer_schema())
    safety = {"kind": "safety"}
    good = {"play": {"strike": {"speed": 1, "azimuth_deg": 90}, "call": safety}}
    schema.validate(good)
    for bad in [
        {"play": {"strike": {"speed": 1, "azimuth_deg": 90}}},
        {"play": {"strike": {"speed": 1, "azimuth_deg": 90}, "call": {"kind": "push-out"}}},
        {"play": {"strike": {"speed": 0, "azimuth_deg": 90}, "call": safety}},
        {"play": {"strike": {"speed": 1, "azimuth_deg": 9, "azimuth": 1}, "call": safety}},
        {"play": {"strike": {"speed": 1}, "call": safety}},
        {"play": {"call": safety}},
        {"play": {"strike": BREAK, "call": {"kind": "pocket", "ball": "cue", "into": "left"}}},
        {"play": {"strike": BREAK, "call": {"kind": "pocket", "ball": "99", "into": "left"}}},
        {"play": {"strike": BREAK, "call": safety, "cling": {}}},
        {"play": {"strike": BREAK, "call": safety, "cue_ball": [-1.0, 0.3]}},
        {"choice": "play-on"},
        {"concede": False},
        {},
        {"play": good["play"], "concede": True},
        {"pass": True},
        [],
    ]:
        assert not schema.is_valid(bad), bad
        with pytest.raises(InputError):
            frame.copy().answer(bad)  # type: ignore[arg-type]
    assert frame.answer(good).trace is not None


def test_a_decision_of_ones_own_is_applied_with_the_errors_of_its_seat() -> None:
    noise, seeds = Noise.preset("club"), (5, 6)
    frame, by_hand = Frame("nine-ball", seed=2), Frame("nine-ball", seed=2)
    break_ = carom.Play(carom.Strike(8.0, 1.57), (0.6, 0.5))
    carom.Decision(break_).apply(frame, noise=noise, seed=seeds)
    by_hand.play(break_.strike, cue_ball=break_.cue_ball, noise=noise, seed=seeds)
    assert frame.hash == by_hand.hash
    meant = Frame("nine-ball", seed=2)
    carom.Decision(break_).apply(meant)
    assert meant.hash != frame.hash

    scratched = Frame("eight-ball", seed=3)
    scratched.play(carom.Strike(1.0, 1.57), cue_ball=(0.6, 0.5))
    twin = scratched.copy()
    choice = scratched.request.choices[0]
    assert carom.Decision(choice=choice).apply(scratched).trace is None
    assert carom.Decision().concession
    carom.Decision().apply(twin)
    assert twin.over


def test_an_unknown_pocket_is_refused_under_the_key_that_a_call_has() -> None:
    # Seen: the error named `call.pocket`, and the key is `into`.
    frame = Frame("ten-ball", seed=1)
    frame.play(carom.Strike(8.0, 1.57), cue_ball=(0.6, 0.5))
    if frame.request.kind == "choice":
        frame.choose("play-on")
    call = {"kind": "pocket", "ball": "1", "into": "corner"}
    with pytest.raises(InputError, match=r'^call\.into: there is no pocket "corner"; write one of'):
        frame.play(carom.Strike(2.0, 1.0), call=call)


def test_an_answer_may_be_a_choice_or_a_concession() -> None:
    frame = Frame("eight-ball", seed=1)
    frame.answer({"play": {"strike": {"speed": 1.0, "azimuth_deg": 90}, "cue_ball": [0.6, 0.5]}})
    assert frame.request.kind == "choice"
    choice = validator(frame.answer_schema())
    assert all(choice.is_valid({"choice": name}) for name in frame.request.choices)
    assert not choice.is_valid({"choice": "spot-frozen"})
    frame.answer({"choice": "play-on"})
    frame.answer({"concede": True})
    assert frame.over
    assert not validator(frame.answer_schema()).is_valid({"concede": True})


def test_a_frame_with_a_frozen_cue_ball_asks_whether_to_spot() -> None:
    diameter = 0.0615
    balls = {"cue": (0.7, 0.7), "yellow": (0.7 + diameter, 0.7), "red": (0.7, 2.13)}
    frame = Frame.of_shot("three-cushion", Shot("carom-10ft", balls))
    assert frame.request.choices == ["play-on", "spot-frozen"]
    decision = carom.Player("carom:200").choose(frame)
    assert decision.choice in frame.request.choices


def test_the_yellow_of_a_struck_shot_is_the_second_players() -> None:
    balls = {"cue": (0.7, 0.7), "yellow": (0.3, 0.3), "red": (0.7, 2.13)}
    strike = {"ball": "yellow", "speed": 2.0, "azimuth_deg": 60.0}
    yellow = Shot("carom-10ft", balls, strike)
    frame = Frame.of_shot("three-cushion", yellow)
    assert (frame.request.player, frame.request.cue_ball) == (1, "yellow")
    frame.play(Strike(speed=2.0, azimuth=1.0))
    assert frame.record["setup"]["player"] == 1
    assert Frame.replay(frame.record).hash == frame.hash
    decision = carom.Player("carom:200").choose(Frame.of_shot("three-cushion", yellow))
    assert isinstance(decision.play, carom.Play)
    white = Frame.of_shot("three-cushion", yellow, player=0)
    assert (white.request.player, white.request.cue_ball) == (0, "cue")
    # A record of before this key began with the first player.
    assert "player" not in white.record["setup"]
    assert Frame.replay(white.record).request.player == 0
    with pytest.raises(InputError, match=r"^player: "):
        Frame.of_shot("three-cushion", yellow, player=2)


def seeds_of(line: dict[str, Any]) -> tuple[int, int]:
    one, other = (int(seed, 16) for seed in line["seeds"]["errors"])
    return one, other


def called(play: dict[str, Any]) -> Call | None:
    call = play.get("call")
    return call and Call(call["kind"], call.get("ball"), call.get("pocket"))


@pytest.mark.parametrize("game", ["nine-ball", "eight-ball"])
def test_two_seeds_give_the_errors_of_a_match_to_the_bit(game: str, tmp_path: Path) -> None:
    clinging = Noise(0.1, 0.004, 0.01, 0.002, 0.002, cling_probability=0.5)
    result = carom.play_match(
        "greedy",
        "level-1",
        game=game,
        pairs=1,
        noise=(clinging, Noise.preset("club")),
        points=1,
        out=tmp_path / "match",
        secret="5" * 64,
    )
    assert result.record is not None
    header, *lines, _ = map(json.loads, result.record.read_text(encoding="utf-8").splitlines())
    noises = [Noise(**noise) for noise in header["noise"]]
    shots = clung = 0
    for line in lines:
        frame = Frame(game, seed=int(line["seeds"]["rack"], 16), **header["options"])
        for move in line["moves"]:
            assert move["seat"] == frame.player
            if "choice" in move:
                frame.choose(move["choice"])
                continue
            play = move["play"]
            ruling = frame.play(
                play["strike"],
                cue_ball=play.get("cue_ball"),
                call=called(play),
                noise=noises[line["seats"][move["seat"]]],
                seed=seeds_of(line),
            )
            assert ruling.trace is not None
            assert ruling.trace.hash == move["trace"]
            played = frame.record["moves"][-1]["play"]
            assert played["strike"] == move["executed"]["strike"]
            assert played.get("cling") == move["executed"].get("cling")
            shots += 1
            clung += "cling" in played
        assert frame.winner == line["end"]["winner"] or line["seats"] == [1, 0]
    assert shots > 10
    assert clung > 0


def test_seeds_that_are_not_one_or_two_are_refused() -> None:
    noise = Noise.preset("club")
    for seed, place in [
        ((1, 2, 3), "seed: found 3 seeds"),
        ((1, -1), r"seed\[1\]: "),
        ("12", "seed: "),
    ]:
        with pytest.raises(InputError, match=f"^{place}"):
            Frame("nine-ball").play(BREAK, cue_ball=(0.6, 0.5), noise=noise, seed=seed)  # type: ignore[arg-type]


def test_a_drawn_strike_beyond_the_efficiency_of_the_tip_is_moved_back() -> None:
    # A side of 0.2 can be played, and one of 0.3 cannot.
    physics = carom.Physics.preset("pool", cue={"tip_efficiency": 0.8})
    frames = [Frame("nine-ball", physics=physics) for _ in range(20)]
    wild = Noise(side_m=0.005)
    for seed, frame in enumerate(frames):
        frame.play({**BREAK, "speed": 2.0, "side": 0.2}, cue_ball=(0.6, 0.5), noise=wild, seed=seed)
    sides = [frame.record["moves"][0]["play"]["strike"]["side"] for frame in frames]
    limit = max(sides)
    assert 0.2 < limit < 0.3
    assert sum(side > limit - 1e-6 for side in sides) > 3
