//! Rulings on simulated strikes at balls that touch the cue ball or lie near it.

use carom::math::{radians, sin_cos};
use carom::resolve::cue_ball::Strike;
use carom_rules::{Foul, Frame, Game, Options, Play, Ruling};

/// The ruling on a level strike straight up the table. The red or the 1 is in front of the cue ball,
/// `gap` (m) away; the line of centres is turned by `cut_deg`.
fn strike(game: Game, gap: f64, cut_deg: f64, speed: f64) -> Ruling {
    let mut frame =
        Frame::new(game, Options::default(), None, None, 1).expect("the game's own table");
    let target = if game == Game::ThreeCushion { 2 } else { 1 };
    let apart = 2.0 * frame.base().physics().ball.radius + gap;
    let (sin, cos) = sin_cos(radians(cut_deg));
    let mut places = vec![None; frame.layout().len()];
    places[0] = Some([0.5, 1.0]);
    places[target] = Some([0.5 + apart * sin, 1.0 + apart * cos]);
    let others: &[usize] = match game {
        Game::Snooker => &[16, 17, 18, 19, 20, 21],
        Game::ThreeCushion => &[1],
        _ => &[9],
    };
    for &other in others {
        places[other] = Some([1.0, 0.1 * other as f64]);
    }
    frame.resume_at(&places, 0).expect("a valid position");
    let azimuth = core::f64::consts::FRAC_PI_2;
    let strike = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
    frame.play(&Play::new(strike)).expect("it can be played").0
}

fn fouls(game: Game, gap: f64, cut_deg: f64, speed: f64) -> Vec<Foul> {
    strike(game, gap, cut_deg, speed).fouls.iter().collect()
}

#[test]
fn a_full_strike_across_a_gap_of_three_millimetres_is_a_foul() {
    assert_eq!(fouls(Game::NineBall, 3e-3, 0.0, 7.0), [Foul::PushShot]);
    assert_eq!(fouls(Game::Snooker, 3e-3, 0.0, 7.0), [Foul::PushShot]);
    assert!(fouls(Game::ThreeCushion, 3e-3, 0.0, 7.0).contains(&Foul::PushShot));
}

#[test]
fn the_tip_meets_the_cue_ball_twice_if_a_near_ball_holds_it_up() {
    assert_eq!(fouls(Game::NineBall, 2e-3, 30.0, 4.0), [Foul::DoubleHit, Foul::PushShot]);
}

#[test]
fn in_pool_a_full_strike_into_a_frozen_ball_is_legal() {
    for speed in [1.5, 3.0, 7.0] {
        assert_eq!(fouls(Game::NineBall, 0.0, 0.0, speed), []);
        assert_eq!(fouls(Game::NineBall, 9e-5, 0.0, speed), [], "light does not pass");
    }
}

#[test]
fn in_snooker_a_strike_into_a_touching_ball_is_one_push() {
    assert_eq!(fouls(Game::Snooker, 0.0, 0.0, 2.0), [Foul::Push]);
    assert_eq!(fouls(Game::Snooker, 9e-5, 0.0, 2.0), [Foul::Push]);
}

#[test]
fn a_thin_graze_of_a_near_ball_is_legal_in_pool_and_snooker() {
    // At this speed the cue ball stays on both tables.
    for game in [Game::NineBall, Game::Snooker] {
        assert_eq!(fouls(game, 1.5e-4, 82.0, 2.5), [], "it leaves at an eighth of the speed");
        assert_eq!(fouls(game, 1.5e-4, 60.0, 3.0), [Foul::PushShot]);
    }
    assert!(fouls(Game::ThreeCushion, 1.5e-4, 82.0, 3.0).contains(&Foul::PushShot));
}

#[test]
fn a_ball_that_the_cue_ball_meets_after_the_tip_has_left_it_is_legal() {
    assert_eq!(fouls(Game::NineBall, 3e-2, 0.0, 3.0), []);
}
