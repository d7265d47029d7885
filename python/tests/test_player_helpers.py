"""One-call helpers of players: legal answers, pots, plays of solutions, successors."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import carom
import pytest
from carom import Call, Frame, InputError, Noise, Play, Strike

CLUB = Noise.preset("club")
# The cue ball, three solids, the eight and two stripes.
PLACES = {
    "cue": (0.62, 1.31),
    "1": (0.21, 0.43),
    "2": (1.02, 1.88),
    "3": (0.71, 2.21),
    "8": (0.33, 1.92),
    "9": (0.94, 0.51),
    "10": (0.5, 0.8),
}


def frame_at(game: str, places: dict[str, tuple[float, float]], table: str = "wpa-9ft") -> Frame:
    balls = [{"id": ball, "position": list(place)} for ball, place in places.items()]
    shot = {"format": "carom-shot/1", "table": table, "balls": balls}
    return Frame.of_shot(game, carom.Shot.from_dict(shot))


@pytest.fixture(name="open_table", scope="module")
def fixture_open_table() -> Frame:
    return frame_at("eight-ball", PLACES)


@pytest.fixture(name="found", scope="module")
def fixture_found(open_table: Frame) -> list[carom.PotPlay]:
    return carom.pots(open_table, CLUB, 60, seed=5)


# Pots.


def test_the_chance_of_a_pot_is_that_of_playing_it_again_and_again(
    open_table: Frame, found: list[carom.PotPlay]
) -> None:
    for pot in (found[0], found[4], found[-1]):
        made = 0
        shot = pot.play.shot(open_table)
        for index in range(60):
            frame = open_table.copy()
            ruling = frame.play(CLUB.draw(shot, index, seed=5), call=pot.play.call)
            assert ruling.trace is not None
            fell = [pot.ball, pot.pocket] in [list(p) for p in ruling.trace.outcome.pocketed]
            made += fell and ruling.legal
        assert (pot.chance.count, pot.chance.trials) == (made, 60)


def test_evaluate_counts_at_least_the_chance_of_a_pot(
    open_table: Frame, found: list[carom.PotPlay]
) -> None:
    for pot in found:
        shot = pot.play.shot(open_table)
        counted = carom.evaluate(shot, CLUB, 60, seed=5, frame=open_table, call=pot.play.call)
        fell = counted.pocket(pot.ball, pot.pocket).count
        assert counted.legal_count is not None
        assert fell - (60 - counted.legal_count) <= pot.chance.count <= fell


def test_pots_are_ordered_and_each_ball_pocket_and_kind_is_listed_once(
    open_table: Frame, found: list[carom.PotPlay]
) -> None:
    counts = [pot.chance.count for pot in found]
    assert counts == sorted(counts, reverse=True)
    assert {"direct", "bank", "kick"} <= {pot.kind for pot in found}
    assert {"1", "2", "3", "9"} <= {pot.ball for pot in found if pot.kind == "direct"}
    for pot in found:
        assert pot.play.call == Call.pocket(pot.ball, pot.pocket)
        trace = pot.play.shot(open_table).simulate()
        assert pot.ball in [ball for ball, _ in trace.outcome.pocketed]
    assert str(found[0]).startswith(f"{100 * counts[0] / 60:.1f} %")
    assert found[0].aim in str(found[0])
    several = carom.pots(open_table, CLUB, 60, seed=5, each=3)
    assert len(found) < len(several) <= 3 * len(found)
    assert [pot for pot in several if pot == found[0]] == [found[0]]


def test_pots_do_not_depend_on_threads_and_do_not_change_the_frame(open_table: Frame) -> None:
    before = open_table.hash
    one = carom.pots(open_table, CLUB, 20, threads=1)
    assert carom.pots(open_table, CLUB, 20, threads=2) == one
    assert open_table.hash == before
    better = carom.pots(open_table, Noise(), 20)
    assert better[0].chance.count == 20


def test_a_ball_in_hand_is_placed_where_it_can_be_potted() -> None:
    frame = frame_at("nine-ball", {"cue": (0.3, 1.2), "1": (0.62, 1.31), "9": (1.0, 2.0)})
    # No ball is hit: ball in hand for the other player.
    frame.play(Strike(0.1, 3.14))
    assert frame.request.in_hand == "anywhere"
    free = carom.pots(frame, CLUB, 50)
    assert free[0].play.cue_ball is not None
    assert free[0].chance.count > 45
    here = carom.pots(frame, CLUB, 50, cue_ball=(0.3, 0.3))
    assert {pot.play.cue_ball for pot in here} == {(0.3, 0.3)}
    assert here[0].chance.count < free[0].chance.count
    with pytest.raises(InputError, match=r"^cue_ball"):
        carom.pots(frame, CLUB, 50, cue_ball=(9.0, 9.0))


def test_there_may_be_no_pots() -> None:
    assert carom.pots(Frame("three-cushion")) == []
    assert carom.pots(Frame("snooker")) == []


def test_wrong_questions_are_refused(open_table: Frame) -> None:
    over = open_table.copy()
    over.concede()
    wrong: list[tuple[Any, dict[str, Any], str]] = [
        (over, {}, r"^frame: it is over"),
        (open_table, {"n": 0}, r"^n: 0 is out of range"),
        (open_table, {"each": 0}, r"^each: 0 is out of range"),
        (open_table, {"cue_ball": (0.3, 0.3)}, r"^cue_ball"),
        (5, {}, r"^frame"),
    ]
    for frame, arguments, message in wrong:
        with pytest.raises(InputError, match=message):
            carom.pots(frame, CLUB, **arguments)


# Successors.


def test_successors_are_the_frames_of_the_variants_of_evaluate(
    open_table: Frame, found: list[carom.PotPlay]
) -> None:
    play = found[0].play
    drawn = carom.successors(open_table, play, CLUB, 80, seed=7)
    counted = carom.evaluate(
        play.shot(open_table), CLUB, 80, seed=7, frame=open_table, call=play.call
    )
    assert sum(after.ruling.legal for after in drawn) == counted.legal_count
    assert sum(after.frame.player == 0 for after in drawn) == counted.turn_kept_count
    shot = play.shot(open_table)
    for index in (0, 3, 79):
        strike = CLUB.draw(shot, index, seed=7)
        frame = open_table.copy()
        ruling = frame.play(strike, call=play.call)
        after = drawn[index]
        # Frame.play converts the angles of a strike to degrees and back.
        assert after.frame.balls.keys() == frame.balls.keys()
        for ball, place in frame.balls.items():
            assert after.frame.balls[ball] == pytest.approx(place, abs=1e-6)
        assert after.frame.request == frame.request
        assert (after.ruling.legal, after.ruling.fouls) == (ruling.legal, ruling.fouls)
        assert after.strike.speed == strike.speed
        assert after.ruling.trace is None
    rest = carom.successors(open_table, play, CLUB, 40, seed=7, first=40, threads=1)
    assert [a.frame.hash for a in rest] == [a.frame.hash for a in drawn[40:]]
    with pytest.raises(InputError, match="copy for a player"):
        _ = drawn[0].frame.record


def test_a_play_that_is_not_allowed_has_no_successors(open_table: Frame) -> None:
    with pytest.raises(InputError, match=r"^call: nothing is called"):
        carom.successors(open_table, Play(Strike(2.0, 1.0)), CLUB)
    assert carom.successors(open_table, Play(Strike(2.0, 1.0), call=Call.safety()), CLUB, 0) == []


# Plays of solutions.


def test_a_solution_becomes_a_play_with_its_call(open_table: Frame) -> None:
    shot = open_table.shot(Strike(1.0, 0.0), call=Call.safety())
    solution = carom.solve(shot, pot=("2", "top-right"), noise=CLUB, wanted=1, n=50)[0]
    play = Play.from_solution(solution, open_table)
    assert play.call == Call.pocket("2", "top-right")
    assert play.cue_ball is None
    frame = open_table.copy()
    assert frame.play(play.strike, call=play.call).legal
    assert "2" not in frame.balls
    counted = carom.evaluate(play.shot(open_table), CLUB, 50)
    assert counted.pocket("2", "top-right").count == solution.chance.count


def test_a_solution_is_placed_and_nominates_a_ball_where_the_game_asks_for_it() -> None:
    nine = frame_at("nine-ball", {"cue": (0.3, 1.2), "1": (0.62, 1.31), "9": (1.0, 2.0)})
    nine.play(Strike(0.1, 3.14))
    shot = nine.shot(Strike(1.0, 0.0), cue_ball=(0.62, 0.8))
    play = Play.from_solution(carom.solve(shot, pot="1", wanted=1, n=20)[0], nine)
    assert (play.cue_ball, play.call) == ((0.62, 0.8), None)
    assert nine.copy().play(play.strike, cue_ball=play.cue_ball).legal
    spots = {ball: at for ball, at in Frame("snooker").balls.items() if "red" not in ball}
    balls = spots | {"cue": (0.7, 1.5), "red-1": (0.6, 2.2)}
    snooker = frame_at("snooker", balls, "snooker-12ft")
    red = carom.solve(snooker.shot(Strike(1.0, 0.0)), pot="red-1", wanted=1, n=20)[0]
    play = Play.from_solution(red, snooker)
    assert play.call is None
    assert snooker.play(play.strike).legal
    shot = snooker.shot(Strike(1.0, 0.0), call=Call.on("black"))
    solution = carom.solve(shot, first="black", wanted=1, n=20)[0]
    play = Play.from_solution(solution, snooker)
    assert play.call == Call.on("black")
    assert snooker.copy().play(play.strike, call=play.call).legal
    balls_of_another = [{"id": "white", "position": [0.5, 0.5]}]
    file = {"format": "carom-shot/1", "table": "wpa-9ft", "balls": balls_of_another}
    other = replace(solution, shot=carom.Shot.from_dict(file))
    with pytest.raises(InputError, match=r"^solution: its shot has no ball 'cue'"):
        Play.from_solution(other, nine)
    over = nine.copy()
    over.concede()
    with pytest.raises(InputError, match=r"^frame: it requests no shot"):
        Play.from_solution(solution, over)


# Legal answers.


@pytest.mark.parametrize("game", ["eight-ball", "nine-ball", "straight-pool", "snooker"])
def test_legal_calls_are_exactly_those_that_the_frame_accepts(game: str) -> None:
    frame = frame_at("eight-ball", PLACES) if game == "eight-ball" else Frame(game, seed=2)
    legal = frame.legal_answers(places=5)
    place = None if legal.places is None else legal.places[0]
    balls = [*frame.balls, "cue"]
    every: list[Call | None] = [None, Call.safety(), Call.push_out()]
    every += [Call.on(ball) for ball in balls]
    every += [Call.pocket(b, p["name"]) for b in balls for p in frame.geometry()["pockets"]]

    def accepts(call: Call | None) -> bool:
        try:
            frame.shot(Strike(2.0, 1.6), cue_ball=place, call=call)
        except InputError:
            return False
        return True

    assert legal.choices == ()
    found = set(legal.calls)
    assert len(found) == len(legal.calls) > 0
    assert found == {call for call in every if accepts(call)}


def test_legal_places_are_spread_over_the_region_and_allowed() -> None:
    for game in ("nine-ball", "snooker"):
        frame = Frame(game)
        places = frame.legal_answers(places=40).places
        assert places is not None
        assert len(set(places)) == 40
        for place in places:
            frame.shot(Strike(2.0, 1.6), cue_ball=place)
        bounds = frame.hand_bounds
        assert bounds is not None
        middle = 0.5 * (bounds[0][0] + bounds[1][0])
        assert 14 < sum(x < middle for x, _ in places) < 26
        moved = frame.legal_answers(places=40, seed=1).places
        assert moved is not None
        assert not set(moved) & set(places)


def test_a_choice_has_choices_and_no_calls() -> None:
    frame = Frame("eight-ball", seed=1)
    frame.play(Strike(0.5, 1.5707), cue_ball=(0.635, 0.5))
    assert frame.request.kind == "choice"
    legal = frame.legal_answers()
    assert legal.choices == tuple(frame.request.choices)
    assert (legal.calls, legal.places) == ((), None)


# In a match.


class Potter:
    """Plays the most probable pot, or else a ball on with the first call that is legal."""

    seen: list[carom.Situation]

    def __init__(self) -> None:
        self.seen = []

    def __deepcopy__(self, _: Any) -> Potter:
        return self

    def choose(self, situation: carom.Situation) -> Any:
        self.seen.append(situation)
        legal = situation.frame.legal_answers(places=1)
        if legal.choices:
            return legal.choices[0]
        found = situation.pots(20)
        if found:
            return found[0].play
        place = legal.places[0] if legal.places else None
        return Play(Strike(6.0, 1.57), cue_ball=place, call=legal.calls[0])


def test_a_player_of_helpers_alone_wins_frames(tmp_path: Any) -> None:
    player = Potter()
    result = carom.play_match(
        player,
        "level-1",
        game="nine-ball",
        pairs=2,
        noise=Noise.preset("professional"),
        secret="ab" * 32,
        out=tmp_path / "m",
    )
    assert result.score.wins > 0
    assert "refusals" not in result.score.reasons
    situation = next(s for s in player.seen if s.pots(20))
    pot = situation.pots(20)[0]
    assert pot == carom.pots(situation.frame, situation.noise, 20, situation.seed)[0]
    drawn = situation.successors(pot.play, 20)
    assert sum(after.ruling.legal for after in drawn) >= pot.chance.count
