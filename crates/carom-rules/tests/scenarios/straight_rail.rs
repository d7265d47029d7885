//! Straight rail (UMB).

use super::{DescribedShot, Scenario, assert_fouls, hit};
use crate::{Call, Choice, Foul, Game, Options, Request};

const NOTHING: Call = Call::Nothing;

/// A shot that touches both object balls, the red first.
fn carom(scenario: &Scenario) -> DescribedShot {
    hit(&[]).touching(&[2, 1 - i32::from(scenario.turn().cue)])
}

/// Player 0 has scored from the starting position.
fn begun() -> Scenario {
    let mut scenario = Scenario::of(Game::StraightRail);
    let point = carom(&scenario);
    assert_eq!(scenario.play(NOTHING, point).points, [1, 0]);
    scenario
}

/// The object balls of player 0 are in the corner at the bottom left.
fn in_a_corner() -> Scenario {
    let mut scenario = begun();
    for (ball, place) in [(0, [0.5, 0.5]), (1, [0.1, 0.1]), (2, [0.1, 0.3])] {
        scenario.0.put(ball, Some(place));
    }
    scenario
}

#[test]
fn both_object_balls_score_without_a_cushion() {
    let mut scenario = begun();
    assert_eq!(scenario.asks(0).cue, 0);
    assert_eq!(scenario.play(NOTHING, hit(&[]).touching(&[1, -1, 2])).points, [1, 0]);
    assert_eq!(scenario.play(NOTHING, hit(&[2])).points, [0, 0]);
    assert_eq!(scenario.asks(1).cue, 1);
}

#[test]
fn the_starting_shot_must_hit_the_red_first_and_directly() {
    let mut scenario = Scenario::of(Game::StraightRail);
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[1, 2]));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    let mut scenario = Scenario::of(Game::StraightRail);
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[-1, 2, 1]));
    assert_fouls(&ruling, &[Foul::IndirectStart]);
    assert_eq!(ruling.points, [0, 0]);
}

#[test]
fn the_second_point_in_a_corner_must_drive_a_ball_out() {
    let mut scenario = in_a_corner();
    let point = carom(&scenario);
    assert_eq!(scenario.play(NOTHING, point).points, [1, 0], "the first point inside");
    let point = carom(&scenario);
    let ruling = scenario.play(NOTHING, point);
    assert_eq!((ruling.points, ruling.is_legal()), ([0, 0], true), "no ball was driven out");
    let count = ruling.carom.expect("a count");
    assert_eq!((count.balls, count.cushions, count.needed, count.stayed), (2, 0, 0, true));
    scenario.asks(1);
}

#[test]
fn a_ball_that_leaves_the_corner_begins_a_new_count() {
    let mut scenario = in_a_corner();
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    // The red is put outside before the next shot, as if the point had driven it out.
    scenario.0.put(2, Some([0.7, 0.7]));
    for _ in 0..3 {
        let point = carom(&scenario);
        assert_eq!(scenario.play(NOTHING, point).points, [1, 0]);
    }
}

#[test]
fn balls_in_two_corners_are_not_limited() {
    let mut scenario = in_a_corner();
    scenario.0.put(2, Some([1.3, 0.1]));
    for _ in 0..3 {
        let point = carom(&scenario);
        assert_eq!(scenario.play(NOTHING, point).points, [1, 0]);
    }
}

#[test]
fn after_a_ball_off_the_table_the_opponent_plays_from_the_starting_position() {
    let mut scenario = begun();
    let ruling = scenario.play(NOTHING, hit(&[2]).losing(2));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    assert_eq!(scenario.asks(1).on, [2]);
    scenario.lies_at(2, [0.71, 2.13]);
    scenario.lies_at(0, [0.71, 0.71]);
}

#[test]
fn a_player_with_a_frozen_cue_ball_may_play_from_the_starting_position() {
    let mut scenario = begun();
    let radius = scenario.0.base().physics().ball.radius;
    scenario.0.put(1, Some([0.7, 1.0]));
    scenario.0.put(0, Some([0.7 + 2.0 * radius, 1.0]));
    let point = carom(&scenario);
    assert_fouls(&scenario.play(NOTHING, point), &[]);
    let mut scenario = begun();
    scenario.0.put(0, Some([0.7, 1.0]));
    scenario.0.put(1, Some([0.7 + 2.0 * radius, 1.0]));
    scenario.play(NOTHING, hit(&[2]));
    scenario.offers(1, &[Choice::PlayOn, Choice::SpotFrozen]);
    scenario.choose(Choice::SpotFrozen);
    assert_eq!(scenario.asks(1).on, [2]);
    scenario.lies_at(0, [0.71, 0.71]);
}

#[test]
fn the_target_ends_the_match_in_equal_innings() {
    let mut scenario =
        Scenario::with(Game::StraightRail, Options { points: 1, ..Options::default() });
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    assert_eq!(scenario.asks(1).on, [2], "the last inning begins in the starting position");
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    assert!(matches!(scenario.0.request(), Request::Over { winner: None, .. }));
}
