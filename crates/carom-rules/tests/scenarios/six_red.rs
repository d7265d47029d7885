//! Six-red snooker.

use super::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::games::GameState;
use crate::games::snooker::On;
use crate::{BallIndex, Call, Choice, Foul, Game, Options, Region};

const RED: BallIndex = 1;
const YELLOW: BallIndex = 7;
const BLUE: BallIndex = 10;
const PINK: BallIndex = 11;
const BLACK: BallIndex = 12;
const NOTHING: Call = Call::Nothing;

fn scenario() -> Scenario {
    Scenario::of(Game::SixRed)
}

fn misses(scenario: &Scenario) -> u32 {
    match scenario.0.game_state() {
        GameState::SixRed(game) => game.misses(),
        other => panic!("{other:?}"),
    }
}

/// Player 0 has pocketed a red, so a colour is on.
fn after_a_red() -> Scenario {
    let mut scenario = scenario();
    assert_eq!(scenario.play(NOTHING, hit(&[RED]).potting(RED, CORNER)).points, [1, 0]);
    assert_eq!(scenario.0.kind_on(), Some(On::Color));
    scenario
}

/// A frame in which the only red is behind the blue as seen from the cue ball: the red can be hit on its edge,
/// and not full.
fn half_hidden() -> Scenario {
    let mut scenario = scenario().without(2..=6);
    scenario.play(NOTHING, hit(&[RED]));
    for (ball, place) in [(0, [0.6, 1.0]), (BLUE, [0.63, 1.5]), (RED, [0.6, 2.0])] {
        scenario.0.put(ball, Some(place));
    }
    scenario
}

/// Player 1 misses the red and is made to play again, `times` times.
fn missed(times: u32) -> Scenario {
    let mut scenario = half_hidden();
    for time in 1..=times {
        scenario.asks(1);
        scenario.play(NOTHING, hit(&[]));
        scenario.offers(0, &[Choice::PlayOn, Choice::PassBack, Choice::Replace]);
        assert_eq!(misses(&scenario), time);
        scenario.choose(Choice::Replace);
    }
    scenario
}

#[test]
fn six_reds_and_the_colors_are_worth_seventy_five() {
    let scenario = scenario();
    assert_eq!(scenario.0.layout().len(), 13);
    assert_eq!(scenario.asks(0).hand, Some(Region::TheD));
    assert_eq!(scenario.turn().on, [1, 2, 3, 4, 5, 6]);
    let values = (0..13).map(|ball| scenario.0.value(ball)).collect::<Vec<_>>();
    assert_eq!(values, [0, 1, 1, 1, 1, 1, 1, 2, 3, 4, 5, 6, 7]);
    let line = scenario.0.describe();
    assert!(line.contains("Left on the table: 75 points."), "{line}");
}

#[test]
fn a_maximum_break_scores_what_the_facts_say() {
    let mut scenario = scenario();
    for red in 1..=6 {
        scenario.play(NOTHING, hit(&[red]).potting(red, CORNER));
        let ruling = scenario.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, CORNER));
        assert_eq!((ruling.points, &ruling.spotted[..]), ([7, 0], &[BLACK][..]));
    }
    for color in YELLOW..=BLACK {
        assert_eq!(scenario.asks(0).on, [color]);
        scenario.play(NOTHING, hit(&[color]).potting(color, SIDE));
    }
    scenario.is_won_by(0);
    assert_eq!(scenario.0.scores(), [75, 0]);
    assert_eq!(
        scenario.0.facts().scoring,
        crate::Scoring::Points { maximum: scenario.0.scores()[0] }
    );
}

#[test]
fn a_foul_costs_the_value_of_the_ball_and_colors_go_back_to_their_spots() {
    let mut scenario = scenario();
    let ruling = scenario.play(NOTHING, hit(&[RED]).potting(PINK, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallPocketed]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 6], &[PINK][..]));
    scenario.lies_at(PINK, [0.889, 0.75 * 3.569]);
}

