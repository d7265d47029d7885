//! Double hits and pushes: strikes whose cue ball meets a ball while the tip is on it.

use super::{DescribedShot, Scenario, assert_fouls, hit};
use crate::referee::NearHit;
use crate::{BallIndex, Call, Foul, Game};

/// Rules on the shot after the break: the tip met the cue ball `contacts` times, and the cue ball met
/// the 1 during the strike.
#[track_caller]
fn nine_ball(contacts: u8, hit_of: NearHit, expected: &[Foul]) {
    let mut scenario = Scenario::of(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(5, super::CORNER));
    let ruling = scenario.play(Call::Nothing, hit(&[1]).meeting(1, contacts, hit_of));
    assert_fouls(&ruling, expected);
}

#[test]
fn in_pool_a_full_hit_of_a_near_ball_with_the_tip_on_is_a_foul() {
    nine_ball(1, NearHit::Full, &[Foul::PushShot]);
    nine_ball(2, NearHit::Full, &[Foul::DoubleHit, Foul::PushShot]);
}

#[test]
fn in_pool_a_graze_of_a_near_ball_is_legal() {
    nine_ball(1, NearHit::Grazed, &[]);
    nine_ball(2, NearHit::Grazed, &[]);
}

#[test]
fn in_pool_several_contacts_of_the_tip_in_a_strike_into_a_frozen_ball_are_legal() {
    nine_ball(2, NearHit::Nothing, &[]);
}

#[test]
fn a_second_contact_of_the_tip_without_another_ball_is_a_double_hit() {
    for game in [Game::NineBall, Game::Snooker, Game::ThreeCushion] {
        let mut scenario = Scenario::of(game);
        let red: BallIndex = if game == Game::ThreeCushion { 2 } else { 1 };
        let mut shot = hit(&[red]).driving(&[1, 2, 3, 4]);
        shot.outcome.tip_contacts = 2;
        assert_fouls(&scenario.play(Call::Nothing, shot), &[Foul::DoubleHit]);
    }
}

#[test]
fn a_push_out_may_not_be_a_double_hit() {
    let mut scenario = Scenario::of(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(5, super::CORNER));
    let ruling = scenario.play(Call::PushOut, hit(&[3]).meeting(3, 2, NearHit::Full));
    assert_fouls(&ruling, &[Foul::DoubleHit, Foul::PushShot]);
}

#[test]
fn in_snooker_a_push_costs_the_value_of_the_ball_that_was_pushed() {
    const BLACK: BallIndex = 21;
    let pushed = |ball, full| {
        let mut scenario = Scenario::of(Game::Snooker);
        scenario.play(Call::Nothing, hit(&[ball]).meeting(ball, 1, full))
    };
    let red = pushed(1, NearHit::Full);
    assert_fouls(&red, &[Foul::PushShot]);
    assert_eq!(red.points, [0, 4]);
    let black = pushed(BLACK, NearHit::Full);
    assert_fouls(&black, &[Foul::WrongBallFirst, Foul::PushShot]);
    assert_eq!(black.points, [0, 7]);
    assert!(pushed(1, NearHit::Grazed).is_legal(), "a very fine hit is not a push");
}

#[test]
fn in_three_cushion_even_a_graze_of_a_near_ball_with_the_tip_on_is_a_foul() {
    const RED: BallIndex = 2;
    let fouls = |shot: DescribedShot, expected: &[Foul]| {
        assert_fouls(&Scenario::of(Game::ThreeCushion).play(Call::Nothing, shot), expected);
    };
    fouls(hit(&[RED]).meeting(RED, 1, NearHit::Grazed), &[Foul::PushShot]);
    fouls(hit(&[RED]).meeting(RED, 2, NearHit::Full), &[Foul::DoubleHit, Foul::PushShot]);
}

#[test]
fn double_hits_and_pushes_have_rule_numbers() {
    let numbers = |game: Game| {
        [Foul::DoubleHit, Foul::PushShot].map(|foul| crate::GameFacts::of(game).rule(foul))
    };
    assert_eq!(numbers(Game::EightBall), ["WPA 6.7", "WPA 6.7"]);
    assert_eq!(numbers(Game::Snooker), ["WPBSA 3.10(a)(ii)", "WPBSA 3.10(b)(v)"]);
    assert_eq!(numbers(Game::ThreeCushion), ["UMB 41", "UMB 41"]);
}
