//! UMB.

use super::{Scene, assert_fouls, hit};
use crate::{Call, Choice, Foul, Frame, Options, Request, Rules};

const NOTHING: Call = Call::Nothing;

/// A shot that scores for either player: three cushions between the other balls.
fn carom(scene: &Scene) -> super::Shot {
    let other = 1 - i32::from(scene.turn().cue);
    hit(&[]).touching(&[2, -1, -1, -1, other])
}

fn played(order: &[i32]) -> i32 {
    let mut scene = Scene::of(Rules::ThreeCushion);
    scene.play(NOTHING, hit(&[]).touching(order)).points[0]
}

#[test]
fn a_carom_needs_three_cushions_before_the_second_ball() {
    assert_eq!(played(&[2, -1, -1, -1, 1]), 1);
    assert_eq!(played(&[-1, -1, -1, 2, 1]), 1);
    assert_eq!(played(&[-1, 2, -1, 2, -1, 1]), 1, "the first ball may be hit again");
    assert_eq!(played(&[2, -1, -1, 1, -1]), 0);
    assert_eq!(played(&[2, -1, -1, -1]), 0);
    assert_eq!(played(&[-1, -1, -1]), 0);
}

#[test]
fn a_point_keeps_the_turn_and_a_miss_passes_it_with_the_other_cue_ball() {
    let mut scene = Scene::of(Rules::ThreeCushion);
    let point = carom(&scene);
    scene.play(NOTHING, point);
    assert_eq!(scene.asks(0).cue, 0);
    scene.play(NOTHING, hit(&[2]));
    assert_eq!(scene.asks(1).cue, 1);
}

#[test]
fn the_opening_shot_goes_to_the_red_first() {
    let mut scene = Scene::of(Rules::ThreeCushion);
    let ruling = scene.play(NOTHING, hit(&[]).touching(&[1, -1, -1, -1, 2]));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [0, 0]);
    scene.asks(1);
}

#[test]
fn balls_off_the_table_are_spotted_and_no_point_is_scored() {
    let mut scene = Scene::of(Rules::ThreeCushion);
    let happened = carom(&scene).losing(2).losing(0);
    let ruling = scene.play(NOTHING, happened);
    assert_fouls(&ruling, &[Foul::CueBallOffTable, Foul::BallOffTable]);
    assert_eq!((ruling.points, ruling.spotted.len()), ([0, 0], 2));
    assert!(!scene.is_down(2) && !scene.is_down(0));
}

#[test]
fn frozen_balls_may_be_spotted() {
    let mut scene = Scene::of(Rules::ThreeCushion);
    let radius = scene.0.base().physics().ball.radius;
    scene.0.put(1, Some([0.7, 1.0]));
    scene.0.put(2, Some([0.7 + 2.0 * radius, 1.0]));
    scene.play(NOTHING, hit(&[2]));
    scene.offers(1, &[Choice::PlayOn, Choice::SpotFrozen]);
    assert_eq!(scene.choose(Choice::SpotFrozen).spotted.len(), 2);
    scene.asks(1);
}

#[test]
fn the_second_player_has_an_inning_to_answer() {
    let options = Options { target: 2, ..Options::default() };
    let frame = Frame::new(Rules::ThreeCushion, options, None, None, 1).expect("its own table");
    let mut scene = Scene(frame);
    for _ in 0..2 {
        let point = carom(&scene);
        scene.play(NOTHING, point);
    }
    let mut drawn = Scene(scene.0.clone());
    scene.asks(1);
    scene.play(NOTHING, hit(&[2]));
    scene.is_won_by(0);
    for _ in 0..2 {
        let point = carom(&drawn);
        drawn.play(NOTHING, point);
    }
    assert!(matches!(drawn.0.request(), Request::Over { winner: None, .. }), "a draw");
}