#[test]
fn after_four_misses_the_balls_are_replaced_and_after_the_fifth_they_are_not() {
    let mut scenario = missed(4);
    scenario.play(NOTHING, hit(&[]));
    scenario.offers(0, &[Choice::PlayOn, Choice::PassBack, Choice::PlayFromAnywhere]);
    assert!(scenario.0.describe().contains("Fouls and misses in a row: 5; 5 at most."));
    scenario.choose(Choice::PlayFromAnywhere);
    let turn = *scenario.asks(0);
    assert_eq!((turn.hand, &turn.on[..]), (Some(Region::Anywhere), &[RED][..]));
    assert!(!turn.calls.nominate, "no free ball");
    assert_eq!((scenario.0.scores(), misses(&scenario)), ([20, 0], 0));
}

#[test]
fn a_shot_that_is_no_miss_starts_the_count_again() {
    let mut scenario = missed(4);
    scenario.play(NOTHING, hit(&[RED]));
    assert_eq!(misses(&scenario), 0);
    let mut scenario = missed(3);
    scenario.play(NOTHING, hit(&[]));
    scenario.choose(Choice::PassBack);
    scenario.asks(1);
    assert_eq!(misses(&scenario), 0);
}

#[test]
fn with_penalty_points_needed_no_miss_is_called_and_the_cue_ball_is_not_placed_anywhere() {
    let mut scenario = missed(4).without([PINK, BLACK, YELLOW + 1]);
    assert_eq!(scenario.0.scores(), [16, 0]);
    // The red and a black, yellow, brown and blue are worth 19; the offender then trails by 20.
    scenario.play(NOTHING, hit(&[]));
    scenario.offers(0, &[Choice::PlayOn, Choice::PassBack]);
    assert_eq!(misses(&scenario), 0);
}

#[test]
fn three_misses_with_a_full_ball_in_sight_lose_the_frame_as_in_snooker() {
    let mut scenario = half_hidden();
    scenario.0.put(BLUE, Some([0.2, 1.5]));
    for _ in 0..2 {
        scenario.play(NOTHING, hit(&[]));
        scenario.choose(Choice::Replace);
    }
    scenario.play(NOTHING, hit(&[]));
    scenario.is_won_by(0);
}

/// After the shot at the blue that was nominated, the blue is between the cue ball and the last red.
fn behind_the_blue(game: Game, [red, blue]: [BallIndex; 2]) -> Scenario {
    let mut scenario = Scenario::of(game);
    scenario.play(NOTHING, hit(&[red]).potting(red, CORNER));
    let reds = 2..blue - 3;
    let mut scenario = scenario.without(reds.clone().skip(1));
    for (ball, place) in [(0, [0.6, 1.0]), (blue, [0.6, 1.06]), (reds.start, [0.6, 2.0])] {
        scenario.0.put(ball, Some(place));
    }
    scenario
}

#[test]
fn a_nominated_color_must_not_be_left_in_the_way() {
    let mut scenario = behind_the_blue(Game::SixRed, [RED, BLUE]);
    let ruling = scenario.play(Call::On(BLUE), hit(&[BLUE]));
    assert_fouls(&ruling, &[Foul::SnookeredByFreeBall]);
    assert_eq!(ruling.points, [0, 5]);
    assert_eq!(scenario.0.facts().rule(Foul::SnookeredByFreeBall), "six-red 3");
    let mut snooker = behind_the_blue(Game::Snooker, [1, 19]);
    assert!(snooker.play(Call::On(19), hit(&[19])).is_legal(), "only six-red forbids it");
    let mut potted = behind_the_blue(Game::SixRed, [RED, BLUE]);
    assert!(potted.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE)).is_legal());
}

#[test]
fn another_color_than_the_nominated_one_may_be_in_the_way() {
    let mut scenario = behind_the_blue(Game::SixRed, [RED, BLUE]);
    assert!(scenario.play(Call::On(PINK), hit(&[PINK])).is_legal());
}

#[test]
fn the_nominated_yellow_may_cover_itself_when_it_is_the_next_ball_on() {
    let mut scenario = after_a_red().without(2..=6);
    scenario.0.put(0, Some([0.6, 1.0]));
    scenario.0.put(YELLOW, Some([0.6, 1.2]));
    assert!(scenario.play(Call::On(YELLOW), hit(&[YELLOW])).is_legal());
    assert_eq!(scenario.asks(1).on, [YELLOW]);
}

#[test]
fn without_the_miss_rule_there_is_nothing_to_count() {
    let mut scenario = Scenario::with(Game::SixRed, Options { miss: false, ..Options::default() });
    scenario.play(NOTHING, hit(&[]));
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack]);
    assert_eq!(misses(&scenario), 0);
}
