//! Korean four-ball.

use super::{Scenario, assert_fouls, hit};
use crate::{Call, Foul, Game, Options};

const NOTHING: Call = Call::Nothing;

/// Player 0 has scored from the starting position.
fn begun() -> Scenario {
    let mut scenario = Scenario::of(Game::FourBall);
    assert_eq!(scenario.asks(0).on, [3], "the red at the other end");
    assert_eq!(scenario.play(NOTHING, hit(&[]).touching(&[3, 2])).points, [1, 0]);
    scenario
}

#[test]
fn both_reds_score_and_one_red_ends_the_inning() {
    let mut scenario = begun();
    assert_eq!(scenario.asks(0).on, [2, 3]);
    assert_eq!(scenario.play(NOTHING, hit(&[]).touching(&[2, -1, 3])).points, [1, 0]);
    let ruling = scenario.play(NOTHING, hit(&[2]));
    assert_eq!((ruling.points, ruling.is_legal()), ([0, 0], true));
    assert_eq!(scenario.asks(1).cue, 1);
}

#[test]
fn the_starting_shot_must_hit_the_red_at_the_other_end() {
    let mut scenario = Scenario::of(Game::FourBall);
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[2, 3]));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [-1, 0]);
}

#[test]
fn the_opponents_ball_costs_a_point_also_after_both_reds() {
    let mut scenario = begun();
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[2, 3, 1]));
    assert_fouls(&ruling, &[Foul::OpponentsBall]);
    assert_eq!(ruling.points, [-1, 0]);
    scenario.asks(1);
}

#[test]
fn a_shot_without_a_red_costs_a_point() {
    let mut scenario = begun();
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[-1, -1]));
    assert_fouls(&ruling, &[Foul::NoContact]);
    assert_eq!(ruling.points, [-1, 0]);
}

#[test]
fn a_ball_off_the_table_goes_back_to_its_place() {
    let mut scenario = begun();
    scenario.0.put(0, Some([0.3, 1.0]));
    let ruling = scenario.play(NOTHING, hit(&[3]).losing(3));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    scenario.lies_at(3, [0.71, 2.13]);
}

#[test]
fn the_last_point_needs_three_cushions() {
    let mut scenario = Scenario::with(Game::FourBall, Options { points: 2, ..Options::default() });
    scenario.play(NOTHING, hit(&[]).touching(&[3, 2]));
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[3, -1, -1, 2]));
    assert_eq!((ruling.points, ruling.is_legal()), ([0, 0], true));
    let count = ruling.carom.expect("a count");
    assert_eq!((count.balls, count.cushions, count.needed, count.stayed), (2, 2, 3, false));
    scenario.asks(1);
    scenario.play(NOTHING, hit(&[2]));
    scenario.play(NOTHING, hit(&[]).touching(&[3, -1, -1, -1, 2]));
    scenario.is_won_by(0);
}
